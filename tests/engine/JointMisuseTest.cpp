// SPDX-License-Identifier: MIT
#include "DynamicsMisuse.h"
#include "JointScene.h"

/// Invalid calls on a joint in use. The joint keeps its values, and the world continues.
namespace
{

using namespace dynamics;

class JointMisuse : public testing::Test
{
protected:
    JointMisuse() { testing::FLAGS_gtest_death_test_style = "fast"; }
    ~JointMisuse() override
    {
        scene.Step(30);
        EXPECT_EQ(WhyBroken(scene.world, true), "");
        EXPECT_TRUE(load->GetPosition().IsValid());
    }

    template <class Joint, class Definition>
    Joint* Between()
    {
        Definition def;
        def.bodyA = post;
        def.bodyB = load;
        return scene.Create<Joint>(def);
    }

    JointScene scene;
    b2Body* post = scene.Post();
    b2Body* load = scene.Load(1.0f, 0.0f);
};

TEST_F(JointMisuse, IsRefusedForDefinitionsWithoutABody)
{
    const b2Vec2 at(0.5f, 0.0f);
    const b2Vec2 axis(1.0f, 0.0f);
    for (b2Body* a : {post, static_cast<b2Body*>(nullptr)})
    {
        const char* sentence = "two bodies";
        ExpectMisuse(sentence, [&] { b2DistanceJointDef().Initialize(a, nullptr, at, at); });
        ExpectMisuse(sentence, [&] { b2FrictionJointDef().Initialize(a, nullptr, at); });
        ExpectMisuse(sentence, [&] { b2MotorJointDef().Initialize(a, nullptr); });
        ExpectMisuse(sentence, [&] { b2PrismaticJointDef().Initialize(a, nullptr, at, axis); });
        ExpectMisuse(sentence,
                     [&] { b2PulleyJointDef().Initialize(a, nullptr, at, at, at, at, 1.0f); });
        ExpectMisuse(sentence, [&] { b2RevoluteJointDef().Initialize(a, nullptr, at); });
        ExpectMisuse(sentence, [&] { b2WeldJointDef().Initialize(a, nullptr, at); });
        ExpectMisuse(sentence, [&] { b2WheelJointDef().Initialize(a, nullptr, at, axis); });
    }
}

TEST_F(JointMisuse, IsRefusedByDistanceJoints)
{
    b2DistanceJointDef def;
    def.Initialize(post, load, post->GetPosition(), load->GetPosition());
    auto* joint = scene.Create<b2DistanceJoint>(def);
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("length", [&] { joint->SetLength(bad); });
        ExpectMisuse("frequency", [&] { joint->SetFrequency(bad); });
        ExpectMisuse("damping", [&] { joint->SetDampingRatio(bad); });
    }
    for (const float32 bad : {kNaN, kInfinity, 2e15f})
    {
        ExpectMisuse("limits", [&] { joint->SetMinLength(bad); });
    }
    for (const float32 bad : {kNaN, -kInfinity, 2e15f})
    {
        ExpectMisuse("limits", [&] { joint->SetMaxLength(bad); });
    }
    EXPECT_EQ(joint->GetMinLength(), 0.0f);
    EXPECT_EQ(joint->GetMaxLength(), b2_maxFloat);
    EXPECT_EQ(joint->GetLength(), 1.0f);
    EXPECT_EQ(joint->GetFrequency(), 0.0f);
    EXPECT_EQ(joint->GetDampingRatio(), 0.0f);
}

/// Of revolute and prismatic joints.
void ExpectMisuseOfLimitAndMotor(auto& joint)
{
    joint.EnableMotor(true);
    joint.EnableLimit(true);
    for (const float32 bad : {kNaN, kInfinity})
    {
        ExpectMisuse("limits", [&] { joint.SetLimits(-bad, 1.0f); });
        ExpectMisuse("limits", [&] { joint.SetLimits(-1.0f, bad); });
        ExpectMisuse("speed", [&] { joint.SetMotorSpeed(bad); });
    }
    ExpectMisuse("limits", [&] { joint.SetLimits(1.0f, -1.0f); });
    EXPECT_EQ(joint.GetLowerLimit(), 0.0f);
    EXPECT_EQ(joint.GetUpperLimit(), 0.0f);
    EXPECT_EQ(joint.GetMotorSpeed(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByRevoluteJoints)
{
    auto* joint = Between<b2RevoluteJoint, b2RevoluteJointDef>();
    ExpectMisuseOfLimitAndMotor(*joint);
    ExpectMisuse("torque", [&] { joint->SetMaxMotorTorque(kNaN); });
    ExpectMisuse("torque", [&] { joint->SetMaxMotorTorque(-1.0f); });
    EXPECT_EQ(joint->GetMaxMotorTorque(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByPrismaticJoints)
{
    auto* joint = Between<b2PrismaticJoint, b2PrismaticJointDef>();
    ExpectMisuseOfLimitAndMotor(*joint);
    ExpectMisuse("force", [&] { joint->SetMaxMotorForce(kNaN); });
    ExpectMisuse("force", [&] { joint->SetMotorForce(-1.0f); });
    EXPECT_EQ(joint->GetMaxMotorForce(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByWheelJoints)
{
    auto* joint = Between<b2WheelJoint, b2WheelJointDef>();
    joint->EnableMotor(true);
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("frequency", [&] { joint->SetSpringFrequencyHz(bad); });
        ExpectMisuse("damping", [&] { joint->SetSpringDampingRatio(bad); });
    }
    ExpectMisuse("speed", [&] { joint->SetMotorSpeed(kNaN); });
    ExpectMisuse("torque", [&] { joint->SetMaxMotorTorque(-1.0f); });
    EXPECT_EQ(joint->GetSpringFrequencyHz(), 2.0f);
    EXPECT_EQ(joint->GetMotorSpeed(), 0.0f);
    EXPECT_EQ(joint->GetMaxMotorTorque(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByWeldJoints)
{
    auto* joint = Between<b2WeldJoint, b2WeldJointDef>();
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("frequency", [&] { joint->SetFrequency(bad); });
        ExpectMisuse("damping", [&] { joint->SetDampingRatio(bad); });
    }
    EXPECT_EQ(joint->GetFrequency(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByRopeJoints)
{
    b2RopeJointDef def;
    def.bodyA = post;
    def.bodyB = load;
    def.maxLength = 3.0f;
    auto* joint = scene.Create<b2RopeJoint>(def);
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("length", [&] { joint->SetMaxLength(bad); });
    }
    EXPECT_EQ(joint->GetMaxLength(), 3.0f);
}

TEST_F(JointMisuse, IsRefusedByFrictionJoints)
{
    auto* joint = Between<b2FrictionJoint, b2FrictionJointDef>();
    for (const float32 bad : {kNaN, -1.0f})
    {
        ExpectMisuse("force", [&] { joint->SetMaxForce(bad); });
        ExpectMisuse("torque", [&] { joint->SetMaxTorque(bad); });
    }
    EXPECT_EQ(joint->GetMaxForce(), 0.0f);
}

TEST_F(JointMisuse, IsRefusedByMotorJoints)
{
    auto* joint = Between<b2MotorJoint, b2MotorJointDef>();
    for (const float32 bad : {kNaN, kInfinity})
    {
        ExpectMisuse("offset", [&] { joint->SetLinearOffset(b2Vec2(bad, 0.0f)); });
        ExpectMisuse("angles", [&] { joint->SetAngularOffset(bad); });
        ExpectMisuse("factor", [&] { joint->SetCorrectionFactor(bad); });
    }
    ExpectMisuse("force", [&] { joint->SetMaxForce(-1.0f); });
    ExpectMisuse("torque", [&] { joint->SetMaxTorque(kNaN); });
    EXPECT_EQ(joint->GetLinearOffset(), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(joint->GetMaxForce(), 1.0f);
}

TEST_F(JointMisuse, IsRefusedByMouseJoints)
{
    b2MouseJointDef def;
    def.bodyA = post;
    def.bodyB = load;
    def.target = load->GetPosition();
    def.maxForce = 100.0f;
    auto* joint = scene.Create<b2MouseJoint>(def);
    for (const float32 bad : {kNaN, kInfinity})
    {
        ExpectMisuse("target", [&] { joint->SetTarget(b2Vec2(0.0f, bad)); });
        ExpectMisuse("frequency", [&] { joint->SetFrequency(bad); });
        ExpectMisuse("damping", [&] { joint->SetDampingRatio(bad); });
    }
    ExpectMisuse("force", [&] { joint->SetMaxForce(-1.0f); });
    EXPECT_EQ(joint->GetTarget(), b2Vec2(1.0f, 0.0f));
    EXPECT_EQ(joint->GetMaxForce(), 100.0f);
}

TEST_F(JointMisuse, IsRefusedByGearJoints)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, load, load->GetPosition());
    b2Body* second = scene.Load(5.0f, 0.0f);
    b2GearJointDef def;
    def.bodyA = load;
    def.bodyB = second;
    def.joint1 = scene.world.CreateJoint(&hinge);
    hinge.Initialize(post, second, second->GetPosition());
    def.joint2 = scene.world.CreateJoint(&hinge);
    auto* gear = scene.Create<b2GearJoint>(def);
    ExpectMisuse("ratio", [&] { gear->SetRatio(kNaN); });
    ExpectMisuse("ratio", [&] { gear->SetRatio(kInfinity); });
    EXPECT_EQ(gear->GetRatio(), 1.0f);
    gear->SetRatio(0.0f); // lets the second one go
    b2Body* foreign = scene.Load(9.0f, 0.0f);
    for (b2Body** named : {&def.bodyA, &def.bodyB})
    {
        b2Body* const sound = *named;
        *named = foreign;
        ExpectMisuse("bodyA and bodyB", [&] { scene.world.CreateJoint(&def); });
        *named = sound;
    }
    EXPECT_EQ(scene.world.GetJointCount(), 3);
}

} // namespace
