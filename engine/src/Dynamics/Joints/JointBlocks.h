// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>

#include <cstddef>
#include <cstring>
#include <iterator>

/// Joints of one kind that share no moving body, eight at a time or alone. What the solver reads of
/// them are numbers, one row of lanes after the other: first the inverse masses and inertias of A
/// and of B, then those of the kind's lanes (Joints/*Lanes.h). A kind is solved by one source at
/// every width, so the bits do not depend on how many are solved together.
namespace box2d
{

inline constexpr int kJointLanes = 8;
/// Numbers of a lane that belong to its bodies: their masses.
inline constexpr int kMassNumbers = 4;

struct JointKernels;

struct JointBlock
{
    b2JointType type;
    uint8 features = 0;           ///< of its lanes together; see JointLane::features
    uint8 movesA = 0, movesB = 0; ///< a bit for each lane whose body can be pushed or turned
    uint8 movesC = 0, movesD = 0; ///< of the second joint of a gear
    int32 width;                  ///< lanes, 1 or 8
    int32 count = 0;              ///< used; the others belong to bodies 0 without mass
    int32 bodyA[kJointLanes] = {}, bodyB[kJointLanes] = {}; ///< solver index
    int32 bodyC[kJointLanes] = {}, bodyD[kJointLanes] = {};
    std::size_t numbers;                   ///< the first of its numbers
    const JointKernels* kernels = nullptr; ///< of the step
    b2Joint* joint[kJointLanes] = {};
};

/// Blocks of one kind and width that are solved one after the other: calls and what they save are
/// paid once for all links of a chain.
struct JointRun
{
    const JointBlock* first;
    const JointBlock* last; ///< behind the end
    float32* numbers;       ///< of all blocks

    const JointBlock* begin() const { return first; }
    const JointBlock* end() const { return last; }
    float32* NumbersOf(const JointBlock& block) const { return numbers + block.numbers; }
};

/// A lane as its joint sees it: where the joint writes its numbers at the start of a step, and
/// finds its impulses at the end.
struct JointLane
{
    float32* first;     ///< of the kind's numbers
    int32 stride;       ///< from one number to the next
    uint8 features = 0; ///< what has to be solved: bits of the kind's own

    /// `Lanes` being those of the kind, with float32 for numbers; the first `count` of them.
    template <class Lanes>
    void Write(const Lanes& lanes, std::size_t count = sizeof(Lanes) / sizeof(float32))
    {
        const auto* bytes = reinterpret_cast<const std::byte*>(&lanes);
        if (stride == 1)
        {
            std::memcpy(first, bytes, count * sizeof(float32));
            return;
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            std::memcpy(first + i * std::size_t(kJointLanes), bytes + i * sizeof(float32),
                        sizeof(float32));
        }
    }
    float32 operator[](int32 number) const { return first[number * stride]; }
};

/// What is done to blocks of one kind and width.
struct JointKernels
{
    int32 numberCount;
    void (*warmStart)(const JointRun& run, float32* bodies);
    void (*solveVelocities)(const JointRun& run, float32* bodies);
    /// Whether all errors were below the tolerance.
    bool (*solvePositions)(const JointRun& run, float32* bodies);
};

/// For the widest instructions that this processor has; see UseWideInstructions.
const JointKernels& KernelsOf(const JointBlock& block);

} // namespace box2d
