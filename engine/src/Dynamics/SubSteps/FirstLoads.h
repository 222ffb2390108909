// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/ContactBlocks.h"

/// What bodies that have just been put on each other at rest will have to bear. Sweeps find the
/// load of a tall pile as a wave does that runs up and down a spring, for seconds; but from the top
/// down, each body passing on its own weight and what lies on it, it is found in one pass.
namespace box2d
{

class World;
struct SolverMemory;

class FirstLoads
{
public:
    /// Of contacts that have been in no sub-step yet, between bodies at rest: their impulses in a
    /// kick of `duration` [s]. After the blocks have been prepared.
    void Find(const World& world, SolverMemory& arrays, float32 duration);

private:
    struct Point
    {
        float32* impulse;
        int32 upper, lower; ///< solver index; 0: bears anything
        int32 order;
        double lift; ///< of the upper body, by an impulse of one
        double upperMoment, lowerMoment;
    };
    struct Body
    {
        double lift = 0.0, moment = 0.0; ///< that it needs
        int32 firstPoint = 0;            ///< of those that it lies on
    };

    void GatherPoints(const World& world, SolverMemory& arrays);
    void GatherPoint(const World& world, ContactBlock& block, int32 lane);
    void SortFromTheTop(const World& world);
    void PassOn(int32 body);

    Array<Point> m_points;
    Array<Body> m_bodies; // by solver index
    Array<int32> m_order; // bodies that lie on something, the highest first
};

} // namespace box2d
