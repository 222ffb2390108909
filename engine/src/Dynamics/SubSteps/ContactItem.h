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

/// A contact of a block as an item: one row per normal and one for the tangent.
class ContactItem
{
public:
    ContactItem(ContactBlock& block, int32 lane) : m_block(block), m_lane(lane) {}

    void FillRows(JointRows& rows) const
    {
        const ContactData& contact = Data(*m_block.contact[m_lane]);
        rows.Clear();
        rows.rows = 3;
        JointRows::Column& a = rows.Of(Data(*contact.bodyA));
        JointRows::Column& b = rows.Of(Data(*contact.bodyB));
        const b2Vec2 normal(m_block.normalX[m_lane], m_block.normalY[m_lane]);
        const b2Vec2 tangent = b2Cross(normal, 1.0f);
        const float32 share = 1.0f / float32(m_block.pointCount);
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            const PointLanes& p = m_block.points[i];
            a.AddTo(i, -normal, -p.normalLeverA[m_lane]);
            b.AddTo(i, normal, p.normalLeverB[m_lane]);
            a.AddTo(2, -share * tangent, -share * p.tangentLeverA[m_lane]);
            b.AddTo(2, share * tangent, share * p.tangentLeverB[m_lane]);
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

    /// Sets the approach speed of its points as a fraction of what their impulses would do to them
    /// alone.
    void SetSoftness(JointRows& rows, float32 share) const
    {
        for (int32 i = 0; i < m_block.pointCount; ++i)
        {
            rows.laws[i].softness = share / NormalMassOf(m_block, m_lane, i);
        }
    }

private:
    float32& Normal(int32 i) { return m_block.points[i].normalImpulse[m_lane]; }
    float32& Tangent(int32 i) { return m_block.points[i].tangentImpulse[m_lane]; }

    ContactBlock& m_block;
    int32 m_lane;
};

} // namespace box2d
