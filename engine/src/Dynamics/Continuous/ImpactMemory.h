// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/ContactBlocks.h"
#include "../State/BodyPose.h"
#include "../State/Solver.h"

#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

/// A future impact.
struct ImpactEvent
{
    float32 time; // fraction of the step
    int32 order;  // order of discovery, to break ties
    b2Contact* contact;
    uint32 versionA, versionB; // of the paths it was computed from
};

/// True if an impact has stopped a body. The entry names its body, because a listener that puts one
/// to sleep changes the awake indices.
struct ImpactFate
{
    const BodyData* body;
    bool isStopped;
};

/// The pose of a body before all impacts; the index may change as above.
struct ImpactStart
{
    const BodyData* body;
    Pose pose;
    int32 lastTurn = -1; ///< last turn of its path; -1 if it is straight
};

/// A point where an impact changed a body's path.
struct ImpactTurn
{
    Pose pose;
    float32 time; ///< fraction of the step
    int32 before; ///< the same body's previous turn, or -1
};

/// The state of a body before an impact.
struct ImpactBackup
{
    b2Body* body;
    Pose pose, previous;
    float32 sweepStart;
    b2Vec2 v;
    float32 w;
    b2Rot rotation; // and values derived from the pose
    b2Transform transform;
    b2Vec2 worldCenter;
};

/// Scratch memory of the search for impacts, and of one impact.
struct ImpactMemory
{
    Array<float32> times;           ///< by awake contact; 1 without an impact
    Array<ImpactEvent> events;      ///< a heap, earliest first
    Array<ImpactFate> fates;        ///< by awake body, with sub-steps: see ImpactJoints
    Array<ImpactStart> starts;      ///< by awake body: before all impacts
    Array<ImpactTurn> turns;        ///< of all bodies, by time
    Array<b2Body*> bodies;          ///< of one impact
    Array<const BodyData*> falling; ///< some of them: see Impact::Falling
    Array<ImpactBackup> before;     ///< backup of these bodies
    std::size_t firstJoined = 0;    ///< the first of these bodies that only joints connect
    Array<b2Contact*> contacts;     ///< of one impact
    Array<ContactBlock> impulses;   ///< one for each contact, and more of earlier impacts
    Array<OverlapBlock> overlaps;   ///< one for each block above
    Array<float32> restitutions;    ///< one for each contact, with sub-steps
    Array<BlockTotals> totals;      ///< of bounces, if joints took part
    Array<float32> depths;
    Array<SolverBody> bounced;
    Array<ContactBlock> bouncedImpulses;
};

} // namespace box2d
