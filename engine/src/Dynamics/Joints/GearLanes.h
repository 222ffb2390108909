// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2GearJoint;

/// The solver of b2GearJoint, whose source has the formulas. Its bodies are those of two joints,
/// the frame and the body of each; a body may be one of both.
namespace box2d
{
namespace
{

template <class F>
struct GearKernels;

template <class F>
struct GearLanes
{
    using Kernels = GearKernels<F>;
    static constexpr int kImpulses = 1;

    /// One of the two joints: how its coordinate follows from its frame (A) and its body (B).
    struct Side
    {
        Vector<F> axis; ///< zero for a hinge
        F armFrame, armBody;
        F slides;             ///< 1 for a slider, 0 for a hinge
        Vector<F> armA, armB; ///< of a slider's anchors at the start of the step [m]
        Vector<F> offset;     ///< from centre of mass A to B [m]
        F start;              ///< a slider's coordinate at the start of the step [m]

        F Speed(const MovingPair<F>& pair) const
        {
            return pair.SpeedAlong(axis, armFrame, armBody);
        }
        /// Returns the change of the coordinate in this step.
        F Displacement(const PlacedPair<F>& pair) const
        {
            const Vector<F> d = pair.Offset(offset) + pair.b.Turn(armB) - pair.a.Turn(armA);
            const F slid = Dot(d, pair.a.Turn(axis)) - start;
            return Select(IsSet(slides), slid, pair.b.angle - pair.a.angle);
        }
    };

    F impulse;
    PairMasses<F> second; ///< of the second joint's bodies
    F ratio, mass;
    F error; ///< at the start of the step
    Side sides[2];
};

template <class F>
struct GearKernels
{
    using Gears = GearLanes<F>;
    static constexpr int kWidth = F::kLanes == 1 ? 1 : kJointLanes;
    static constexpr int kFirst = kMassNumbers * kWidth;
    static constexpr int kSecond = kFirst + kWidth; ///< masses of the second joint's bodies

    static MovingPair<F> Moving(const JointBlock& block, int lane, int side, const float32* numbers,
                                const float32* bodies)
    {
        return side == 0
                   ? LoadMoving<F>(block.bodyA + lane, block.bodyB + lane, numbers + lane, bodies)
                   : LoadMoving<F>(block.bodyC + lane, block.bodyD + lane, numbers + kSecond + lane,
                                   bodies);
    }
    /// One side after the other, because they may share a body.
    static void Apply(const JointBlock& block, int lane, const Gears& gears, F impulse,
                      const float32* numbers, float32* bodies)
    {
        MovingPair<F> pair = Moving(block, lane, 0, numbers, bodies);
        ApplyTo(pair, gears.sides[0], impulse);
        StoreMoving(pair, block.bodyA + lane, block.bodyB + lane, uint32(block.movesA) >> lane,
                    uint32(block.movesB) >> lane, bodies);
        pair = Moving(block, lane, 1, numbers, bodies);
        ApplyTo(pair, gears.sides[1], gears.ratio * impulse);
        StoreMoving(pair, block.bodyC + lane, block.bodyD + lane, uint32(block.movesC) >> lane,
                    uint32(block.movesD) >> lane, bodies);
    }
    static void ApplyTo(MovingPair<F>& pair, const typename Gears::Side& side, F impulse)
    {
        pair.ApplyAlong(side.axis, side.armFrame, side.armBody, impulse);
    }

    static void WarmStart(const JointRun& run, float32* bodies)
    {
        for (const JointBlock& block : run)
        {
            WarmStart(block, run.NumbersOf(block), bodies);
        }
    }
    static void WarmStart(const JointBlock& block, float32* numbers, float32* bodies)
    {
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            const Gears gears = LoadNumbers<Gears, F>(numbers + kFirst + lane);
            Apply(block, lane, gears, gears.impulse, numbers, bodies);
        }
    }
    static void SolveVelocities(const JointRun& run, float32* bodies)
    {
        for (const JointBlock& block : run)
        {
            SolveVelocities(block, run.NumbersOf(block), bodies);
        }
    }
    static void SolveVelocities(const JointBlock& block, float32* numbers, float32* bodies)
    {
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            Gears gears = LoadNumbers<Gears, F>(numbers + kFirst + lane);
            const F speed =
                gears.sides[0].Speed(Moving(block, lane, 0, numbers, bodies)) +
                gears.ratio * gears.sides[1].Speed(Moving(block, lane, 1, numbers, bodies));
            const F change = -gears.mass * speed;
            gears.impulse = gears.impulse + change;
            StoreNumbers<1, Gears, F>(numbers + kFirst + lane, gears);
            Apply(block, lane, gears, change, numbers, bodies);
        }
    }

    static PlacedPair<F> Placed(const JointBlock& block, int lane, int side, const float32* numbers,
                                const float32* bodies)
    {
        return side == 0
                   ? LoadPlaced<F>(block.bodyA + lane, block.bodyB + lane, numbers + lane, bodies)
                   : LoadPlaced<F>(block.bodyC + lane, block.bodyD + lane, numbers + kSecond + lane,
                                   bodies);
    }
    static void Move(const JointBlock& block, int lane, const Gears& gears, F impulse,
                     const float32* numbers, float32* bodies)
    {
        PlacedPair<F> pair = Placed(block, lane, 0, numbers, bodies);
        MoveTo(pair, gears.sides[0], impulse);
        StorePlaced(pair, block.bodyA + lane, block.bodyB + lane, uint32(block.movesA) >> lane,
                    uint32(block.movesB) >> lane, bodies);
        pair = Placed(block, lane, 1, numbers, bodies);
        MoveTo(pair, gears.sides[1], gears.ratio * impulse);
        StorePlaced(pair, block.bodyC + lane, block.bodyD + lane, uint32(block.movesC) >> lane,
                    uint32(block.movesD) >> lane, bodies);
    }
    static void MoveTo(PlacedPair<F>& pair, const typename Gears::Side& side, F impulse)
    {
        pair.MoveAlong(side.axis, side.armFrame, side.armBody, impulse);
    }
    static bool SolvePositions(const JointRun& run, float32* bodies)
    {
        bool joined = true;
        for (const JointBlock& block : run)
        {
            joined = SolvePositions(block, run.NumbersOf(block), bodies) && joined;
        }
        return joined;
    }
    static bool SolvePositions(const JointBlock& block, float32* numbers, float32* bodies)
    {
        bool joined = true;
        for (int lane = 0; lane < block.count; lane += F::kLanes)
        {
            const Gears gears = LoadNumbers<Gears, F>(numbers + kFirst + lane);
            const F error =
                gears.error + gears.sides[0].Displacement(Placed(block, lane, 0, numbers, bodies)) +
                gears.ratio * gears.sides[1].Displacement(Placed(block, lane, 1, numbers, bodies));
            Move(block, lane, gears, -gears.mass * error, numbers, bodies);
            joined = joined && !Any(Not(AtLeast(F::Set(b2_linearSlop), Abs(error))));
        }
        return joined;
    }
};

template <class F>
struct LanesOf<b2GearJoint, F> : std::type_identity<GearLanes<F>>
{};

} // namespace
} // namespace box2d
