// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// Revolute and distance joints against statics and closed forms, and what holds for every joint.
namespace
{

using namespace dynamics;

constexpr float32 kGravity = 10.0f;

b2RevoluteJoint* Hinge(Scene& scene, b2Body* a, b2Body* b, const b2Vec2& anchor)
{
    b2RevoluteJointDef def;
    def.Initialize(a, b, anchor);
    return static_cast<b2RevoluteJoint*>(scene.world.CreateJoint(&def));
}

TEST(DynamicsRevoluteJoint, KeepsTheTwoPointsTogetherWhileItSwings)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* rod = scene.Box(1.0f, 5.0f, 1.0f, 0.1f);
    b2Joint* joint = Hinge(scene, ceiling, rod, b2Vec2(0.0f, 5.0f));
    for (int i = 0; i < 600; ++i)
    {
        scene.Step();
        ASSERT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), b2_linearSlop) << i;
    }
}

// T = 2 pi sqrt(I / (m g d)) for small swings.
TEST(DynamicsRevoluteJoint, SwingsAPendulumWithItsPeriod)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(2.0f * std::sin(0.05f), -2.0f * std::cos(0.05f));
    def.angle = 0.05f;
    b2Body* bob = scene.world.CreateBody(&def);
    Scene::AddBox(bob, 0.1f, 0.1f);
    Hinge(scene, ceiling, bob, b2Vec2(0.0f, 0.0f));
    bob->SetSleepingAllowed(false);
    const float32 inertia = bob->GetInertia() + bob->GetMass() * 4.0f;
    const float32 period = 2.0f * b2_pi * std::sqrt(inertia / (bob->GetMass() * kGravity * 2.0f));
    int crossings = 0;
    float32 last = 0.0f;
    float32 time = 0.0f;
    for (int i = 0; i < 1200; ++i)
    {
        const float32 before = bob->GetPosition().x;
        scene.Step();
        time += kStep;
        if (before > 0.0f && bob->GetPosition().x <= 0.0f)
        {
            ++crossings;
            last = crossings == 1 ? time : last;
            if (crossings == 6)
            {
                EXPECT_NEAR((time - last) / 5.0f, period, 0.01f * period);
                return;
            }
        }
    }
    FAIL() << "it does not swing";
}

TEST(DynamicsRevoluteJoint, HoldsABodyUpWithItsWeight)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* load = scene.Box(0.0f, 4.0f, 0.5f, 1.0f); // 2 kg
    load->SetSleepingAllowed(false);
    b2Joint* joint = Hinge(scene, ceiling, load, b2Vec2(0.0f, 5.0f));
    scene.Step(60);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 2.0f * kGravity, 0.01f) << "on body B, upwards";
    EXPECT_NEAR(joint->GetReactionForce(60.0f).x, 0.0f, 0.01f);
    EXPECT_EQ(joint->GetReactionForce(), joint->GetReactionForce(60.0f));
    EXPECT_NEAR(joint->GetReactionTorque(60.0f), 0.0f, 1e-4f);
}

TEST(DynamicsRevoluteJoint, MeasuresItsAngleFromTheInitialPoses)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Body(b2_staticBody, 0.0f, 0.0f, 0.7f);
    b2Body* b = scene.Body(b2_dynamicBody, 1.0f, 0.0f, -0.4f);
    Scene::AddBox(b, 0.5f, 0.1f);
    b2RevoluteJoint* joint = Hinge(scene, a, b, b2Vec2(0.0f, 0.0f));
    EXPECT_NEAR(joint->GetJointAngle(), 0.0f, 1e-6f);
    joint->SetMotorSpeed(1.0f);
    joint->SetMaxMotorTorque(1000.0f);
    joint->EnableMotor(true);
    scene.Step(120);
    EXPECT_NEAR(joint->GetJointSpeed(), 1.0f, 1e-3f);
    EXPECT_NEAR(joint->GetJointAngle(), 2.0f, 0.01f) << "counter-clockwise is positive";
    EXPECT_NEAR(b->GetAngle(), 1.6f, 0.01f);
}

TEST(DynamicsRevoluteJoint, AppliesNoMoreThanItsMaxMotorTorque)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* hub = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* wheel = scene.Ball(0.0f, 0.0f, 1.0f);
    b2RevoluteJoint* joint = Hinge(scene, hub, wheel, b2Vec2(0.0f, 0.0f));
    joint->SetMotorSpeed(100.0f);
    joint->SetMaxMotorTorque(3.0f);
    joint->EnableMotor(true);
    scene.Step(60);
    EXPECT_NEAR(wheel->GetAngularVelocity(), 3.0f / wheel->GetInertia(), 1e-3f);
    EXPECT_NEAR(joint->GetMotorTorque(60.0f), 3.0f, 1e-4f);
    EXPECT_NEAR(joint->GetMotorTorque(), 3.0f, 1e-4f);
    joint->EnableMotor(false);
    const float32 speed = wheel->GetAngularVelocity();
    scene.Step(10);
    EXPECT_NEAR(wheel->GetAngularVelocity(), speed, 1e-5f);
    EXPECT_EQ(joint->GetMotorTorque(60.0f), 0.0f);
}

TEST(DynamicsRevoluteJoint, HoldsAnArmUpToItsMaxMotorTorque)
{
    for (const float32 share : {0.9f, 1.1f})
    {
        Scene scene;
        b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
        b2Body* arm = scene.Box(1.0f, 0.0f, 1.0f, 0.25f); // 1 kg, its weight 1 m from the hinge
        b2RevoluteJoint* joint = Hinge(scene, wall, arm, b2Vec2(0.0f, 0.0f));
        joint->SetMaxMotorTorque(share * arm->GetMass() * kGravity);
        joint->EnableMotor(true);
        scene.Step(60);
        const bool holds = b2Abs(joint->GetJointAngle()) < 0.01f;
        EXPECT_EQ(holds, share > 1.0f) << joint->GetJointAngle();
    }
}

TEST(DynamicsRevoluteJoint, StaysWithinItsLimits)
{
    for (const float32 speed : {-3.0f, 3.0f, 30.0f, -90.0f})
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
        b2Body* arm = scene.Box(1.0f, 0.0f, 1.0f, 0.1f);
        b2RevoluteJoint* joint = Hinge(scene, wall, arm, b2Vec2(0.0f, 0.0f));
        joint->SetLimits(-0.5f, 1.0f);
        joint->EnableLimit(true);
        arm->SetAngularVelocity(speed);
        arm->SetLinearVelocity(b2Vec2(0.0f, speed));
        for (int i = 0; i < 120; ++i)
        {
            scene.Step();
            ASSERT_GT(joint->GetJointAngle(), -0.5f - b2_angularSlop) << speed << ", step " << i;
            ASSERT_LT(joint->GetJointAngle(), 1.0f + b2_angularSlop) << speed << ", step " << i;
        }
    }
}

TEST(DynamicsRevoluteJoint, HoldsTheWeightOfAnArmAtItsLimit)
{
    Scene scene;
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* arm = scene.Box(1.0f, 0.0f, 1.0f, 0.25f);
    arm->SetSleepingAllowed(false);
    b2RevoluteJoint* joint = Hinge(scene, wall, arm, b2Vec2(0.0f, 0.0f));
    joint->SetLimits(0.0f, 1.0f);
    joint->EnableLimit(true);
    scene.Step(120);
    EXPECT_NEAR(joint->GetReactionTorque(60.0f), arm->GetMass() * kGravity, 0.05f);
    EXPECT_NEAR(joint->GetJointAngle(), 0.0f, b2_angularSlop);
}

TEST(DynamicsRevoluteJoint, IsRigidWithEqualLimits)
{
    Scene scene;
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* arm = scene.Box(1.0f, 0.0f, 1.0f, 0.25f);
    b2RevoluteJoint* joint = Hinge(scene, wall, arm, b2Vec2(0.0f, 0.0f));
    joint->SetLimits(0.0f, 0.0f);
    joint->EnableLimit(true);
    scene.Step(120);
    EXPECT_NEAR(arm->GetPosition().y, 0.0f, 0.02f);
}

TEST(DynamicsRevoluteJoint, WakesTheBodiesWhenLimitOrMotorChanges)
{
    Scene scene;
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* arm = scene.Box(0.0f, -1.0f, 0.1f, 1.0f);
    b2RevoluteJoint* joint = Hinge(scene, wall, arm, b2Vec2(0.0f, 0.0f));
    const auto rest = [&] {
        scene.Step(120);
        EXPECT_FALSE(arm->IsAwake());
    };
    rest();
    joint->SetLimits(-1.0f, 1.0f);
    EXPECT_TRUE(arm->IsAwake());
    rest();
    joint->EnableLimit(true);
    EXPECT_TRUE(arm->IsAwake());
    rest();
    joint->SetMotorSpeed(1.0f);
    EXPECT_TRUE(arm->IsAwake());
    rest();
    joint->SetMaxMotorTorque(100.0f);
    EXPECT_TRUE(arm->IsAwake());
    rest();
    joint->EnableMotor(true);
    EXPECT_TRUE(arm->IsAwake());
    scene.Step(30);
    EXPECT_GT(joint->GetJointAngle(), 0.1f);
}

b2DistanceJoint* Rod(Scene& scene, b2Body* a, b2Body* b, float32 hertz = 0.0f, float32 ratio = 0.0f)
{
    b2DistanceJointDef def;
    def.Initialize(a, b, a->GetPosition(), b->GetPosition());
    def.frequencyHz = hertz;
    def.dampingRatio = ratio;
    return static_cast<b2DistanceJoint*>(scene.world.CreateJoint(&def));
}

TEST(DynamicsDistanceJoint, KeepsItsLengthAndCarriesTheWeight)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* load = scene.Box(0.0f, 2.0f);
    load->SetSleepingAllowed(false);
    b2DistanceJoint* joint = Rod(scene, ceiling, load);
    EXPECT_NEAR(joint->GetLength(), 3.0f, 1e-6f);
    scene.Step(60);
    EXPECT_NEAR(load->GetPosition().y, 2.0f, 1e-3f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, kGravity, 0.01f);
    EXPECT_EQ(joint->GetReactionTorque(60.0f), 0.0f);
    load->ApplyLinearImpulse(b2Vec2(10.0f, 0.0f), load->GetWorldCenter());
    for (int i = 0; i < 300; ++i)
    {
        scene.Step();
        ASSERT_NEAR(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 3.0f, 0.01f) << i;
    }
}

TEST(DynamicsDistanceJoint, KeepsTheCommonCentreOfTwoFreeBodies)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Ball(-1.0f, 0.0f, 0.3f);
    b2Body* b = scene.Ball(1.0f, 0.0f, 0.3f);
    Rod(scene, a, b);
    a->SetLinearVelocity(b2Vec2(0.0f, -2.0f));
    b->SetLinearVelocity(b2Vec2(0.0f, 2.0f));
    scene.Step(600);
    const b2Vec2 middle = 0.5f * (a->GetPosition() + b->GetPosition());
    EXPECT_NEAR(middle.Length(), 0.0f, 1e-3f);
    EXPECT_NEAR(b2Distance(a->GetPosition(), b->GetPosition()), 2.0f, 0.01f);
}

TEST(DynamicsDistanceJoint, SwingsWithItsFrequencyWhenSoft)
{
    for (const float32 hertz : {1.0f, 2.0f, 4.0f})
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
        b2Body* ball = scene.Ball(5.0f, 0.0f, 0.3f);
        Rod(scene, wall, ball, hertz);
        ball->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
        int crossings = 0;
        float32 first = 0.0f;
        float32 last = 0.0f;
        float32 before = 0.0f;
        for (int i = 1; i <= 2400 && crossings < 5; ++i)
        {
            scene.world.Step(1.0f / 240.0f, 8, 3);
            const float32 way = ball->GetPosition().x - 5.0f;
            if (before < 0.0f && way >= 0.0f)
            {
                // Between the two steps, where the straight line crosses.
                last = (float32(i) - way / (way - before)) / 240.0f;
                first = crossings++ == 0 ? last : first;
            }
            before = way;
        }
        ASSERT_GE(crossings, 2) << hertz;
        EXPECT_NEAR(float32(crossings - 1) / (last - first), hertz, 0.03f * hertz);
    }
}

TEST(DynamicsDistanceJoint, DoesNotSwingWhenCriticallyDamped)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* ball = scene.Ball(5.0f, 0.0f, 0.3f);
    Rod(scene, wall, ball, 2.0f, 1.0f);
    ball->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    for (int i = 0; i < 240; ++i)
    {
        scene.Step();
        ASSERT_GT(ball->GetPosition().x, 4.995f);
    }
    EXPECT_NEAR(ball->GetPosition().x, 5.0f, 1e-3f);
}

// A load sinks by g / omega^2 on a spring.
TEST(DynamicsDistanceJoint, StretchesUnderItsLoadWhenSoft)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* load = scene.Box(0.0f, 2.0f);
    load->SetSleepingAllowed(false);
    b2DistanceJoint* joint = Rod(scene, ceiling, load, 1.0f, 1.0f);
    scene.Step(600);
    const float32 omega = 2.0f * b2_pi;
    EXPECT_NEAR(2.0f - load->GetPosition().y, kGravity / (omega * omega), 0.005f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, kGravity, 0.05f);
}

TEST(DynamicsJoints, HoldWithoutWarmStartingToo)
{
    Scene scene;
    scene.world.SetWarmStarting(false);
    b2Body* last = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (int i = 0; i < 3; ++i)
    {
        b2Body* link = scene.Box(float32(i) + 0.5f, 0.0f, 0.5f, 0.1f);
        Hinge(scene, last, link, b2Vec2(float32(i), 0.0f));
        last = link;
    }
    scene.Step(600);
    EXPECT_NEAR(last->GetPosition().y, -2.5f, 0.1f);
    EXPECT_EQ(WhyBroken(scene.world, true), "");
}

TEST(DynamicsJoints, AreListedByTheirBodiesAndTheWorld)
{
    Scene scene;
    b2Body* a = scene.Box(0.0f, 0.0f);
    b2Body* b = scene.Box(3.0f, 0.0f);
    int tag = 0;
    b2DistanceJointDef def;
    def.Initialize(a, b, a->GetPosition(), b->GetPosition());
    def.userData = &tag;
    b2Joint* joint = scene.world.CreateJoint(&def);
    EXPECT_EQ(scene.world.GetJointList(), joint);
    EXPECT_EQ(scene.world.GetJointCount(), 1);
    ASSERT_NE(a->GetJointList(), nullptr);
    EXPECT_EQ(a->GetJointList()->joint, joint);
    EXPECT_EQ(a->GetJointList()->other, b);
    EXPECT_EQ(b->GetJointList()->other, a);
    EXPECT_EQ(joint->GetBodyA(), a);
    EXPECT_EQ(joint->GetBodyB(), b);
    EXPECT_EQ(joint->GetType(), e_distanceJoint);
    EXPECT_EQ(joint->GetUserData(), &tag);
    EXPECT_TRUE(joint->IsActive());
    a->SetActive(false);
    EXPECT_FALSE(joint->IsActive());
    scene.world.DestroyJoint(joint);
    EXPECT_EQ(a->GetJointList(), nullptr);
    EXPECT_EQ(scene.world.GetJointCount(), 0);
}

TEST(DynamicsJoints, AreNotSimulatedWhileABodyIsInactive)
{
    Scene scene;
    b2Body* anchor = scene.Box(0.0f, 5.0f);
    anchor->SetActive(false);
    b2Body* load = scene.Box(0.0f, 2.0f);
    Rod(scene, anchor, load);
    scene.Step(30);
    EXPECT_LT(load->GetPosition().y, 1.0f) << "it falls freely";
}

TEST(DynamicsJoints, ReportTheSameForceWhenTheTimeStepChanges)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* load = scene.Box(0.0f, 2.0f);
    load->SetSleepingAllowed(false);
    b2DistanceJoint* joint = Rod(scene, ceiling, load);
    for (int i = 0; i < 120; ++i)
    {
        const float32 step = i % 2 == 0 ? 1.0f / 30.0f : 1.0f / 120.0f;
        scene.world.Step(step, 8, 3);
        ASSERT_NEAR(joint->GetReactionForce(1.0f / step).y, kGravity, i < 4 ? 1.0f : 0.05f) << i;
    }
    EXPECT_NEAR(load->GetPosition().y, 2.0f, 1e-3f);
}

} // namespace
