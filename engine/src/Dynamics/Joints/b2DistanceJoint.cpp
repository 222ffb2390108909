// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>

#include "JointFrame.h"

// Keep two anchors at length L:  C = |d| - L,  n = d / |d|
//   Cdot = dot(n, vB + wB x rB - vA - wA x rA)
//   K    = mA + mB + iA (rA x n)^2 + iB (rB x n)^2        (mA … inverse masses)
// A spring adds softness (Catto, "Soft Constraints", GDC 2011): with stiffness k, damping c and
// step h
//   gamma = 1 / (h (c + h k)),  bias = C h k gamma,  impulse = -(Cdot + bias + gamma * total) / (K
//   + gamma)

void b2DistanceJointDef::Initialize(b2Body* a, b2Body* b, const b2Vec2& anchorA,
                                    const b2Vec2& anchorB)
{
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchorA);
    localAnchorB = b->GetLocalPoint(anchorB);
    length = b2Distance(anchorA, anchorB);
}

b2DistanceJoint::b2DistanceJoint(const b2DistanceJointDef* def)
    : b2Joint(def), m_localAnchorA(def->localAnchorA), m_localAnchorB(def->localAnchorB),
      m_length(def->length), m_frequencyHz(def->frequencyHz), m_dampingRatio(def->dampingRatio)
{}

void b2DistanceJoint::Prepare(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    m_armA = f.ArmA(m_localAnchorA);
    m_armB = f.ArmB(m_localAnchorB);
    m_offset = f.Offset();
    m_axis = m_offset + m_armB - m_armA;
    const float32 length = m_axis.Normalize();
    if (length == 0.0f)
    {
        m_axis.SetZero(); // no direction to push in
    }
    const float32 crossA = b2Cross(m_armA, m_axis);
    const float32 crossB = b2Cross(m_armB, m_axis);
    float32 k = f.mA + f.mB + f.iA * crossA * crossA + f.iB * crossB * crossB;
    m_gamma = 0.0f;
    m_bias = 0.0f;
    if (m_frequencyHz > 0.0f && k > 0.0f)
    {
        const float32 h = context.timeStep;
        const float32 omega = 2.0f * b2_pi * m_frequencyHz;
        const float32 damping = 2.0f * m_dampingRatio * omega / k;
        const float32 stiffness = omega * omega / k;
        m_gamma = 1.0f / (h * (damping + h * stiffness));
        m_bias = (length - m_length) * h * stiffness * m_gamma;
        k += m_gamma;
    }
    m_mass = k > 0.0f ? 1.0f / k : 0.0f;
    m_impulse *= context.warmStarting ? context.stepRatio : 0.0f;
    f.ApplyImpulse(m_impulse * m_axis, m_armA, m_armB);
}

void b2DistanceJoint::SolveVelocity(const box2d::SolverContext& context)
{
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const float32 speed = b2Dot(m_axis, f.PointSpeed(m_armA, m_armB));
    const float32 impulse = -m_mass * (speed + m_bias + m_gamma * m_impulse);
    m_impulse += impulse;
    f.ApplyImpulse(impulse * m_axis, m_armA, m_armB);
}

bool b2DistanceJoint::SolvePosition(const box2d::SolverContext& context)
{
    if (m_frequencyHz > 0.0f)
    {
        return true; // the spring does it
    }
    const box2d::JointFrame f(*m_bodyA, *m_bodyB, context);
    const b2Vec2 armA = b2Mul(f.a.q, m_armA);
    const b2Vec2 armB = b2Mul(f.b.q, m_armB);
    b2Vec2 axis = m_offset + f.b.d - f.a.d + armB - armA;
    const float32 length = axis.Normalize();
    const float32 error =
        b2Clamp(length - m_length, -b2_maxLinearCorrection, b2_maxLinearCorrection);
    const float32 crossA = b2Cross(armA, axis);
    const float32 crossB = b2Cross(armB, axis);
    const float32 k = f.mA + f.mB + f.iA * crossA * crossA + f.iB * crossB * crossB;
    if (length > 0.0f && k > 0.0f)
    {
        f.Move((-error / k) * axis, armA, armB);
    }
    return b2Abs(error) < b2_linearSlop;
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
    return (inv_dt * m_impulse) * m_axis;
}

float32 b2DistanceJoint::GetReactionTorque(float32) const
{
    return 0.0f;
}

void b2DistanceJoint::Dump()
{
    b2Log("  b2DistanceJointDef jd;\n");
    b2Log("  jd.bodyA = bodies[%d];\n", box2d::Data(*m_bodyA).number);
    b2Log("  jd.bodyB = bodies[%d];\n", box2d::Data(*m_bodyB).number);
    b2Log("  jd.collideConnected = bool(%d);\n", m_collideConnected);
    b2Log("  jd.localAnchorA.Set(%.9gf, %.9gf);\n", double(m_localAnchorA.x),
          double(m_localAnchorA.y));
    b2Log("  jd.localAnchorB.Set(%.9gf, %.9gf);\n", double(m_localAnchorB.x),
          double(m_localAnchorB.y));
    b2Log("  jd.length = %.9gf;\n", double(m_length));
    b2Log("  jd.frequencyHz = %.9gf;\n", double(m_frequencyHz));
    b2Log("  jd.dampingRatio = %.9gf;\n", double(m_dampingRatio));
    b2Log("  joints[%d] = m_world->CreateJoint(&jd);\n", m_number);
}
