// SPDX-License-Identifier: MIT
#pragma once

#include "JointBlocks.h"

/// The order in which joints are solved, and what of it can be done at once. Joints are solved in
/// the order of their creation, each with what those before it have left of its bodies: in a chain
/// an impulse then runs along all links in one iteration. Two joints that share no body
/// that moves do not notice each other's turn, so they are sorted into levels: a joint is one level
/// above the last of its bodies' earlier joints (level scheduling of triangular solves; Anderson
/// and Saad, 1989). Within a level all can be solved at the same time; the result is that of one
/// after the other, to the last bit.
namespace box2d
{

class ConstraintGraph;
class ThreadPool;

class JointSchedule
{
public:
    /// Follows the graph's list of joints; free while that is unchanged.
    void Update(const ConstraintGraph& graph);
    bool IsEmpty() const { return m_levels.empty(); }
    /// Returns the joints, level by level.
    Array<Array<b2Joint*>> Levels() const;

    void Prepare(const SolverContext& context, ThreadPool* threads);
    /// One iteration.
    void SolveVelocities(const SolverContext& context, ThreadPool* threads);
    /// Stores the impulses in the joints.
    void StoreImpulses(ThreadPool* threads);
    /// One iteration; whether all errors were below the tolerance.
    bool SolvePositions(const SolverContext& context, ThreadPool* threads);

private:
    void Build(const Array<b2Joint*>& joints);
    void SortInto(const Array<b2Joint*>& joints);
    void AddLevel(b2Joint* const* begin, b2Joint* const* end);
    void AddKind(b2JointType type, b2Joint* const* begin, b2Joint* const* end);
    template <class Function>
    void ForBlocks(int32 begin, int32 end, ThreadPool* threads, Function&& some);
    template <class Function>
    void ForRuns(ThreadPool* threads, Function&& one);
    void Fill(JointBlock& block, const SolverContext& context);
    void Keep(const JointBlock& block);
    float32* NumbersOf(const JointBlock& block) { return m_numbers.data() + block.numbers; }

    Array<JointBlock> m_blocks; // level by level
    Array<float32> m_numbers;   // of the blocks
    Array<int32> m_levels;      // first block of each level, with one more for the end
    int32 m_version = -1;       // version of the graph's list
    // Scratch of Build, kept because joints change whenever islands wake and sleep.
    Array<int32> m_levelOf;   // per joint
    Array<int32> m_counts;    // per level
    Array<int32> m_ends;      // per level
    Array<b2Joint*> m_sorted; // by level
};

} // namespace box2d
