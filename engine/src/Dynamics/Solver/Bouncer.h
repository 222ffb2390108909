// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlockSolver.h"
#include "Restitution.h"

namespace box2d
{

/// Iterations over what bounces in a row: an impulse passes from one body to the next in each, so a
/// row of 64 balls is exact in any order. In a wedge of 3 degrees a ball turns back in 30. A bound;
/// no test fails with 512.
inline constexpr int32 kMaxBounces = 64;

/// Returns the normal speed of a point; approach is negative [m/s].
inline float32 NormalSpeedOf(const ContactBlock& block, int32 lane, int32 point,
                             const SolverBody* bodies)
{
    const SolverBody& a = bodies[block.bodyA[lane]];
    const SolverBody& b = bodies[block.bodyB[lane]];
    const PointLanes& p = block.points[point];
    return b2Dot(b.v - a.v, b2Vec2(block.normalX[lane], block.normalY[lane])) +
           b.w * p.normalLeverB[lane] - a.w * p.normalLeverA[lane];
}

/// True if a point of the contact approaches fast enough to bounce.
inline bool IsBouncing(const ContactBlock& block, int32 lane, const SolverContext& context)
{
    bool any = false;
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        const float32 speed = NormalSpeedOf(block, lane, i, context.bodies);
        any = any || IsBouncing(simd::Float1{speed}, context).v;
    }
    return any;
}

/// Restitution of one contact of a block, before contacts are solved: in sub-steps of all contacts
/// (SubStepSolver::Bounce), in a whole step of those in corners (Corners.h). Independent of other
/// contacts and joints.
class Bouncer
{
public:
    Bouncer(ContactBlock& block, BlockTotals& totals, int32 lane, const SolverContext& context)
        : m_context(context), m_block(block), m_totals(totals), m_lane(lane),
          m_a(context.bodies[block.bodyA[lane]]), m_b(context.bodies[block.bodyB[lane]]),
          m_normal(block.normalX[lane], block.normalY[lane])
    {}

    /// Applies restitution; false if the approach speed is too low. Never adds energy: an impulse x
    /// at a point whose speed changes from v to v' does the work x (v + v') / 2. Both points are
    /// pushed together only if both approach, so that v' = -e v at each. A separating point would
    /// be held at v' = 0, which is work, so it waits until it approaches itself. Friction follows
    /// the normal impulses, which do not include the rotation that it causes.
    bool Bounce(float32 restitution)
    {
        if (!IsBouncing(m_block, m_lane, m_context))
        {
            return false;
        }
        const int32 count = m_block.pointCount;
        const float32 more = 1.0f + restitution;
        const float32 speed1 = NormalSpeed(0);
        const float32 speed2 = count == 2 ? NormalSpeed(1) : 0.0f;
        float32 x[2] = {};
        if (speed1 < 0.0f && speed2 < 0.0f && SolvePair(more * speed1, more * speed2, x))
        {
            Push(0, x[0]);
            Push(1, x[1]);
        }
        else
        {
            for (int32 i = 0; i < count; ++i)
            {
                const float32 coming = b2Max(-NormalSpeed(i), 0.0f);
                x[i] = more * coming * NormalMassOf(m_block, m_lane, i);
                Push(i, x[i]);
            }
        }
        for (int32 i = 0; i < count; ++i)
        {
            ApplyFriction(i, x[i]);
        }
        return true;
    }

private:
    float32 NormalSpeed(int32 i) const
    {
        return NormalSpeedOf(m_block, m_lane, i, m_context.bodies);
    }
    float32 TangentSpeed(int32 i) const
    {
        const PointLanes& p = m_block.points[i];
        return b2Dot(m_b.v - m_a.v, b2Cross(m_normal, 1.0f)) + m_b.w * p.tangentLeverB[m_lane] -
               m_a.w * p.tangentLeverA[m_lane] - m_block.tangentSpeed[m_lane];
    }
    /// False if the points are too close to be solved together.
    bool SolvePair(float32 wanted1, float32 wanted2, float32 (&x)[2]) const
    {
        using F = simd::Float1;
        F x1, x2;
        const bool solved =
            PairResponse<F>::Of(m_block, m_lane).Enumerate(F{wanted1}, F{wanted2}, x1, x2).v;
        x[0] = x1.v;
        x[1] = x2.v;
        return solved && AreCoupled<F>(m_block, m_lane).v;
    }
    void Push(int32 i, float32 impulse)
    {
        const PointLanes& p = m_block.points[i];
        Apply(impulse, m_normal, p.normalLeverA[m_lane], p.normalLeverB[m_lane]);
        m_totals.normal[i][m_lane] += impulse;
    }
    /// Applies the friction of a normal impulse.
    void ApplyFriction(int32 i, float32 impulse)
    {
        const PointLanes& p = m_block.points[i];
        const float32 limit = m_block.friction[m_lane] * impulse;
        const float32 drag =
            b2Clamp(-TangentSpeed(i) * m_block.pointMass[i][m_lane], -limit, limit);
        Apply(drag, b2Cross(m_normal, 1.0f), p.tangentLeverA[m_lane], p.tangentLeverB[m_lane]);
        m_totals.tangent[i][m_lane] += drag;
    }
    void Apply(float32 impulse, const b2Vec2& direction, float32 leverA, float32 leverB)
    {
        if ((m_block.movesA >> m_lane & 1) != 0)
        {
            m_a.v -= (m_block.masses.invMassA[m_lane] * impulse) * direction;
            m_a.w -= m_block.masses.invInertiaA[m_lane] * leverA * impulse;
        }
        if ((m_block.movesB >> m_lane & 1) != 0)
        {
            m_b.v += (m_block.masses.invMassB[m_lane] * impulse) * direction;
            m_b.w += m_block.masses.invInertiaB[m_lane] * leverB * impulse;
        }
    }

    const SolverContext& m_context;
    ContactBlock& m_block;
    BlockTotals& m_totals;
    int32 m_lane;
    SolverBody& m_a;
    SolverBody& m_b;
    b2Vec2 m_normal;
};

} // namespace box2d
