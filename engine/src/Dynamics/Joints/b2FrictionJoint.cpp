// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2FrictionJoint.h>

#include "FrictionLanes.h"
#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// The relative velocity of the anchors and the relative angular velocity are driven to zero, each
// with a bounded impulse.

void b2FrictionJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
}

b2FrictionJoint::b2FrictionJoint(const b2FrictionJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_maxForce(def->maxForce), m_maxTorque(def->maxTorque)
{}

void b2FrictionJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));
    box2d::Scale(m_angularImpulse, box2d::WarmStartFactor(context, *this));

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_localAnchorA);
    const b2Vec2 armB = f.ArmB(m_localAnchorB);
    lane.Write(box2d::FrictionLanes<float32>{.impulse = box2d::InLanes(m_impulse),
                                             .angularImpulse = m_angularImpulse,
                                             .maximum = context.timeStep * m_maxForce,
                                             .maxAngular = context.timeStep * m_maxTorque,
                                             .armA = box2d::InLanes(armA),
                                             .armB = box2d::InLanes(armB),
                                             .inverse = box2d::InversePointMatrix(f, armA, armB),
                                             .angularMass = box2d::InverseOrZero(f.iA + f.iB)});
}

void b2FrictionJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
    m_angularImpulse = lane[2];
}

void b2FrictionJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    row.AddPoint(m_localAnchorA, m_localAnchorB);
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
