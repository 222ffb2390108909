// SPDX-License-Identifier: MIT
#include "RubeBuilt.h"

#include "../../base/Errors.h"
#include "../../base/TemporaryFolder.h"

#include <rube/RubeFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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

// ---- Built parts

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

TEST(RubeBuilder, MakesBodiesAsleepUnlessFileSaysAwake)
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

TEST(RubeBuilder, OmitsImpossibleMass)
{
    Built built(R"({"body":[{"name":"top","type":2,"massData-mass":7,"massData-I":1,
        "massData-center":{"x":1,"y":0}}]})");
    EXPECT_THAT(built.Missing(), ElementsAre("mass of body 0 \"top\""));
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

// ---- Omitted parts

TEST(RubeBuilder, NamesPolygonsThatHaveTooManyOrTooFewVertices)
{
    for (const auto& [fixture, count] : {std::pair(Polygon(b2_maxPolygonVertices + 1), "has 9"),
                                         {Vertices("polygon", "1", "1"), "has 1"},
                                         {Vertices("polygon", "", ""), "has 0"}})
    {
        Built built(OneFixture(fixture));
        ASSERT_THAT(built.Missing(), ElementsAre("fixture 0 \"side\" of body 0 \"box\""));
        EXPECT_THAT(built.leftOut[0].reason, HasSubstr(count));
        EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr);
    }
    Built maximum(OneFixture(Polygon(b2_maxPolygonVertices)));
    EXPECT_THAT(maximum.leftOut, IsEmpty());
    EXPECT_NE(maximum.world.GetBodyList()->GetFixtureList(), nullptr);
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
        EXPECT_THAT(built.Missing(), ElementsAre("fixture 0 \"side\" of body 0 \"box\"")) << shape;
        EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr) << shape;
    }
}

TEST(RubeBuilder, LimitsNumberAndLengthOfFindings)
{
    std::string text =
        R"({"body":[{"name":"\u001b[31m)" + std::string(500, 'n') + R"("},{}],"joint":[)";
    for (int i = 0; i < 1200; ++i)
    {
        text += std::string(i > 0 ? "," : "") + R"({"type":"x","bodyA":0,"bodyB":1})";
    }
    Built built(text + "]}");
    ASSERT_EQ(built.leftOut.size(), 1001u);
    EXPECT_EQ(built.leftOut.back().part, "200 more parts");
    EXPECT_LT(built.leftOut.front().Text().size(), 250u);
    EXPECT_EQ(built.leftOut.front().Text().find('\x1b'), std::string::npos);
}

// ---- Files

class RubeFile : public testing::Test
{
protected:
    std::filesystem::path Write(const std::string& text)
    {
        const std::filesystem::path file = m_folder / "scene.json";
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

    static Result<std::unique_ptr<Scene>> Load(const std::filesystem::path& file)
    {
        RubeNotes leftOut;
        return LoadRubeScene(file, leftOut);
    }

    TemporaryFolder m_folder;
};

TEST_F(RubeFile, GivesStepSettingsToItsScene)
{
    RubeNotes leftOut;
    const auto scene = LoadRubeScene(
        Write(R"({"stepsPerSecond":50,"velocityIterations":12,"positionIterations":5,"body":[]})"),
        leftOut);
    ASSERT_TRUE(scene);
    EXPECT_EQ((*scene)->PreferredSteps().timeStep, 0.02f);
    EXPECT_EQ((*scene)->PreferredSteps().velocityIterations, 12);
    EXPECT_EQ((*scene)->PreferredSteps().positionIterations, 5);
}

TEST_F(RubeFile, FramesItsImages)
{
    RubeNotes leftOut;
    const auto scene =
        LoadRubeScene(Write(R"({"body":[{"type":2,"position":{"x":10,"y":0}}],"image":[
                 {"corners":{"x":[-40,40,40,-40],"y":[-5,-5,25,25]}},{"file":"no corners"},
                 {"body":0,"corners":{"x":[-2,2,2,-2],"y":[-1,-1,1,1]}}]})"),
                      leftOut);
    ASSERT_TRUE(scene);
    const std::vector<b2AABB> boxes = (*scene)->Framed();
    ASSERT_EQ(boxes.size(), 2u);
    EXPECT_EQ(boxes[0].lowerBound, b2Vec2(-40.0f, -5.0f));
    EXPECT_EQ(boxes[0].upperBound, b2Vec2(40.0f, 25.0f));
    EXPECT_EQ(boxes[1].lowerBound, b2Vec2(8.0f, -1.0f)) << "where its body is";
    EXPECT_EQ(boxes[1].upperBound, b2Vec2(12.0f, 1.0f));
}

TEST_F(RubeFile, IsNamedWhenUnreadable)
{
    const std::filesystem::path absent = m_folder / "absent.json";
    EXPECT_THAT(Load(absent), Refuses(absent.string()));
    EXPECT_THAT(Load(m_folder.Path()), Refuses(m_folder.Path().string()));
    const std::filesystem::path pipe = m_folder / "pipe.json";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(Load(pipe), Refuses(pipe.string()));
    const std::filesystem::path empty = Write("");
    EXPECT_THAT(Load(empty), Refuses(empty.string()));
}

TEST_F(RubeFile, IsRefusedUnreadWhenTooLarge)
{
    const std::filesystem::path file = Write("{");
    std::filesystem::resize_file(file, 1u << 30); // sparse, takes no room on the disk
    EXPECT_THAT(Load(file), RefusesWith(file.string(), "64 MB"));
}

TEST_F(RubeFile, BuildsWorldThatStepsWithAnyByteChanged)
{
    const std::string whole =
        R"({"gravity":{"x":0,"y":-10},"body":[{"type":2,"awake":true,"massData-mass":2,)"
        R"("massData-I":3,"fixture":[{"density":1,"polygon":{"vertices":{"x":[-1,1,1,-1],)"
        R"("y":[-1,-1,1,1]}}},{"circle":{"radius":1,"center":0}}]},{"position":{"x":1,"y":3},)"
        R"("fixture":[{"chain":{"vertices":{"x":[-5,0,5],"y":[-3,-4,-3]}}}]}],"joint":[)"
        R"({"type":"distance","bodyA":0,"bodyB":1,"anchorA":0,"anchorB":0,"length":2.5},)"
        R"({"type":"revolute","bodyA":1,"bodyB":0,"lowerLimit":0,"upperLimit":1},)"
        R"({"type":"prismatic","bodyA":1,"bodyB":0,"localAxisA":{"x":0,"y":1}},)"
        R"({"type":"wheel","bodyA":1,"bodyB":0,"localAxisA":{"x":0,"y":1},"springFrequency":4},)"
        R"({"type":"rope","bodyA":1,"bodyB":0,"maxLength":4},{"type":"weld","bodyA":1,"bodyB":0},)"
        R"({"type":"friction","bodyA":1,"bodyB":0,"maxForce":4,"maxTorque":2},)"
        R"({"type":"motor","bodyA":1,"bodyB":0,"maxForce":4,"maxTorque":2},)"
        R"({"type":"pulley","bodyA":1,"bodyB":0,"groundAnchorA":{"x":1,"y":5},"lengthA":2},)"
        R"({"type":"mouse","bodyA":1,"bodyB":0,"target":{"x":2,"y":5},"frequency":3},)"
        R"({"type":"gear","bodyA":1,"bodyB":0,"joint1":1,"joint2":2,"ratio":2}]})";
    std::size_t built = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
    {
        for (const char byte : {'0', '9', '-', '.', 'e', ' '})
        {
            std::string changed = whole;
            changed[at] = byte;
            if (const auto scene = ParseRubeScene(changed, "scene.json"))
            {
                RubeNotes leftOut;
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
    RubeNotes leftOut;
    const auto loaded = LoadRubeScene(file, leftOut);
    ASSERT_TRUE(loaded) << loaded.GetError().Text();
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
