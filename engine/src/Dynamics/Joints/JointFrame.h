// SPDX-License-Identifier: MIT
#pragma once

#include "../State/BodyPose.h"
#include "JointEnergy.h"
#include "JointLanes.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Body.h>

/// What every joint needs of its two bodies: their places in the solver and their inverse masses.
/// Made on the spot, never kept.
namespace box2d
{

struct JointFrame
{
    JointFrame(const b2Body& bodyA, const b2Body& bodyB, const SolverContext& context)
        : dataA(Data(bodyA)), dataB(Data(bodyB)), a(context.bodies[dataA.SolverIndex()]),
          b(context.bodies[dataB.SolverIndex()]), mA(dataA.SolverInvMass()),
          iA(dataA.SolverInvInertia()), mB(dataB.SolverInvMass()), iB(dataB.SolverInvInertia())
    {}

    /// From the centre of mass to a point given in the body's frame, in world axes.
    b2Vec2 ArmA(const b2Vec2& local) const
    {
        return b2Mul(dataA.rotation, local - dataA.localCenter);
    }
    b2Vec2 ArmB(const b2Vec2& local) const
    {
        return b2Mul(dataB.rotation, local - dataB.localCenter);
    }
    b2Vec2 Offset() const { return CenterOffset(dataA, dataB); }

    const BodyData& dataA;
    const BodyData& dataB;
    SolverBody& a;
    SolverBody& b;
    float32 mA, iA, mB, iB; ///< inverse
};

/// A spring as a soft constraint (Catto, "Soft Constraints", GDC 2011): with stiffness k, damping c
/// and step h
///   gamma = 1 / (h (c + h k)),  bias = C h k gamma,  impulse = -(Cdot + bias + gamma * total) / (K
///   + gamma).
struct Softness
{
    float32 gamma = 0.0f;
    float32 biasRate = 0.0f; ///< bias over C [1/s]
};

/// `mass` is the effective mass that the spring moves; frequency in hertz.
inline Softness MakeSoftness(float32 frequencyHz, float32 dampingRatio, float32 mass,
                             float32 timeStep)
{
    Softness soft;
    if (frequencyHz > 0.0f && mass > 0.0f)
    {
        const float32 omega = 2.0f * b2_pi * frequencyHz;
        const float32 damping = 2.0f * mass * dampingRatio * omega;
        const float32 stiffness = mass * omega * omega;
        soft.gamma = 1.0f / (timeStep * (damping + timeStep * stiffness));
        soft.biasRate = timeStep * stiffness * soft.gamma;
    }
    return soft;
}

inline float32 InverseOrZero(float32 value)
{
    return value > 0.0f ? 1.0f / value : 0.0f;
}

/// For a kind's numbers; see JointBlocks.h.
inline Vector<float32> InLanes(const b2Vec2& v)
{
    return {v.x, v.y};
}

inline float32 Flag(bool flag)
{
    return flag ? 1.0f : 0.0f;
}

/// How an impulse along `axis` changes the relative speed along it:
///   K = mA + mB + iA (rA x n)^2 + iB (rB x n)^2.
inline float32 AxisMatrix(const JointFrame& f, const b2Vec2& axis, const b2Vec2& rA,
                          const b2Vec2& rB)
{
    const float32 crossA = b2Cross(rA, axis);
    const float32 crossB = b2Cross(rB, axis);
    return f.mA + f.mB + f.iA * crossA * crossA + f.iB * crossB * crossB;
}

/// The largest impulse a force can give in a step, as a bound on a vector.
inline b2Vec2 ClampLength(const b2Vec2& v, float32 limit)
{
    const float32 squared = v.LengthSquared();
    return squared > limit * limit ? (limit / b2Sqrt(squared)) * v : v;
}

/// The share of the last step's impulses that a step starts with.
inline float32 CarryOver(const SolverContext& context)
{
    return context.warmStarting ? context.stepRatio : 0.0f;
}

/// The same for a joint at points of its bodies. None where a body turns so far in a step, on a
/// lever, that the impulses no longer point where they should: a few iterations do not take them
/// back, so bodies gain energy and the impulses grow from step to step.
inline float32 CarryOver(const SolverContext& context, const b2Joint& joint)
{
    // A pendulum's pull is off by half of itself then. With 1 rad some random worlds burst.
    constexpr float32 kMaxTurn = 0.5f; // [rad]
    constexpr float32 kRadii = 1.0f;   // on shorter levers the body hardly turns with the joint
    const auto turns = [&context](const b2Body& body) {
        return b2Abs(context.timeStep * context.bodies[Data(body).SolverIndex()].w) > kMaxTurn;
    };
    const bool isStale = (turns(*joint.GetBodyA()) && HasLeverOnA(joint, kRadii)) ||
                         (turns(*joint.GetBodyB()) && HasLeverOnB(joint, kRadii));
    return isStale ? 0.0f : CarryOver(context);
}

/// Keeps that share of an impulse; one that is not finite is forgotten.
inline void Carry(float32& impulse, float32 share)
{
    impulse = b2IsValid(impulse) ? share * impulse : 0.0f;
}

inline void Carry(b2Vec2& impulse, float32 share)
{
    Carry(impulse.x, share);
    Carry(impulse.y, share);
}

/// The lines every joint's Dump starts with.
inline void DumpBodies(const char* definition, const b2Body& a, const b2Body& b,
                       bool collideConnected)
{
    b2Log("  %s jd;\n", definition);
    b2Log("  jd.bodyA = bodies[%d];\n", Data(a).number);
    b2Log("  jd.bodyB = bodies[%d];\n", Data(b).number);
    b2Log("  jd.collideConnected = bool(%d);\n", collideConnected);
}

inline void DumpPoint(const char* name, const b2Vec2& p)
{
    b2Log("  jd.%s.Set(%.8ef, %.8ef);\n", name, double(p.x), double(p.y));
}

inline void DumpNumber(const char* name, float32 value)
{
    b2Log("  jd.%s = %.8ef;\n", name, double(value));
}

inline void DumpFlag(const char* name, bool value)
{
    b2Log("  jd.%s = bool(%d);\n", name, value);
}

inline void DumpEnd(int32 number)
{
    b2Log("  joints[%d] = m_world->CreateJoint(&jd);\n", number);
}

/// How an impulse on B's point changes the relative velocity of the two points: the matrix
///   K = (mA + mB) E - iA [rA][rA] - iB [rB][rB],   [r] the cross-product matrix of r.
inline b2Mat22 PointMatrix(const JointFrame& f, const b2Vec2& rA, const b2Vec2& rB)
{
    const float32 mass = f.mA + f.mB;
    const float32 k11 = mass + f.iA * rA.y * rA.y + f.iB * rB.y * rB.y;
    const float32 k12 = -f.iA * rA.x * rA.y - f.iB * rB.x * rB.y;
    const float32 k22 = mass + f.iA * rA.x * rA.x + f.iB * rB.x * rB.x;
    return b2Mat22(k11, k12, k12, k22);
}

/// For what the lanes calculate too: of one lane.
inline PairMasses<simd::Float1> MassesOf(const JointFrame& f)
{
    return {{f.mA}, {f.iA}, {f.mB}, {f.iB}};
}
inline HeldRow<float32> NumbersOf(const HeldRow<simd::Float1>& row)
{
    return {row.mass.v, {row.reaction.x.v, row.reaction.y.v}};
}

/// The inverse of a symmetric matrix, or zero where it is singular.
inline PairMasses<float32>::Matrix InverseInLanes(const b2Mat22& m)
{
    const float32 determinant = b2Cross(m.ex, m.ey);
    const float32 scale = determinant != 0.0f ? 1.0f / determinant : 0.0f;
    return {scale * m.ey.y, -scale * m.ex.y, scale * m.ex.x};
}

} // namespace box2d
