// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2RopeJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "RopeLanes.h"

// The distance joint as an inequality: C = |d| - L <= 0. While the rope is slack, the separation
// speed is at most the one that makes it taut at the end of this step.

b2RopeJoint::b2RopeJoint(const b2RopeJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_maxLength(def->maxLength)
{}

void b2RopeJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_localAnchorA);
    const b2Vec2 armB = f.ArmB(m_localAnchorB);
    const b2Vec2 offset = f.Offset();
    m_axis = offset + armB - armA;
    m_length = m_axis.Length();
    if (m_axis.Normalize() == 0.0f)
    {
        m_axis.SetZero();
    }
    const float32 k = box2d::AxisMatrix(f, m_axis, armA, armB);
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));

    lane.Write(box2d::RopeLanes<float32>{.impulse = m_impulse,
                                         .axis = box2d::InLanes(m_axis),
                                         .armA = box2d::InLanes(armA),
                                         .armB = box2d::InLanes(armB),
                                         .offset = box2d::InLanes(offset),
                                         .mass = m_length > 0.0f ? box2d::InverseOrZero(k) : 0.0f,
                                         .slack = b2Max(m_maxLength - m_length, 0.0f) *
                                                  context.inverseStep,
                                         .maxLength = m_maxLength});
}

void b2RopeJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
}

void b2RopeJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto line = row.f.Between(m_localAnchorA, m_localAnchorB);
    m_axis = line.axis;
    row.AddLine(line, 0.0f);
    row.GiveToMotor(0.0f, 0.0f);
    row.GiveToLimit(line.length, -b2_maxFloat, m_maxLength);
}

void b2RopeJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
}

void b2RopeJoint::SetRowImpulses(const float32 (&)[3], const float32 (&beyond)[3])
{
    m_impulse = beyond[0];
}

b2Vec2 b2RopeJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2RopeJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2RopeJoint::GetReactionForce(float32 inv_dt) const
{
    return (inv_dt * m_impulse) * m_axis;
}

float32 b2RopeJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

b2LimitState b2RopeJoint::GetLimitState() const
{
    return m_impulse < 0.0f ? e_atUpperLimit : e_inactiveLimit;
}

void b2RopeJoint::SetMaxLength(float32 length)
{
    if (box2d::IsLength(length) && length != m_maxLength)
    {
        WakeBodies();
        m_maxLength = length;
        NoteChange();
    }
}

void b2RopeJoint::Dump()
{
    box2d::DumpBodies("b2RopeJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("maxLength", m_maxLength);
    box2d::DumpEnd(m_number);
}
