// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <cstdint>

class b2Body;
class b2Contact;

/// Connects bodies and contacts: a node of each body's list of contacts.
struct b2ContactEdge
{
    b2Body* other = nullptr; ///< the other body
    b2Contact* contact = nullptr;
    b2ContactEdge* prev = nullptr;
    b2ContactEdge* next = nullptr;
};

/// The engine's data of a contact. b2Contact is its public interface. Internal to the engine.
namespace box2d
{

enum ContactFlag : std::uint32_t
{
    kContactTouching = 1u << 0,
    kContactEnabled = 1u << 1,
    kContactSensor = 1u << 2, ///< one of the fixtures is a sensor
    kContactFilter = 1u << 3, ///< the filters have changed: check again if the fixtures collide
    kContactLinked = 1u << 4, ///< connects the islands of its bodies
    // From the first phase of an update to the second:
    kContactComputed = 1u << 5, ///< the first phase is done
    kContactApart = 1u << 6,    ///< the boxes no longer overlap
    kContactMeets = 1u << 7,    ///< the shapes touch
    kContactKept = 1u << 8,     ///< the manifold stays valid while the bodies do not move
    kContactObstacle = 1u << 9, ///< one of the bodies is not dynamic
    kContactDriven = 1u << 10,  ///< the tangent speed is not zero
};

struct ContactData
{
    // What every update reads: a line of a cache. The manifold, in the next one, is read of
    // contacts that touch only.
    b2Body* bodyA = nullptr;
    b2Body* bodyB = nullptr;
    std::uint32_t flags = 0;
    /// Between the shapes when the manifold was computed [m]. Negative: along a face of B; 0: they
    /// touch, or it is not known.
    float32 gap = 0.0f;
    b2Transform relative; ///< transform of body B in A's frame when the manifold was computed
    float32 friction = 0.0f;
    float32 restitution = 0.0f;
    /// With sub-steps: the fraction of the step's impulse that the last sub-step applied. Negative
    /// before the first.
    float32 lastShare = -1.0f;
    float32 radiusA = 0.0f; ///< radius, with what the skin still has, at the last update [m]
    float32 radiusB = 0.0f;
    std::int16_t toiCount = 0; ///< times of impact handled in this step
    std::int8_t color = -1;    ///< in the constraint graph, -1 when not solved
    std::uint8_t solvedAs = 0; ///< Form() of its last block
    b2Manifold manifold;
    float32 tangentSpeed = 0.0f; ///< of a conveyor belt [m/s]
    float32 skins = 1.0f; ///< share of the skins that keeps the shapes apart: see UpdateSkins

    const b2FixtureProxy* proxyA = nullptr; ///< a child of a fixture of body A
    const b2FixtureProxy* proxyB = nullptr;

    std::int32_t awakeIndex =
        -1; ///< index among the contacts updated each step, -1 when both bodies are at rest
    /// Of its manifold before the current update, -1 if the update has left that as it was.
    std::int32_t oldIndex = -1;
    std::int32_t colorIndex = -1;
    std::int32_t place = 0; ///< index in the list of a snapshot while it is written or read

    b2ContactEdge edgeA; ///< in the list of body A
    b2ContactEdge edgeB; ///< in the list of body B
    b2Contact* prev = nullptr;
    b2Contact* next = nullptr;

    /// Returns the form of the contact: how the overlap is measured and at how many points.
    /// Contacts of the same form share blocks. 0 if it is not solved.
    std::uint8_t Form() const
    {
        const bool solved = (flags & kContactEnabled) != 0 && manifold.pointCount > 0;
        return solved ? std::uint8_t(2 * int(manifold.type) + manifold.pointCount)
                      : std::uint8_t(0);
    }
    void SetTangentSpeed(float32 speed)
    {
        tangentSpeed = speed;
        flags = speed != 0.0f ? flags | kContactDriven : flags & ~std::uint32_t(kContactDriven);
    }
    b2Fixture* FixtureA() const { return proxyA->fixture; }
    b2Fixture* FixtureB() const { return proxyB->fixture; }
    std::int32_t ChildA() const { return proxyA->childIndex; }
    std::int32_t ChildB() const { return proxyB->childIndex; }
    bool IsTouching() const { return (flags & kContactTouching) != 0; }
    bool IsEnabled() const { return (flags & kContactEnabled) != 0; }
    bool IsSensor() const { return (flags & kContactSensor) != 0; }
};

} // namespace box2d
