// SPDX-License-Identifier: MIT
#include "Listeners.h"

namespace fuzz
{

void Listeners::Trespass(b2Body* body)
{
    if (!m_choices.Wild() || !m_choices.Rarely(8))
    {
        return;
    }
    b2BodyDef def;
    m_world.CreateBody(&def);
    m_world.DestroyBody(body);
    if (body->GetFixtureList())
    {
        body->DestroyFixture(body->GetFixtureList());
    }
    if (m_world.GetJointList())
    {
        m_world.DestroyJoint(m_world.GetJointList());
    }
    body->SetTransform(b2Vec2(1.0f, 1.0f), 0.0f);
    body->SetType(b2_staticBody);
    body->SetActive(false);
    m_world.Step(1.0f / 60.0f, 1, 1);
    m_world.ShiftOrigin(b2Vec2(1.0f, 0.0f));
}

void Listeners::Touch(b2Contact* contact)
{
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold);
    if (m_choices.Rarely(10))
    {
        contact->GetFixtureA()->GetBody()->SetLinearVelocity(m_choices.Vector(20.0f));
    }
    if (m_world.IsLocked())
    {
        Trespass(contact->GetFixtureB()->GetBody());
    }
}

void Listeners::PreSolve(b2Contact* contact, const b2Manifold* oldManifold)
{
    b2PointState before[b2_maxManifoldPoints], after[b2_maxManifoldPoints];
    b2GetPointStates(before, after, oldManifold, contact->GetManifold());
    switch (m_choices.Number(0, 15))
    {
    case 1:
        contact->SetEnabled(false);
        break;
    case 2:
        contact->SetFriction(m_choices.Real(0.0f, 1.0f));
        break;
    case 3:
        contact->SetRestitution(m_choices.Real(0.0f, 1.0f));
        break;
    case 4:
        contact->SetTangentSpeed(m_choices.Real(-5.0f, 5.0f));
        break;
    default:
        break;
    }
    Trespass(contact->GetFixtureA()->GetBody());
}

void Listeners::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse)
{
    if (impulse->count > 0 && m_choices.Rarely(20))
    {
        b2Body* body = contact->GetFixtureB()->GetBody();
        body->ApplyLinearImpulse(m_choices.Vector(5.0f), body->GetWorldCenter());
    }
    Trespass(contact->GetFixtureB()->GetBody());
}

bool Listeners::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB)
{
    return b2ContactFilter::ShouldCollide(fixtureA, fixtureB) && !m_choices.Rarely(16);
}

void Listeners::SayGoodbye(b2Joint* joint)
{
    joint->SetUserData(nullptr);
}

void Listeners::SayGoodbye(b2Fixture* fixture)
{
    fixture->SetUserData(nullptr);
}

bool Listeners::ReportFixture(b2Fixture* fixture)
{
    Trespass(fixture->GetBody());
    return !m_choices.Rarely(8);
}

float32 Listeners::ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float32 fraction)
{
    Trespass(fixture->GetBody());
    const float32 answers[4] = {fraction, 1.0f, -1.0f, 0.0f};
    return answers[m_choices.Number(0, 3)];
}

} // namespace fuzz
