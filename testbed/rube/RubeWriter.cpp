// SPDX-License-Identifier: MIT
#include "RubeWriter.h"

#include "RubeFields.h"

#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace boxreel
{

namespace
{

using Json = nlohmann::ordered_json;

/// Writes 0 and 1 as integers, and other numbers with the fewest digits that identify the float.
/// Numbers without a decimal form (-0, or if reading via a double rounds differently) are written
/// as hex digits of their bits.
Json Number(float32 value)
{
    if (value == 1.0f || (value == 0.0f && !std::signbit(value)))
    {
        return Json(value == 1.0f ? 1 : 0);
    }
    std::array<char, 32> text{};
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double number = 0.0;
    (void)std::from_chars(text.data(), end, number);
    if (static_cast<float32>(number) == value && value != 0.0f)
    {
        return Json(number);
    }
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08X", std::bit_cast<std::uint32_t>(value));
    return Json(digits);
}

bool IsZero(const b2Vec2& v)
{
    return v == b2Vec2_zero && !std::signbit(v.x) && !std::signbit(v.y);
}

Json Vector(const b2Vec2& v)
{
    return IsZero(v) ? Json(0) : Json{{"x", Number(v.x)}, {"y", Number(v.y)}};
}

Json Vertices(const std::vector<b2Vec2>& vertices)
{
    Json xs = Json::array();
    Json ys = Json::array();
    for (const b2Vec2& vertex : vertices)
    {
        xs.push_back(Number(vertex.x));
        ys.push_back(Number(vertex.y));
    }
    return {{"x", std::move(xs)}, {"y", std::move(ys)}};
}

/// Which members an object gets.
enum class Fields
{
    All,
    Needed, ///< a yes or an integer only if it is not the default
};

/// Adds the members that VisitFields names to a JSON object.
class FieldWriter
{
public:
    FieldWriter(Json& object, Fields fields) : m_object(object), m_fields(fields) {}

    void operator()(const char* name, float32 member, const RubeRange&, const auto&) const
    {
        m_object[name] = Number(member);
    }

    void operator()(const char* name, const b2Vec2& member, const RubeRange&, const auto&) const
    {
        m_object[name] = Vector(member);
    }

    void operator()(const char* name, bool member, bool fallback, const auto&) const
    {
        if (m_fields == Fields::All || member != fallback)
        {
            m_object[name] = member;
        }
    }

    void operator()(const char* name, auto member, const RubeRange& range, const auto&) const
    {
        if (m_fields == Fields::All || std::int64_t(member) != std::int64_t(range.fallback))
        {
            m_object[name] = std::int64_t(member);
        }
    }

private:
    Json& m_object;
    Fields m_fields;
};

/// `part` is a copy, because VisitFields names members that can be set.
template <class Part>
void AddFields(Json& object, Part part, Fields fields = Fields::All)
{
    VisitFields(part, FieldWriter(object, fields));
}

void AddName(Json& object, const std::string& name)
{
    if (!name.empty())
    {
        object["name"] = name;
    }
}

void AddProperties(Json& object, const std::string& properties)
{
    if (!properties.empty())
    {
        object["customProperties"] = Json::parse(properties, nullptr, false);
    }
}

void AddShape(Json&, std::monostate) {}

void AddShape(Json& fixture, const RubeCircle& circle)
{
    fixture["circle"] = {{"center", Vector(circle.center)}, {"radius", Number(circle.radius)}};
}

void AddShape(Json& fixture, const RubeEdge& edge)
{
    Json shape{{"vertex1", Vector(edge.vertex1)}, {"vertex2", Vector(edge.vertex2)}};
    if (edge.vertex0)
    {
        shape["hasVertex0"] = true;
        shape["vertex0"] = Vector(*edge.vertex0);
    }
    if (edge.vertex3)
    {
        shape["hasVertex3"] = true;
        shape["vertex3"] = Vector(*edge.vertex3);
    }
    fixture["edge"] = std::move(shape);
}

void AddShape(Json& fixture, const RubeChain& chain)
{
    Json shape{{"vertices", Vertices(chain.vertices)}};
    if (chain.previous)
    {
        shape["hasPrevVertex"] = true;
        shape["prevVertex"] = Vector(*chain.previous);
    }
    if (chain.next)
    {
        shape["hasNextVertex"] = true;
        shape["nextVertex"] = Vector(*chain.next);
    }
    fixture[chain.isLoop ? "loop" : "chain"] = std::move(shape);
}

void AddShape(Json& fixture, const RubePolygon& polygon)
{
    fixture["polygon"] = {{"vertices", Vertices(polygon.vertices)}};
    if (!polygon.normals.empty())
    {
        fixture["polygon"]["normals"] = Vertices(polygon.normals);
    }
}

Json Fixture(const RubeFixture& fixture)
{
    Json object = Json::object();
    AddName(object, fixture.name);
    AddFields<b2FixtureDef>(object, fixture, Fields::Needed);
    std::visit([&object](const auto& shape) { AddShape(object, shape); }, fixture.geometry);
    AddProperties(object, fixture.properties);
    return object;
}

Json Body(const RubeBody& body)
{
    Json object = Json::object();
    AddName(object, body.name);
    AddFields<b2BodyDef>(object, body);
    if (body.massData)
    {
        object["massData-mass"] = Number(body.massData->mass);
        object["massData-center"] = Vector(body.massData->center);
        object["massData-I"] = Number(body.massData->I);
    }
    if (!body.fixtures.empty())
    {
        Json fixtures = Json::array();
        for (const RubeFixture& fixture : body.fixtures)
        {
            fixtures.push_back(Fixture(fixture));
        }
        object["fixture"] = std::move(fixtures);
    }
    AddProperties(object, body.properties);
    return object;
}

Json Joint(const RubeJoint& joint)
{
    Json object{{"type", joint.type}};
    AddName(object, joint.name);
    object["bodyA"] = joint.bodyA;
    object["bodyB"] = joint.bodyB;
    object["collideConnected"] = joint.collideConnected;
    object["anchorA"] = Vector(joint.anchorA);
    object["anchorB"] = Vector(joint.anchorB);
    std::visit([&object](const auto& details) { AddFields(object, details); }, joint.details);
    AddProperties(object, joint.properties);
    return object;
}

Json List(const auto& parts, const auto& text)
{
    Json list = Json::array();
    for (const auto& part : parts)
    {
        list.push_back(text(part));
    }
    return list;
}

} // namespace

std::string WriteRubeText(const RubeScene& scene)
{
    Json root = Json::object();
    AddFields<RubeWorld>(root, scene);
    root["body"] = List(scene.bodies, Body);
    root["joint"] = List(scene.joints, Joint);
    if (!scene.images.empty())
    {
        root["image"] = List(scene.images, [](const RubeImage& image) {
            return Json::parse(image.text, nullptr, false);
        });
    }
    AddProperties(root, scene.properties);
    // Names may contain any bytes. Invalid UTF-8 becomes U+FFFD.
    return root.dump(1, '\t', false, Json::error_handler_t::replace) + "\n";
}

} // namespace boxreel
