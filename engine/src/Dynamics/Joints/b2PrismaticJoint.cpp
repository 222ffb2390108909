// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// With d = xB + rB - xA - rA, the axis a fixed in A, t = (0, 0, 1) x a:
//   across:   C1 = dot(t, d),                 Cdot1 = dot(t, vB - vA) + (rB x t) wB - ((d + rA) x
//   t) wA turning:  C2 = aB - aA - reference,       Cdot2 = wB - wA along:    the same as across
//   with a for t, for the motor and the limit
// Across and turning are solved together, along by itself.

namespace
{

/// The two coupled rows and how far the arms reach across and along the axis.
struct Rows
{
    b2Vec2 axis, across;
    float32 axisA, axisB;     // (d + rA) x a, rB x a
    float32 acrossA, acrossB; // (d + rA) x t, rB x t

    Rows(const b2Vec2& a, const b2Vec2& reachA, const b2Vec2& armB)
        : axis(a), across(b2Cross(1.0f, a)), axisA(b2Cross(reachA, axis)),
          axisB(b2Cross(armB, axis)), acrossA(b2Cross(reachA, across)),
          acrossB(b2Cross(armB, across))
    {}

    b2Mat22 Matrix(const box2d::JointFrame& f) const
    {
        const float32 k11 = f.mA + f.mB + f.iA * acrossA * acrossA + f.iB * acrossB * acrossB;
        const float32 k12 = f.iA * acrossA + f.iB * acrossB;
        const float32 k22 = f.iA + f.iB;
        return b2Mat22(k11, k12, k12, k22 > 0.0f ? k22 : 1.0f); // two bodies that cannot turn
    }
    float32 AxialMatrix(const box2d::JointFrame& f) const
    {
        return f.mA + f.mB + f.iA * axisA * axisA + f.iB * axisB * axisB;
    }
    float32 AxialSpeed(const box2d::JointFrame& f) const
    {
        return b2Dot(axis, f.b.v - f.a.v) + axisB * f.b.w - axisA * f.a.w;
    }
    void ApplyAxial(const box2d::JointFrame& f, float32 impulse) const
    {
        f.a.v -= (f.mA * impulse) * axis;
        f.a.w -= f.iA * axisA * impulse;
        f.b.v += (f.mB * impulse) * axis;
        f.b.w += f.iB * axisB * impulse;
    }
    void Apply(const box2d::JointFrame& f, const b2Vec2& impulse) const
    {
        f.a.v -= (f.mA * impulse.x) * across;
        f.a.w -= f.iA * (acrossA * impulse.x + impulse.y);
        f.b.v += (f.mB * impulse.x) * across;
        f.b.w += f.iB * (acrossB * impulse.x + impulse.y);
    }
};

} // namespace

void b2PrismaticJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor, const b2Vec2& axis)
{
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    localAxisA = a->GetLocalVector(axis);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

b2PrismaticJoint::b2PrismaticJoint(const b2PrismaticJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_localAxisA(def->localAxisA), m_referenceAngle(def->referenceAngle),
      m_enableLimit(def->enableLimit), m_lowerTranslation(def->lowerTranslation),
      m_upperTranslation(def->upperTranslation), m_enableMotor(def->enableMotor),
      m_maxMotorForce(def->maxMotorForce), m_motorSpeed(def->motorSpeed)
{
    if (m_localAxisA.Normalize() == 0.0f)
    {
        m_localAxisA.Set(1.0f, 0.0f);
    }
}

void b2PrismaticJoint::Prepare(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    m_armA = f.ArmA(m_localAnchorA);
    m_armB = f.ArmB(m_localAnchorB);
    m_offset = f.Offset();
    m_axis = b2Mul(f.dataA.rotation, m_localAxisA);
    m_translation = b2Dot(m_axis, m_offset + m_armB - m_armA);
    m_angleError = float32(f.dataB.pose.angle - f.dataA.pose.angle - double(m_referenceAngle));
    const Rows rows(m_axis, m_offset + m_armB, m_armB);
    m_axialMass = box2d::InverseOrZero(rows.AxialMatrix(f));

    const float32 share = box2d::CarryOver(context);
    box2d::Carry(m_impulse, share);
    box2d::Carry(m_motorImpulse, m_enableMotor ? share : 0.0f);
    box2d::Carry(m_lowerImpulse, m_enableLimit ? share : 0.0f);
    box2d::Carry(m_upperImpulse, m_enableLimit ? share : 0.0f);
    rows.ApplyAxial(f, m_motorImpulse + m_lowerImpulse - m_upperImpulse);
    rows.Apply(f, m_impulse);
}

void b2PrismaticJoint::SolveVelocity(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const Rows rows(m_axis, m_offset + m_armB, m_armB);
    if (m_enableMotor)
    {
        const float32 limit = context.timeStep * m_maxMotorForce;
        const float32 wanted = m_motorImpulse + m_axialMass * (m_motorSpeed - rows.AxialSpeed(f));
        const float32 total = b2Clamp(wanted, -limit, limit);
        rows.ApplyAxial(f, total - m_motorImpulse);
        m_motorImpulse = total;
    }
    if (m_enableLimit)
    {
        const float32 aboveLower =
            b2Max(m_translation - m_lowerTranslation, 0.0f) * context.inverseStep;
        const float32 lower =
            b2Max(m_lowerImpulse - m_axialMass * (rows.AxialSpeed(f) + aboveLower), 0.0f);
        rows.ApplyAxial(f, lower - m_lowerImpulse);
        m_lowerImpulse = lower;

        const float32 belowUpper =
            b2Max(m_upperTranslation - m_translation, 0.0f) * context.inverseStep;
        const float32 upper =
            b2Max(m_upperImpulse - m_axialMass * (belowUpper - rows.AxialSpeed(f)), 0.0f);
        rows.ApplyAxial(f, m_upperImpulse - upper);
        m_upperImpulse = upper;
    }
    const b2Vec2 speed(b2Dot(rows.across, f.b.v - f.a.v) + rows.acrossB * f.b.w -
                           rows.acrossA * f.a.w,
                       f.b.w - f.a.w);
    const b2Vec2 impulse = rows.Matrix(f).Solve(-speed);
    m_impulse += impulse;
    rows.Apply(f, impulse);
}

bool b2PrismaticJoint::SolvePosition(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = b2Mul(f.a.q, m_armA);
    const b2Vec2 armB = b2Mul(f.b.q, m_armB);
    const b2Vec2 reachA = m_offset + f.b.d - f.a.d + armB; // d + rA
    const b2Vec2 d = reachA - armA;
    const Rows rows(b2Mul(f.a.q, m_axis), reachA, armB);

    float32 limitError = 0.0f;
    if (m_enableLimit)
    {
        const float32 translation = b2Dot(rows.axis, d);
        const float32 inside = b2Clamp(translation, m_lowerTranslation, m_upperTranslation);
        limitError = b2Abs(translation - inside);
        const float32 push =
            b2Clamp(inside - translation, -b2_maxLinearCorrection, b2_maxLinearCorrection);
        const float32 impulse = push * box2d::InverseOrZero(rows.AxialMatrix(f));
        f.a.d -= (f.mA * impulse) * rows.axis;
        f.a.Rotate(-f.iA * rows.axisA * impulse);
        f.b.d += (f.mB * impulse) * rows.axis;
        f.b.Rotate(f.iB * rows.axisB * impulse);
    }
    const b2Vec2 error(b2Dot(rows.across, d), m_angleError + f.b.angle - f.a.angle);
    const b2Vec2 impulse = rows.Matrix(f).Solve(-error);
    f.a.d -= (f.mA * impulse.x) * rows.across;
    f.a.Rotate(-f.iA * (rows.acrossA * impulse.x + impulse.y));
    f.b.d += (f.mB * impulse.x) * rows.across;
    f.b.Rotate(f.iB * (rows.acrossB * impulse.x + impulse.y));
    return b2Max(b2Abs(error.x), limitError) <= b2_linearSlop && b2Abs(error.y) <= b2_angularSlop;
}

void b2PrismaticJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto slide = row.AddSlide(m_localAnchorA, m_localAnchorB, m_localAxisA);
    m_axis = slide.axis;
    row.AddAngle(float32(row.Angle() - double(m_referenceAngle)));
    if (m_enableMotor || m_enableLimit)
    {
        row.AddAlong(slide.axis, slide.reachA, slide.armB, 0.0f);
        row.GiveToMotor(m_motorSpeed, m_enableMotor ? m_maxMotorForce : 0.0f);
        if (m_enableLimit)
        {
            row.GiveToLimit(slide.translation, m_lowerTranslation, m_upperTranslation);
        }
    }
}

void b2PrismaticJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
    impulse[2] = m_motorImpulse + m_lowerImpulse - m_upperImpulse;
}

void b2PrismaticJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_motorImpulse = within[2];
    m_lowerImpulse = b2Max(beyond[2], 0.0f);
    m_upperImpulse = b2Max(-beyond[2], 0.0f);
}

b2Vec2 b2PrismaticJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2PrismaticJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2PrismaticJoint::GetReactionForce(float32 inv_dt) const
{
    const float32 axial = m_motorImpulse + m_lowerImpulse - m_upperImpulse;
    return inv_dt * (m_impulse.x * b2Cross(1.0f, m_axis) + axial * m_axis);
}

float32 b2PrismaticJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_impulse.y;
}

float32 b2PrismaticJoint::GetJointTranslation() const
{
    const box2d::BodyData& a = box2d::Data(*m_bodyA);
    const box2d::BodyData& b = box2d::Data(*m_bodyB);
    const b2Vec2 d = box2d::CenterOffset(a, b) + b2Mul(b.rotation, m_localAnchorB - b.localCenter) -
                     b2Mul(a.rotation, m_localAnchorA - a.localCenter);
    return b2Dot(d, b2Mul(a.rotation, m_localAxisA));
}

float32 b2PrismaticJoint::GetJointSpeed() const
{
    const box2d::BodyData& a = box2d::Data(*m_bodyA);
    const box2d::BodyData& b = box2d::Data(*m_bodyB);
    const b2Vec2 armB = b2Mul(b.rotation, m_localAnchorB - b.localCenter);
    const b2Vec2 reachA = box2d::CenterOffset(a, b) + armB;
    const b2Vec2 axis = b2Mul(a.rotation, m_localAxisA);
    return b2Dot(axis, b.linearVelocity - a.linearVelocity) +
           b2Cross(armB, axis) * b.angularVelocity - b2Cross(reachA, axis) * a.angularVelocity;
}

float32 b2PrismaticJoint::GetMotorForce(float32 inv_dt) const
{
    return inv_dt * m_motorImpulse;
}

float32 b2PrismaticJoint::GetMotorForce() const
{
    return GetMotorForce(LastInverseStep());
}

void b2PrismaticJoint::EnableLimit(bool flag)
{
    if (flag != m_enableLimit)
    {
        WakeBodies();
        m_enableLimit = flag;
        m_lowerImpulse = 0.0f;
        m_upperImpulse = 0.0f;
    }
}

void b2PrismaticJoint::SetLimits(float32 lower, float32 upper)
{
    if (!box2d::AreLimits(true, lower, upper))
    {
        return;
    }
    if (lower != m_lowerTranslation || upper != m_upperTranslation)
    {
        WakeBodies();
        m_lowerTranslation = lower;
        m_upperTranslation = upper;
        m_lowerImpulse = 0.0f;
        m_upperImpulse = 0.0f;
    }
}

void b2PrismaticJoint::EnableMotor(bool flag)
{
    WakeBodies();
    m_enableMotor = flag;
}

void b2PrismaticJoint::SetMotorSpeed(float32 speed)
{
    if (box2d::IsMotor(speed, m_maxMotorForce))
    {
        WakeBodies();
        m_motorSpeed = speed;
    }
}

void b2PrismaticJoint::SetMaxMotorForce(float32 force)
{
    if (box2d::IsMotor(m_motorSpeed, force))
    {
        WakeBodies();
        m_maxMotorForce = force;
    }
}

void b2PrismaticJoint::Dump()
{
    box2d::DumpBodies("b2PrismaticJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpPoint("localAxisA", m_localAxisA);
    box2d::DumpNumber("referenceAngle", m_referenceAngle);
    box2d::DumpFlag("enableLimit", m_enableLimit);
    box2d::DumpNumber("lowerTranslation", m_lowerTranslation);
    box2d::DumpNumber("upperTranslation", m_upperTranslation);
    box2d::DumpFlag("enableMotor", m_enableMotor);
    box2d::DumpNumber("motorSpeed", m_motorSpeed);
    box2d::DumpNumber("maxMotorForce", m_maxMotorForce);
    box2d::DumpEnd(m_number);
}
