// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>

#include "DistanceLanes.h"
#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// Keep two anchors at length L:  C = |d| - L,  n = d / |d|
//   Cdot = dot(n, vB + wB x rB - vA - wA x rA)
//   K    = mA + mB + iA (rA x n)^2 + iB (rB x n)^2        (mA … inverse masses)
// With a frequency it is a spring along n: see Softness.

void b2DistanceJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchorA,
                                    const b2Vec2& anchorB)
{
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchorA);
    localAnchorB = b->GetLocalPoint(anchorB);
    length = b2Distance(anchorA, anchorB);
}

b2DistanceJoint::b2DistanceJoint(const b2DistanceJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_length(def->length), m_frequencyHz(def->frequencyHz), m_dampingRatio(def->dampingRatio)
{}

void b2DistanceJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_localAnchorA);
    const b2Vec2 armB = f.ArmB(m_localAnchorB);
    const b2Vec2 offset = f.Offset();
    m_axis = offset + armB - armA;
    const float32 length = m_axis.Normalize();
    if (length == 0.0f)
    {
        m_axis.SetZero(); // no direction to push in
    }
    const float32 k = box2d::AxisMatrix(f, m_axis, armA, armB);
    const box2d::Softness soft = box2d::MakeSoftness(m_frequencyHz, m_dampingRatio,
                                                     box2d::InverseOrZero(k), context.timeStep);
    box2d::Carry(m_impulse, box2d::CarryOver(context));

    using Lanes = box2d::DistanceLanes<float32>;
    lane.features = m_frequencyHz > 0.0f ? Lanes::kSpring : 0;
    lane.Write(Lanes{.impulse = m_impulse,
                     .axis = box2d::InLanes(m_axis),
                     .armA = box2d::InLanes(armA),
                     .armB = box2d::InLanes(armB),
                     .offset = box2d::InLanes(offset),
                     .mass = box2d::InverseOrZero(k + soft.gamma),
                     .bias = (length - m_length) * soft.biasRate,
                     .gamma = soft.gamma,
                     .length = m_length,
                     .isSpring = box2d::Flag(m_frequencyHz > 0.0f)});
}

void b2DistanceJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
}

void b2DistanceJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto line = row.Between(m_localAnchorA, m_localAnchorB);
    m_axis = line.axis;
    row.AddLine(line, line.length - m_length);
    if (m_frequencyHz > 0.0f)
    {
        row.GiveToSpring(line.length - m_length, m_frequencyHz, m_dampingRatio);
    }
}

void b2DistanceJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
}

void b2DistanceJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse = within[0];
}

b2Vec2 b2DistanceJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2DistanceJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2DistanceJoint::GetReactionForce(float32 inv_dt) const
{
    return (inv_dt * m_impulse) * m_axis;
}

float32 b2DistanceJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

void b2DistanceJoint::SetLength(float32 length)
{
    if (box2d::IsLength(length) && length != m_length)
    {
        WakeBodies();
        m_length = length;
        NoteChange();
    }
}

void b2DistanceJoint::SetFrequency(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio) && hz != m_frequencyHz)
    {
        WakeBodies();
        m_frequencyHz = hz;
        NoteChange();
    }
}

void b2DistanceJoint::SetDampingRatio(float32 ratio)
{
    if (box2d::IsSpring(m_frequencyHz, ratio) && ratio != m_dampingRatio)
    {
        WakeBodies();
        m_dampingRatio = ratio;
    }
}

void b2DistanceJoint::Dump()
{
    box2d::DumpBodies("b2DistanceJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("length", m_length);
    box2d::DumpNumber("frequencyHz", m_frequencyHz);
    box2d::DumpNumber("dampingRatio", m_dampingRatio);
    box2d::DumpEnd(m_number);
}
