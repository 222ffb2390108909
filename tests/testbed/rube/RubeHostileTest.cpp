// SPDX-License-Identifier: MIT
// Invalid scene files: every field of every wrong type, shapes and joints that would fail the
// engine's asserts, confusing numbers and names. Those of the fuzzer are in tests/fuzz.
#include "RubeBuilt.h"

#include "../../base/Errors.h"

#include <rube/RubeFile.h>
#include <rube/RubeTraps.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Result<RubeScene> Parse(const std::string& text)
{
    return ParseRubeScene(text, "scene.json");
}

std::string Body(const std::string& members)
{
    return "{\"body\":[{" + members + "}]}";
}

std::string Fixture(const std::string& members)
{
    return Body(R"("type":2,"fixture":[{)" + members + "}]");
}

std::string Joint(const std::string& members)
{
    return R"({"body":[{},{}],"joint":[{"bodyA":0,"bodyB":1,)" + members + "}]}";
}

std::string Vertices(const std::string& kind, const std::string& x, const std::string& y)
{
    return "\"" + kind + R"(":{"vertices":{"x":[)" + x + R"(],"y":[)" + y + "]}}";
}

/// The same part of a text many times, with commas between.
std::string Repeated(const std::string& part, std::size_t times)
{
    std::string text;
    text.reserve((part.size() + 1) * times);
    for (std::size_t i = 0; i < times; ++i)
    {
        text.append(i > 0 ? "," : "").append(part);
    }
    return text;
}

// ---- Kinds

/// Fields of one object of the format, by what their values are.
struct Fields
{
    std::string before; ///< of the text, up to the name of the field
    std::string after;
    std::string path; ///< of the object, as messages say it
    std::vector<std::string> numbers, flags, wholes, texts, vectors, lists, shapes;
};

std::vector<Fields> AllFields()
{
    const auto joint = [](const std::string& type, std::vector<std::string> numbers,
                          std::vector<std::string> flags = {},
                          std::vector<std::string> vectors = {},
                          std::vector<std::string> wholes = {}) {
        return Fields{R"({"body":[{},{}],"joint":[{"bodyA":0,"bodyB":1,"joint1":0,"joint2":0,)"
                      R"("type":")" +
                          type + "\",",
                      "}]}",
                      "joint[0].",
                      std::move(numbers),
                      std::move(flags),
                      std::move(wholes),
                      {},
                      std::move(vectors),
                      {},
                      {}};
    };
    const std::string fixture = R"({"body":[{"fixture":[{)";
    return {
        {"{\"body\":[],",
         "}",
         "",
         {"stepsPerSecond"},
         {"allowSleep", "autoClearForces", "warmStarting", "continuousPhysics", "subStepping"},
         {"velocityIterations", "positionIterations"},
         {},
         {"gravity"},
         {"joint", "image"},
         {}},
        {"{", "}", "", {}, {}, {}, {}, {}, {"body"}, {}},
        {"{\"body\":[{",
         "}]}",
         "body[0].",
         {"angle", "angularVelocity", "linearDamping", "angularDamping", "gravityScale",
          "massData-mass", "massData-I"},
         {"bullet", "allowSleep", "awake", "active", "fixedRotation"},
         {"type"},
         {"name"},
         {"position", "linearVelocity", "massData-center"},
         {"fixture"},
         {}},
        {fixture,
         "}]}]}",
         "body[0].fixture[0].",
         {"friction", "restitution", "density"},
         {"sensor"},
         {"filter-categoryBits", "filter-maskBits", "filter-groupIndex"},
         {"name"},
         {},
         {},
         {"circle", "edge", "chain", "loop", "polygon"}},
        {fixture + "\"circle\":{",
         "}}]}]}",
         "body[0].fixture[0].circle.",
         {"radius"},
         {},
         {},
         {},
         {"center"},
         {},
         {}},
        {fixture + R"("edge":{"hasVertex0":true,"hasVertex3":true,)",
         "}}]}]}",
         "body[0].fixture[0].edge.",
         {},
         {},
         {},
         {},
         {"vertex0", "vertex1", "vertex2", "vertex3"},
         {},
         {}},
        {fixture + "\"edge\":{",
         "}}]}]}",
         "body[0].fixture[0].edge.",
         {},
         {"hasVertex0", "hasVertex3"},
         {},
         {},
         {},
         {},
         {}},
        {fixture +
             R"("chain":{"vertices":{"x":[],"y":[]},"hasPrevVertex":true,"hasNextVertex":true,)",
         "}}]}]}",
         "body[0].fixture[0].chain.",
         {},
         {},
         {},
         {},
         {"prevVertex", "nextVertex"},
         {},
         {}},
        {fixture + R"("polygon":{"vertices":{"x":[],)",
         "}}}]}]}",
         "body[0].fixture[0].polygon.vertices.",
         {},
         {},
         {},
         {},
         {},
         {"y"},
         {}},
        {fixture + "\"loop\":{",
         "}}]}]}",
         "body[0].fixture[0].loop.",
         {},
         {},
         {},
         {},
         {},
         {},
         {"vertices"}},
        {R"({"body":[{}],"joint":[{"bodyB":0,)",
         "}]}",
         "joint[0].",
         {},
         {},
         {},
         {"type"},
         {},
         {},
         {}},
        {R"({"body":[{}],"joint":[{"type":"weld",)",
         "}]}",
         "joint[0].",
         {},
         {},
         {"bodyA"},
         {},
         {},
         {},
         {}},
        joint("revolute", {"refAngle", "lowerLimit", "upperLimit", "motorSpeed", "maxMotorTorque"},
              {"enableLimit", "enableMotor", "collideConnected"}, {"anchorA", "anchorB"}),
        joint("prismatic", {"refAngle", "lowerLimit", "upperLimit", "motorSpeed", "maxMotorForce"},
              {"enableLimit", "enableMotor"}, {"localAxisA", "localAxis1"}),
        joint("distance", {"length", "frequency", "dampingRatio"}),
        joint("pulley", {"lengthA", "lengthB", "ratio"}, {}, {"groundAnchorA", "groundAnchorB"}),
        joint("mouse", {"maxForce", "frequency", "dampingRatio"}, {}, {"target"}),
        joint("gear", {"ratio"}, {}, {}, {"joint1", "joint2"}),
        joint("wheel", {"motorSpeed", "maxMotorTorque", "springFrequency", "springDampingRatio"},
              {"enableMotor"}, {"localAxisA"}),
        joint("motor", {"refAngle", "maxForce", "maxTorque", "correctionFactor"}, {},
              {"linearOffset"}),
        joint("weld", {"refAngle", "frequency", "dampingRatio"}),
        joint("friction", {"maxForce", "maxTorque"}),
        joint("rope", {"maxLength"}),
        {R"({"body":[],"image":[{)",
         "}]}",
         "image[0].",
         {"angle"},
         {},
         {"body"},
         {"file"},
         {"center"},
         {},
         {"corners"}},
    };
}

TEST(HostileSceneFile, IsRefusedWithPathOfFieldOfWrongType)
{
    int refused = 0;
    for (const Fields& fields : AllFields())
    {
        const auto refuse = [&](const std::vector<std::string>& names,
                                const std::vector<const char*>& values) {
            for (const std::string& name : names)
            {
                for (const char* value : values)
                {
                    const std::string text =
                        fields.before + "\"" + name + "\":" + value + fields.after;
                    EXPECT_THAT(Parse(text),
                                Refuses(StartsWith("scene.json: " + fields.path + name)))
                        << text;
                    ++refused;
                }
            }
        };
        refuse(fields.numbers,
               {"null", "true", "[]", "{}", "\"\"", "\"NaN\"", "\"nan\"", "\"inf\"", "\"0.5\"",
                "\"3F00000\"", "\"0x3F0000\"", "\"7FC00000\"", "\"FFC00001\"", "\"7F800000\"",
                "\"FF800000\"", "\"7F7FFFFF\"", "1e30", "-1e30", "123456789012345678901234567890"});
        refuse(fields.flags, {"null", "\"true\"", "2", "-1", "0.5", "1e300", "[]", "{}"});
        refuse(fields.wholes, {"null", "true", "\"1\"", "\"3F800000\"", "0.5", "1e30", "-99999",
                               "9223372036854775808", "-9223372036854775809", "[]", "{}"});
        refuse(fields.texts, {"null", "true", "1", "[]", "{}"});
        refuse(fields.vectors,
               {"null", "true", "\"0\"", "1", "[]", "[0,0]", "{}", R"({"x":1})", R"({"y":1})",
                R"({"x":"NaN","y":0})", R"({"x":0,"y":1e7})", R"({"x":[0],"y":[0]})"});
        refuse(fields.lists, {"null", "true", "\"x\"", "1", "{}", R"({"0":{}})"});
        refuse(fields.shapes, {"null", "true", "\"x\"", "1", "[]", "[0,0]"});
    }
    EXPECT_GT(refused, 1000);
}

TEST(HostileSceneFile, IsRefusedWithPathOfPartOfWrongType)
{
    for (const char* part : {"null", "true", "3", "\"x\"", "[]"})
    {
        const std::string list = std::string("[") + part + "]";
        EXPECT_THAT(Parse("{\"body\":" + list + "}"), Refuses("scene.json: body[0]"));
        EXPECT_THAT(Parse(Body("\"fixture\":" + list)), Refuses("scene.json: body[0].fixture[0]"));
        EXPECT_THAT(Parse("{\"body\":[],\"joint\":" + list + "}"), Refuses("scene.json: joint[0]"));
        EXPECT_THAT(Parse("{\"body\":[],\"image\":" + list + "}"), Refuses("scene.json: image[0]"));
        if (part != std::string("3"))
        {
            EXPECT_THAT(Parse(Fixture(Vertices("chain", part, "1"))),
                        Refuses("scene.json: body[0].fixture[0].chain.vertices.x[0]"));
        }
    }
}

// ---- Numbers

TEST(HostileSceneFile, AcceptsTinyNumbersAndMinusZero)
{
    for (const char* number : {"-0", "-0.0", "1e-45", "1e-400", "-1e-400", "\"80000000\"",
                               "\"00000001\"", "\"807fffff\""})
    {
        Built built(Body(std::string("\"angle\":") + number));
        EXPECT_NEAR(built.world.GetBodyList()->GetAngle(), 0.0f, 1e-30f) << number;
    }
}

TEST(HostileSceneFile, IsRefusedForInvalidOrTooLargeNumbers)
{
    for (const char* number : {"1e999", "-1e999", "1e2147483648"})
    {
        EXPECT_THAT(Parse(Body(std::string("\"angle\":") + number)),
                    RefusesWith(StartsWith("scene.json:1:"), "too large"))
            << number;
    }
    for (const char* number : {"NaN", "nan", "inf", "Infinity", "-Infinity", "0x10", "+1", ".5",
                               "1.", "01", "1e", "--1"})
    {
        EXPECT_THAT(Parse(Body(std::string("\"angle\":") + number)),
                    Refuses(StartsWith("scene.json:1:")))
            << number;
    }
}

// ---- Counts

TEST(HostileSceneFile, IsRefusedForTooManyBodiesOrVertices)
{
    EXPECT_THAT(Parse("{\"body\":[" + Repeated("{}", 1'000'000) + "]}"),
                RefusesWith("scene.json", "500000"));
    const std::string million = Repeated("1", 1'000'000);
    EXPECT_THAT(Parse(Fixture(Vertices("polygon", million, million))),
                RefusesWith("scene.json", "2000000"));
}

TEST(HostileSceneFile, OmitsPolygonWithTooManyVertices)
{
    const std::string many = Repeated("1", 100'000);
    Built built(Fixture(Vertices("polygon", many, many)));
    ASSERT_THAT(built.Missing(), ElementsAre("fixture 0 of body 0"));
    EXPECT_THAT(built.leftOut[0].reason, HasSubstr("100000"));
}

TEST(HostileSceneFile, SumsMassOfManyFixtures)
{
    const std::string circle = R"({"density":1,"circle":{"radius":1,"center":{"x":1,"y":0}}})";
    for (const std::size_t count : {100u, 101u, 5000u})
    {
        Built built(Body(R"("type":2,"awake":true,"angularVelocity":2,"fixture":[)" +
                         Repeated(circle, count) + "]"));
        const b2Body& body = *built.world.GetBodyList();
        const float32 mass = static_cast<float32>(count) * b2_pi;
        EXPECT_NEAR(body.GetMass(), mass, 1e-3f * mass);
        EXPECT_EQ(body.GetLocalCenter(), b2Vec2(1.0f, 0.0f));
        EXPECT_EQ(body.GetLinearVelocity(), b2Vec2(0.0f, 0.0f)) << "as the file says";
        EXPECT_EQ(body.GetFixtureList()->GetDensity(), 1.0f);
    }
}

// The first step would look at each pair: five thousand in one place are four gigabytes.
TEST(HostileSceneFile, IsRefusedForTooManyShapesInOnePlace)
{
    const auto load = [](int type, std::size_t bodies, std::size_t fixtures) {
        const std::string circles = Repeated(R"({"circle":{"radius":1}})", fixtures);
        const std::string body =
            "{\"type\":" + std::to_string(type) + ",\"fixture\":[" + circles + "]}";
        RubeNotes leftOut;
        const auto scene =
            SceneOfText("{\"body\":[" + Repeated(body, bodies) + "]}", "scene.json", leftOut);
        return scene ? Result<void>() : Result<void>(scene.GetError());
    };
    const auto refused = RefusesWith("scene.json", "1000000");
    EXPECT_TRUE(load(b2_dynamicBody, 1400, 1));
    EXPECT_THAT(load(b2_dynamicBody, 1500, 1), refused);
    EXPECT_THAT(load(b2_kinematicBody, 1500, 1), refused);
    EXPECT_THAT(load(b2_dynamicBody, 1, 1500), refused) << "of one body they are looked at, too";
    EXPECT_TRUE(load(b2_staticBody, 3000, 1)) << "these never meet";
}

// ---- What the engine would assert

TEST(HostileSceneFile, AcceptsBoxThatBeginsAtAnyCorner)
{
    for (const auto& [x, y] : {std::pair("-1,1,1,-1", "-2,-2,2,2"),
                               {"1,1,-1,-1", "-2,2,2,-2"},
                               {"1,-1,-1,1", "2,2,-2,-2"},
                               {"-1,-1,1,1", "2,-2,-2,2"},
                               {"-1,-1,1,1", "-2,2,2,-2"},
                               {"1,-1,-1,1", "-2,-2,2,2"}})
    {
        Built built(Fixture(R"("density":1,)" + Vertices("polygon", x, y)));
        EXPECT_THAT(built.leftOut, IsEmpty());
        EXPECT_FLOAT_EQ(built.world.GetBodyList()->GetMass(), 8.0f) << x;
    }
}

TEST(HostileSceneFile, OmitsLoopsAndChainsWithTooFewCorners)
{
    for (const std::string& shape :
         {Vertices("loop", "0,1,0", "0,0,0"), Vertices("loop", "0,1,0.004,-0.004", "0,0,0,0"),
          Vertices("loop", "0,0,0,0", "0,0,0,0"), Vertices("chain", "0,0.005", "0,0")})
    {
        Built built(Fixture(shape));
        EXPECT_THAT(built.Missing(), ElementsAre("fixture 0 of body 0")) << shape;
        EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr);
    }
}

// At the tolerance a root and a square round differently.
TEST(HostileSceneFile, AcceptsVerticesAtToleranceDistance)
{
    for (int i = 0; i < 2000; ++i)
    {
        const float32 angle = 0.001f * static_cast<float32>(i);
        RubeScene scene;
        scene.bodies.resize(1);
        scene.bodies[0].fixtures.resize(1);
        const b2Vec2 close = b2_linearSlop * b2Vec2(std::cos(angle), std::sin(angle));
        scene.bodies[0].fixtures[0].geometry =
            RubeChain{{b2Vec2(0.0f, 0.0f), close, b2Vec2(1.0f, 1.0f)}, false, {}, {}};
        b2World world(b2Vec2(0.0f, 0.0f));
        RubeNotes leftOut;
        BuildRubeScene(scene, world, leftOut);
        ASSERT_THAT(leftOut, IsEmpty());
        const auto& chain =
            static_cast<const b2ChainShape&>(*world.GetBodyList()->GetFixtureList()->GetShape());
        const bool isKept = close.LengthSquared() > b2_linearSlop * b2_linearSlop;
        ASSERT_EQ(chain.m_count, isKept ? 3 : 2) << angle;
    }
}

TEST(HostileSceneFile, OmitsInvalidJoints)
{
    for (const auto& [joint, kind] : {std::pair(R"("type":"gear","joint1":0,"joint2":0)", "gear"),
                                      {R"("type":"gear","joint1":7,"joint2":1000000000)", "gear"},
                                      {R"("type":"")", "no kind"},
                                      {R"("type":"pulley","ratio":0)", "pulley"},
                                      {R"("type":"mouse","frequency":0)", "mouse"},
                                      {R"("type":"wheel","localAxisA":0)", "wheel"},
                                      {R"("type":"wheel","localAxisA":{"x":1e-30,"y":0})", "wheel"},
                                      {R"("type":"rope","maxLength":0)", "rope"},
                                      {R"("type":"rope","maxLength":0.001)", "rope"}})
    {
        Built built(Joint(joint));
        EXPECT_THAT(built.Missing(),
                    ElementsAre(std::string("joint 0 (") + kind + ", between body 0 and body 1)"))
            << joint;
        EXPECT_EQ(built.world.GetJointCount(), 0);
    }
}

TEST(HostileSceneFile, OmitsGearsThatReferToEachOther)
{
    const std::string gears = R"({"type":"gear","bodyA":0,"bodyB":1,"joint1":1,"joint2":2},
        {"type":"gear","bodyA":0,"bodyB":1,"joint1":2,"joint2":0},
        {"type":"gear","bodyA":0,"bodyB":1,"joint1":0,"joint2":1})";
    Built built(R"({"body":[{"type":2},{"type":2}],"joint":[)" + gears + "]}");
    EXPECT_EQ(built.leftOut.size(), 3u);
    EXPECT_EQ(built.world.GetJointCount(), 0);
}

TEST(HostileSceneFile, IsRefusedForReferencesToMissingBodies)
{
    EXPECT_THAT(Parse(Joint(R"("type":"weld","bodyB":2)")), Refuses("scene.json: joint[0].bodyB"));
    EXPECT_THAT(Parse(R"({"body":[],"image":[{"body":0}]})"), Refuses("scene.json: image[0].body"));
    EXPECT_THAT(Parse(R"({"body":[],"joint":[{"type":"weld","bodyA":0,"bodyB":0}]})"),
                Refuses("scene.json: joint[0].bodyA"));
}

// ---- Sleeping bodies

TEST(HostileSceneFile, StopsBodiesThatSleepWithVelocity)
{
    const std::string spinning =
        R"("type":2,"massData-mass":1,"massData-I":2,"massData-center":{"x":1,"y":0},)"
        R"("angularVelocity":3)";
    for (const char* velocity : {"0", R"({"x":1,"y":0})"})
    {
        Built asleep(Body(spinning + R"(,"linearVelocity":)" + velocity));
        const b2Body& body = *asleep.world.GetBodyList();
        EXPECT_FALSE(body.IsAwake());
        EXPECT_EQ(body.GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
        EXPECT_EQ(body.GetAngularVelocity(), 0.0f);
    }
    Built awake(Body(spinning + R"(,"awake":true,"linearVelocity":{"x":1,"y":0})"));
    EXPECT_EQ(awake.world.GetBodyList()->GetLinearVelocity(), b2Vec2(1.0f, 0.0f));
    EXPECT_EQ(awake.world.GetBodyList()->GetAngularVelocity(), 3.0f);
}

// ---- Names and duplicates

TEST(HostileSceneFile, ReplacesControlCharactersInNames)
{
    const std::string name = "\\u0000\\u001b[2J\\u007f\\u009b2J\\r\\n";
    Built built(Body(R"("name":")" + name + R"(zß中","fixture":[{}])"));
    EXPECT_THAT(built.Missing(), ElementsAre("fixture 0 of body 0 \"??[2J??2J??zß中\""));
}

TEST(HostileSceneFile, IsRefusedWhenNotUtf8)
{
    for (const std::string& name :
         {std::string("\xFF"), std::string("\xC0\x80"), std::string("\xED\xA0\x80"),
          std::string("\xF4\x90\x80\x80"), std::string("\xE4"), std::string("\\ud800")})
    {
        EXPECT_THAT(Parse(Body("\"name\":\"" + name + "\"")), Refuses(StartsWith("scene.json:1:")));
    }
    EXPECT_THAT(Parse(std::string("\xFF\xFE{\0}\0", 6)), Refuses(StartsWith("scene.json:1:")));
    Built withMark("\xEF\xBB\xBF" + Body(""));
    EXPECT_EQ(withMark.world.GetBodyCount(), 1);
}

TEST(HostileSceneFile, UsesTheLastOfDuplicateMembers)
{
    Built built(R"({"body":[{},{}],"body":[{"angle":1,"angle":2}]})");
    ASSERT_EQ(built.world.GetBodyCount(), 1);
    EXPECT_EQ(built.world.GetBodyList()->GetAngle(), 2.0f);
}

TEST(HostileSceneFile, NotesFixtureWithTwoShapes)
{
    const std::string text =
        Fixture(R"("friction":1,"density":1,"polygon":3,"circle":{"radius":1},"loop":[])");
    Built built(text);
    ASSERT_NE(built.world.GetBodyList()->GetFixtureList(), nullptr);
    EXPECT_EQ(built.world.GetBodyList()->GetFixtureList()->GetType(), b2Shape::e_circle);
    const auto traps = RubeTraps(text, "scene.json");
    ASSERT_TRUE(traps) << "what is not taken is not looked at";
    EXPECT_THAT(*traps, ElementsAre(Field(&RubeNote::part, "body 0"),
                                    AllOf(Field(&RubeNote::part, "fixture 0 of body 0"),
                                          Field(&RubeNote::reason, HasSubstr("circle")))));
}

// ---- Devices

TEST(HostileSceneFile, IsRefusedWhenItIsADevice)
{
    for (const char* device : {"/dev/zero", "/dev/null", "/dev", "/proc/self/mem"})
    {
        RubeNotes leftOut;
        const auto scene = LoadRubeScene(device, leftOut);
        EXPECT_THAT(scene, Refuses(device));
    }
}

} // namespace
} // namespace boxreel
