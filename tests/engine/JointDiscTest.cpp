// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <algorithm>

/// Joints with a force that is bounded as a vector, in contact with other bodies.
namespace
{

using namespace dynamics;

/// A ball of 0.5 m at the origin, and a row of heavy balls that touch it aslant.
struct Row : JointScene
{
    Row(int32 subSteps, int count, float32 side) : JointScene(b2Vec2_zero)
    {
        world.SetSubStepCount(subSteps);
        ball = Body(b2_dynamicBody, 0.0f, 0.0f);
        AddBall(ball, 0.5f);
        for (int i = 1; i <= count; ++i)
        {
            const b2Vec2 place = side * float32(i) * kAslant;
            last = Body(b2_dynamicBody, place.x, place.y);
            AddBall(last, 0.5f)->SetDensity(30.0f);
            last->ResetMassData();
            mass += last->GetMass();
        }
        mass += ball->GetMass();
    }

    inline static const b2Vec2 kAslant = b2Vec2(b2Sqrt(0.5f), b2Sqrt(0.5f));
    b2Body* ball;
    b2Body* last;
    float32 mass = 0.0f;
};

class JointDisc : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, JointDisc, testing::Values(1, 2, 4, 8));

/// With sub-steps each of two rows had the whole force: 14.1 N, and 13 N did not move the row.
TEST_P(JointDisc, SlipsWhereARowPushesAslantWithMoreThanItsForce)
{
    for (const float32 force : {9.0f, 13.0f, 20.0f})
    {
        Row row(GetParam(), 5, -1.0f);
        b2FrictionJointDef def;
        def.Initialize(row.Post(), row.ball, b2Vec2_zero);
        def.maxForce = 10.0f;
        def.maxTorque = 100.0f;
        b2Joint* joint = row.world.CreateJoint(&def);
        float32 largest = 0.0f;
        for (int i = 0; i < 180; ++i)
        {
            row.last->ApplyForceToCenter(force * Row::kAslant);
            row.Step();
            largest = std::max(largest, joint->GetReactionForce(60.0f).Length());
        }
        EXPECT_LT(largest, 10.01f) << force << " N";
        const float32 expected = 0.5f * std::max(force - 10.0f, 0.0f) / row.mass * 3.0f * 3.0f;
        EXPECT_NEAR(row.ball->GetPosition().Length(), expected, 0.02f) << force << " N";
    }
}

TEST_P(JointDisc, PullsARowAslantWithNoMoreThanItsForce)
{
    Row row(GetParam(), 4, 1.0f);
    b2MouseJointDef def;
    def.bodyA = row.Post();
    def.bodyB = row.ball;
    def.maxForce = 100.0f;
    auto* mouse = row.Create<b2MouseJoint>(def);
    mouse->SetTarget(b2Vec2(20.0f, 20.0f));
    float32 largest = 0.0f;
    for (int i = 0; i < 120; ++i)
    {
        row.Step();
        largest = std::max(largest, mouse->GetReactionForce(60.0f).Length());
    }
    EXPECT_LT(largest, 100.1f);
    EXPECT_GT(largest, 99.0f);
}

/// What has no force has no direction either.
TEST_P(JointDisc, LeavesARowAloneWithoutForce)
{
    const auto placeAfter = [](bool joined) {
        Row row(GetParam(), 5, -1.0f);
        if (joined)
        {
            b2FrictionJointDef def;
            def.Initialize(row.Post(), row.ball, b2Vec2_zero);
            def.maxTorque = 1.0f;
            row.world.CreateJoint(&def);
        }
        for (int i = 0; i < 60; ++i)
        {
            row.last->ApplyForceToCenter(9.0f * Row::kAslant);
            row.Step();
        }
        return row.ball->GetPosition().Length();
    };
    EXPECT_NEAR(placeAfter(true), placeAfter(false), 1e-4f);
}

} // namespace
