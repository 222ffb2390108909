// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2FrictionJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// The relative velocity of the anchors and the relative angular velocity are driven to zero, each
// with a bounded impulse.

void b2FrictionJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor)
{
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
}

b2FrictionJoint::b2FrictionJoint(const b2FrictionJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_maxForce(def->maxForce), m_maxTorque(def->maxTorque)
{}

void b2FrictionJoint::Prepare(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    m_armA = f.ArmA(m_localAnchorA);
    m_armB = f.ArmB(m_localAnchorB);
    box2d::Carry(m_impulse, box2d::CarryOver(context));
    box2d::Carry(m_angularImpulse, box2d::CarryOver(context));
    f.ApplyImpulse(m_impulse, m_armA, m_armB);
    f.ApplyAngularImpulse(m_angularImpulse);
}

void b2FrictionJoint::SolveVelocity(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const float32 maxTurn = context.timeStep * m_maxTorque;
    const float32 turn = b2Clamp(
        m_angularImpulse - box2d::InverseOrZero(f.iA + f.iB) * (f.b.w - f.a.w), -maxTurn, maxTurn);
    f.ApplyAngularImpulse(turn - m_angularImpulse);
    m_angularImpulse = turn;

    const b2Vec2 wanted =
        m_impulse + box2d::PointMatrix(f, m_armA, m_armB).Solve(-f.PointSpeed(m_armA, m_armB));
    const b2Vec2 total = box2d::ClampLength(wanted, context.timeStep * m_maxForce);
    f.ApplyImpulse(total - m_impulse, m_armA, m_armB);
    m_impulse = total;
}

bool b2FrictionJoint::SolvePosition(const box2d::SolverContext&)
{
    return true;
}

void b2FrictionJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const b2Vec2 armA = row.ArmA(m_localAnchorA);
    const b2Vec2 armB = row.ArmB(m_localAnchorB);
    row.AddPoint(armA, armB, b2Vec2(0.0f, 0.0f));
    row.GiveToFriction(m_maxForce, m_maxTorque);
}

void b2FrictionJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
    impulse[2] = m_angularImpulse;
}

void b2FrictionJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_angularImpulse = within[2];
}

b2Vec2 b2FrictionJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2FrictionJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2FrictionJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * m_impulse;
}

float32 b2FrictionJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_angularImpulse;
}

void b2FrictionJoint::SetMaxForce(float32 force)
{
    if (box2d::AreForces(force, m_maxTorque) && force != m_maxForce)
    {
        WakeBodies();
        m_maxForce = force;
    }
}

void b2FrictionJoint::SetMaxTorque(float32 torque)
{
    if (box2d::AreForces(m_maxForce, torque) && torque != m_maxTorque)
    {
        WakeBodies();
        m_maxTorque = torque;
    }
}

void b2FrictionJoint::Dump()
{
    box2d::DumpBodies("b2FrictionJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("maxForce", m_maxForce);
    box2d::DumpNumber("maxTorque", m_maxTorque);
    box2d::DumpEnd(m_number);
}
