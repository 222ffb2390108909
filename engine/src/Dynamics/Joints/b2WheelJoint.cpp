// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2WheelJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "WheelKind.h"
#include "WheelLanes.h"

// With d = xB + rB - xA - rA, the axis a fixed in A, t = (0, 0, 1) x a:
//   rigid:   C = dot(t, d),   Cdot = dot(t, vB - vA) + (rB x t) wB - ((d + rA) x t) wA
//   spring:  the same with a for t, made soft
//   motor:   drives wB - wA to its speed

void b2WheelJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor, const b2Vec2& axis)
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
}

b2WheelJoint::b2WheelJoint(const b2WheelJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_localAxisA(def->localAxisA), m_enableMotor(def->enableMotor),
      m_maxMotorTorque(def->maxMotorTorque), m_motorSpeed(def->motorSpeed),
      m_frequencyHz(def->frequencyHz), m_dampingRatio(def->dampingRatio)
{
    if (m_localAxisA.Normalize() == 0.0f)
    {
        m_localAxisA.Set(1.0f, 0.0f);
    }
}

void b2WheelJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    const float32 share = box2d::WarmStartFactor(context, *this);
    box2d::Scale(m_impulse, share);
    box2d::Scale(m_springImpulse, m_frequencyHz > 0.0f ? share : 0.0f);
    box2d::Scale(m_motorImpulse, m_enableMotor ? share : 0.0f);

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const auto slide = f.Along(m_localAxisA, m_localAnchorA, m_localAnchorB);
    m_axis = slide.axis;
    const float32 k = box2d::AxisMatrix(f, m_axis, slide.reachA, slide.armB);
    const b2Vec2 across = b2Cross(1.0f, m_axis);
    const float32 kAcross = box2d::AxisMatrix(f, across, slide.reachA, slide.armB);
    const box2d::Softness soft = box2d::MakeSoftness(m_frequencyHz, m_dampingRatio,
                                                     box2d::InverseOrZero(k), context.timeStep);

    using Lanes = box2d::WheelLanes<float32>;
    lane.features = m_enableMotor ? Lanes::kMotor : 0;
    lane.Write(
        Lanes{.impulse = m_impulse,
              .springImpulse = m_springImpulse,
              .motorImpulse = m_motorImpulse,
              .axis = box2d::InLanes(m_axis),
              .axisA = b2Cross(slide.reachA, m_axis),
              .axisB = b2Cross(slide.armB, m_axis),
              .acrossA = b2Cross(slide.reachA, across),
              .acrossB = b2Cross(slide.armB, across),
              .armA = box2d::InLanes(slide.armA),
              .armB = box2d::InLanes(slide.armB),
              .offset = box2d::InLanes(f.Offset()),
              .rigidMass = box2d::InverseOrZero(kAcross),
              .springMass = m_frequencyHz > 0.0f ? box2d::InverseOrZero(k + soft.gamma) : 0.0f,
              .bias = slide.translation * soft.biasRate,
              .gamma = soft.gamma,
              .motorMass = box2d::InverseOrZero(f.iA + f.iB),
              .hasMotor = box2d::Flag(m_enableMotor),
              .motorSpeed = m_motorSpeed,
              .maxMotor = context.timeStep * m_maxMotorTorque});
}

void b2WheelJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
    m_springImpulse = lane[1];
    m_motorImpulse = lane[2];
}

void b2WheelJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const auto slide = row.AddSlide(m_localAnchorA, m_localAnchorB, m_localAxisA);
    m_axis = slide.axis;
    row.AddAlong(slide.axis, slide.reachA, slide.armB, 0.0f);
    row.GiveToSpring(slide.translation, m_frequencyHz, m_dampingRatio);
    row.AddAngle(0.0f);
    row.GiveToMotor(m_motorSpeed, m_enableMotor ? m_maxMotorTorque : 0.0f);
}

void b2WheelJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
    impulse[1] = m_springImpulse;
    impulse[2] = m_motorImpulse;
}

void b2WheelJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse = within[0];
    m_springImpulse = within[1];
    m_motorImpulse = within[2];
}

box2d::SpringState box2d::JointAccess::Kind<b2WheelJoint>::SpringOf(const b2WheelJoint& joint,
                                                                    const JointPair& pair)
{
    const auto slide =
        pair.Along(joint.GetLocalAxisA(), joint.GetLocalAnchorA(), joint.GetLocalAnchorB());
    SpringState spring;
    spring.error = double(slide.translation);
    spring.stiffness = StiffnessOf(pair.InverseMass(slide.reachA, slide.armB, slide.axis),
                                   joint.GetSpringFrequencyHz());
    return spring;
}

b2Vec2 b2WheelJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2WheelJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2WheelJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * (m_impulse * b2Cross(1.0f, m_axis) + m_springImpulse * m_axis);
}

float32 b2WheelJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_motorImpulse;
}

float32 b2WheelJoint::GetJointTranslation() const
{
    const box2d::BodyData& a = box2d::Data(*m_bodyA);
    const box2d::BodyData& b = box2d::Data(*m_bodyB);
    const b2Vec2 d = box2d::CenterOffset(a, b) + b2Mul(b.rotation, m_localAnchorB - b.localCenter) -
                     b2Mul(a.rotation, m_localAnchorA - a.localCenter);
    return b2Dot(d, b2Mul(a.rotation, m_localAxisA));
}

float32 b2WheelJoint::GetJointSpeed() const
{
    return m_bodyB->GetAngularVelocity() - m_bodyA->GetAngularVelocity();
}

float32 b2WheelJoint::GetMotorTorque(float32 inv_dt) const
{
    return inv_dt * m_motorImpulse;
}

float32 b2WheelJoint::GetMotorTorque() const
{
    return GetMotorTorque(LastInverseStep());
}

void b2WheelJoint::EnableMotor(bool flag)
{
    WakeBodies();
    m_enableMotor = flag;
}

void b2WheelJoint::SetMotorSpeed(float32 speed)
{
    if (box2d::IsMotor(speed, m_maxMotorTorque))
    {
        WakeBodies();
        m_motorSpeed = speed;
    }
}

void b2WheelJoint::SetMaxMotorTorque(float32 torque)
{
    if (box2d::IsMotor(m_motorSpeed, torque))
    {
        WakeBodies();
        m_maxMotorTorque = torque;
    }
}

void b2WheelJoint::SetSpringFrequencyHz(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio) && hz != m_frequencyHz)
    {
        WakeBodies();
        m_frequencyHz = hz;
    }
}

void b2WheelJoint::SetSpringDampingRatio(float32 ratio)
{
    if (box2d::IsSpring(m_frequencyHz, ratio) && ratio != m_dampingRatio)
    {
        WakeBodies();
        m_dampingRatio = ratio;
    }
}

void b2WheelJoint::Dump()
{
    box2d::DumpBodies("b2WheelJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpPoint("localAxisA", m_localAxisA);
    box2d::DumpFlag("enableMotor", m_enableMotor);
    box2d::DumpNumber("motorSpeed", m_motorSpeed);
    box2d::DumpNumber("maxMotorTorque", m_maxMotorTorque);
    box2d::DumpNumber("frequencyHz", m_frequencyHz);
    box2d::DumpNumber("dampingRatio", m_dampingRatio);
    box2d::DumpEnd(m_number);
}
