// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/b2ContactManager.h>
#include <Box2D/Dynamics/b2TimeStep.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <memory>

/// @file
/// The world.

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

/// The hub: owns bodies, joints and contacts, steps them, answers queries. To be called by one
/// thread at a time, whatever the number of threads that help it. What must not be called while it
/// is locked (IsLocked) says so.
class b2World
{
public:
    /// Empty. Gravity [m/s^2], finite: else it asserts and is 0. `doSleep`: whether bodies may fall
    /// asleep.
    explicit b2World(const b2Vec2& gravity, bool doSleep = true);
    ~b2World();
    b2World(const b2World&) = delete;
    b2World& operator=(const b2World&) = delete;

    /// Whom the world tells of what vanishes with a body; nullptr: nobody. Each listener must
    /// outlive the world or be replaced by nullptr.
    void SetDestructionListener(b2DestructionListener* listener);
    /// As SetDestructionListener.
    void SetListener(b2DestructionListener* listener) { SetDestructionListener(listener); }
    /// Who decides which fixtures collide; nullptr: what b2ContactFilter itself does.
    void SetContactFilter(b2ContactFilter* filter);
    /// Whom the world tells of contacts; nullptr: nobody.
    void SetContactListener(b2ContactListener* listener);
    /// What DrawDebugData draws with; nullptr: nothing.
    void SetDebugDraw(b2Draw* debugDraw);

    /// A body of the world's, from a definition, which is copied. nullptr, after an assert where
    /// they are on: while the world is locked, and of no definition. A value that is none, such as
    /// a velocity that is not finite, becomes the default of b2BodyDef.
    b2Body* CreateBody(const b2BodyDef* def);
    /// Takes it away with its fixtures, joints and contacts. While the world is locked, and of no
    /// body of this world, it asserts and nothing goes.
    void DestroyBody(b2Body* body);
    /// A joint between two bodies of the world's, from a definition, which is copied. nullptr,
    /// after an assert where they are on: while the world is locked; of no definition; without two
    /// different bodies, both of this world; of a type that is no joint's; with a number out of the
    /// range that its definition says, or not finite; and of a gear whose two joints are not
    /// revolute or prismatic or do not move two different bodies of this world.
    b2Joint* CreateJoint(const b2JointDef* def);
    /// Takes it away; its bodies wake. While the world is locked, and of no joint of this world, it
    /// asserts and nothing goes.
    void DestroyJoint(b2Joint* joint);

    /// Moves time on. `timeStep` in seconds, 0 to a million, should not vary; 8 and 3 are good
    /// iteration counts, none is below 0. Nothing is done, after an assert where they are on, while
    /// the world is locked or with a step that is negative or not finite; a longer step is cut.
    void Step(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    /// Forgets all forces and torques; only needed when automatic clearing is off.
    void ClearForces();
    /// Calls the registered b2Draw for what its flags ask for.
    void DrawDebugData();
    void DebugDraw() { DrawDebugData(); } ///< as DrawDebugData, by the name of 2.4

    /// Every fixture whose broad-phase box overlaps `aabb` [m], in no particular order. The bounds
    /// are finite and in order: of others the answer means nothing. No callback asserts, and
    /// nothing is done.
    void QueryAABB(b2QueryCallback* callback, const b2AABB& aabb) const;
    /// As QueryAABB.
    void Query(b2QueryCallback* callback, const b2AABB& aabb) const { QueryAABB(callback, aabb); }
    /// Every fixture that the ray from point1 to point2 [m], both finite, meets, in no particular
    /// order. No callback asserts, and nothing is done.
    void RayCast(b2RayCastCallback* callback, const b2Vec2& point1, const b2Vec2& point2) const;

    /// The newest body, from which b2Body::GetNext leads to all others; nullptr: there is none.
    b2Body* GetBodyList();
    const b2Body* GetBodyList() const;   ///< the newest body, to be read
    b2Joint* GetJointList();             ///< the newest joint, and b2Joint::GetNext leads on
    const b2Joint* GetJointList() const; ///< the newest joint, to be read
    b2Contact* GetContactList();         ///< the newest contact, and b2Contact::GetNext leads on
    const b2Contact* GetContactList() const; ///< the newest contact, to be read
    /// The active kinematic and dynamic bodies that do not sleep, GetAwakeBodyCount() of them, in
    /// no particular order: what can move, without a look at what rests. Valid until the world is
    /// changed or stepped. An addition to the manual's interface.
    const b2Body* const* GetAwakeBodies() const;
    int32 GetAwakeBodyCount() const; ///< how many GetAwakeBodies has
    /// Bodies that are not active, and so in no tree and no list of what is awake. An addition to
    /// the manual's interface.
    int32 GetInactiveBodyCount() const;

    void SetAllowSleeping(bool flag); ///< whether bodies may fall asleep; false wakes all
    bool GetAllowSleeping() const;    ///< whether bodies may fall asleep
    /// Whether impulses of the last step are where the next begins.
    void SetWarmStarting(bool flag);
    bool GetWarmStarting() const; ///< whether impulses of the last step are where the next begins
    /// Whether fast bodies are stopped at what they would pass.
    void SetContinuousPhysics(bool flag);
    bool GetContinuousPhysics() const; ///< whether fast bodies are stopped at what they would pass
    /// One time of impact a step, for watching them.
    void SetSubStepping(bool flag);
    bool GetSubStepping() const; ///< whether a step ends at its first time of impact

    /// How many small steps a step takes, 1 to 64, and 1 unless said: the scheme of the manual.
    /// With more, contacts are found once a step, and the bodies then move in small steps of a
    /// scheme of second order: free flight is exact, joints are solved exactly and lose no energy.
    /// The iterations given to Step are shared out over the small steps, at least one to each:
    /// b2IterationsOfASubStep. Another number asserts and becomes the nearest of these; while the
    /// world is locked nothing changes.
    void SetSubStepCount(int32 count);
    int32 GetSubStepCount() const; ///< 1 to 64

    /// How many threads share the work of a step, the calling one included; 1 to 64, and 1 unless
    /// said. The results are the same to the last bit whatever the number. Callbacks come from the
    /// calling thread, in the same order. While a step lasts the others wait busily, callbacks
    /// included: small worlds, and more threads than processors, only cost. Another number asserts
    /// and becomes the nearest of these; while the world is locked nothing changes.
    void SetThreadCount(int32 count);
    int32 GetThreadCount() const; ///< 1 to 64

    int32 GetProxyCount() const;    ///< how many boxes the broad phase has
    int32 GetBodyCount() const;     ///< how many bodies there are
    int32 GetJointCount() const;    ///< how many joints there are
    int32 GetContactCount() const;  ///< how many contacts there are, touching or not
    int32 GetTreeHeight() const;    ///< of the broad phase's highest tree, 0 or more
    int32 GetTreeBalance() const;   ///< as b2DynamicTree::GetMaxBalance
    float32 GetTreeQuality() const; ///< as b2DynamicTree::GetAreaRatio

    /// Acceleration of all dynamic bodies [m/s^2]. One that is not finite asserts and changes
    /// nothing.
    void SetGravity(const b2Vec2& gravity);
    b2Vec2 GetGravity() const; ///< acceleration of all dynamic bodies [m/s^2]
    /// True while a callback may run, in a step or a query: nothing may be created or destroyed
    /// then.
    bool IsLocked() const;
    void SetAutoClearForces(bool flag); ///< whether forces last for one step only
    bool GetAutoClearForces() const;    ///< whether forces last for one step only
    /// Moves the origin of the whole world; what was at `newOrigin` [m] is at zero afterwards.
    /// Nothing moves, after an assert where they are on, while the world is locked and for a
    /// coordinate beyond 1e15 m or not finite.
    void ShiftOrigin(const b2Vec2& newOrigin);
    /// Where the time of the last step went; switches measuring on.
    const b2Profile& GetProfile() const;
    /// As things stand: filled by this call.
    const b2ContactManager& GetContactManager() const;
    /// Writes the world as code to the log; nothing while it is locked.
    void Dump();

private:
    friend struct box2d::SnapshotAccess;
    std::unique_ptr<box2d::World> m_world;
};
