// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2WeldJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

// A hinge whose angle is held too. Rigid: the three rows are solved together, with
//   K = [ PointMatrix   k ; k^T   iA + iB ],   k = (-iA rA.y - iB rB.y, iA rA.x + iB rB.x).
// Soft: the angle is a spring, solved before the point.

namespace
{

b2Mat33 FullMatrix(const box2d::JointFrame& f, const b2Vec2& rA, const b2Vec2& rB)
{
    const b2Mat22 point = box2d::PointMatrix(f, rA, rB);
    const float32 kx = -f.iA * rA.y - f.iB * rB.y;
    const float32 ky = f.iA * rA.x + f.iB * rB.x;
    return b2Mat33(b2Vec3(point.ex.x, point.ex.y, kx), b2Vec3(point.ey.x, point.ey.y, ky),
                   b2Vec3(kx, ky, f.iA + f.iB));
}

} // namespace

void b2WeldJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor)
{
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

b2WeldJoint::b2WeldJoint(const b2WeldJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_referenceAngle(def->referenceAngle), m_frequencyHz(def->frequencyHz),
      m_dampingRatio(def->dampingRatio)
{}

void b2WeldJoint::Prepare(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    m_armA = f.ArmA(m_localAnchorA);
    m_armB = f.ArmB(m_localAnchorB);
    m_offset = f.Offset();
    m_angleError = float32(f.dataB.pose.angle - f.dataA.pose.angle - double(m_referenceAngle));
    const float32 inertia = f.iA + f.iB;
    const box2d::Softness soft = box2d::MakeSoftness(
        m_frequencyHz, m_dampingRatio, box2d::InverseOrZero(inertia), context.timeStep);
    m_gamma = soft.gamma;
    m_bias = m_angleError * soft.biasRate;
    m_angularMass = inertia > 0.0f ? 1.0f / (inertia + m_gamma) : 0.0f;

    box2d::Carry(m_impulse, box2d::CarryOver(context));
    box2d::Carry(m_angularImpulse, box2d::CarryOver(context));
    f.ApplyImpulse(m_impulse, m_armA, m_armB);
    f.ApplyAngularImpulse(m_angularImpulse);
}

void b2WeldJoint::SolveVelocity(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    if (m_frequencyHz > 0.0f || m_angularMass == 0.0f)
    {
        const float32 turn = -m_angularMass * (f.b.w - f.a.w + m_bias + m_gamma * m_angularImpulse);
        m_angularImpulse += turn;
        f.ApplyAngularImpulse(turn);
        const b2Vec2 push =
            box2d::PointMatrix(f, m_armA, m_armB).Solve(-f.PointSpeed(m_armA, m_armB));
        m_impulse += push;
        f.ApplyImpulse(push, m_armA, m_armB);
        return;
    }
    const b2Vec2 speed = f.PointSpeed(m_armA, m_armB);
    const b2Vec3 impulse =
        FullMatrix(f, m_armA, m_armB).Solve33(b2Vec3(-speed.x, -speed.y, f.a.w - f.b.w));
    m_impulse += b2Vec2(impulse.x, impulse.y);
    m_angularImpulse += impulse.z;
    f.ApplyImpulse(b2Vec2(impulse.x, impulse.y), m_armA, m_armB);
    f.ApplyAngularImpulse(impulse.z);
}

bool b2WeldJoint::SolvePosition(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = b2Mul(f.a.q, m_armA);
    const b2Vec2 armB = b2Mul(f.b.q, m_armB);
    const b2Vec2 error = m_offset + f.b.d - f.a.d + armB - armA;
    if (m_frequencyHz > 0.0f || m_angularMass == 0.0f)
    {
        f.Move(box2d::PointMatrix(f, armA, armB).Solve(-error), armA, armB);
        return error.Length() <= b2_linearSlop;
    }
    const float32 angularError = m_angleError + f.b.angle - f.a.angle;
    const b2Vec3 impulse =
        FullMatrix(f, armA, armB).Solve33(b2Vec3(-error.x, -error.y, -angularError));
    const b2Vec2 push(impulse.x, impulse.y);
    f.a.d -= f.mA * push;
    f.a.Rotate(-f.iA * (b2Cross(armA, push) + impulse.z));
    f.b.d += f.mB * push;
    f.b.Rotate(f.iB * (b2Cross(armB, push) + impulse.z));
    return error.Length() <= b2_linearSlop && b2Abs(angularError) <= b2_angularSlop;
}

void b2WeldJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const b2Vec2 armA = row.ArmA(m_localAnchorA);
    const b2Vec2 armB = row.ArmB(m_localAnchorB);
    row.AddPoint(armA, armB, row.Offset() + armB - armA);
    const float32 angle = float32(row.Angle() - double(m_referenceAngle));
    row.AddAngle(angle);
    if (m_frequencyHz > 0.0f)
    {
        row.GiveToSpring(angle, m_frequencyHz, m_dampingRatio);
    }
}

void b2WeldJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
    impulse[2] = m_angularImpulse;
}

void b2WeldJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse.Set(within[0], within[1]);
    m_angularImpulse = within[2];
}

b2Vec2 b2WeldJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2WeldJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2WeldJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * m_impulse;
}

float32 b2WeldJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_angularImpulse;
}

void b2WeldJoint::SetFrequency(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio) && hz != m_frequencyHz)
    {
        WakeBodies();
        m_frequencyHz = hz;
    }
}

void b2WeldJoint::SetDampingRatio(float32 ratio)
{
    if (box2d::IsSpring(m_frequencyHz, ratio) && ratio != m_dampingRatio)
    {
        WakeBodies();
        m_dampingRatio = ratio;
    }
}

void b2WeldJoint::Dump()
{
    box2d::DumpBodies("b2WeldJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("referenceAngle", m_referenceAngle);
    box2d::DumpNumber("frequencyHz", m_frequencyHz);
    box2d::DumpNumber("dampingRatio", m_dampingRatio);
    box2d::DumpEnd(m_number);
}
