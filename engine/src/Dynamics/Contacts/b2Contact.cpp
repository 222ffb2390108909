// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Contacts/b2Contact.h>

#include "../Islands/Sleep.h"
#include "../State/Access.h"
#include "Narrowphase.h"

#include <Box2D/Dynamics/b2Body.h>

namespace
{

/// The next update looks at what the program may have changed, or is about to.
void NoteUserChange(const box2d::ContactData& c)
{
    if (c.awakeIndex != -1)
    {
        box2d::LookAgain(*box2d::Data(*c.bodyA).world, c);
    }
}

} // namespace

b2Manifold* b2Contact::GetManifold()
{
    NoteUserChange(m_data);
    return &m_data.manifold;
}

void b2Contact::GetWorldManifold(b2WorldManifold* worldManifold) const
{
    worldManifold->Initialize(&m_data.manifold, m_data.bodyA->GetTransform(), m_data.radiusA,
                              m_data.bodyB->GetTransform(), m_data.radiusB);
}

void b2Contact::SetEnabled(bool flag)
{
    m_data.flags = flag ? m_data.flags | box2d::kContactEnabled
                        : m_data.flags & ~std::uint32_t(box2d::kContactEnabled);
    NoteUserChange(m_data);
}

void b2Contact::SetFriction(float32 friction)
{
    if (B2_REQUIRE(b2IsValid(friction) && friction >= 0.0f,
                   "A contact's friction must be finite and not negative."))
    {
        m_data.friction = friction;
    }
}

void b2Contact::SetRestitution(float32 restitution)
{
    if (B2_REQUIRE(b2IsValid(restitution) && restitution >= 0.0f,
                   "A contact's restitution must be finite and not negative."))
    {
        m_data.restitution = restitution;
    }
}

void b2Contact::SetTangentSpeed(float32 speed)
{
    if (B2_REQUIRE(b2IsValid(speed), "A contact's tangent speed must be finite."))
    {
        m_data.SetTangentSpeed(speed);
    }
}

void b2Contact::ResetFriction()
{
    const float32 mixed =
        b2MixFriction(m_data.FixtureA()->GetFriction(), m_data.FixtureB()->GetFriction());
    m_data.friction = b2Min(mixed, b2_maxFloat); // the product can overflow before its root is
                                                 // taken
}

void b2Contact::ResetRestitution()
{
    m_data.restitution =
        b2MixRestitution(m_data.FixtureA()->GetRestitution(), m_data.FixtureB()->GetRestitution());
}

void b2Contact::Evaluate(b2Manifold* manifold, const b2Transform& xfA, const b2Transform& xfB)
{
    box2d::Collide(manifold, *m_data.FixtureA()->GetShape(), m_data.ChildA(),
                   *m_data.FixtureB()->GetShape(), b2MulT(xfA, xfB));
}
