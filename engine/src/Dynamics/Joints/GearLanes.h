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

    /// The bodies of one of the two joints.
    struct Ends
    {
        const int32* a;
        const int32* b;
        const float32* masses;
        uint32 movesA, movesB;

        MovingPair<F> Moving(const float32* bodies) const
        {
            return LoadMoving<F>(a, b, masses, bodies);
        }
        PlacedPair<F> Placed(const float32* bodies) const
        {
            return LoadPlaced<F>(a, b, masses, bodies);
        }
    };
    struct Lanes
    {
        Gears gears;
        Ends ends[2];

        /// One side after the other, because they may share a body.
        void Apply(F impulse, float32* bodies) const
        {
            for (int i = 0; i < 2; ++i)
            {
                const typename Gears::Side& side = gears.sides[i];
                const Ends& e = ends[i];
                MovingPair<F> pair = e.Moving(bodies);
                pair.ApplyAlong(side.axis, side.armFrame, side.armBody,
                                i == 0 ? impulse : gears.ratio * impulse);
                StoreMoving(pair, e.a, e.b, e.movesA, e.movesB, bodies);
            }
        }
        void Move(F impulse, float32* bodies) const
        {
            for (int i = 0; i < 2; ++i)
            {
                const typename Gears::Side& side = gears.sides[i];
                const Ends& e = ends[i];
                PlacedPair<F> pair = e.Placed(bodies);
                pair.MoveAlong(side.axis, side.armFrame, side.armBody,
                               i == 0 ? impulse : gears.ratio * impulse);
                StorePlaced(pair, e.a, e.b, e.movesA, e.movesB, bodies);
            }
        }
    };

    /// Calls the function for each F of lanes, with their numbers.
    template <class Function>
    static void ForLanes(const JointRun& run, Function&& function)
    {
        for (const JointBlock& block : run)
        {
            float32* numbers = run.NumbersOf(block);
            for (int lane = 0; lane < block.count; lane += F::kLanes)
            {
                float32* own = numbers + kFirst + lane;
                Lanes lanes = {LoadNumbers<Gears, F>(own),
                               {{block.bodyA + lane, block.bodyB + lane, numbers + lane,
                                 uint32(block.movesA) >> lane, uint32(block.movesB) >> lane},
                                {block.bodyC + lane, block.bodyD + lane, numbers + kSecond + lane,
                                 uint32(block.movesC) >> lane, uint32(block.movesD) >> lane}}};
                function(lanes, own);
            }
        }
    }
    static void WarmStart(const JointRun& run, float32* bodies)
    {
        ForLanes(run, [bodies](const Lanes& lanes, const float32*) {
            lanes.Apply(lanes.gears.impulse, bodies);
        });
    }
    static void SolveVelocities(const JointRun& run, float32* bodies)
    {
        ForLanes(run, [bodies](Lanes& lanes, float32* own) {
            Gears& gears = lanes.gears;
            const F speed = gears.sides[0].Speed(lanes.ends[0].Moving(bodies)) +
                            gears.ratio * gears.sides[1].Speed(lanes.ends[1].Moving(bodies));
            const F change = -gears.mass * speed;
            gears.impulse = gears.impulse + change;
            StoreNumbers<1, Gears, F>(own, gears);
            lanes.Apply(change, bodies);
        });
    }
    static bool SolvePositions(const JointRun& run, float32* bodies)
    {
        bool joined = true;
        ForLanes(run, [&joined, bodies](const Lanes& lanes, const float32*) {
            const Gears& gears = lanes.gears;
            const F error = gears.error +
                            gears.sides[0].Displacement(lanes.ends[0].Placed(bodies)) +
                            gears.ratio * gears.sides[1].Displacement(lanes.ends[1].Placed(bodies));
            lanes.Move(-gears.mass * error, bodies);
            joined = joined && !Any(Not(AtLeast(F::Set(b2_linearSlop), Abs(error))));
        });
        return joined;
    }
};

template <class F>
struct LanesOf<b2GearJoint, F> : std::type_identity<GearLanes<F>>
{};

} // namespace
} // namespace box2d
