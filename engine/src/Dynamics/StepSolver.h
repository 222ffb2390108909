// SPDX-License-Identifier: MIT
#pragma once

#include "SolverArrays.h"
#include "World.h"

namespace box2d
{

/// The stages of solving one step, in the order in which World::SolveAwake calls them, over arrays
/// that the world lends.
class StepSolver
{
public:
    StepSolver(World& world, float32 timeStep);

    void WakeJointNeighbours();
    void IntegrateVelocities();
    void PrepareConstraints();
    void SolveVelocities(int32 iterations);
    void NoteImpulses();
    void ReportImpulses();
    void IntegratePositions();
    void SolvePositions(int32 iterations);
    void WriteBack();
    void LetRest();

private:
    void AssignBlocks(int32 color);
    template <class Function>
    void ForColors(Direction direction, Function&& some);
    template <class Function>
    void ForBlocks(Function&& function);
    template <class Function>
    void ForBodies(Function&& function);
    SolverBody WithForces(const BodyData& body) const;
    bool WriteBack(BodyData& body, SolverBody& moved) const;
    bool SolveContacts(Direction direction);
    float32 SolveOverlaps(Direction direction);
    float32 SleepTimeAfter(const BodyData& body, const SolverBody& moved) const;

    World& m_world;
    SolverArrays& m_arrays;
    ThreadPool* m_threads; // may be null
    SolverContext m_context;
};

} // namespace box2d
