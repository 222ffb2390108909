// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// The contact listener's four events and the contact filter, section by section.
namespace
{

using dynamics::Scene;

/// The listing of the section, which logs its calls.
class MyContactListener : public b2ContactListener
{
public:
    void BeginContact(b2Contact* contact) override
    { /* handle begin event */
        log += contact->IsTouching() ? 'B' : '?';
    }
    void EndContact(b2Contact* contact) override
    { /* handle end event */
        log += contact->GetFixtureA() ? 'E' : '?';
    }
    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override
    { /* handle pre-solve event */
        log += contact->GetManifold()->pointCount > 0 && oldManifold ? 'S' : '?';
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    { /* handle post-solve event */
        log += impulse->count == contact->GetManifold()->pointCount ? 'P' : '?';
    }

    std::string log;
};

/// A listener that is registered for its life.
template <class Listener>
struct Heard : public Scene
{
    explicit Heard(const b2Vec2& gravity = b2Vec2(0.0f, -10.0f)) : Scene(gravity)
    {
        world.SetContactListener(&listener);
    }
    ~Heard() { world.SetContactListener(nullptr); }
    Listener listener;
};

TEST(ContactListener, ReceivesTheFourEventsInOrderInTheListing)
{
    Heard<MyContactListener> scene;
    b2Body* ground = scene.Ground();
    b2Body* ball = scene.Ball(0.0f, 0.505f);
    scene.Step(2);
    EXPECT_EQ(scene.listener.log, "BSPSP");
    ball->SetTransform(b2Vec2(0.0f, 3.0f), 0.0f);
    scene.listener.log.clear();
    scene.Step();
    EXPECT_EQ(scene.listener.log, "E");
    EXPECT_EQ(ground->GetContactList(), nullptr);
}

TEST(ContactListener, NeedsNoneOfItsFunctions)
{
    struct Silent : public b2ContactListener
    {};
    Heard<Silent> scene;
    scene.Ground();
    scene.Box(0.0f, 0.5f);
    scene.Step(3);
    EXPECT_EQ(scene.world.GetContactCount(), 1);
}

TEST(BeginContactEvent, ComesForSensorsToo)
{
    Heard<MyContactListener> scene;
    b2Body* zone = scene.Body(b2_staticBody, 0.0f, 0.0f);
    Scene::AddBox(zone, 1.0f, 1.0f)->SetSensor(true);
    scene.Ball(0.0f, 0.0f);
    EXPECT_EQ(scene.listener.log, "");
    scene.Step();
    EXPECT_EQ(scene.listener.log, "B");
}

TEST(EndContactEvent, ComesOutsideAStepWhenABodyIsDestroyed)
{
    Heard<MyContactListener> scene;
    scene.Ground();
    b2Body* zone = scene.Body(b2_staticBody, 0.0f, 0.0f);
    Scene::AddBox(zone, 1.0f, 1.0f)->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 0.505f);
    scene.Step();
    scene.listener.log.clear();
    scene.world.DestroyBody(ball);
    EXPECT_EQ(scene.listener.log, "EE") << "of the solid contact and of the sensor's";
}

/// The listing: a platform that lets pass what comes from below.
struct OneSided : public b2ContactListener
{
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        b2WorldManifold worldManifold;
        contact->GetWorldManifold(&worldManifold);
        ++asked;
        if (worldManifold.normal.y < -0.5f)
        {
            contact->SetEnabled(false);
        }
    }
    int asked = 0;
};

/// Returns the position of a ball one second after it was thrown at a fixed platform from y.
float32 ThrownAtAPlatform(float32 y, float32 speed)
{
    Heard<OneSided> scene;
    Scene::AddBox(scene.Body(b2_staticBody, 0.0f, 0.0f), 3.0f, 0.1f);
    b2Body* ball = scene.Ball(0.0f, y, 0.25f);
    ball->SetLinearVelocity(b2Vec2(0.0f, speed));
    scene.Step(60);
    return ball->GetPosition().y;
}

TEST(PreSolveEvent, MakesAPlatformOneSidedInTheFirstListing)
{
    EXPECT_NEAR(ThrownAtAPlatform(1.5f, 0.0f), 0.35f, 0.02f) << "from above it is solid";
    EXPECT_GT(ThrownAtAPlatform(-1.5f, 9.0f), 1.5f) << "from below it is not";
}

TEST(PreSolveEvent, EnablesTheContactAgainInEveryStep)
{
    struct Once : public b2ContactListener
    {
        void PreSolve(b2Contact* contact, const b2Manifold*) override
        {
            EXPECT_TRUE(contact->IsEnabled());
            if (++asked == 1)
            {
                contact->SetEnabled(false);
            }
        }
        void PostSolve(b2Contact*, const b2ContactImpulse*) override { ++solved; }
        int asked = 0;
        int solved = 0;
    };
    Heard<Once> scene;
    scene.Ground();
    scene.Ball(0.0f, 0.5f);
    scene.Step(3);
    EXPECT_EQ(scene.listener.asked, 3);
    EXPECT_EQ(scene.listener.solved, 2);
}

TEST(PreSolveEvent, MayComeSeveralTimesAStepForContinuousCollision)
{
    Heard<MyContactListener> scene(b2Vec2_zero);
    scene.Wall(0.0f);
    b2Body* ball = scene.Ball(-1.0f, 0.0f, 0.1f);
    ball->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
    scene.Step(2);
    EXPECT_NE(scene.listener.log.find("BS"), std::string::npos);
    EXPECT_LT(ball->GetPosition().x, 0.0f);
}

/// The second listing: the speed of approach when a point is added.
struct SoundListener : public b2ContactListener
{
    void MyPlayCollisionSound(float32 speed) { played.push_back(speed); }

    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override
    {
        b2WorldManifold worldManifold;
        contact->GetWorldManifold(&worldManifold);

        b2PointState state1[2], state2[2];
        b2GetPointStates(state1, state2, oldManifold, contact->GetManifold());
        if (state2[0] == b2_addState)
        {
            const b2Body* bodyA = contact->GetFixtureA()->GetBody();
            const b2Body* bodyB = contact->GetFixtureB()->GetBody();
            b2Vec2 point = worldManifold.points[0];
            b2Vec2 vA = bodyA->GetLinearVelocityFromWorldPoint(point);
            b2Vec2 vB = bodyB->GetLinearVelocityFromWorldPoint(point);
            // The text subtracts the other way round, which is the speed of parting.
            float32 approachVelocity = b2Dot(vA - vB, worldManifold.normal);
            if (approachVelocity > 1.0f)
            {
                MyPlayCollisionSound(approachVelocity);
            }
        }
    }

    std::vector<float32> played;
};

TEST(PreSolveEvent, ReportsAnImpactAndItsSpeedInTheSecondListing)
{
    Heard<SoundListener> scene;
    scene.Ground();
    scene.Ball(0.0f, 5.5f);
    scene.Step(120);
    ASSERT_EQ(scene.listener.played.size(), 1u);
    EXPECT_NEAR(scene.listener.played[0], 10.0f, 0.3f);
}

TEST(PostSolveEvent, GathersTheImpulsesOfTheCollision)
{
    struct Gather : public b2ContactListener
    {
        void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
        {
            for (int32 i = 0; i < impulse->count; ++i)
            {
                total += impulse->normalImpulses[i];
                EXPECT_LE(b2Abs(impulse->tangentImpulses[i]),
                          contact->GetFriction() * impulse->normalImpulses[i] + 1e-6f);
            }
        }
        float32 total = 0.0f;
    };
    Heard<Gather> scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 3.0f);
    box->SetSleepingAllowed(false);
    scene.Step(120);
    // Over two seconds the ground gives what gravity took: the box rests again.
    EXPECT_NEAR(scene.listener.total, 2.0f * 10.0f * box->GetMass(), 0.4f);
}

TEST(PostSolveEvent, ComesWhileTheWorldIsLocked)
{
    struct Alters : public b2ContactListener
    {
        void PostSolve(b2Contact* contact, const b2ContactImpulse*) override
        {
            locked = contact->GetFixtureA()->GetBody()->GetWorld()->IsLocked();
        }
        bool locked = false;
    };
    Heard<Alters> scene;
    scene.Ground();
    scene.Box(0.0f, 0.5f);
    EXPECT_FALSE(scene.world.IsLocked());
    scene.Step(3);
    EXPECT_TRUE(scene.listener.locked);
}

struct ContactPoint
{
    b2Fixture* fixtureA;
    b2Fixture* fixtureB;
};

/// Buffers the contacts of a step, as the listing assumes.
struct BufferingListener : public b2ContactListener
{
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        m_points.push_back({contact->GetFixtureA(), contact->GetFixtureB()});
    }
    std::vector<ContactPoint> m_points;
};

/// The listing: destroys what touches something heavier, out of the buffer.
void DestroyTouchingBodies(b2World* m_world, ContactPoint* m_points, int32 m_pointCount)
{
    // A body with several contacts would be destroyed once for each, so the doomed are collected.
    const int32 k_maxNuke = 6;
    b2Body* nuke[k_maxNuke];
    int32 nukeCount = 0;

    // The lighter body of each contact is destroyed.
    for (int32 i = 0; i < m_pointCount; ++i)
    {
        ContactPoint* point = m_points + i;
        b2Body* bodyA = point->fixtureA->GetBody();
        b2Body* bodyB = point->fixtureB->GetBody();
        float32 massA = bodyA->GetMass();
        float32 massB = bodyB->GetMass();
        if (massA > 0.0f && massB > 0.0f)
        {
            if (massB > massA)
            {
                nuke[nukeCount++] = bodyA;
            }
            else
            {
                nuke[nukeCount++] = bodyB;
            }
            if (nukeCount == k_maxNuke)
            {
                break;
            }
        }
    }

    // Equal pointers stand side by side then.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds" // GCC 12 takes the branch for long arrays here too
#endif
    std::sort(nuke, nuke + nukeCount);
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

    // Each of them once.
    int32 i = 0;
    while (i < nukeCount)
    {
        b2Body* b = nuke[i++];
        while (i < nukeCount && nuke[i] == b)
        {
            ++i;
        }
        m_world->DestroyBody(b);
    }
}

TEST(PostSolveEvent, DestroysBodiesFromTheBufferInTheListing)
{
    Heard<BufferingListener> scene;
    scene.Ground();
    b2Body* heavy = scene.Box(0.0f, 2.0f, 2.0f, 0.5f);
    scene.Box(-1.0f, 0.5f);
    scene.Box(1.0f, 0.5f);
    int steps = 0;
    for (; steps < 120 && scene.world.GetBodyCount() > 2; ++steps)
    {
        scene.listener.m_points.clear();
        scene.Step();
        DestroyTouchingBodies(&scene.world, scene.listener.m_points.data(),
                              int32(scene.listener.m_points.size()));
    }
    EXPECT_LT(steps, 120);
    EXPECT_EQ(scene.world.GetBodyList(), heavy);
    scene.Step(60);
    EXPECT_NEAR(heavy->GetPosition().y, 0.5f + dynamics::kRestingGap, 0.01f);
}

/// The listing: what the engine does by itself.
class DefaultAsListed : public b2ContactFilter
{
public:
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override
    {
        const b2Filter& filterA = fixtureA->GetFilterData();
        const b2Filter& filterB = fixtureB->GetFilterData();
        if (filterA.groupIndex == filterB.groupIndex && filterA.groupIndex != 0)
        {
            return filterA.groupIndex > 0;
        }
        bool collide = (filterA.maskBits & filterB.categoryBits) != 0 &&
                       (filterA.categoryBits & filterB.maskBits) != 0;
        return collide;
    }
};

TEST(ContactFiltering, EqualsTheListingByDefault)
{
    Scene scene;
    b2Fixture* a = scene.Box(0.0f, 0.0f)->GetFixtureList();
    b2Fixture* b = scene.Box(0.5f, 0.0f)->GetFixtureList();
    DefaultAsListed listed;
    b2ContactFilter byDefault;
    const uint16 bits[3] = {0x0001, 0x0002, 0x0003};
    for (int i = 0; i < 3 * 3 * 3 * 3 * 9; ++i)
    {
        b2Filter filterA, filterB;
        filterA.categoryBits = bits[i % 3];
        filterA.maskBits = bits[i / 3 % 3];
        filterB.categoryBits = bits[i / 9 % 3];
        filterB.maskBits = bits[i / 27 % 3];
        filterA.groupIndex = int16(i / 81 % 3 - 1);
        filterB.groupIndex = int16(i / 243 - 1);
        a->SetFilterData(filterA);
        b->SetFilterData(filterB);
        EXPECT_EQ(byDefault.ShouldCollide(a, b), listed.ShouldCollide(a, b)) << i;
    }
}

TEST(ContactFiltering, FollowsTheFilterOfTheProgram)
{
    /// A door that opens for some and stays shut for others.
    class MyContactFilter : public b2ContactFilter
    {
    public:
        bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override
        {
            return !fixtureA->GetUserData() && !fixtureB->GetUserData();
        }
    };
    MyContactFilter filter;
    int key = 0;
    Scene scene(b2Vec2_zero);
    b2World* world = &scene.world;
    world->SetContactFilter(&filter);
    scene.Wall(0.0f);
    b2Body* guest = scene.Ball(-2.0f, -3.0f);
    b2Body* holder = scene.Ball(-2.0f, 3.0f);
    holder->GetFixtureList()->SetUserData(&key);
    guest->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    holder->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    scene.Step(60);
    EXPECT_LT(guest->GetPosition().x, 0.0f);
    EXPECT_NEAR(holder->GetPosition().x, 2.0f, 0.01f);
    world->SetContactFilter(nullptr);
}

} // namespace
