// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2MouseJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "MouseKind.h"
#include "MouseLanes.h"

#include <Box2D/Dynamics/b2World.h>

// A spring between a point of body B and a fixed point, in both directions at once:
//   C = xB + rB - target,  Cdot = vB + wB x rB,  K = mB E - iB [rB][rB] + gamma E
// The impulse is bounded.

namespace
{

/// Decay rate of the body's angular velocity in sub-steps [1/s]: -60 ln(MouseLanes::kKeptSpin), the
/// rate of a whole step at 60 Hz. After a second exp(-1.2) = 30 % is left.
constexpr float32 kSpinLoss = 1.2f;

} // namespace

b2MouseJoint::b2MouseJoint(const b2MouseJointDef* def)
    : b2Joint(def), m_localAnchorB(def->bodyB->GetLocalPoint(def->target)), m_target(def->target),
      m_maxForce(def->maxForce), m_frequencyHz(def->frequencyHz), m_dampingRatio(def->dampingRatio)
{
    (void)B2_REQUIRE(m_target.IsValid() && b2IsValid(m_maxForce) && m_maxForce >= 0.0f &&
                         m_frequencyHz > 0.0f && m_dampingRatio >= 0.0f,
                     "A mouse joint needs a finite target and force, a frequency above 0 and no "
                     "negative damping.");
}

void b2MouseJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 arm = f.ArmB(m_localAnchorB);
    const box2d::Softness soft = box2d::MakeSoftness(m_frequencyHz, m_dampingRatio,
                                                     box2d::InverseOrZero(f.mB), context.timeStep);
    const b2Vec2 error(float32(f.dataB.pose.x - double(m_target.x)) + f.b.d.x + arm.x,
                       float32(f.dataB.pose.y - double(m_target.y)) + f.b.d.y + arm.y);
    const float32 k11 = f.mB + f.iB * arm.y * arm.y + soft.gamma;
    const float32 k12 = -f.iB * arm.x * arm.y;
    const float32 k22 = f.mB + f.iB * arm.x * arm.x + soft.gamma;
    const box2d::PairMasses<box2d::simd::Float1>::Matrix matrix = {{k11}, {k12}, {k22}};
    lane.Write(box2d::MouseLanes<float32>{.impulse = box2d::InLanes(m_impulse),
                                          .maximum = context.timeStep * m_maxForce,
                                          .arm = box2d::InLanes(arm),
                                          .inverse = box2d::NumbersOf(matrix.Inverse()),
                                          .bias = box2d::InLanes(soft.biasRate * error),
                                          .gamma = soft.gamma});
}

void b2MouseJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse.Set(lane[0], lane[1]);
}

void b2MouseJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const b2Vec2 armB = row.f.ArmB(m_localAnchorB);
    const box2d::BodyData& data = row.f.dataB;
    const b2Vec2 error(float32(data.pose.x - double(m_target.x)) + row.f.b.d.x + armB.x,
                       float32(data.pose.y - double(m_target.y)) + row.f.b.d.y + armB.y);
    for (const bool isX : {true, false})
    {
        const b2Vec2 direction(isX ? 1.0f : 0.0f, isX ? 0.0f : 1.0f);
        row.b.AddTo(rows.rows++, direction, b2Cross(armB, direction));
        row.GiveToSpring(isX ? error.x : error.y, m_frequencyHz, m_dampingRatio, row.f.mB);
        rows.laws[rows.rows - 1].maximum = context.timeStep * m_maxForce;
    }
    rows.disc = true;
    // Damps the rotation, so that a dragged body does not spin for long.
    row.b.AddTo(rows.rows++, b2Vec2(0.0f, 0.0f), 1.0f);
    row.Give().softness = row.f.iB / (kSpinLoss * context.timeStep);
}

void b2MouseJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse.x;
    impulse[1] = m_impulse.y;
}

void b2MouseJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse.Set(within[0], within[1]);
}

box2d::SpringState box2d::JointAccess::Kind<b2MouseJoint>::SpringOf(const b2MouseJoint& joint,
                                                                    const JointPair& pair)
{
    const b2Vec2 arm = pair.ArmB(joint.GetBodyB()->GetLocalPoint(joint.GetAnchorB()));
    const b2Vec2 target = joint.GetTarget();
    const Pose& pose = pair.dataB.pose;
    const b2Vec2 apart(float32(pose.x - double(target.x)), float32(pose.y - double(target.y)));
    SpringState spring;
    spring.error = double((apart + pair.b.d + arm).Length());
    spring.stiffness = StiffnessOf(double(pair.dataB.SolverInvMass()), joint.GetFrequency());
    spring.maximum = double(joint.GetMaxForce());
    return spring;
}

b2Vec2 b2MouseJoint::GetAnchorA() const
{
    return m_target;
}

b2Vec2 b2MouseJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2MouseJoint::GetReactionForce(float32 inv_dt) const
{
    return inv_dt * m_impulse;
}

float32 b2MouseJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

void b2MouseJoint::SetTarget(const b2Vec2& target)
{
    if (box2d::IsTarget(target) && target != m_target)
    {
        m_bodyB->SetAwake(true);
        m_target = target;
    }
}

void b2MouseJoint::ShiftOrigin(const b2Vec2& newOrigin)
{
    m_target -= newOrigin;
}

void b2MouseJoint::SetMaxForce(float32 force)
{
    if (box2d::AreForces(force, 0.0f))
    {
        m_maxForce = force;
    }
}

void b2MouseJoint::SetFrequency(float32 hz)
{
    if (box2d::IsSpring(hz, m_dampingRatio))
    {
        m_frequencyHz = hz;
    }
}

void b2MouseJoint::SetDampingRatio(float32 ratio)
{
    if (box2d::IsSpring(m_frequencyHz, ratio))
    {
        m_dampingRatio = ratio;
    }
}

void b2MouseJoint::Dump()
{
    b2Log("  // A mouse joint belongs to a hand, not to a scene.\n");
}
