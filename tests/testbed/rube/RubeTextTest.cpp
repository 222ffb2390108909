// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <rube/RubeText.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

// One test a rule of the format, and one a way to be malformed.
namespace boxreel
{
namespace
{

Result<RubeScene> Parse(const std::string& text)
{
    return ParseRubeScene(text, "scene.json");
}

RubeScene Parsed(const std::string& text)
{
    const Result<RubeScene> scene = Parse(text);
    if (!scene)
    {
        ADD_FAILURE() << scene.GetError().Text();
        return {};
    }
    return *scene;
}

RubeBody ParsedBody(const std::string& members)
{
    RubeScene scene = Parsed(R"({"body":[{)" + members + "}]}");
    return scene.bodies.size() == 1 ? scene.bodies[0] : RubeBody{};
}

RubeFixture ParsedFixture(const std::string& members)
{
    RubeBody body = ParsedBody(R"("fixture":[{)" + members + "}]");
    return body.fixtures.size() == 1 ? body.fixtures[0] : RubeFixture{};
}

RubeJoint ParsedJoint(const std::string& members)
{
    RubeScene scene = Parsed(R"({"body":[{},{},{}],"joint":[{)" + members + "}]}");
    return scene.joints.size() == 1 ? scene.joints[0] : RubeJoint{};
}

/// Refused because of this part of the text; empty: because of all of it.
auto RefusesPart(const std::string& part)
{
    return Refuses(part.empty() ? "scene.json" : "scene.json: " + part);
}

/// Refused where the text is not JSON.
auto RefusesPlace(const std::string& place)
{
    return Refuses("scene.json:" + place);
}

// ---- Numbers

TEST(RubeNumbers, AreLiteralsOrFractionsOrTheHexDigitsOfAFloat)
{
    EXPECT_EQ(ParsedBody(R"("angle":1)").angle, 1.0f);
    EXPECT_EQ(ParsedBody(R"("angle":0)").angle, 0.0f);
    EXPECT_EQ(ParsedBody(R"("angle":-0.25)").angle, -0.25f);
    EXPECT_EQ(ParsedBody(R"("angle":2.5e1)").angle, 25.0f);
    EXPECT_EQ(ParsedBody(R"("angle":"3F000000")").angle, 0.5f);
    EXPECT_EQ(ParsedBody(R"("angle":"C0490FDB")").angle, -3.14159274f);
}

TEST(RubeNumbers, KeepEveryBitOfAHexFloat)
{
    EXPECT_EQ(ParsedBody(R"("angle":"3DCCCCCE")").angle, 0x1.99999Cp-4f);
}

TEST(RubeNumbers, AreRefusedWhenTheStringIsNoFloat)
{
    for (const char* text : {"\"\"", "\"0.5\"", "\"3F00000\"", "\"3F0000000\"", "\"3F00000G\"",
                             "\"-3F00000\"", "\" 3F00000\""})
    {
        EXPECT_THAT(Parse(R"({"body":[{"angle":)" + std::string(text) + "}]}"),
                    RefusesPart("body[0].angle"));
    }
}

TEST(RubeNumbers, AreRefusedWhenNotFiniteOrOutOfRange)
{
    EXPECT_THAT(Parse(R"({"body":[{"angle":"7FC00000"}]})"), RefusesPart("body[0].angle"));
    EXPECT_THAT(Parse(R"({"body":[{"angle":"7F800000"}]})"), RefusesPart("body[0].angle"));
    EXPECT_THAT(Parse(R"({"body":[{"angle":1e300}]})"), RefusesPart("body[0].angle"));
    EXPECT_THAT(Parse(R"({"body":[{"angle":1e999}]})"), RefusesPlace("1:23"));
    EXPECT_THAT(Parse(R"({"body":[{"angle":NaN}]})"), RefusesPlace("1:19"));
    EXPECT_THAT(Parse(R"({"body":[{"position":{"x":0,"y":-2e6}}]})"),
                RefusesPart("body[0].position.y"));
    EXPECT_THAT(Parse(R"({"body":[{"linearDamping":-1}]})"), RefusesPart("body[0].linearDamping"));
    EXPECT_THAT(Parse(R"({"body":[],"stepsPerSecond":0})"), RefusesPart("stepsPerSecond"));
    EXPECT_THAT(Parse(R"({"body":[],"velocityIterations":1000000000})"),
                RefusesPart("velocityIterations"));
}

TEST(RubeNumbers, MakeVectorsOfTwoOrOfTheLiteralZero)
{
    EXPECT_EQ(ParsedBody(R"("position":{"x":2,"y":"3F000000"})").position, b2Vec2(2.0f, 0.5f));
    EXPECT_EQ(ParsedBody(R"("position":0)").position, b2Vec2(0.0f, 0.0f));
    EXPECT_THAT(Parse(R"({"body":[{"position":1}]})"), RefusesPart("body[0].position"));
    EXPECT_THAT(Parse(R"({"body":[{"position":{"x":1}}]})"), RefusesPart("body[0].position.y"));
}

// ---- World

TEST(RubeWorldSettings, HaveTheFormatsDefaults)
{
    const RubeScene scene = Parsed(R"({"body":[]})");
    EXPECT_EQ(scene.gravity, b2Vec2(0.0f, 0.0f));
    EXPECT_TRUE(scene.allowSleep);
    EXPECT_TRUE(scene.autoClearForces);
    EXPECT_TRUE(scene.warmStarting);
    EXPECT_TRUE(scene.continuousPhysics);
    EXPECT_FALSE(scene.subStepping);
    EXPECT_EQ(scene.stepsPerSecond, 60.0f);
    EXPECT_EQ(scene.velocityIterations, 8);
    EXPECT_EQ(scene.positionIterations, 3);
}

TEST(RubeWorldSettings, AreRead)
{
    const RubeScene scene = Parsed(R"({"gravity":{"x":1,"y":-9.5},"allowSleep":false,
        "autoClearForces":0,"warmStarting":false,"continuousPhysics":false,"subStepping":true,
        "stepsPerSecond":120.0,"velocityIterations":20,"positionIterations":10,"body":[]})");
    EXPECT_EQ(scene.gravity, b2Vec2(1.0f, -9.5f));
    EXPECT_FALSE(scene.allowSleep);
    EXPECT_FALSE(scene.autoClearForces);
    EXPECT_FALSE(scene.warmStarting);
    EXPECT_FALSE(scene.continuousPhysics);
    EXPECT_TRUE(scene.subStepping);
    EXPECT_EQ(scene.stepsPerSecond, 120.0f);
    EXPECT_EQ(scene.velocityIterations, 20);
    EXPECT_EQ(scene.positionIterations, 10);
}

// ---- Bodies

TEST(RubeBodies, HaveTheFormatsDefaults)
{
    const RubeBody body = ParsedBody("");
    EXPECT_EQ(body.type, b2_staticBody);
    EXPECT_FALSE(body.awake) << "a missing awake means asleep";
    EXPECT_TRUE(body.active);
    EXPECT_TRUE(body.allowSleep);
    EXPECT_FALSE(body.bullet);
    EXPECT_FALSE(body.fixedRotation);
    EXPECT_EQ(body.gravityScale, 1.0f);
    EXPECT_FALSE(body.massData.has_value());
}

TEST(RubeBodies, AreRead)
{
    const RubeBody body = ParsedBody(R"("name":"wheel","type":2,"position":{"x":1,"y":2},
        "angle":0.5,"linearVelocity":{"x":3,"y":4},"angularVelocity":5,"linearDamping":0.1,
        "angularDamping":0.2,"gravityScale":-1,"bullet":true,"allowSleep":false,"awake":true,
        "active":false,"fixedRotation":true)");
    EXPECT_EQ(body.name, "wheel");
    EXPECT_EQ(body.type, b2_dynamicBody);
    EXPECT_EQ(body.position, b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(body.angle, 0.5f);
    EXPECT_EQ(body.linearVelocity, b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(body.angularVelocity, 5.0f);
    EXPECT_EQ(body.linearDamping, 0.1f);
    EXPECT_EQ(body.angularDamping, 0.2f);
    EXPECT_EQ(body.gravityScale, -1.0f);
    EXPECT_TRUE(body.bullet);
    EXPECT_FALSE(body.allowSleep);
    EXPECT_TRUE(body.awake);
    EXPECT_FALSE(body.active);
    EXPECT_TRUE(body.fixedRotation);
}

TEST(RubeBodies, TakeMassDataOnlyWhenAMassIsGiven)
{
    EXPECT_FALSE(ParsedBody(R"("massData-I":3,"massData-center":{"x":1,"y":0})").massData);
    EXPECT_FALSE(ParsedBody(R"("massData-mass":0,"massData-I":3)").massData);
    const auto mass = ParsedBody(R"("massData-mass":2,"massData-center":{"x":1,"y":0})").massData;
    ASSERT_TRUE(mass.has_value());
    EXPECT_EQ(mass->mass, 2.0f);
    EXPECT_EQ(mass->center, b2Vec2(1.0f, 0.0f));
    EXPECT_EQ(mass->I, 0.0f);
}

TEST(RubeBodies, AreRefusedWhenATypeIsUnknownOrOfTheWrongKind)
{
    EXPECT_THAT(Parse(R"({"body":[{},{"type":3}]})"), RefusesPart("body[1].type"));
    EXPECT_THAT(Parse(R"({"body":[{"type":"2"}]})"), RefusesPart("body[0].type"));
    EXPECT_THAT(Parse(R"({"body":[{"type":1.5}]})"), RefusesPart("body[0].type"));
    EXPECT_THAT(Parse(R"({"body":[{"name":5}]})"), RefusesPart("body[0].name"));
    EXPECT_THAT(Parse(R"({"body":[{"awake":"yes"}]})"), RefusesPart("body[0].awake"));
    EXPECT_THAT(Parse(R"({"body":[7]})"), RefusesPart("body[0]"));
    EXPECT_THAT(Parse(R"({"body":{"0":{}}})"), RefusesPart("body"));
}

// ---- Fixtures

TEST(RubeFixtures, HaveTheFormatsDefaults)
{
    const RubeFixture fixture = ParsedFixture("");
    EXPECT_EQ(fixture.friction, 0.0f) << "not the engine's 0.2";
    EXPECT_EQ(fixture.restitution, 0.0f);
    EXPECT_EQ(fixture.density, 0.0f);
    EXPECT_FALSE(fixture.isSensor);
    EXPECT_EQ(fixture.filter.categoryBits, 1);
    EXPECT_EQ(fixture.filter.maskBits, 65535);
    EXPECT_EQ(fixture.filter.groupIndex, 0);
}

TEST(RubeFixtures, AreRead)
{
    const RubeFixture fixture =
        ParsedFixture(R"("name":"rim","friction":0.5,"restitution":0.25,"density":2,"sensor":true,
        "filter-categoryBits":4,"filter-maskBits":-1,"filter-groupIndex":-3,
        "circle":{"radius":1.5,"center":{"x":1,"y":2}})");
    EXPECT_EQ(fixture.name, "rim");
    EXPECT_EQ(fixture.friction, 0.5f);
    EXPECT_EQ(fixture.restitution, 0.25f);
    EXPECT_EQ(fixture.density, 2.0f);
    EXPECT_TRUE(fixture.isSensor);
    EXPECT_EQ(fixture.filter.categoryBits, 4);
    EXPECT_EQ(fixture.filter.maskBits, 65535);
    EXPECT_EQ(fixture.filter.groupIndex, -3);
    const auto* circle = std::get_if<RubeCircle>(&fixture.geometry);
    ASSERT_NE(circle, nullptr);
    EXPECT_EQ(circle->radius, 1.5f);
    EXPECT_EQ(circle->center, b2Vec2(1.0f, 2.0f));
}

TEST(RubeFixtures, ReadEdgesWithTheirGhostVertices)
{
    const RubeFixture fixture =
        ParsedFixture(R"("edge":{"vertex1":0,"vertex2":{"x":2,"y":0},"hasVertex0":true,
        "vertex0":{"x":-1,"y":1},"hasVertex3":false,"vertex3":{"x":3,"y":1}})");
    const auto* edge = std::get_if<RubeEdge>(&fixture.geometry);
    ASSERT_NE(edge, nullptr);
    EXPECT_EQ(edge->vertex2, b2Vec2(2.0f, 0.0f));
    ASSERT_TRUE(edge->vertex0.has_value());
    EXPECT_EQ(*edge->vertex0, b2Vec2(-1.0f, 1.0f));
    EXPECT_FALSE(edge->vertex3.has_value()) << "given, but not said to count";
}

TEST(RubeFixtures, ReadChainsLoopsAndPolygons)
{
    const std::string vertices = R"({"vertices":{"x":[0,1,"40000000"],"y":[0,0.5,0]}})";
    const auto chainFixture = ParsedFixture(R"("chain":)" + vertices);
    const auto* chain = std::get_if<RubeChain>(&chainFixture.geometry);
    ASSERT_NE(chain, nullptr);
    EXPECT_FALSE(chain->isLoop);
    ASSERT_EQ(chain->vertices.size(), 3u);
    EXPECT_EQ(chain->vertices[2], b2Vec2(2.0f, 0.0f));

    const auto loopFixture = ParsedFixture(R"("loop":)" + vertices);
    const auto* loop = std::get_if<RubeChain>(&loopFixture.geometry);
    ASSERT_NE(loop, nullptr);
    EXPECT_TRUE(loop->isLoop);

    const auto polygonFixture = ParsedFixture(R"("polygon":)" + vertices);
    const auto* polygon = std::get_if<RubePolygon>(&polygonFixture.geometry);
    ASSERT_NE(polygon, nullptr);
    EXPECT_EQ(polygon->vertices.size(), 3u);
}

TEST(RubeFixtures, AreRefusedWhenTheirVerticesDoNotPairUp)
{
    EXPECT_THAT(Parse(R"({"body":[{"fixture":[{"polygon":{"vertices":{"x":[0,1],"y":[0]}}}]}]})"),
                RefusesPart("body[0].fixture[0].polygon.vertices"));
    EXPECT_THAT(Parse(R"({"body":[{"fixture":[{"chain":{}}]}]})"),
                RefusesPart("body[0].fixture[0].chain.vertices"));
    EXPECT_THAT(Parse(R"({"body":[{"fixture":[{"loop":{"vertices":{"x":[0,true],"y":[0,0]}}}]}]})"),
                RefusesPart("body[0].fixture[0].loop.vertices.x[1]"));
}

// ---- Joints

TEST(RubeJoints, ReadRevoluteJoints)
{
    const RubeJoint joint = ParsedJoint(R"("type":"revolute","name":"hinge","bodyA":1,"bodyB":2,
        "anchorA":0,"anchorB":{"x":1,"y":-1},"collideConnected":true,"refAngle":0.5,
        "enableLimit":true,"lowerLimit":-1,"upperLimit":1,"enableMotor":true,"motorSpeed":3,
        "maxMotorTorque":100,"jointSpeed":"7FC00000")");
    EXPECT_EQ(joint.type, "revolute");
    EXPECT_EQ(joint.name, "hinge");
    EXPECT_EQ(joint.bodyA, 1u);
    EXPECT_EQ(joint.bodyB, 2u);
    EXPECT_TRUE(joint.collideConnected);
    EXPECT_EQ(joint.anchorB, b2Vec2(1.0f, -1.0f));
    const auto* revolute = std::get_if<RubeRevolute>(&joint.details);
    ASSERT_NE(revolute, nullptr);
    EXPECT_EQ(revolute->referenceAngle, 0.5f);
    EXPECT_TRUE(revolute->enableLimit);
    EXPECT_EQ(revolute->lowerAngle, -1.0f);
    EXPECT_EQ(revolute->upperAngle, 1.0f);
    EXPECT_TRUE(revolute->enableMotor);
    EXPECT_EQ(revolute->motorSpeed, 3.0f);
    EXPECT_EQ(revolute->maxMotorTorque, 100.0f);
}

TEST(RubeJoints, ReadDistanceJoints)
{
    const RubeJoint joint = ParsedJoint(
        R"("type":"distance","bodyA":0,"bodyB":1,"length":2.5,"frequency":4,"dampingRatio":0.5)");
    const auto* distance = std::get_if<RubeDistance>(&joint.details);
    ASSERT_NE(distance, nullptr);
    EXPECT_EQ(distance->length, 2.5f);
    EXPECT_EQ(distance->frequencyHz, 4.0f);
    EXPECT_EQ(distance->dampingRatio, 0.5f);
}

TEST(RubeJoints, KeepTheNamesOfOtherKinds)
{
    const RubeJoint joint = ParsedJoint(R"("type":"magnet","bodyA":0,"bodyB":1)");
    EXPECT_EQ(joint.type, "magnet");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(joint.details));
}

TEST(RubeJoints, AreRefusedWhenTheyPointAtNoBody)
{
    const std::string before = R"({"body":[{},{}],"joint":[{"type":"revolute","bodyA":0,)";
    EXPECT_THAT(Parse(before + R"("bodyB":2}]})"), RefusesPart("joint[0].bodyB"));
    EXPECT_THAT(Parse(before + R"("bodyB":-1}]})"), RefusesPart("joint[0].bodyB"));
    EXPECT_THAT(Parse(before + R"("bodyB":1e18}]})"), RefusesPart("joint[0].bodyB"));
    EXPECT_THAT(Parse(before + R"("name":""}]})"), RefusesPart("joint[0].bodyB"));
    EXPECT_THAT(Parse(R"({"body":[],"joint":[{"type":"weld","bodyA":0,"bodyB":0}]})"),
                RefusesPart("joint[0].bodyA"));
    EXPECT_THAT(Parse(R"({"body":[{},{}],"joint":[{"bodyA":0,"bodyB":1}]})"),
                RefusesPart("joint[0].type"));
}

// ---- Foreign and hostile text

constexpr const char* kWholeScene = R"({"gravity":{"x":0,"y":-10},"body":[{"name":"a","type":2,
"position":0,"awake":true,"massData-mass":2,"massData-I":"40000000","fixture":[{"density":1,
"polygon":{"vertices":{"x":[-1,1,1,-1],"y":[-1,-1,1,1]}}},{"circle":{"radius":1,"center":0}}]},
{"fixture":[{"chain":{"vertices":{"x":[-5,5],"y":[-3,-3]}}}]}],
"joint":[{"type":"distance","bodyA":0,"bodyB":1,"anchorA":0,"anchorB":0,"length":2.5}]})";

TEST(RubeText, IsRefusedWithPlaceWhenInvalid)
{
    EXPECT_THAT(Parse(""), RefusesPart(""));
    EXPECT_THAT(Parse("\n"), RefusesPart(""));
    EXPECT_THAT(Parse("[]"), RefusesPart(""));
    EXPECT_THAT(Parse("{}"), RefusesPart("body"));
    EXPECT_THAT(Parse("<html>"), RefusesPlace("1:1"));
    EXPECT_THAT(Parse("{\"body\":\n[]\n?}"), RefusesPlace("3:1"));
    EXPECT_THAT(Parse("{\"body\":[]} {}"), RefusesPlace("1:13"));
    EXPECT_THAT(Parse("{\"body\":[]}}"), RefusesPlace("1:12"));
    EXPECT_THAT(Parse(std::string("{\"body\":[]}\0", 12)), RefusesPlace("1:12"));
    EXPECT_THAT(Parse("{\"body\":[{\"name\":\"\xFF\"}]}"), RefusesPlace("1:19"));
}

TEST(RubeText, IsRefusedWhenCutOffAnywhere)
{
    const std::string whole = kWholeScene;
    ASSERT_TRUE(Parse(whole));
    for (std::size_t length = 1; length < whole.size(); ++length)
    {
        EXPECT_THAT(Parse(whole.substr(0, length)), RefusesPart(""))
            << "cut after " << length << " bytes";
    }
}

TEST(RubeText, IsReadOrRefusedWithAnyByteChanged)
{
    const std::string whole = kWholeScene;
    std::size_t refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
    {
        for (const char byte : {'\0', '"', '0', '9', '-', 'e', '[', '}', ',', '\xFF'})
        {
            std::string changed = whole;
            changed[at] = byte;
            refused += Parse(changed) ? 0u : 1u;
        }
    }
    EXPECT_GT(refused, whole.size()) << "most changes make it malformed";
}

TEST(RubeText, IsRefusedWhenNestedTooDeeply)
{
    for (const char* open : {"[", "{\"a\":"})
    {
        std::string text = R"({"body":)";
        for (int i = 0; i < 1'000'000; ++i)
        {
            text += open;
        }
        EXPECT_THAT(Parse(text), RefusesWith("scene.json", "64"));
    }
}

TEST(RubeText, IsReadWhenNestedUpToTheLimit)
{
    const auto nested = [](std::size_t lists) {
        return R"({"body":[],"x":)" + std::string(lists, '[') + std::string(lists, ']') + "}";
    };
    EXPECT_TRUE(Parse(nested(63))); // and the outermost object
    EXPECT_THAT(Parse(nested(64)), RefusesWith("scene.json", "64"));
}

TEST(RubeText, IsRefusedForTooManyValues)
{
    std::string text = R"({"body":[)";
    for (int i = 0; i < 2'000'001; ++i)
    {
        text += "[],";
    }
    EXPECT_THAT(Parse(text), RefusesWith("scene.json", "2000000"));
}

TEST(RubeText, IsRefusedWhenLargerThanTheLimit)
{
    EXPECT_THAT(Parse(std::string((64u << 20) + 1, ' ')), RefusesWith("scene.json", "64 MB"));
}

TEST(RubeText, MakesShortErrorsForHugeNames)
{
    const std::string name(1'000'000, 'n');
    const std::string text = R"({"body":[{")" + name + R"(":1,"type":"x"}]})";
    EXPECT_THAT(Parse(text), RefusesPart("body[0].type"));
}

} // namespace
} // namespace boxreel
