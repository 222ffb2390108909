// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// A body stopped by an impact within a step stays joined to bodies that continue.
namespace
{

using namespace dynamics;

/// Two boxes on a hinge that fly at a thin wall.
struct Thrown : JointScene
{
    Thrown(int32 subSteps, float32 speed) : JointScene(b2Vec2_zero)
    {
        world.SetSubStepCount(subSteps);
        b2EdgeShape edge;
        edge.Set(b2Vec2(5.0f, -5.0f), b2Vec2(5.0f, 5.0f));
        Add(Post(), edge, 0.2f, 0.0f);
        first = Load(0.0f, 0.0f, 0.5f, 0.125f);
        second = Load(-1.0f, 0.0f, 0.5f, 0.125f);
        b2RevoluteJointDef def;
        def.Initialize(first, second, b2Vec2(-0.5f, 0.0f));
        hinge = world.CreateJoint(&def);
        first->SetLinearVelocity(b2Vec2(speed, 0.0f));
        second->SetLinearVelocity(b2Vec2(speed, 0.0f));
    }
    float32 Gap() const { return b2Distance(hinge->GetAnchorA(), hinge->GetAnchorB()); }
    float32 Kinetic() const
    {
        float32 sum = 0.0f;
        for (const b2Body* body : {first, second})
        {
            sum += body->GetMass() * body->GetLinearVelocity().LengthSquared() +
                   body->GetInertia() * body->GetAngularVelocity() * body->GetAngularVelocity();
        }
        return sum;
    }

    b2Body* first;
    b2Body* second;
    b2Joint* hinge;
};

class ImpactJoints : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, ImpactJoints, testing::Values(2, 4, 8));

TEST_P(ImpactJoints, PullABodyBackToOneThatAWallStops)
{
    for (const float32 speed : {40.0f, 63.0f, 80.0f})
    {
        Thrown pair(GetParam(), speed);
        const float32 before = pair.Kinetic();
        float32 widest = 0.0f;
        float32 farthest = 0.0f;
        for (int i = 0; i < 30; ++i)
        {
            pair.Step();
            widest = b2Max(widest, pair.Gap());
            farthest = b2Max(farthest, pair.first->GetPosition().x);
            EXPECT_LT(pair.Kinetic(), 1.005f * before) << speed << " m/s, step " << i;
        }
        EXPECT_LT(widest, 0.02f) << speed << " m/s";
        EXPECT_LT(farthest, 5.0f) << speed << " m/s";
    }
}

/// The other impact wakes a pair, which changes the list of joints: all joints were then closed at
/// once, also those that were open before.
TEST_P(ImpactJoints, LeaveAHingeOpenWhereAnotherImpactWakesAPair)
{
    const auto gapAfter = [](bool joined) {
        JointScene scene(b2Vec2_zero);
        scene.world.SetSubStepCount(GetParam());
        b2EdgeShape wall;
        wall.Set(b2Vec2(10.0f, -50.0f), b2Vec2(10.0f, 50.0f));
        scene.Add(scene.Post(), wall, 0.2f, 0.0f);
        const auto ball = [&](float32 x, float32 y) {
            b2Body* body = scene.Body(b2_dynamicBody, x, y);
            scene.AddBall(body, 0.2f, 0.2f);
            return body;
        };
        b2Body* first = ball(9.7f, 0.0f);
        first->SetBullet(true);
        b2Body* second = ball(6.7f, 0.0f);
        for (b2Body* body : {first, second})
        {
            body->SetLinearVelocity(b2Vec2(90.0f, 0.0f));
        }
        b2RevoluteJointDef open;
        open.bodyA = first;
        open.bodyB = second;
        scene.world.CreateJoint(&open);
        b2Body* below = ball(0.0f, 80.0f);
        b2Body* above = ball(0.0f, 81.0f);
        if (joined)
        {
            b2RevoluteJointDef closed;
            closed.Initialize(below, above, b2Vec2(0.0f, 80.5f));
            scene.world.CreateJoint(&closed);
        }
        below->SetAwake(false);
        above->SetAwake(false);
        b2Body* bullet = ball(-0.8f, 80.0f);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity(b2Vec2(90.0f, 0.0f));
        scene.Step();
        EXPECT_TRUE(below->IsAwake());
        EXPECT_LT(first->GetPosition().x, 9.9f); // at the wall
        return b2Distance(first->GetPosition(), second->GetPosition());
    };
    EXPECT_NEAR(gapAfter(true), gapAfter(false), 1e-4f);
}

} // namespace
