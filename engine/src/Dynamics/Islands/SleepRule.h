// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

/// Decides if a body rests. StepSolver calls it for each awake body at the end of a step. A body
/// rests while its sleep time grows. An island whose bodies have all rested for b2_timeToSleep
/// falls asleep (State/Islands.h). Two rules are elsewhere: KeepDrivenAwake (Joints/JointKinds.h)
/// for bodies that a motor moves, and WakeNeighbours (Sleep.h) for bodies that touch a moving body.
namespace box2d
{

/// The inputs of the rule in a step, other than the body.
struct SleepStep
{
    float32 timeStep; ///< [s]
    bool inSubSteps;  ///< true if the world's sub-step count is above 1
};

/// True if both velocities [m/s], [rad/s] are within the sleep tolerances.
bool IsSlow(const b2Vec2& linearVelocity, float32 angularVelocity);

/// Returns the sleep time of a body after a step that moved it to `moved` [s]; 0 if it does not
/// rest.
float32 SleepTimeAfter(const BodyData& body, const SolverBody& moved, const SleepStep& step);

} // namespace box2d
