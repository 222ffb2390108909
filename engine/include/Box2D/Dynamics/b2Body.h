// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

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

enum b2BodyType
{
    b2_staticBody = 0, ///< zero mass and velocity, moved by hand only
    b2_kinematicBody,  ///< moves by its velocity, takes no force
    b2_dynamicBody,    ///< fully simulated
};

/// All that is needed to create a body. Can be reused.
struct b2BodyDef
{
    b2BodyType type = b2_staticBody;
    b2Vec2 position = b2Vec2(0.0f, 0.0f);       ///< of the body's origin [m]
    float32 angle = 0.0f;                       ///< [rad]
    b2Vec2 linearVelocity = b2Vec2(0.0f, 0.0f); ///< of the body's origin [m/s]
    float32 angularVelocity = 0.0f;             ///< [rad/s]
    float32 linearDamping = 0.0f;               ///< [1/s], >= 0; infinity: no motion
    float32 angularDamping = 0.0f;              ///< [1/s], >= 0; infinity: no motion
    bool allowSleep = true;
    bool awake = true;
    bool fixedRotation = false;
    bool bullet = false; ///< continuous collision against moving bodies too
    bool active = true;
    void* userData = nullptr;
    float32 gravityScale = 1.0f;
};

/// A rigid body. Created by b2World::CreateBody, destroyed by b2World::DestroyBody.
class b2Body
{
public:
    /// Attaches a copy of the definition's shape and updates the mass. nullptr while the world is
    /// locked.
    b2Fixture* CreateFixture(const b2FixtureDef* def);
    b2Fixture* CreateFixture(const b2Shape* shape, float32 density);
    void DestroyFixture(b2Fixture* fixture);

    /// Moves the body's origin. Contacts are updated in the next step. False, and nothing is moved,
    /// while the world is locked.
    bool SetTransform(const b2Vec2& position, float32 angle);
    const b2Transform& GetTransform() const { return m_data.transform; }
    const b2Vec2& GetPosition() const { return m_data.transform.p; }
    /// Not normalised: grows with every turn.
    float32 GetAngle() const { return float32(m_data.pose.angle); }
    void SetAngle(float32 angle) { SetTransform(GetPosition(), angle); }
    const b2Vec2& GetWorldCenter() const { return m_data.worldCenter; }
    const b2Vec2& GetCenterPosition() const { return m_data.worldCenter; }
    const b2Vec2& GetLocalCenter() const { return m_data.localCenter; }

    /// Of the centre of mass.
    void SetLinearVelocity(const b2Vec2& v);
    const b2Vec2& GetLinearVelocity() const { return m_data.linearVelocity; }
    void SetAngularVelocity(float32 omega);
    float32 GetAngularVelocity() const { return m_data.angularVelocity; }

    /// At a world point [N]; off the centre of mass it turns the body. `wake` false leaves a
    /// sleeping body alone.
    void ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake = true);
    void ApplyForceToCenter(const b2Vec2& force, bool wake = true);
    void ApplyTorque(float32 torque, bool wake = true); ///< [N m]
    void ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point,
                            bool wake = true);                   ///< [N s]
    void ApplyAngularImpulse(float32 impulse, bool wake = true); ///< [N m s]

    float32 GetMass() const { return m_data.mass; }
    /// About the body's origin [kg m^2].
    float32 GetInertia() const;
    void GetMassData(b2MassData* data) const;
    /// Replaces what the fixtures give. Dynamic bodies only.
    void SetMassData(const b2MassData* data);
    void ResetMassData();

    b2Vec2 GetWorldPoint(const b2Vec2& localPoint) const
    {
        return b2Mul(m_data.transform, localPoint);
    }
    b2Vec2 GetWorldVector(const b2Vec2& localVector) const
    {
        return b2Mul(m_data.transform.q, localVector);
    }
    b2Vec2 GetLocalPoint(const b2Vec2& worldPoint) const
    {
        return b2MulT(m_data.transform, worldPoint);
    }
    b2Vec2 GetLocalVector(const b2Vec2& worldVector) const
    {
        return b2MulT(m_data.transform.q, worldVector);
    }
    b2Vec2 GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const;
    b2Vec2 GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const;

    float32 GetLinearDamping() const { return m_data.linearDamping; }
    void SetLinearDamping(float32 damping); ///< [1/s], >= 0; infinity stops it
    float32 GetAngularDamping() const { return m_data.angularDamping; }
    void SetAngularDamping(float32 damping); ///< [1/s], >= 0
    float32 GetGravityScale() const { return m_data.gravityScale; }
    void SetGravityScale(float32 scale);

    /// Costs as much as creating the body anew.
    void SetType(b2BodyType type);
    b2BodyType GetType() const { return static_cast<b2BodyType>(m_data.mobility); }
    void SetBullet(bool flag);
    bool IsBullet() const { return (m_data.flags & box2d::kBodyBullet) != 0; }
    void SetSleepingAllowed(bool flag);
    bool IsSleepingAllowed() const { return (m_data.flags & box2d::kBodyAutoSleep) != 0; }
    /// Waking wakes everything the body touches or is joined to.
    void SetAwake(bool flag);
    bool IsAwake() const { return m_data.IsAwake(); }
    /// An inactive body takes no part in collision or dynamics.
    void SetActive(bool flag);
    bool IsActive() const { return m_data.IsActive(); }
    void SetFixedRotation(bool flag);
    bool IsFixedRotation() const { return (m_data.flags & box2d::kBodyFixedRotation) != 0; }

    b2Fixture* GetFixtureList() { return m_data.fixtureList; }
    const b2Fixture* GetFixtureList() const { return m_data.fixtureList; }
    b2JointEdge* GetJointList() { return m_data.jointList; }
    const b2JointEdge* GetJointList() const { return m_data.jointList; }
    /// Changes during a step; b2ContactListener tells more.
    b2ContactEdge* GetContactList() { return m_data.contactList; }
    const b2ContactEdge* GetContactList() const { return m_data.contactList; }
    b2Body* GetNext() { return m_data.next; }
    const b2Body* GetNext() const { return m_data.next; }

    /// In the order of creation, from 0, and never used again: what b2Draw::BeginBody is told. An
    /// addition to the manual's interface.
    int32 GetNumber() const { return m_data.number; }

    void* GetUserData() const { return m_data.userData; }
    void SetUserData(void* data) { m_data.userData = data; }
    b2World* GetWorld();
    const b2World* GetWorld() const;

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
