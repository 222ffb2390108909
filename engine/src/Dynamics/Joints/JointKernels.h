// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

#include "DistanceLanes.h"
#include "FrictionLanes.h"
#include "GearLanes.h"
#include "JointKinds.h"
#include "MotorLanes.h"
#include "MouseLanes.h"
#include "PrismaticLanes.h"
#include "PulleyLanes.h"
#include "RevoluteLanes.h"
#include "RopeLanes.h"
#include "WeldLanes.h"
#include "WheelLanes.h"

/// The functions for blocks, for numbers F of 1, 4 or 8 lanes. One source per instruction set
/// includes it, so it has no external linkage.
namespace box2d
{
namespace
{

template <class Joints, class F>
struct PairKernels
{
    static constexpr int kWidth = F::kLanes == 1 ? 1 : kJointLanes;
    static constexpr int kFirst = kMassNumbers * kWidth; ///< first number of the type
    static constexpr bool kHasPlainForm = Joints::kPlainImpulses != Joints::kImpulses;

    /// Calls the function for each F of lanes, with their bodies' velocities and the joints'
    /// numbers.
    template <class Function>
    BOX2D_INLINE static void ForMoving(const JointBlock& block, float32* numbers, float32* bodies,
                                       Function&& function)
    {
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            const int32* a = block.bodyA + lane;
            const int32* b = block.bodyB + lane;
            MovingPair<F> pair = LoadMoving<F>(a, b, numbers + lane, bodies);
            function(pair, numbers + kFirst + lane);
            StoreMoving(pair, a, b, uint32(block.movesA) >> lane, uint32(block.movesB) >> lane,
                        bodies);
        }
    }
    static void WarmStart(const JointRun& run, float32* bodies)
    {
        for (const JointBlock& block : run)
        {
            ForMoving(block, run.NumbersOf(block), bodies,
                      [&](MovingPair<F>& pair, const float32* own) {
                          LoadNumbers<Joints, F>(own).WarmStart(pair, block.features);
                      });
        }
    }
    /// Writes `Impulses` numbers of each joint back.
    template <int Impulses>
    static void SolveVelocities(const JointBlock& block, float32* numbers, float32* bodies,
                                uint8 features)
    {
        ForMoving(block, numbers, bodies, [&](MovingPair<F>& pair, float32* own) {
            Joints joints = LoadNumbers<Joints, F>(own);
            joints.SolveVelocity(pair, features);
            StoreNumbers<Impulses, Joints, F>(own, joints);
        });
    }
    /// The features that velocities are solved with [all].
    static constexpr uint8 VelocityFeatures()
    {
        if constexpr (requires { Joints::kVelocityFeatures; })
        {
            return Joints::kVelocityFeatures;
        }
        return 0xFF;
    }
    /// Without features, the most common case, most numbers are not read.
    static void SolveVelocities(const JointRun& run, float32* bodies)
    {
        for (const JointBlock& block : run)
        {
            if ((block.features & VelocityFeatures()) == 0)
            {
                SolveVelocities<Joints::kPlainImpulses>(block, run.NumbersOf(block), bodies, 0);
            }
            else
            {
                SolveVelocities<Joints::kImpulses>(block, run.NumbersOf(block), bodies,
                                                   block.features);
            }
        }
    }
    static bool SolvePositions(const JointRun& run, float32* bodies)
    {
        bool joined = true;
        for (const JointBlock& block : run)
        {
            float32* numbers = run.NumbersOf(block);
            joined = (kHasPlainForm && block.features == 0
                          ? SolvePositions(block, numbers, bodies, 0)
                          : SolvePositions(block, numbers, bodies, block.features)) &&
                     joined;
        }
        return joined;
    }
    static void Turn(const JointRun& run, const JointRun& atStart, const float32* bodies,
                     const Kick& kick)
    {
        for (const JointBlock& block : run)
        {
            float32* numbers = run.NumbersOf(block);
            const float32* start = atStart.NumbersOf(block);
            if (block.features == 0)
            {
                Turn<Joints::TurnedNumbers()>(block, numbers, start, bodies, 0, kick);
            }
            else
            {
                Turn<int(sizeof(Joints) / sizeof(F))>(block, numbers, start, bodies, block.features,
                                                      kick);
            }
        }
    }
    /// Writes the first `Count` numbers of each joint back.
    template <int Count>
    BOX2D_INLINE static void Turn(const JointBlock& block, float32* numbers, const float32* start,
                                  const float32* bodies, uint8 features, const Kick& kick)
    {
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            const PlacedPair<F> pair =
                LoadPlaced<F>(block.bodyA + lane, block.bodyB + lane, start + lane, bodies);
            Joints joints = LoadNumbers<Joints, F>(numbers + kFirst + lane);
            joints.Turn(pair, LoadNumbers<Joints, F>(start + kFirst + lane), features, kick);
            StoreNumbers<Count, Joints, F>(numbers + kFirst + lane, joints);
        }
    }
    BOX2D_INLINE static bool SolvePositions(const JointBlock& block, float32* numbers,
                                            float32* bodies, uint8 features)
    {
        bool joined = true;
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            const int32* a = block.bodyA + lane;
            const int32* b = block.bodyB + lane;
            PlacedPair<F> pair = LoadPlaced<F>(a, b, numbers + lane, bodies);
            const Joints joints = LoadNumbers<Joints, F>(numbers + kFirst + lane);
            const auto held = joints.SolvePosition(pair, features);
            joined = !Any(And(pair.CanMove(), Not(held))) && joined;
            StorePlaced(pair, a, b, uint32(block.movesA) >> lane, uint32(block.movesB) >> lane,
                        bodies);
        }
        return joined;
    }
};

/// For types without position constraints: friction and motor joints.
inline bool HoldsNoPositions(const JointRun&, float32*)
{
    return true;
}

/// The lanes' own kernels, or those of pairs.
template <class Lanes, class F>
constexpr JointKernels MakeKernels()
{
    constexpr auto numbers = int32(kMassNumbers + sizeof(Lanes) / sizeof(F));
    if constexpr (requires { typename Lanes::Kernels; })
    {
        using Kernels = typename Lanes::Kernels;
        return {numbers,
                Lanes::kImpulses,
                Kernels::WarmStart,
                Kernels::SolveVelocities,
                Kernels::SolvePositions,
                nullptr};
    }
    else
    {
        using Kernels = PairKernels<Lanes, F>;
        JointKernels kernels = {
            numbers,          Lanes::kImpulses, Kernels::WarmStart, Kernels::SolveVelocities,
            HoldsNoPositions, nullptr};
        if constexpr (requires(Lanes lanes, PlacedPair<F> pair, Kick kick) {
                          lanes.Turn(pair, lanes, uint8(0), kick);
                      })
        {
            kernels.turn = Kernels::Turn;
        }
        if constexpr (requires(const Lanes lanes, PlacedPair<F> pair) {
                          lanes.SolvePosition(pair, uint8(0));
                      })
        {
            kernels.solvePositions = Kernels::SolvePositions;
        }
        return kernels;
    }
}

template <class Joint, class F>
constexpr JointKernels kKernels = MakeKernels<typename LanesOf<Joint, F>::type, F>();

template <class F>
const JointKernels& KernelsOf(b2JointType type)
{
    return *WithType(type, []<class Joint>(JointTag<Joint>) { return &kKernels<Joint, F>; });
}

} // namespace
} // namespace box2d
