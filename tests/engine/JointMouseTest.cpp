// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// The soft pull of a hand on one point of a body.
namespace
{

using namespace dynamics;

struct Pull : JointScene
{
    explicit Pull(float32 maxForce, const b2Vec2& grip = b2Vec2(0.0f, 0.0f),
                  const b2Vec2& gravity = b2Vec2(0.0f, -10.0f))
        : JointScene(gravity), load(Load(0.0f, 0.0f))
    {
        b2MouseJointDef def;
        def.bodyA = Post();
        def.bodyB = load;
        def.target = grip;
        def.maxForce = maxForce;
        joint = Create<b2MouseJoint>(def);
    }

    b2Body* load;
    b2MouseJoint* joint;
};

TEST(MouseJoint, TakesTheBodyToItsTarget)
{
    Pull pull(1000.0f, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 0.0f));
    pull.joint->SetTarget(b2Vec2(3.0f, 4.0f));
    pull.Step(120);
    EXPECT_NEAR(pull.load->GetPosition().x, 3.0f, 1e-3f);
    EXPECT_NEAR(pull.load->GetPosition().y, 4.0f, 1e-3f);
    EXPECT_EQ(pull.joint->GetAnchorA(), b2Vec2(3.0f, 4.0f));
}

// A weight m g on a spring of stiffness m (2 pi f)^2.
TEST(MouseJoint, SagsUnderTheWeightByItsStiffness)
{
    Pull pull(1000.0f);
    pull.Step(240);
    const float32 omega = 2.0f * b2_pi * 5.0f;
    EXPECT_NEAR(pull.load->GetPosition().y, -kGravity / (omega * omega), 1e-4f);
    EXPECT_NEAR(pull.joint->GetReactionForce(1.0f / kStep).y, kGravity, 0.01f);
    EXPECT_EQ(pull.joint->GetReactionTorque(1.0f / kStep), 0.0f);
}

TEST(MouseJoint, PullsWithAtMostItsMaxForce)
{
    Pull pull(4.0f, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 0.0f));
    pull.joint->SetTarget(b2Vec2(100.0f, 0.0f));
    pull.Step(60);
    EXPECT_NEAR(pull.load->GetLinearVelocity().x, 4.0f, 1e-3f);
    EXPECT_NEAR(pull.joint->GetReactionForce().x, 4.0f, 1e-3f);

    Pull weak(6.0f); // too weak for the weight
    weak.Step(60);
    EXPECT_NEAR(weak.load->GetLinearVelocity().y, -4.0f, 0.02f);
}

TEST(MouseJoint, LetsABodyHangFromItsCorner)
{
    Pull pull(1000.0f, b2Vec2(0.5f, 0.5f));
    pull.Step(1200);
    const b2Vec2 grip = pull.joint->GetAnchorB();
    EXPECT_NEAR(grip.x, 0.5f, 0.01f);
    EXPECT_NEAR(pull.load->GetPosition().x, grip.x, 0.01f);
    EXPECT_LT(pull.load->GetPosition().y, grip.y);
}

TEST(MouseJoint, WakesTheBodyOnlyWhenItsTargetChanges)
{
    Pull pull(1000.0f);
    pull.load->SetSleepingAllowed(true);
    pull.Step(300);
    ASSERT_FALSE(pull.load->IsAwake());
    pull.joint->SetTarget(pull.joint->GetTarget());
    EXPECT_FALSE(pull.load->IsAwake());
    pull.joint->SetTarget(b2Vec2(1.0f, 0.0f));
    EXPECT_TRUE(pull.load->IsAwake());
}

TEST(MouseJoint, ShiftsItsTargetWithTheOrigin)
{
    Pull pull(1000.0f);
    pull.world.ShiftOrigin(b2Vec2(5.0f, 1.0f));
    EXPECT_EQ(pull.joint->GetTarget(), b2Vec2(-5.0f, -1.0f));
    pull.Step(60);
    EXPECT_NEAR(pull.load->GetPosition().x, -5.0f, 1e-3f);
}

TEST(MouseJoint, UsesNumbersThatAreSetLater)
{
    Pull pull(1000.0f);
    pull.joint->SetMaxForce(500.0f);
    pull.joint->SetFrequency(2.0f);
    pull.joint->SetDampingRatio(1.0f);
    EXPECT_EQ(pull.joint->GetMaxForce(), 500.0f);
    EXPECT_EQ(pull.joint->GetFrequency(), 2.0f);
    EXPECT_EQ(pull.joint->GetDampingRatio(), 1.0f);
    pull.Step(600);
    const float32 omega = 2.0f * b2_pi * 2.0f;
    EXPECT_NEAR(pull.load->GetPosition().y, -kGravity / (omega * omega), 1e-3f);
}

} // namespace
