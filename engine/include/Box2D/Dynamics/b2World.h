// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/b2ContactManager.h>
#include <Box2D/Dynamics/b2TimeStep.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <memory>

/// @file
/// The world: container and entry point of the simulation.

struct b2AABB;
struct b2BodyDef;
struct b2JointDef;
class b2Body;
class b2Contact;
class b2Draw;
class b2Joint;

namespace box2d
{
class World;
struct SnapshotAccess;
} // namespace box2d

/// Owns bodies, joints and contacts, steps them and answers queries. Only one thread at a time may
/// call it, independent of GetThreadCount. Functions that must not be called while it is locked
/// (IsLocked) say so.
class b2World
{
public:
    /// Creates an empty world. Gravity [m/s^2] is finite; otherwise it asserts and is 0. `doSleep`:
    /// true if bodies may fall asleep.
    explicit b2World(const b2Vec2& gravity, bool doSleep = true);
    ~b2World();
    b2World(const b2World&) = delete;
    b2World& operator=(const b2World&) = delete;

    /// Sets the listener for objects destroyed with a body; nullptr removes it. A listener must
    /// outlive the world or be removed.
    void SetDestructionListener(b2DestructionListener* listener);
    /// Same as SetDestructionListener.
    void SetListener(b2DestructionListener* listener) { SetDestructionListener(listener); }
    /// Sets the filter that decides which fixtures collide; nullptr restores the default of
    /// b2ContactFilter.
    void SetContactFilter(b2ContactFilter* filter);
    /// Sets the listener for contacts; nullptr removes it.
    void SetContactListener(b2ContactListener* listener);
    /// Sets the implementation that DrawDebugData calls; nullptr removes it.
    void SetDebugDraw(b2Draw* debugDraw);

    /// Creates a body from a definition, which is copied. While the world is locked, or without a
    /// definition, it asserts and returns nullptr. An invalid value, such as a velocity that is not
    /// finite, becomes the default of b2BodyDef.
    b2Body* CreateBody(const b2BodyDef* def);
    /// Destroys a body with its fixtures, joints and contacts. While the world is locked, or if the
    /// body is not of this world, it asserts and changes nothing.
    void DestroyBody(b2Body* body);
    /// Creates a joint from a definition, which is copied. Asserts and returns nullptr in these
    /// cases:
    /// - the world is locked,
    /// - there is no definition,
    /// - the type is invalid,
    /// - the bodies are not two different bodies of this world,
    /// - a number is not finite or out of range,
    /// - the joints of a gear are not revolute or prismatic, or do not move two different bodies of
    /// this world.
    b2Joint* CreateJoint(const b2JointDef* def);
    /// Destroys a joint and wakes its bodies. While the world is locked, or if the joint is not of
    /// this world, it asserts and changes nothing.
    void DestroyJoint(b2Joint* joint);

    /// Advances the simulation. `timeStep` is 0 to a million seconds and should be constant.
    /// Iteration counts are >= 0; 8 and 3 are typical. While the world is locked, or for a negative
    /// or non-finite step, it asserts and does nothing. A longer step is clamped.
    void Step(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    /// Clears all forces and torques; only needed when automatic clearing is off.
    void ClearForces();
    /// Calls the registered b2Draw for the layers in its flags.
    void DrawDebugData();
    void DebugDraw() { DrawDebugData(); } ///< as DrawDebugData, by the name of 2.4

    /// Reports every fixture whose broad-phase box overlaps `aabb` [m], in no particular order. The
    /// bounds must be finite and sorted; otherwise the result is undefined. A null callback asserts
    /// and does nothing.
    void QueryAABB(b2QueryCallback* callback, const b2AABB& aabb) const;
    /// Same as QueryAABB.
    void Query(b2QueryCallback* callback, const b2AABB& aabb) const { QueryAABB(callback, aabb); }
    /// Reports every fixture that the ray from point1 to point2 [m] hits, in no particular order.
    /// Both points are finite. A null callback asserts and does nothing.
    void RayCast(b2RayCastCallback* callback, const b2Vec2& point1, const b2Vec2& point2) const;

    /// Returns the newest body; b2Body::GetNext iterates over the others. nullptr if there is none.
    b2Body* GetBodyList();
    const b2Body* GetBodyList() const;   ///< the newest body, read-only
    b2Joint* GetJointList();             ///< the newest joint; b2Joint::GetNext iterates over the
                                         ///< others
    const b2Joint* GetJointList() const; ///< the newest joint, read-only
    b2Contact* GetContactList();         ///< the newest contact; b2Contact::GetNext iterates over
                                         ///< the others
    const b2Contact* GetContactList() const; ///< the newest contact, read-only
    /// Returns the active, awake kinematic and dynamic bodies, GetAwakeBodyCount() of them, in no
    /// particular order. Valid until the world is changed or stepped. An addition to the manual's
    /// interface.
    const b2Body* const* GetAwakeBodies() const;
    int32 GetAwakeBodyCount() const; ///< size of GetAwakeBodies
    /// Returns the number of inactive bodies, which are in no tree and not awake. An addition to
    /// the manual's interface.
    int32 GetInactiveBodyCount() const;

    void SetAllowSleeping(bool flag); ///< allows or forbids sleep; forbidding wakes all bodies
    bool GetAllowSleeping() const;    ///< true if bodies may fall asleep
    /// Enables or disables warm starting: the impulses of the last step initialize the next.
    void SetWarmStarting(bool flag);
    bool GetWarmStarting() const; ///< true if warm starting is enabled
    /// Enables or disables continuous collision.
    void SetContinuousPhysics(bool flag);
    bool GetContinuousPhysics() const; ///< true if continuous collision is enabled
    /// Enables or disables single stepping of continuous collision: each step ends at its first
    /// time of impact.
    void SetSubStepping(bool flag);
    bool GetSubStepping() const; ///< true if a step ends at its first time of impact

    /// Sets the number of sub-steps per step, 1 to 64, default 1. 1 selects the scheme of the
    /// manual.
    /// With more, contacts are found once per step, and the bodies move in sub-steps of a
    /// second-order scheme. Free flight is exact; joints are solved exactly and conserve energy.
    /// Shapes that are put into each other's skins stay there for as long as they touch. On a
    /// ground they stay so for as long as they are well within one of its shapes. The iterations
    /// given to Step are divided among the sub-steps, see b2IterationsOfASubStep. Gaps that joints
    /// under load have with one sub-step close at once when the number is raised. A number out of
    /// range asserts and is clamped; while the world is locked nothing changes.
    void SetSubStepCount(int32 count);
    int32 GetSubStepCount() const; ///< 1 to 64

    /// Sets the number of threads of a step, including the calling one, 1 to 64, default 1. Results
    /// are bit-identical for every number. Callbacks come from the calling thread, in the same
    /// order.
    /// During a step, including callbacks, the other threads busy-wait. For small worlds, or with
    /// more threads than processors, more threads are slower. A number out of range asserts and is
    /// clamped; while the world is locked nothing changes.
    void SetThreadCount(int32 count);
    int32 GetThreadCount() const; ///< 1 to 64

    int32 GetProxyCount() const;    ///< number of boxes in the broad phase
    int32 GetBodyCount() const;     ///< number of bodies
    int32 GetJointCount() const;    ///< number of joints
    int32 GetContactCount() const;  ///< number of contacts, touching or not
    int32 GetTreeHeight() const;    ///< of the broad phase's highest tree, 0 or more
    int32 GetTreeBalance() const;   ///< as b2DynamicTree::GetMaxBalance
    float32 GetTreeQuality() const; ///< as b2DynamicTree::GetAreaRatio

    /// Sets the acceleration of all dynamic bodies [m/s^2]. A value that is not finite asserts and
    /// changes nothing.
    void SetGravity(const b2Vec2& gravity);
    b2Vec2 GetGravity() const; ///< acceleration of all dynamic bodies [m/s^2]
    /// Sets the restitution threshold [m/s], default b2_velocityThreshold: slower impacts do not
    /// bounce. With 0 bodies with restitution hardly come to rest. A value that is negative or not
    /// finite asserts and changes nothing. Snapshots save it. An addition to the manual's
    /// interface.
    void SetRestitutionThreshold(float32 speed);
    float32 GetRestitutionThreshold() const; ///< slower impacts do not bounce [m/s]
    /// True while a callback of a step or query may run. Objects cannot be created or destroyed
    /// then.
    bool IsLocked() const;
    void SetAutoClearForces(bool flag); ///< true: forces last for one step only
    bool GetAutoClearForces() const;    ///< true if forces last for one step only
    /// Shifts the origin of the world: `newOrigin` [m] becomes zero. While the world is locked, or
    /// for a coordinate beyond 1e15 m or not finite, it asserts and changes nothing.
    void ShiftOrigin(const b2Vec2& newOrigin);
    /// Returns the timing of the last step. The first call enables measuring.
    const b2Profile& GetProfile() const;
    /// Fills the summary of the contacts and returns it.
    const b2ContactManager& GetContactManager() const;
    /// Writes the world as code to the log; does nothing while it is locked.
    void Dump();

private:
    friend struct box2d::SnapshotAccess;
    std::unique_ptr<box2d::World> m_world;
};
