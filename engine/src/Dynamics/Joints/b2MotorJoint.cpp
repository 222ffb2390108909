// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2MotorJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "MotorKind.h"
#include "MotorLanes.h"

// Friction towards a velocity that corrects a fraction of the error in one step:
//   Cdot + factor / h * C = 0,  C the deviation of body B's origin and angle from the target.

void b2MotorJointDef::Initialize(b2Body* a, b2Body* b)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
    linearOffset = a->GetLocalPoint(b->GetPosition());
    angularOffset = b->GetAngle() - a->GetAngle();
}

b2MotorJoint::b2MotorJoint(const b2MotorJointDef* def)
    : b2Joint(def), m_linearOffset(def->linearOffset), m_angularOffset(def->angularOffset),
      m_maxForce(def->maxForce), m_maxTorque(def->maxTorque),
      m_correctionFactor(def->correctionFactor)
{}

void b2MotorJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));
    box2d::Scale(m_angularImpulse, box2d::WarmStartFactor(context, *this));

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_linearOffset);
    const b2Vec2 armB = f.ArmB(b2Vec2(0.0f, 0.0f));
    const b2Vec2 error = f.Offset() + armB - armA;
    const double angle = f.Angle() - double(m_angularOffset);
    const float32 rate = context.inverseWhole * m_correctionFactor; // a share of each step
    lane.Write(
        box2d::MotorLanes<float32>{.friction = {.impulse = box2d::InLanes(m_impulse),
                                                .angularImpulse = m_angularImpulse,
                                                .maximum = context.timeStep * m_maxForce,
                                                .maxAngular = context.timeStep * m_maxTorque,
                                                .armA = box2d::InLanes(armA),
                                                .armB = box2d::InLanes(armB),
                                                .inverse = box2d::InversePointMatrix(f, armA, armB),
                                                .angularMass = box2d::InverseOrZero(f.iA + f.iB)},
                                   .bias = box2d::InLanes(rate * error),
                                   .angularBias = rate * float32(angle)});
}

void b2MotorJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
    m_angularImpulse = lane[2];
}

void b2MotorJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const float32 rate = context.inverseWhole * m_correctionFactor; // a share of each step
    row.AddPoint(m_linearOffset, b2Vec2(0.0f, 0.0f));
    const b2Vec2 error(rows.error[0], rows.error[1]);
    row.GiveToFriction(m_maxForce, m_maxTorque);
    rows.laws[0].wanted = -rate * error.x;
    rows.laws[1].wanted = -rate * error.y;
    rows.laws[2].wanted = -rate * float32(row.f.Angle() - double(m_angularOffset));
}

void b2MotorJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
    impulse[2] = m_angularImpulse;
}

void b2MotorJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_angularImpulse = within[2];
}

/// It corrects a share of its error within a step.
double box2d::JointAccess::Kind<b2MotorJoint>::MaxPower(const b2MotorJoint& joint,
                                                        const JointPair& pair, double step)
{
    const b2Vec2 armA = pair.ArmA(joint.GetLinearOffset());
    const b2Vec2 armB = pair.ArmB(b2Vec2_zero);
    const double rate = double(joint.GetCorrectionFactor()) / step;
    const double distance = double((pair.Offset() + armB - armA).Length());
    const double turn = std::abs(pair.Angle() - double(joint.GetAngularOffset()));
    const double speed = double(pair.SpeedAt(armA, armB).Length());
    const double spin = double(b2Abs(pair.b.w - pair.a.w));
    return double(joint.GetMaxForce()) * std::min(speed, rate * distance) +
           double(joint.GetMaxTorque()) * std::min(spin, rate * turn);
}

b2Vec2 b2MotorJoint::GetAnchorA() const
{
    return m_bodyA->GetPosition();
}

b2Vec2 b2MotorJoint::GetAnchorB() const
{
    return m_bodyB->GetPosition();
}

b2Vec2 b2MotorJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * m_impulse;
}

float32 b2MotorJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_angularImpulse;
}

void b2MotorJoint::SetLinearOffset(const b2Vec2& linearOffset)
{
    if (box2d::IsTarget(linearOffset) && linearOffset != m_linearOffset)
    {
        WakeBodies();
        m_linearOffset = linearOffset;
    }
}

void b2MotorJoint::SetAngularOffset(float32 angularOffset)
{
    if (box2d::IsAngle(angularOffset) && angularOffset != m_angularOffset)
    {
        WakeBodies();
        m_angularOffset = angularOffset;
    }
}

void b2MotorJoint::SetMaxForce(float32 force)
{
    if (box2d::AreForces(force, m_maxTorque) && force != m_maxForce)
    {
        WakeBodies();
        m_maxForce = force;
    }
}

void b2MotorJoint::SetMaxTorque(float32 torque)
{
    if (box2d::AreForces(m_maxForce, torque) && torque != m_maxTorque)
    {
        WakeBodies();
        m_maxTorque = torque;
    }
}

void b2MotorJoint::SetCorrectionFactor(float32 factor)
{
    if (box2d::IsShare(factor) && factor != m_correctionFactor)
    {
        WakeBodies();
        m_correctionFactor = factor;
    }
}

void b2MotorJoint::Dump()
{
    box2d::DumpBodies("b2MotorJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("linearOffset", m_linearOffset);
    box2d::DumpNumber("angularOffset", m_angularOffset);
    box2d::DumpNumber("maxForce", m_maxForce);
    box2d::DumpNumber("maxTorque", m_maxTorque);
    box2d::DumpNumber("correctionFactor", m_correctionFactor);
    box2d::DumpEnd(m_number);
}
