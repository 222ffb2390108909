// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <set>
#include <vector>

namespace
{

/// Lets a listener hear a stage for as long as both live.
template <class Listener>
struct Heard : public manual::Stage
{
    explicit Heard(const b2Vec2& gravity = b2Vec2(0.0f, -10.0f)) : manual::Stage(gravity)
    {
        world.SetContactListener(&listener);
    }
    ~Heard() { world.SetContactListener(nullptr); }
    Listener listener;
};

struct Actor
{
    int hits = 0;
};

TEST(ContactsListing, WalksOverContacts)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Ground();
    b2Body* box = stage.Box(0.0f, 0.515f);
    b2Body* upper = stage.Box(0.0f, 1.53f);
    Actor actor;
    upper->SetUserData(&actor);
    stage.Run(0.1f);

    int touching = 0;
    // [walk]
    for (b2Contact* c = world.GetContactList(); c; c = c->GetNext())
    {
        if (c->IsTouching()) // else only their boxes overlap
        {
            ++touching;
        }
    }
    for (b2ContactEdge* e = box->GetContactList(); e; e = e->next)
    {
        // e->contact, and e->other: the other body
        if (auto* hit = static_cast<Actor*>(e->other->GetUserData()))
        {
            ++hit->hits;
        }
    }
    // [/walk]
    EXPECT_EQ(touching, 2);
    EXPECT_EQ(actor.hits, 1);
}

TEST(ContactsListing, ReadsAContact)
{
    manual::Stage stage;
    stage.Ground();
    stage.Box(0.0f, 0.515f);
    stage.Run(1.0f);
    b2Contact* contact = stage.world.GetContactList();
    float32 force = 0.0f;
    // [read]
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold); // normal from fixture A to fixture B
    for (int32 i = 0; i < contact->GetManifold()->pointCount; ++i)
    {
        const b2ManifoldPoint& point = contact->GetManifold()->points[i];
        force += 60.0f * point.normalImpulse; // over the time step: the force there [N]
    }
    // [/read]
    EXPECT_NEAR(force, 10.0f, 0.05f) << "the weight of 1 kg";
    EXPECT_NEAR(b2Abs(manifold.normal.y), 1.0f, 1e-5f);
    EXPECT_NEAR(manifold.points[0].y, 0.0075f, 0.002f) << "midway between the surfaces";
}

// [listener]
class Listener : public b2ContactListener
{
public:
    void BeginContact(b2Contact*) override { ++begun; }
    void EndContact(b2Contact*) override { ++ended; }
    void PreSolve(b2Contact*, const b2Manifold*) override { ++before; }
    void PostSolve(b2Contact*, const b2ContactImpulse*) override { ++after; }

    int begun = 0, ended = 0, before = 0, after = 0;
};
// [/listener]

TEST(ContactsListing, HearsFourEvents)
{
    Heard<Listener> stage;
    stage.Ground();
    b2Body* ball = stage.Ball(0.0f, 0.505f);
    stage.Run(0.1f); // six steps
    EXPECT_EQ(stage.listener.begun, 1);
    EXPECT_EQ(stage.listener.before, 6);
    EXPECT_EQ(stage.listener.after, 6);
    stage.world.DestroyBody(ball);
    EXPECT_EQ(stage.listener.ended, 1);
}

// [one-way]
/// Stops what comes from above and lets through what comes from below.
class OneWay : public b2ContactListener
{
public:
    const b2Fixture* platform = nullptr;

private:
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        const bool isA = contact->GetFixtureA() == platform; // either may be it
        if (isA || contact->GetFixtureB() == platform)
        {
            b2WorldManifold manifold;
            contact->GetWorldManifold(&manifold);
            const b2Vec2 away = isA ? manifold.normal : -manifold.normal;
            const b2Fixture* other = isA ? contact->GetFixtureB() : contact->GetFixtureA();
            if (away.y < 0.5f || other->GetBody()->GetLinearVelocity().y > 0.5f)
            {
                contact->SetEnabled(false); // until the next step, which asks again
            }
        }
    }
};
// [/one-way]

TEST(ContactsListing, LetsThroughFromBelow)
{
    for (const float32 start : {-2.0f, 2.0f})
    {
        Heard<OneWay> stage;
        b2Body* platform = stage.Box(0.0f, 0.0f, 3.0f, 0.1f, b2_staticBody);
        stage.listener.platform = platform->GetFixtureList();
        b2Body* ball = stage.Ball(0.0f, start, 0.25f);
        ball->SetLinearVelocity(b2Vec2(0.0f, start < 0.0f ? 9.0f : 0.0f));
        stage.Run(3.0f);
        EXPECT_NEAR(ball->GetPosition().y, 0.355f, 0.005f) << "it has come to rest on top";
    }
}

// [sound]
/// Remembers how hard things hit, for sounds to be played after the step.
class Impacts : public b2ContactListener
{
public:
    std::vector<float32> speeds; // [m/s]

private:
    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override
    {
        b2PointState before[b2_maxManifoldPoints], now[b2_maxManifoldPoints];
        b2GetPointStates(before, now, oldManifold, contact->GetManifold());
        if (now[0] != b2_addState)
        {
            return; // touched before
        }
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        const b2Vec2 point = manifold.points[0];
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        const float32 speed = b2Dot(a->GetLinearVelocityFromWorldPoint(point) -
                                        b->GetLinearVelocityFromWorldPoint(point),
                                    manifold.normal);
        if (speed > 1.0f)
        {
            speeds.push_back(speed);
        }
    }
};
// [/sound]

TEST(ContactsListing, HearsHowHardThingsHit)
{
    Heard<Impacts> stage;
    stage.Ground();
    b2Body* ball = stage.Ball(0.0f, 5.5f);
    stage.Run(2.0f);
    ball->SetLinearVelocity(b2Vec2(0.0f, -3.0f)); // it lies there already
    stage.Run(0.1f);
    ASSERT_EQ(stage.listener.speeds.size(), 1u);
    EXPECT_NEAR(stage.listener.speeds[0], 10.0f, 0.3f);
}

// [damage]
/// Collects what has been hit too hard.
class Damage : public b2ContactListener
{
public:
    std::set<b2Body*> broken; // a set, for a body may be hit by several in one step

private:
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        for (int32 i = 0; i < impulse->count; ++i)
        {
            if (impulse->normalImpulses[i] > 3.0f) // [N s]
            {
                broken.insert(contact->GetFixtureA()->GetBody());
                broken.insert(contact->GetFixtureB()->GetBody());
            }
        }
    }
};
// [/damage]

TEST(ContactsListing, BreaksThingsAfterTheStep)
{
    Heard<Damage> stage;
    b2World& world = stage.world;
    Damage& damage = stage.listener;
    b2Body* ground = stage.Ground();
    stage.Box(0.0f, 5.0f);
    for (int i = 0; i < 120; ++i)
    {
        // [after-step]
        world.Step(1.0f / 60.0f, 8, 3);
        for (b2Body* body : damage.broken)
        {
            if (body->GetType() == b2_dynamicBody)
            {
                world.DestroyBody(body);
            }
        }
        damage.broken.clear(); // at once: these pointers are good until something is destroyed
        // [/after-step]
    }
    EXPECT_EQ(world.GetBodyList(), ground) << "1 kg at 10 m/s";
    EXPECT_EQ(world.GetBodyCount(), 1);
}

// [filter]
/// Ghosts pass through doors; all else goes by the filters of the fixtures.
class Doors : public b2ContactFilter
{
public:
    const b2Fixture* door = nullptr;
    const b2Body* ghost = nullptr;

private:
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override
    {
        const bool meet = (fixtureA == door && fixtureB->GetBody() == ghost) ||
                          (fixtureB == door && fixtureA->GetBody() == ghost);
        return !meet && b2ContactFilter::ShouldCollide(fixtureA, fixtureB);
    }
};
// [/filter]

TEST(ContactsListing, FiltersByAFunction)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* door = stage.Box(3.0f, 0.0f, 0.1f, 5.0f, b2_staticBody);
    b2Body* ghost = stage.Ball(0.0f, 0.0f, 0.3f);
    b2Body* guest = stage.Ball(0.0f, 2.0f, 0.3f);
    Doors doors;
    // [set-filter]
    doors.door = door->GetFixtureList();
    doors.ghost = ghost;
    world.SetContactFilter(&doors); // has to live as long as the world, or be replaced by nullptr
    // [/set-filter]
    ghost->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    guest->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    stage.Run(2.0f);
    EXPECT_GT(ghost->GetPosition().x, 5.0f);
    EXPECT_LT(guest->GetPosition().x, 3.0f);
    world.SetContactFilter(nullptr);
}

// [usual-filter]
/// The same rule as that of b2ContactFilter.
class Usual : public b2ContactFilter
{
public:
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override
    {
        const b2Filter a = fixtureA->GetFilterData();
        const b2Filter b = fixtureB->GetFilterData();
        if (a.groupIndex == b.groupIndex && a.groupIndex != 0)
        {
            return a.groupIndex > 0; // one group: always or never
        }
        return (a.maskBits & b.categoryBits) != 0 && (b.maskBits & a.categoryBits) != 0;
    }
};
// [/usual-filter]

TEST(ContactsListing, FiltersAsTheEngineDoesUnlessToldOtherwise)
{
    manual::Stage stage;
    b2Fixture* a = stage.Ball(0.0f, 0.0f)->GetFixtureList();
    b2Fixture* b = stage.Ball(0.0f, 0.0f)->GetFixtureList();
    b2ContactFilter engine;
    Usual usual;
    int collide = 0;
    for (int i = 0; i < 1024; ++i)
    {
        b2Filter filter;
        filter.categoryBits = uint16(i & 3);
        filter.maskBits = uint16(i >> 2 & 3);
        filter.groupIndex = int16((i >> 8) % 3 - 1);
        a->SetFilterData(filter);
        filter.categoryBits = uint16(i >> 4 & 3);
        filter.maskBits = uint16(i >> 6 & 3);
        b->SetFilterData(filter);
        EXPECT_EQ(usual.ShouldCollide(a, b), engine.ShouldCollide(a, b)) << i;
        collide += engine.ShouldCollide(a, b) ? 1 : 0;
    }
    EXPECT_GT(collide, 100);
    EXPECT_LT(collide, 900);
}

class Belt : public b2ContactListener
{
public:
    const b2Fixture* belt = nullptr;

private:
    // [belt]
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        if (contact->GetFixtureA() == belt || contact->GetFixtureB() == belt)
        {
            contact->SetTangentSpeed(2.0f); // on its top to the right [m/s]
        }
    }
    // [/belt]
};

TEST(ContactsListing, CarriesThingsOnABelt)
{
    Heard<Belt> stage;
    stage.listener.belt = stage.Ground()->GetFixtureList();
    b2Body* box = stage.Box(0.0f, 0.515f);
    b2Body* ball = stage.Ball(5.0f, 0.505f);
    ball->SetFixedRotation(true);
    stage.Run(3.0f);
    EXPECT_NEAR(box->GetLinearVelocity().x, 2.0f, 0.01f);
    EXPECT_NEAR(ball->GetLinearVelocity().x, 2.0f, 0.01f);
}

struct Total : public b2ContactListener
{
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override
    {
        ++calls;
        for (int32 i = 0; i < impulse->count; ++i)
        {
            sum += impulse->normalImpulses[i];
        }
    }
    int calls = 0;
    float32 sum = 0.0f;
};

TEST(ContactsListing, TellsTheImpulsesOfAWholeStep)
{
    for (const int32 subSteps : {1, 4})
    {
        Heard<Total> stage;
        stage.world.SetSubStepCount(subSteps);
        stage.Ground();
        b2Body* box = stage.Box(0.0f, 0.515f);
        box->SetSleepingAllowed(false);
        stage.Run(1.0f);
        stage.listener = Total();
        stage.Run(1.0f);
        EXPECT_EQ(stage.listener.calls, 60);
        EXPECT_NEAR(stage.listener.sum, 10.0f, 0.1f);
    }
}

} // namespace
