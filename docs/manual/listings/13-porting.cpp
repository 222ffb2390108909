// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>

// NOLINTBEGIN(readability-redundant-declaration): programs declare what headers of 2.3 do not
// [statistics]
extern int32 b2_toiCalls, b2_toiIters; // as such programs do; the headers declare them too

void PrintSearches()
{
    std::printf("%d searches, %d advances\n", b2_toiCalls, b2_toiIters);
}
// [/statistics]
// NOLINTEND(readability-redundant-declaration)

namespace
{

// [stiffness]
/// Sets a spring as Box2D 2.4 does: a stiffness [N/m] and a damping [N s/m].
void SetSpring(b2DistanceJointDef& def, float32 stiffness, float32 damping)
{
    const float32 a = def.bodyA->GetMass(), b = def.bodyB->GetMass();
    const float32 mass = a > 0.0f && b > 0.0f ? a * b / (a + b) : a + b;
    const bool isSpring = stiffness > 0.0f && mass > 0.0f; // else a rod
    const float32 omega = isSpring ? std::sqrt(stiffness / mass) : 0.0f;
    def.frequencyHz = omega / (2.0f * b2_pi);
    def.dampingRatio = isSpring ? damping / (2.0f * mass * omega) : 0.0f;
}
// [/stiffness]

TEST(PortingListing, SetsASpringByItsStiffness)
{
    manual::Stage stage;
    b2Body* hook = stage.Body(b2_staticBody, 0.0f, 10.0f);
    b2Body* load = stage.Box(0.0f, 7.0f, 1.0f, 1.0f); // 4 kg
    b2DistanceJointDef def;
    def.Initialize(hook, load, hook->GetPosition(), load->GetPosition());
    SetSpring(def, 100.0f, 20.0f);
    stage.world.CreateJoint(&def);
    stage.Run(10.0f);
    EXPECT_NEAR(7.0f - load->GetPosition().y, 4.0f * 10.0f / 100.0f, 0.005f) << "m g / k";
    b2Body* held = stage.Box(20.0f, 7.0f);
    def.Initialize(hook, held, b2Vec2(20.0f, 10.0f), held->GetPosition());
    SetSpring(def, 0.0f, 0.0f);
    ASSERT_NE(stage.world.CreateJoint(&def), nullptr);
    EXPECT_EQ(def.frequencyHz, 0.0f) << "a rod";
}

TEST(PortingListing, LimitsADistanceJoint)
{
    manual::Stage stage;
    b2Body* hook = stage.Body(b2_staticBody, 0.0f, 10.0f);
    b2Body* load = stage.Box(0.0f, 7.0f, 1.0f, 1.0f);
    // [limits]
    b2DistanceJointDef def;
    def.Initialize(hook, load, hook->GetPosition(), load->GetPosition());
    def.minLength = 1.0f;
    def.maxLength = 4.0f; // free between the two, as there is no frequency
    // [/limits]
    auto* joint = static_cast<b2DistanceJoint*>(stage.world.CreateJoint(&def));
    EXPECT_EQ(joint->GetLength(), 3.0f);
    stage.Run(0.3f);
    EXPECT_NEAR(load->GetLinearVelocity().y, -3.0f, 0.01f) << "it falls";
    stage.Run(3.0f);
    EXPECT_NEAR(joint->GetCurrentLength(), 4.0f, 0.005f) << "to the maximum";
}

/// Where a ball is after two seconds that flies from the middle of a square to the right, or from
/// its right to the middle.
float32 Thrown(const b2Shape& shape, bool outwards)
{
    manual::Stage stage(b2Vec2_zero);
    stage.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&shape, 0.0f);
    b2Body* ball = stage.Ball(outwards ? 0.0f : 5.0f, 0.0f, 0.3f);
    ball->SetLinearVelocity(b2Vec2(outwards ? 3.0f : -3.0f, 0.0f));
    stage.Run(1.5f);
    return ball->GetPosition().x;
}

TEST(PortingListing, StopsOnOneSideOnly)
{
    const b2Vec2 outline[] = {{-2.0f, -2.0f}, {-2.0f, 2.0f}, {2.0f, 2.0f}, {2.0f, -2.0f}};
    // [one-sided]
    b2ChainShape loop;
    loop.CreateLoop(outline, 4); // clockwise, so that its right is inside
    loop.m_oneSided = true;
    // [/one-sided]
    EXPECT_LT(Thrown(loop, true), 1.75f) << "from inside";
    EXPECT_LT(Thrown(loop, false), 1.0f) << "in from outside";
    loop.m_oneSided = false;
    EXPECT_GT(Thrown(loop, false), 2.0f);
}

TEST(PortingListing, CountsSearches)
{
    manual::Stage stage;
    stage.Ground();
    b2Body* box = stage.Box(0.0f, 1.0f);
    box->SetLinearVelocity(b2Vec2(0.0f, -200.0f));
    b2_toiCalls = 0;
    stage.Run(1.0f / 60.0f);
    testing::internal::CaptureStdout();
    PrintSearches();
    EXPECT_THAT(testing::internal::GetCapturedStdout(),
                testing::MatchesRegex("[1-9][0-9]* searches, [0-9]+ advances\n"));
}

// [threshold]
/// Impacts slower than this do not bounce; for thresholds above the world's own.
class BounceThreshold : public b2ContactListener
{
public:
    float32 slowest = 3.0f; // [m/s]

private:
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        const b2Vec2 point = manifold.points[0];
        const float32 approach = b2Dot(a->GetLinearVelocityFromWorldPoint(point) -
                                           b->GetLinearVelocityFromWorldPoint(point),
                                       manifold.normal);
        contact->ResetRestitution();
        if (approach < slowest)
        {
            contact->SetRestitution(0.0f);
        }
    }
};
// [/threshold]

/// How high a ball of restitution 0.9 comes again that falls from a height.
float32 Rebound(float32 height)
{
    BounceThreshold listener;
    manual::Stage stage;
    stage.world.SetContactListener(&listener);
    stage.Ground();
    b2Body* ball = stage.Ball(0.0f, 0.505f + height);
    ball->GetFixtureList()->SetRestitution(0.9f);
    float32 highest = 0.0f;
    bool fell = false;
    for (int i = 0; i < 180; ++i)
    {
        stage.Run(1.0f / 60.0f);
        fell = fell || ball->GetPosition().y < 0.6f;
        highest = fell ? b2Max(highest, ball->GetPosition().y - 0.505f) : highest;
    }
    stage.world.SetContactListener(nullptr);
    return highest;
}

TEST(PortingListing, BouncesAboveItsThreshold)
{
    EXPECT_GT(Rebound(2.0f), 1.0f) << "at 6.3 m/s";
    EXPECT_LT(Rebound(0.3f), 0.1f) << "at 2.4 m/s";
}

TEST(PortingListing, SetsUpAWorldAsBox2DDoes)
{
    // [as-box2d]
    b2World world(b2Vec2(0.0f, -10.0f)); // one step of first order, one thread, sleep: as in Box2D
    world.Step(1.0f / 60.0f, 8, 3);
    // [/as-box2d]
    EXPECT_EQ(world.GetSubStepCount(), 1);
    EXPECT_EQ(world.GetThreadCount(), 1);
    EXPECT_TRUE(world.GetAllowSleeping());
}

} // namespace
