// SPDX-License-Identifier: MIT
#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <cstdarg>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

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
static_assert(Is<void (b2World::*)(float32)>(&b2World::SetRestitutionThreshold));
static_assert(Is<float32 (b2World::*)() const>(&b2World::GetRestitutionThreshold));
static_assert(std::is_same_v<decltype(b2ContactManager::m_broadPhase), b2BroadPhase>);
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

std::string s_misuse;

TEST(PublicApi, ReportsMisuseToTheFunctionThatIsSet)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    s_misuse.clear();
    b2SetMisuse([](const char* sentence, const char*, int) { s_misuse = sentence; });
    world.Step(-1.0f, 8, 3);
    EXPECT_NE(s_misuse.find("time step"), std::string::npos);
    world.SetSubStepCount(0);
    EXPECT_EQ(world.GetSubStepCount(), 1);
    EXPECT_EQ(s_misuse.find("time step"), std::string::npos);
    s_misuse.clear();
    b2SetMisuse(nullptr);
    world.SetSubStepCount(2);
    EXPECT_EQ(s_misuse, "");
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

TEST(ContactManager, MatchesTheWorld)
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

/// Numbers of proxies that a query or ray meets.
struct Met
{
    bool QueryCallback(int32 proxyId)
    {
        proxies.push_back(proxyId);
        return int32(proxies.size()) < maximum;
    }
    float32 RayCastCallback(const b2RayCastInput& input, int32 proxyId)
    {
        proxies.push_back(proxyId);
        const b2AABB& box = broadPhase->GetFatAABB(proxyId);
        b2RayCastOutput output;
        nearest = box.RayCast(&output, input) ? output.fraction : input.maxFraction;
        return nearest;
    }

    const b2BroadPhase* broadPhase = nullptr;
    int32 maximum = 1000;
    float32 nearest = 1.0f;
    std::vector<int32> proxies;
};

/// A static, a kinematic and a dynamic circle of radius 1 every 4 m along x, in turn.
struct RowOfCircles
{
    RowOfCircles() : world(b2Vec2(0.0f, 0.0f))
    {
        b2CircleShape circle;
        circle.m_radius = 1.0f;
        for (int32 i = 0; i < 9; ++i)
        {
            b2BodyDef def;
            def.type = b2BodyType(i % 3);
            def.position.Set(4.0f * float32(i), 0.0f);
            fixtures.push_back(world.CreateBody(&def)->CreateFixture(&circle, 1.0f));
        }
        world.Step(1.0f / 60.0f, 8, 3);
    }
    const b2BroadPhase& BroadPhase() const { return world.GetContactManager().m_broadPhase; }

    b2World world;
    std::vector<b2Fixture*> fixtures;
};

b2AABB BoxOf(float32 lower, float32 upper)
{
    b2AABB box;
    box.lowerBound.Set(lower, -1.0f);
    box.upperBound.Set(upper, 1.0f);
    return box;
}

TEST(WorldBroadPhase, HasABoxForEachFixture)
{
    const RowOfCircles row;
    const b2BroadPhase& broadPhase = row.BroadPhase();
    EXPECT_EQ(broadPhase.GetProxyCount(), 9);
    EXPECT_EQ(broadPhase.GetTreeHeight(), row.world.GetTreeHeight());
    EXPECT_EQ(broadPhase.GetTreeHeight(), 2) << "three leaves";
    EXPECT_EQ(broadPhase.GetTreeBalance(), row.world.GetTreeBalance());
    EXPECT_EQ(broadPhase.GetTreeQuality(), row.world.GetTreeQuality());
    Met met;
    broadPhase.Query(&met, BoxOf(-10.0f, 100.0f));
    ASSERT_EQ(met.proxies.size(), 9u);
    for (const int32 id : met.proxies)
    {
        const auto* proxy = static_cast<b2FixtureProxy*>(broadPhase.GetUserData(id));
        EXPECT_EQ(proxy->proxyId, id);
        EXPECT_EQ(broadPhase.GetFatAABB(id).lowerBound, proxy->fixture->GetAABB(0).lowerBound);
        EXPECT_EQ(broadPhase.GetFatAABB(id).upperBound, proxy->fixture->GetAABB(0).upperBound);
        EXPECT_TRUE(broadPhase.TestOverlap(id, id));
    }
    EXPECT_FALSE(broadPhase.TestOverlap(met.proxies[0], met.proxies[1]));
}

TEST(WorldBroadPhase, FindsTheBoxesThatABoxOverlaps)
{
    const RowOfCircles row;
    Met met;
    row.BroadPhase().Query(&met, BoxOf(2.0f, 14.0f)); // the second to the fourth: one of each kind
    std::vector<const b2Fixture*> found;
    for (const int32 id : met.proxies)
    {
        found.push_back(static_cast<b2FixtureProxy*>(row.BroadPhase().GetUserData(id))->fixture);
    }
    EXPECT_EQ(std::set<const b2Fixture*>(found.begin(), found.end()),
              std::set<const b2Fixture*>(row.fixtures.begin() + 1, row.fixtures.begin() + 4));
    Met one;
    one.maximum = 1;
    row.BroadPhase().Query(&one, BoxOf(-10.0f, 100.0f));
    EXPECT_EQ(one.proxies.size(), 1u) << "no other tree is asked once a callback has said stop";
}

TEST(WorldBroadPhase, ClipsARayInAllTrees)
{
    const RowOfCircles row;
    Met met;
    met.broadPhase = &row.BroadPhase();
    b2RayCastInput input;
    input.p1.Set(2.5f, 0.0f); // between the first and the second, which is kinematic
    input.p2.Set(-7.0f, 0.0f);
    input.maxFraction = 1.0f;
    row.BroadPhase().RayCast(&met, input);
    ASSERT_EQ(met.proxies.size(), 1u) << "the first circle, which is static";
    EXPECT_NEAR(met.nearest, 1.5f / 9.5f, 0.02f);
    Met cut;
    cut.broadPhase = &row.BroadPhase();
    input.p1.Set(-5.0f, 0.0f);
    input.p2.Set(35.0f, 0.0f);
    row.BroadPhase().RayCast(&cut, input);
    EXPECT_NEAR(cut.nearest, 0.1f, 0.01f) << "the nearest of all";
    EXPECT_LT(cut.proxies.size(), 4u) << "what lies behind it is not looked at in other trees";
}

TEST(WorldBroadPhase, ShowsTheWorldAfterARestore)
{
    RowOfCircles row;
    const std::vector<uint8> bytes = b2SaveSnapshot(row.world);
    ASSERT_EQ(b2RestoreSnapshot(row.world, bytes), nullptr);
    EXPECT_EQ(row.BroadPhase().GetProxyCount(), 9);
    EXPECT_EQ(row.BroadPhase().GetTreeHeight(), 2);
}

// ---- Names of 2.4

TEST(NamesOf24, DoWhatThoseOf23Do)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(1.0f, 2.0f);
    b2Body* body = world.CreateBody(&def);
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    circle.m_p.Set(0.5f, 0.0f); // off the origin: the centre of mass counts
    body->CreateFixture(&circle, 1.0f);
    body->ApplyLinearImpulseToCenter(b2Vec2(0.0f, 3.0f * body->GetMass()), true);
    EXPECT_FLOAT_EQ(body->GetLinearVelocity().y, 3.0f);
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    body->SetAwake(false);
    body->ApplyLinearImpulseToCenter(b2Vec2(0.0f, 1.0f), false);
    EXPECT_EQ(body->GetLinearVelocity().y, 0.0f);
    body->SetEnabled(false);
    EXPECT_FALSE(body->IsEnabled());
    EXPECT_FALSE(body->IsActive());
    body->SetEnabled(true);
    EXPECT_TRUE(body->IsActive());

    struct Circles : b2Draw
    {
        void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
        void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
        void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
        void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override
        {
            ++count;
        }
        void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override {}
        void DrawTransform(const b2Transform&) override {}
        int count = 0;
    } draw;
    draw.SetFlags(b2Draw::e_shapeBit);
    world.SetDebugDraw(&draw);
    world.DebugDraw();
    EXPECT_EQ(draw.count, 1);
}

} // namespace
