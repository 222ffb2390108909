// SPDX-License-Identifier: MIT
#include "RubeText.h"

#include "RubeJson.h"

#include <base/ErrorMacros.h>

#include <cstdint>

namespace boxreel
{

namespace
{

// Limits that no sane scene reaches and that keep every later product finite.
constexpr float32 kFarthest = 1e6f;   ///< coordinates and lengths: floats are 6 cm apart there [m]
constexpr float32 kFastest = 1e6f;    ///< velocities [m/s, rad/s]
constexpr float32 kWidest = 1e6f;     ///< angles [rad]
constexpr float32 kStrongest = 1e12f; ///< forces, torques, masses, densities
constexpr float32 kStiffest =
    1e25f; ///< rotational inertia: maximum mass at maximum distance [kg m^2]
constexpr float32 kLargest = 1e6f; ///< everything without a unit, damping and frequencies

b2Vec2 ReadVector(const JsonValue& value, float32 maximum = kFarthest)
{
    if (!value.Exists() || value.IsZero())
    {
        return b2Vec2(0.0f, 0.0f);
    }
    const float32 x = value.Required("x").Number(0.0f, -maximum, maximum);
    const float32 y = value.Required("y").Number(0.0f, -maximum, maximum);
    return b2Vec2(x, y);
}

std::optional<b2Vec2> ReadVectorIf(const JsonValue& isGiven, const JsonValue& value)
{
    return isGiven.Bool(false) ? std::optional(ReadVector(value)) : std::nullopt;
}

std::vector<b2Vec2> ReadVertices(const JsonValue& value)
{
    const JsonValue xs = value.Required("x");
    const JsonValue ys = value.Required("y");
    const std::size_t count = xs.Count();
    if (ys.Count() != count)
    {
        value.Complain("must have as many x as y");
        return {};
    }
    std::vector<b2Vec2> vertices;
    vertices.reserve(count);
    for (std::size_t i = 0; i < count && !value.IsHopeless(); ++i)
    {
        vertices.emplace_back(xs.Item(i).Number(0.0f, -kFarthest, kFarthest),
                              ys.Item(i).Number(0.0f, -kFarthest, kFarthest));
    }
    return vertices;
}

RubeCircle ReadCircle(const JsonValue& value)
{
    RubeCircle circle;
    circle.center = ReadVector(value.Member("center"));
    circle.radius = value.Member("radius").Number(0.0f, 0.0f, kFarthest);
    return circle;
}

RubeEdge ReadEdge(const JsonValue& value)
{
    RubeEdge edge;
    edge.vertex1 = ReadVector(value.Member("vertex1"));
    edge.vertex2 = ReadVector(value.Member("vertex2"));
    edge.vertex0 = ReadVectorIf(value.Member("hasVertex0"), value.Member("vertex0"));
    edge.vertex3 = ReadVectorIf(value.Member("hasVertex3"), value.Member("vertex3"));
    return edge;
}

RubeChain ReadChain(const JsonValue& value, bool isLoop)
{
    RubeChain chain;
    chain.vertices = ReadVertices(value.Required("vertices"));
    chain.isLoop = isLoop;
    chain.previous = ReadVectorIf(value.Member("hasPrevVertex"), value.Member("prevVertex"));
    chain.next = ReadVectorIf(value.Member("hasNextVertex"), value.Member("nextVertex"));
    return chain;
}

RubeFixture ReadFixture(const JsonValue& value)
{
    RubeFixture fixture;
    fixture.name = value.Member("name").Text();
    fixture.restitution = value.Member("restitution").Number(0.0f, 0.0f, kLargest);
    fixture.friction = value.Member("friction").Number(0.0f, 0.0f, kLargest);
    fixture.density = value.Member("density").Number(0.0f, 0.0f, kStrongest);
    fixture.isSensor = value.Member("sensor").Bool(false);
    // Some writers print the sixteen bits as a signed number; -1 and 65535 are the same mask.
    fixture.categoryBits =
        static_cast<uint16>(value.Member("filter-categoryBits").Integer(1, -32768, 65535));
    fixture.maskBits =
        static_cast<uint16>(value.Member("filter-maskBits").Integer(65535, -32768, 65535));
    fixture.groupIndex =
        static_cast<int16>(value.Member("filter-groupIndex").Integer(0, -32768, 32767));

    if (const JsonValue circle = value.Member("circle"); circle.Exists())
    {
        fixture.shape = ReadCircle(circle);
    }
    else if (const JsonValue edge = value.Member("edge"); edge.Exists())
    {
        fixture.shape = ReadEdge(edge);
    }
    else if (const JsonValue chain = value.Member("chain"); chain.Exists())
    {
        fixture.shape = ReadChain(chain, false);
    }
    else if (const JsonValue loop = value.Member("loop"); loop.Exists())
    {
        fixture.shape = ReadChain(loop, true);
    }
    else if (const JsonValue polygon = value.Member("polygon"); polygon.Exists())
    {
        RubePolygon said{ReadVertices(polygon.Required("vertices"))};
        if (const JsonValue normals = polygon.Member("normals"); normals.Exists())
        {
            said.normals = ReadVertices(normals);
        }
        fixture.shape = std::move(said);
    }
    fixture.properties = value.Member("customProperties").Raw();
    return fixture;
}

// A file with a centre or an inertia but no mass means the mass of the fixtures. Otherwise the body
// would have 1 kg and could not rotate.
std::optional<b2MassData> ReadMassData(const JsonValue& value)
{
    const JsonValue mass = value.Member("massData-mass");
    b2MassData data;
    data.mass = mass.Number(0.0f, 0.0f, kStrongest);
    data.center = ReadVector(value.Member("massData-center"));
    data.I = value.Member("massData-I").Number(0.0f, 0.0f, kStiffest);
    return data.mass > 0.0f ? std::optional(data) : std::nullopt;
}

RubeBody ReadBody(const JsonValue& value)
{
    RubeBody body;
    body.name = value.Member("name").Text();
    body.type = static_cast<b2BodyType>(value.Member("type").Integer(0, 0, 2));
    body.position = ReadVector(value.Member("position"));
    body.angle = value.Member("angle").Number(0.0f, -kWidest, kWidest);
    body.linearVelocity = ReadVector(value.Member("linearVelocity"), kFastest);
    body.angularVelocity = value.Member("angularVelocity").Number(0.0f, -kFastest, kFastest);
    body.linearDamping = value.Member("linearDamping").Number(0.0f, 0.0f, kLargest);
    body.angularDamping = value.Member("angularDamping").Number(0.0f, 0.0f, kLargest);
    body.gravityScale = value.Member("gravityScale").Number(1.0f, -kLargest, kLargest);
    body.isBullet = value.Member("bullet").Bool(false);
    body.allowSleep = value.Member("allowSleep").Bool(true);
    body.isAwake = value.Member("awake").Bool(false);
    body.isActive = value.Member("active").Bool(true);
    body.fixedRotation = value.Member("fixedRotation").Bool(false);
    body.massData = ReadMassData(value);

    body.properties = value.Member("customProperties").Raw();
    const JsonValue fixtures = value.Member("fixture");
    for (std::size_t i = 0; i < fixtures.Count() && !value.IsHopeless(); ++i)
    {
        body.fixtures.push_back(ReadFixture(fixtures.Item(i)));
    }
    return body;
}

RubeRevolute ReadRevolute(const JsonValue& value)
{
    RubeRevolute joint;
    joint.referenceAngle = value.Member("refAngle").Number(0.0f, -kWidest, kWidest);
    joint.enableLimit = value.Member("enableLimit").Bool(false);
    joint.lowerLimit = value.Member("lowerLimit").Number(0.0f, -kWidest, kWidest);
    joint.upperLimit = value.Member("upperLimit").Number(0.0f, -kWidest, kWidest);
    joint.enableMotor = value.Member("enableMotor").Bool(false);
    joint.motorSpeed = value.Member("motorSpeed").Number(0.0f, -kFastest, kFastest);
    joint.maxMotorTorque = value.Member("maxMotorTorque").Number(0.0f, 0.0f, kStrongest);
    return joint;
}

RubeDistance ReadDistance(const JsonValue& value)
{
    RubeDistance joint;
    joint.length = value.Member("length").Number(0.0f, 0.0f, kFarthest);
    joint.frequency = value.Member("frequency").Number(0.0f, 0.0f, kLargest);
    joint.dampingRatio = value.Member("dampingRatio").Number(0.0f, 0.0f, kLargest);
    return joint;
}

// Old files call it localAxis1.
b2Vec2 ReadAxis(const JsonValue& value)
{
    const JsonValue axis = value.Member("localAxisA");
    return ReadVector(axis.Exists() ? axis : value.Member("localAxis1"));
}

RubePrismatic ReadPrismatic(const JsonValue& value)
{
    RubePrismatic joint;
    joint.axis = ReadAxis(value);
    joint.referenceAngle = value.Member("refAngle").Number(0.0f, -kWidest, kWidest);
    joint.enableLimit = value.Member("enableLimit").Bool(false);
    joint.lowerLimit = value.Member("lowerLimit").Number(0.0f, -kFarthest, kFarthest);
    joint.upperLimit = value.Member("upperLimit").Number(0.0f, -kFarthest, kFarthest);
    joint.enableMotor = value.Member("enableMotor").Bool(false);
    joint.motorSpeed = value.Member("motorSpeed").Number(0.0f, -kFastest, kFastest);
    joint.maxMotorForce = value.Member("maxMotorForce").Number(0.0f, 0.0f, kStrongest);
    return joint;
}

RubePulley ReadPulley(const JsonValue& value)
{
    RubePulley joint;
    joint.groundAnchorA = ReadVector(value.Member("groundAnchorA"));
    joint.groundAnchorB = ReadVector(value.Member("groundAnchorB"));
    joint.lengthA = value.Member("lengthA").Number(0.0f, 0.0f, kFarthest);
    joint.lengthB = value.Member("lengthB").Number(0.0f, 0.0f, kFarthest);
    joint.ratio = value.Member("ratio").Number(1.0f, 0.0f, kLargest);
    return joint;
}

RubeMouse ReadMouse(const JsonValue& value)
{
    RubeMouse joint;
    joint.target = ReadVector(value.Member("target"));
    joint.maxForce = value.Member("maxForce").Number(0.0f, 0.0f, kStrongest);
    joint.frequency = value.Member("frequency").Number(0.0f, 0.0f, kLargest);
    joint.dampingRatio = value.Member("dampingRatio").Number(0.0f, 0.0f, kLargest);
    return joint;
}

RubeGear ReadGear(const JsonValue& value)
{
    constexpr std::int64_t kMost = 1'000'000'000; // whether there is such a joint is asked later
    RubeGear joint;
    joint.joint1 = static_cast<std::size_t>(value.Required("joint1").Integer(0, 0, kMost));
    joint.joint2 = static_cast<std::size_t>(value.Required("joint2").Integer(0, 0, kMost));
    joint.ratio = value.Member("ratio").Number(1.0f, -kLargest, kLargest);
    return joint;
}

RubeWheel ReadWheel(const JsonValue& value)
{
    RubeWheel joint;
    joint.axis = ReadAxis(value);
    joint.enableMotor = value.Member("enableMotor").Bool(false);
    joint.motorSpeed = value.Member("motorSpeed").Number(0.0f, -kFastest, kFastest);
    joint.maxMotorTorque = value.Member("maxMotorTorque").Number(0.0f, 0.0f, kStrongest);
    joint.frequency = value.Member("springFrequency").Number(0.0f, 0.0f, kLargest);
    joint.dampingRatio = value.Member("springDampingRatio").Number(0.0f, 0.0f, kLargest);
    return joint;
}

RubeMotor ReadMotor(const JsonValue& value)
{
    RubeMotor joint;
    // Old files have it where other joints have their anchor.
    const JsonValue offset = value.Member("linearOffset");
    joint.linearOffset = ReadVector(offset.Exists() ? offset : value.Member("anchorA"));
    joint.angularOffset = value.Member("refAngle").Number(0.0f, -kWidest, kWidest);
    joint.maxForce = value.Member("maxForce").Number(0.0f, 0.0f, kStrongest);
    joint.maxTorque = value.Member("maxTorque").Number(0.0f, 0.0f, kStrongest);
    joint.correctionFactor = value.Member("correctionFactor").Number(0.3f, 0.0f, 1.0f);
    return joint;
}

RubeWeld ReadWeld(const JsonValue& value)
{
    RubeWeld joint;
    joint.referenceAngle = value.Member("refAngle").Number(0.0f, -kWidest, kWidest);
    joint.frequency = value.Member("frequency").Number(0.0f, 0.0f, kLargest);
    joint.dampingRatio = value.Member("dampingRatio").Number(0.0f, 0.0f, kLargest);
    return joint;
}

RubeFriction ReadFriction(const JsonValue& value)
{
    RubeFriction joint;
    joint.maxForce = value.Member("maxForce").Number(0.0f, 0.0f, kStrongest);
    joint.maxTorque = value.Member("maxTorque").Number(0.0f, 0.0f, kStrongest);
    return joint;
}

RubeRope ReadRope(const JsonValue& value)
{
    return RubeRope{value.Member("maxLength").Number(0.0f, 0.0f, kFarthest)};
}

/// Reads the details of a joint; none for an unknown type.
decltype(RubeJoint::details) ReadDetails(const std::string& type, const JsonValue& value)
{
    using Details = decltype(RubeJoint::details);
    using Reader = Details (*)(const JsonValue&);
    static const std::pair<std::string_view, Reader> kReaders[] = {
        {"revolute", [](const JsonValue& v) { return Details(ReadRevolute(v)); }},
        {"distance", [](const JsonValue& v) { return Details(ReadDistance(v)); }},
        {"prismatic", [](const JsonValue& v) { return Details(ReadPrismatic(v)); }},
        {"pulley", [](const JsonValue& v) { return Details(ReadPulley(v)); }},
        {"mouse", [](const JsonValue& v) { return Details(ReadMouse(v)); }},
        {"gear", [](const JsonValue& v) { return Details(ReadGear(v)); }},
        {"wheel", [](const JsonValue& v) { return Details(ReadWheel(v)); }},
        {"motor", [](const JsonValue& v) { return Details(ReadMotor(v)); }},
        {"weld", [](const JsonValue& v) { return Details(ReadWeld(v)); }},
        {"friction", [](const JsonValue& v) { return Details(ReadFriction(v)); }},
        {"rope", [](const JsonValue& v) { return Details(ReadRope(v)); }}};
    for (const auto& [name, read] : kReaders)
    {
        if (name == type)
        {
            return read(value);
        }
    }
    return {};
}

std::size_t ReadBodyIndex(const JsonValue& joint, const char* name, std::size_t bodyCount)
{
    const JsonValue index = joint.Required(name);
    if (bodyCount == 0)
    {
        index.Complain("names a body, but the file has none");
        return 0;
    }
    return static_cast<std::size_t>(index.Integer(0, 0, static_cast<std::int64_t>(bodyCount) - 1));
}

RubeJoint ReadJoint(const JsonValue& value, std::size_t bodyCount)
{
    RubeJoint joint;
    joint.type = value.Required("type").Text();
    joint.name = value.Member("name").Text();
    joint.bodyA = ReadBodyIndex(value, "bodyA", bodyCount);
    joint.bodyB = ReadBodyIndex(value, "bodyB", bodyCount);
    joint.collideConnected = value.Member("collideConnected").Bool(false);
    joint.anchorA = ReadVector(value.Member("anchorA"));
    joint.anchorB = ReadVector(value.Member("anchorB"));
    joint.details = ReadDetails(joint.type, value);
    joint.properties = value.Member("customProperties").Raw();
    return joint;
}

RubeImage ReadImage(const JsonValue& value, std::size_t bodyCount)
{
    RubeImage image;
    image.text = value.Raw();
    image.file = value.Member("file").Text();
    const std::int64_t body =
        value.Member("body").Integer(-1, -1, static_cast<std::int64_t>(bodyCount) - 1);
    if (body >= 0)
    {
        image.body = static_cast<std::size_t>(body);
    }
    image.center = ReadVector(value.Member("center"));
    image.angle = value.Member("angle").Number(0.0f, -kWidest, kWidest);
    if (const JsonValue corners = value.Member("corners"); corners.Exists())
    {
        const std::vector<b2Vec2> points = ReadVertices(corners);
        if (points.size() == 4)
        {
            image.corners = {points[0], points[1], points[2], points[3]};
        }
    }
    return image;
}

void ReadWorld(const JsonValue& value, RubeScene& scene)
{
    scene.gravity = ReadVector(value.Member("gravity"), kLargest);
    scene.allowSleep = value.Member("allowSleep").Bool(true);
    scene.autoClearForces = value.Member("autoClearForces").Bool(true);
    scene.warmStarting = value.Member("warmStarting").Bool(true);
    scene.continuousPhysics = value.Member("continuousPhysics").Bool(true);
    scene.subStepping = value.Member("subStepping").Bool(false);
    scene.stepsPerSecond = value.Member("stepsPerSecond").Number(60.0f, 1.0f, 100000.0f);
    scene.velocityIterations =
        static_cast<int32>(value.Member("velocityIterations").Integer(8, 1, 1000));
    scene.positionIterations =
        static_cast<int32>(value.Member("positionIterations").Integer(3, 1, 1000));
}

} // namespace

bool IsReadableMass(const b2MassData& data)
{
    const auto isWithin = [](float32 value, float32 minimum, float32 maximum) {
        return value >= minimum && value <= maximum;
    };
    return data.mass > 0.0f && isWithin(data.mass, 0.0f, kStrongest) &&
           isWithin(data.I, 0.0f, kStiffest) && isWithin(data.center.x, -kFarthest, kFarthest) &&
           isWithin(data.center.y, -kFarthest, kFarthest);
}

Result<RubeScene> ParseRubeScene(std::string_view text, const std::string& source)
{
    ASSIGN_OR_RETURN(const JsonDocument document, JsonDocument::Parse(text, source));
    const JsonValue root = document.Root();
    RubeScene scene;
    ReadWorld(root, scene);
    // Without this, every JSON object would be read as an empty scene.
    const JsonValue bodies = root.Required("body");
    for (std::size_t i = 0; i < bodies.Count() && !root.IsHopeless(); ++i)
    {
        scene.bodies.push_back(ReadBody(bodies.Item(i)));
    }
    const JsonValue joints = root.Member("joint");
    for (std::size_t i = 0; i < joints.Count() && !root.IsHopeless(); ++i)
    {
        scene.joints.push_back(ReadJoint(joints.Item(i), scene.bodies.size()));
    }
    const JsonValue images = root.Member("image");
    for (std::size_t i = 0; i < images.Count() && !root.IsHopeless(); ++i)
    {
        scene.images.push_back(ReadImage(images.Item(i), scene.bodies.size()));
    }
    scene.properties = root.Member("customProperties").Raw();
    if (document.Complaint())
    {
        return *document.Complaint();
    }
    return scene;
}

} // namespace boxreel
