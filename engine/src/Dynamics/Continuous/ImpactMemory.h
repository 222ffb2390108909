// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/ContactBlocks.h"
#include "../State/BodyPose.h"
#include "../State/Solver.h"

#include <Box2D/Dynamics/b2Body.h>

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

/// The memory of the search for impacts, and of one impact.
struct ImpactMemory
{
    Array<float32> times;              ///< by awake contact
    Array<ImpactEvent> events;         ///< a heap, the earliest first
    Array<ImpactFate> fates;           ///< by awake body, of sub-steps: see ImpactJoints
    Array<ImpactStart> starts;         ///< by awake body: before all impacts
    Array<ImpactTurn> turns;           ///< of all bodies, by time
    Array<b2Body*> bodies;             ///< of one impact
    Array<ImpactBackup> before;        ///< the same bodies as they were
    Array<b2Contact*> contacts;        ///< of one impact
    Array<ContactConstraint> impulses; ///< of one impact
    Array<OverlapConstraint> overlaps;
    Array<float32> depths;
    Array<SolverBody> bounced;
    Array<ContactConstraint> bouncedImpulses;
};

} // namespace box2d
