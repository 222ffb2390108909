// SPDX-License-Identifier: MIT
#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <cstdarg>
#include <string>
#include <type_traits>

// The names and signatures that programs of the 2.3 generation rely on, and what the manual leaves
// to the headers. A signature is checked by the compiler: a changed one does not build.

namespace
{

template <typename Expected, typename Actual>
constexpr bool Is(Actual)
{
    return std::is_same_v<Expected, Actual>;
}

// ---- The world

static_assert(Is<void (b2World::*)(const b2Vec2&)>(&b2World::ShiftOrigin));
static_assert(Is<const b2Profile& (b2World::*)() const>(&b2World::GetProfile));
static_assert(Is<const b2ContactManager& (b2World::*)() const>(&b2World::GetContactManager));
static_assert(Is<void (b2World::*)()>(&b2World::Dump));
static_assert(Is<float32 (b2World::*)() const>(&b2World::GetTreeQuality));
static_assert(Is<int32 (b2World::*)() const>(&b2World::GetTreeHeight));
static_assert(Is<int32 (b2World::*)() const>(&b2World::GetTreeBalance));
static_assert(Is<int32 (b2World::*)() const>(&b2World::GetProxyCount));
static_assert(Is<void (b2World::*)(float32, int32, int32)>(&b2World::Step));
static_assert(Is<void (b2World::*)(b2QueryCallback*, const b2AABB&) const>(&b2World::QueryAABB));
static_assert(Is<void (b2World::*)(b2RayCastCallback*, const b2Vec2&, const b2Vec2&) const>(
    &b2World::RayCast));
static_assert(Is<void (b2World::*)(b2ContactFilter*)>(&b2World::SetContactFilter));
static_assert(Is<void (b2World::*)(b2ContactListener*)>(&b2World::SetContactListener));
static_assert(Is<void (b2World::*)(b2Draw*)>(&b2World::SetDebugDraw));
static_assert(Is<void (b2World::*)(bool)>(&b2World::SetSubStepping));
static_assert(std::is_same_v<b2Draw, b2DebugDraw>);

// ---- Bodies, fixtures, contacts

static_assert(Is<void (b2Body::*)()>(&b2Body::Dump));
static_assert(Is<void (b2Body::*)(b2MassData*) const>(&b2Body::GetMassData));
static_assert(Is<void (b2Body::*)(const b2MassData*)>(&b2Body::SetMassData));
static_assert(Is<void (b2Body::*)(b2BodyType)>(&b2Body::SetType));
static_assert(
    Is<b2Vec2 (b2Body::*)(const b2Vec2&) const>(&b2Body::GetLinearVelocityFromWorldPoint));
static_assert(
    Is<b2Vec2 (b2Body::*)(const b2Vec2&) const>(&b2Body::GetLinearVelocityFromLocalPoint));
static_assert(Is<bool (b2Fixture::*)(b2RayCastOutput*, const b2RayCastInput&, int32) const>(
    &b2Fixture::RayCast));
static_assert(Is<const b2AABB& (b2Fixture::*)(int32) const>(&b2Fixture::GetAABB));
static_assert(Is<void (b2Fixture::*)(int32)>(&b2Fixture::Dump));
static_assert(Is<void (b2Fixture::*)()>(&b2Fixture::Refilter));
static_assert(Is<void (b2Contact::*)(b2WorldManifold*) const>(&b2Contact::GetWorldManifold));
static_assert(Is<void (b2Contact::*)(float32)>(&b2Contact::SetTangentSpeed));
static_assert(Is<void (b2Contact::*)(b2Manifold*, const b2Transform&, const b2Transform&)>(
    &b2Contact::Evaluate));

// ---- Collision by itself

static_assert(Is<void (*)(b2PointState*, b2PointState*, const b2Manifold*, const b2Manifold*)>(
    &b2GetPointStates));
static_assert(Is<int32 (*)(b2ClipVertex*, const b2ClipVertex*, const b2Vec2&, float32, int32)>(
    &b2ClipSegmentToLine));
static_assert(Is<void (*)(b2TOIOutput*, const b2TOIInput*)>(&b2TimeOfImpact));
static_assert(Is<void (*)(b2DistanceOutput*, b2SimplexCache*, const b2DistanceInput*)>(
    static_cast<void (*)(b2DistanceOutput*, b2SimplexCache*, const b2DistanceInput*)>(
        &b2Distance)));
static_assert(Is<void (b2DistanceProxy::*)(const b2Shape*, int32)>(&b2DistanceProxy::Set));
static_assert(Is<int32 (b2DistanceProxy::*)(const b2Vec2&) const>(&b2DistanceProxy::GetSupport));
static_assert(Is<b2Shape* (b2Shape::*)(b2BlockAllocator*) const>(&b2Shape::Clone));
static_assert(Is<void (b2Shape::*)(b2MassData*, float32) const>(&b2Shape::ComputeMass));
static_assert(Is<int32 (b2DynamicTree::*)(const b2AABB&, void*)>(&b2DynamicTree::CreateProxy));
static_assert(
    Is<bool (b2DynamicTree::*)(int32, const b2AABB&, const b2Vec2&)>(&b2DynamicTree::MoveProxy));
static_assert(Is<int32 (b2BroadPhase::*)(const b2AABB&, void*)>(&b2BroadPhase::CreateProxy));

// ---- Common

static_assert(Is<void* (*)(int32)>(&b2Alloc));
static_assert(Is<void (*)(void*)>(&b2Free));
static_assert(Is<void (*)(const char*, ...)>(&b2Log));
static_assert(Is<void* (b2BlockAllocator::*)(int32)>(&b2BlockAllocator::Allocate));
static_assert(Is<void (b2BlockAllocator::*)(void*, int32)>(&b2BlockAllocator::Free));
static_assert(Is<void* (b2StackAllocator::*)(int32)>(&b2StackAllocator::Allocate));
static_assert(Is<int32 (b2StackAllocator::*)() const>(&b2StackAllocator::GetMaxAllocation));
static_assert(Is<void (b2Timer::*)()>(&b2Timer::Reset));
static_assert(Is<float32 (b2Timer::*)() const>(&b2Timer::GetMilliseconds));
static_assert(Is<b2Vec2 (b2Mat22::*)(const b2Vec2&) const>(&b2Mat22::Solve));
static_assert(Is<b2Vec3 (b2Mat33::*)(const b2Vec3&) const>(&b2Mat33::Solve33));
static_assert(Is<void (b2Sweep::*)(b2Transform*, float32) const>(&b2Sweep::GetTransform));
static_assert(b2_version.major == 2 && b2_version.minor == 3);

// ---- What the dumps say

std::string s_log;

void Collect(const char* text)
{
    s_log += text;
}

TEST(PublicApi, DumpsEveryPartOfAWorld)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef groundDef;
    b2Body* ground = world.CreateBody(&groundDef);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 2.0f);
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(0.0f, 4.0f);
    b2Body* body = world.CreateBody(&bodyDef);
    body->CreateFixture(&box, 3.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, body, b2Vec2(0.0f, 4.0f));
    world.CreateJoint(&hinge);
    s_log.clear();
    b2SetLog(Collect);
    world.Dump();
    b2SetLog(nullptr);
    EXPECT_NE(s_log.find("b2World* m_world = new b2World(b2Vec2("), std::string::npos);
    EXPECT_NE(s_log.find("b2RevoluteJointDef jd"), std::string::npos);
    EXPECT_NE(s_log.find("b2PolygonShape shape"), std::string::npos);
    EXPECT_LT(s_log.find("bodies[0]"), s_log.find("bodies[1]"));
}

TEST(PublicApi, TheContactManagerSaysWhatTheWorldSays)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2ContactListener listener;
    b2ContactFilter filter;
    world.SetContactListener(&listener);
    world.SetContactFilter(&filter);
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int32 i = 0; i < 3; ++i)
    {
        def.position.Set(1.5f * float32(i), 0.0f);
        world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
    }
    world.Step(1.0f / 60.0f, 8, 3);
    const b2ContactManager& manager = world.GetContactManager();
    EXPECT_EQ(manager.m_contactCount, 2);
    EXPECT_EQ(manager.m_contactList, world.GetContactList());
    EXPECT_EQ(manager.m_contactListener, &listener);
    EXPECT_EQ(manager.m_contactFilter, &filter);
}

} // namespace
