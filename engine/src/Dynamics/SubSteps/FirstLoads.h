// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/ContactBlocks.h"

/// Estimates the loads of bodies that have just been stacked at rest. Iterations find the load of a
/// tall stack like a wave on a spring, which takes seconds. From the top down, each body passing on
/// its weight and load, one pass suffices.
namespace box2d
{

class World;
struct SolverMemory;

class FirstLoads
{
public:
    /// Finds the impulses in a kick of `duration` [s] of contacts that have been in no sub-step
    /// yet, between bodies at rest. Call it after the blocks have been prepared.
    void Find(const World& world, SolverMemory& arrays, float32 duration);

private:
    struct Point
    {
        float32* impulse;
        int32 upper, lower; ///< solver index; 0: static
        int32 order;
        double lift; ///< vertical part of a unit impulse on the upper body
        double upperMoment, lowerMoment;
    };
    struct Body
    {
        double lift = 0.0, moment = 0.0; ///< required
        int32 firstPoint = 0;            ///< of its contacts with the bodies below
    };

    void GatherPoints(const World& world, SolverMemory& arrays);
    void GatherPoint(const World& world, ContactBlock& block, int32 lane);
    void SortFromTheTop(const World& world);
    void PassOn(int32 body);

    Array<Point> m_points;
    Array<Body> m_bodies; // by solver index
    Array<int32> m_order; // bodies with another below them, highest first
};

} // namespace box2d
