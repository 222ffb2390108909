// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Body.h>

/// What every joint needs of its two bodies: their places in the solver and their inverse masses.
/// Made on the spot, never kept.
namespace box2d
{

b2Vec2 CenterOffset(const BodyData& a, const BodyData& b);

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

    /// Velocity of B's point seen from A's.
    b2Vec2 PointSpeed(const b2Vec2& armA, const b2Vec2& armB) const
    {
        return b.v + b2Cross(b.w, armB) - a.v - b2Cross(a.w, armA);
    }
    void ApplyImpulse(const b2Vec2& impulse, const b2Vec2& armA, const b2Vec2& armB) const
    {
        a.v -= mA * impulse;
        a.w -= iA * b2Cross(armA, impulse);
        b.v += mB * impulse;
        b.w += iB * b2Cross(armB, impulse);
    }
    void ApplyAngularImpulse(float32 impulse) const
    {
        a.w -= iA * impulse;
        b.w += iB * impulse;
    }
    /// The same on positions, for corrections.
    void Move(const b2Vec2& impulse, const b2Vec2& armA, const b2Vec2& armB) const
    {
        a.d -= mA * impulse;
        a.Rotate(-iA * b2Cross(armA, impulse));
        b.d += mB * impulse;
        b.Rotate(iB * b2Cross(armB, impulse));
    }
    void Turn(float32 impulse) const
    {
        a.Rotate(-iA * impulse);
        b.Rotate(iB * impulse);
    }

    const BodyData& dataA;
    const BodyData& dataB;
    SolverBody& a;
    SolverBody& b;
    float32 mA, iA, mB, iB; ///< inverse
};

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

} // namespace box2d
