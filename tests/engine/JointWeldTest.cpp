// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Welds: rigid, or with a spring against turning.
namespace
{

using namespace dynamics;

/// A beam of 2 m, welded to a post at its left end.
struct Cantilever : JointScene
{
    explicit Cantilever(float32 frequencyHz = 0.0f, float32 dampingRatio = 0.0f)
        : beam(Load(1.0f, 0.0f, 1.0f, 0.1f))
    {
        b2WeldJointDef def;
        def.Initialize(Post(), beam, b2Vec2(0.0f, 0.0f));
        def.frequencyHz = frequencyHz;
        def.dampingRatio = dampingRatio;
        joint = Create<b2WeldJoint>(def);
    }

    b2Body* beam;
    b2WeldJoint* joint;
};

TEST(WeldJoint, CarriesTheWeightAndItsTorque)
{
    Cantilever c;
    c.Step(120);
    const float32 weight = kGravity * c.beam->GetMass();
    const b2Vec2 force = c.joint->GetReactionForce();
    EXPECT_NEAR(force.x, 0.0f, 0.01f * weight);
    EXPECT_NEAR(force.y, weight, 0.01f * weight);
    EXPECT_NEAR(c.joint->GetReactionTorque(), weight * 1.0f, 0.01f * weight);
    EXPECT_NEAR(c.beam->GetAngle(), 0.0f, 1e-3f);
}

TEST(WeldJoint, KeepsPointAndAngleHoweverItIsShaken)
{
    Cantilever c;
    c.Shake(c.beam, 600, [&] {
        EXPECT_LT(b2Distance(c.joint->GetAnchorA(), c.joint->GetAnchorB()), b2_linearSlop);
        EXPECT_NEAR(c.beam->GetAngle(), 0.0f, b2_angularSlop);
    });
}

TEST(WeldJoint, MovesTwoFreeBodiesAsOne)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Load(0.0f, 0.0f);
    b2Body* b = scene.Load(1.0f, 0.0f);
    b2WeldJointDef def;
    def.Initialize(a, b, b2Vec2(0.5f, 0.0f));
    auto* joint = scene.Create<b2WeldJoint>(def);
    a->SetLinearVelocity(b2Vec2(0.0f, 2.0f));
    const b2Vec2 momentum = a->GetMass() * a->GetLinearVelocity();
    scene.Step();
    // Two boxes of 1 kg: I = 2 (1/6 + 1/4), L = 1 * 2 * 0.5.
    EXPECT_NEAR(b2Abs(a->GetAngularVelocity()), 1.0f / (2.0f * (1.0f / 6.0f + 0.25f)), 1e-4f);
    for (int i = 0; i < 300; ++i)
    {
        scene.Step();
        ASSERT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), b2_linearSlop);
    }
    const b2Vec2 now =
        a->GetMass() * a->GetLinearVelocity() + b->GetMass() * b->GetLinearVelocity();
    EXPECT_NEAR(b2Distance(now, momentum), 0.0f, 1e-4f);
    EXPECT_NEAR(a->GetAngularVelocity(), b->GetAngularVelocity(), 1e-4f);
    // The centres leave their circle along the tangent and are pulled back to it. That removes a
    // little of the spin in each step: 3.4 % in these five seconds.
    EXPECT_NEAR(b2Abs(a->GetAngularVelocity()), 1.2f, 0.05f);
}

// Welded at its centre, so only the spring rotates it.
TEST(WeldJoint, SwingsWithItsFrequencyWhenSoft)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* load = scene.Load(0.0f, 0.0f);
    b2WeldJointDef def;
    def.Initialize(scene.Post(), load, b2Vec2(0.0f, 0.0f));
    def.frequencyHz = 1.0f;
    scene.Create<b2WeldJoint>(def);
    load->SetAngularVelocity(1.0f);
    int crossings = 0;
    float32 first = 0.0f;
    float32 latest = 0.0f;
    for (int i = 0; i < 300; ++i)
    {
        const float32 before = load->GetAngle();
        scene.Step();
        if (before < 0.0f && load->GetAngle() >= 0.0f)
        {
            latest = float32(i) * kStep;
            first = crossings++ == 0 ? latest : first;
        }
    }
    ASSERT_GE(crossings, 3);
    EXPECT_NEAR((latest - first) / float32(crossings - 1), 1.0f, 0.02f);
}

// torque = k angle with k = I (2 pi f)^2, I the beam's about its centre.
TEST(WeldJoint, BendsUnderTorqueWhenSoft)
{
    Cantilever c(8.0f, 1.0f);
    c.Step(600);
    const float32 inertia = c.beam->GetInertia();
    const float32 omega = 2.0f * b2_pi * 8.0f;
    const float32 sag = kGravity * c.beam->GetMass() * 1.0f / (inertia * omega * omega);
    EXPECT_NEAR(c.beam->GetAngle(), -sag, 0.05f * sag);
    EXPECT_LT(b2Distance(c.joint->GetAnchorA(), c.joint->GetAnchorB()), b2_linearSlop);
}

TEST(WeldJoint, KeepsTheReferenceAngleOfItsDefinition)
{
    JointScene scene;
    b2Body* a = scene.Body(b2_staticBody, 0.0f, 0.0f, 0.3f);
    b2Body* b = scene.Body(b2_dynamicBody, 1.0f, 0.0f, 1.0f);
    Scene::AddBox(b, 0.5f, 0.5f);
    b2WeldJointDef def;
    def.Initialize(a, b, b2Vec2(1.0f, 0.0f));
    auto* joint = scene.Create<b2WeldJoint>(def);
    EXPECT_NEAR(joint->GetReferenceAngle(), 0.7f, 1e-6f);
    scene.Step(60);
    EXPECT_NEAR(b->GetAngle(), 1.0f, 1e-4f);
}

TEST(WeldJoint, WakesTheBodiesWhenItsSpringChanges)
{
    Cantilever c(8.0f, 1.0f);
    c.beam->SetSleepingAllowed(true);
    c.Step(600);
    ASSERT_FALSE(c.beam->IsAwake());
    c.joint->SetFrequency(4.0f);
    EXPECT_TRUE(c.beam->IsAwake());
    EXPECT_EQ(c.joint->GetFrequency(), 4.0f);
    c.Step(600);
    ASSERT_FALSE(c.beam->IsAwake());
    c.joint->SetDampingRatio(0.8f);
    EXPECT_TRUE(c.beam->IsAwake());
    EXPECT_EQ(c.joint->GetDampingRatio(), 0.8f);
}

} // namespace
