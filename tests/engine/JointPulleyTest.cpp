// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Pulleys: lengthA + ratio * lengthB stays what it was.
namespace
{

using namespace dynamics;

/// Two loads 5 m below two fixed points, `heavy` times as heavy on the right.
struct Hoist : JointScene
{
    explicit Hoist(float32 ratio, float32 heavy)
    {
        a = Load(-3.0f, 5.0f);
        b = Load(3.0f, 5.0f, 0.5f, 0.5f * heavy);
        b2PulleyJointDef def;
        def.Initialize(a, b, b2Vec2(-3.0f, 10.0f), b2Vec2(3.0f, 10.0f), a->GetPosition(),
                       b->GetPosition(), ratio);
        joint = Create<b2PulleyJoint>(def);
    }
    float32 Total() const
    {
        return joint->GetCurrentLengthA() + joint->GetRatio() * joint->GetCurrentLengthB();
    }

    b2Body* a;
    b2Body* b;
    b2PulleyJoint* joint;
};

TEST(PulleyJoint, BalancesLoadsInItsRatio)
{
    for (const float32 ratio : {1.0f, 2.0f, 3.0f})
    {
        Hoist hoist(ratio, ratio);
        hoist.Step(300);
        EXPECT_NEAR(hoist.joint->GetCurrentLengthA(), 5.0f, 0.01f) << ratio;
        EXPECT_NEAR(hoist.joint->GetCurrentLengthB(), 5.0f, 0.01f) << ratio;
        // The force on body B is its weight.
        EXPECT_NEAR(hoist.joint->GetReactionForce(1.0f / kStep).y, kGravity * ratio,
                    0.01f * kGravity * ratio);
        EXPECT_EQ(hoist.joint->GetReactionTorque(), 0.0f);
    }
}

// Atwood's machine: a = g (mB - mA) / (mA + mB).
TEST(PulleyJoint, AcceleratesLoadsAsAtwoodsMachineDoes)
{
    Hoist hoist(1.0f, 3.0f);
    hoist.Step(30);
    EXPECT_NEAR(hoist.b->GetLinearVelocity().y, -0.5f * kGravity * 0.5f, 0.02f);
    EXPECT_NEAR(hoist.a->GetLinearVelocity().y, 0.5f * kGravity * 0.5f, 0.02f);
}

TEST(PulleyJoint, MovesItsSidesInItsRatio)
{
    Hoist hoist(2.0f, 1.0f); // the left one pulls the right one up at half its speed
    hoist.Step(30);
    EXPECT_LT(hoist.a->GetLinearVelocity().y, -1.0f);
    EXPECT_NEAR(hoist.a->GetLinearVelocity().y, -2.0f * hoist.b->GetLinearVelocity().y, 0.01f);
}

TEST(PulleyJoint, KeepsTheRopesLengthHoweverItIsPulled)
{
    Hoist hoist(2.0f, 2.0f);
    const float32 total = hoist.Total();
    // The tension of a taut rope under a hundred weights; the solver's leftover is a share of what
    // a load moves in a step.
    hoist.Shake(hoist.b, 300, [&] { EXPECT_NEAR(hoist.Total(), total, 0.05f); });
}

TEST(PulleyJoint, ReportsItsGroundAnchors)
{
    Hoist hoist(2.0f, 1.0f);
    EXPECT_EQ(hoist.joint->GetGroundAnchorA(), b2Vec2(-3.0f, 10.0f));
    EXPECT_EQ(hoist.joint->GetGroundAnchorB(), b2Vec2(3.0f, 10.0f));
    EXPECT_EQ(hoist.joint->GetLengthA(), 5.0f);
    EXPECT_EQ(hoist.joint->GetLengthB(), 5.0f);
    EXPECT_EQ(hoist.joint->GetRatio(), 2.0f);
    EXPECT_EQ(hoist.joint->GetAnchorA(), hoist.a->GetPosition());
    EXPECT_EQ(hoist.joint->GetLocalAnchorA(), b2Vec2(0.0f, 0.0f));
    EXPECT_TRUE(hoist.joint->GetCollideConnected()) << "as pulleys are defined";
    hoist.world.ShiftOrigin(b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(hoist.joint->GetGroundAnchorA(), b2Vec2(-4.0f, 8.0f));
    EXPECT_NEAR(hoist.joint->GetCurrentLengthA(), 5.0f, 1e-5f);
}

TEST(PulleyJoint, ReturnsTheLengthsOfItsDefinition)
{
    Hoist hoist(1.0f, 2.0f);
    hoist.Step(30);
    EXPECT_LT(hoist.joint->GetLengthA(), 4.9f) << "the lighter load goes up";
    EXPECT_EQ(hoist.joint->GetDefinedLengthA(), 5.0f);
    EXPECT_EQ(hoist.joint->GetDefinedLengthB(), 5.0f);
}

TEST(PulleyJoint, StaysFiniteWhenALoadReachesItsWheel)
{
    Hoist hoist(1.0f, 6.0f);
    for (int i = 0; i < 600; ++i)
    {
        hoist.Step();
        ASSERT_EQ(WhyBroken(hoist.world, true), "");
        ASSERT_TRUE(hoist.a->GetPosition().IsValid() && hoist.b->GetPosition().IsValid());
    }
}

} // namespace
