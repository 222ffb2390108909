// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "../Solver/ContactBlocks.h"
#include "../State/Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>

namespace box2d
{

/// A contact sticks below this fraction of its friction limit. Iterations clamp its impulse to the
/// limit in single precision. It may then differ from this limit by some roundings of 1e-7, far
/// less than the 1e-4 here. No note compares other values.
constexpr double kSticks = 0.9999;

/// Softness of a change of a normal impulse, as a fraction of the speed that it gives to its bodies
/// alone: the proximal point method (Rockafellar, "Monotone Operators and the Proximal Point
/// Algorithm", 1976). Contacts and joints that contradict each other by rounding then need no large
/// impulses, and a solution that does not change is exact. With 1e-6 a plate that winds a chain
/// around itself loses a third of its angular momentum in a step, with 1e-3 a random world bursts.
/// Islands that cannot contradict themselves need no softness, and any softness is too much for the
/// leaning of a tall stack (docs/notes/contradictory-contacts.md).
constexpr float32 kProximal = 1e-4f;

/// A contact of a block as an item: one row per normal and one for the tangent.
class ContactItem
{
public:
    ContactItem(ContactBlock& block, int32 lane) : m_block(block), m_lane(lane) {}

    /// `overlap`: of the same contact.
    void FillRows(JointRows& rows, const OverlapBlock& overlap, const SolverContext& context) const
    {
        const ContactData& contact = Data(*m_block.contact[m_lane]);
        rows.Clear();
        rows.rows = 3;
        JointRows::Column& a = rows.Of(Data(*contact.bodyA));
        JointRows::Column& b = rows.Of(Data(*contact.bodyB));
        const b2Vec2 normal(m_block.normalX[m_lane], m_block.normalY[m_lane]);
        const b2Vec2 tangent = b2Cross(normal, 1.0f);
        const float32 share = 1.0f / float32(m_block.pointCount);
        const b2Vec2 off = 0.5f * HowFarOff(overlap, context);
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            const PointLanes& p = m_block.points[i];
            a.AddTo(i, -normal, -p.normalLeverA[m_lane] - off.y);
            b.AddTo(i, normal, p.normalLeverB[m_lane] - off.y);
            a.AddTo(2, -share * tangent, share * (off.x - p.tangentLeverA[m_lane]));
            b.AddTo(2, share * tangent, share * (off.x + p.tangentLeverB[m_lane]));
        }
    }

    void Fill(BoundedSystem::Item& item, const Vector3& speed, double tolerance)
    {
        item = BoundedSystem::Item();
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            item.impulse.at[i] = double(Normal(i));
            item.maximum.at[i] = BoundedSystem::kUnbounded;
            const bool pushes = Normal(i) > 0.0f || speed.at[i] < -tolerance;
            item.active = uint8(item.active | int(pushes) << i);
            item.impulse.at[2] += double(Tangent(i));
        }
        item.speeds.at[2] = double(m_block.tangentSpeed[m_lane]);
        const double limit = Holds(item);
        item.minimum.at[2] = -limit;
        item.maximum.at[2] = limit;
        if (b2Abs(item.impulse.at[2]) < kSticks * limit)
        {
            item.active |= 4;
        }
    }

    double Holds(const BoundedSystem::Item& item) const
    {
        return double(m_block.friction[m_lane]) * (item.impulse.at[0] + item.impulse.at[1]);
    }

    /// Marks the impulses as proportional to the kick's length.
    void PassOnInProportion(BlockTotals& totals)
    {
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            totals.firstNormal[i][m_lane] = Normal(i);
            totals.firstTangent[i][m_lane] = Tangent(i);
        }
    }

    /// Counts the impulses and leaves nothing of them for the next kick.
    void CountImpact(BlockTotals& totals)
    {
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            totals.normal[i][m_lane] += Normal(i);
            totals.tangent[i][m_lane] += Tangent(i);
            Normal(i) = Tangent(i) = 0.0f;
        }
        PassOnInProportion(totals);
    }

    /// Sets friction as a fraction of each point's limit.
    void Take(const BoundedSystem::Item& item)
    {
        double load = 0.0;
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            load += item.impulse.at[i];
        }
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            const double share = load > 0.0 ? item.impulse.at[i] / load : 0.0;
            Normal(i) = float32(item.impulse.at[i]);
            Tangent(i) = float32(share * item.impulse.at[2]);
        }
    }

    /// Sets the approach speed of its points as a fraction of what their impulses, beyond those at
    /// the start, would do to them alone.
    void SetSoftness(JointRows& rows, BoundedSystem::Item& item, float32 share,
                     const Vector3& start) const
    {
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            rows.laws[i].softness = share / NormalMassOf(m_block, m_lane, i);
            item.start.at[i] = start.at[i];
        }
    }

private:
    /// Returns how far the arms of two bodies that press on each other end apart, along the normal
    /// and the tangent [m]. Arms are those of the middle of the step, and the bodies have moved
    /// since. A turn of both together would need an impulse then, and change their angular
    /// momentum.
    b2Vec2 HowFarOff(const OverlapBlock& overlap, const SolverContext& context) const
    {
        const b2Manifold& last = Data(*m_block.contact[m_lane]).manifold;
        bool presses = false;
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            presses = presses || m_block.points[i].normalImpulse[m_lane] > 0.0f ||
                      last.points[i].normalImpulse > 0.0f;
        }
        if (!presses || (m_block.movesA >> m_lane & m_block.movesB >> m_lane & 1) == 0)
        {
            return b2Vec2_zero;
        }
        const b2Vec2 offset(overlap.offsetX[m_lane], overlap.offsetY[m_lane]);
        const b2Vec2 apart = offset + context.bodies[m_block.bodyB[m_lane]].d -
                             context.bodies[m_block.bodyA[m_lane]].d;
        const b2Vec2 normal(m_block.normalX[m_lane], m_block.normalY[m_lane]);
        const PointLanes& p = m_block.points[0];
        // The normal's lever is the arm along the tangent, the tangent's minus that along the
        // normal.
        return b2Vec2(b2Dot(apart, normal) + p.tangentLeverA[m_lane] - p.tangentLeverB[m_lane],
                      b2Dot(apart, b2Cross(normal, 1.0f)) - p.normalLeverA[m_lane] +
                          p.normalLeverB[m_lane]);
    }

    float32& Normal(int32 i) { return m_block.points[i].normalImpulse[m_lane]; }
    float32& Tangent(int32 i) { return m_block.points[i].tangentImpulse[m_lane]; }

    ContactBlock& m_block;
    int32 m_lane;
};

} // namespace box2d
