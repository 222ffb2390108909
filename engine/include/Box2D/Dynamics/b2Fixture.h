// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Collision/b2Collision.h>

/// @file
/// Fixtures, and what they are made from.

class b2Body;
class b2Fixture;

namespace box2d
{
struct FixtureAccess;
} // namespace box2d

/// Which fixtures collide with which.
struct b2Filter
{
    uint16 categoryBits = 0x0001; ///< what it is, normally one bit; any
    uint16 maskBits = 0xFFFF;     ///< the categories it collides with; any
    int16 groupIndex = 0; ///< same group: always (positive) or never (negative); 0: no group
};

/// All that is needed to create a fixture. Can be reused; the shape is copied.
struct b2FixtureDef
{
    const b2Shape* shape = nullptr; ///< must be set
    void* userData = nullptr;       ///< anything of the program's
    float32 friction = 0.2f;        ///< finite, >= 0, usually 0 to 1
    float32 restitution = 0.0f;     ///< finite, >= 0, usually 0 to 1
    float32 density = 0.0f;         ///< mass of a unit of area [kg/m^2], finite, >= 0
    bool isSensor = false;          ///< notices contacts without responding
    b2Filter filter;                ///< what it collides with
};

/// The broad phase's view of one child of a fixture's shape.
struct b2FixtureProxy
{
    b2AABB aabb;                  ///< what the tree holds: the shape's box with a margin
    b2Fixture* fixture = nullptr; ///< to which it belongs
    int32 childIndex = 0;         ///< of the shape, from 0
    int32 proxyId = -1;           ///< in the broad phase; -1: none
};

/// Binds a shape to a body and adds material and filtering. Created by b2Body::CreateFixture,
/// destroyed with its body or by b2Body::DestroyFixture. Its settings may be changed while the
/// world is locked.
class b2Fixture
{
public:
    b2Shape::Type GetType() const { return m_shape->GetType(); } ///< which class the shape is
    /// Changing a shape that is in use is not supported.
    b2Shape* GetShape() { return m_shape; }
    const b2Shape* GetShape() const { return m_shape; } ///< the same, to be read

    void SetSensor(bool sensor);                 ///< whether it notices contacts without responding
    bool IsSensor() const { return m_isSensor; } ///< whether it notices contacts without responding

    /// Takes effect in the next step.
    void SetFilterData(const b2Filter& filter);
    const b2Filter& GetFilterData() const { return m_filter; } ///< what it collides with
    /// Makes the next step ask the contact filter again.
    void Refilter();

    b2Body* GetBody() { return m_body; }             ///< to which it belongs
    const b2Body* GetBody() const { return m_body; } ///< to which it belongs
    b2Fixture* GetNext() { return m_next; } ///< of the body's list; nullptr: this is the last
    /// Of the body's list; nullptr: this is the last.
    const b2Fixture* GetNext() const { return m_next; }

    void* GetUserData() const { return m_userData; }    ///< what was set
    void SetUserData(void* data) { m_userData = data; } ///< anything of the program's

    /// Is the world point [m] inside the shape?
    bool TestPoint(const b2Vec2& p) const;
    /// Where a ray of the world first meets a child of the shape, 0 <= childIndex < its
    /// GetChildCount(): of a chain another asserts. False, and `output` is as it was: nowhere.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, int32 childIndex) const;
    /// Of the shape with its density, in the body's frame. `massData` is not null.
    void GetMassData(b2MassData* massData) const { m_shape->ComputeMass(massData, m_density); }

    /// Mass of a unit of area [kg/m^2], finite, >= 0; else it asserts and nothing changes. The
    /// body's mass stays: call b2Body::ResetMassData.
    void SetDensity(float32 density);
    float32 GetDensity() const { return m_density; }   ///< mass of a unit of area [kg/m^2]
    float32 GetFriction() const { return m_friction; } ///< >= 0, usually 0 to 1
    /// Finite, >= 0; else it asserts and nothing changes. Existing contacts keep theirs.
    void SetFriction(float32 friction);
    float32 GetRestitution() const { return m_restitution; } ///< >= 0, usually 0 to 1
    /// Finite, >= 0; else it asserts and nothing changes. Existing contacts keep theirs.
    void SetRestitution(float32 restitution);

    /// The box in the broad phase [m], larger than the shape. Of an active body only, and 0 <=
    /// childIndex < the shape's GetChildCount(): another asserts, and without asserts is not to be
    /// asked for.
    const b2AABB& GetAABB(int32 childIndex) const;

    /// Writes the fixture as code to the log, for the body that the code calls `bodies[bodyIndex]`.
    void Dump(int32 bodyIndex);

protected:
    friend struct box2d::FixtureAccess;
    b2Fixture() = default;
    ~b2Fixture() = default;

    float32 m_density = 0.0f;
    b2Fixture* m_next = nullptr;
    b2Body* m_body = nullptr;
    b2Shape* m_shape = nullptr;
    float32 m_friction = 0.0f;
    float32 m_restitution = 0.0f;
    b2FixtureProxy* m_proxies = nullptr; ///< one a child
    int32 m_proxyCount = 0;              ///< in the broad phase: all children, or 0 while inactive
    b2Filter m_filter;
    bool m_isSensor = false;
    void* m_userData = nullptr;
};

/// The friction of a contact from that of its fixtures: the geometric mean, so that either can make
/// it slippery. Both >= 0.
inline float32 b2MixFriction(float32 friction1, float32 friction2)
{
    return b2Sqrt(friction1 * friction2);
}

/// The restitution of a contact: the larger, so that a ball bounces on anything. Both >= 0.
inline float32 b2MixRestitution(float32 restitution1, float32 restitution2)
{
    return restitution1 > restitution2 ? restitution1 : restitution2;
}
