// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>

#include <cstddef>
#include <cstring>
#include <iterator>

/// Joints of one kind without common dynamic bodies, solved eight at a time or alone. The solver
/// reads rows of lanes. The first rows are the inverse masses and inertias of A and of B, the
/// others those of the kind's lanes (Joints/*Lanes.h). One source solves a kind at every width, so
/// the bits do not depend on the number solved together.
namespace box2d
{

/// Lanes of a block: the floats of an AVX2 register. Sixteen, for AVX-512, were measured for
/// contacts only (docs/notes/solver-lanes.md).
inline constexpr int kJointLanes = 8;
/// Number of rows for the bodies' masses.
inline constexpr int kMassNumbers = 4;

struct JointKernels;

struct JointBlock
{
    b2JointType type;
    uint8 features = 0;           ///< union of its lanes; see JointLane::features
    uint8 movesA = 0, movesB = 0; ///< bit mask of lanes whose body can move or rotate
    uint8 movesC = 0, movesD = 0; ///< for the second joint of a gear
    int32 width;                  ///< number of lanes, 1 or 8
    int32 count = 0;              ///< used lanes; the others have bodies 0 without mass
    int32 bodyA[kJointLanes] = {}, bodyB[kJointLanes] = {}; ///< solver index
    int32 bodyC[kJointLanes] = {}, bodyD[kJointLanes] = {};
    std::size_t numbers;                   ///< index of the first of its numbers
    std::size_t sums;                      ///< index of the first of the sums of its impulses
    const JointKernels* kernels = nullptr; ///< of the step
    b2Joint* joint[kJointLanes] = {};
};

/// Consecutive blocks of one type and width: the cost of a call is shared by all links of a chain.
struct JointRun
{
    const JointBlock* first;
    const JointBlock* last; ///< behind the end
    float32* numbers;       ///< of all blocks

    const JointBlock* begin() const { return first; }
    const JointBlock* end() const { return last; }
    float32* NumbersOf(const JointBlock& block) const { return numbers + block.numbers; }
};

/// A lane from the view of its joint, which writes its numbers at the start of a step and reads its
/// impulses at the end.
struct JointLane
{
    float32* first;     ///< numbers of the type
    int32 stride;       ///< distance of two numbers
    uint8 features = 0; ///< bits of the type: parts to solve

    /// Writes the first `count` numbers of `Lanes`, the type's lanes with float32 as number.
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

/// A velocity update in a step with sub-steps.
struct Kick
{
    float32 share;        ///< duration over that of a sub-step
    float32 inverseDrift; ///< [1/s], one over the duration of the next drift
};

/// The functions for blocks of one type and width.
struct JointKernels
{
    int32 numberCount;
    int32 impulseCount; ///< the first numbers behind the masses
    void (*warmStart)(const JointRun& run, float32* bodies);
    void (*solveVelocities)(const JointRun& run, float32* bodies);
    /// Returns true if all errors are below the tolerance.
    bool (*solvePositions)(const JointRun& run, float32* bodies);
    /// In sub-steps: computes what velocities are solved with from `atStart`, the numbers at the
    /// start of the step, at the present poses. Null: the joints fill their lanes again.
    void (*turn)(const JointRun& run, const JointRun& atStart, const float32* bodies,
                 const Kick& kick);
};

/// Returns the functions for the widest instructions of this processor; see UseLanes.
const JointKernels& KernelsOf(const JointBlock& block);

} // namespace box2d
