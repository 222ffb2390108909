// SPDX-License-Identifier: MIT
#pragma once

#include "AwakeIslands.h"
#include "BodyKick.h"
#include "CarryGuard.h"
#include "ConstraintGraph.h"
#include "ContactBlocks.h"
#include "ContactSystem.h"
#include "EnergyGuard.h"
#include "FirstLoads.h"
#include "JointSchedule.h"
#include "JointSystem.h"
#include "Solver.h"

/// The memory that a step works in. It belongs to the world and is used again in every step.
namespace box2d
{

/// An impact that is to come.
struct ImpactEvent
{
    float32 time; // fraction of the step
    int32 order;  // of discovery, to decide between equal times
    b2Contact* contact;
    uint32 versionA, versionB; // of the ways it was computed from
};

/// Whether an impact has stopped a body. Its place among the awake is another's once a listener has
/// put one to sleep, so it says whose it is.
struct ImpactFate
{
    const BodyData* body;
    bool isStopped;
};

/// Where a body was before all impacts; the same holds of its place.
struct ImpactStart
{
    const BodyData* body;
    Pose pose;
    int32 lastTurn = -1; ///< of its way, among all; -1 when it goes straight on
};

/// Where an impact has turned a body's way.
struct ImpactTurn
{
    Pose pose;
    float32 time; ///< as a fraction of the step
    int32 before; ///< the same body's turn before this, or -1
};

/// A body as it was before an impact.
struct ImpactBackup
{
    b2Body* body;
    Pose pose, previous;
    float32 sweepStart;
    b2Vec2 v;
    float32 w;
    b2Rot rotation; // and what else is made of the pose
    b2Transform transform;
    b2Vec2 worldCenter;
};

/// How a body gets through a step of small ones.
enum class WayOfBody : uint8
{
    Together, ///< small step by small step, with all others
    Flies,    ///< at once: nothing holds or touches it
    InTree,   ///< with its HingeTree
};

struct SolverArrays
{
    Array<SolverBody> bodies;
    ContactBlocks contacts[ConstraintGraph::kColorCount]; ///< of the step, by colour
    int32 colors[ConstraintGraph::kColorCount]; ///< that have contacts, in the order of solving
    int32 colorCount = 0;
    JointSchedule joints;
    AwakeIslands islands;             ///< of small steps
    JointSystem jointSystem;          ///< of small steps
    ContactSystem contactSystem;      ///< of small steps
    FirstLoads firstLoads;            ///< of small steps
    CarryGuard carryGuard;            ///< of small steps
    EnergyGuard energyGuard;          ///< of what has joints
    Array<uint8> left;                ///< by awake body: whether a shape has left its box
    Array<WayOfBody> ways;            ///< by awake body, of small steps
    Array<BodyKick> kicks;            ///< by awake body, of small steps
    Array<SolverBody> beforePushes;   ///< by solver index, of small steps: see MoveApart
    Array<float32> farthestPushes;    ///< by number of AwakeIslands: of any of its bodies [m]
    Array<uint8> deep;                ///< by solver index, of small steps: see FindDeep
    Array<b2Contact*> reported;       ///< whose impulses the listener wants to know, in order
    Array<float32> impactTimes;       ///< by awake contact
    Array<ImpactEvent> impactEvents;  ///< a heap, the earliest first
    Array<b2Body*> impactBodies;      ///< of one impact
    Array<ImpactBackup> impactBefore; ///< the same bodies as they were
    Array<b2Contact*> impactContacts; ///< of one impact
    Array<ImpactFate> impactFates;    ///< by awake body, of small steps: see ImpactJoints
    Array<ImpactStart> impactStarts;  ///< by awake body: before all impacts
    Array<ImpactTurn> impactTurns;    ///< of all bodies, by time
    Array<ContactConstraint> impact;  ///< of one impact
    Array<OverlapConstraint> impactOverlaps;
    Array<float32> impactDepths;
    Array<SolverBody> impactBounced;
    Array<ContactConstraint> impactBouncedImpulses;
};

} // namespace box2d
