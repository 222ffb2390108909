// SPDX-License-Identifier: MIT
#include "RubeWriter.h"

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
    object["density"] = Number(fixture.density);
    object["friction"] = Number(fixture.friction);
    object["restitution"] = Number(fixture.restitution);
    if (fixture.isSensor)
    {
        object["sensor"] = true;
    }
    if (fixture.categoryBits != 1)
    {
        object["filter-categoryBits"] = fixture.categoryBits;
    }
    if (fixture.maskBits != 65535)
    {
        object["filter-maskBits"] = fixture.maskBits;
    }
    if (fixture.groupIndex != 0)
    {
        object["filter-groupIndex"] = fixture.groupIndex;
    }
    std::visit([&object](const auto& shape) { AddShape(object, shape); }, fixture.shape);
    AddProperties(object, fixture.properties);
    return object;
}

Json Body(const RubeBody& body)
{
    Json object = Json::object();
    AddName(object, body.name);
    object["type"] = static_cast<int>(body.type);
    object["position"] = Vector(body.position);
    object["angle"] = Number(body.angle);
    object["linearVelocity"] = Vector(body.linearVelocity);
    object["angularVelocity"] = Number(body.angularVelocity);
    object["linearDamping"] = Number(body.linearDamping);
    object["angularDamping"] = Number(body.angularDamping);
    object["gravityScale"] = Number(body.gravityScale);
    object["bullet"] = body.isBullet;
    object["allowSleep"] = body.allowSleep;
    object["awake"] = body.isAwake;
    object["active"] = body.isActive;
    object["fixedRotation"] = body.fixedRotation;
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

void AddDetails(Json&, std::monostate) {}

/// Adds limit and motor of revolute and prismatic joints.
void AddLimitAndMotor(Json& object, const auto& joint)
{
    object["refAngle"] = Number(joint.referenceAngle);
    object["enableLimit"] = joint.enableLimit;
    object["lowerLimit"] = Number(joint.lowerLimit);
    object["upperLimit"] = Number(joint.upperLimit);
    object["enableMotor"] = joint.enableMotor;
    object["motorSpeed"] = Number(joint.motorSpeed);
}

void AddSpring(Json& object, const auto& joint)
{
    object["frequency"] = Number(joint.frequency);
    object["dampingRatio"] = Number(joint.dampingRatio);
}

void AddDetails(Json& object, const RubeRevolute& joint)
{
    AddLimitAndMotor(object, joint);
    object["maxMotorTorque"] = Number(joint.maxMotorTorque);
}

void AddDetails(Json& object, const RubeDistance& joint)
{
    object["length"] = Number(joint.length);
    AddSpring(object, joint);
}

void AddDetails(Json& object, const RubePrismatic& joint)
{
    object["localAxisA"] = Vector(joint.axis);
    AddLimitAndMotor(object, joint);
    object["maxMotorForce"] = Number(joint.maxMotorForce);
}

void AddDetails(Json& object, const RubePulley& joint)
{
    object["groundAnchorA"] = Vector(joint.groundAnchorA);
    object["groundAnchorB"] = Vector(joint.groundAnchorB);
    object["lengthA"] = Number(joint.lengthA);
    object["lengthB"] = Number(joint.lengthB);
    object["ratio"] = Number(joint.ratio);
}

void AddDetails(Json& object, const RubeMouse& joint)
{
    object["target"] = Vector(joint.target);
    object["maxForce"] = Number(joint.maxForce);
    AddSpring(object, joint);
}

void AddDetails(Json& object, const RubeGear& joint)
{
    object["joint1"] = joint.joint1;
    object["joint2"] = joint.joint2;
    object["ratio"] = Number(joint.ratio);
}

void AddDetails(Json& object, const RubeWheel& joint)
{
    object["localAxisA"] = Vector(joint.axis);
    object["enableMotor"] = joint.enableMotor;
    object["motorSpeed"] = Number(joint.motorSpeed);
    object["maxMotorTorque"] = Number(joint.maxMotorTorque);
    object["springFrequency"] = Number(joint.frequency);
    object["springDampingRatio"] = Number(joint.dampingRatio);
}

void AddDetails(Json& object, const RubeMotor& joint)
{
    object["linearOffset"] = Vector(joint.linearOffset);
    object["refAngle"] = Number(joint.angularOffset);
    object["maxForce"] = Number(joint.maxForce);
    object["maxTorque"] = Number(joint.maxTorque);
    object["correctionFactor"] = Number(joint.correctionFactor);
}

void AddDetails(Json& object, const RubeWeld& joint)
{
    object["refAngle"] = Number(joint.referenceAngle);
    AddSpring(object, joint);
}

void AddDetails(Json& object, const RubeFriction& joint)
{
    object["maxForce"] = Number(joint.maxForce);
    object["maxTorque"] = Number(joint.maxTorque);
}

void AddDetails(Json& object, const RubeRope& joint)
{
    object["maxLength"] = Number(joint.maxLength);
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
    std::visit([&object](const auto& details) { AddDetails(object, details); }, joint.details);
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
    root["gravity"] = Vector(scene.gravity);
    root["allowSleep"] = scene.allowSleep;
    root["autoClearForces"] = scene.autoClearForces;
    root["warmStarting"] = scene.warmStarting;
    root["continuousPhysics"] = scene.continuousPhysics;
    root["subStepping"] = scene.subStepping;
    root["stepsPerSecond"] = Number(scene.stepsPerSecond);
    root["velocityIterations"] = scene.velocityIterations;
    root["positionIterations"] = scene.positionIterations;
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
