// SPDX-License-Identifier: MIT
#include "RubeText.h"

#include "RubeFields.h"
#include "RubeJson.h"

#include <base/ErrorMacros.h>

#include <cstdint>

namespace boxreel
{

namespace
{

constexpr float32 kStiffest =
    1e25f; ///< rotational inertia: maximum mass at maximum distance [kg m^2]

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

/// Sets each member that VisitFields names to its value in a JSON object.
class FieldReader
{
public:
    explicit FieldReader(const JsonValue& object) : m_object(object) {}

    void operator()(const char* name, bool& member, bool fallback, const auto&) const
    {
        member = m_object.Member(name).Bool(fallback);
    }

    template <class Number>
    void operator()(const char* name, Number& member, const RubeRange& range, const auto&) const
    {
        const JsonValue value = Find(name, range);
        if constexpr (std::is_same_v<Number, b2Vec2>)
        {
            member = ReadVector(value, range.maximum);
        }
        else if constexpr (std::is_same_v<Number, float32>)
        {
            member = value.Number(range.fallback, range.minimum, range.maximum);
        }
        else
        {
            member = static_cast<Number>(value.Integer(std::int64_t(range.fallback),
                                                       std::int64_t(range.minimum),
                                                       std::int64_t(range.maximum)));
        }
    }

private:
    JsonValue Find(const char* name, const RubeRange& range) const
    {
        const JsonValue value = range.isRequired ? m_object.Required(name) : m_object.Member(name);
        return value.Exists() || range.oldName == nullptr ? value : m_object.Member(range.oldName);
    }

    const JsonValue& m_object;
};

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
    VisitFields(fixture, FieldReader(value));
    if (const JsonValue circle = value.Member("circle"); circle.Exists())
    {
        fixture.geometry = ReadCircle(circle);
    }
    else if (const JsonValue edge = value.Member("edge"); edge.Exists())
    {
        fixture.geometry = ReadEdge(edge);
    }
    else if (const JsonValue chain = value.Member("chain"); chain.Exists())
    {
        fixture.geometry = ReadChain(chain, false);
    }
    else if (const JsonValue loop = value.Member("loop"); loop.Exists())
    {
        fixture.geometry = ReadChain(loop, true);
    }
    else if (const JsonValue polygon = value.Member("polygon"); polygon.Exists())
    {
        RubePolygon said{ReadVertices(polygon.Required("vertices"))};
        if (const JsonValue normals = polygon.Member("normals"); normals.Exists())
        {
            said.normals = ReadVertices(normals);
        }
        fixture.geometry = std::move(said);
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
    VisitFields(body, FieldReader(value));
    body.massData = ReadMassData(value);

    body.properties = value.Member("customProperties").Raw();
    const JsonValue fixtures = value.Member("fixture");
    for (std::size_t i = 0; i < fixtures.Count() && !value.IsHopeless(); ++i)
    {
        body.fixtures.push_back(ReadFixture(fixtures.Item(i)));
    }
    return body;
}

/// Reads the details of a joint; none for an unknown type.
RubeDetails ReadDetails(const std::string& type, const JsonValue& value)
{
    for (const RubeKindName& kind : kRubeKinds)
    {
        if (kind.name == type)
        {
            RubeDetails details = kind.empty;
            std::visit([&](auto& joint) { VisitFields(joint, FieldReader(value)); }, details);
            return details;
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
    image.angle = value.Member("angle").Number(0.0f, kAngle.minimum, kAngle.maximum);
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
    VisitFields(scene, FieldReader(root));
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
