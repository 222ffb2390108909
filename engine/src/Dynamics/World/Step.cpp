// SPDX-License-Identifier: MIT
#include "../Energy/EnergyGuard.h"
#include "../Solver/StepSolver.h"

#include "../State/ProfileScope.h"

#include <Box2D/Dynamics/b2Body.h>

/// One step of the world: update contacts, solve velocities, integrate, solve positions, continuous
/// collision, and sleep.
namespace box2d
{

namespace
{

/// Shorter steps do nothing, longer ones are clamped [s]: their squares and inverses would exceed
/// single precision.
constexpr float32 kShortestStep = 1e-9f;
constexpr float32 kLongestStep = 1e6f;

/// Keeps the threads polling during a step.
class ThreadsReady
{
public:
    explicit ThreadsReady(ThreadPool* threads) : m_threads(threads)
    {
        if (m_threads)
        {
            m_threads->Begin();
        }
    }
    ~ThreadsReady()
    {
        if (m_threads)
        {
            m_threads->End();
        }
    }
    ThreadsReady(const ThreadsReady&) = delete;
    ThreadsReady& operator=(const ThreadsReady&) = delete;

private:
    ThreadPool* m_threads;
};

} // namespace

void World::Step(float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (!B2_REQUIRE(!locked, "b2World::Step must not be called from inside a callback.") ||
        !B2_REQUIRE(b2IsValid(timeStep) && timeStep >= 0.0f,
                    "The time step must be finite and not negative."))
    {
        return;
    }
    (void)B2_REQUIRE(timeStep <= kLongestStep, "The time step must not exceed a million seconds.");
    (void)B2_REQUIRE(velocityIterations >= 0 && positionIterations >= 0,
                     "The numbers of iterations must not be negative.");
    timeStep = timeStep < kShortestStep ? 0.0f : b2Min(timeStep, kLongestStep);
    profile = b2Profile();
    ProfileScope step(profiling, profile.step);
    const Lock lock(*this);
    const ThreadsReady ready(threads.get());
    if (proxies.HasMoved())
    {
        ProfileScope broadphase(profiling, profile.broadphase);
        FindNewContacts();
    }
    {
        ProfileScope collide(profiling, profile.collide);
        UpdateContacts();
    }
    if (timeStep > 0.0f)
    {
        // Only impacts can remain of a step, so without continuous collision it is complete.
        stepComplete = stepComplete || !continuousPhysics;
        if (stepComplete)
        {
            ProfileScope solve(profiling, profile.solve);
            Solve(timeStep, velocityIterations, positionIterations);
        }
        if (continuousPhysics)
        {
            ProfileScope solveTOI(profiling, profile.solveTOI);
            SolveContinuous(timeStep, velocityIterations);
        }
        inverseStep = 1.0f / timeStep;
        ++stepNumber;
    }
    if (autoClearForces)
    {
        ClearForces();
    }
}

void World::Solve(float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (!awakeBodies.empty())
    {
        SolveAwake(timeStep, velocityIterations, positionIterations);
    }
    if (proxies.HasMoved())
    {
        ProfileScope broadphase(profiling, profile.broadphase);
        FindNewContacts();
    }
}

void World::SolveAwake(float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (subStepCount > 1)
    {
        SolveInSubSteps(timeStep, velocityIterations, positionIterations);
        return;
    }
    lastSubSteps = 1;
    StepSolver solve(*this, timeStep);
    {
        ProfileScope init(profiling, profile.solveInit);
        solve.WakeJointNeighbours();
        solve.IntegrateVelocities();
        energyGuard->Begin(*this, *solver, timeStep);
        solve.PrepareContacts();
        solve.WarmStart();
    }
    {
        ProfileScope velocity(profiling, profile.solveVelocity);
        solve.SolveVelocities(velocityIterations);
        solve.NoteImpulses();
    }
    {
        ProfileScope position(profiling, profile.solvePosition);
        solve.IntegratePositions();
        solve.SolvePositions(positionIterations);
    }
    energyGuard->Balance(*this, *solver);
    solve.WriteBack();
    solve.LetRest();
    solve.ReportImpulses(); // last, so that a listener may push, wake or stop bodies
}

void World::ClearForces()
{
    if (!forcesApplied)
    {
        return;
    }
    forcesApplied = false;
    for (b2Body* body : awakeBodies)
    {
        Data(*body).force.SetZero();
        Data(*body).torque = 0.0f;
    }
}

} // namespace box2d
