// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "RevoluteLanes.h"

// The two anchors coincide:  C = xB + rB - xA - rA,  Cdot = vB + wB x rB - vA - wA x rA,  K as in
// PointMatrix. The motor drives wB - wA to its speed within its torque. A limit is an inequality on
// the angle; the approach speed is at most the one that reaches it at the end of this step. Both
// are solved with the point held: on a long arm, the point would otherwise cancel most of an
// impulse on the angle.

void b2RevoluteJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

b2RevoluteJoint::b2RevoluteJoint(const b2RevoluteJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_referenceAngle(def->referenceAngle), m_enableLimit(def->enableLimit),
      m_lowerAngle(def->lowerAngle), m_upperAngle(def->upperAngle), m_enableMotor(def->enableMotor),
      m_motorSpeed(def->motorSpeed), m_maxMotorTorque(def->maxMotorTorque)
{}

void b2RevoluteJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const float32 share = box2d::WarmStartFactor(context, *this);
    box2d::Scale(m_impulse, share);
    box2d::Scale(m_motorImpulse, m_enableMotor ? share : 0.0f);
    box2d::Scale(m_limitImpulse, m_enableLimit ? share : 0.0f);

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_localAnchorA);
    const b2Vec2 armB = f.ArmB(m_localAnchorB);

    using Lanes = box2d::RevoluteLanes<float32>;
    Lanes lanes;
    lanes.impulse = box2d::InLanes(m_impulse);
    lanes.motorImpulse = m_motorImpulse;
    lanes.limitImpulse = m_limitImpulse;
    lanes.armA = box2d::InLanes(armA);
    lanes.armB = box2d::InLanes(armB);
    lanes.offset = box2d::InLanes(f.Offset());
    lanes.inverse = box2d::InversePointMatrix(f, armA, armB);
    lanes.hasMotor = box2d::Flag(m_enableMotor);
    lanes.hasLimits = box2d::Flag(m_enableLimit);
    if (!m_enableMotor && !m_enableLimit)
    {
        lane.Write(lanes, sizeof(Lanes) / sizeof(float32) - Lanes::kAxialNumbers);
        return;
    }
    lane.features =
        uint8((m_enableMotor ? Lanes::kMotor : 0) | (m_enableLimit ? Lanes::kLimits : 0));
    const float32 angle = float32(f.Angle() - double(m_referenceAngle));
    using One = box2d::simd::Float1;
    const auto row = box2d::HeldRow<One>::AngleOfPoint(box2d::MassesOf(f), box2d::InOneLane(armA),
                                                       box2d::InOneLane(armB));
    lanes.axial = {.row = box2d::NumbersOf(row),
                   .motorSpeed = m_motorSpeed,
                   .maxMotor = context.timeStep * m_maxMotorTorque,
                   .angle = angle,
                   .lower = m_lowerAngle,
                   .upper = m_upperAngle,
                   .lowerSpeed = b2Max(angle - m_lowerAngle, 0.0f) * context.inverseStep,
                   .upperSpeed = b2Max(m_upperAngle - angle, 0.0f) * context.inverseStep};
    lane.Write(lanes);
}

void b2RevoluteJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
    m_motorImpulse = lane[2];
    m_limitImpulse = lane[3];
}

void b2RevoluteJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    row.AddPoint(m_localAnchorA, m_localAnchorB);
    if (m_enableMotor || m_enableLimit)
    {
        const float32 angle = float32(row.f.Angle() - double(m_referenceAngle));
        row.AddAngle(0.0f);
        row.GiveToMotor(m_motorSpeed, m_enableMotor ? m_maxMotorTorque : 0.0f);
        if (m_enableLimit)
        {
            row.GiveToLimit(angle, m_lowerAngle, m_upperAngle);
        }
    }
}

void b2RevoluteJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
    impulse[2] = m_motorImpulse + m_limitImpulse;
}

void b2RevoluteJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_motorImpulse = within[2];
    m_limitImpulse = beyond[2];
}

b2Vec2 b2RevoluteJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2RevoluteJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2RevoluteJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * m_impulse;
}

float32 b2RevoluteJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * (m_motorImpulse + m_limitImpulse);
}

float32 b2RevoluteJoint::GetJointAngle() const
{
    const double angle = box2d::Data(*m_bodyB).pose.angle - box2d::Data(*m_bodyA).pose.angle;
    return float32(angle - double(m_referenceAngle));
}

float32 b2RevoluteJoint::GetJointSpeed() const
{
    return m_bodyB->GetAngularVelocity() - m_bodyA->GetAngularVelocity();
}

float32 b2RevoluteJoint::GetMotorTorque(float32 inv_dt) const
{
    return inv_dt * m_motorImpulse;
}

float32 b2RevoluteJoint::GetMotorTorque() const
{
    return GetMotorTorque(LastInverseStep());
}

void b2RevoluteJoint::EnableLimit(bool flag)
{
    if (flag != m_enableLimit)
    {
        WakeBodies();
        m_enableLimit = flag;
        NoteChange();
        m_limitImpulse = 0.0f;
    }
}

void b2RevoluteJoint::SetLimits(float32 lower, float32 upper)
{
    if (!box2d::AreLimits(true, lower, upper))
    {
        return;
    }
    if (lower != m_lowerAngle || upper != m_upperAngle)
    {
        WakeBodies();
        m_lowerAngle = lower;
        m_upperAngle = upper;
        NoteChange();
        m_limitImpulse = 0.0f;
    }
}

void b2RevoluteJoint::EnableMotor(bool flag)
{
    WakeBodies();
    m_enableMotor = flag;
}

void b2RevoluteJoint::SetMotorSpeed(float32 speed)
{
    if (box2d::IsMotor(speed, m_maxMotorTorque))
    {
        WakeBodies();
        m_motorSpeed = speed;
    }
}

void b2RevoluteJoint::SetMaxMotorTorque(float32 torque)
{
    if (box2d::IsMotor(m_motorSpeed, torque))
    {
        WakeBodies();
        m_maxMotorTorque = torque;
    }
}

void b2RevoluteJoint::Dump()
{
    box2d::DumpBodies("b2RevoluteJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("referenceAngle", m_referenceAngle);
    box2d::DumpFlag("enableLimit", m_enableLimit);
    box2d::DumpNumber("lowerAngle", m_lowerAngle);
    box2d::DumpNumber("upperAngle", m_upperAngle);
    box2d::DumpFlag("enableMotor", m_enableMotor);
    box2d::DumpNumber("motorSpeed", m_motorSpeed);
    box2d::DumpNumber("maxMotorTorque", m_maxMotorTorque);
    box2d::DumpEnd(m_number);
}
