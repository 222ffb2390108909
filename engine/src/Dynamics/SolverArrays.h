// SPDX-License-Identifier: MIT
#pragma once

#include "ConstraintGraph.h"
#include "ContactBlocks.h"
#include "JointSchedule.h"
#include "Solver.h"

/// The memory that a step works in. It belongs to the world and is used again in every step.
namespace box2d
{

struct SolverArrays
{
    Array<SolverBody> bodies;
    ContactBlocks contacts[ConstraintGraph::kColorCount]; ///< of the step, by colour
    int32 colors[ConstraintGraph::kColorCount]; ///< that have contacts, in the order of solving
    int32 colorCount = 0;
    JointSchedule joints;
    Array<uint8> left;               ///< by awake body: whether a shape has left its box
    Array<b2Contact*> reported;      ///< whose impulses the listener wants to know, in order
    Array<float32> impactTimes;      ///< by awake contact
    Array<ContactConstraint> impact; ///< of one impact
    Array<OverlapConstraint> impactOverlaps;
};

} // namespace box2d
