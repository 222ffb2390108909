// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

/// Motors, limits, ropes and friction, in steps of four sub-steps.
namespace
{

using namespace dynamics;

/// A wheel on a bearing, between two bodies that both move.
struct Bearing : SmallScene
{
    Bearing()
        : SmallScene(b2Vec2(0.0f, 0.0f)), a(Part(0.0f, 0.0f, 0.5f, 0.5f)),
          b(Part(0.0f, 0.0f, 0.3f, 0.3f)), joint(Hinge(a, b, 0.0f, 0.0f))
    {}

    b2Body* a;
    b2Body* b;
    b2RevoluteJoint* joint;
};

TEST(SubStepsMotor, ReachesItsSpeedAtOnceWhenStrong)
{
    Bearing s;
    s.joint->EnableMotor(true);
    s.joint->SetMotorSpeed(3.0f);
    s.joint->SetMaxMotorTorque(1e6f);
    s.Step();
    EXPECT_NEAR(s.joint->GetJointSpeed(), 3.0f, 1e-5f);
    EXPECT_NEAR(s.Spin(), 0.0f, 1e-5f);
    s.Step();
    EXPECT_NEAR(s.joint->GetMotorTorque(), 0.0f, 1e-3f);
}

/// An arm of two, each held 5 m from its centre, that stretches and folds: the upper joint's motor
/// would need twice the torque that it has.
TEST(SubStepsMotor, StaysBelowItsMaximumWhenItsFrameTurns)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* upper = s.Part(5.0f, 0.0f, 0.4f, 0.4f);
    b2Body* lower = s.Part(15.0f, 0.0f, 0.8f, 0.8f);
    s.Hinge(s.Post(), upper, 0.0f, 0.0f);
    b2RevoluteJoint* motor = s.Hinge(upper, lower, 10.0f, 0.0f);
    motor->EnableMotor(true);
    motor->SetMotorSpeed(6.8f);
    motor->SetMaxMotorTorque(600.0f);
    double maximum = 0.0;
    bool slows = false;
    for (int step = 0; step < 60; ++step)
    {
        const float32 before = motor->GetJointSpeed();
        s.Step();
        const float32 fastest = b2Max(before, b2Max(motor->GetJointSpeed(), 6.8f));
        maximum += 600.0 * double(fastest * kStep);
        slows = slows || (step > 10 && motor->GetJointSpeed() < 6.5f);
        ASSERT_LE(s.Energy(), 1.001 * maximum) << "step " << step;
    }
    EXPECT_TRUE(slows);
}

TEST(SubStepsMotor, AppliesItsMaximumUntilItReachesItsSpeed)
{
    Bearing s;
    s.joint->EnableMotor(true);
    s.joint->SetMotorSpeed(5.0f);
    s.joint->SetMaxMotorTorque(0.1f);
    const float32 gain = 0.1f * (1.0f / s.a->GetInertia() + 1.0f / s.b->GetInertia());
    for (int i = 1; float32(i) * kStep * gain < 4.9f; ++i)
    {
        s.Step();
        ASSERT_NEAR(s.joint->GetMotorTorque(), 0.1f, 1e-6f);
        ASSERT_NEAR(s.joint->GetJointSpeed(), float32(i) * kStep * gain, 1e-3f);
    }
    s.Step(30);
    EXPECT_NEAR(s.joint->GetJointSpeed(), 5.0f, 1e-5f);
    EXPECT_NEAR(s.joint->GetMotorTorque(), 0.0f, 1e-5f);
}

// The torque that turns a rod about its end evenly: m g l cos(angle).
TEST(SubStepsMotor, ReportsItsTorque)
{
    SmallScene s;
    b2Body* rod = s.Part(0.5f, 0.0f);
    b2RevoluteJoint* joint = s.Hinge(s.Post(), rod, 0.0f, 0.0f);
    joint->EnableMotor(true);
    joint->SetMotorSpeed(1.0f);
    joint->SetMaxMotorTorque(1e6f);
    const float32 weight = rod->GetMass() * kGravity;
    s.Step();
    for (int i = 0; i < 600; ++i)
    {
        const float32 angle = joint->GetJointAngle() + 0.5f * kStep;
        s.Step();
        ASSERT_NEAR(joint->GetJointSpeed(), 1.0f, 1e-4f);
        ASSERT_NEAR(joint->GetMotorTorque(), 0.5f * weight * std::cos(angle), 0.005f * weight);
    }
}

// Every second motor is too weak for its load, and gives way.
TEST(SubStepsMotor, HoldsAnArmOfManyJoints)
{
    SmallScene s;
    b2Body* last = s.Post();
    std::vector<b2RevoluteJoint*> joints;
    for (int i = 0; i < 8; ++i)
    {
        b2Body* body = s.Part(0.5f + float32(i), 0.0f);
        joints.push_back(s.Hinge(last, body, float32(i), 0.0f));
        joints.back()->EnableMotor(true);
        joints.back()->SetMaxMotorTorque(1e6f);
        last = body;
    }
    s.Step(300);
    EXPECT_NEAR(last->GetPosition().x, 7.5f, 1e-3f);
    EXPECT_NEAR(last->GetPosition().y, 0.0f, 1e-3f);
    for (int i = 0; i < 8; ++i)
    {
        const float32 beyond = 8.0f - float32(i);
        const float32 torque = s.parts[0]->GetMass() * kGravity * beyond * beyond / 2.0f;
        EXPECT_NEAR(joints[std::size_t(i)]->GetMotorTorque(), torque, 0.005f * torque) << i;
    }
    joints[3]->SetMaxMotorTorque(15.0f); // of 25
    s.Step();
    EXPECT_NEAR(joints[3]->GetMotorTorque(), 15.0f, 1e-4f);
    for (const int i : {0, 1, 2, 4, 5, 6, 7})
    {
        EXPECT_NEAR(joints[std::size_t(i)]->GetJointSpeed(), 0.0f, 1e-4f) << i;
    }
    EXPECT_LT(joints[3]->GetJointSpeed(), -0.01f);
}

TEST(SubStepsMotor, LiftsASliderWithItsMaximumForce)
{
    SmallScene s;
    b2Body* load = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2PrismaticJoint* joint = s.Slider(s.Post(), load, 0.0f, 0.0f, b2Vec2(0.0f, 1.0f));
    joint->EnableMotor(true);
    joint->SetMotorSpeed(2.0f);
    joint->SetMaxMotorForce(15.0f * load->GetMass());
    s.Step(12); // at 5 m/s^2
    EXPECT_NEAR(joint->GetJointSpeed(), 1.0f, 1e-3f);
    EXPECT_NEAR(joint->GetMotorForce(), 15.0f * load->GetMass(), 1e-3f);
    s.Step(60);
    EXPECT_NEAR(joint->GetJointSpeed(), 2.0f, 1e-4f);
    EXPECT_NEAR(joint->GetMotorForce(), 10.0f * load->GetMass(), 0.05f);
}

TEST(SubStepsMotor, AcceleratesALoadOnAPlatformOfLevers)
{
    // A foot is pulled in, and two bars push up a platform 15 times as fast. Much more than the
    // impulse of the motor in a sub-step goes into their speed, and then contacts have to follow.
    SmallScene s;
    b2Body* post = s.Post();
    b2Body* platform = s.Load(0.0f, 0.0f, 2.0f, 0.1f);
    s.Slider(post, platform, 0.0f, 0.0f, b2Vec2(0.0f, 1.0f));
    b2Body* foot = s.Part(3.0f, -0.2f, 0.1f, 0.1f);
    b2PrismaticJoint* motor = s.Slider(post, foot, 3.0f, -0.2f, b2Vec2(1.0f, 0.0f));
    s.Rod(foot, platform, b2Vec2(3.0f, -0.2f), b2Vec2(0.0f, 0.0f));
    for (const float32 x : {-1.5f, 0.0f, 1.5f})
    {
        s.Load(x, 0.61f, 0.5f, 0.5f);
    }
    motor->EnableMotor(true);
    motor->SetMotorSpeed(-0.1f);
    motor->SetMaxMotorForce(5000.0f);
    s.Step(60);
    EXPECT_NEAR(motor->GetJointSpeed(), -0.1f, 1e-3f);
    EXPECT_GT(platform->GetPosition().y, 0.5f);
}

TEST(SubStepsMotor, TurnsAWheelOnItsSpring)
{
    SmallScene s;
    b2Body* car = s.Part(0.0f, 0.0f, 1.0f, 0.3f);
    b2Body* wheel = s.Part(0.0f, -0.5f, 0.3f, 0.3f);
    s.Slider(s.Post(), car, 0.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    b2WheelJointDef def;
    def.Initialize(car, wheel, b2Vec2(0.0f, -0.5f), b2Vec2(0.0f, 1.0f));
    def.enableMotor = true;
    def.motorSpeed = -4.0f;
    def.maxMotorTorque = 0.05f;
    def.frequencyHz = 4.0f;
    def.dampingRatio = 0.7f;
    auto* joint = s.Create<b2WheelJoint>(def);
    s.Step(6);
    EXPECT_NEAR(joint->GetMotorTorque(), -0.05f, 1e-6f);
    EXPECT_NEAR(joint->GetJointSpeed(), -0.1f * 0.05f / wheel->GetInertia(), 1e-3f);
    s.Step(300);
    EXPECT_NEAR(joint->GetJointSpeed(), -4.0f, 1e-4f);
    EXPECT_NEAR(b2Dot(joint->GetReactionForce(), b2Vec2(0.0f, 1.0f)), wheel->GetMass() * kGravity,
                0.005f * wheel->GetMass() * kGravity);
}

// It falls onto the lower limit, and is thrown against the upper.
TEST(SubStepsLimit, StopsAPendulum)
{
    SmallScene s;
    b2Body* rod = s.Part(0.5f, 0.0f);
    b2RevoluteJoint* joint = s.Hinge(s.Post(), rod, 0.0f, 0.0f);
    joint->EnableLimit(true);
    joint->SetLimits(-0.5f, 0.25f);
    for (int i = 0; i < 300; ++i)
    {
        if (i == 100 || i == 200)
        {
            rod->SetAngularVelocity(float32(i) / 10.0f);
        }
        s.Step();
        ASSERT_GE(joint->GetJointAngle(), -0.501f) << i;
        ASSERT_LE(joint->GetJointAngle(), 0.251f) << i;
    }
    EXPECT_NEAR(joint->GetJointAngle(), -0.5f, 1e-3f);
    const float32 torque = 0.5f * rod->GetMass() * kGravity * std::cos(0.5f);
    EXPECT_NEAR(joint->GetReactionTorque(), torque, 0.005f * torque);
}

// A whip of eight links, each of which can bend a little.
TEST(SubStepsLimit, HoldsInAWhippedChain)
{
    SmallScene s;
    b2Body* last = s.Post();
    std::vector<b2RevoluteJoint*> joints;
    for (int i = 0; i < 8; ++i)
    {
        b2Body* body = s.Part(0.5f + float32(i), 0.0f);
        joints.push_back(s.Hinge(last, body, float32(i), 0.0f));
        joints.back()->EnableLimit(true);
        joints.back()->SetLimits(-0.3f, 0.2f);
        last = body;
    }
    float32 beyond = 0.0f;
    for (int i = 0; i < 600; ++i)
    {
        if (i % 60 == 30)
        {
            last->SetLinearVelocity(b2Vec2(30.0f * s.Random(), 30.0f * s.Random()));
        }
        s.Step();
        for (const b2RevoluteJoint* joint : joints)
        {
            beyond =
                b2Max(beyond, b2Max(joint->GetJointAngle() - 0.2f, -0.3f - joint->GetJointAngle()));
            ASSERT_LT(Gap(joint), kHeld);
        }
    }
    RecordProperty("beyond", std::to_string(beyond));
    EXPECT_LT(beyond, 1e-3f);
}

TEST(SubStepsLimit, StopsASliderBetweenTwoMovingBodies)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* a = s.Part(0.0f, 0.0f);
    b2Body* b = s.Part(0.0f, 0.0f, 0.2f, 0.2f);
    b2PrismaticJoint* joint = s.Slider(a, b, 0.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    joint->EnableLimit(true);
    joint->SetLimits(-0.5f, 1.0f);
    a->SetAngularVelocity(3.0f);
    b->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    s.Step();
    const b2Vec2 momentum = s.Momentum();
    const float32 spin = s.Spin();
    for (int i = 0; i < 600; ++i)
    {
        s.Step();
        ASSERT_LE(joint->GetJointTranslation(), 1.001f);
        ASSERT_GE(joint->GetJointTranslation(), -0.501f);
    }
    EXPECT_NEAR(joint->GetJointTranslation(), 1.0f, 1e-3f);
    EXPECT_LT(b2Distance(s.Momentum(), momentum), 1e-4f);
    EXPECT_NEAR(s.Spin(), spin, 1e-4f);
}

TEST(SubStepsLimit, CorrectsAViolationGradually)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* rod = s.Part(0.5f, 0.0f);
    b2RevoluteJoint* joint = s.Hinge(s.Post(), rod, 0.0f, 0.0f);
    joint->EnableLimit(true);
    joint->SetLimits(0.5f, 1.5f);
    float32 fastest = 0.0f;
    int steps = 0;
    for (; steps < 60 && joint->GetJointAngle() < 0.499f; ++steps)
    {
        s.Step();
        fastest = b2Max(fastest, rod->GetAngularVelocity());
    }
    EXPECT_LT(steps, 30);
    EXPECT_LT(fastest, 2.01f);
}

TEST(SubStepsLimit, HoldsLikeAWeldWithEqualBounds)
{
    SmallScene s;
    b2Body* rod = s.Part(0.5f, 0.0f);
    b2RevoluteJoint* joint = s.Hinge(s.Post(), rod, 0.0f, 0.0f);
    joint->EnableLimit(true);
    joint->SetLimits(0.0f, 0.0f);
    joint->EnableMotor(true);
    joint->SetMotorSpeed(-2.0f);
    joint->SetMaxMotorTorque(3.0f);
    s.Step(120);
    EXPECT_NEAR(joint->GetJointAngle(), 0.0f, 1e-4f);
    EXPECT_NEAR(joint->GetMotorTorque(), -3.0f, 1e-3f);
    const float32 torque = 0.5f * rod->GetMass() * kGravity;
    EXPECT_NEAR(joint->GetReactionTorque(), torque, 0.005f * torque);
}

TEST(SubStepsLimit, SharesOneAxisWithAMotor)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* load = s.Part(0.0f, 0.0f);
    b2PrismaticJoint* joint = s.Slider(s.Post(), load, 0.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    joint->EnableLimit(true);
    joint->SetLimits(-1.0f, 1.0f);
    joint->EnableMotor(true);
    joint->SetMotorSpeed(2.0f);
    joint->SetMaxMotorForce(7.0f);
    s.Step(120);
    EXPECT_NEAR(joint->GetJointTranslation(), 1.0f, 1e-3f);
    EXPECT_NEAR(joint->GetMotorForce(), 7.0f, 1e-4f);
    EXPECT_NEAR(joint->GetReactionForce().x, 0.0f, 1e-4f);
    joint->SetMotorSpeed(-2.0f);
    s.Step(120);
    EXPECT_NEAR(joint->GetJointTranslation(), -1.0f, 1e-3f);
    EXPECT_NEAR(joint->GetMotorForce(), -7.0f, 1e-4f);
}

TEST(SubStepsRope, StopsAFallingBody)
{
    SmallScene s;
    b2Body* load = s.Part(0.5f, 0.0f, 0.3f, 0.3f);
    b2RopeJointDef def;
    def.bodyA = s.Post();
    def.bodyB = load;
    def.localAnchorA.SetZero();
    def.localAnchorB.Set(0.0f, 0.3f);
    def.maxLength = 2.0f;
    auto* joint = s.Create<b2RopeJoint>(def);
    float32 longest = 0.0f;
    for (int i = 0; i < 600; ++i)
    {
        s.Step();
        longest = b2Max(longest, Gap(joint));
    }
    RecordProperty("beyond", std::to_string(longest - 2.0f));
    EXPECT_LT(longest, 2.001f);
    EXPECT_GT(longest, 1.99f);
}

TEST(SubStepsRope, HoldsAWeight)
{
    SmallScene s;
    b2Body* load = s.Part(0.0f, -2.0f, 0.3f, 0.3f);
    b2RopeJointDef def;
    def.bodyA = s.Post();
    def.bodyB = load;
    def.localAnchorA.SetZero();
    def.localAnchorB.SetZero();
    def.maxLength = 2.0f;
    auto* joint = s.Create<b2RopeJoint>(def);
    s.Step(120);
    const float32 weight = load->GetMass() * kGravity;
    EXPECT_NEAR(joint->GetReactionForce().y, weight, 0.005f * weight);
    EXPECT_EQ(joint->GetLimitState(), e_atUpperLimit);
}

TEST(SubStepsFriction, DeceleratesByItsMaximumForce)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* a = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2Body* b = s.Part(0.0f, 0.0f, 0.4f, 0.4f);
    b2FrictionJointDef def;
    def.Initialize(a, b, b2Vec2(0.0f, 0.0f));
    def.maxForce = 0.5f;
    def.maxTorque = 0.02f;
    auto* joint = s.Create<b2FrictionJoint>(def);
    b->SetLinearVelocity(b2Vec2(3.0f, 4.0f));
    b->SetAngularVelocity(2.0f);
    const b2Vec2 momentum = s.Momentum();
    const float32 spin = s.Spin();
    s.Step(60);
    EXPECT_NEAR(b->GetLinearVelocity().Length(), 5.0f - 0.5f / b->GetMass(), 0.02f);
    EXPECT_NEAR(b->GetAngularVelocity(), 2.0f - 0.02f / b->GetInertia(), 0.01f);
    EXPECT_NEAR(joint->GetReactionForce().Length(), 0.5f, 0.005f);
    EXPECT_NEAR(joint->GetReactionTorque(), -0.02f, 1e-5f);
    EXPECT_LT(b2Distance(s.Momentum(), momentum), 1e-4f);
    EXPECT_NEAR(s.Spin(), spin, 1e-3f);
}

TEST(SubStepsFriction, HoldsLoadsBelowItsMaximum)
{
    SmallScene s;
    b2Body* load = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2FrictionJointDef def;
    def.Initialize(s.Post(), load, b2Vec2(0.2f, 0.0f));
    def.maxForce = 1.1f * load->GetMass() * kGravity;
    def.maxTorque = 1.1f * 0.2f * load->GetMass() * kGravity;
    auto* joint = s.Create<b2FrictionJoint>(def);
    s.Step(120);
    EXPECT_LT(load->GetPosition().Length(), 1e-4f);
    EXPECT_NEAR(joint->GetReactionForce().y, load->GetMass() * kGravity, 0.05f);
    joint->SetMaxForce(0.5f * load->GetMass() * kGravity);
    s.Step(60);
    EXPECT_NEAR(load->GetLinearVelocity().y, -5.0f, 0.05f);
    EXPECT_NEAR(joint->GetReactionForce().y, 5.0f * load->GetMass(), 0.05f);
}

TEST(SubStepsMotorJoint, ReachesItsTarget)
{
    SmallScene s;
    b2Body* load = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2MotorJointDef def;
    def.Initialize(s.Post(), load);
    def.maxForce = 100.0f * load->GetMass();
    def.maxTorque = 100.0f;
    auto* joint = s.Create<b2MotorJoint>(def);
    joint->SetLinearOffset(b2Vec2(1.0f, 0.5f));
    joint->SetAngularOffset(0.4f);
    s.Step(120);
    EXPECT_LT(b2Distance(load->GetPosition(), b2Vec2(1.0f, 0.5f)), 1e-3f);
    EXPECT_NEAR(load->GetAngle(), 0.4f, 1e-3f);
    const float32 weight = load->GetMass() * kGravity;
    EXPECT_NEAR(joint->GetReactionForce().y, weight, 0.005f * weight);
}

/// Returns the energy of two bodies that a motor joint drives apart and a rigid one holds together.
double EnergyOfTornPair(b2JointType type, float32 speed, float32 lever)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* heavy = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2Body* light = s.Part(2.7f, 0.0f, 0.05f, 0.05f);
    type == e_weldJoint ? (void)s.Weld(heavy, light, 1.0f, lever)
                        : (void)s.Hinge(heavy, light, 1.0f, lever);
    b2MotorJointDef def;
    def.Initialize(heavy, light);
    def.maxForce = 2500.0f;
    def.maxTorque = 47.0f;
    s.Create<b2MotorJoint>(def);
    light->SetLinearVelocity(b2Vec2(-0.4f * speed, speed));
    light->SetAngularVelocity(0.3f * speed);
    heavy->SetAngularVelocity(-0.1f * speed);
    const auto energy = [&] {
        double sum = 0.0;
        for (const b2Body* body : {heavy, light})
        {
            const float32 w = body->GetAngularVelocity();
            sum += 0.5 * double(body->GetMass() * body->GetLinearVelocity().LengthSquared());
            sum += 0.5 * double(body->GetInertia() * w * w);
        }
        return sum;
    };
    const double before = energy();
    s.Step();
    return energy() / before;
}

TEST(SubStepsMotorJoint, GainsNoEnergyAgainstRigidJoints)
{
    for (const b2JointType type : {e_weldJoint, e_revoluteJoint})
    {
        for (float32 speed = 5.0f; speed < 200.0f; speed *= 2.0f)
        {
            for (const float32 lever : {0.0f, 1.0f, 9.0f})
            {
                EXPECT_LT(EnergyOfTornPair(type, speed, lever), 1.01)
                    << "joint type " << type << ", " << speed << " m/s, lever " << lever;
            }
        }
    }
}

} // namespace
