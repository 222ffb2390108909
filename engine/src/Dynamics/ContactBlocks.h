// SPDX-License-Identifier: MIT
#pragma once

#include "Solver.h"

/// Contacts of one colour, eight at a time: the velocity solver's form of ContactConstraint, so
/// that one instruction serves several contacts. A block is solved by 8, by twice 4 or by 8 times
/// one lane with the same bits, and so is the plain solver of ContactSolver.cpp, which stays as the
/// reference.
namespace box2d
{

/// Puts constraints from `begin` to `end`, all of one colour, into blocks at the end of the list;
/// each alone in a block when they may share bodies.
void PackBlocks(const Array<ContactConstraint>& constraints, std::size_t begin, std::size_t end,
                bool mayShareBodies, Array<ContactBlock>& blocks);
/// Puts the impulses back into the constraints.
void UnpackImpulses(const Array<ContactBlock>& blocks, Array<ContactConstraint>& constraints);

/// The same for overlaps, which must stay where they are as long as the blocks are used.
void PackBlocks(const Array<OverlapConstraint>& overlaps, std::size_t begin, std::size_t end,
                bool mayShareBodies, Array<OverlapBlock>& blocks);
/// The wide version of SolveOverlaps.
float32 SolveBlocks(const Array<OverlapBlock>& blocks, SolverBody* bodies, float32 rate,
                    Direction direction);

/// The wide versions of WarmStart and SolveContactVelocities, for the widest instructions that this
/// processor has.
void WarmStartBlocks(Array<ContactBlock>& blocks, SolverBody* bodies);
/// False when no impulse changed: then no other sweep over the same contacts would change one.
bool SolveBlocks(Array<ContactBlock>& blocks, SolverBody* bodies, Direction direction);

/// The same for a width by name, for tests: 4, or 8 where the processor has AVX2.
bool HasWideInstructions();
void UseWideInstructions(bool use);

} // namespace box2d
