// SPDX-License-Identifier: MIT
#pragma once

#include "../State/BodyPose.h"
#include "JointEnergy.h"
#include "JointLanes.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Body.h>

/// What joints compute from the present poses of their bodies.
namespace box2d
{

/// A pair with its inverse masses.
struct JointFrame : JointPair
{
    JointFrame(const b2Body& bodyA, const b2Body& bodyB, const SolverContext& context)
        : JointPair(bodyA, bodyB, context.bodies), mA(dataA.SolverInvMass()),
          iA(dataA.SolverInvInertia()), mB(dataB.SolverInvMass()), iB(dataB.SolverInvInertia())
    {}

    /// The vector from the joint's point of A to that of B.
    struct Line
    {
        b2Vec2 armA, armB;
        b2Vec2 axis; ///< unit vector, or zero without a direction
        float32 length;
    };
    Line Between(const b2Vec2& localAnchorA, const b2Vec2& localAnchorB) const
    {
        Line line{ArmA(localAnchorA), ArmB(localAnchorB), {}, 0.0f};
        line.axis = Offset() + line.armB - line.armA;
        line.length = line.axis.Normalize();
        if (line.length == 0.0f)
        {
            line.axis.SetZero();
        }
        return line;
    }

    float32 mA, iA, mB, iB; ///< inverse masses and inertias
};

/// A spring as a soft constraint (Catto, "Soft Constraints", GDC 2011). With stiffness k, damping c
/// and step h:
///   gamma = 1 / (h (c + h k)),  bias = C h k gamma,
///   impulse = -(Cdot + bias + gamma * total) / (K + gamma).
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

/// Converts for the numbers of a type; see JointBlocks.h.
inline Vector<float32> InLanes(const b2Vec2& v)
{
    return {v.x, v.y};
}

inline float32 Flag(bool flag)
{
    return flag ? 1.0f : 0.0f;
}

/// Limits a vector to the maximum impulse of a force in a step.
inline b2Vec2 ClampLength(const b2Vec2& v, float32 limit)
{
    const float32 squared = v.LengthSquared();
    return squared > limit * limit ? (limit / b2Sqrt(squared)) * v : v;
}

/// Returns the warm starting factor of a step.
inline float32 WarmStartFactor(const SolverContext& context)
{
    return context.warmStarting ? context.stepRatio : 0.0f;
}

/// Same as above, for a joint with anchors. Returns 0 if a body with a lever rotates so far in a
/// step that the impulses have the wrong direction. A few iterations do not correct that, so that
/// bodies gain energy and impulses grow from step to step.
inline float32 WarmStartFactor(const SolverContext& context, const b2Joint& joint)
{
    // The direction of a pendulum's tension is then off by half of itself. With 0.125, 2, 4 and 16
    // rad no fast test fails. With 1 rad and with no limit one chaotic random world throws a body.
    constexpr float32 kMaxTurn = 0.5f; // [rad]
    // Radii of gyration. A rod held at its end has 1.7. If that counted, limbs that lie on each
    // other would lose their warm start again and again, and never rest. With 4 no test fails; with
    // 1 a test of a chain that diverges finds no energy to take.
    constexpr float32 kRadii = 2.0f;
    const auto turns = [&context](const b2Body& body) {
        return b2Abs(context.timeStep * context.bodies[Data(body).SolverIndex()].w) > kMaxTurn;
    };
    const bool isStale = (turns(*joint.GetBodyA()) && HasLeverOnA(joint, kRadii)) ||
                         (turns(*joint.GetBodyB()) && HasLeverOnB(joint, kRadii));
    return isStale ? 0.0f : WarmStartFactor(context);
}

/// Scales an impulse; resets one that is not finite.
inline void Scale(float32& impulse, float32 share)
{
    impulse = b2IsValid(impulse) ? share * impulse : 0.0f;
}

inline void Scale(b2Vec2& impulse, float32 share)
{
    Scale(impulse.x, share);
    Scale(impulse.y, share);
}

/// Writes the first lines of every joint's Dump.
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

// For calculations shared with the lanes: a single lane.

inline PairMasses<simd::Float1> MassesOf(const JointFrame& f)
{
    return {{f.mA}, {f.iA}, {f.mB}, {f.iB}};
}
inline Vector<simd::Float1> InOneLane(const b2Vec2& v)
{
    return {{v.x}, {v.y}};
}
inline HeldRow<float32> NumbersOf(const HeldRow<simd::Float1>& row)
{
    return {row.mass.v, {row.reaction.x.v, row.reaction.y.v}};
}
inline PairMasses<float32>::Matrix NumbersOf(const PairMasses<simd::Float1>::Matrix& m)
{
    return {m.k11.v, m.k12.v, m.k22.v};
}

/// Returns the response of the relative speed along `axis` to an impulse along it:
///   K = mA + mB + iA (rA x n)^2 + iB (rB x n)^2.
inline float32 AxisMatrix(const JointFrame& f, const b2Vec2& axis, const b2Vec2& rA,
                          const b2Vec2& rB)
{
    return MassesOf(f).AxisMatrix(InOneLane(axis), InOneLane(rA), InOneLane(rB)).v;
}

/// Returns the inverse of the response of the two points, see PairMasses; zero if it is singular.
inline PairMasses<float32>::Matrix InversePointMatrix(const JointFrame& f, const b2Vec2& rA,
                                                      const b2Vec2& rB)
{
    return NumbersOf(MassesOf(f).PointMatrix(InOneLane(rA), InOneLane(rB)).Inverse());
}

} // namespace box2d
