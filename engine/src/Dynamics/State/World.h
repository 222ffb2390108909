// SPDX-License-Identifier: MIT
#pragma once

#include "BodyPose.h"
#include "ConstraintGraph.h"
#include "Islands.h"
#include "PairSet.h"
#include "Proxies.h"
#include "WorldSettings.h"

#include "../../Common/ThreadPool.h"

#include <Box2D/Common/b2BlockAllocator.h>
#include <Box2D/Dynamics/b2ContactManager.h>
#include <Box2D/Dynamics/b2TimeStep.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <memory>

class b2Body;
class b2Contact;
class b2Draw;
class b2Joint;
class b2World;

/// The data of a world. b2World is its public interface. Operations on it are functions, each
/// declared by the folder that owns it (World/Bodies.h, Contacts/Contacts.h, Islands/Sleep.h ...).
namespace box2d
{

class EnergyGuard;
struct ImpactMemory;
struct SolverMemory;
struct SubStepMemory;

/// What the update of an awake contact reads first, one after the other. Of shapes that stay apart
/// and of bodies that lie on each other it reads nothing else. Repeats parts of the ContactData.
struct PairLook
{
    const BodyData* bodyA = nullptr;
    const BodyData* bodyB = nullptr;
    const b2FixtureProxy* proxyA = nullptr;
    const b2FixtureProxy* proxyB = nullptr;
    b2Transform relative;
    float32 gap = 0.0f;     ///< or 0; if it is not kept either, the contact itself is updated
    bool kept = false;      ///< kContactKept, and it was kept at last
    bool unchanged = false; ///< what the first part of the present update found
};

class World
{
public:
    World(b2World& owner, const b2Vec2& gravity, bool doSleep);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Steps for which a body counts as moved after a user change. Corrections of poses take a
    /// fifth of an error in each, so a tenth of it is left then.
    static constexpr std::uint32_t kUserChangeSteps = 10;
    /// True if the step with this number is one of the last kUserChangeSteps.
    bool IsRecentUserChange(std::uint32_t step) const
    {
        return stepNumber - step < kUserChangeSteps;
    }

    b2World& owner;
    WorldSettings settings;

    b2BlockAllocator allocator; ///< bodies, fixtures, shapes, joints, contacts
    Proxies proxies;
    PairSet pairs; ///< pairs with a contact
    ConstraintGraph graph;
    Islands islands;

    Array<b2Body*> awakeBodies;      ///< kinematic and dynamic bodies
    std::uint32_t awakeVersion = 0;  ///< changes with that list
    Array<b2Contact*> awakeContacts; ///< contacts with an awake body that is not static
    Array<uint8> awakeObstacles;     ///< of each of these: true if one of its bodies is not dynamic
    Array<PairLook> awakeLooks;      ///< at each of these
    Array<b2Manifold> oldManifolds;  ///< their manifolds before the current update
    Array<uint8> attention; ///< by index: true if the second phase of the update is required
    // Scratch of the stages of a step, reused in every step.
    std::unique_ptr<SolverMemory> solver;
    std::unique_ptr<SubStepMemory> subSteps;
    std::unique_ptr<EnergyGuard> energyGuard;
    std::unique_ptr<ImpactMemory> impacts;
    std::unique_ptr<ThreadPool> threads; ///< null if only the calling thread is used

    b2Body* bodyList = nullptr;
    b2Joint* jointList = nullptr;
    b2Contact* contactList = nullptr;
    int32 bodyCount = 0;
    int32 jointCount = 0;
    int32 gearCount = 0;     ///< among the joints
    int32 inactiveCount = 0; ///< among the bodies: they are in no tree
    int32 contactCount = 0;
    int32 bodyNumber = 0;  ///< of the next body
    int32 jointNumber = 0; ///< of the next joint

    b2ContactFilter defaultFilter;
    b2ContactFilter* filter = &defaultFilter; ///< never null
    b2ContactListener* listener = nullptr;
    b2DestructionListener* destructionListener = nullptr;
    b2Draw* debugDraw = nullptr;

    int32 lastSubSteps = 1;                      ///< of the last step in which anything was solved
    float32 inverseStep = 0.0f;                  ///< of the last step [1/s], 0 before the first
    std::uint32_t stepNumber = kUserChangeSteps; ///< steps with a time above 0
    b2Profile profile;
    /// The result of b2World::GetContactManager.
    mutable b2ContactManager contactManager{
        .m_broadPhase = b2BroadPhase(proxies.Trees(), Proxies::kTreeCount, Proxies::kTreeBits)};
    bool profiling = false;
    bool stepComplete = true;    ///< false between the sub-steps of SetSubStepping
    mutable bool locked = false; ///< a callback of the program may run: objects cannot be created
                                 ///< or destroyed
    bool forcesApplied = false;  ///< since the last ClearForces
    bool hasBullets = false;     ///< a body is, or was, a bullet
    bool filtersChanged = false; ///< a contact has kContactFilter set
    bool directionReversed = false; ///< alternates with each step, see ColorDirectionOf
};

/// Locks a world while a callback of the program may run. Can be nested.
class Lock
{
public:
    explicit Lock(const World& world) : m_world(world), m_before(world.locked)
    {
        world.locked = true;
    }
    ~Lock() { m_world.locked = m_before; }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    const World& m_world;
    bool m_before;
};

} // namespace box2d
