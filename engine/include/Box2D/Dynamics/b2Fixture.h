// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Collision/b2Collision.h>

/// @file
/// Fixtures and their definitions.

class b2Body;
class b2Fixture;

namespace box2d
{
struct FixtureAccess;
} // namespace box2d

/// Collision filter data.
struct b2Filter
{
    uint16 categoryBits = 0x0001; ///< categories of the fixture, normally one bit; any value
    uint16 maskBits = 0xFFFF;     ///< categories that it collides with; any value
    int16 groupIndex = 0; ///< same group: always (positive) or never (negative); 0: no group
};

/// The definition of a fixture. Can be reused; the shape is copied.
struct b2FixtureDef
{
    const b2Shape* shape = nullptr; ///< required
    void* userData = nullptr;       ///< user data; the engine does not read it
    float32 friction = 0.2f;        ///< finite, >= 0, usually 0 to 1
    float32 restitution = 0.0f;     ///< finite, >= 0, usually 0 to 1
    float32 density = 0.0f;         ///< mass per area [kg/m^2], finite, >= 0
    bool isSensor = false;          ///< reports contacts without a collision response
    b2Filter filter;                ///< collision filter
};

/// One child of a fixture's shape in the broad phase.
struct b2FixtureProxy
{
    b2AABB aabb;                  ///< box in the tree: the shape's box with a margin
    b2Fixture* fixture = nullptr; ///< owner
    int32 childIndex = 0;         ///< child of the shape, from 0
    int32 proxyId = -1;           ///< in the broad phase; -1: none
};

/// Attaches a shape to a body, with material and filter data. Created by b2Body::CreateFixture,
/// destroyed with its body or by b2Body::DestroyFixture. Its settings may be changed while the
/// world is locked.
class b2Fixture
{
public:
    b2Shape::Type GetType() const { return m_shape->GetType(); } ///< the type of the shape
    /// Returns the shape. Changing it in place is not supported; see SetShape.
    b2Shape* GetShape() { return m_shape; }
    const b2Shape* GetShape() const { return m_shape; } ///< as above, read-only
    /// Replaces the shape by a copy of another of the same type. Contacts change in the next step;
    /// those of a chain end if its number of edges changes. The mass does not change: call
    /// b2Body::ResetMassData. Wakes no body. An unsound shape and a locked world assert and change
    /// nothing; the result is then false.
    bool SetShape(const b2Shape& shape);

    void SetSensor(bool sensor); ///< true: reports contacts without a collision
                                 ///< response
    bool IsSensor() const
    {
        return m_isSensor;
    } ///< true if it reports contacts without a
      ///< collision response

    /// Sets the collision filter, with effect from the next step.
    void SetFilterData(const b2Filter& filter);
    const b2Filter& GetFilterData() const { return m_filter; } ///< collision filter
    /// Makes the next step call the contact filter again.
    void Refilter();

    b2Body* GetBody() { return m_body; }             ///< owner
    const b2Body* GetBody() const { return m_body; } ///< owner
    b2Fixture* GetNext() { return m_next; } ///< next in the body's list; nullptr at the end
    /// Returns the next in the body's list; nullptr at the end.
    const b2Fixture* GetNext() const { return m_next; }

    void* GetUserData() const { return m_userData; }    ///< returns the user data
    void SetUserData(void* data) { m_userData = data; } ///< user data; the engine does not read it

    /// True if the world point [m] is inside the shape.
    bool TestPoint(const b2Vec2& p) const;
    /// Finds the first hit of a ray in world coordinates with a child of the shape. 0 <= childIndex
    /// < GetChildCount(); another index of a chain asserts. Returns false and leaves `output`
    /// unchanged if there is no hit.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, int32 childIndex) const;
    /// Computes the mass data of the shape with its density, in the body's frame. `massData` is not
    /// null.
    void GetMassData(b2MassData* massData) const { m_shape->ComputeMass(massData, m_density); }

    /// Sets the mass per area [kg/m^2], finite, >= 0; otherwise it asserts and changes nothing. The
    /// body's mass does not change: call b2Body::ResetMassData.
    void SetDensity(float32 density);
    float32 GetDensity() const { return m_density; }   ///< mass per area [kg/m^2]
    float32 GetFriction() const { return m_friction; } ///< >= 0, usually 0 to 1
    /// Sets the friction, finite, >= 0; otherwise it asserts and changes nothing. Existing contacts
    /// keep their value.
    void SetFriction(float32 friction);
    float32 GetRestitution() const { return m_restitution; } ///< >= 0, usually 0 to 1
    /// Sets the restitution, finite, >= 0; otherwise it asserts and changes nothing. Existing
    /// contacts keep their value.
    void SetRestitution(float32 restitution);

    /// Returns the box in the broad phase [m], larger than the shape. Only for an active body and 0
    /// <= childIndex < GetChildCount(); another index asserts, and is undefined with asserts off.
    const b2AABB& GetAABB(int32 childIndex) const;

    /// Writes the fixture as code to the log. The code refers to the body as `bodies[bodyIndex]`.
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
    b2FixtureProxy* m_proxies = nullptr; ///< one per child
    int32 m_proxyCount = 0;              ///< number of children in the broad phase; 0 while
                                         ///< inactive
    b2Filter m_filter;
    bool m_isSensor = false;
    void* m_userData = nullptr;
};

/// Returns the friction of a contact: the geometric mean, so that one slippery fixture suffices.
/// Both arguments >= 0.
inline float32 b2MixFriction(float32 friction1, float32 friction2)
{
    return b2Sqrt(friction1 * friction2);
}

/// Returns the restitution of a contact: the maximum, so that one elastic fixture suffices. Both
/// arguments >= 0.
inline float32 b2MixRestitution(float32 restitution1, float32 restitution2)
{
    return restitution1 > restitution2 ? restitution1 : restitution2;
}
