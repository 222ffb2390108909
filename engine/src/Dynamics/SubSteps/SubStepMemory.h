// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/BodyKick.h"
#include "../State/Solver.h"
#include "ContactSystem.h"
#include "FirstLoads.h"
#include "JointSystem.h"
#include "WarmStartGuard.h"

namespace box2d
{

/// The motion of a body through a step with sub-steps.
enum class BodyMode : uint8
{
    Together, ///< sub-step by sub-step
    Flies,    ///< in one step: without joints and contacts
    InTree,   ///< with its HingeTree
};

/// Scratch memory of a step with sub-steps.
struct SubStepMemory
{
    JointSystem joints;
    ContactSystem contacts;
    FirstLoads firstLoads;
    WarmStartGuard warmStartGuard;
    Array<BodyMode> modes;          ///< by awake body
    Array<BodyKick> kicks;          ///< by awake body
    Array<SolverBody> beforePushes; ///< by solver index: see MoveApart
    Array<float32> farthestPushes;  ///< by number of AwakeIslands: maximum of its bodies [m]
};

} // namespace box2d
