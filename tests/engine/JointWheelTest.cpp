// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Wheels on a suspension: guided along an axis by a spring, free to turn, driven.
namespace
{

using namespace dynamics;

/// A wheel of one metre below a post, on a vertical suspension.
struct Suspension : JointScene
{
    explicit Suspension(float32 frequencyHz = 2.0f, float32 dampingRatio = 0.7f,
                        float32 motorTorque = 0.0f, float32 motorSpeed = 0.0f)
    {
        wheel = Ball(0.0f, 0.0f, 1.0f);
        wheel->SetSleepingAllowed(false);
        b2WheelJointDef def;
        def.Initialize(Post(), wheel, wheel->GetPosition(), b2Vec2(0.0f, 1.0f));
        def.frequencyHz = frequencyHz;
        def.dampingRatio = dampingRatio;
        def.enableMotor = motorTorque > 0.0f;
        def.maxMotorTorque = motorTorque;
        def.motorSpeed = motorSpeed;
        joint = Create<b2WheelJoint>(def);
    }

    b2Body* wheel;
    b2WheelJoint* joint;
};

// A weight m g on a spring of stiffness m (2 pi f)^2.
TEST(WheelJoint, SagsUnderTheWeightByItsFrequency)
{
    for (const float32 frequency : {1.0f, 2.0f, 5.0f})
    {
        Suspension s(frequency);
        s.Step(600);
        const float32 omega = 2.0f * b2_pi * frequency;
        const float32 sag = kGravity / (omega * omega);
        EXPECT_NEAR(s.joint->GetJointTranslation(), -sag, 0.01f * sag) << frequency;
        EXPECT_NEAR(s.joint->GetReactionForce().y, kGravity * s.wheel->GetMass(), 0.05f);
    }
}

TEST(WheelJoint, SwingsWithItsFrequency)
{
    Suspension s(1.0f, 0.0f);
    float32 last = 0.0f;
    int crossings = 0;
    float32 first = 0.0f;
    float32 latest = 0.0f;
    const float32 middle = -kGravity / (4.0f * b2_pi * b2_pi);
    for (int i = 0; i < 600; ++i)
    {
        s.Step();
        const float32 y = s.wheel->GetPosition().y - middle;
        if (last > 0.0f && y <= 0.0f)
        {
            latest = float32(i) * kStep;
            first = crossings++ == 0 ? latest : first;
        }
        last = y;
    }
    // The implicit spring takes from the swing and lengthens it a little; measured 1.011 s.
    ASSERT_GE(crossings, 3);
    EXPECT_NEAR((latest - first) / float32(crossings - 1), 1.0f, 0.02f);
}

TEST(WheelJoint, NeverLeavesItsAxis)
{
    Suspension s;
    s.Shake(s.wheel, 600, [&] { EXPECT_NEAR(s.wheel->GetPosition().x, 0.0f, b2_linearSlop); });
}

TEST(WheelJoint, TurnsFreelyWithoutAMotor)
{
    Suspension s;
    s.wheel->SetAngularVelocity(7.0f);
    s.Step(60);
    EXPECT_NEAR(s.joint->GetJointSpeed(), 7.0f, 1e-4f);
    EXPECT_EQ(s.joint->GetReactionTorque(), 0.0f);
}

TEST(WheelJoint, ReachesItsMotorSpeedWithItsMaxMotorTorque)
{
    Suspension s(2.0f, 0.7f, 3.0f, 5.0f);
    const float32 inertia = s.wheel->GetInertia();
    s.Step(30);
    EXPECT_NEAR(s.joint->GetJointSpeed(), 0.5f * 3.0f / inertia, 1e-3f);
    EXPECT_NEAR(s.joint->GetMotorTorque(), 3.0f, 1e-3f);
    EXPECT_NEAR(s.joint->GetReactionTorque(1.0f / kStep), 3.0f, 1e-3f);
    s.Step(200);
    EXPECT_NEAR(s.joint->GetJointSpeed(), 5.0f, 1e-3f);
    EXPECT_NEAR(s.joint->GetMotorTorque(1.0f / kStep), 0.0f, 1e-3f);
}

TEST(WheelJoint, LeavesItsAxisFreeWithoutASpring)
{
    Suspension s(0.0f);
    s.Step(60);
    EXPECT_NEAR(s.wheel->GetLinearVelocity().y, -kGravity, 1e-3f);
}

TEST(WheelJoint, DrivesACarByItsMotors)
{
    JointScene scene;
    scene.Ground();
    b2Body* chassis = scene.Load(0.0f, 1.0f, 1.5f, 0.25f);
    b2Body* wheels[2];
    b2WheelJoint* joints[2];
    for (int i = 0; i < 2; ++i)
    {
        const float32 x = i == 0 ? -1.0f : 1.0f;
        wheels[i] = scene.Body(b2_dynamicBody, x, 0.4f);
        Scene::AddBall(wheels[i], 0.4f, 0.9f);
        b2WheelJointDef def;
        def.Initialize(chassis, wheels[i], wheels[i]->GetPosition(), b2Vec2(0.0f, 1.0f));
        def.frequencyHz = 4.0f;
        def.enableMotor = true;
        def.maxMotorTorque = 20.0f;
        def.motorSpeed = -10.0f;
        joints[i] = scene.Create<b2WheelJoint>(def);
    }
    scene.Step(300);
    EXPECT_NEAR(chassis->GetLinearVelocity().x, 10.0f * 0.4f, 0.05f) << "it rolls";
    EXPECT_NEAR(chassis->GetAngle(), 0.0f, 0.05f);
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(joints[i]->GetJointTranslation(), 0.0f, 0.2f);
    }
}

TEST(WheelJoint, WakesTheBodiesWhenAValueChanges)
{
    Suspension s;
    s.wheel->SetSleepingAllowed(true);
    const auto rest = [&] {
        s.Step(600);
        EXPECT_FALSE(s.wheel->IsAwake());
    };
    rest();
    s.joint->SetSpringFrequencyHz(3.0f);
    EXPECT_TRUE(s.wheel->IsAwake());
    EXPECT_EQ(s.joint->GetSpringFrequencyHz(), 3.0f);
    rest();
    s.joint->SetSpringDampingRatio(0.9f);
    EXPECT_TRUE(s.wheel->IsAwake());
    EXPECT_EQ(s.joint->GetSpringDampingRatio(), 0.9f);
    rest();
    s.joint->EnableMotor(true);
    EXPECT_TRUE(s.wheel->IsAwake());
    rest();
    s.joint->SetMaxMotorTorque(10.0f);
    EXPECT_TRUE(s.wheel->IsAwake());
    rest();
    s.joint->SetMotorSpeed(1.0f);
    EXPECT_TRUE(s.wheel->IsAwake());
}

} // namespace
