// SPDX-License-Identifier: MIT
#include <rube/RubeBuilder.h>
#include <rube/RubeFile.h>
#include <rube/RubeText.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A world built from a text.
struct Built
{
    explicit Built(const std::string& text) : world(b2Vec2(0.0f, -10.0f))
    {
        const Result<RubeScene> scene = ParseRubeScene(text, "scene.json");
        if (scene)
        {
            BuildRubeScene(*scene, world, leftOut);
        }
        else
        {
            ADD_FAILURE() << scene.GetError().message;
        }
    }

    b2World world;
    std::vector<std::string> leftOut;
};

std::string OneFixture(const std::string& members, const std::string& bodyMembers = "\"type\":2")
{
    return R"({"body":[{"name":"box",)" + bodyMembers + R"(,"fixture":[{"name":"side",)" + members +
           "}]}]}";
}

std::string Polygon(int corners)
{
    std::string x;
    std::string y;
    for (int i = 0; i < corners; ++i)
    {
        const double angle = 6.283185307179586 * i / corners;
        x.append(i > 0 ? "," : "").append(std::to_string(std::cos(angle)));
        y.append(i > 0 ? "," : "").append(std::to_string(std::sin(angle)));
    }
    return R"("density":1,"polygon":{"vertices":{"x":[)" + x + R"(],"y":[)" + y + "]}}";
}

std::string Vertices(const std::string& kind, const std::string& x, const std::string& y)
{
    return "\"" + kind + R"(":{"vertices":{"x":[)" + x + R"(],"y":[)" + y + "]}}";
}

// ---- What is built

TEST(RubeBuilder, GivesFixturesTheirShapeAndSurface)
{
    Built built(OneFixture(R"("density":2,"friction":0.5,"restitution":0.25,"sensor":true,
        "filter-groupIndex":-3,"circle":{"radius":1.5,"center":{"x":1,"y":2}})"));
    EXPECT_THAT(built.leftOut, IsEmpty());
    ASSERT_EQ(built.world.GetBodyCount(), 1);
    const b2Fixture* fixture = built.world.GetBodyList()->GetFixtureList();
    ASSERT_NE(fixture, nullptr);
    ASSERT_EQ(fixture->GetType(), b2Shape::e_circle);
    EXPECT_EQ(static_cast<const b2CircleShape*>(fixture->GetShape())->m_radius, 1.5f);
    EXPECT_EQ(fixture->GetFriction(), 0.5f);
    EXPECT_EQ(fixture->GetRestitution(), 0.25f);
    EXPECT_TRUE(fixture->IsSensor());
    EXPECT_EQ(fixture->GetFilterData().groupIndex, -3);
    EXPECT_NEAR(built.world.GetBodyList()->GetMass(), 2.0f * b2_pi * 2.25f, 1e-3f);
}

TEST(RubeBuilder, GivesBodiesTheirState)
{
    Built built(R"({"gravity":{"x":0,"y":-5},"allowSleep":false,"body":[{"type":2,"awake":true,
        "position":{"x":3,"y":4},"angle":0.5,"linearVelocity":{"x":1,"y":2},"angularVelocity":-1,
        "linearDamping":0.1,"angularDamping":0.2,"gravityScale":2,"bullet":true,
        "fixedRotation":true},{"type":2}]})");
    EXPECT_EQ(built.world.GetGravity(), b2Vec2(0.0f, -5.0f));
    EXPECT_FALSE(built.world.GetAllowSleeping());
    ASSERT_EQ(built.world.GetBodyCount(), 2);
    const b2Body* second = built.world.GetBodyList();
    const b2Body* first = second->GetNext();
    EXPECT_EQ(first->GetPosition(), b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(first->GetAngle(), 0.5f);
    EXPECT_EQ(first->GetLinearVelocity(), b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(first->GetAngularVelocity(), -1.0f);
    EXPECT_EQ(first->GetLinearDamping(), 0.1f);
    EXPECT_EQ(first->GetAngularDamping(), 0.2f);
    EXPECT_EQ(first->GetGravityScale(), 2.0f);
    EXPECT_TRUE(first->IsBullet());
    EXPECT_TRUE(first->IsFixedRotation());
    EXPECT_TRUE(first->IsAwake());
}

TEST(RubeBuilder, LetsABodySleepThatDoesNotSayItIsAwake)
{
    Built built(R"({"body":[{"type":2}]})");
    EXPECT_FALSE(built.world.GetBodyList()->IsAwake());
}

TEST(RubeBuilder, TakesTheMassOfTheFixturesUnlessOneIsGiven)
{
    const std::string square =
        R"("density":3,)" + Vertices("polygon", "-0.5,0.5,0.5,-0.5", "-0.5,-0.5,0.5,0.5");
    Built own(OneFixture(square, R"("type":2,"massData-I":0.01)"));
    EXPECT_NEAR(own.world.GetBodyList()->GetMass(), 3.0f, 1e-5f);
    EXPECT_GT(own.world.GetBodyList()->GetInertia(), 0.1f);

    Built given(OneFixture(square, R"("type":2,"massData-mass":7,"massData-I":5,
        "massData-center":{"x":0.5,"y":0})"));
    EXPECT_EQ(given.world.GetBodyList()->GetMass(), 7.0f);
    EXPECT_NEAR(given.world.GetBodyList()->GetInertia(), 5.0f, 1e-4f);
    EXPECT_EQ(given.world.GetBodyList()->GetLocalCenter(), b2Vec2(0.5f, 0.0f));
}

TEST(RubeBuilder, LeavesOutAMassThatNoBodyCanHave)
{
    Built built(R"({"body":[{"name":"top","type":2,"massData-mass":7,"massData-I":1,
        "massData-center":{"x":1,"y":0}}]})");
    EXPECT_THAT(built.leftOut, ElementsAre(HasSubstr("the mass of body 0 \"top\" is left out")));
}

TEST(RubeBuilder, MakesAnEdgeOfAPolygonWithTwoVertices)
{
    Built built(OneFixture(Vertices("polygon", "0,2", "0,1")));
    EXPECT_THAT(built.leftOut, IsEmpty());
    const b2Fixture* fixture = built.world.GetBodyList()->GetFixtureList();
    ASSERT_EQ(fixture->GetType(), b2Shape::e_edge);
    EXPECT_EQ(static_cast<const b2EdgeShape*>(fixture->GetShape())->m_vertex2, b2Vec2(2.0f, 1.0f));
}

TEST(RubeBuilder, GivesEdgesTheirGhostVertices)
{
    Built built(OneFixture(R"("edge":{"vertex1":0,"vertex2":{"x":2,"y":0},"hasVertex3":true,
        "vertex3":{"x":3,"y":1}})"));
    const auto* edge =
        static_cast<const b2EdgeShape*>(built.world.GetBodyList()->GetFixtureList()->GetShape());
    EXPECT_FALSE(edge->m_hasVertex0);
    EXPECT_TRUE(edge->m_hasVertex3);
    EXPECT_EQ(edge->m_vertex3, b2Vec2(3.0f, 1.0f));
}

TEST(RubeBuilder, BuildsOpenChainsAndLoopsInBothSpellings)
{
    const auto edges = [](const std::string& kind, const std::string& x, const std::string& y) {
        Built built(OneFixture(Vertices(kind, x, y)));
        EXPECT_THAT(built.leftOut, IsEmpty());
        return built.world.GetBodyList()->GetFixtureList()->GetShape()->GetChildCount();
    };
    EXPECT_EQ(edges("chain", "0,1,2", "0,0,1"), 2);
    EXPECT_EQ(edges("loop", "0,1,1,0", "0,0,1,1"), 4);
    EXPECT_EQ(edges("chain", "0,1,1,0,0", "0,0,1,1,0"), 4) << "closed by repeating the first";
    EXPECT_EQ(edges("loop", "0,1,1,0,0", "0,0,1,1,0"), 4) << "old files may repeat it as well";
    EXPECT_EQ(edges("chain", "0,0.001,1,1,2", "0,0,0,0,1"), 2) << "repeated vertices add nothing";
}

TEST(RubeBuilder, BuildsRevoluteAndDistanceJoints)
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

TEST(RubeBuilder, BuildsPrismaticJointsWithEveryField)
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

TEST(RubeBuilder, BuildsWheelJointsWithEveryField)
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

TEST(RubeBuilder, BuildsWeldRopeAndFrictionJointsWithEveryField)
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

TEST(RubeBuilder, BuildsMotorJointsOfOldAndNewFiles)
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

TEST(RubeBuilder, BuildsPulleyAndMouseJointsWithEveryField)
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

TEST(RubeBuilder, BuildsGearsWhereverTheyStandInTheFile)
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

// ---- What is left out

TEST(RubeBuilder, NamesPolygonsThatHaveTooManyOrTooFewVertices)
{
    Built built(OneFixture(Polygon(b2_maxPolygonVertices + 1)));
    EXPECT_THAT(built.leftOut,
                ElementsAre("fixture 0 \"side\" of body 0 \"box\" is left out: a polygon has 3 to "
                            "8 vertices, this one has 9."));
    EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr);

    Built most(OneFixture(Polygon(b2_maxPolygonVertices)));
    EXPECT_THAT(most.leftOut, IsEmpty());
    EXPECT_NE(most.world.GetBodyList()->GetFixtureList(), nullptr);

    Built single(OneFixture(Vertices("polygon", "1", "1")));
    EXPECT_THAT(single.leftOut, ElementsAre(HasSubstr("this one has 1")));
    Built none(OneFixture(Vertices("polygon", "", "")));
    EXPECT_THAT(none.leftOut, ElementsAre(HasSubstr("this one has 0")));
}

TEST(RubeBuilder, NamesShapesWithoutExtent)
{
    for (const std::string& shape :
         {std::string(R"("circle":{"radius":0,"center":0})"), std::string(R"("circle":{})"),
          std::string(R"("edge":{"vertex1":0,"vertex2":{"x":0.001,"y":0}})"),
          Vertices("polygon", "0,1,2", "0,0,0"), Vertices("polygon", "1,1,1", "1,1,1"),
          Vertices("polygon", "0,0", "0,0"), Vertices("chain", "1,1", "2,2"),
          Vertices("chain", "", ""), Vertices("loop", "0,1", "0,0"), std::string(R"("density":1)")})
    {
        Built built(OneFixture(shape));
        EXPECT_THAT(built.leftOut, ElementsAre(AllOf(HasSubstr("fixture 0 \"side\""),
                                                     HasSubstr("body 0 \"box\" is left out"))))
            << shape;
        EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr) << shape;
    }
}

TEST(RubeBuilder, NamesJointsThatItCannotBuild)
{
    Built built(R"({"body":[{"name":"a"},{"name":"b","type":2}],"joint":[
        {"type":"magnet","name":"slack","bodyA":0,"bodyB":1},
        {"type":"revolute","name":"self","bodyA":1,"bodyB":1},
        {"type":"distance","name":"short","bodyA":0,"bodyB":1,"length":0},
        {"type":"revolute","name":"odd","bodyA":0,"bodyB":1,"enableLimit":true,"lowerLimit":1,
         "upperLimit":0},
        {"type":"prismatic","name":"lost","bodyA":0,"bodyB":1,"localAxisA":0}]})");
    EXPECT_THAT(built.leftOut,
                ElementsAre("joint 0 \"slack\" (magnet, between body 0 \"a\" and body 1 \"b\") "
                            "is left out: joints of this kind cannot be built.",
                            AllOf(HasSubstr("joint 1 \"self\""), HasSubstr("with itself")),
                            AllOf(HasSubstr("joint 2 \"short\""), HasSubstr("length is zero")),
                            AllOf(HasSubstr("the limit of joint 3 \"odd\""),
                                  HasSubstr("lower end is above")),
                            AllOf(HasSubstr("joint 4 \"lost\""), HasSubstr("no direction"))));
    ASSERT_EQ(built.world.GetJointCount(), 1);
    EXPECT_FALSE(static_cast<b2RevoluteJoint*>(built.world.GetJointList())->IsLimitEnabled());
}

TEST(RubeBuilder, NamesWhatKeepsAJointOfTheOtherKindsFromBeingBuilt)
{
    const auto why = [](const std::string& members) {
        Built built(R"({"body":[{},{"type":2}],"joint":[{"bodyA":0,"bodyB":1,)" + members + "}]}");
        EXPECT_EQ(built.world.GetJointCount(), 0);
        return built.leftOut.size() == 1 ? built.leftOut.front() : "";
    };
    EXPECT_THAT(why(R"("type":"rope","maxLength":0)"), HasSubstr("length is zero"));
    EXPECT_THAT(why(R"("type":"wheel","localAxisA":0)"), HasSubstr("no direction"));
    EXPECT_THAT(why(R"("type":"pulley","ratio":0)"), HasSubstr("ratio above zero"));
    EXPECT_THAT(why(R"("type":"mouse","frequency":0)"), HasSubstr("frequency above zero"));
    for (const char* joints : {R"("joint1":0,"joint2":0)", R"("joint1":7,"joint2":0)"})
    {
        EXPECT_THAT(why(std::string(R"("type":"gear",)") + joints),
                    HasSubstr("a gear needs two joints"));
    }
}

TEST(RubeBuilder, KeepsItsListOfFindingsShort)
{
    std::string text =
        R"({"body":[{"name":"\u001b[31m)" + std::string(500, 'n') + R"("},{}],"joint":[)";
    for (int i = 0; i < 1200; ++i)
    {
        text += std::string(i > 0 ? "," : "") + R"({"type":"x","bodyA":0,"bodyB":1})";
    }
    Built built(text + "]}");
    ASSERT_EQ(built.leftOut.size(), 1001u);
    EXPECT_EQ(built.leftOut.back(), "And so are 200 more parts.");
    EXPECT_LT(built.leftOut.front().size(), 250u);
    EXPECT_EQ(built.leftOut.front().find('\x1b'), std::string::npos);
}

// ---- Files

/// A folder for one test, gone afterwards.
class RubeFile : public testing::Test
{
protected:
    RubeFile()
        : m_folder(std::filesystem::temp_directory_path() /
                   ("boxreel-rube-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(m_folder);
    }
    ~RubeFile() override { std::filesystem::remove_all(m_folder); }

    std::filesystem::path Write(const std::string& text)
    {
        const std::filesystem::path file = m_folder / "scene.json";
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

    std::string Complaint(const std::filesystem::path& file)
    {
        std::vector<std::string> leftOut;
        const auto scene = LoadRubeScene(file, leftOut);
        if (scene)
        {
            ADD_FAILURE() << file << " should not be accepted";
            return "";
        }
        EXPECT_EQ(scene.GetError().kind, ErrorKind::Unusable);
        EXPECT_THAT(scene.GetError().message, HasSubstr(file.string()));
        return scene.GetError().message;
    }

    std::filesystem::path m_folder;
};

TEST_F(RubeFile, SaysHowItsSceneWantsToBeStepped)
{
    std::vector<std::string> leftOut;
    const auto scene = LoadRubeScene(
        Write(R"({"stepsPerSecond":50,"velocityIterations":12,"positionIterations":5,"body":[]})"),
        leftOut);
    ASSERT_TRUE(scene);
    EXPECT_EQ((*scene)->PreferredSteps().timeStep, 0.02f);
    EXPECT_EQ((*scene)->PreferredSteps().velocityIterations, 12);
    EXPECT_EQ((*scene)->PreferredSteps().positionIterations, 5);
}

TEST_F(RubeFile, ThatCannotBeReadIsNamed)
{
    EXPECT_THAT(Complaint(m_folder / "absent.json"), HasSubstr("does not exist"));
    EXPECT_THAT(Complaint(m_folder), HasSubstr("is no regular file"));
    const std::filesystem::path pipe = m_folder / "pipe.json";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(Complaint(pipe), HasSubstr("is no regular file"));
    EXPECT_THAT(Complaint(Write("")), HasSubstr("ends in the middle"));
}

TEST_F(RubeFile, OfAGigabyteIsRefusedUnread)
{
    const std::filesystem::path file = Write("{");
    std::filesystem::resize_file(file, 1u << 30); // sparse, takes no room on the disk
    EXPECT_THAT(Complaint(file), HasSubstr("is larger than 64 MB"));
}

TEST_F(RubeFile, WithAnyByteChangedNeverBreaksTheWorldItMakes)
{
    const std::string whole =
        R"({"gravity":{"x":0,"y":-10},"body":[{"type":2,"awake":true,"massData-mass":2,)"
        R"("massData-I":3,"fixture":[{"density":1,"polygon":{"vertices":{"x":[-1,1,1,-1],)"
        R"("y":[-1,-1,1,1]}}},{"circle":{"radius":1,"center":0}}]},{"position":{"x":1,"y":3},)"
        R"("fixture":[{"chain":{"vertices":{"x":[-5,0,5],"y":[-3,-4,-3]}}}]}],"joint":[)"
        R"({"type":"distance","bodyA":0,"bodyB":1,"anchorA":0,"anchorB":0,"length":2.5},)"
        R"({"type":"revolute","bodyA":1,"bodyB":0,"lowerLimit":0,"upperLimit":1},)"
        R"({"type":"prismatic","bodyA":1,"bodyB":0,"localAxisA":{"x":0,"y":1}}]})";
    std::size_t built = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
    {
        for (const char byte : {'0', '9', '-', '.', 'e', ' '})
        {
            std::string changed = whole;
            changed[at] = byte;
            if (const auto scene = ParseRubeScene(changed, "scene.json"))
            {
                std::vector<std::string> leftOut;
                b2World world(b2Vec2(0.0f, 0.0f));
                BuildRubeScene(*scene, world, leftOut);
                world.Step(1.0f / scene->stepsPerSecond, 2, 2);
                ++built;
            }
        }
    }
    EXPECT_GT(built, 300u) << "many changes only change a number or a name";
}

// The scene file that came from elsewhere, with the counts that its editor shows.
TEST(RubeExample, IsReadBuiltAndStepped)
{
    const std::filesystem::path file = BOXREEL_RUBE_EXAMPLE;
    if (!std::filesystem::exists(file))
    {
        GTEST_SKIP() << "the example scene is not beside this checkout: " << file;
    }
    std::vector<std::string> leftOut;
    const auto loaded = LoadRubeScene(file, leftOut);
    ASSERT_TRUE(loaded) << loaded.GetError().message;
    Scene& scene = **loaded;
    EXPECT_EQ(scene.World().GetBodyCount(), 9);
    EXPECT_EQ(scene.World().GetJointCount(), 8);
    int32 circles = 0;
    int32 polygons = 0;
    for (b2Body* body = scene.World().GetBodyList(); body != nullptr; body = body->GetNext())
    {
        for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
        {
            circles += fixture->GetType() == b2Shape::e_circle ? 1 : 0;
            polygons += fixture->GetType() == b2Shape::e_polygon ? 1 : 0;
        }
    }
    EXPECT_EQ(circles, 4);
    EXPECT_EQ(polygons, 8);
    EXPECT_THAT(leftOut, IsEmpty());

    // The wheels turn by themselves, half and a quarter of a turn a second.
    for (int32 i = 0; i < 60; ++i)
    {
        scene.Step(scene.PreferredSteps());
    }
    EXPECT_NEAR(scene.World().GetBodyList()->GetAngle(), b2_pi, 1e-3f);
    for (b2Joint* joint = scene.World().GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        if (joint->GetType() == e_distanceJoint)
        {
            const float32 length = b2Distance(joint->GetAnchorA(), joint->GetAnchorB());
            EXPECT_NEAR(length, static_cast<b2DistanceJoint*>(joint)->GetLength(), 0.05f);
        }
    }
}

} // namespace
} // namespace boxreel
