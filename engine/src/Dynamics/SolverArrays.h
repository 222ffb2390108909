// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlocks.h"
#include "Solver.h"

/// The memory that a step works in. It belongs to the world and is used again in every step.
namespace box2d
{

struct SolverArrays
{
    Array<SolverBody> bodies;
    ContactBlocks contacts;          ///< of the step
    Array<b2Contact*> reported;      ///< whose impulses the listener wants to know, in order
    Array<ContactConstraint> impact; ///< of one impact
    Array<OverlapConstraint> impactOverlaps;
};

} // namespace box2d
