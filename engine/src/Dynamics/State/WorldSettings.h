// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// The settings of b2World's setters that affect results. The solver gets a copy (SolverContext). A
/// new setting is a member here, named in Visit, and a pair of functions of b2World.
namespace box2d
{

/// Maximum of sub-steps per step: a bound of the cost. From 16 to 64 results hardly change: the
/// stones of a loaded arch sink as far (docs/notes/sub-steps-direct-solver.md).
inline constexpr int32 kMaxSubSteps = 64;

struct WorldSettings
{
    /// Part of a snapshot's version: 1 higher with every change of Visit, or of what a step does
    /// with a setting.
    static constexpr uint32 kFormat = 0;

    b2Vec2 gravity;                                      ///< [m/s^2]
    float32 restitutionThreshold = b2_velocityThreshold; ///< slower impacts do not bounce [m/s]
    int32 subStepCount = 1;                              ///< of a step, at most kMaxSubSteps
    bool allowSleep = true;
    bool warmStarting = true;
    bool continuousPhysics = true;
    bool subStepping = false;
    bool autoClearForces = true;
};

/// Saves and restores them, see Snapshot/Archive.h.
template <class Archive>
void Visit(Archive& archive, WorldSettings& settings)
{
    auto& [gravity, restitutionThreshold, subStepCount, allowSleep, warmStarting, continuousPhysics,
           subStepping, autoClearForces] = settings;
    archive(gravity, restitutionThreshold);
    archive.Require(b2IsValid(restitutionThreshold) && restitutionThreshold >= 0.0f);
    archive.Within(subStepCount, 1, kMaxSubSteps);
    archive(allowSleep, warmStarting, continuousPhysics, subStepping, autoClearForces);
}

} // namespace box2d
