// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

/// The chapter about the world, section by section.
namespace
{

using dynamics::kStep;
using dynamics::Scene;

TEST(CreatingAWorld, SetsGravityAndSleepingInTheListing)
{
    const b2Vec2 gravity(0.0f, -10.0f);
    for (bool doSleep : {true, false})
    {
        b2World* myWorld = new b2World(gravity, doSleep);
        EXPECT_EQ(myWorld->GetGravity(), gravity);
        EXPECT_EQ(myWorld->GetAllowSleeping(), doSleep);
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.gravityScale = 0.0f;
        b2Body* body = myWorld->CreateBody(&def);
        Scene::AddBall(body, 0.5f);
        for (int i = 0; i < 60; ++i)
        {
            myWorld->Step(kStep, 8, 3);
        }
        EXPECT_EQ(body->IsAwake(), !doSleep);
        delete myWorld;
    }
}

TEST(Simulation, StepsTheWorldInTheListing)
{
    Scene scene;
    b2World* myWorld = &scene.world;
    b2Body* body = scene.Box(0.0f, 0.0f);
    float32 timeStep = 1.0f / 60.f;
    int32 velocityIterations = 10;
    int32 positionIterations = 8;
    myWorld->Step(timeStep, velocityIterations, positionIterations);
    EXPECT_NEAR(body->GetLinearVelocity().y, -10.0f / 60.0f, 1e-6f);
    EXPECT_NEAR(body->GetPosition().y, -10.0f / 3600.0f, 1e-6f);
}

TEST(Simulation, CollidesABodyCreatedBeforeTheStep)
{
    Scene scene;
    scene.Ground();
    scene.Step();
    b2Body* box = scene.Box(0.0f, 0.5f);
    EXPECT_EQ(box->GetContactList(), nullptr);
    scene.Step();
    ASSERT_NE(box->GetContactList(), nullptr);
    EXPECT_TRUE(box->GetContactList()->contact->IsTouching());
}

/// Returns the maximum gap of a hanging chain's hinges in two seconds.
float32 WorstGap(float32 hz, int32 iterations)
{
    Scene scene;
    b2Body* previous = scene.Body(b2_staticBody, 0.0f, 0.0f);
    std::vector<b2Joint*> joints;
    for (int i = 0; i < 12; ++i)
    {
        b2Body* link = scene.Box(0.5f + float32(i), 0.0f, 0.5f, 0.125f);
        b2RevoluteJointDef def;
        def.Initialize(previous, link, b2Vec2(float32(i), 0.0f));
        joints.push_back(scene.world.CreateJoint(&def));
        previous = link;
    }
    float32 worst = 0.0f;
    for (int i = 0; i < int(2.0f * hz); ++i)
    {
        scene.world.Step(1.0f / hz, iterations, 3);
        for (b2Joint* joint : joints)
        {
            worst = b2Max(worst, b2Distance(joint->GetAnchorA(), joint->GetAnchorB()));
        }
    }
    return worst;
}

TEST(Simulation, ImprovesWithIterationsAndMoreWithSmallSteps)
{
    EXPECT_LT(WorstGap(60.0f, 20), WorstGap(60.0f, 5));
    EXPECT_LT(WorstGap(60.0f, 10), 0.8f * WorstGap(30.0f, 20));
}

TEST(ExploringTheWorld, WakesAllBodiesInTheListing)
{
    Scene scene;
    b2World* myWorld = &scene.world;
    scene.Ground();
    const std::vector<b2Body*> boxes = {scene.Box(0.0f, 0.5f), scene.Box(5.0f, 0.5f)};
    scene.Step(120);
    ASSERT_TRUE(dynamics::AllAwake(boxes, false));
    for (b2Body* b = myWorld->GetBodyList(); b; b = b->GetNext())
    {
        b->SetAwake(true);
    }
    EXPECT_TRUE(dynamics::AllAwake(boxes, true));
}

struct GameActor
{
    bool IsDead() const { return dead; }
    bool dead = false;
    std::vector<b2Body*> friends;
};

/// Bodies with actors of which every other is dead.
struct Crowd : public Scene
{
    Crowd() : actors(10)
    {
        for (int i = 0; i < 10; ++i)
        {
            b2Body* body = Box(2.0f * float32(i), 0.0f);
            actors[i].dead = i % 2 == 0;
            body->SetUserData(&actors[i]);
        }
    }

    int Alive()
    {
        int alive = 0;
        for (b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            EXPECT_FALSE(((GameActor*)b->GetUserData())->IsDead());
            ++alive;
        }
        return alive;
    }

    std::vector<GameActor> actors;
};

TEST(ExploringTheWorld, DestroysDeadActorsInTheWalkOfTheListing)
{
    Crowd crowd;
    b2World* myWorld = &crowd.world;
    b2Body* node = myWorld->GetBodyList();
    while (node)
    {
        b2Body* b = node;
        node = node->GetNext();
        GameActor* myActor = (GameActor*)b->GetUserData();
        if (myActor->IsDead())
        {
            myWorld->DestroyBody(b);
        }
    }
    EXPECT_EQ(crowd.Alive(), 5);
    crowd.Step();
}

/// Destroys the body and its actor's friends; true when there were any.
bool GameCrazyBodyDestroyer(b2Body* body)
{
    b2World* world = body->GetWorld();
    const std::vector<b2Body*> friends = ((GameActor*)body->GetUserData())->friends;
    world->DestroyBody(body);
    for (b2Body* other : friends)
    {
        world->DestroyBody(other);
    }
    return !friends.empty();
}

TEST(ExploringTheWorld, RestartsAtTheFirstBodyInTheLastListing)
{
    Crowd crowd;
    b2World* myWorld = &crowd.world;
    // The first that is met takes the one that would be next with it.
    b2Body* first = myWorld->GetBodyList();
    while (!((GameActor*)first->GetUserData())->IsDead())
    {
        first = first->GetNext();
    }
    ((GameActor*)first->GetUserData())->friends = {first->GetNext()};

    b2Body* node = myWorld->GetBodyList();
    while (node)
    {
        b2Body* b = node;
        node = node->GetNext();
        GameActor* myActor = (GameActor*)b->GetUserData();
        if (myActor->IsDead())
        {
            bool otherBodiesDestroyed = GameCrazyBodyDestroyer(b);
            if (otherBodiesDestroyed)
            {
                node = myWorld->GetBodyList();
            }
        }
    }
    EXPECT_EQ(crowd.Alive(), 4);
}

/// The listing: wakes the bodies it finds.
class MyQueryCallback : public b2QueryCallback
{
public:
    bool ReportFixture(b2Fixture* fixture) override
    {
        b2Body* body = fixture->GetBody();
        body->SetAwake(true);
        found.insert(body);
        // Go on to the next fixture.
        return true;
    }
    std::set<b2Body*> found;
};

TEST(AABBQueries, WakeTheBodiesInARegionInTheListing)
{
    Scene scene;
    b2World* myWorld = &scene.world;
    scene.Ground();
    b2Body* inside = scene.Box(0.0f, 0.5f);
    b2Body* outside = scene.Box(10.0f, 0.5f);
    scene.Step(120);
    ASSERT_FALSE(inside->IsAwake() || outside->IsAwake());

    MyQueryCallback callback;
    b2AABB aabb;
    aabb.lowerBound.Set(-1.0f, -1.0f);
    aabb.upperBound.Set(1.0f, 1.0f);
    myWorld->Query(&callback, aabb);
    EXPECT_TRUE(inside->IsAwake());
    EXPECT_FALSE(outside->IsAwake());
    EXPECT_EQ(callback.found.size(), 2u) << "the box and the ground";
}

TEST(AABBQueries, EndWhenTheCallbackReturnsFalse)
{
    struct First : public b2QueryCallback
    {
        bool ReportFixture(b2Fixture*) override
        {
            ++count;
            return false;
        }
        int count = 0;
    };
    Scene scene;
    for (int i = 0; i < 5; ++i)
    {
        scene.Box(float32(i), 0.0f);
    }
    First callback;
    b2AABB aabb;
    aabb.lowerBound.Set(-10.0f, -10.0f);
    aabb.upperBound.Set(10.0f, 10.0f);
    scene.world.QueryAABB(&callback, aabb);
    EXPECT_EQ(callback.count, 1);
}

/// The listing: of all hits it keeps the nearest.
class MyRayCastCallback : public b2RayCastCallback
{
public:
    MyRayCastCallback() { m_fixture = NULL; }

    float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override
    {
        m_fixture = fixture;
        m_point = point;
        m_normal = normal;
        m_fraction = fraction;
        return fraction;
    }

    b2Fixture* m_fixture;
    b2Vec2 m_point;
    b2Vec2 m_normal;
    float32 m_fraction;
};

TEST(RayCasts, CaptureTheClosestHitInTheListing)
{
    Scene scene;
    b2World* myWorld = &scene.world;
    b2Body* far = scene.Box(2.5f, 0.75f, 0.25f, 0.5f);
    b2Body* near = scene.Box(1.0f, 0.5f, 0.5f, 0.5f);

    MyRayCastCallback callback;
    b2Vec2 point1(-1.0f, 0.0f);
    b2Vec2 point2(3.0f, 1.0f);
    myWorld->RayCast(&callback, point1, point2);
    ASSERT_EQ(callback.m_fixture, near->GetFixtureList());
    EXPECT_NEAR(callback.m_fraction, 1.5f / 4.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(callback.m_point, b2Vec2(0.5f, 0.375f)), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(callback.m_normal, b2Vec2(-1.0f, 0.0f)), 0.0f, 1e-6f);

    MyRayCastCallback back;
    myWorld->RayCast(&back, point2, point1);
    EXPECT_EQ(back.m_fixture, far->GetFixtureList());
}

/// Answers every hit with the same number, unless it is the one to ignore.
struct Answering : public b2RayCastCallback
{
    explicit Answering(float32 what, const b2Body* ignored = nullptr)
        : answer(what), ignore(ignored)
    {}
    float32 ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&,
                          float32 fraction) override
    {
        ++hits;
        if (fixture->GetBody() == ignore)
        {
            return -1.0f;
        }
        nearest = fixture->GetBody();
        return answer < 0.0f ? fraction : answer;
    }
    float32 answer;
    const b2Body* ignore;
    const b2Body* nearest = nullptr;
    int hits = 0;
};

TEST(RayCasts, EndAtZeroContinueAtOneAndIgnoreAtMinusOne)
{
    Scene scene;
    b2Body* first = scene.Box(0.0f, 0.0f);
    b2Body* second = scene.Box(3.0f, 0.0f);
    scene.Box(6.0f, 0.0f);
    const b2Vec2 from(-5.0f, 0.0f), to(10.0f, 0.0f);
    Answering any(0.0f), all(1.0f), behind(-1.0f, first);
    scene.world.RayCast(&any, from, to);
    scene.world.RayCast(&all, from, to);
    scene.world.RayCast(&behind, from, to);
    EXPECT_EQ(any.hits, 1);
    EXPECT_EQ(all.hits, 3);
    EXPECT_EQ(behind.nearest, second);
}

TEST(ForcesAndImpulses, WakeTheBodyUnlessTheCallerForbidsIt)
{
    Scene scene;
    scene.Ground();
    b2Body* myBody = scene.Box(0.0f, 0.5f);
    const b2Vec2 myForce(0.1f, 0.0f);
    scene.Step(120);
    ASSERT_FALSE(myBody->IsAwake());
    const b2Vec2 myPoint = myBody->GetWorldCenter();
    if (myBody->IsAwake() == true)
    {
        myBody->ApplyForce(myForce, myPoint);
    }
    EXPECT_FALSE(myBody->IsAwake());
    myBody->ApplyForce(myForce, myPoint, false);
    EXPECT_FALSE(myBody->IsAwake());
    myBody->ApplyForce(myForce, myPoint, true);
    EXPECT_TRUE(myBody->IsAwake());
    for (int i = 0; i < 4; ++i)
    {
        myBody->SetAwake(false);
        switch (i)
        {
        case 0:
            myBody->ApplyForce(myForce, myPoint);
            break;
        case 1:
            myBody->ApplyTorque(0.1f);
            break;
        case 2:
            myBody->ApplyLinearImpulse(myForce, myPoint);
            break;
        default:
            myBody->ApplyAngularImpulse(0.1f);
            break;
        }
        EXPECT_TRUE(myBody->IsAwake()) << i;
    }
}

TEST(CoordinateTransformations, GoFromTheBodyToTheWorldAndBack)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 1.0f, 2.0f, 0.5f * b2_pi);
    const b2Vec2 local(3.0f, 0.0f);
    EXPECT_NEAR(b2Distance(body->GetWorldPoint(local), b2Vec2(1.0f, 5.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(body->GetWorldVector(local), b2Vec2(0.0f, 3.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(body->GetLocalPoint(b2Vec2(1.0f, 5.0f)), local), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(body->GetLocalVector(b2Vec2(0.0f, 3.0f)), local), 0.0f, 1e-5f);
}

struct MyFixtureData
{
    int visits = 0;
};

TEST(Lists, HoldFixturesJointsAndContactsOfABody)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* body = scene.Box(0.0f, 0.5f);
    Scene::AddBall(body, 0.25f);
    MyFixtureData counted;
    for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
    {
        f->SetUserData(&counted);
    }
    b2MotorJointDef def;
    def.Initialize(ground, body);
    def.collideConnected = true;
    b2Joint* joint = scene.world.CreateJoint(&def);
    scene.Step();

    for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
    {
        MyFixtureData* data = (MyFixtureData*)f->GetUserData();
        ++data->visits;
    }
    EXPECT_EQ(counted.visits, 2);
    ASSERT_NE(body->GetJointList(), nullptr);
    EXPECT_EQ(body->GetJointList()->joint, joint);
    EXPECT_EQ(body->GetJointList()->other, ground);
    EXPECT_EQ(body->GetJointList()->next, nullptr);
    ASSERT_NE(body->GetContactList(), nullptr);
    EXPECT_EQ(body->GetContactList()->other, ground);
}

} // namespace
