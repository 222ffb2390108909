// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/StepSolver.h"
#include "SubStepMemory.h"

namespace box2d
{

/// The stages of solving one step in sub-steps, in the order in which SolveInSubSteps calls
/// them.
class SubStepSolver : public StepSolver
{
public:
    SubStepSolver(World& world, float32 timeStep);

    void Begin(int32 count);
    /// True if any body moves sub-step by sub-step.
    bool AnyTogether() const;
    /// Applies a kick and solves the velocities.
    void Kick(float32 duration, float32 share, int32 iterations);
    void Drift(float32 timeStep);
    void MoveApart(float32 timeStep, int32 iterations, float32 rate);
    void CloseAfterPushes(int32 iterations)
    {
        m_subSteps.joints.CloseAfterPushes(m_context, iterations);
    }
    void StoreImpulses();
    void End();

private:
    /// Calls the function for ranges of awake bodies that move sub-step by sub-step.
    template <class Function>
    void ForTogether(Function&& function);
    bool AnyHeld() const;
    bool AreStillApart() const;
    void Bounce();
    bool Bounce(ContactBlocks& blocks, int32 index, int32 lane);
    bool Iterate(int32 iterations, float32 unchanged);
    void LimitPushes(float32 maximum);
    void HoldOverflow();
    void Fly(std::size_t index);

    SubStepMemory& m_subSteps;
    int32 m_kick = 0; ///< index of the next
    /// Smallest separation of the last measurement in this step [m]; 0 if nothing overlapped.
    float32 m_measured = -b2_maxFloat;
};

/// The step of a world with a sub-step count above 1.
void SolveInSubSteps(World& world, float32 timeStep, int32 velocityIterations,
                     int32 positionIterations);

} // namespace box2d
