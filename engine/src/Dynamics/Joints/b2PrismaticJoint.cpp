// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "PrismaticLanes.h"

// With d = xB + rB - xA - rA, the axis a fixed in A, t = (0, 0, 1) x a:
//   across:   C1 = dot(t, d)
//             Cdot1 = dot(t, vB - vA) + (rB x t) wB - ((d + rA) x t) wA
//   turning:  C2 = aB - aA - reference,  Cdot2 = wB - wA
//   along:    the same as across with a for t, for the motor and the limit
// Across and turning are solved together; motor and limit with these two held.

void b2PrismaticJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor, const b2Vec2& axis)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
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

void b2PrismaticJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const float32 share = box2d::WarmStartFactor(context, *this);
    box2d::Scale(m_impulse, share);
    box2d::Scale(m_motorImpulse, m_enableMotor ? share : 0.0f);
    box2d::Scale(m_limitImpulse, m_enableLimit ? share : 0.0f);

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const auto slide = f.Along(m_localAxisA, m_localAnchorA, m_localAnchorB);
    m_axis = slide.axis;
    const double angle = f.Angle() - double(m_referenceAngle);
    const float32 axisA = b2Cross(slide.reachA, m_axis);
    const float32 axisB = b2Cross(slide.armB, m_axis);
    const b2Vec2 across = b2Cross(1.0f, m_axis);
    const float32 acrossA = b2Cross(slide.reachA, across);
    const float32 acrossB = b2Cross(slide.armB, across);
    using OneLane = box2d::PrismaticLanes<box2d::simd::Float1>;
    const OneLane::Levers levers = {{axisA}, {axisB}, {acrossA}, {acrossB}};
    const auto masses = box2d::MassesOf(f);
    const float32 toLower = b2Max(slide.translation - m_lowerTranslation, 0.0f);
    const float32 toUpper = b2Max(m_upperTranslation - slide.translation, 0.0f);

    using Lanes = box2d::PrismaticLanes<float32>;
    lane.features =
        uint8((m_enableMotor ? Lanes::kMotor : 0) | (m_enableLimit ? Lanes::kLimits : 0));
    lane.Write(Lanes{.impulse = box2d::InLanes(m_impulse),
                     .motorImpulse = m_motorImpulse,
                     .limitImpulse = m_limitImpulse,
                     .axis = box2d::InLanes(m_axis),
                     .levers = {axisA, axisB, acrossA, acrossB},
                     .inverse = box2d::NumbersOf(levers.MatrixOf(masses).Inverse()),
                     .armA = box2d::InLanes(slide.armA),
                     .armB = box2d::InLanes(slide.armB),
                     .offset = box2d::InLanes(f.Offset()),
                     .angleError = float32(angle),
                     .row = box2d::NumbersOf(levers.RowOf(masses)),
                     .hasMotor = box2d::Flag(m_enableMotor),
                     .hasLimits = box2d::Flag(m_enableLimit),
                     .motorSpeed = m_motorSpeed,
                     .maxMotor = context.timeStep * m_maxMotorForce,
                     .lower = m_lowerTranslation,
                     .upper = m_upperTranslation,
                     .lowerSpeed = toLower * context.inverseStep,
                     .upperSpeed = toUpper * context.inverseStep});
}

void b2PrismaticJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
    m_motorImpulse = lane[2];
    m_limitImpulse = lane[3];
}

void b2PrismaticJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto slide = row.AddSlide(m_localAnchorA, m_localAnchorB, m_localAxisA);
    m_axis = slide.axis;
    row.AddAngle(float32(row.f.Angle() - double(m_referenceAngle)));
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
    impulse[2] = m_motorImpulse + m_limitImpulse;
}

void b2PrismaticJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_motorImpulse = within[2];
    m_limitImpulse = beyond[2];
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
    const float32 axial = m_motorImpulse + m_limitImpulse;
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
        NoteChange();
        m_limitImpulse = 0.0f;
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
        NoteChange();
        m_limitImpulse = 0.0f;
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
