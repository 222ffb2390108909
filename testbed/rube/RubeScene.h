// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// The content of a R.U.B.E. / b2dJson scene file as plain data, written by the reader (RubeText.h)
/// and read by the builder (RubeBuilder.h). Bodies, fixtures and joints contain the engine's
/// definitions; the reader sets the members that RubeFields.h lists, which have other defaults in
/// the format. Numbers are finite and within the limits of RubeFields.h, and indices are valid.
/// Some shapes may still be impossible to build.
namespace boxreel
{

struct RubeCircle
{
    b2Vec2 center = b2Vec2(0.0f, 0.0f); ///< in the body's frame, as all points of shapes [m]
    float32 radius = 0.0f;              ///< [m]
};

struct RubeEdge
{
    b2Vec2 vertex1 = b2Vec2(0.0f, 0.0f);
    b2Vec2 vertex2 = b2Vec2(0.0f, 0.0f);
    std::optional<b2Vec2> vertex0; ///< ghost vertex before the edge
    std::optional<b2Vec2> vertex3; ///< ghost vertex behind the edge
};

struct RubeChain
{
    std::vector<b2Vec2> vertices;
    bool isLoop = false; ///< old files: closed without repeating the first vertex
    std::optional<b2Vec2> previous;
    std::optional<b2Vec2> next;
};

struct RubePolygon
{
    std::vector<b2Vec2> vertices; ///< two of them mean an edge
    /// Normals of the edges, an extension of the format. Empty if all of them are exactly, to the
    /// last bit, the normals computed from the vertices.
    std::vector<b2Vec2> normals = {};
};

struct RubeFixture : b2FixtureDef
{
    std::string name;
    std::variant<std::monostate, RubeCircle, RubeEdge, RubeChain, RubePolygon> geometry;
    std::string properties; ///< JSON text of what the engine has no use for; empty: none
};

/// A picture of a body. The image file is not read; its outline can be drawn.
struct RubeImage
{
    std::string text;                   ///< all of it, as JSON
    std::string file;                   ///< of the picture
    std::optional<std::size_t> body;    ///< index into RubeScene::bodies; none: of the world
    b2Vec2 center = b2Vec2(0.0f, 0.0f); ///< in the body's frame [m]
    float32 angle = 0.0f;               ///< [rad]
    std::optional<std::array<b2Vec2, 4>> corners; ///< in the body's frame [m], in turn
};

struct RubeBody : b2BodyDef
{
    std::string name;
    std::optional<b2MassData>
        massData; ///< only when the file gives a mass; I about the body's origin
    std::vector<RubeFixture> fixtures;
    std::string properties; ///< as of a fixture
};

/// A joint as the engine defines it, and its class there. The definition has the numbers of the
/// file, which the builder may refuse; its bodies and anchors are those of RubeJoint.
template <class Definition, class EngineJoint>
struct RubeKind : Definition
{
    using Joint = EngineJoint;
};

using RubeRevolute = RubeKind<b2RevoluteJointDef, b2RevoluteJoint>;
using RubeDistance = RubeKind<b2DistanceJointDef, b2DistanceJoint>;
using RubePrismatic = RubeKind<b2PrismaticJointDef, b2PrismaticJoint>; ///< axis of any length
using RubePulley = RubeKind<b2PulleyJointDef, b2PulleyJoint>;
/// Pulls body B at the point of the world that the joint gives as its anchor B.
using RubeMouse = RubeKind<b2MouseJointDef, b2MouseJoint>;
using RubeWheel = RubeKind<b2WheelJointDef, b2WheelJoint>; ///< axis of any length
using RubeMotor = RubeKind<b2MotorJointDef, b2MotorJoint>;
using RubeWeld = RubeKind<b2WeldJointDef, b2WeldJoint>;
using RubeFriction = RubeKind<b2FrictionJointDef, b2FrictionJoint>;
using RubeRope = RubeKind<b2RopeJointDef, b2RopeJoint>;

struct RubeGear : RubeKind<b2GearJointDef, b2GearJoint>
{
    std::size_t index1 = 0; ///< of joint 1 in RubeScene::joints, which may not have so many
    std::size_t index2 = 0;
};

/// Nothing for other kinds.
using RubeDetails =
    std::variant<std::monostate, RubeRevolute, RubeDistance, RubePrismatic, RubePulley, RubeMouse,
                 RubeGear, RubeWheel, RubeMotor, RubeWeld, RubeFriction, RubeRope>;

struct RubeJoint
{
    std::string type; ///< as the file spells it
    std::string name;
    std::size_t bodyA = 0; ///< index into RubeScene::bodies
    std::size_t bodyB = 0;
    bool collideConnected = false;
    b2Vec2 anchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 anchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    RubeDetails details;
    std::string properties; ///< as of a fixture
};

struct RubeWorld
{
    b2Vec2 gravity = b2Vec2(0.0f, 0.0f); ///< [m/s^2]
    bool allowSleep = true;
    bool autoClearForces = true;
    bool warmStarting = true;
    bool continuousPhysics = true;
    bool subStepping = false;
    float32 stepsPerSecond = 60.0f;
    int32 velocityIterations = 8;
    int32 positionIterations = 3;
};

struct RubeScene : RubeWorld
{
    std::vector<RubeBody> bodies;
    std::vector<RubeJoint> joints;
    std::vector<RubeImage> images;
    std::string properties; ///< as of a fixture
};

} // namespace boxreel
