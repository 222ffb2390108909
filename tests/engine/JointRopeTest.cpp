// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Ropes between two bodies: a largest distance, and nothing below it.
namespace
{

using namespace dynamics;

struct Tether : JointScene
{
    explicit Tether(float32 y, float32 length = 3.0f) : load(Load(0.0f, y))
    {
        b2RopeJointDef def;
        def.bodyA = Post();
        def.bodyB = load;
        def.localAnchorA.SetZero();
        def.localAnchorB.SetZero();
        def.maxLength = length;
        joint = Create<b2RopeJoint>(def);
    }
    float32 Length() const { return b2Distance(joint->GetAnchorA(), joint->GetAnchorB()); }

    b2Body* load;
    b2RopeJoint* joint;
};

TEST(RopeJoint, DoesNothingWhenSlack)
{
    Tether t(0.0f);
    t.Step(30); // falls 1.29 m
    EXPECT_NEAR(t.load->GetLinearVelocity().y, -5.0f, 1e-4f);
    EXPECT_EQ(t.joint->GetLimitState(), e_inactiveLimit);
    EXPECT_EQ(t.joint->GetReactionForce(1.0f / kStep).Length(), 0.0f);
}

TEST(RopeJoint, CarriesTheWeightWhenTaut)
{
    Tether t(-3.0f);
    t.Step(120);
    EXPECT_NEAR(t.Length(), 3.0f, b2_linearSlop);
    EXPECT_EQ(t.joint->GetLimitState(), e_atUpperLimit);
    EXPECT_NEAR(t.joint->GetReactionForce(1.0f / kStep).y, kGravity, 0.01f);
    EXPECT_EQ(t.joint->GetReactionTorque(), 0.0f);
}

TEST(RopeJoint, CatchesAFallWithoutStretching)
{
    Tether t(3.0f); // 6 m to fall: 11 m/s
    for (int i = 0; i < 240; ++i)
    {
        t.Step();
        ASSERT_LT(t.Length(), 3.0f + b2_linearSlop) << i;
    }
}

TEST(RopeJoint, NeverGrowsLongerHoweverItIsPulled)
{
    Tether t(-2.0f);
    t.Shake(t.load, 600, [&] { EXPECT_LT(t.Length(), 3.0f + 2.0f * b2_linearSlop); });
}

TEST(RopeJoint, CanBeLengthenedAndShortened)
{
    Tether t(-3.0f);
    t.load->SetSleepingAllowed(true);
    t.Step(300);
    ASSERT_FALSE(t.load->IsAwake());
    t.joint->SetMaxLength(4.0f);
    EXPECT_TRUE(t.load->IsAwake());
    EXPECT_EQ(t.joint->GetMaxLength(), 4.0f);
    t.Step(300);
    EXPECT_NEAR(t.Length(), 4.0f, b2_linearSlop);
    t.joint->SetMaxLength(2.0f);
    t.Step(300);
    EXPECT_NEAR(t.Length(), 2.0f, b2_linearSlop);
}

TEST(RopeJoint, PullsTwoFreeBodiesAlike)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Load(0.0f, 0.0f);
    b2Body* b = scene.Load(4.0f, 0.0f);
    b2RopeJointDef def;
    def.bodyA = a;
    def.bodyB = b;
    def.localAnchorA.SetZero();
    def.localAnchorB.SetZero();
    def.maxLength = 5.0f;
    auto* joint = scene.Create<b2RopeJoint>(def);
    b->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    scene.Step(60);
    // An impact without rebound: both go on at the common speed.
    EXPECT_NEAR(a->GetLinearVelocity().x, 2.0f, 0.01f);
    EXPECT_NEAR(b->GetLinearVelocity().x, 2.0f, 0.01f);
    EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 5.0f + b2_linearSlop);
}

} // namespace
