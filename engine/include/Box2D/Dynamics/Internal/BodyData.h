// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <cstdint>

class b2Body;
class b2Fixture;
struct b2ContactEdge;
struct b2JointEdge;

/// What the engine keeps of a body. b2Body is the public face of it; the parts of the engine pass
/// BodyData around. Not for programs that use the engine.
namespace box2d
{

class World;

enum BodyFlag : std::uint32_t
{
    kBodyAwake = 1u << 0,
    kBodyAutoSleep = 1u << 1,
    kBodyBullet = 1u << 2,
    kBodyFixedRotation = 1u << 3,
    kBodyActive = 1u << 4,
    kBodyMassSet = 1u << 5, ///< by SetMassData, not by the fixtures
    kBodySwept = 1u << 6,   ///< a fast bullet: its boxes hold its last way and no more
};

/// The mobility of a body, with the values of b2BodyType.
enum class Mobility : std::uint8_t
{
    Static = 0,
    Kinematic = 1,
    Dynamic = 2,
};

/// Centre of mass and angle, in more than single precision, so that a slow body far from the origin
/// still moves. [m], [rad]
struct Pose
{
    double x = 0.0;
    double y = 0.0;
    double angle = 0.0;
};

struct BodyData
{
    // What every contact of the body reads, in one cache line.
    Pose pose;                    ///< of the centre of mass
    b2Rot rotation;               ///< sine and cosine of pose.angle
    b2Vec2 localCenter;           ///< centre of mass in the body's frame
    float32 invMass = 0.0f;       ///< 0: infinite mass
    float32 invInertia = 0.0f;    ///< about the centre of mass
    float32 maxExtent = 0.0f;     ///< farthest point from the centre of mass [m]
    std::int32_t awakeIndex = -1; ///< place among the awake bodies, -1 when asleep or static
    std::uint32_t flags = 0;
    Mobility mobility = Mobility::Static;

    // What a step reads and writes.
    b2Vec2 linearVelocity; ///< of the centre of mass [m/s]
    float32 angularVelocity = 0.0f;
    b2Vec2 force; ///< at the centre of mass [N]
    float32 torque = 0.0f;
    float32 gravityScale = 1.0f;
    float32 linearDamping = 0.0f;
    float32 angularDamping = 0.0f;
    float32 sleepTime = 0.0f; ///< how long it has been slow [s]

    // The way of the last step, for continuous collision: from `previous` at `sweepStart` to `pose`
    // at its end.
    Pose previous;
    float32 sweepStart = 0.0f;      ///< fraction of the step, 0 to 1
    std::uint32_t sweepVersion = 0; ///< changes whenever the way does
    float32 minExtent = 0.0f; ///< radius of the thinnest fixture [m]: farther in one step is fast
    float32 room = 0.0f;      ///< how far any point may move before a box must be looked at [m]

    std::uint32_t colorMask = 0; ///< the colours of the constraint graph that touch it
    std::int32_t island = -1;    ///< dynamic and active bodies only
    /// While the joints' schedule is made the first level that is free, while a system's pattern is
    /// made its place there.
    mutable std::int32_t jointLevel = 0;
    float32 energyOwed = 0.0f;  ///< its share of what its island has won, see EnergyGuard [J]
    float32 energyScale = 0.0f; ///< its largest kinetic energy of late, while it has joints [J]
    std::uint32_t movedAt = 0;  ///< World::stepNumber when the program last moved it by hand
    b2Body* islandPrev = nullptr;
    b2Body* islandNext = nullptr;

    // What the user sees.
    b2Transform transform; ///< of the body's origin
    b2Vec2 worldCenter;    ///< pose in single precision
    float32 mass = 0.0f;
    float32 inertia = 0.0f; ///< about the centre of mass

    b2Fixture* fixtureList = nullptr;
    std::int32_t fixtureCount = 0;
    b2JointEdge* jointList = nullptr;
    b2ContactEdge* contactList = nullptr;
    b2Body* prev = nullptr;
    b2Body* next = nullptr;
    World* world = nullptr;
    void* userData = nullptr;
    std::int32_t number = 0; ///< in order of creation, never used again
    std::int32_t place = 0;  ///< in the list of a snapshot while that is made or read

    bool IsAwake() const { return (flags & kBodyAwake) != 0; }
    bool IsActive() const { return (flags & kBodyActive) != 0; }
    bool IsDynamic() const { return mobility == Mobility::Dynamic; }
    /// Its place in the solver's array; 0 stands for everything that does not move.
    std::int32_t SolverIndex() const { return awakeIndex + 1; }
    /// What does not take part in the step cannot be pushed, whatever its mass.
    float32 SolverInvMass() const { return awakeIndex == -1 ? 0.0f : invMass; }
    float32 SolverInvInertia() const { return awakeIndex == -1 ? 0.0f : invInertia; }
};

} // namespace box2d
