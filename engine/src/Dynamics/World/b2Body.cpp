// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2Body.h>

#include "../Islands/Sleep.h"
#include "../State/Access.h"
#include "../State/Reach.h"
#include "../State/Solver.h"
#include "../State/World.h"
#include "Bodies.h"
#include "Fixtures.h"

#include <Box2D/Dynamics/b2Fixture.h>
#include <Box2D/Dynamics/b2World.h>

/// The public interface of box2d::BodyData: checks preconditions, then forwards.

namespace
{

bool IsUnlocked(const box2d::BodyData& body)
{
    return B2_REQUIRE(!body.world->locked,
                      "A body must not be changed from inside a callback of its world.");
}

// Forces on inactive bodies would accumulate unnoticed.
bool TakesForces(b2Body& body, bool wake)
{
    box2d::BodyData& data = box2d::Data(body);
    if (!data.IsDynamic())
    {
        return false;
    }
    if (wake)
    {
        body.SetAwake(true);
    }
    data.world->forcesApplied = true;
    return data.awakeIndex != -1;
}

bool IsFinite(const b2Vec2& a, const b2Vec2& b)
{
    return B2_REQUIRE(a.IsValid() && b.IsValid(),
                      "Forces, impulses and their points must be finite.");
}

bool IsDamping(float32 damping)
{
    return B2_REQUIRE(damping >= 0.0f, "A body's damping must be a number and not negative.");
}

bool IsFinite(float32 a)
{
    return B2_REQUIRE(b2IsValid(a), "Torques and angular impulses must be finite.");
}

} // namespace

b2Fixture* b2Body::CreateFixture(const b2FixtureDef* def)
{
    if (!IsUnlocked(m_data) ||
        !B2_REQUIRE(def != nullptr, "b2Body::CreateFixture needs a definition."))
    {
        return nullptr;
    }
    return box2d::CreateFixture(*m_data.world, *this, *def);
}

b2Fixture* b2Body::CreateFixture(const b2Shape* shape, float32 density)
{
    b2FixtureDef def;
    def.shape = shape;
    def.density = density;
    return CreateFixture(&def);
}

void b2Body::DestroyFixture(b2Fixture* fixture)
{
    if (IsUnlocked(m_data) && B2_REQUIRE(fixture != nullptr && fixture->GetBody() == this,
                                         "b2Body::DestroyFixture needs a fixture of this body."))
    {
        box2d::DestroyFixture(*m_data.world, *this, *fixture);
    }
}

bool b2Body::SetTransform(const b2Vec2& position, float32 angle)
{
    if (!IsUnlocked(m_data) ||
        !B2_REQUIRE(box2d::IsWithinReach(position) && box2d::IsWithinReach(angle),
                    "b2Body::SetTransform needs a finite position and angle within 1e15 of zero."))
    {
        return false;
    }
    box2d::SetTransform(*m_data.world, *this, position, angle);
    return true;
}

void b2Body::SetLinearVelocity(const b2Vec2& v)
{
    if (m_data.mobility == box2d::Mobility::Static ||
        !B2_REQUIRE(v.IsValid(), "b2Body::SetLinearVelocity needs a finite velocity."))
    {
        return;
    }
    if (v != b2Vec2(0.0f, 0.0f))
    {
        SetAwake(true);
    }
    m_data.linearVelocity = v;
}

void b2Body::SetAngularVelocity(float32 omega)
{
    if (m_data.mobility == box2d::Mobility::Static ||
        !B2_REQUIRE(b2IsValid(omega), "b2Body::SetAngularVelocity needs a finite velocity."))
    {
        return;
    }
    if (omega != 0.0f)
    {
        SetAwake(true);
    }
    m_data.angularVelocity = omega;
}

void b2Body::ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake)
{
    if (IsFinite(force, point) && TakesForces(*this, wake))
    {
        m_data.force += force;
        m_data.torque += b2Cross(point - m_data.worldCenter, force);
    }
}

void b2Body::ApplyForceToCenter(const b2Vec2& force, bool wake)
{
    if (IsFinite(force, force) && TakesForces(*this, wake))
    {
        m_data.force += force;
    }
}

void b2Body::ApplyTorque(float32 torque, bool wake)
{
    if (IsFinite(torque) && TakesForces(*this, wake))
    {
        m_data.torque += torque;
    }
}

void b2Body::ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point, bool wake)
{
    if (IsFinite(impulse, point) && TakesForces(*this, wake))
    {
        using box2d::Bounded;
        const float32 turn = b2Cross(point - m_data.worldCenter, impulse);
        m_data.linearVelocity = Bounded(m_data.linearVelocity + m_data.invMass * impulse);
        m_data.angularVelocity = Bounded(m_data.angularVelocity + m_data.invInertia * turn);
    }
}

void b2Body::ApplyAngularImpulse(float32 impulse, bool wake)
{
    if (IsFinite(impulse) && TakesForces(*this, wake))
    {
        m_data.angularVelocity =
            box2d::Bounded(m_data.angularVelocity + m_data.invInertia * impulse);
    }
}

float32 b2Body::GetInertia() const
{
    // A body that does not rotate has no inertia about its origin either.
    const float32 ofOrigin = m_data.mass * m_data.localCenter.LengthSquared();
    return m_data.inertia > 0.0f ? b2Min(m_data.inertia + ofOrigin, b2_maxFloat) : 0.0f;
}

void b2Body::GetMassData(b2MassData* data) const
{
    if (!B2_REQUIRE(data != nullptr, "GetMassData needs a place for the mass."))
    {
        return;
    }
    data->mass = m_data.mass;
    data->I = GetInertia();
    data->center = m_data.localCenter;
}

void b2Body::SetMassData(const b2MassData* data)
{
    if (IsUnlocked(m_data) && B2_REQUIRE(data != nullptr, "b2Body::SetMassData needs mass data.") &&
        B2_REQUIRE(b2IsValid(data->mass) && data->mass >= 0.0f && b2IsValid(data->I) &&
                       data->I >= 0.0f && box2d::IsWithinReach(data->center),
                   "b2Body::SetMassData needs a mass and an inertia that are finite and not "
                   "negative, and a finite centre of mass."))
    {
        box2d::SetMassData(m_data, *data);
    }
}

void b2Body::ResetMassData()
{
    box2d::ResetMassData(m_data);
}

b2Vec2 b2Body::GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const
{
    return m_data.linearVelocity + b2Cross(m_data.angularVelocity, worldPoint - m_data.worldCenter);
}

b2Vec2 b2Body::GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const
{
    return GetLinearVelocityFromWorldPoint(GetWorldPoint(localPoint));
}

void b2Body::SetLinearDamping(float32 damping)
{
    if (IsDamping(damping))
    {
        m_data.linearDamping = damping;
    }
}

void b2Body::SetAngularDamping(float32 damping)
{
    if (IsDamping(damping))
    {
        m_data.angularDamping = damping;
    }
}

void b2Body::SetGravityScale(float32 scale)
{
    if (B2_REQUIRE(b2IsValid(scale), "A body's gravity scale must be finite."))
    {
        m_data.gravityScale = scale;
    }
}

void b2Body::SetType(b2BodyType type)
{
    const bool known = type == b2_staticBody || type == b2_kinematicBody || type == b2_dynamicBody;
    if (B2_REQUIRE(known, "A body's type must be b2_staticBody, b2_kinematicBody or "
                          "b2_dynamicBody.") &&
        type != GetType() && IsUnlocked(m_data))
    {
        box2d::SetMobility(*m_data.world, *this, static_cast<box2d::Mobility>(type));
    }
}

void b2Body::SetBullet(bool flag)
{
    m_data.world->hasBullets = m_data.world->hasBullets || flag;
    m_data.flags = flag ? m_data.flags | box2d::kBodyBullet
                        : m_data.flags & ~std::uint32_t(box2d::kBodyBullet);
}

void b2Body::SetSleepingAllowed(bool flag)
{
    if (flag)
    {
        m_data.flags |= box2d::kBodyAutoSleep;
        return;
    }
    m_data.flags &= ~std::uint32_t(box2d::kBodyAutoSleep);
    SetAwake(true);
}

void b2Body::SetAwake(bool flag)
{
    flag ? box2d::Wake(*m_data.world, *this) : box2d::PutToSleep(*m_data.world, *this);
}

void b2Body::SetActive(bool flag)
{
    if (IsUnlocked(m_data))
    {
        box2d::SetActive(*m_data.world, *this, flag);
    }
}

void b2Body::SetFixedRotation(bool flag)
{
    if (flag == IsFixedRotation())
    {
        return;
    }
    m_data.flags = flag ? m_data.flags | box2d::kBodyFixedRotation
                        : m_data.flags & ~std::uint32_t(box2d::kBodyFixedRotation);
    m_data.angularVelocity = 0.0f;
    ResetMassData();
}

b2World* b2Body::GetWorld()
{
    return &m_data.world->owner;
}

const b2World* b2Body::GetWorld() const
{
    return &m_data.world->owner;
}

void b2Body::Dump()
{
    b2Log("{\n");
    b2Log("  b2BodyDef bd;\n");
    b2Log("  bd.type = b2BodyType(%d);\n", int(GetType()));
    b2Log("  bd.position.Set(%.8ef, %.8ef);\n", double(GetPosition().x), double(GetPosition().y));
    b2Log("  bd.angle = %.8ef;\n", double(GetAngle()));
    // Velocity of the origin, which is the centre of mass without fixtures.
    const b2Vec2 velocity = GetLinearVelocityFromWorldPoint(GetPosition());
    b2Log("  bd.linearVelocity.Set(%.8ef, %.8ef);\n", double(velocity.x), double(velocity.y));
    b2Log("  bd.angularVelocity = %.8ef;\n", double(GetAngularVelocity()));
    b2Log("  bd.linearDamping = %.8ef;\n", double(GetLinearDamping()));
    b2Log("  bd.angularDamping = %.8ef;\n", double(GetAngularDamping()));
    b2Log("  bd.allowSleep = bool(%d);\n", IsSleepingAllowed());
    b2Log("  bd.awake = bool(%d);\n", IsAwake());
    b2Log("  bd.fixedRotation = bool(%d);\n", IsFixedRotation());
    b2Log("  bd.bullet = bool(%d);\n", IsBullet());
    b2Log("  bd.active = bool(%d);\n", IsActive());
    b2Log("  bd.gravityScale = %.8ef;\n", double(GetGravityScale()));
    b2Log("  bodies[%d] = m_world->CreateBody(&bd);\n", m_data.number);
    box2d::Array<b2Fixture*> fixtures; // oldest first
    for (b2Fixture* f = m_data.fixtureList; f; f = f->GetNext())
    {
        fixtures.insert(fixtures.begin(), f);
    }
    for (b2Fixture* f : fixtures)
    {
        b2Log("  {\n");
        f->Dump(m_data.number);
        b2Log("  }\n");
    }
    if ((m_data.flags & box2d::kBodyMassSet) != 0)
    {
        b2MassData mass;
        GetMassData(&mass);
        b2Log("  b2MassData mass;\n");
        b2Log("  mass.mass = %.8ef;\n", double(mass.mass));
        b2Log("  mass.center.Set(%.8ef, %.8ef);\n", double(mass.center.x), double(mass.center.y));
        b2Log("  mass.I = %.8ef;\n", double(mass.I));
        b2Log("  bodies[%d]->SetMassData(&mass);\n", m_data.number);
    }
    b2Log("}\n");
}
