// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2Joint.h>

#include "../State/World.h"

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

namespace
{

/// Returns the reduced mass of an oscillator of two bodies; a mass of 0 is static.
float32 ReducedMass(float32 a, float32 b)
{
    return a > 0.0f && b > 0.0f ? a * b / (a + b) : a + b;
}

// m x'' + c x' + k x = 0  with  k = m omega^2,  c = 2 zeta m omega,  omega = 2 pi f.
void SpringOf(float32 mass, float32 frequencyHertz, float32 dampingRatio, float32& stiffness,
              float32& damping)
{
    const float32 omega = 2.0f * b2_pi * frequencyHertz;
    stiffness = mass * omega * omega;
    damping = 2.0f * dampingRatio * mass * omega;
}

} // namespace

void b2LinearStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                       float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB)
{
    SpringOf(ReducedMass(bodyA->GetMass(), bodyB->GetMass()), frequencyHertz, dampingRatio,
             stiffness, damping);
}

void b2AngularStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                        float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB)
{
    SpringOf(ReducedMass(bodyA->GetInertia(), bodyB->GetInertia()), frequencyHertz, dampingRatio,
             stiffness, damping);
}
