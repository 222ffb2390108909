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

int32 IslandOf(const SolverArrays& arrays, const RowSides& sides)
{
    for (int32 i = 0; i < sides.count; ++i)
    {
        if (sides.sides[i] != nullptr)
        {
            return arrays.islands.Of(sides.sides[i]->SolverIndex());
        }
    }
    return -1;
}

} // namespace

bool CarryGuard::Island::HasWon() const
{
    return !exempt && after > (1.0 + kTolerance) * before;
}

bool CarryGuard::HasWon(int32 island) const
{
    return island != -1 && m_islands[std::size_t(island)].HasWon();
}

bool CarryGuard::HasWon(const SolverArrays& arrays, const RowSides& sides) const
{
    return HasWon(IslandOf(arrays, sides));
}

void CarryGuard::Exempt(int32 island, bool really)
{
    if (island != -1 && really)
    {
        m_islands[std::size_t(island)].exempt = true;
    }
}

void CarryGuard::Begin(SolverArrays& arrays)
{
    const AwakeIslands& islands = arrays.islands;
    m_before.resize(arrays.bodies.size());
    m_islands.assign(std::size_t(islands.Count()), Island());
    ForContacts(arrays, [&](const ContactBlock& block, const BlockTotals&, int32 lane) {
        const int32 a = islands.Of(block.bodyA[lane]);
        const int32 b = islands.Of(block.bodyB[lane]);
        const bool belt = block.tangentSpeed[lane] != 0.0f;
        const auto moves = [&](int32 body) { return Moves(arrays.bodies[std::size_t(body)]); };
        Exempt(a, belt || (b == -1 && moves(block.bodyB[lane])));
        Exempt(b, belt || (a == -1 && moves(block.bodyA[lane])));
    });
    const JointSystem& joints = arrays.jointSystem;
    joints.ForRowed([&](std::size_t joint, const JointRows&) {
        const int32 island = IslandOf(arrays, joints.Sides(joint));
        Exempt(island, !joints.IsExact(joint));
        for (b2Body* body : {joints.At(joint).GetBodyA(), joints.At(joint).GetBodyB()})
        {
            const int32 index = Data(*body).SolverIndex();
            Exempt(island, islands.Of(index) == -1 && Moves(arrays.bodies[std::size_t(index)]));
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
        const int32 island = arrays.islands.Of(data.SolverIndex());
        if (island != -1)
        {
            m_islands[std::size_t(island)].before +=
                KineticEnergyOf(data, arrays.bodies[std::size_t(data.SolverIndex())]);
        }
    }
}

bool CarryGuard::HasWon(const World& world, SolverArrays& arrays)
{
    for (const b2Body* body : world.awakeBodies)
    {
        const BodyData& data = Data(*body);
        const int32 island = arrays.islands.Of(data.SolverIndex());
        if (island != -1)
        {
            m_islands[std::size_t(island)].after +=
                KineticEnergyOf(data, arrays.bodies[std::size_t(data.SolverIndex())]);
        }
    }
    const JointSystem& joints = arrays.jointSystem;
    SolverContext start, end;
    start.bodies = m_before.data();
    end.bodies = arrays.bodies.data();
    joints.ForRowed([&](std::size_t joint, const JointRows& rows) {
        const int32 island = IslandOf(arrays, joints.Sides(joint));
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
        if (HasWon(arrays.islands.Of(int32(i))))
        {
            arrays.bodies[i].v = m_before[i].v;
            arrays.bodies[i].w = m_before[i].w;
        }
    }
    ForContacts(arrays, [&](ContactBlock& block, BlockTotals& totals, int32 lane) {
        if (!HasWon(arrays.islands.Of(block.bodyA[lane])) &&
            !HasWon(arrays.islands.Of(block.bodyB[lane])))
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
