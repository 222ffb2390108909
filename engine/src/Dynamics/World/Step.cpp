// SPDX-License-Identifier: MIT
#include "Step.h"

#include "../Contacts/Contacts.h"
#include "../Continuous/Continuous.h"
#include "../Energy/EnergyGuard.h"
#include "../Solver/StepSolver.h"
#include "../State/ProfileScope.h"
#include "../SubSteps/SubStepSolver.h"

#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

namespace
{

/// Shorter steps do nothing, longer ones are clamped [s]. Within these bounds the largest products
/// are within single precision, which ends at 3e38. The square of the longest path at kFastest is
/// 1e32. The largest mass (Bodies.cpp) times the square of the largest inverse step is 1e38.
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

void SolveGroup(StepSolver& group, b2Profile& profile, int32 velocityIterations,
                int32 positionIterations)
{
    {
        ProfileScope init(group.IsProfiling(), profile.solveInit);
        group.PrepareContacts();
        group.WarmStart();
    }
    {
        ProfileScope velocity(group.IsProfiling(), profile.solveVelocity);
        group.SolveVelocities(velocityIterations);
        group.StoreImpulses();
    }
    ProfileScope position(group.IsProfiling(), profile.solvePosition);
    group.IntegratePositions();
    group.SolvePositions(positionIterations);
}

void SolveAwake(World& world, float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (world.settings.subStepCount > 1)
    {
        SolveInSubSteps(world, timeStep, velocityIterations, positionIterations);
        return;
    }
    world.lastSubSteps = 1;
    StepSolver solve(world, timeStep);
    {
        ProfileScope init(world.profiling, world.profile.solveInit);
        solve.SortBodies();
        solve.WakeJointNeighbours();
        solve.IntegrateVelocities();
        world.energyGuard->Begin(world, *world.solver, timeStep);
        solve.AssignContacts();
        world.solver->joints.Update(world.graph);
        solve.BounceInCorners();
    }
    if (solve.IsFree())
    {
        ProfileScope position(world.profiling, world.profile.solvePosition);
        solve.IntegratePositions();
    }
    else
    {
        ForGroups(solve, [&](StepSolver& group) {
            SolveGroup(group, world.profile, velocityIterations, positionIterations);
        });
    }
    world.directionReversed = !world.directionReversed;
    solve.NoteImpulses();
    world.energyGuard->Balance(world, *world.solver);
    solve.WriteBack();
    solve.LetRest();
    solve.ReportImpulses(); // last, so that a listener may push, wake or stop bodies
}

void Solve(World& world, float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (!world.awakeBodies.empty())
    {
        SolveAwake(world, timeStep, velocityIterations, positionIterations);
    }
    if (world.proxies.HasMoved())
    {
        ProfileScope broadphase(world.profiling, world.profile.broadphase);
        FindNewContacts(world);
    }
}

} // namespace

void Step(World& world, float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    if (!B2_REQUIRE(!world.locked, "b2World::Step must not be called from inside a callback.") ||
        !B2_REQUIRE(b2IsValid(timeStep) && timeStep >= 0.0f,
                    "The time step must be finite and not negative."))
    {
        return;
    }
    (void)B2_REQUIRE(timeStep <= kLongestStep, "The time step must not exceed a million seconds.");
    (void)B2_REQUIRE(velocityIterations >= 0 && positionIterations >= 0,
                     "The numbers of iterations must not be negative.");
    timeStep = timeStep < kShortestStep ? 0.0f : b2Min(timeStep, kLongestStep);
    world.profile = b2Profile();
    ProfileScope step(world.profiling, world.profile.step);
    const Lock lock(world);
    const ThreadsReady ready(world.threads.get());
    if (world.proxies.HasMoved())
    {
        ProfileScope broadphase(world.profiling, world.profile.broadphase);
        FindNewContacts(world);
    }
    {
        ProfileScope collide(world.profiling, world.profile.collide);
        UpdateContacts(world);
    }
    if (timeStep > 0.0f)
    {
        // Only impacts can be left of a step, so without continuous collision nothing is.
        world.stepComplete = world.stepComplete || !world.settings.continuousPhysics;
        if (world.stepComplete)
        {
            ProfileScope solve(world.profiling, world.profile.solve);
            Solve(world, timeStep, velocityIterations, positionIterations);
        }
        if (world.settings.continuousPhysics)
        {
            ProfileScope solveTOI(world.profiling, world.profile.solveTOI);
            SolveContinuous(world, timeStep, velocityIterations);
        }
        world.inverseStep = 1.0f / timeStep;
        ++world.stepNumber;
    }
    if (world.settings.autoClearForces)
    {
        ClearForces(world);
    }
}

void ClearForces(World& world)
{
    if (!world.forcesApplied)
    {
        return;
    }
    world.forcesApplied = false;
    for (b2Body* body : world.awakeBodies)
    {
        Data(*body).force.SetZero();
        Data(*body).torque = 0.0f;
    }
}

} // namespace box2d
