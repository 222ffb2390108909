// SPDX-License-Identifier: MIT
#include "WarmStartGuard.h"

#include "../Solver/SolverMemory.h"
#include "../State/Access.h"

#include <algorithm>

namespace box2d
{

namespace
{

/// Relative energy that rounding, and friction with a changed bound, may add to an island. With a
/// hundredth calm islands start from zero, and forty boxes rest after 5.8 s instead of 3.9. Up to
/// 0.1 no test fails (docs/notes/tuned-constants.md).
constexpr double kTolerance = 1e-3;

bool Moves(const SolverBody& body)
{
    return body.v != b2Vec2_zero || body.w != 0.0f;
}

/// Calls the function for each contact of the group's wanted blocks, with its block, the block's
/// totals, and its lane.
template <class IsWanted, class Function>
void ForContacts(SolverMemory& solver, const IslandGroup& group, IsWanted&& isWanted,
                 Function&& function)
{
    for (int32 i = 0; i < solver.colorCount; ++i)
    {
        ContactBlocks& blocks = solver.contacts[solver.colors[i]];
        const BlockRange range = blocks.Of(group);
        for (int32 k = range.begin; k < range.end; ++k)
        {
            const int32 count = isWanted(blocks.Contacts(k)) ? blocks.Contacts(k).count : 0;
            for (int32 lane = 0; lane < count; ++lane)
            {
                function(blocks.Contacts(k), blocks.Totals(k), lane);
            }
        }
    }
}

int32 IslandOf(const SolverMemory& solver, const RowSides& sides)
{
    for (int32 i = 0; i < sides.count; ++i)
    {
        if (sides.sides[i] != nullptr)
        {
            return solver.islands.Of(sides.sides[i]->SolverIndex());
        }
    }
    return -1;
}

} // namespace

bool WarmStartGuard::Island::HasGained() const
{
    return !exempt && after > (1.0 + kTolerance) * before;
}

bool WarmStartGuard::HasGained(int32 island) const
{
    return island != -1 && m_islands[std::size_t(island)].HasGained();
}

bool WarmStartGuard::HasGained(const SolverMemory& solver, const RowSides& sides) const
{
    return HasGained(IslandOf(solver, sides));
}

void WarmStartGuard::Exempt(int32 island, bool really)
{
    if (island != -1 && really)
    {
        m_islands[std::size_t(island)].exempt = true;
    }
}

void WarmStartGuard::Begin(SolverMemory& solver, const JointSystem& joints,
                           const ContactSystem& contacts)
{
    const AwakeIslands& islands = solver.islands;
    m_before.resize(solver.bodies.size());
    m_islands.resize(std::size_t(islands.Count()));
    for (int32 i = 0; i < islands.Count(); ++i)
    {
        m_islands[std::size_t(i)] = {.exempt = contacts.IsLarge(i)};
    }
    m_checksAny = !std::ranges::all_of(m_islands, &Island::exempt);
    if (!m_checksAny)
    {
        return;
    }
    m_anyMoves = false;
    for (std::size_t i = 1; i < solver.bodies.size(); ++i)
    {
        m_anyMoves = m_anyMoves || (islands.Of(int32(i)) == -1 && Moves(solver.bodies[i]));
    }
    joints.ForIterated([&](b2Joint* joint) {
        for (const b2Body* body : {joint->GetBodyA(), joint->GetBodyB()})
        {
            Exempt(islands.Of(Data(*body).SolverIndex()), true);
        }
    });
    m_checksAny = !std::ranges::all_of(m_islands, &Island::exempt);
}

std::span<WarmStartGuard::Island> WarmStartGuard::Of(const IslandGroup& group)
{
    return std::span(m_islands).subspan(std::size_t(group.firstIsland),
                                        std::size_t(group.endIsland - group.firstIsland));
}

void WarmStartGuard::Note(const SolverMemory& solver, const IslandGroup& group)
{
    if (m_checksAny)
    {
        std::copy(solver.bodies.begin() + group.firstBody + 1,
                  solver.bodies.begin() + group.endBody + 1,
                  m_before.begin() + group.firstBody + 1);
    }
}

void WarmStartGuard::FindEnergies(const SolverMemory& solver, const IslandGroup& group,
                                  const BodyKick* kicks)
{
    for (Island& island : Of(group))
    {
        island.before = island.after = 0.0;
    }
    for (auto i = std::size_t(group.firstBody) + 1; i <= std::size_t(group.endBody); ++i)
    {
        const int32 number = solver.islands.Of(int32(i));
        if (number != -1)
        {
            const auto mass = double(kicks[i - 1].mass);
            const auto inertia = double(kicks[i - 1].inertia);
            Island& island = m_islands[std::size_t(number)];
            island.before += KineticEnergy(m_before[i], mass, inertia);
            island.after += KineticEnergy(solver.bodies[i], mass, inertia);
        }
    }
}

/// Adds what platforms and belts supply by the contacts' impulses at their speeds. Relative to
/// them, iterations from zero impulses only lower the energy.
void WarmStartGuard::AddDrives(SolverMemory& solver, const IslandGroup& group)
{
    const auto drives = [&](const ContactBlock& block) { return m_anyMoves || block.driven; };
    ForContacts(
        solver, group, drives, [&](const ContactBlock& block, const BlockTotals&, int32 lane) {
            const auto platform = [&](int32 body) {
                return solver.islands.Of(body) == -1 ? solver.bodies[std::size_t(body)]
                                                     : SolverBody();
            };
            const SolverBody a = platform(block.bodyA[lane]);
            const SolverBody b = platform(block.bodyB[lane]);
            const b2Vec2 normal(block.normalX[lane], block.normalY[lane]);
            const float32 along = b2Dot(a.v - b.v, normal);
            const float32 across =
                b2Dot(a.v - b.v, b2Cross(normal, 1.0f)) + block.tangentSpeed[lane];
            Island& island = m_islands[std::size_t(
                b2Max(solver.islands.Of(block.bodyA[lane]), solver.islands.Of(block.bodyB[lane])))];
            for (int32 i = 0; i < block.pointCount; ++i)
            {
                const PointLanes& p = block.points[i];
                const float32 push =
                    along + a.w * p.normalLeverA[lane] - b.w * p.normalLeverB[lane];
                const float32 drag =
                    across + a.w * p.tangentLeverA[lane] - b.w * p.tangentLeverB[lane];
                island.before += double(p.normalImpulse[lane]) * double(push) +
                                 double(p.tangentImpulse[lane]) * double(drag);
            }
        });
}

bool WarmStartGuard::HasGained(SolverMemory& solver, const IslandGroup& group,
                               const BodyKick* kicks, const JointSystem& joints)
{
    if (!m_checksAny)
    {
        return false;
    }
    FindEnergies(solver, group, kicks);
    AddDrives(solver, group);
    SolverContext start, end;
    start.bodies = m_before.data();
    end.bodies = solver.bodies.data();
    joints.ForRowed([&](std::size_t joint, const JointRows& rows) {
        const int32 island = IslandOf(solver, joints.Sides(joint));
        if (rows.boundedRows > 0 && island != -1)
        {
            m_islands[std::size_t(island)].before += joints.MaxWork(joint, start, end);
        }
        for (int32 row = 0; row < rows.rows && m_anyMoves && island != -1; ++row)
        {
            m_islands[std::size_t(island)].before -=
                double(rows.impulse[row]) * GivenSpeed(rows, row, start);
        }
    });
    return std::ranges::any_of(Of(group), [](const Island& island) { return island.HasGained(); });
}

void WarmStartGuard::Restore(SolverMemory& solver, const IslandGroup& group) const
{
    for (auto i = std::size_t(group.firstBody) + 1; i <= std::size_t(group.endBody); ++i)
    {
        if (HasGained(solver.islands.Of(int32(i))))
        {
            solver.bodies[i].v = m_before[i].v;
            solver.bodies[i].w = m_before[i].w;
        }
    }
    const auto all = [](const ContactBlock&) { return true; };
    ForContacts(solver, group, all, [&](ContactBlock& block, BlockTotals& totals, int32 lane) {
        if (!HasGained(solver.islands.Of(block.bodyA[lane])) &&
            !HasGained(solver.islands.Of(block.bodyB[lane])))
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
