// SPDX-License-Identifier: MIT
#pragma once

#include "HingeBlocks.h"

class b2Joint;

/// The order in which joints are solved, and what of it can be done at once. Joints are solved in
/// the order of their creation, each with what those before it have left of its bodies: in a chain
/// an impulse then runs along all links in one sweep. Two joints that share no body
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
    /// Follows the graph's list of joints; costs nothing while that stays the same.
    void Update(const ConstraintGraph& graph);
    bool IsEmpty() const { return m_levels.empty(); }
    /// What is solved at one time, level by level.
    Array<Array<b2Joint*>> Levels() const;

    void Prepare(const SolverContext& context, ThreadPool* threads);
    /// One sweep.
    void SolveVelocities(const SolverContext& context, ThreadPool* threads);
    /// Puts the impulses back into the joints.
    void StoreImpulses(ThreadPool* threads);
    /// One sweep; whether all errors were below the tolerance.
    bool SolvePositions(const SolverContext& context, ThreadPool* threads);

private:
    /// Up to the next level's, of either list.
    struct Level
    {
        int32 firstBlock, firstSingle;
    };

    void Build(const Array<b2Joint*>& joints);
    void SortInto(const Array<b2Joint*>& joints, const Array<int32>& levels,
                  const Array<int32>& counts);
    void AddLevel(b2Joint* const* begin, b2Joint* const* end);
    template <class OneBlock, class OneJoint>
    void ForLevels(ThreadPool* threads, OneBlock&& oneBlock, OneJoint&& oneJoint);

    Array<HingeBlock> m_blocks;
    Array<b2Joint*> m_singles;
    Array<Level> m_levels; // and one more for the end
    int32 m_version = -1;  // of the graph's list
};

} // namespace box2d
