// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2PulleyJoint.h>

#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"
#include "PulleyLanes.h"

// With u = xA + rA - groundA, uB likewise, nA = u / |u|:
//   C    = |uA| + ratio |uB| - constant
//   Cdot = dot(nA, vA + wA x rA) + ratio dot(nB, vB + wB x rB)
//   K    = mA + iA (rA x nA)^2 + ratio^2 (mB + iB (rB x nB)^2)
// The impulse pulls both bodies towards their ground anchors.

namespace
{

float32 RopeLength(const b2Vec2& rope)
{
    return b2Max(rope.Length(), box2d::kShortestRope);
}

b2Vec2 RopeDirection(const b2Vec2& rope)
{
    const float32 length = rope.Length();
    return length > box2d::kShortestRope ? (1.0f / length) * rope : b2Vec2(0.0f, 0.0f);
}

/// Returns the vector from the ground anchor to the body's centre of mass.
b2Vec2 RopeOf(const box2d::BodyData& data, const box2d::SolverBody& moved, const b2Vec2& ground)
{
    return b2Vec2(float32(data.pose.x - double(ground.x)),
                  float32(data.pose.y - double(ground.y))) +
           moved.d;
}

float32 PulleyMatrix(const box2d::JointFrame& f, float32 ratio, const b2Vec2& axisA,
                     const b2Vec2& armA, const b2Vec2& axisB, const b2Vec2& armB)
{
    const float32 crossA = b2Cross(armA, axisA);
    const float32 crossB = b2Cross(armB, axisB);
    return f.mA + f.iA * crossA * crossA + ratio * ratio * (f.mB + f.iB * crossB * crossB);
}

} // namespace

void b2PulleyJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& groundA,
                                  const b2Vec2& groundB, const b2Vec2& anchorA,
                                  const b2Vec2& anchorB, float32 r)
{
    bodyA = a;
    bodyB = b;
    if (!box2d::AreBodies(a, b))
    {
        return;
    }
    groundAnchorA = groundA;
    groundAnchorB = groundB;
    localAnchorA = a->GetLocalPoint(anchorA);
    localAnchorB = b->GetLocalPoint(anchorB);
    lengthA = b2Distance(anchorA, groundA);
    lengthB = b2Distance(anchorB, groundB);
    ratio = r;
    (void)B2_REQUIRE(ratio > b2_epsilon, "A pulley's ratio must be above 0.");
}

b2PulleyJoint::b2PulleyJoint(const b2PulleyJointDef* def)
    : b2Joint(def), m_groundAnchorA(def->groundAnchorA), m_groundAnchorB(def->groundAnchorB),
      m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB), m_lengthA(def->lengthA),
      m_lengthB(def->lengthB), m_ratio(def->ratio > b2_epsilon ? def->ratio : 1.0f)
{
    (void)B2_REQUIRE(def->ratio > b2_epsilon, "A pulley's ratio must be above 0.");
}

void b2PulleyJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context, *this));

    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = f.ArmA(m_localAnchorA);
    const b2Vec2 armB = f.ArmB(m_localAnchorB);
    const b2Vec2 ropeA = RopeOf(f.dataA, f.a, m_groundAnchorA);
    const b2Vec2 ropeB = RopeOf(f.dataB, f.b, m_groundAnchorB);
    m_axisA = RopeDirection(ropeA + armA);
    m_axisB = RopeDirection(ropeB + armB);
    const float32 k = PulleyMatrix(f, m_ratio, m_axisA, armA, m_axisB, armB);
    lane.Write(box2d::PulleyLanes<float32>{.impulse = m_impulse,
                                           .axisA = box2d::InLanes(m_axisA),
                                           .axisB = box2d::InLanes(m_axisB),
                                           .armA = box2d::InLanes(armA),
                                           .armB = box2d::InLanes(armB),
                                           .ropeA = box2d::InLanes(ropeA),
                                           .ropeB = box2d::InLanes(ropeB),
                                           .ratio = m_ratio,
                                           .mass = box2d::InverseOrZero(k),
                                           .lengthA = b2Max(m_lengthA, box2d::kShortestRope),
                                           .lengthB = b2Max(m_lengthB, box2d::kShortestRope)});
}

void b2PulleyJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
}

/// Returns the excess length of the rope.
float32 b2PulleyJoint::Stretch(const b2Vec2& ropeA, const b2Vec2& ropeB) const
{
    return RopeLength(ropeA) - b2Max(m_lengthA, box2d::kShortestRope) +
           m_ratio * (RopeLength(ropeB) - b2Max(m_lengthB, box2d::kShortestRope));
}

void b2PulleyJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    // The impulse pulls, so the row is the remaining length.
    box2d::RowFiller row(*m_bodyA, *m_bodyB, context, rows);
    const b2Vec2 armA = row.f.ArmA(m_localAnchorA);
    const b2Vec2 armB = row.f.ArmB(m_localAnchorB);
    const b2Vec2 ropeA = RopeOf(row.f.dataA, row.f.a, m_groundAnchorA) + armA;
    const b2Vec2 ropeB = RopeOf(row.f.dataB, row.f.b, m_groundAnchorB) + armB;
    m_axisA = RopeDirection(ropeA);
    m_axisB = RopeDirection(ropeB);
    row.a.AddTo(0, -m_axisA, -b2Cross(armA, m_axisA));
    row.b.AddTo(0, -m_ratio * m_axisB, -m_ratio * b2Cross(armB, m_axisB));
    rows.error[0] = -Stretch(ropeA, ropeB);
    rows.rows = 1;
}

void b2PulleyJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
}

void b2PulleyJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse = within[0];
}

b2Vec2 b2PulleyJoint::GetAnchorA() const
{
    return m_bodyA->GetWorldPoint(m_localAnchorA);
}

b2Vec2 b2PulleyJoint::GetAnchorB() const
{
    return m_bodyB->GetWorldPoint(m_localAnchorB);
}

b2Vec2 b2PulleyJoint::GetReactionForce(float32 inv_dt) const
{
    return (-inv_dt * m_ratio * m_impulse) * m_axisB;
}

float32 b2PulleyJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

float32 b2PulleyJoint::GetCurrentLengthA() const
{
    return b2Distance(GetAnchorA(), m_groundAnchorA);
}

float32 b2PulleyJoint::GetCurrentLengthB() const
{
    return b2Distance(GetAnchorB(), m_groundAnchorB);
}

void b2PulleyJoint::ShiftOrigin(const b2Vec2& newOrigin)
{
    m_groundAnchorA -= newOrigin;
    m_groundAnchorB -= newOrigin;
}

void b2PulleyJoint::Dump()
{
    box2d::DumpBodies("b2PulleyJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    box2d::DumpPoint("groundAnchorA", m_groundAnchorA);
    box2d::DumpPoint("groundAnchorB", m_groundAnchorB);
    box2d::DumpPoint("localAnchorA", m_localAnchorA);
    box2d::DumpPoint("localAnchorB", m_localAnchorB);
    box2d::DumpNumber("lengthA", m_lengthA);
    box2d::DumpNumber("lengthB", m_lengthB);
    box2d::DumpNumber("ratio", m_ratio);
    box2d::DumpEnd(m_number);
}
