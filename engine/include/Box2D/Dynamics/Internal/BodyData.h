// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <cstdint>

class b2Body;
class b2Fixture;
struct b2ContactEdge;
struct b2JointEdge;

/// The engine's data of a body. b2Body is its public interface; the parts of the engine use
/// BodyData. Internal to the engine.
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
    kBodyMassSet = 1u << 5,  ///< mass set by SetMassData, not computed from the fixtures
    kBodyPathBox = 1u << 6,  ///< a fast bullet: its boxes contain exactly its last path
    kBodyBoxMoved = 1u << 7, ///< a box has changed since contacts were last updated
};

/// The type of a body, with the values of b2BodyType.
enum class Mobility : std::uint8_t
{
    Static = 0,
    Kinematic = 1,
    Dynamic = 2,
};

/// Centre of mass [m] and angle [rad] in double precision, so that a slow body far from the origin
/// still moves.
struct Pose
{
    double x = 0.0;
    double y = 0.0;
    double angle = 0.0;
};

struct BodyData
{
    // The data that every contact of the body reads, in one cache line.
    Pose pose;                    ///< of the centre of mass
    b2Rot rotation;               ///< sine and cosine of pose.angle
    b2Vec2 localCenter;           ///< centre of mass in the body's frame
    float32 invMass = 0.0f;       ///< 0: infinite mass
    float32 invInertia = 0.0f;    ///< about the centre of mass
    float32 maxExtent = 0.0f;     ///< farthest point from the centre of mass [m]
    std::int32_t awakeIndex = -1; ///< index in the list of awake bodies, -1 when asleep or static
    std::uint32_t flags = 0;
    Mobility mobility = Mobility::Static;

    // The data that a step reads and writes.
    b2Vec2 linearVelocity; ///< of the centre of mass [m/s]
    float32 angularVelocity = 0.0f;
    b2Vec2 force; ///< applied at the centre of mass [N]
    float32 torque = 0.0f;
    float32 gravityScale = 1.0f;
    float32 linearDamping = 0.0f;
    float32 angularDamping = 0.0f;
    float32 sleepTime = 0.0f; ///< time below the sleep tolerances [s]

    // The path of the last step, for continuous collision: from `previous` at `sweepStart` to
    // `pose` at its end.
    Pose previous;
    float32 sweepStart = 0.0f;      ///< fraction of the step, 0 to 1
    std::uint32_t sweepVersion = 0; ///< changes whenever the path changes
    float32 minExtent = 0.0f; ///< radius of the thinnest fixture [m]: a longer path in one step is
                              ///< fast
    float32 room = 0.0f;      ///< distance that any point may move before its box must be checked
                              ///< [m]

    std::uint32_t colorMask = 0; ///< colours of the constraint graph that contain the body
    std::int32_t island = -1;    ///< dynamic and active bodies only
    /// While the joint schedule is built: the first free level. While the pattern of a system is
    /// built: the index in it.
    mutable std::int32_t jointLevel = 0;
    float32 energyDebt = 0.0f;  ///< share of the energy that its island gained, see EnergyGuard [J]
    float32 energyScale = 0.0f; ///< decaying maximum of the kinetic energy, while it has joints [J]
    std::uint32_t userMovedAt = 0; ///< World::stepNumber of the last user change of its transform
    std::uint32_t placedAt = 0;    ///< the same, or of the last new fixture
    b2Body* islandPrev = nullptr;
    b2Body* islandNext = nullptr;

    // The data that the user reads.
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
    std::int32_t number = 0; ///< creation order, never reused
    std::int32_t place = 0;  ///< index in the list of a snapshot while it is written or read

    bool IsAwake() const { return (flags & kBodyAwake) != 0; }
    bool IsActive() const { return (flags & kBodyActive) != 0; }
    bool IsDynamic() const { return mobility == Mobility::Dynamic; }
    /// Returns the index in the solver's array; 0 is shared by all bodies that do not move.
    std::int32_t SolverIndex() const { return awakeIndex + 1; }
    /// Returns 0 for bodies outside the step: they cannot be pushed, independent of their mass.
    float32 SolverInvMass() const { return awakeIndex == -1 ? 0.0f : invMass; }
    float32 SolverInvInertia() const { return awakeIndex == -1 ? 0.0f : invInertia; }
};

} // namespace box2d
