// SPDX-License-Identifier: MIT
#pragma once

#include "../Islands/AwakeIslands.h"
#include "../Joints/JointSchedule.h"
#include "../State/ConstraintGraph.h"
#include "../State/Solver.h"
#include "ContactBlocks.h"
#include "IslandGroups.h"

namespace box2d
{

/// The impulses of a contact that bounced in a corner before the iterations of its step.
struct CornerImpulse
{
    const b2Contact* contact;
    float32 normal[2], tangent[2];
};

/// Scratch memory of BounceInCorners.
struct CornerMemory
{
    Array<b2Contact*> contacts;    ///< of one body
    Array<ContactBlock> blocks;    ///< one for each contact, and more of earlier bodies
    Array<OverlapBlock> overlaps;  ///< one for each block
    Array<BlockTotals> totals;     ///< the same
    Array<CornerImpulse> impulses; ///< of all bodies, for the listener
};

/// The scratch memory of the solver and the other stages of a step. Owned by the world and reused
/// in every step.
struct SolverMemory
{
    Array<SolverBody> bodies;
    /// By solver index: the way that pushes out of overlaps moved a body in this step [m]. Empty
    /// unless the energy guard wants to know.
    Array<b2Vec2> pushed;
    ContactBlocks contacts[ConstraintGraph::kColorCount]; ///< of the step, by colour
    int32 colors[ConstraintGraph::kColorCount]; ///< colours with contacts, in the order of solving
    int32 colorCount = 0;
    JointSchedule joints;
    AwakeIslands islands; ///< for sub-steps and groups
    IslandGroups groups;
    CornerMemory corners;
    Array<uint8> left;          ///< by awake body: true if a shape has left its box
    Array<b2Contact*> reported; ///< contacts with impulses to report to the listener, in order
};

} // namespace box2d
