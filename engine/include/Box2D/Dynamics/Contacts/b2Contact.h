// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/ContactData.h>
#include <Box2D/Dynamics/b2Fixture.h>

/// @file
/// Contacts.

namespace box2d
{
ContactData& Data(b2Contact& contact);
} // namespace box2d

/// Two fixtures whose broad-phase boxes overlap. Created and destroyed by the world. The shapes
/// touch only if IsTouching is true.
class b2Contact
{
public:
    b2Contact() = default;
    b2Contact(const b2Contact&) = delete;
    b2Contact& operator=(const b2Contact&) = delete;

    /// Returns the manifold in the frames of the bodies; see b2WorldManifold. A change of it counts
    /// until the next step has ended: call this again before a later change. Not thread-safe.
    b2Manifold* GetManifold();
    const b2Manifold* GetManifold() const { return &m_data.manifold; } ///< as above, read-only
    /// Computes the manifold in world coordinates at the bodies' current transforms, with the skins
    /// that this contact has: see b2World::SetSubStepCount. `worldManifold` is not null; it is
    /// unchanged if there are no points.
    void GetWorldManifold(b2WorldManifold* worldManifold) const;

    bool IsTouching() const { return m_data.IsTouching(); } ///< true if the shapes overlap
    /// Disables the contact for this step if `flag` is false. For use in
    /// b2ContactListener::PreSolve.
    void SetEnabled(bool flag);
    bool IsEnabled() const { return m_data.IsEnabled(); } ///< false if disabled for this step

    b2Contact* GetNext() { return m_data.next; } ///< next in the world's list; nullptr at the end
    /// Returns the next in the world's list; nullptr at the end.
    const b2Contact* GetNext() const { return m_data.next; }
    b2Fixture* GetFixtureA() { return m_data.FixtureA(); } ///< returns the first fixture
    const b2Fixture* GetFixtureA() const
    {
        return m_data.FixtureA();
    }                                                      ///< returns the first fixture
    b2Fixture* GetFixtureB() { return m_data.FixtureB(); } ///< returns the second fixture
    const b2Fixture* GetFixtureB() const
    {
        return m_data.FixtureB();
    } ///< returns the second fixture
    int32 GetChildIndexA() const
    {
        return m_data.ChildA();
    }                                                        ///< child of the first shape,
                                                             ///< from 0
    int32 GetChildIndexB() const { return m_data.ChildB(); } ///< child of the second shape, from 0

    /// Overrides the mixed friction until reset. Finite, >= 0; otherwise it asserts and changes
    /// nothing.
    void SetFriction(float32 friction);
    float32 GetFriction() const { return m_data.friction; } ///< mixed value or user override, >= 0
    /// Restores the mixed value of the two fixtures.
    void ResetFriction();
    /// Overrides the mixed restitution until reset. Finite, >= 0; otherwise it asserts and changes
    /// nothing.
    void SetRestitution(float32 restitution);
    float32 GetRestitution() const
    {
        return m_data.restitution;
    } ///< mixed value or user override, >= 0
    /// Restores the mixed value of the two fixtures.
    void ResetRestitution();
    /// Sets the surface speed of a conveyor belt [m/s], finite; otherwise it asserts and changes
    /// nothing.
    void SetTangentSpeed(float32 speed);
    float32 GetTangentSpeed() const { return m_data.tangentSpeed; } ///< of a conveyor belt [m/s]

    /// Computes the manifold of the two shapes at the given transforms, finite. `manifold` is not
    /// null.
    void Evaluate(b2Manifold* manifold, const b2Transform& xfA, const b2Transform& xfB);

private:
    friend box2d::ContactData& box2d::Data(b2Contact& contact);
    box2d::ContactData m_data;
};

namespace box2d
{
inline ContactData& Data(b2Contact& contact)
{
    return contact.m_data;
}
} // namespace box2d
