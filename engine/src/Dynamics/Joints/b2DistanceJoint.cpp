// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>

#include "DistanceKind.h"
#include "DistanceLanes.h"
#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// Keep two anchors at length L:  C = |d| - L,  n = d / |d|
//   Cdot = dot(n, vB + wB x rB - vA - wA x rA)
//   K    = mA + mB + iA (rA x n)^2 + iB (rB x n)^2        (mA … inverse masses)
// With a frequency it is a spring along n: see Softness. Limits are inequalities on |d|; the
// approach speed is at most the one that reaches the limit at the end of this step.

void b2DistanceJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchorA,
                                    const b2Vec2& anchorB)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
    localAnchorA = a->GetLocalPoint(anchorA);
    localAnchorB = b->GetLocalPoint(anchorB);
    length = b2Distance(anchorA, anchorB);
}

namespace
{

// A definition with both defaults has no limits: a rod or spring of 2.3. All other limits are
// clamped as in 2.4. They are never shorter than the slop, because a shorter distance has no sound
// direction.

bool HasNoLimits(float32 minLength, float32 maxLength)
{
    return minLength == 0.0f && maxLength == b2_maxFloat;
}

} // namespace

b2DistanceJoint::b2DistanceJoint(const b2DistanceJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_length(def->length), m_frequencyHz(def->frequencyHz), m_dampingRatio(def->dampingRatio),
      m_minLength(def->minLength), m_maxLength(b2Min(def->maxLength, b2_maxFloat))
{
    if (!HasNoLimits(m_minLength, m_maxLength))
    {
        m_minLength = b2Max(m_minLength, b2_linearSlop);
        m_maxLength = b2Max(m_maxLength, m_minLength);
    }
    ChooseForm();
}

void b2DistanceJoint::ChooseForm()
{
    const bool isRod = m_minLength == m_maxLength;
    m_isLimited = !isRod && !HasNoLimits(m_minLength, m_maxLength);
    m_restLength = isRod ? m_minLength : m_length;
    m_springHz = isRod ? 0.0f : m_frequencyHz;
}

void b2DistanceJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const auto line = f.Between(m_localAnchorA, m_localAnchorB);
    m_axis = line.axis;
    const float32 k = box2d::AxisMatrix(f, line.axis, line.armA, line.armB);
    const box2d::Softness soft =
        box2d::MakeSoftness(m_springHz, m_dampingRatio, box2d::InverseOrZero(k), context.timeStep);
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));

    using Lanes = box2d::DistanceLanes<float32>;
    static_assert(sizeof(Lanes) == sizeof(float32) * (Lanes::kPlainNumbers + Lanes::kLimitNumbers));
    const bool isSpring = m_springHz > 0.0f;
    lane.features = isSpring ? Lanes::kSpring : 0;
    Lanes lanes;
    lanes.impulse = m_impulse;
    lanes.lowerImpulse = lanes.upperImpulse = 0.0f;
    lanes.axis = box2d::InLanes(m_axis);
    lanes.armA = box2d::InLanes(line.armA);
    lanes.armB = box2d::InLanes(line.armB);
    lanes.offset = box2d::InLanes(f.Offset());
    lanes.mass = box2d::InverseOrZero(k + soft.gamma);
    lanes.bias = (line.length - m_restLength) * soft.biasRate;
    lanes.gamma = soft.gamma;
    lanes.length = m_restLength;
    lanes.form = isSpring ? float32(Lanes::kSpringForm) : float32(Lanes::kRodForm);
    if (!m_isLimited)
    {
        lane.Write(lanes, Lanes::kPlainNumbers);
        return;
    }
    box2d::Scale(m_lowerImpulse, box2d::WarmStartFactor(context, *this));
    box2d::Scale(m_upperImpulse, box2d::WarmStartFactor(context, *this));
    const float32 toLower = b2Max(line.length - m_minLength, 0.0f);
    // To a limit that there is not: what no body goes in a step.
    const float32 toUpper = b2Clamp(m_maxLength - line.length, 0.0f, box2d::kReach);
    lane.features = Lanes::kLimits;
    lanes.form = float32(Lanes::kLimitedForm);
    if (!isSpring) // free between the limits
    {
        lanes.impulse = lanes.mass = 0.0f;
    }
    lanes.lowerImpulse = m_lowerImpulse;
    lanes.upperImpulse = m_upperImpulse;
    lanes.limits = {.mass = line.length > 0.0f ? box2d::InverseOrZero(k) : 0.0f,
                    .lower = m_minLength,
                    .upper = m_maxLength,
                    .lowerSpeed = toLower * context.inverseStep,
                    .upperSpeed = toUpper * context.inverseStep};
    lane.Write(lanes);
}

void b2DistanceJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
    if (m_isLimited)
    {
        m_lowerImpulse = lane[1];
        m_upperImpulse = lane[2];
    }
}

void b2DistanceJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto line = row.f.Between(m_localAnchorA, m_localAnchorB);
    m_axis = line.axis;
    row.AddLine(line, line.length - m_restLength);
    if (m_springHz > 0.0f)
    {
        row.GiveToSpring(line.length - m_restLength, m_springHz, m_dampingRatio);
    }
    if (!m_isLimited)
    {
        return;
    }
    if (m_springHz > 0.0f)
    {
        row.AddAlong(line.axis, line.armA, line.armB, 0.0f);
    }
    row.GiveToMotor(0.0f, 0.0f);
    row.GiveToLimit(line.length, m_minLength, m_maxLength);
}

void b2DistanceJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
    if (m_isLimited)
    {
        impulse[m_springHz > 0.0f ? 1 : 0] = m_lowerImpulse - m_upperImpulse;
    }
}

void b2DistanceJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3])
{
    m_impulse = within[0];
    if (m_isLimited)
    {
        const float32 limits = beyond[m_springHz > 0.0f ? 1 : 0];
        m_lowerImpulse = b2Max(limits, 0.0f);
        m_upperImpulse = b2Max(-limits, 0.0f);
    }
}

box2d::SpringState box2d::JointAccess::Kind<b2DistanceJoint>::SpringOf(const b2DistanceJoint& joint,
                                                                       const JointPair& pair)
{
    const b2Vec2 armA = pair.ArmA(joint.GetLocalAnchorA());
    const b2Vec2 armB = pair.ArmB(joint.GetLocalAnchorB());
    b2Vec2 axis = pair.Offset() + armB - armA;
    SpringState spring;
    spring.error = double(axis.Normalize() - joint.GetLength());
    spring.stiffness = StiffnessOf(pair.InverseMass(armA, armB, axis), joint.GetFrequency());
    return spring;
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
    return (inv_dt * (m_impulse + m_lowerImpulse - m_upperImpulse)) * m_axis;
}

float32 b2DistanceJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

float32 b2DistanceJoint::SetLength(float32 length)
{
    if (box2d::IsLength(length) && length != m_length)
    {
        WakeBodies();
        m_length = length;
        ChooseForm();
        NoteChange();
    }
    return m_length;
}

float32 b2DistanceJoint::SetMinLength(float32 minLength)
{
    if (box2d::AreLengthLimits(minLength, m_maxLength))
    {
        SetLimits(b2Clamp(minLength, b2_linearSlop, m_maxLength), m_maxLength);
    }
    return m_minLength;
}

float32 b2DistanceJoint::SetMaxLength(float32 maxLength)
{
    if (box2d::AreLengthLimits(m_minLength, maxLength))
    {
        const float32 minLength = b2Max(m_minLength, b2_linearSlop);
        SetLimits(minLength, b2Clamp(maxLength, minLength, b2_maxFloat));
    }
    return m_maxLength;
}

void b2DistanceJoint::SetLimits(float32 minLength, float32 maxLength)
{
    if (minLength != m_minLength || maxLength != m_maxLength)
    {
        WakeBodies();
        m_minLength = minLength;
        m_maxLength = maxLength;
        m_lowerImpulse = m_upperImpulse = 0.0f;
        ChooseForm();
        NoteChange();
    }
}

float32 b2DistanceJoint::GetCurrentLength() const
{
    return b2Distance(GetAnchorA(), GetAnchorB());
}

void b2DistanceJoint::SetFrequency(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio) && hz != m_frequencyHz)
    {
        WakeBodies();
        m_frequencyHz = hz;
        ChooseForm();
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
    if (!HasNoLimits(m_minLength, m_maxLength))
    {
        box2d::DumpNumber("minLength", m_minLength);
        box2d::DumpNumber("maxLength", m_maxLength);
    }
    box2d::DumpEnd(m_number);
}
