// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Friction seen from above: a force and a torque against any motion, up to their limits.
namespace
{

using namespace dynamics;

struct Drag : JointScene
{
    Drag(float32 force, float32 torque) : JointScene(b2Vec2(0.0f, 0.0f)), load(Load(0.0f, 0.0f))
    {
        b2FrictionJointDef def;
        def.Initialize(Post(), load, load->GetPosition());
        def.maxForce = force;
        def.maxTorque = torque;
        joint = Create<b2FrictionJoint>(def);
    }

    b2Body* load;
    b2FrictionJoint* joint;
};

TEST(FrictionJoint, SlowsASlideByItsForce)
{
    Drag drag(2.0f, 0.0f);
    drag.load->SetLinearVelocity(b2Vec2(3.0f, 4.0f));
    drag.Step(60);
    EXPECT_NEAR(drag.load->GetLinearVelocity().x, 3.0f * 0.6f, 1e-3f);
    EXPECT_NEAR(drag.load->GetLinearVelocity().y, 4.0f * 0.6f, 1e-3f);
    const b2Vec2 force = drag.joint->GetReactionForce();
    EXPECT_NEAR(force.x, -2.0f * 0.6f, 1e-3f) << "against the motion in every direction";
    EXPECT_NEAR(force.y, -2.0f * 0.8f, 1e-3f);
    drag.Step(120);
    EXPECT_NEAR(drag.load->GetLinearVelocity().Length(), 0.0f, 1e-5f) << "and it stays stopped";
}

TEST(FrictionJoint, SlowsASpinByItsTorque)
{
    Drag drag(0.0f, 0.5f);
    const float32 inertia = drag.load->GetInertia();
    drag.load->SetAngularVelocity(6.0f);
    drag.Step(30);
    EXPECT_NEAR(drag.load->GetAngularVelocity(), 6.0f - 0.5f * 0.5f / inertia, 1e-3f);
    EXPECT_NEAR(drag.joint->GetReactionTorque(1.0f / kStep), -0.5f, 1e-4f);
    drag.Step(300);
    EXPECT_NEAR(drag.load->GetAngularVelocity(), 0.0f, 1e-5f);
}

TEST(FrictionJoint, HoldsASmallerForceAndSlipsUnderALargerOne)
{
    Drag drag(2.0f, 1.0f);
    for (int i = 0; i < 60; ++i)
    {
        drag.load->ApplyForceToCenter(b2Vec2(1.9f, 0.0f));
        drag.Step();
    }
    EXPECT_NEAR(drag.load->GetPosition().x, 0.0f, 1e-4f);
    for (int i = 0; i < 60; ++i)
    {
        drag.load->ApplyForceToCenter(b2Vec2(5.0f, 0.0f));
        drag.Step();
    }
    EXPECT_NEAR(drag.load->GetLinearVelocity().x, 3.0f, 1e-2f);
}

TEST(FrictionJoint, UsesMaximaThatAreSetLater)
{
    Drag drag(2.0f, 1.0f);
    drag.joint->SetMaxForce(4.0f);
    drag.joint->SetMaxTorque(3.0f);
    EXPECT_EQ(drag.joint->GetMaxForce(), 4.0f);
    EXPECT_EQ(drag.joint->GetMaxTorque(), 3.0f);
    drag.load->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
    drag.Step(60);
    EXPECT_NEAR(drag.load->GetLinearVelocity().x, 6.0f, 1e-3f);
}

} // namespace
