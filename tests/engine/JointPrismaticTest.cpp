// SPDX-License-Identifier: MIT
#include "JointScene.h"

/// Sliders: guided along an axis, limited, driven.
namespace
{

using namespace dynamics;

/// A box on a post, free to move along `axis` from where it is.
struct Slider : JointScene
{
    explicit Slider(const b2Vec2& axis, bool limited = false, float32 motorForce = 0.0f,
                    float32 motorSpeed = 0.0f, const b2Vec2& gravity = b2Vec2(0.0f, -10.0f))
        : JointScene(gravity), load(Load(0.0f, 0.0f))
    {
        b2PrismaticJointDef def;
        def.Initialize(Post(), load, load->GetPosition(), axis);
        def.enableLimit = limited;
        def.lowerTranslation = -2.0f;
        def.upperTranslation = 1.0f;
        def.enableMotor = motorForce > 0.0f;
        def.maxMotorForce = motorForce;
        def.motorSpeed = motorSpeed;
        joint = Create<b2PrismaticJoint>(def);
    }

    b2Body* load;
    b2PrismaticJoint* joint;
};

const b2Vec2 kUp(0.0f, 1.0f);

TEST(PrismaticJoint, GuidesABodyAlongItsAxisHoweverItIsPushed)
{
    const b2Vec2 axis(0.6f, 0.8f);
    Slider slider(axis);
    slider.Shake(slider.load, 600, [&] {
        EXPECT_NEAR(b2Cross(axis, slider.load->GetPosition()), 0.0f, b2_linearSlop);
        EXPECT_NEAR(slider.load->GetAngle(), 0.0f, b2_angularSlop);
        EXPECT_NEAR(slider.joint->GetJointTranslation(), b2Dot(axis, slider.load->GetPosition()),
                    1e-3f);
    });
    EXPECT_GT(slider.load->GetPosition().Length(), 1.0f) << "it does slide";
}

TEST(PrismaticJoint, LetsABodyFallFreelyAlongItsAxis)
{
    Slider slider(kUp);
    slider.Step(60);
    EXPECT_NEAR(slider.joint->GetJointSpeed(), -kGravity, 1e-4f);
    EXPECT_NEAR(slider.joint->GetJointTranslation(), -0.5f * kGravity * (1.0f + kStep), 1e-3f);
    EXPECT_NEAR(slider.joint->GetReactionForce(1.0f / kStep).Length(), 0.0f, 1e-4f);
}

TEST(PrismaticJoint, CarriesTheWeightAcrossItsAxis)
{
    Slider slider(b2Vec2(1.0f, 0.0f));
    slider.Step(10);
    const b2Vec2 force = slider.joint->GetReactionForce();
    EXPECT_NEAR(force.x, 0.0f, 1e-3f);
    EXPECT_NEAR(force.y, kGravity * slider.load->GetMass(), 1e-3f);
}

TEST(PrismaticJoint, HoldsALoadThatHangsOffTheAxisByItsTorque)
{
    JointScene scene;
    b2Body* load = scene.Load(1.5f, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(scene.Post(), load, b2Vec2(0.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    auto* joint = scene.Create<b2PrismaticJoint>(def);
    scene.Step(60);
    // The force acts at body B's centre line, so what remains is a torque of weight times arm.
    EXPECT_NEAR(b2Abs(joint->GetReactionTorque()), 1.5f * kGravity * load->GetMass(), 0.02f);
    EXPECT_NEAR(load->GetAngle(), 0.0f, b2_angularSlop);
}

TEST(PrismaticJoint, RestsOnItsLowerLimitWithItsWeight)
{
    Slider slider(kUp, true);
    slider.Step(180);
    EXPECT_NEAR(slider.joint->GetJointTranslation(), -2.0f, b2_linearSlop);
    EXPECT_NEAR(slider.joint->GetReactionForce().y, kGravity * slider.load->GetMass(), 1e-2f);
}

TEST(PrismaticJoint, DoesNotRunThroughALimitAtAnySpeed)
{
    for (const float32 speed : {5.0f, 50.0f, 110.0f})
    {
        Slider slider(kUp, true, 0.0f, 0.0f, b2Vec2(0.0f, 0.0f));
        slider.load->SetLinearVelocity(b2Vec2(0.0f, speed));
        for (int i = 0; i < 120; ++i)
        {
            slider.Step();
            ASSERT_LT(slider.joint->GetJointTranslation(), 1.0f + b2_linearSlop) << speed;
            ASSERT_GT(slider.joint->GetJointTranslation(), -2.0f - b2_linearSlop) << speed;
        }
        EXPECT_NEAR(slider.joint->GetJointTranslation(), 1.0f, b2_linearSlop);
    }
}

TEST(PrismaticJoint, IsRigidWithEqualLimits)
{
    Slider slider(kUp, true);
    slider.joint->SetLimits(-0.5f, -0.5f);
    slider.Step(60);
    slider.Shake(slider.load, 300,
                 [&] { EXPECT_NEAR(slider.joint->GetJointTranslation(), -0.5f, b2_linearSlop); });
}

TEST(PrismaticJoint, ReachesItsMotorSpeedWithItsMaxMotorForce)
{
    Slider slider(b2Vec2(1.0f, 0.0f), false, 4.0f, 3.0f); // 4 N on 1 kg
    slider.Step(30);
    EXPECT_NEAR(slider.joint->GetJointSpeed(), 2.0f, 1e-3f);
    EXPECT_NEAR(slider.joint->GetMotorForce(), 4.0f, 1e-3f);
    slider.Step(60);
    EXPECT_NEAR(slider.joint->GetJointSpeed(), 3.0f, 1e-4f);
    EXPECT_NEAR(slider.joint->GetMotorForce(1.0f / kStep), 0.0f, 1e-3f);
}

TEST(PrismaticJoint, HoldsAWeightUpToItsMaxMotorForce)
{
    Slider strong(kUp, false, 12.0f, 0.0f);
    strong.Step(120);
    EXPECT_NEAR(strong.joint->GetJointTranslation(), 0.0f, 1e-3f);
    EXPECT_NEAR(strong.joint->GetMotorForce(), kGravity, 1e-2f);

    Slider weak(kUp, false, 8.0f, 0.0f);
    weak.Step(60);
    EXPECT_NEAR(weak.joint->GetJointSpeed(), -2.0f, 1e-2f);
    EXPECT_NEAR(weak.joint->GetMotorForce(), 8.0f, 1e-2f);
}

TEST(PrismaticJoint, StopsItsMotorAtTheLimit)
{
    Slider slider(kUp, true, 1000.0f, 5.0f);
    slider.Step(120);
    EXPECT_NEAR(slider.joint->GetJointTranslation(), 1.0f, b2_linearSlop);
    EXPECT_NEAR(slider.joint->GetMotorForce(), 1000.0f, 1.0f);
    // The motor pushes up, the limit down: together they carry the weight.
    EXPECT_NEAR(slider.joint->GetReactionForce().y, kGravity, 1.0f);
}

TEST(PrismaticJoint, KeepsTheMomentumOfTwoFreeBodies)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Load(0.0f, 0.0f);
    b2Body* b = scene.Load(2.0f, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(a, b, b2Vec2(1.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    def.enableMotor = true;
    def.motorSpeed = 1.0f;
    def.maxMotorForce = 5.0f;
    scene.Create<b2PrismaticJoint>(def);
    a->SetAngularVelocity(2.0f);
    scene.Step(120);
    const b2Vec2 momentum =
        a->GetMass() * a->GetLinearVelocity() + b->GetMass() * b->GetLinearVelocity();
    EXPECT_NEAR(momentum.Length(), 0.0f, 1e-4f);
    EXPECT_NEAR(a->GetAngularVelocity(), b->GetAngularVelocity(), 1e-3f) << "they turn as one";
}

TEST(PrismaticJoint, WakesTheBodiesWhenAValueChanges)
{
    Slider slider(kUp, true);
    slider.load->SetSleepingAllowed(true);
    const auto rest = [&] {
        slider.Step(300);
        EXPECT_FALSE(slider.load->IsAwake());
    };
    rest();
    slider.joint->SetLimits(-1.0f, 1.0f);
    EXPECT_TRUE(slider.load->IsAwake());
    rest();
    slider.joint->EnableMotor(true);
    EXPECT_TRUE(slider.load->IsAwake());
    rest();
    slider.joint->SetMaxMotorForce(20.0f);
    EXPECT_TRUE(slider.load->IsAwake());
    rest();
    slider.joint->SetMotorSpeed(1.0f);
    EXPECT_TRUE(slider.load->IsAwake());
    slider.Step(300);
    EXPECT_NEAR(slider.joint->GetJointTranslation(), 1.0f, b2_linearSlop);
    slider.joint->EnableLimit(false);
    EXPECT_TRUE(slider.load->IsAwake());
}

TEST(PrismaticJoint, IsInitializedFromThePosesOfItsBodies)
{
    JointScene scene;
    b2Body* a = scene.Body(b2_staticBody, 1.0f, 2.0f, 0.5f * b2_pi);
    b2Body* b = scene.Body(b2_dynamicBody, 3.0f, 2.0f, 0.25f);
    b2PrismaticJointDef def;
    def.Initialize(a, b, b2Vec2(1.0f, 3.0f), b2Vec2(0.0f, 1.0f));
    EXPECT_NEAR(def.localAnchorA.x, 1.0f, 1e-6f);
    EXPECT_NEAR(def.localAxisA.x, 1.0f, 1e-6f);
    EXPECT_NEAR(def.referenceAngle, 0.25f - 0.5f * b2_pi, 1e-6f);
    auto* joint = scene.Create<b2PrismaticJoint>(def);
    EXPECT_NEAR(joint->GetJointTranslation(), 0.0f, 1e-6f);
    EXPECT_EQ(joint->GetReferenceAngle(), def.referenceAngle);
}

} // namespace
