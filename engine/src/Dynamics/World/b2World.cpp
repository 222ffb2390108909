// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2World.h>

#include "../State/Access.h"
#include "../State/Reach.h"
#include "../State/World.h"
#include "Bodies.h"
#include "DebugDraw.h"
#include "Joints.h"
#include "Queries.h"
#include "Step.h"

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

/// The public interface of box2d::World: checks preconditions, then forwards.

b2World::b2World(const b2Vec2& gravity, bool doSleep)
    : m_world(std::make_unique<box2d::World>(*this, gravity, doSleep))
{
    (void)B2_REQUIRE(gravity.IsValid(), "A world's gravity must be finite.");
}

b2World::~b2World() = default;

void b2World::SetDestructionListener(b2DestructionListener* listener)
{
    m_world->destructionListener = listener;
}

void b2World::SetContactFilter(b2ContactFilter* filter)
{
    m_world->filter = filter ? filter : &m_world->defaultFilter;
}

void b2World::SetContactListener(b2ContactListener* listener)
{
    m_world->listener = listener;
    m_world->graph.NoteAllForms(); // the old listener may have disabled contacts
}

void b2World::SetDebugDraw(b2Draw* debugDraw)
{
    m_world->debugDraw = debugDraw;
}

b2Body* b2World::CreateBody(const b2BodyDef* def)
{
    if (!B2_REQUIRE(!IsLocked(),
                    "b2World::CreateBody must not be called from inside a callback.") ||
        !B2_REQUIRE(def != nullptr, "b2World::CreateBody needs a definition."))
    {
        return nullptr;
    }
    return box2d::CreateBody(*m_world, *def);
}

void b2World::DestroyBody(b2Body* body)
{
    if (B2_REQUIRE(!IsLocked(),
                   "b2World::DestroyBody must not be called from inside a callback.") &&
        B2_REQUIRE(body != nullptr && body->GetWorld() == this,
                   "b2World::DestroyBody needs a body of this world."))
    {
        box2d::DestroyBody(*m_world, *body);
    }
}

b2Joint* b2World::CreateJoint(const b2JointDef* def)
{
    if (!B2_REQUIRE(!IsLocked(),
                    "b2World::CreateJoint must not be called from inside a callback.") ||
        !B2_REQUIRE(def != nullptr, "b2World::CreateJoint needs a definition."))
    {
        return nullptr;
    }
    return box2d::CreateJoint(*m_world, *def);
}

void b2World::DestroyJoint(b2Joint* joint)
{
    if (B2_REQUIRE(!IsLocked(),
                   "b2World::DestroyJoint must not be called from inside a callback.") &&
        B2_REQUIRE(joint != nullptr && joint->GetBodyA()->GetWorld() == this,
                   "b2World::DestroyJoint needs a joint of this world."))
    {
        box2d::DestroyJoint(*m_world, *joint);
    }
}

void b2World::Step(float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    box2d::Step(*m_world, timeStep, velocityIterations, positionIterations);
}

void b2World::ClearForces()
{
    box2d::ClearForces(*m_world);
}

void b2World::DrawDebugData()
{
    if (m_world->debugDraw)
    {
        box2d::Draw(*m_world, *m_world->debugDraw);
    }
}

void b2World::QueryAABB(b2QueryCallback* callback, const b2AABB& aabb) const
{
    if (B2_REQUIRE(callback != nullptr, "b2World::QueryAABB needs a callback."))
    {
        box2d::Query(*m_world, *callback, aabb);
    }
}

void b2World::RayCast(b2RayCastCallback* callback, const b2Vec2& point1, const b2Vec2& point2) const
{
    if (B2_REQUIRE(callback != nullptr, "b2World::RayCast needs a callback."))
    {
        box2d::RayCast(*m_world, *callback, point1, point2);
    }
}

b2Body* b2World::GetBodyList()
{
    return m_world->bodyList;
}

const b2Body* b2World::GetBodyList() const
{
    return m_world->bodyList;
}

b2Joint* b2World::GetJointList()
{
    return m_world->jointList;
}

const b2Joint* b2World::GetJointList() const
{
    return m_world->jointList;
}

b2Contact* b2World::GetContactList()
{
    return m_world->contactList;
}

const b2Contact* b2World::GetContactList() const
{
    return m_world->contactList;
}

const b2Body* const* b2World::GetAwakeBodies() const
{
    return m_world->awakeBodies.data();
}

int32 b2World::GetAwakeBodyCount() const
{
    return static_cast<int32>(m_world->awakeBodies.size());
}

int32 b2World::GetInactiveBodyCount() const
{
    return m_world->inactiveCount;
}

void b2World::SetSubStepCount(int32 count)
{
    if (!B2_REQUIRE(!IsLocked(),
                    "b2World::SetSubStepCount must not be called from inside a callback."))
    {
        return;
    }
    (void)B2_REQUIRE(count >= 1 && count <= box2d::kMaxSubSteps,
                     "The number of sub-steps must be from 1 to 64.");
    m_world->settings.subStepCount = b2Clamp(count, 1, box2d::kMaxSubSteps);
}

int32 b2World::GetSubStepCount() const
{
    return m_world->settings.subStepCount;
}

void b2World::SetThreadCount(int32 count)
{
    if (!B2_REQUIRE(!IsLocked(),
                    "b2World::SetThreadCount must not be called from inside a callback."))
    {
        return;
    }
    (void)B2_REQUIRE(count >= 1 && count <= box2d::ThreadPool::kMaxThreads,
                     "The number of threads must be from 1 to 64.");
    count = b2Clamp(count, 1, box2d::ThreadPool::kMaxThreads);
    if (count != GetThreadCount())
    {
        m_world->threads.reset(); // destroy the old threads before creating new ones
        m_world->threads = count > 1 ? std::make_unique<box2d::ThreadPool>(count) : nullptr;
    }
}

int32 b2World::GetThreadCount() const
{
    return m_world->threads ? m_world->threads->Count() : 1;
}

void b2World::SetAllowSleeping(bool flag)
{
    if (flag == m_world->settings.allowSleep)
    {
        return;
    }
    m_world->settings.allowSleep = flag;
    if (!flag)
    {
        for (b2Body* body = GetBodyList(); body; body = body->GetNext())
        {
            body->SetAwake(true);
        }
    }
}

bool b2World::GetAllowSleeping() const
{
    return m_world->settings.allowSleep;
}

void b2World::SetWarmStarting(bool flag)
{
    m_world->settings.warmStarting = flag;
}

bool b2World::GetWarmStarting() const
{
    return m_world->settings.warmStarting;
}

void b2World::SetContinuousPhysics(bool flag)
{
    m_world->settings.continuousPhysics = flag;
}

bool b2World::GetContinuousPhysics() const
{
    return m_world->settings.continuousPhysics;
}

void b2World::SetSubStepping(bool flag)
{
    m_world->settings.subStepping = flag;
}

bool b2World::GetSubStepping() const
{
    return m_world->settings.subStepping;
}

int32 b2World::GetProxyCount() const
{
    return m_world->proxies.Count();
}

int32 b2World::GetBodyCount() const
{
    return m_world->bodyCount;
}

int32 b2World::GetJointCount() const
{
    return m_world->jointCount;
}

int32 b2World::GetContactCount() const
{
    return m_world->contactCount;
}

int32 b2World::GetTreeHeight() const
{
    return m_world->contactManager.m_broadPhase.GetTreeHeight();
}

int32 b2World::GetTreeBalance() const
{
    return m_world->contactManager.m_broadPhase.GetTreeBalance();
}

float32 b2World::GetTreeQuality() const
{
    return m_world->contactManager.m_broadPhase.GetTreeQuality();
}

void b2World::SetGravity(const b2Vec2& gravity)
{
    if (B2_REQUIRE(gravity.IsValid(), "A world's gravity must be finite."))
    {
        m_world->settings.gravity = gravity;
    }
}

b2Vec2 b2World::GetGravity() const
{
    return m_world->settings.gravity;
}

void b2World::SetRestitutionThreshold(float32 speed)
{
    if (B2_REQUIRE(b2IsValid(speed) && speed >= 0.0f,
                   "A world's restitution threshold must be finite and not negative."))
    {
        m_world->settings.restitutionThreshold = speed;
    }
}

float32 b2World::GetRestitutionThreshold() const
{
    return m_world->settings.restitutionThreshold;
}

bool b2World::IsLocked() const
{
    return m_world->locked;
}

void b2World::SetAutoClearForces(bool flag)
{
    m_world->settings.autoClearForces = flag;
}

bool b2World::GetAutoClearForces() const
{
    return m_world->settings.autoClearForces;
}

void b2World::ShiftOrigin(const b2Vec2& newOrigin)
{
    if (B2_REQUIRE(!IsLocked(),
                   "b2World::ShiftOrigin must not be called from inside a callback.") &&
        B2_REQUIRE(box2d::IsWithinReach(newOrigin),
                   "b2World::ShiftOrigin needs a finite point within 1e15 m."))
    {
        box2d::ShiftOrigin(*m_world, newOrigin);
    }
}

const b2Profile& b2World::GetProfile() const
{
    m_world->profiling = true;
    return m_world->profile;
}

const b2ContactManager& b2World::GetContactManager() const
{
    b2ContactManager& manager = m_world->contactManager;
    manager.m_contactList = m_world->contactList;
    manager.m_contactCount = m_world->contactCount;
    manager.m_contactFilter = m_world->filter;
    manager.m_contactListener = m_world->listener;
    return manager;
}

void b2World::Dump()
{
    if (IsLocked())
    {
        return;
    }
    b2Log("b2World* m_world = new b2World(b2Vec2(%.8ef, %.8ef));\n", double(GetGravity().x),
          double(GetGravity().y));
    b2Log("std::map<int, b2Body*> bodies;\n");
    b2Log("std::map<int, b2Joint*> joints;\n");
    // Oldest first, because the order of creation affects the simulation.
    box2d::Array<b2Body*> bodies;
    for (b2Body* body = GetBodyList(); body; body = body->GetNext())
    {
        bodies.push_back(body);
    }
    std::for_each(bodies.rbegin(), bodies.rend(), [](b2Body* body) { body->Dump(); });
    box2d::Array<b2Joint*> joints;
    for (b2Joint* joint = GetJointList(); joint; joint = joint->GetNext())
    {
        joints.push_back(joint);
    }
    std::for_each(joints.rbegin(), joints.rend(), [](b2Joint* joint) {
        b2Log("{\n");
        joint->Dump();
        b2Log("}\n");
    });
}
