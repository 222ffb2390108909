// SPDX-License-Identifier: MIT
#include "CarryGuard.h"

#include "Access.h"
#include "SolverArrays.h"
#include "World.h"

#include <algorithm>

namespace box2d
{

namespace
{

/// What rounding, and friction whose bound has changed at last, may add to an island's energy, as a
/// share of it.
constexpr double kTolerance = 1e-3;

double KineticEnergyOf(const BodyData& body, const SolverBody& state)
{
    return body.IsDynamic() ? KineticEnergy(state, double(body.mass), double(body.inertia)) : 0.0;
}

bool Moves(const SolverBody& body)
{
    return body.v != b2Vec2_zero || body.w != 0.0f;
}

/// Calls for each contact, with its block, the block's totals, and its lane.
template <class Function>
void ForContacts(SolverArrays& arrays, Function&& function)
{
    for (int32 i = 0; i < arrays.colorCount; ++i)
    {
        ContactBlocks& blocks = arrays.contacts[arrays.colors[i]];
        for (int32 k = 0; k < blocks.Count(); ++k)
        {
            for (int32 lane = 0; lane < blocks.Contacts(k).count; ++lane)
            {
                function(blocks.Contacts(k), blocks.Totals(k), lane);
            }
        }
    }
}

} // namespace

bool CarryGuard::Island::HasWon() const
{
    return !exempt && after > (1.0 + kTolerance) * before;
}

int32 CarryGuard::IslandOf(const RowSides& sides) const
{
    for (int32 i = 0; i < sides.count; ++i)
    {
        if (sides.sides[i] != nullptr)
        {
            return m_islandOf[std::size_t(sides.sides[i]->SolverIndex())];
        }
    }
    return -1;
}

bool CarryGuard::HasWon(int32 island) const
{
    return island != -1 && m_islands[std::size_t(island)].HasWon();
}

bool CarryGuard::HasWon(const RowSides& sides) const
{
    return HasWon(IslandOf(sides));
}

void CarryGuard::Exempt(int32 island, bool really)
{
    if (island != -1 && really)
    {
        m_islands[std::size_t(island)].exempt = true;
    }
}

void CarryGuard::Begin(const World& world, SolverArrays& arrays)
{
    const std::size_t count = world.awakeBodies.size() + 1;
    m_before.resize(count);
    m_islands.assign(std::size_t(world.islands.Size()), Island());
    m_islandOf.assign(count, -1);
    for (const b2Body* body : world.awakeBodies)
    {
        m_islandOf[std::size_t(Data(*body).SolverIndex())] = Data(*body).island;
    }
    ForContacts(arrays, [&](const ContactBlock& block, const BlockTotals&, int32 lane) {
        const auto a = std::size_t(block.bodyA[lane]);
        const auto b = std::size_t(block.bodyB[lane]);
        const bool belt = block.tangentSpeed[lane] != 0.0f;
        Exempt(m_islandOf[a], belt || (m_islandOf[b] == -1 && Moves(arrays.bodies[b])));
        Exempt(m_islandOf[b], belt || (m_islandOf[a] == -1 && Moves(arrays.bodies[a])));
    });
    const JointSystem& joints = arrays.jointSystem;
    joints.ForRowed([&](std::size_t joint, const JointRows&) {
        const int32 island = IslandOf(joints.Sides(joint));
        Exempt(island, !joints.IsExact(joint));
        for (b2Body* body : {joints.At(joint).GetBodyA(), joints.At(joint).GetBodyB()})
        {
            const auto index = std::size_t(Data(*body).SolverIndex());
            Exempt(island, m_islandOf[index] == -1 && Moves(arrays.bodies[index]));
        }
    });
}

void CarryGuard::Note(const World& world, const SolverArrays& arrays)
{
    std::copy(arrays.bodies.begin(), arrays.bodies.end(), m_before.begin());
    for (Island& island : m_islands)
    {
        island.before = island.after = 0.0;
    }
    for (const b2Body* body : world.awakeBodies)
    {
        const BodyData& data = Data(*body);
        if (data.island != -1)
        {
            m_islands[std::size_t(data.island)].before +=
                KineticEnergyOf(data, arrays.bodies[std::size_t(data.SolverIndex())]);
        }
    }
}

bool CarryGuard::HasWon(const World& world, SolverArrays& arrays)
{
    for (const b2Body* body : world.awakeBodies)
    {
        const BodyData& data = Data(*body);
        if (data.island != -1)
        {
            m_islands[std::size_t(data.island)].after +=
                KineticEnergyOf(data, arrays.bodies[std::size_t(data.SolverIndex())]);
        }
    }
    const JointSystem& joints = arrays.jointSystem;
    SolverContext start, end;
    start.bodies = m_before.data();
    end.bodies = arrays.bodies.data();
    joints.ForRowed([&](std::size_t joint, const JointRows& rows) {
        const int32 island = IslandOf(joints.Sides(joint));
        if (rows.giving > 0 && island != -1)
        {
            m_islands[std::size_t(island)].before += joints.MostWork(joint, start, end);
        }
    });
    return std::any_of(m_islands.begin(), m_islands.end(),
                       [](const Island& island) { return island.HasWon(); });
}

void CarryGuard::TakeBack(SolverArrays& arrays) const
{
    for (std::size_t i = 0; i < arrays.bodies.size(); ++i)
    {
        if (HasWon(m_islandOf[i]))
        {
            arrays.bodies[i].v = m_before[i].v;
            arrays.bodies[i].w = m_before[i].w;
        }
    }
    ForContacts(arrays, [&](ContactBlock& block, BlockTotals& totals, int32 lane) {
        if (!HasWon(m_islandOf[std::size_t(block.bodyA[lane])]) &&
            !HasWon(m_islandOf[std::size_t(block.bodyB[lane])]))
        {
            return;
        }
        for (int32 i = 0; i < block.pointCount; ++i)
        {
            block.points[i].normalImpulse[lane] = block.points[i].tangentImpulse[lane] = 0.0f;
            totals.firstNormal[i][lane] = totals.firstTangent[i][lane] = 0.0f;
        }
    });
}

} // namespace box2d
