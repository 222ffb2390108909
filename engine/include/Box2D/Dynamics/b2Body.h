// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

/// @file
/// Rigid bodies and their definitions.

class b2Contact;
class b2Fixture;
class b2Joint;
class b2World;
struct b2ContactEdge;
struct b2FixtureDef;
struct b2JointEdge;

namespace box2d
{
BodyData& Data(b2Body& body);
const BodyData& Data(const b2Body& body);
} // namespace box2d

/// The motion type of a body.
enum b2BodyType
{
    b2_staticBody = 0, ///< zero mass and velocity, moved only by the program
    b2_kinematicBody,  ///< moves by its velocity, not affected by forces
    b2_dynamicBody,    ///< fully simulated
};

/// The definition of a body. Can be reused. Numbers are finite unless stated otherwise;
/// b2World::CreateBody states how it handles others.
struct b2BodyDef
{
    b2BodyType type = b2_staticBody;      ///< motion type of the body
    b2Vec2 position = b2Vec2(0.0f, 0.0f); ///< of the body's origin [m], each within 1e15 of zero
    /// Counter-clockwise from the x axis [rad], within 1e15 of zero.
    float32 angle = 0.0f;
    b2Vec2 linearVelocity = b2Vec2(0.0f, 0.0f); ///< of the body's origin [m/s]
    float32 angularVelocity = 0.0f;             ///< counter-clockwise [rad/s]
    /// Decay rate of the linear velocity [1/s], >= 0; infinity: no motion.
    float32 linearDamping = 0.0f;
    /// Decay rate of the angular velocity [1/s], >= 0; infinity: no rotation.
    float32 angularDamping = 0.0f;
    bool allowSleep = true;      ///< true if it may fall asleep
    bool awake = true;           ///< true if it starts awake
    bool fixedRotation = false;  ///< true if it never rotates
    bool bullet = false;         ///< true for continuous collision against dynamic bodies too
    bool active = true;          ///< true if it takes part in collision and dynamics
    void* userData = nullptr;    ///< user data; the engine does not read it
    float32 gravityScale = 1.0f; ///< factor of the world's gravity; 0: none, negative: opposite
};

/// A rigid body. Created by b2World::CreateBody, destroyed by b2World::DestroyBody. A number that
/// is not finite or outside the range of its function asserts and changes nothing. Functions that
/// convert between frames accept any points and vectors. Functions that must not be called while
/// the world is locked say so.
class b2Body
{
public:
    /// Attaches a copy of the definition's shape and updates the mass. Asserts and returns nullptr
    /// while the world is locked, and without a definition or a shape. The same holds for a shape
    /// that has no vertices or no size, or reaches further than 1e15 m. A density, friction or
    /// restitution that is negative or not finite becomes 0.
    b2Fixture* CreateFixture(const b2FixtureDef* def);
    /// Same as above, from a shape and a density [kg/m^2], >= 0, with the other defaults of
    /// b2FixtureDef.
    b2Fixture* CreateFixture(const b2Shape* shape, float32 density);
    /// Destroys a fixture and its contacts, and updates the mass. While the world is locked, or if
    /// the fixture is not of this body, it asserts and changes nothing.
    void DestroyFixture(b2Fixture* fixture);

    /// Sets the position of the origin [m] and the angle [rad], both within 1e15 of zero. Touching
    /// bodies wake, and the next step updates the contacts. While the world is locked, or for a
    /// number out of range, it asserts, moves nothing and returns false.
    bool SetTransform(const b2Vec2& position, float32 angle);
    /// Returns the transform from the body's frame to the world.
    const b2Transform& GetTransform() const { return m_data.transform; }
    const b2Vec2& GetPosition() const { return m_data.transform.p; } ///< position of the origin [m]
    /// Returns the angle from the x axis, counter-clockwise [rad]. It is not normalized: it grows
    /// with every turn.
    float32 GetAngle() const { return float32(m_data.pose.angle); }
    /// Sets the angle [rad], rotating about the origin; as SetTransform.
    void SetAngle(float32 angle) { SetTransform(GetPosition(), angle); }
    const b2Vec2& GetWorldCenter() const
    {
        return m_data.worldCenter;
    } ///< position of the centre
      ///< of mass [m]
    /// Same as GetWorldCenter [m].
    const b2Vec2& GetCenterPosition() const { return m_data.worldCenter; }
    /// Returns the centre of mass in the body's frame [m].
    const b2Vec2& GetLocalCenter() const { return m_data.localCenter; }

    /// Sets the velocity of the centre of mass [m/s], finite. Wakes the body unless it is 0. Static
    /// bodies are unchanged.
    void SetLinearVelocity(const b2Vec2& v);
    /// Returns the velocity of the centre of mass [m/s].
    const b2Vec2& GetLinearVelocity() const { return m_data.linearVelocity; }
    /// Sets the angular velocity, counter-clockwise [rad/s], finite; as SetLinearVelocity.
    void SetAngularVelocity(float32 omega);
    float32 GetAngularVelocity() const
    {
        return m_data.angularVelocity;
    } ///< counter-clockwise
      ///< [rad/s]

    /// Applies a force [N] at a world point [m], both finite, in the next step. Off the centre of
    /// mass it also causes a torque. With `wake` false, a sleeping body ignores it. These six
    /// functions affect dynamic bodies only.
    void ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake = true);
    /// Applies a force at the centre of mass [N], finite, in the next step.
    void ApplyForceToCenter(const b2Vec2& force, bool wake = true);
    /// Applies a torque, counter-clockwise [N m], finite, in the next step.
    void ApplyTorque(float32 torque, bool wake = true);
    /// Applies an impulse [N s] at a world point [m], both finite. Changes the velocity at once;
    /// off the centre of mass also the angular velocity.
    void ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point, bool wake = true);
    /// Applies an impulse at the centre of mass [N s], finite; changes the velocity at once. The
    /// name is that of 2.4.
    void ApplyLinearImpulseToCenter(const b2Vec2& impulse, bool wake = true)
    {
        ApplyLinearImpulse(impulse, GetWorldCenter(), wake);
    }
    /// Applies an angular impulse, counter-clockwise [N m s], finite; changes the angular velocity
    /// at once.
    void ApplyAngularImpulse(float32 impulse, bool wake = true);

    float32 GetMass() const { return m_data.mass; } ///< 0 for static and kinematic bodies [kg]
    /// Returns the rotational inertia about the body's origin [kg m^2].
    float32 GetInertia() const;
    /// Computes mass, centre of mass and rotational inertia about the origin. `data` is not null.
    void GetMassData(b2MassData* data) const;
    /// Overrides the mass data of the fixtures. The override ends with ResetMassData, a new fixture
    /// with a density, or a destroyed fixture. Mass [kg] and inertia [kg m^2] are finite and >= 0,
    /// the centre [m] is within 1e15 of zero. A mass of 0 counts as 1 kg. Other values, null, and a
    /// locked world assert and change nothing. Affects dynamic bodies only.
    void SetMassData(const b2MassData* data);
    /// Computes the mass data from the fixtures.
    void ResetMassData();

    /// Transforms a point from the body's frame to the world [m].
    b2Vec2 GetWorldPoint(const b2Vec2& localPoint) const
    {
        return b2Mul(m_data.transform, localPoint);
    }
    /// Rotates a vector from the body's frame to the world, in the vector's unit.
    b2Vec2 GetWorldVector(const b2Vec2& localVector) const
    {
        return b2Mul(m_data.transform.q, localVector);
    }
    /// Transforms a point from the world to the body's frame [m].
    b2Vec2 GetLocalPoint(const b2Vec2& worldPoint) const
    {
        return b2MulT(m_data.transform, worldPoint);
    }
    /// Rotates a vector from the world to the body's frame, in the vector's unit.
    b2Vec2 GetLocalVector(const b2Vec2& worldVector) const
    {
        return b2MulT(m_data.transform.q, worldVector);
    }
    /// Returns the velocity [m/s] of the body at a world point [m].
    b2Vec2 GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const;
    /// Returns the velocity [m/s] of a point in the body's frame [m].
    b2Vec2 GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const;

    /// Returns the decay rate of the linear velocity [1/s].
    float32 GetLinearDamping() const { return m_data.linearDamping; }
    /// Sets the decay rate of the linear velocity [1/s], >= 0; infinity stops it.
    void SetLinearDamping(float32 damping);
    /// Returns the decay rate of the angular velocity [1/s].
    float32 GetAngularDamping() const { return m_data.angularDamping; }
    /// Sets the decay rate of the angular velocity [1/s], >= 0; infinity stops it.
    void SetAngularDamping(float32 damping);
    /// Returns the factor of the world's gravity; 0: none.
    float32 GetGravityScale() const { return m_data.gravityScale; }
    /// Sets the factor of the world's gravity, finite; 0: none, negative: opposite.
    void SetGravityScale(float32 scale);

    /// Sets the type and wakes the body; costs as much as creating it again. While the world is
    /// locked, or for an invalid type, it asserts and changes nothing.
    void SetType(b2BodyType type);
    /// Returns how the body moves.
    b2BodyType GetType() const { return static_cast<b2BodyType>(m_data.mobility); }
    void SetBullet(bool flag); ///< enables or disables continuous collision against dynamic bodies
    bool IsBullet() const { return (m_data.flags & box2d::kBodyBullet) != 0; } ///< see SetBullet
    void SetSleepingAllowed(bool flag); ///< allows or forbids sleep; forbidding wakes the body
    /// True if it may fall asleep.
    bool IsSleepingAllowed() const { return (m_data.flags & box2d::kBodyAutoSleep) != 0; }
    /// Wakes the body or puts it to sleep. Waking wakes its whole contact island; sleep stops the
    /// body.
    void SetAwake(bool flag);
    bool IsAwake() const { return m_data.IsAwake(); } ///< true if awake
    /// Activates or deactivates the body. An inactive body takes no part in collision or dynamics.
    /// While the world is locked it asserts and changes nothing.
    void SetActive(bool flag);
    bool IsActive() const { return m_data.IsActive(); } ///< see SetActive
    void SetEnabled(bool flag) { SetActive(flag); }     ///< as SetActive, by the name of 2.4
    bool IsEnabled() const { return IsActive(); }       ///< as IsActive, by the name of 2.4
    /// Enables or disables rotation; a change stops the rotation.
    void SetFixedRotation(bool flag);
    /// True if it never rotates.
    bool IsFixedRotation() const { return (m_data.flags & box2d::kBodyFixedRotation) != 0; }

    b2Fixture* GetFixtureList() { return m_data.fixtureList; } ///< newest first; nullptr if empty
    /// Returns the list, newest first; nullptr if empty.
    const b2Fixture* GetFixtureList() const { return m_data.fixtureList; }
    b2JointEdge* GetJointList() { return m_data.jointList; } ///< newest first; nullptr if empty
    /// Returns the list, newest first; nullptr if empty.
    const b2JointEdge* GetJointList() const { return m_data.jointList; }
    /// Returns the contacts. The list changes during a step; prefer b2ContactListener.
    b2ContactEdge* GetContactList() { return m_data.contactList; }
    /// Same as above, read-only.
    const b2ContactEdge* GetContactList() const { return m_data.contactList; }
    b2Body* GetNext() { return m_data.next; } ///< next in the world's list; nullptr at the end
    /// Returns the next in the world's list; nullptr at the end.
    const b2Body* GetNext() const { return m_data.next; }

    /// Returns the number in creation order, from 0, never reused: the argument of
    /// b2Draw::BeginBody. An addition to the manual's interface.
    int32 GetNumber() const { return m_data.number; }

    void* GetUserData() const
    {
        return m_data.userData;
    } ///< user data; the engine does not read it
    void SetUserData(void* data)
    {
        m_data.userData = data;
    }                                ///< user data; the engine does not read it
    b2World* GetWorld();             ///< owner
    const b2World* GetWorld() const; ///< owner

    /// Writes the body as code to the log.
    void Dump();

private:
    friend box2d::BodyData& box2d::Data(b2Body& body);
    friend const box2d::BodyData& box2d::Data(const b2Body& body);
    box2d::BodyData m_data;
};

namespace box2d
{
inline BodyData& Data(b2Body& body)
{
    return body.m_data;
}
inline const BodyData& Data(const b2Body& body)
{
    return body.m_data;
}
} // namespace box2d
