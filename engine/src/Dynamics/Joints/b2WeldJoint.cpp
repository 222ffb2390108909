// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2WeldJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "WeldKind.h"
#include "WeldLanes.h"

// A hinge with a fixed angle. Rigid: the three rows are solved together, with
//   K = [ PointMatrix   k ; k^T   iA + iB ],   k = (-iA rA.y - iB rB.y, iA rA.x + iB rB.x).
// Soft: the angle has a spring, solved before the point.

void b2WeldJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchor)
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

b2WeldJoint::b2WeldJoint(const b2WeldJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_referenceAngle(def->referenceAngle), m_frequencyHz(def->frequencyHz),
      m_dampingRatio(def->dampingRatio)
{}

void b2WeldJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));
    box2d::Scale(m_angularImpulse, box2d::WarmStartFactor(context, *this));

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const double angle = f.Angle() - double(m_referenceAngle);
    const float32 inertia = f.iA + f.iB;
    const box2d::Softness soft = box2d::MakeSoftness(
        m_frequencyHz, m_dampingRatio, box2d::InverseOrZero(inertia), context.timeStep);

    using Lanes = box2d::WeldLanes<float32>;
    const bool isRigid = !(m_frequencyHz > 0.0f) && inertia > 0.0f;
    lane.features = isRigid ? Lanes::kRigid : Lanes::kSoft;
    lane.Write(Lanes{.impulse = box2d::InLanes(m_impulse),
                     .angularImpulse = m_angularImpulse,
                     .armA = box2d::InLanes(f.ArmA(m_localAnchorA)),
                     .armB = box2d::InLanes(f.ArmB(m_localAnchorB)),
                     .offset = box2d::InLanes(f.Offset()),
                     .angleError = float32(angle),
                     .isRigid = box2d::Flag(isRigid),
                     .angularMass = inertia > 0.0f ? 1.0f / (inertia + soft.gamma) : 0.0f,
                     .bias = float32(angle) * soft.biasRate,
                     .gamma = soft.gamma});
}

void b2WeldJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
    m_angularImpulse = lane[2];
}

void b2WeldJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    row.AddPoint(m_localAnchorA, m_localAnchorB);
    const float32 angle = float32(row.f.Angle() - double(m_referenceAngle));
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

box2d::SpringState box2d::JointAccess::Kind<b2WeldJoint>::SpringOf(const b2WeldJoint& joint,
                                                                   const JointPair& pair)
{
    SpringState spring;
    spring.error = pair.Angle() - double(joint.GetReferenceAngle());
    spring.stiffness =
        StiffnessOf(double(pair.dataA.SolverInvInertia()) + double(pair.dataB.SolverInvInertia()),
                    joint.GetFrequency());
    return spring;
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
        NoteChange();
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
