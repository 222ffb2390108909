// SPDX-License-Identifier: MIT
// Scene files that are wrong on purpose: every field of every wrong kind, shapes and joints that
// the engine's asserts would end, numbers and names made to confuse. Those of the fuzzer are in
// tests/fuzz.
#include "RubeBuilt.h"

#include <rube/RubeFile.h>
#include <rube/RubeTraps.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string Complaint(const std::string& text)
{
    const Result<RubeScene> scene = ParseRubeScene(text, "scene.json");
    if (scene)
    {
        ADD_FAILURE() << "should not be accepted: " << text.substr(0, 200);
        return "";
    }
    EXPECT_EQ(scene.GetError().kind, ErrorKind::Unusable);
    const std::string complaint = scene.GetError().Text();
    EXPECT_THAT(complaint, AllOf(StartsWith("scene.json"), EndsWith(".")));
    EXPECT_EQ(std::ranges::count(complaint, '\n'), 0);
    EXPECT_LT(complaint.size(), 300u);
    return complaint;
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

TEST(HostileSceneFile, WithAFieldOfAWrongKindIsRefusedWithItsPath)
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
                    EXPECT_THAT(Complaint(text), StartsWith("scene.json: " + fields.path + name))
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

TEST(HostileSceneFile, WithPartsOfAWrongKindIsRefusedWithTheirPath)
{
    for (const char* part : {"null", "true", "3", "\"x\"", "[]"})
    {
        const std::string list = std::string("[") + part + "]";
        EXPECT_THAT(Complaint("{\"body\":" + list + "}"), StartsWith("scene.json: body[0]"));
        EXPECT_THAT(Complaint(Body("\"fixture\":" + list)),
                    StartsWith("scene.json: body[0].fixture[0]"));
        EXPECT_THAT(Complaint("{\"body\":[],\"joint\":" + list + "}"),
                    StartsWith("scene.json: joint[0]"));
        EXPECT_THAT(Complaint("{\"body\":[],\"image\":" + list + "}"),
                    StartsWith("scene.json: image[0]"));
        if (part != std::string("3"))
        {
            EXPECT_THAT(Complaint(Fixture(Vertices("chain", part, "1"))),
                        StartsWith("scene.json: body[0].fixture[0].chain.vertices.x[0]"));
        }
    }
}

// ---- Numbers

TEST(HostileSceneFile, MayHaveNumbersThatAreTinyOrMinusZero)
{
    for (const char* number : {"-0", "-0.0", "1e-45", "1e-400", "-1e-400", "\"80000000\"",
                               "\"00000001\"", "\"807fffff\""})
    {
        Built built(Body(std::string("\"angle\":") + number));
        EXPECT_NEAR(built.world.GetBodyList()->GetAngle(), 0.0f, 1e-30f) << number;
    }
}

TEST(HostileSceneFile, WithNumbersThatNoDoubleHoldsIsRefused)
{
    for (const char* number : {"1e999", "-1e999", "1e2147483648"})
    {
        EXPECT_THAT(Complaint(Body(std::string("\"angle\":") + number)),
                    AllOf(HasSubstr("the number at line 1, column "), HasSubstr("is too large")))
            << number;
    }
    for (const char* number : {"NaN", "nan", "inf", "Infinity", "-Infinity", "0x10", "+1", ".5",
                               "1.", "01", "1e", "--1"})
    {
        EXPECT_THAT(Complaint(Body(std::string("\"angle\":") + number)),
                    AllOf(HasSubstr("line 1, column "), HasSubstr("cannot be read")))
            << number;
    }
}

// ---- Counts

TEST(HostileSceneFile, WithMoreThanCanBeHeldIsRefused)
{
    EXPECT_THAT(Complaint("{\"body\":[" + Repeated("{}", 1'000'000) + "]}"),
                HasSubstr("has more than 500000 objects; split the scene"));
    const std::string million = Repeated("1", 1'000'000);
    EXPECT_THAT(Complaint(Fixture(Vertices("polygon", million, million))),
                HasSubstr("has more than 2000000 values; split the scene"));
}

TEST(HostileSceneFile, WithManyVerticesInAPolygonHasItLeftOut)
{
    const std::string many = Repeated("1", 100'000);
    Built built(Fixture(Vertices("polygon", many, many)));
    EXPECT_THAT(built.leftOut, ElementsAre(HasSubstr("this one has 100000")));
}

TEST(HostileSceneFile, WithManyFixturesOnABodyWeighsThemAllTogether)
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
TEST(HostileSceneFile, WithTooManyShapesInOnePlaceIsRefused)
{
    const auto load = [](int type, std::size_t bodies, std::size_t fixtures) {
        const std::string circles = Repeated(R"({"circle":{"radius":1}})", fixtures);
        const std::string body =
            "{\"type\":" + std::to_string(type) + ",\"fixture\":[" + circles + "]}";
        std::vector<std::string> leftOut;
        const auto scene =
            SceneOfText("{\"body\":[" + Repeated(body, bodies) + "]}", "scene.json", leftOut);
        return scene ? "" : scene.GetError().Text();
    };
    const auto refused = StartsWith("scene.json has more than 1000000 pairs of shapes");
    EXPECT_EQ(load(b2_dynamicBody, 1400, 1), "");
    EXPECT_THAT(load(b2_dynamicBody, 1500, 1), refused);
    EXPECT_THAT(load(b2_kinematicBody, 1500, 1), refused);
    EXPECT_THAT(load(b2_dynamicBody, 1, 1500), refused) << "of one body they are looked at, too";
    EXPECT_EQ(load(b2_staticBody, 3000, 1), "") << "these never meet";
}

// ---- What the engine would assert

TEST(HostileSceneFile, MayHaveABoxWhoseCornersBeginAnywhere)
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

TEST(HostileSceneFile, HasLoopsAndChainsLeftOutThatHaveTooFewCorners)
{
    for (const std::string& shape :
         {Vertices("loop", "0,1,0", "0,0,0"), Vertices("loop", "0,1,0.004,-0.004", "0,0,0,0"),
          Vertices("loop", "0,0,0,0", "0,0,0,0"), Vertices("chain", "0,0.005", "0,0")})
    {
        Built built(Fixture(shape));
        EXPECT_THAT(built.leftOut, ElementsAre(HasSubstr("different vertices"))) << shape;
        EXPECT_EQ(built.world.GetBodyList()->GetFixtureList(), nullptr);
    }
}

// At the tolerance a root and a square round differently.
TEST(HostileSceneFile, MayHaveVerticesAsCloseAsTheToleranceInAnyDirection)
{
    for (int i = 0; i < 2000; ++i)
    {
        const float32 angle = 0.001f * static_cast<float32>(i);
        RubeScene scene;
        scene.bodies.resize(1);
        scene.bodies[0].fixtures.resize(1);
        const b2Vec2 close = b2_linearSlop * b2Vec2(std::cos(angle), std::sin(angle));
        scene.bodies[0].fixtures[0].shape =
            RubeChain{{b2Vec2(0.0f, 0.0f), close, b2Vec2(1.0f, 1.0f)}, false, {}, {}};
        b2World world(b2Vec2(0.0f, 0.0f));
        std::vector<std::string> leftOut;
        BuildRubeScene(scene, world, leftOut);
        ASSERT_THAT(leftOut, IsEmpty());
        const auto& chain =
            static_cast<const b2ChainShape&>(*world.GetBodyList()->GetFixtureList()->GetShape());
        const bool isKept = close.LengthSquared() > b2_linearSlop * b2_linearSlop;
        ASSERT_EQ(chain.m_count, isKept ? 3 : 2) << angle;
    }
}

TEST(HostileSceneFile, LeavesOutJointsThatCannotBe)
{
    for (const auto& [joint, why] :
         {std::pair(R"("type":"gear","joint1":0,"joint2":0)", "a gear needs two joints"),
          {R"("type":"gear","joint1":7,"joint2":1000000000)", "a gear needs two joints"},
          {R"("type":"revolute","bodyB":0)", "it connects a body with itself"},
          {R"("type":"")", "joints of this kind cannot be built"},
          {R"("type":"pulley","ratio":0)", "a pulley needs a ratio above zero"},
          {R"("type":"wheel","localAxisA":{"x":1e-30,"y":0})", "its axis has no direction"},
          {R"("type":"rope","maxLength":0.001)", "its length is zero"}})
    {
        Built built(Joint(joint));
        EXPECT_THAT(built.leftOut, ElementsAre(HasSubstr(why))) << joint;
        EXPECT_EQ(built.world.GetJointCount(), 0);
    }
}

TEST(HostileSceneFile, LeavesOutGearsThatStandOnEachOther)
{
    const std::string gears = R"({"type":"gear","bodyA":0,"bodyB":1,"joint1":1,"joint2":2},
        {"type":"gear","bodyA":0,"bodyB":1,"joint1":2,"joint2":0},
        {"type":"gear","bodyA":0,"bodyB":1,"joint1":0,"joint2":1})";
    Built built(R"({"body":[{"type":2},{"type":2}],"joint":[)" + gears + "]}");
    EXPECT_EQ(built.leftOut.size(), 3u);
    EXPECT_EQ(built.world.GetJointCount(), 0);
}

TEST(HostileSceneFile, ThatPointsAtWhatIsNotThereIsRefused)
{
    EXPECT_THAT(Complaint(Joint(R"("type":"weld","bodyB":2)")), HasSubstr("joint[0].bodyB"));
    EXPECT_THAT(Complaint(R"({"body":[],"image":[{"body":0}]})"), HasSubstr("image[0].body"));
    EXPECT_THAT(Complaint(R"({"body":[],"joint":[{"type":"weld","bodyA":0,"bodyB":0}]})"),
                HasSubstr("joint[0] connects bodies, but the file has none"));
}

// ---- What is asleep

TEST(HostileSceneFile, ThatSleepsInFullSpinRests)
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

TEST(HostileSceneFile, CannotGarbleATerminalWithItsNames)
{
    const std::string name = "\\u0000\\u001b[2J\\u007f\\u009b2J\\r\\n";
    Built built(Body(R"("name":")" + name + R"(zß中","fixture":[{}])"));
    ASSERT_EQ(built.leftOut.size(), 1u);
    EXPECT_THAT(built.leftOut[0], HasSubstr("of body 0 \"??[2J??2J??zß中\" is left out"));
}

TEST(HostileSceneFile, OfAnotherEncodingIsRefused)
{
    for (const std::string& name :
         {std::string("\xFF"), std::string("\xC0\x80"), std::string("\xED\xA0\x80"),
          std::string("\xF4\x90\x80\x80"), std::string("\xE4"), std::string("\\ud800")})
    {
        EXPECT_THAT(Complaint(Body("\"name\":\"" + name + "\"")), HasSubstr("line 1, column"));
    }
    EXPECT_THAT(Complaint(std::string("\xFF\xFE{\0}\0", 6)), HasSubstr("line 1, column"));
    Built withMark("\xEF\xBB\xBF" + Body(""));
    EXPECT_EQ(withMark.world.GetBodyCount(), 1);
}

TEST(HostileSceneFile, ThatSaysAThingTwiceMeansTheLast)
{
    Built built(R"({"body":[{},{}],"body":[{"angle":1,"angle":2}]})");
    ASSERT_EQ(built.world.GetBodyCount(), 1);
    EXPECT_EQ(built.world.GetBodyList()->GetAngle(), 2.0f);
}

TEST(HostileSceneFile, WithTwoShapesInAFixtureHasItNoted)
{
    const std::string text =
        Fixture(R"("friction":1,"density":1,"polygon":3,"circle":{"radius":1},"loop":[])");
    Built built(text);
    ASSERT_NE(built.world.GetBodyList()->GetFixtureList(), nullptr);
    EXPECT_EQ(built.world.GetBodyList()->GetFixtureList()->GetType(), b2Shape::e_circle);
    const auto traps = RubeTraps(text, "scene.json");
    ASSERT_TRUE(traps) << "what is not taken is not looked at";
    EXPECT_THAT(*traps, ElementsAre(HasSubstr("does not say awake"),
                                    HasSubstr("it has more than one shape; its circle is taken")));
}

// ---- Devices

TEST(HostileSceneFile, ThatIsADeviceIsRefusedUnread)
{
    for (const char* device : {"/dev/zero", "/dev/null", "/dev", "/proc/self/mem"})
    {
        std::vector<std::string> leftOut;
        const auto scene = LoadRubeScene(device, leftOut);
        ASSERT_FALSE(scene) << device;
        EXPECT_THAT(scene.GetError().culprit, StartsWith(device));
    }
}

} // namespace
} // namespace boxreel
