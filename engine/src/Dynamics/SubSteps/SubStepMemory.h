// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/BodyKick.h"
#include "../State/Solver.h"
#include "ContactSystem.h"
#include "FirstLoads.h"
#include "JointSystem.h"
#include "JointedBounce.h"
#include "WarmStartGuard.h"

namespace box2d
{

/// The motion of a body through a step with sub-steps.
enum class BodyMode : uint8
{
    Together, ///< sub-step by sub-step
    OnJoints, ///< likewise; it may fall freely with its joints: no contacts, no damping
    Flies,    ///< in one step: without joints, contacts and damping
    InTree,   ///< with its HingeTree
};

inline bool IsTogether(BodyMode mode)
{
    return mode == BodyMode::Together || mode == BodyMode::OnJoints;
}

/// Scratch memory of a step with sub-steps.
struct SubStepMemory
{
    JointSystem joints;
    ContactSystem contacts;
    FirstLoads firstLoads;
    WarmStartGuard warmStartGuard;
    JointedBounce jointedBounce;
    Array<BodyMode> modes;          ///< by awake body
    Array<BodyKick> kicks;          ///< by awake body
    Array<SolverBody> beforePushes; ///< by solver index: see MoveApart
    Array<float32> farthestPushes;  ///< by number of AwakeIslands: maximum of its bodies [m]
};

} // namespace box2d
