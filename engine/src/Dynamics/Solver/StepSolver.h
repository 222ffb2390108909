// SPDX-License-Identifier: MIT
#pragma once

#include "../State/World.h"
#include "OverlapSolver.h"
#include "SolverMemory.h"

#include <thread>

namespace box2d
{

/// Returns the parameters of a step of `timeStep` [s] > 0, for the step, its sub-steps and its
/// impacts. The bodies are assigned later.
SolverContext MakeContext(const World& world, float32 timeStep);

/// The stages of solving one step, in the order in which SolveAwake calls them, over arrays
/// that the world lends.
class StepSolver
{
public:
    StepSolver(World& world, float32 timeStep);

    bool IsProfiling() const { return m_profiling; }
    /// Brings awake bodies into the order of their islands where that pays off.
    void SortBodies();
    void WakeJointNeighbours();
    void IntegrateVelocities();
    void AssignContacts();
    /// Call before PrepareContacts.
    void BounceInCorners();
    /// True if no awake body has a contact or joint.
    bool IsFree() const;
    void PrepareContacts();
    void WarmStart();
    void SolveVelocities(int32 iterations);
    void StoreImpulses();
    void NoteImpulses();
    void ReportImpulses();
    void IntegratePositions();
    void NotePushes(float32 sign);
    void SolvePositions(int32 iterations);
    void WriteBack();
    void LetRest();

protected:
    void FindGroups();
    void FindIslands();
    void AssignBlocks(int32 color);
    /// Processes the blocks in order, on the given threads.
    template <class Function>
    void ForEachBlock(Direction direction, ThreadPool* threads, Function&& one);
    template <class Function>
    void ForBodies(Function&& function);
    SolverBody WithForces(const BodyData& body) const;
    bool WriteBack(BodyData& body, SolverBody& moved) const;
    bool SolveContacts(Direction direction, float32 unchanged = 0.0f);
    float32 SolveOverlaps(Direction direction, PushPace pace);
    void TurnAsSeen();

    // Blocks, and bodies, per part of a parallel loop. They affect the time only: 8 blocks have up
    // to 128 contacts, and a body takes a small part of the time of its contacts. With less,
    // threads fetch parts too often; with more, a colour has fewer parts than threads.
    static constexpr int32 kBlockGrain = 8;
    static constexpr int32 kBodyGrain = 64;

    World& m_world;
    SolverMemory& m_memory;
    ThreadPool* m_threads; // may be null
    SolverContext m_context;
    IslandGroup m_group;         // the present one
    bool m_foundIslands = false; // the awake ones
    bool m_profiling;            // this thread adds its times to the profile

    template <class Solver, class Function>
    friend void ForGroups(Solver& solver, Function&& function);
};

/// Calls the function with a solver for each group of islands, whose functions handle the bodies
/// and contacts of that group only. Threads take one group after another.
template <class Solver, class Function>
void ForGroups(Solver& solver, Function&& function)
{
    const int32 count = solver.m_memory.groups.Count();
    if (count == 1)
    {
        function(solver);
        return;
    }
    const std::thread::id caller = std::this_thread::get_id();
    ParallelFor(solver.m_threads, count, 1, [&](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            Solver part(solver);
            part.m_threads = nullptr;
            part.m_group = solver.m_memory.groups.At(i);
            part.m_profiling = solver.m_profiling && std::this_thread::get_id() == caller;
            function(part);
        }
    });
}

/// Processes colour after colour: first contacts that may share bodies, in order; then the blocks
/// of each colour on all threads.
template <class Function>
void StepSolver::ForEachBlock(Direction direction, ThreadPool* threads, Function&& one)
{
    const int32 count = m_memory.colorCount;
    for (int32 i = 0; i < count; ++i)
    {
        const int32 color = m_memory.colors[direction == Direction::Forward ? i : count - 1 - i];
        ContactBlocks& blocks = m_memory.contacts[color];
        const BlockRange range = blocks.Of(m_group);
        ParallelFor(color == ConstraintGraph::kOverflow ? nullptr : threads,
                    range.end - range.begin, kBlockGrain, [&](int32 begin, int32 end) {
                        for (int32 k = 0; k < end - begin; ++k)
                        {
                            one(blocks,
                                range.begin +
                                    (direction == Direction::Forward ? begin + k : end - 1 - k));
                        }
                    });
    }
}

template <class Function>
void StepSolver::ForBodies(Function&& function)
{
    ParallelFor(m_threads, int32(m_world.awakeBodies.size()), kBodyGrain,
                [&](int32 begin, int32 end) {
                    for (int32 i = begin; i < end; ++i)
                    {
                        function(std::size_t(i));
                    }
                });
}

} // namespace box2d
