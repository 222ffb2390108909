// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// The content of a R.U.B.E. / b2dJson scene file as plain data, written by the reader (RubeText.h)
/// and read by the builder (RubeBuilder.h). The defaults are those of the format, which sometimes
/// differ from the engine's. Numbers are finite and within the reader's limits, and indices are
/// valid. Some shapes may still be impossible to build.
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

struct RubeFixture
{
    std::string name;
    float32 restitution = 0.0f;
    float32 friction = 0.0f;
    float32 density = 0.0f; ///< [kg/m^2]
    bool isSensor = false;
    uint16 categoryBits = 1;
    uint16 maskBits = 65535;
    int16 groupIndex = 0;
    std::variant<std::monostate, RubeCircle, RubeEdge, RubeChain, RubePolygon> shape;
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

struct RubeBody
{
    std::string name;
    b2BodyType type = b2_staticBody;
    b2Vec2 position = b2Vec2(0.0f, 0.0f); ///< [m]
    float32 angle = 0.0f;                 ///< [rad]
    b2Vec2 linearVelocity = b2Vec2(0.0f, 0.0f);
    float32 angularVelocity = 0.0f;
    float32 linearDamping = 0.0f;
    float32 angularDamping = 0.0f;
    float32 gravityScale = 1.0f;
    bool isBullet = false;
    bool allowSleep = true;
    bool isAwake = false;
    bool isActive = true;
    bool fixedRotation = false;
    std::optional<b2MassData>
        massData; ///< only when the file gives a mass; I about the body's origin
    std::vector<RubeFixture> fixtures;
    std::string properties; ///< as of a fixture
};

struct RubeRevolute
{
    float32 referenceAngle = 0.0f; ///< [rad]
    bool enableLimit = false;
    float32 lowerLimit = 0.0f; ///< [rad]
    float32 upperLimit = 0.0f; ///< [rad]
    bool enableMotor = false;
    float32 motorSpeed = 0.0f;     ///< [rad/s]
    float32 maxMotorTorque = 0.0f; ///< [N m]
};

struct RubeDistance
{
    float32 length = 0.0f;    ///< [m]
    float32 frequency = 0.0f; ///< of the spring [Hz], 0 is rigid
    float32 dampingRatio = 0.0f;
};

struct RubePrismatic
{
    b2Vec2 axis = b2Vec2(1.0f, 0.0f); ///< in body A's frame, of any length
    float32 referenceAngle = 0.0f;    ///< [rad]
    bool enableLimit = false;
    float32 lowerLimit = 0.0f; ///< [m]
    float32 upperLimit = 0.0f; ///< [m]
    bool enableMotor = false;
    float32 motorSpeed = 0.0f;    ///< [m/s]
    float32 maxMotorForce = 0.0f; ///< [N]
};

struct RubePulley
{
    b2Vec2 groundAnchorA = b2Vec2(0.0f, 0.0f); ///< in the world, as that of B [m]
    b2Vec2 groundAnchorB = b2Vec2(0.0f, 0.0f);
    float32 lengthA = 0.0f; ///< [m]
    float32 lengthB = 0.0f; ///< [m]
    float32 ratio = 1.0f;
};

/// Pulls body B at the point of the world that the joint gives as its anchor B.
struct RubeMouse
{
    b2Vec2 target = b2Vec2(0.0f, 0.0f); ///< in the world [m]
    float32 maxForce = 0.0f;            ///< [N]
    float32 frequency = 0.0f;           ///< [Hz]
    float32 dampingRatio = 0.0f;
};

struct RubeGear
{
    std::size_t joint1 = 0; ///< index into RubeScene::joints, which may not have so many
    std::size_t joint2 = 0;
    float32 ratio = 1.0f;
};

struct RubeWheel
{
    b2Vec2 axis = b2Vec2(1.0f, 0.0f); ///< in body A's frame, of any length
    bool enableMotor = false;
    float32 motorSpeed = 0.0f;     ///< [rad/s]
    float32 maxMotorTorque = 0.0f; ///< [N m]
    float32 frequency = 0.0f;      ///< of the spring [Hz], 0: none
    float32 dampingRatio = 0.0f;
};

struct RubeMotor
{
    b2Vec2 linearOffset = b2Vec2(0.0f, 0.0f); ///< body B's origin in body A's frame [m]
    float32 angularOffset = 0.0f;             ///< [rad]
    float32 maxForce = 0.0f;                  ///< [N]
    float32 maxTorque = 0.0f;                 ///< [N m]
    float32 correctionFactor = 0.3f;          ///< 0 to 1
};

struct RubeWeld
{
    float32 referenceAngle = 0.0f; ///< [rad]
    float32 frequency = 0.0f;      ///< against turning [Hz], 0 is rigid
    float32 dampingRatio = 0.0f;
};

struct RubeFriction
{
    float32 maxForce = 0.0f;  ///< [N]
    float32 maxTorque = 0.0f; ///< [N m]
};

struct RubeRope
{
    float32 maxLength = 0.0f; ///< [m]
};

struct RubeJoint
{
    std::string type; ///< as the file spells it
    std::string name;
    std::size_t bodyA = 0; ///< index into RubeScene::bodies
    std::size_t bodyB = 0;
    bool collideConnected = false;
    b2Vec2 anchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 anchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    /// Nothing for other kinds.
    std::variant<std::monostate, RubeRevolute, RubeDistance, RubePrismatic, RubePulley, RubeMouse,
                 RubeGear, RubeWheel, RubeMotor, RubeWeld, RubeFriction, RubeRope>
        details;
    std::string properties; ///< as of a fixture
};

struct RubeScene
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
    std::vector<RubeBody> bodies;
    std::vector<RubeJoint> joints;
    std::vector<RubeImage> images;
    std::string properties; ///< as of a fixture
};

} // namespace boxreel
