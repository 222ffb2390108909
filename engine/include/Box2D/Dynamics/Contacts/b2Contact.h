// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/ContactData.h>
#include <Box2D/Dynamics/b2Fixture.h>

/// @file
/// Contacts, and the ways to them.

namespace box2d
{
ContactData& Data(b2Contact& contact);
} // namespace box2d

/// Two fixtures whose broad-phase boxes overlap. Created and destroyed by the world; they touch
/// only when IsTouching says so.
class b2Contact
{
public:
    /// In the frames of the bodies; see b2WorldManifold.
    b2Manifold* GetManifold() { return &m_data.manifold; }
    const b2Manifold* GetManifold() const { return &m_data.manifold; } ///< the same, to be read
    /// In the world, at the bodies' present transforms; untouched when there are no points.
    /// `worldManifold` is not null.
    void GetWorldManifold(b2WorldManifold* worldManifold) const;

    bool IsTouching() const { return m_data.IsTouching(); } ///< whether the shapes overlap
    /// Inside b2ContactListener::PreSolve: false switches the contact off for this step.
    void SetEnabled(bool flag);
    bool IsEnabled() const { return m_data.IsEnabled(); } ///< false: switched off for this step

    b2Contact* GetNext() { return m_data.next; } ///< of the world's list; nullptr: this is the last
    /// Of the world's list; nullptr: this is the last.
    const b2Contact* GetNext() const { return m_data.next; }
    b2Fixture* GetFixtureA() { return m_data.fixtureA; }             ///< the first fixture
    const b2Fixture* GetFixtureA() const { return m_data.fixtureA; } ///< the first fixture
    b2Fixture* GetFixtureB() { return m_data.fixtureB; }             ///< the second fixture
    const b2Fixture* GetFixtureB() const { return m_data.fixtureB; } ///< the second fixture
    int32 GetChildIndexA() const { return m_data.childA; }           ///< of the first shape, from 0
    int32 GetChildIndexB() const { return m_data.childB; } ///< of the second shape, from 0

    /// Overrides the mixed friction until reset. Finite, >= 0; else it asserts and nothing changes.
    void SetFriction(float32 friction);
    float32 GetFriction() const { return m_data.friction; } ///< mixed or set, >= 0
    /// To the mixture of the fixtures' values.
    void ResetFriction();
    /// Overrides the mixed restitution until reset. Finite, >= 0; else it asserts and nothing
    /// changes.
    void SetRestitution(float32 restitution);
    float32 GetRestitution() const { return m_data.restitution; } ///< mixed or set, >= 0
    /// To the mixture of the fixtures' values.
    void ResetRestitution();
    /// The surface speed of a conveyor belt [m/s], finite; else it asserts and nothing changes.
    void SetTangentSpeed(float32 speed);
    float32 GetTangentSpeed() const { return m_data.tangentSpeed; } ///< of a conveyor belt [m/s]

    /// The manifold of the two shapes at the given transforms, finite. `manifold` is not null.
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
