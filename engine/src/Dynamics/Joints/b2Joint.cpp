// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2Joint.h>

#include "../World.h"

#include <Box2D/Dynamics/b2Body.h>

b2Joint::b2Joint(const b2JointDef* def)
    : m_type(def->type), m_bodyA(def->bodyA), m_bodyB(def->bodyB),
      m_collideConnected(def->collideConnected), m_userData(def->userData)
{}

bool b2Joint::IsActive() const
{
    return m_bodyA->IsActive() && m_bodyB->IsActive();
}

float32 b2Joint::LastInverseStep() const
{
    return box2d::Data(*m_bodyA).world->inverseStep;
}

b2Vec2 b2Joint::GetReactionForce() const
{
    return GetReactionForce(LastInverseStep());
}

float32 b2Joint::GetReactionTorque() const
{
    return GetReactionTorque(LastInverseStep());
}

void b2Joint::Dump()
{
    b2Log("// A joint of type %d has no code form.\n", int(m_type));
}

void b2Joint::WakeBodies()
{
    m_bodyA->SetAwake(true);
    m_bodyB->SetAwake(true);
}

void b2Joint::NoteChange()
{
    m_changedAt = box2d::Data(*m_bodyA).world->stepNumber;
}
