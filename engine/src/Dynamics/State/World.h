// SPDX-License-Identifier: MIT
#pragma once

#include "BodyPose.h"
#include "ConstraintGraph.h"
#include "Islands.h"
#include "PairSet.h"
#include "Proxies.h"

#include "../../Common/ThreadPool.h"

#include <Box2D/Common/b2BlockAllocator.h>
#include <Box2D/Dynamics/b2ContactManager.h>
#include <Box2D/Dynamics/b2TimeStep.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <memory>

struct b2BodyDef;
struct b2FixtureDef;
struct b2FixtureProxy;
struct b2JointDef;
struct b2MassData;
class b2Body;
class b2Contact;
class b2Draw;
class b2Joint;
class b2Shape;
class b2World;

/// The data of a world. b2World is its public interface. The parts of the engine are functions of
/// it, one file each: Bodies, Contacts, Joints, Step, Continuous, Queries, DebugDraw.
namespace box2d
{

class EnergyGuard;
struct ImpactMemory;
struct SolverMemory;
struct SubStepMemory;

/// Maximum of sub-steps per step.
inline constexpr int32 kMostSubSteps = 64;

struct ContactData;
struct SeenChild;

class World
{
public:
    World(b2World& owner, const b2Vec2& gravity, bool doSleep);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // Bodies.cpp
    b2Body* CreateBody(const b2BodyDef& def);
    /// Adds an empty body, the newest in the list.
    b2Body& AddBody();
    void DestroyBody(b2Body& body);
    void SetTransform(b2Body& body, const b2Vec2& position, float32 angle);
    void SetMassData(BodyData& body, const b2MassData& massData);
    void ResetMassData(BodyData& body);
    /// Computes the maximum extent from the centre of mass and the minimum thickness.
    static void MeasureExtents(BodyData& body);
    /// As above, if only the newest fixture changed: adding thousands of fixtures stays linear.
    static void MeasureNewest(BodyData& body);
    void SetMobility(b2Body& body, Mobility mobility);
    void SetActive(b2Body& body, bool active);

    // Fixtures.cpp
    b2Fixture* CreateFixture(b2Body& body, const b2FixtureDef& def);
    /// Adds a fixture with a copy of the shape, in no tree yet, the newest of its body.
    b2Fixture& AddFixture(b2Body& body, const b2Shape& shape);
    void DestroyFixture(b2Body& body, b2Fixture& fixture);
    /// Frees its memory; it must be in no list.
    void FreeFixture(b2Fixture& fixture);
    void Refilter(b2Fixture& fixture);
    /// Call after a change of the fixture's sensor flag.
    void UpdateSensor(b2Fixture& fixture);
    void CreateProxies(b2Fixture& fixture);
    void DestroyProxies(b2Fixture& fixture);
    /// Call after a motion of the body: updates the boxes that shapes have left. `swept` includes
    /// the path from the pose at the start of the step.
    void UpdateProxies(BodyData& body, bool swept);
    /// As above in two phases: RefreshBoxes updates the boxes of this body; if it returns true, the
    /// second updates the broad phase.
    static bool RefreshBoxes(BodyData& body, bool swept);
    void MoveProxies(BodyData& body);
    void GrowBoxes(BodyData& body);
    /// Updates all boxes unconditionally.
    void ResetProxies(BodyData& body);

    // Joints.cpp
    b2Joint* CreateJoint(const b2JointDef& def);
    /// As above in two phases; the second makes it the newest of the world and its bodies.
    b2Joint& ConstructJoint(const b2JointDef& def);
    void LinkJoint(b2Joint& joint);
    /// Also destroys the gears that use it.
    void DestroyJoint(b2Joint& joint);
    /// Destroys a joint with its body, and calls the destruction listener.
    void DestroyJointImplicitly(b2Joint& joint);
    void FlagJointContacts(b2Joint& joint);

    // Contacts.cpp
    void FindNewContacts();
    void UpdateContacts();
    void UpdateContact(b2Contact& contact);
    /// As above in two phases: the first updates only this contact, with its previous manifold in
    /// `old`; the second handles the consequences.
    static void ComputeContact(b2Contact& contact, b2Manifold& old);
    void FinishContact(b2Contact& contact, const b2Manifold& old);
    static void ComputeManifold(ContactData& c, const b2Transform& bInA, const b2Manifold& old);
    bool ComputeContacts();
    void ForgetUpdate(ContactData& c);
    bool NeedsAttention(b2Contact& contact);
    void FinishContacts();
    void FinishContactsInNeed();
    /// Adds a contact between children of fixtures, the newest of the world and its bodies.
    b2Contact& AddContact(const b2FixtureProxy& a, const b2FixtureProxy& b);
    void DestroyContact(b2Contact& contact);
    /// True if bodies, joints and the filter allow contacts of the pair.
    bool ShouldCollide(b2Fixture& fixtureA, b2Fixture& fixtureB) const;

    // Sleep.cpp
    void Wake(b2Body& body);       ///< and its connected component
    void PutToSleep(b2Body& body); ///< this body only
    void PutToSleep(int32 island);
    /// Adds it to the lists of awake objects or removes it, by the state of its bodies. Call after
    /// any change of that state.
    void UpdateActivity(b2Body& body);
    void UpdateActivity(b2Contact& contact);
    void UpdateActivity(b2Joint& joint);
    /// Wakes bodies held by a contact or joint with a moving body.
    void WakeNeighbours(b2Body& bodyA, b2Body& bodyB);
    /// Keeps bodies awake that a motor moves at its target speed, at any speed.
    static void KeepDrivenAwake(b2Joint& joint);
    /// False if WakeNeighbours has no effect.
    static bool WakesNeighbours(const BodyData& a, const BodyData& b);
    /// Call after a user change: wakes the body with everything in contact or jointed, because
    /// contacts between sleeping bodies are not updated. A body without any stays asleep.
    void WakeAttached(b2Body& body);

    /// Number of steps for which a user change counts as recent: pose corrections remove a fifth of
    /// the error per step, so a tenth is left then.
    static constexpr std::uint32_t kHandLasts = 10;
    /// True if the step with this number is one of the last kHandLasts.
    bool IsRecent(std::uint32_t step) const { return stepNumber - step < kHandLasts; }

    // Step.cpp
    void Step(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    void Solve(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    void SolveAwake(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    // SubStepSolver.cpp
    void SolveInSubSteps(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    void ClearForces();
    // Continuous.cpp
    void SolveContinuous(float32 timeStep, int32 velocityIterations);
    // DebugDraw.cpp
    void Draw(b2Draw& draw) const;
    // SeenShapes.cpp
    Array<SeenChild> FindSeen(const b2AABB& view) const;
    // Queries.cpp
    void Query(b2QueryCallback& callback, const b2AABB& box) const;
    void RayCast(b2RayCastCallback& callback, const b2Vec2& point1, const b2Vec2& point2) const;
    void ShiftOrigin(const b2Vec2& newOrigin);

    b2World& owner;
    b2BlockAllocator allocator; ///< bodies, fixtures, shapes, joints, contacts
    Proxies proxies;
    PairSet pairs; ///< pairs with a contact
    ConstraintGraph graph;
    Islands islands;

    Array<b2Body*> awakeBodies;      ///< kinematic and dynamic bodies
    Array<b2Contact*> awakeContacts; ///< contacts with an awake body that is not static
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

    b2Vec2 gravity; ///< [m/s^2]
    b2ContactFilter defaultFilter;
    b2ContactFilter* filter = &defaultFilter; ///< never null
    b2ContactListener* listener = nullptr;
    b2DestructionListener* destructionListener = nullptr;
    b2Draw* debugDraw = nullptr;

    int32 subStepCount = 1;                ///< sub-steps per step
    int32 lastSubSteps = 1;                ///< of the last step with solved constraints
    float32 inverseStep = 0.0f;            ///< of the last step [1/s], 0 before the first
    std::uint32_t stepNumber = kHandLasts; ///< steps with a time above 0
    b2Profile profile;
    /// The result of b2World::GetContactManager.
    mutable b2ContactManager contactManager{
        .m_broadPhase = b2BroadPhase(proxies.Trees(), Proxies::kTreeCount, Proxies::kTreeBits)};
    bool profiling = false;
    bool allowSleep = true;
    bool warmStarting = true;
    bool continuousPhysics = true;
    bool subStepping = false;
    bool stepComplete = true; ///< false between the sub-steps of SetSubStepping
    bool autoClearForces = true;
    mutable bool locked = false; ///< a callback of the program may run: objects cannot be created
                                 ///< or destroyed
    bool forcesApplied = false;  ///< since the last ClearForces
    bool hasBullets = false;     ///< a body is, or was, a bullet
    bool filtersChanged = false; ///< a contact has kContactFilter set
    bool sweepsTurned = false;   ///< alternates with each step, see ColorDirectionOf
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
