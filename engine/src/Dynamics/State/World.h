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

/// Everything a world holds. b2World is the public face of it; the parts of the engine are
/// functions on it, a file each: Bodies, Contacts, Joints, Step, Continuous, Queries, DebugDraw.
namespace box2d
{

class EnergyGuard;
struct ImpactMemory;
struct SolverMemory;
struct SubStepMemory;

/// Of one step; more only costs.
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
    /// An empty one, the newest in the list.
    b2Body& AddBody();
    void DestroyBody(b2Body& body);
    void SetTransform(b2Body& body, const b2Vec2& position, float32 angle);
    void SetMassData(BodyData& body, const b2MassData& massData);
    void ResetMassData(BodyData& body);
    /// How far the shapes reach from the centre of mass, and how thin they are.
    static void MeasureExtents(BodyData& body);
    /// The same, when nothing but the fixture that was created last is new: a body of thousands is
    /// not measured thousands of times.
    static void MeasureNewest(BodyData& body);
    void SetMobility(b2Body& body, Mobility mobility);
    void SetActive(b2Body& body, bool active);

    // Fixtures.cpp
    b2Fixture* CreateFixture(b2Body& body, const b2FixtureDef& def);
    /// With a copy of the shape, in no tree yet, the newest of its body.
    b2Fixture& AddFixture(b2Body& body, const b2Shape& shape);
    void DestroyFixture(b2Body& body, b2Fixture& fixture);
    /// Gives its memory back; it must be out of every list.
    void FreeFixture(b2Fixture& fixture);
    void Refilter(b2Fixture& fixture);
    /// After the fixture has become, or ceased to be, a sensor.
    void UpdateSensor(b2Fixture& fixture);
    void CreateProxies(b2Fixture& fixture);
    void DestroyProxies(b2Fixture& fixture);
    /// After its body has moved: new boxes where the shapes have left theirs. `swept` also covers
    /// the way from the pose at the start of the step.
    void UpdateProxies(BodyData& body, bool swept);
    /// The same in two parts: new boxes, of this body alone; then, when that was true, the broad
    /// phase is told.
    static bool RefreshBoxes(BodyData& body, bool swept);
    void MoveProxies(BodyData& body);
    void GrowBoxes(BodyData& body);
    /// Boxes anew whether the shapes have left theirs or not.
    void ResetProxies(BodyData& body);

    // Joints.cpp
    b2Joint* CreateJoint(const b2JointDef& def);
    /// Makes it the newest of the world and its bodies.
    void LinkJoint(b2Joint& joint);
    /// With the gears that are made of it.
    void DestroyJoint(b2Joint& joint);
    /// As a consequence of something else: the program is told.
    void DestroyJointImplicitly(b2Joint& joint);
    void FlagJointContacts(b2Joint& joint);

    // Contacts.cpp
    void FindNewContacts();
    void UpdateContacts();
    void UpdateContact(b2Contact& contact);
    /// The same in two parts: what concerns this contact alone, with the manifold as it was left in
    /// `old`; then what follows from it.
    static void ComputeContact(b2Contact& contact, b2Manifold& old);
    void FinishContact(b2Contact& contact, const b2Manifold& old);
    static void ComputeManifold(ContactData& c, const b2Transform& bInA, const b2Manifold& old);
    bool ComputeContacts();
    void ForgetUpdate(ContactData& c);
    bool NeedsAttention(b2Contact& contact);
    void FinishContacts();
    void FinishContactsInNeed();
    /// The newest of the world and its bodies, between children of fixtures.
    b2Contact& AddContact(const b2FixtureProxy& a, const b2FixtureProxy& b);
    void DestroyContact(b2Contact& contact);
    /// The pair may have contacts as far as bodies, joints and the filter are concerned.
    bool ShouldCollide(b2Fixture& fixtureA, b2Fixture& fixtureB) const;

    // Sleep.cpp
    void Wake(b2Body& body);       ///< and everything that hangs together with it
    void PutToSleep(b2Body& body); ///< this one only
    void PutToSleep(int32 island);
    /// Puts it into the lists of what a step looks at, or takes it out, as follows from the state
    /// of its body or bodies. To be called after any change of that.
    void UpdateActivity(b2Body& body);
    void UpdateActivity(b2Contact& contact);
    void UpdateActivity(b2Joint& joint);
    /// Wakes what is held by a contact or joint with something that moves.
    void WakeNeighbours(b2Body& bodyA, b2Body& bodyB);
    /// False when WakeNeighbours would do nothing.
    static bool WakesNeighbours(const BodyData& a, const BodyData& b);
    /// After a change by hand: wakes the body with everything it has contacts or joints with, for
    /// contacts between sleeping bodies are not looked at. One that has none sleeps on.
    void WakeAttached(b2Body& body);

    /// For so many steps what the program has moved by hand counts as moved: corrections of poses
    /// take a fifth of what they find in each, so a tenth of it is left then.
    static constexpr std::uint32_t kHandLasts = 10;
    /// Whether it did so in the last of these, by the number of the step then.
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
    PairSet pairs; ///< that have a contact
    ConstraintGraph graph;
    Islands islands;

    Array<b2Body*> awakeBodies;      ///< kinematic and dynamic
    Array<b2Contact*> awakeContacts; ///< with a body that is awake and not static
    Array<b2Manifold> oldManifolds;  ///< of these, before the present update
    Array<uint8> attention; ///< of these, by place: whether the second part of the update is due
    // Of the stages of a step, used again in every one.
    std::unique_ptr<SolverMemory> solver;
    std::unique_ptr<SubStepMemory> subSteps;
    std::unique_ptr<EnergyGuard> energyGuard;
    std::unique_ptr<ImpactMemory> impacts;
    std::unique_ptr<ThreadPool> threads; ///< null when the caller's is the only one

    b2Body* bodyList = nullptr;
    b2Joint* jointList = nullptr;
    b2Contact* contactList = nullptr;
    int32 bodyCount = 0;
    int32 jointCount = 0;
    int32 gearCount = 0;     ///< of the joints
    int32 inactiveCount = 0; ///< of the bodies: they are in no tree
    int32 contactCount = 0;
    int32 bodyNumber = 0;  ///< of the next body
    int32 jointNumber = 0; ///< of the next joint

    b2Vec2 gravity; ///< [m/s^2]
    b2ContactFilter defaultFilter;
    b2ContactFilter* filter = &defaultFilter; ///< never null
    b2ContactListener* listener = nullptr;
    b2DestructionListener* destructionListener = nullptr;
    b2Draw* debugDraw = nullptr;

    int32 subStepCount = 1;                ///< small steps of a step
    int32 lastSubSteps = 1;                ///< of the last step in which anything was solved
    float32 inverseStep = 0.0f;            ///< of the last step [1/s], 0 before the first
    std::uint32_t stepNumber = kHandLasts; ///< of steps that take time
    b2Profile profile;
    /// What b2World::GetContactManager hands out.
    mutable b2ContactManager contactManager{
        .m_broadPhase = b2BroadPhase(proxies.Trees(), Proxies::kTreeCount, Proxies::kTreeBits)};
    bool profiling = false;
    bool allowSleep = true;
    bool warmStarting = true;
    bool continuousPhysics = true;
    bool subStepping = false;
    bool stepComplete = true; ///< false between the sub-steps of SetSubStepping
    bool autoClearForces = true;
    mutable bool locked = false; ///< a callback of the program may run: nothing may come or go
    bool forcesApplied = false;  ///< since they were last cleared
    bool hasBullets = false;     ///< some body is, or was, a bullet
    bool filtersChanged = false; ///< some contact has kContactFilter set
    bool sweepsTurned = false;   ///< changes with each step, see ColorDirectionOf
};

/// Keeps a world locked for as long as a callback of the program may run. Can be nested.
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
