// SPDX-License-Identifier: MIT
#include "RubeBuilt.h"

#include <gmock/gmock.h>

// One test a kind of joint, and what keeps one from being built.
namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// A joint of this kind between the ground and a ball.
template <class Joint>
const Joint& OnlyJoint(const Built& built)
{
    EXPECT_THAT(built.leftOut, IsEmpty());
    return dynamic_cast<const Joint&>(*built.world.GetJointList());
}

std::string WithJoint(const std::string& members)
{
    return R"({"body":[{},{"type":2}],"joint":[{"bodyA":0,"bodyB":1,"anchorA":{"x":1,"y":2},)"
           R"("anchorB":{"x":3,"y":4},)" +
           members + "}]}";
}

TEST(RubeJointBuilder, BuildsRevoluteAndDistanceJoints)
{
    Built built(R"({"body":[{"type":2},{"type":2}],"joint":[
        {"type":"revolute","bodyA":0,"bodyB":1,"anchorA":0,"anchorB":{"x":1,"y":-1},
         "refAngle":0.5,"enableLimit":true,"lowerLimit":-1,"upperLimit":2,"enableMotor":true,
         "motorSpeed":3,"maxMotorTorque":100,"collideConnected":true},
        {"type":"distance","bodyA":1,"bodyB":0,"length":2.5,"frequency":4,"dampingRatio":0.5}]})");
    EXPECT_THAT(built.leftOut, IsEmpty());
    ASSERT_EQ(built.world.GetJointCount(), 2);
    b2Joint* newest = built.world.GetJointList();
    ASSERT_EQ(newest->GetType(), e_distanceJoint);
    const auto* distance = static_cast<b2DistanceJoint*>(newest);
    EXPECT_EQ(distance->GetLength(), 2.5f);
    EXPECT_EQ(distance->GetFrequency(), 4.0f);
    EXPECT_EQ(distance->GetDampingRatio(), 0.5f);
    ASSERT_EQ(newest->GetNext()->GetType(), e_revoluteJoint);
    const auto* revolute = static_cast<b2RevoluteJoint*>(newest->GetNext());
    EXPECT_EQ(revolute->GetLocalAnchorB(), b2Vec2(1.0f, -1.0f));
    EXPECT_EQ(revolute->GetReferenceAngle(), 0.5f);
    EXPECT_TRUE(revolute->IsLimitEnabled());
    EXPECT_EQ(revolute->GetLowerLimit(), -1.0f);
    EXPECT_EQ(revolute->GetUpperLimit(), 2.0f);
    EXPECT_TRUE(revolute->IsMotorEnabled());
    EXPECT_EQ(revolute->GetMotorSpeed(), 3.0f);
    EXPECT_EQ(revolute->GetMaxMotorTorque(), 100.0f);
    EXPECT_TRUE(revolute->GetCollideConnected());
}

TEST(RubeJointBuilder, BuildsPrismaticJointsWithEveryField)
{
    for (const char* axis : {"localAxisA", "localAxis1"})
    {
        Built built(R"({"body":[{},{"type":2}],"joint":[{"type":"prismatic","bodyA":0,"bodyB":1,
            "anchorA":{"x":1,"y":2},"anchorB":{"x":3,"y":4},"refAngle":0.5,")" +
                    std::string(axis) + R"(":{"x":3,"y":4},"enableLimit":true,
            "lowerLimit":-1,"upperLimit":2,"enableMotor":true,"motorSpeed":3,
            "maxMotorForce":100}]})");
        ASSERT_THAT(built.leftOut, IsEmpty());
        const auto* joint = dynamic_cast<b2PrismaticJoint*>(built.world.GetJointList());
        ASSERT_NE(joint, nullptr);
        EXPECT_EQ(joint->GetLocalAnchorA(), b2Vec2(1.0f, 2.0f));
        EXPECT_EQ(joint->GetLocalAnchorB(), b2Vec2(3.0f, 4.0f));
        EXPECT_NEAR(joint->GetLocalAxisA().x, 0.6f, 1e-6f);
        EXPECT_NEAR(joint->GetLocalAxisA().y, 0.8f, 1e-6f);
        EXPECT_EQ(joint->GetReferenceAngle(), 0.5f);
        EXPECT_TRUE(joint->IsLimitEnabled());
        EXPECT_EQ(joint->GetLowerLimit(), -1.0f);
        EXPECT_EQ(joint->GetUpperLimit(), 2.0f);
        EXPECT_TRUE(joint->IsMotorEnabled());
        EXPECT_EQ(joint->GetMotorSpeed(), 3.0f);
        EXPECT_EQ(joint->GetMaxMotorForce(), 100.0f);
    }
}

TEST(RubeJointBuilder, BuildsWheelJointsWithEveryField)
{
    const Built built(WithJoint(R"("type":"wheel","localAxisA":{"x":3,"y":4},"enableMotor":true,
        "motorSpeed":2,"maxMotorTorque":50,"springFrequency":5,"springDampingRatio":0.25)"));
    const auto& joint = OnlyJoint<b2WheelJoint>(built);
    EXPECT_EQ(joint.GetLocalAnchorA(), b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(joint.GetLocalAnchorB(), b2Vec2(3.0f, 4.0f));
    EXPECT_NEAR(joint.GetLocalAxisA().y, 0.8f, 1e-6f);
    EXPECT_TRUE(joint.IsMotorEnabled());
    EXPECT_EQ(joint.GetMotorSpeed(), 2.0f);
    EXPECT_EQ(joint.GetMaxMotorTorque(), 50.0f);
    EXPECT_EQ(joint.GetSpringFrequencyHz(), 5.0f);
    EXPECT_EQ(joint.GetSpringDampingRatio(), 0.25f);
}

TEST(RubeJointBuilder, BuildsAllFieldsOfWeldRopeAndFrictionJoints)
{
    const Built welded(
        WithJoint(R"("type":"weld","refAngle":0.5,"frequency":4,"dampingRatio":0.75)"));
    const auto& weld = OnlyJoint<b2WeldJoint>(welded);
    EXPECT_EQ(weld.GetLocalAnchorB(), b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(weld.GetReferenceAngle(), 0.5f);
    EXPECT_EQ(weld.GetFrequency(), 4.0f);
    EXPECT_EQ(weld.GetDampingRatio(), 0.75f);
    const Built roped(WithJoint(R"("type":"rope","maxLength":7)"));
    EXPECT_EQ(OnlyJoint<b2RopeJoint>(roped).GetMaxLength(), 7.0f);
    EXPECT_EQ(OnlyJoint<b2RopeJoint>(roped).GetLocalAnchorA(), b2Vec2(1.0f, 2.0f));
    const Built rubbed(WithJoint(R"("type":"friction","maxForce":8,"maxTorque":9)"));
    EXPECT_EQ(OnlyJoint<b2FrictionJoint>(rubbed).GetMaxForce(), 8.0f);
    EXPECT_EQ(OnlyJoint<b2FrictionJoint>(rubbed).GetMaxTorque(), 9.0f);
    EXPECT_EQ(OnlyJoint<b2FrictionJoint>(rubbed).GetLocalAnchorB(), b2Vec2(3.0f, 4.0f));
}

TEST(RubeJointBuilder, BuildsMotorJointsOfOldAndNewFiles)
{
    for (const char* offset : {R"("linearOffset":{"x":5,"y":6},)", ""})
    {
        const Built built(
            WithJoint(R"("type":"motor",)" + std::string(offset) +
                      R"("refAngle":0.5,"maxForce":8,"maxTorque":9,"correctionFactor":0.125)"));
        const auto& joint = OnlyJoint<b2MotorJoint>(built);
        EXPECT_EQ(joint.GetLinearOffset(), *offset ? b2Vec2(5.0f, 6.0f) : b2Vec2(1.0f, 2.0f));
        EXPECT_EQ(joint.GetAngularOffset(), 0.5f);
        EXPECT_EQ(joint.GetMaxForce(), 8.0f);
        EXPECT_EQ(joint.GetMaxTorque(), 9.0f);
        EXPECT_EQ(joint.GetCorrectionFactor(), 0.125f);
    }
}

TEST(RubeJointBuilder, BuildsPulleyAndMouseJointsWithEveryField)
{
    const Built hung(WithJoint(R"("type":"pulley","groundAnchorA":{"x":-4,"y":5},
        "groundAnchorB":{"x":4,"y":6},"lengthA":2,"lengthB":3,"ratio":1.5)"));
    const auto& pulley = OnlyJoint<b2PulleyJoint>(hung);
    EXPECT_EQ(pulley.GetGroundAnchorA(), b2Vec2(-4.0f, 5.0f));
    EXPECT_EQ(pulley.GetGroundAnchorB(), b2Vec2(4.0f, 6.0f));
    EXPECT_EQ(pulley.GetRatio(), 1.5f);
    EXPECT_EQ(pulley.GetAnchorA(), b2Vec2(1.0f, 2.0f));
    const Built held(WithJoint(R"("type":"mouse","target":{"x":7,"y":8},"maxForce":100,
        "frequency":4,"dampingRatio":0.5)"));
    const auto& mouse = OnlyJoint<b2MouseJoint>(held);
    EXPECT_EQ(mouse.GetTarget(), b2Vec2(7.0f, 8.0f));
    EXPECT_EQ(mouse.GetAnchorB(), b2Vec2(3.0f, 4.0f)) << "a point of the world";
    EXPECT_EQ(mouse.GetMaxForce(), 100.0f);
    EXPECT_EQ(mouse.GetFrequency(), 4.0f);
    EXPECT_EQ(mouse.GetDampingRatio(), 0.5f);
}

TEST(RubeJointBuilder, BuildsGearsWhereverTheyStandInTheFile)
{
    Built built(R"({"body":[{},{"type":2},{"type":2}],"joint":[
        {"type":"gear","bodyA":1,"bodyB":2,"joint1":1,"joint2":2,"ratio":-2},
        {"type":"revolute","bodyA":0,"bodyB":1},
        {"type":"prismatic","bodyA":0,"bodyB":2,"localAxisA":{"x":1,"y":0}}]})");
    EXPECT_THAT(built.leftOut, IsEmpty());
    auto& gear = dynamic_cast<b2GearJoint&>(*built.world.GetJointList());
    EXPECT_EQ(built.world.GetJointCount(), 3);
    EXPECT_EQ(gear.GetJoint1()->GetType(), e_revoluteJoint);
    EXPECT_EQ(gear.GetJoint2()->GetType(), e_prismaticJoint);
    EXPECT_EQ(gear.GetRatio(), -2.0f);
}

TEST(RubeJointBuilder, NamesJointsThatItCannotBuild)
{
    Built built(R"({"body":[{"name":"a"},{"name":"b","type":2}],"joint":[
        {"type":"magnet","name":"slack","bodyA":0,"bodyB":1},
        {"type":"revolute","name":"self","bodyA":1,"bodyB":1},
        {"type":"distance","name":"short","bodyA":0,"bodyB":1,"length":0},
        {"type":"revolute","name":"odd","bodyA":0,"bodyB":1,"enableLimit":true,"lowerLimit":1,
         "upperLimit":0},
        {"type":"prismatic","name":"lost","bodyA":0,"bodyB":1,"localAxisA":0}]})");
    EXPECT_THAT(built.Missing(),
                ElementsAre("joint 0 \"slack\" (magnet, between body 0 \"a\" and body 1 \"b\")",
                            "joint 1 \"self\" (revolute, between body 1 \"b\" and body 1 \"b\")",
                            "joint 2 \"short\" (distance, between body 0 \"a\" and body 1 \"b\")",
                            "limit of joint 3 \"odd\" (revolute, between body 0 \"a\" and body 1 "
                            "\"b\")",
                            "joint 4 \"lost\" (prismatic, between body 0 \"a\" and body 1 \"b\")"));
    ASSERT_EQ(built.world.GetJointCount(), 1);
    EXPECT_FALSE(static_cast<b2RevoluteJoint*>(built.world.GetJointList())->IsLimitEnabled());
}

TEST(RubeJointBuilder, OmitsGearOnBodyOfNoneOfItsJoints)
{
    const Built built(R"({"body":[{},{"type":2},{"type":2},{"name":"far","type":2}],"joint":[
        {"type":"revolute","bodyA":0,"bodyB":1},
        {"type":"revolute","bodyA":0,"bodyB":2},
        {"type":"gear","bodyA":1,"bodyB":3,"joint1":0,"joint2":1}]})");
    EXPECT_EQ(built.world.GetJointCount(), 2);
    EXPECT_THAT(built.Missing(), ElementsAre("joint 2 (gear, between body 1 and body 3 \"far\")"));
}

} // namespace
} // namespace boxreel
