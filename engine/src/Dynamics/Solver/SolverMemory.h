// SPDX-License-Identifier: MIT
#pragma once

#include "../Islands/AwakeIslands.h"
#include "../Joints/JointSchedule.h"
#include "../State/ConstraintGraph.h"
#include "../State/Solver.h"
#include "ContactBlocks.h"

namespace box2d
{

/// The memory that the solution of a step works in. It belongs to the world and is used again in
/// every step; so is that of the other stages.
struct SolverMemory
{
    Array<SolverBody> bodies;
    ContactBlocks contacts[ConstraintGraph::kColorCount]; ///< of the step, by colour
    int32 colors[ConstraintGraph::kColorCount]; ///< that have contacts, in the order of solving
    int32 colorCount = 0;
    JointSchedule joints;
    AwakeIslands islands;       ///< of sub-steps
    Array<uint8> left;          ///< by awake body: whether a shape has left its box
    Array<uint8> deep;          ///< by solver index, of sub-steps: see FindDeep
    Array<b2Contact*> reported; ///< whose impulses the listener wants to know, in order
};

} // namespace box2d
