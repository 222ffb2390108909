// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>

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

void b2DistanceJoint::Prepare(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    m_armA = f.ArmA(m_localAnchorA);
    m_armB = f.ArmB(m_localAnchorB);
    m_offset = f.Offset();
    m_axis = m_offset + m_armB - m_armA;
    const float32 length = m_axis.Normalize();
    if (length == 0.0f)
    {
        m_axis.SetZero(); // no direction to push in
    }
    const float32 k = box2d::AxisMatrix(f, m_axis, m_armA, m_armB);
    const box2d::Softness soft = box2d::MakeSoftness(m_frequencyHz, m_dampingRatio,
                                                     box2d::InverseOrZero(k), context.timeStep);
    m_gamma = soft.gamma;
    m_bias = (length - m_length) * soft.biasRate;
    m_mass = box2d::InverseOrZero(k + m_gamma);
    box2d::Carry(m_impulse, box2d::CarryOver(context));
    f.ApplyImpulse(m_impulse * m_axis, m_armA, m_armB);
}

void b2DistanceJoint::SolveVelocity(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const float32 speed = b2Dot(m_axis, f.PointSpeed(m_armA, m_armB));
    const float32 impulse = -m_mass * (speed + m_bias + m_gamma * m_impulse);
    m_impulse += impulse;
    f.ApplyImpulse(impulse * m_axis, m_armA, m_armB);
}

bool b2DistanceJoint::SolvePosition(const box2d::SolverContext& context)
{
    if (m_frequencyHz > 0.0f)
    {
        return true; // the spring does it
    }
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = b2Mul(f.a.q, m_armA);
    const b2Vec2 armB = b2Mul(f.b.q, m_armB);
    b2Vec2 axis = m_offset + f.b.d - f.a.d + armB - armA;
    const float32 length = axis.Normalize();
    const float32 error =
        b2Clamp(length - m_length, -b2_maxLinearCorrection, b2_maxLinearCorrection);
    const float32 k = box2d::AxisMatrix(f, axis, armA, armB);
    if (length > 0.0f && k > 0.0f)
    {
        f.Move((-error / k) * axis, armA, armB);
    }
    return b2Abs(error) < b2_linearSlop;
}

void b2DistanceJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto line = row.Between(m_localAnchorA, m_localAnchorB);
    m_axis = line.axis;
    row.AddAlong(line.axis, line.armA, line.armB, line.length - m_length);
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
    }
}

void b2DistanceJoint::SetFrequency(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio) && hz != m_frequencyHz)
    {
        WakeBodies();
        m_frequencyHz = hz;
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
