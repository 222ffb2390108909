// SPDX-License-Identifier: MIT
#pragma once

#include "JointBlocks.h"

/// The order in which joints are solved, and the joints that can be solved at once. Joints are
/// solved in the order of their creation, each with the velocities that those before it have left.
/// In a chain an impulse then runs along all links in one iteration. Two joints without a common
/// dynamic body are independent, so joints are sorted into levels. A joint is one level above the
/// last of its bodies' earlier joints (level scheduling of triangular solves; Anderson and Saad,
/// 1989). All joints of a level can be solved at the same time, with the same bits as one after the
/// other.
namespace box2d
{

class ConstraintGraph;
class ThreadPool;

class JointSchedule
{
public:
    /// Follows the graph's list of joints; free while that is unchanged.
    void Update(const ConstraintGraph& graph);
    /// Follows some of the graph's joints; cheap while these and the graph's version are unchanged.
    void Update(const Array<b2Joint*>& joints, int32 version);
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

    // In sub-steps.

    /// Call at the start of a step. The context has the duration of a sub-step.
    void Begin(const SolverContext& context, ThreadPool* threads);
    /// Call in each kick, which the context describes. Adds the impulses of the last kick to those
    /// of the step. Computes the rows at the present poses, and applies these impulses times
    /// `share`.
    void Kick(const SolverContext& context, float32 share, ThreadPool* threads);
    /// One iteration; whether all errors were below the tolerance.
    bool SolvePositionsInStep(const SolverContext& context, ThreadPool* threads);
    /// Call after the last kick: stores the sums of the step's impulses in the joints.
    void End(ThreadPool* threads);

private:
    void Build(const Array<b2Joint*>& joints);
    void SortInto(const Array<b2Joint*>& joints);
    void AddLevel(b2Joint* const* begin, b2Joint* const* end);
    void AddKind(b2JointType type, b2Joint* const* begin, b2Joint* const* end);
    template <class Function>
    void ForBlocks(int32 begin, int32 end, ThreadPool* threads, Function&& some);
    template <class Function>
    void ForRuns(float32* numbers, ThreadPool* threads, Function&& one);
    template <class Function>
    void ForImpulses(const JointBlock& block, Function&& function);
    void PassOn(const JointBlock& block, float32 share);
    bool SolvePositions(float32* numbers, const SolverContext& context, ThreadPool* threads);
    void Fill(const SolverContext& context, ThreadPool* threads);
    void Fill(JointBlock& block, const SolverContext& context);
    void Keep(const JointBlock& block);
    float32* NumbersOf(const JointBlock& block) { return m_numbers.data() + block.numbers; }

    Array<JointBlock> m_blocks; // level by level
    Array<float32> m_numbers;   // of the blocks
    Array<float32> m_atStart;   // in sub-steps: those at the start of the step
    Array<float32> m_sums;      // likewise, of the blocks: the sums of impulses over the kicks
    std::size_t m_impulseCount = 0;
    bool m_kicked = false;    // in this step
    Array<b2Joint*> m_joints; // the list that was followed
    Array<int32> m_levels;    // first block of each level, with one more for the end
    int32 m_version = -1;     // version of the graph's list
    // Scratch of Build, kept because joints change whenever islands wake and sleep.
    Array<int32> m_levelOf;   // per joint
    Array<int32> m_counts;    // per level
    Array<int32> m_ends;      // per level
    Array<b2Joint*> m_sorted; // by level
};

} // namespace box2d
