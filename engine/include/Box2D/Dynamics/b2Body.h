// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

/// @file
/// Bodies, and what they are made from.

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

/// What moves a body.
enum b2BodyType
{
    b2_staticBody = 0, ///< zero mass and velocity, moved by hand only
    b2_kinematicBody,  ///< moves by its velocity, takes no force
    b2_dynamicBody,    ///< fully simulated
};

/// All that is needed to create a body. Can be reused. Numbers are finite unless said; what
/// b2World::CreateBody does with others is said there.
struct b2BodyDef
{
    b2BodyType type = b2_staticBody;      ///< what moves it
    b2Vec2 position = b2Vec2(0.0f, 0.0f); ///< of the body's origin [m], each within 1e15 of zero
    /// Anticlockwise from the x axis [rad], within 1e15 of zero.
    float32 angle = 0.0f;
    b2Vec2 linearVelocity = b2Vec2(0.0f, 0.0f); ///< of the body's origin [m/s]
    float32 angularVelocity = 0.0f;             ///< anticlockwise [rad/s]
    /// Rate at which the velocity decays [1/s], >= 0; infinity: no motion.
    float32 linearDamping = 0.0f;
    /// Rate at which the rotation decays [1/s], >= 0; infinity: no motion.
    float32 angularDamping = 0.0f;
    bool allowSleep = true;      ///< whether it may fall asleep
    bool awake = true;           ///< whether it starts awake
    bool fixedRotation = false;  ///< whether it never turns
    bool bullet = false;         ///< continuous collision against moving bodies too
    bool active = true;          ///< whether it takes part in collision and dynamics
    void* userData = nullptr;    ///< anything of the program's
    float32 gravityScale = 1.0f; ///< times the world's gravity; 0: none, negative: against it
};

/// A rigid body. Created by b2World::CreateBody, destroyed by b2World::DestroyBody. A number that
/// is out of the range said at its function, or not finite, asserts and changes nothing. Points and
/// vectors that are only turned or moved from frame to frame may be any. What must not be called
/// while the world is locked says so.
class b2Body
{
public:
    /// Attaches a copy of the definition's shape and updates the mass. nullptr, after an assert
    /// where they are on: while the world is locked; of no definition or no shape; of a shape
    /// without points, without a size, or that reaches further than 1e15 m. A density, friction or
    /// restitution that is negative or not finite becomes 0.
    b2Fixture* CreateFixture(const b2FixtureDef* def);
    /// The same from a shape and a density [kg/m^2], >= 0; all else as in b2FixtureDef.
    b2Fixture* CreateFixture(const b2Shape* shape, float32 density);
    /// Removes it and its contacts, and updates the mass. While the world is locked, and of no
    /// fixture of this body, it asserts and nothing goes.
    void DestroyFixture(b2Fixture* fixture);

    /// Moves the body's origin [m] and turns it [rad]; position and angle are within 1e15 of zero.
    /// Contacts are updated in the next step, what touches it wakes. False, and nothing is moved,
    /// after an assert where they are on: while the world is locked, and for a number out of range.
    bool SetTransform(const b2Vec2& position, float32 angle);
    /// From the body's frame to the world.
    const b2Transform& GetTransform() const { return m_data.transform; }
    const b2Vec2& GetPosition() const { return m_data.transform.p; } ///< of the origin [m]
    /// From the x axis, anticlockwise [rad]; not normalised: grows with every turn.
    float32 GetAngle() const { return float32(m_data.pose.angle); }
    /// Turns it about its origin [rad]; as SetTransform.
    void SetAngle(float32 angle) { SetTransform(GetPosition(), angle); }
    const b2Vec2& GetWorldCenter() const { return m_data.worldCenter; } ///< the centre of mass [m]
    /// As GetWorldCenter [m].
    const b2Vec2& GetCenterPosition() const { return m_data.worldCenter; }
    /// Of mass, in its frame [m].
    const b2Vec2& GetLocalCenter() const { return m_data.localCenter; }

    /// Of the centre of mass [m/s], finite; wakes the body unless 0. Static bodies have none: for
    /// them nothing is done.
    void SetLinearVelocity(const b2Vec2& v);
    /// Of the centre of mass [m/s].
    const b2Vec2& GetLinearVelocity() const { return m_data.linearVelocity; }
    /// Anticlockwise [rad/s], finite; as SetLinearVelocity.
    void SetAngularVelocity(float32 omega);
    float32 GetAngularVelocity() const { return m_data.angularVelocity; } ///< anticlockwise [rad/s]

    /// A force [N] at a world point [m], both finite, for the next step; off the centre of mass it
    /// turns the body. `wake` false leaves a sleeping body alone, and then it feels nothing. These
    /// six act on dynamic bodies only.
    void ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake = true);
    /// At the centre of mass [N], finite, for the next step.
    void ApplyForceToCenter(const b2Vec2& force, bool wake = true);
    /// Anticlockwise [N m], finite, for the next step.
    void ApplyTorque(float32 torque, bool wake = true);
    /// [N s] at a world point [m], both finite: changes the velocity at once, and off the centre of
    /// mass the rotation too.
    void ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point, bool wake = true);
    /// At the centre of mass [N s], finite: changes the velocity at once. By the name of 2.4.
    void ApplyLinearImpulseToCenter(const b2Vec2& impulse, bool wake = true)
    {
        ApplyLinearImpulse(impulse, GetWorldCenter(), wake);
    }
    /// Changes the rotation at once, anticlockwise [N m s], finite.
    void ApplyAngularImpulse(float32 impulse, bool wake = true);

    float32 GetMass() const { return m_data.mass; } ///< 0: static or kinematic [kg]
    /// About the body's origin [kg m^2].
    float32 GetInertia() const;
    /// Mass, centre of mass and moment of inertia about the origin. `data` is not null.
    void GetMassData(b2MassData* data) const;
    /// Replaces what the fixtures give, until ResetMassData or until a fixture with a density comes
    /// or any goes. Mass [kg] and inertia [kg m^2] are finite and not negative, a mass of 0 counts
    /// as 1 kg, the centre [m] within 1e15 of zero; else, of no data, and while the world is
    /// locked, it asserts and changes nothing. For dynamic bodies only; others stay as they are.
    void SetMassData(const b2MassData* data);
    /// To what the fixtures give.
    void ResetMassData();

    /// From the body's frame to the world [m].
    b2Vec2 GetWorldPoint(const b2Vec2& localPoint) const
    {
        return b2Mul(m_data.transform, localPoint);
    }
    /// From the body's frame to the world, turned only; in the vector's unit.
    b2Vec2 GetWorldVector(const b2Vec2& localVector) const
    {
        return b2Mul(m_data.transform.q, localVector);
    }
    /// From the world to the body's frame [m].
    b2Vec2 GetLocalPoint(const b2Vec2& worldPoint) const
    {
        return b2MulT(m_data.transform, worldPoint);
    }
    /// From the world to the body's frame, turned only; in the vector's unit.
    b2Vec2 GetLocalVector(const b2Vec2& worldVector) const
    {
        return b2MulT(m_data.transform.q, worldVector);
    }
    /// Of the body [m/s] at a world point [m].
    b2Vec2 GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const;
    /// Of a point of the body [m], in its frame [m/s].
    b2Vec2 GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const;

    /// Rate at which the velocity decays [1/s].
    float32 GetLinearDamping() const { return m_data.linearDamping; }
    /// Rate at which the velocity decays [1/s], >= 0; infinity stops it.
    void SetLinearDamping(float32 damping);
    /// Rate at which the rotation decays [1/s].
    float32 GetAngularDamping() const { return m_data.angularDamping; }
    /// Rate at which the rotation decays [1/s], >= 0; infinity stops it.
    void SetAngularDamping(float32 damping);
    /// Times the world's gravity; 0: none.
    float32 GetGravityScale() const { return m_data.gravityScale; }
    /// Times the world's gravity, finite; 0: none, negative: against it.
    void SetGravityScale(float32 scale);

    /// Costs as much as creating the body anew, and wakes it. While the world is locked, and of no
    /// type of b2BodyType, it asserts and changes nothing.
    void SetType(b2BodyType type);
    /// What moves it.
    b2BodyType GetType() const { return static_cast<b2BodyType>(m_data.mobility); }
    void SetBullet(bool flag); ///< continuous collision against moving bodies too
    bool IsBullet() const { return (m_data.flags & box2d::kBodyBullet) != 0; } ///< see SetBullet
    void SetSleepingAllowed(bool flag); ///< whether it may sleep; false wakes it
    /// Whether it may fall asleep.
    bool IsSleepingAllowed() const { return (m_data.flags & box2d::kBodyAutoSleep) != 0; }
    /// Waking wakes everything the body touches or is joined to; falling asleep stops it.
    void SetAwake(bool flag);
    bool IsAwake() const { return m_data.IsAwake(); } ///< whether it does not sleep
    /// An inactive body takes no part in collision or dynamics. While the world is locked it
    /// asserts and changes nothing.
    void SetActive(bool flag);
    bool IsActive() const { return m_data.IsActive(); } ///< see SetActive
    void SetEnabled(bool flag) { SetActive(flag); }     ///< as SetActive, by the name of 2.4
    bool IsEnabled() const { return IsActive(); }       ///< as IsActive, by the name of 2.4
    /// Whether it never turns; a change stops its rotation.
    void SetFixedRotation(bool flag);
    /// Whether it never turns.
    bool IsFixedRotation() const { return (m_data.flags & box2d::kBodyFixedRotation) != 0; }

    b2Fixture* GetFixtureList() { return m_data.fixtureList; } ///< the newest; nullptr: none
    /// The newest; nullptr: none.
    const b2Fixture* GetFixtureList() const { return m_data.fixtureList; }
    b2JointEdge* GetJointList() { return m_data.jointList; } ///< the newest; nullptr: none
    /// The newest; nullptr: none.
    const b2JointEdge* GetJointList() const { return m_data.jointList; }
    /// Changes during a step; b2ContactListener tells more.
    b2ContactEdge* GetContactList() { return m_data.contactList; }
    /// The same, to be read.
    const b2ContactEdge* GetContactList() const { return m_data.contactList; }
    b2Body* GetNext() { return m_data.next; } ///< of the world's list; nullptr: this is the last
    /// Of the world's list; nullptr: this is the last.
    const b2Body* GetNext() const { return m_data.next; }

    /// In the order of creation, from 0, and never used again: what b2Draw::BeginBody is told. An
    /// addition to the manual's interface.
    int32 GetNumber() const { return m_data.number; }

    void* GetUserData() const { return m_data.userData; }    ///< anything of the program's
    void SetUserData(void* data) { m_data.userData = data; } ///< anything of the program's
    b2World* GetWorld();                                     ///< to which it belongs
    const b2World* GetWorld() const;                         ///< to which it belongs

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
