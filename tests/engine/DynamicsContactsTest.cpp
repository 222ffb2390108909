// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

/// Contact events, materials, filters and sensors.
namespace
{

using namespace dynamics;

/// Records a letter for each event (b begin, e end, p pre-solve, q post-solve) and a bar between
/// steps.
struct Recorder : b2ContactListener
{
    void BeginContact(b2Contact* contact) override
    {
        text += 'b';
        lastA = contact->GetFixtureA()->GetBody();
        touchedAtBegin = contact->IsTouching();
    }
    void EndContact(b2Contact*) override { text += 'e'; }
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        text += 'p';
        if (preSolve)
        {
            preSolve(*contact);
        }
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        text += 'q';
        EXPECT_EQ(impulse->count, contact->GetManifold()->pointCount);
        normalImpulse = 0.0f;
        for (int32 i = 0; i < impulse->count; ++i)
        {
            normalImpulse += impulse->normalImpulses[i];
        }
    }
    std::string Take() { return std::exchange(text, ""); }

    std::string text;
    b2Body* lastA = nullptr;
    bool touchedAtBegin = false;
    float32 normalImpulse = 0.0f;
    std::function<void(b2Contact&)> preSolve;
};

TEST(DynamicsContactEvents, ComeInOrderAndOnceAStep)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    scene.Step();
    EXPECT_EQ(events.Take(), "bpq");
    EXPECT_TRUE(events.touchedAtBegin);
    scene.Step();
    EXPECT_EQ(events.Take(), "pq");
    EXPECT_NEAR(events.normalImpulse, 10.0f * kStep, 0.02f) << "it carries the weight";
    box->SetTransform(b2Vec2(0.0f, 3.0f), 0.0f);
    EXPECT_EQ(events.Take(), "") << "not before the next step";
    scene.Step();
    EXPECT_EQ(events.Take(), "e");
    scene.Step();
    EXPECT_EQ(events.Take(), "");
}

TEST(DynamicsContactEvents, StopWhileTheBodiesSleep)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.515f);
    scene.Step(120);
    ASSERT_FALSE(box->IsAwake());
    events.Take();
    scene.Step(10);
    EXPECT_EQ(events.Take(), "");
    EXPECT_TRUE(box->GetContactList()->contact->IsTouching());
    box->SetAwake(true);
    scene.Step();
    EXPECT_EQ(events.Take(), "pq") << "it never ceased to touch";
}

TEST(DynamicsContactEvents, EndOutsideAStepWhenABodyOrFixtureGoes)
{
    for (const int way : {0, 1, 2, 3})
    {
        Scene scene;
        Recorder events;
        scene.world.SetContactListener(&events);
        scene.Ground();
        b2Body* box = scene.Box(0.0f, 0.505f);
        scene.Step();
        events.Take();
        switch (way)
        {
        case 0:
            scene.world.DestroyBody(box);
            break;
        case 1:
            box->DestroyFixture(box->GetFixtureList());
            break;
        case 2:
            box->SetActive(false);
            break;
        default:
            box->SetType(b2_kinematicBody);
            break;
        }
        EXPECT_EQ(events.Take(), "e") << way;
        EXPECT_EQ(scene.world.GetContactCount(), 0);
        scene.Step(3);
        EXPECT_EQ(events.Take(), "") << way;
    }
}

TEST(DynamicsContactEvents, AreNotSentWhenTheWorldIsDestroyed)
{
    Recorder events;
    {
        Scene scene;
        scene.world.SetContactListener(&events);
        scene.Ground();
        scene.Box(0.0f, 0.505f);
        scene.Step();
        events.Take();
    }
    EXPECT_EQ(events.Take(), "");
}

TEST(DynamicsContactEvents, EndInTheStepAfterTheFilterChanged)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    scene.Step();
    events.Take();
    b2Filter filter;
    filter.maskBits = 0;
    box->GetFixtureList()->SetFilterData(filter);
    EXPECT_EQ(events.Take(), "");
    EXPECT_EQ(scene.world.GetContactCount(), 1);
    scene.Step();
    EXPECT_EQ(events.Take(), "e");
    EXPECT_EQ(scene.world.GetContactCount(), 0);
    box->GetFixtureList()->SetFilterData(b2Filter());
    EXPECT_EQ(scene.world.GetContactCount(), 0);
    scene.Step();
    EXPECT_EQ(events.Take().substr(0, 2), "bp");
}

TEST(DynamicsContactEvents, NameTheOlderBodyFirst)
{
    for (const bool groundFirst : {false, true})
    {
        Scene scene;
        Recorder events;
        scene.world.SetContactListener(&events);
        b2Body* older = groundFirst ? scene.Ground() : scene.Box(0.0f, 0.505f);
        groundFirst ? scene.Box(0.0f, 0.505f) : scene.Ground();
        scene.Step();
        EXPECT_EQ(events.lastA, older);
    }
}

TEST(DynamicsContactEvents, DisableAContactForOneStepOnly)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    int disabled = 0;
    events.preSolve = [&](b2Contact& contact) {
        EXPECT_TRUE(contact.IsEnabled());
        contact.SetEnabled(false);
        ++disabled;
    };
    scene.Step(5);
    EXPECT_EQ(events.Take(), "bppppp") << "no post-solve";
    EXPECT_EQ(disabled, 5);
    EXPECT_NEAR(box->GetLinearVelocity().y, -50.0f * kStep, 1e-4f) << "free fall";
    events.preSolve = nullptr;
    scene.Step();
    EXPECT_EQ(events.Take(), "pq");
    EXPECT_GE(box->GetLinearVelocity().y, -1e-3f);
}

TEST(DynamicsContactEvents, MakeAPlatformOneSidedWhenDisabled)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    b2Body* platform = scene.Body(b2_staticBody, 0.0f, 2.0f);
    Scene::AddBox(platform, 3.0f, 0.1f);
    b2Body* ball = scene.Ball(0.0f, 0.0f, 0.2f);
    ball->SetLinearVelocity(b2Vec2(0.0f, 12.0f));
    const b2Body* platformBody = platform;
    events.preSolve = [&](b2Contact& contact) {
        const b2Body* other = contact.GetFixtureA()->GetBody() == platformBody
                                  ? contact.GetFixtureB()->GetBody()
                                  : contact.GetFixtureA()->GetBody();
        contact.SetEnabled(other->GetPosition().y - 0.2f > 2.05f);
    };
    float32 highest = 0.0f;
    for (int i = 0; i < 240; ++i)
    {
        scene.Step();
        highest = b2Max(highest, ball->GetPosition().y);
    }
    EXPECT_GT(highest, 5.0f);
    EXPECT_NEAR(ball->GetPosition().y, 2.3f, 0.02f);
}

TEST(DynamicsContactEvents, MayChangeVelocities)
{
    struct Kicker : b2ContactListener
    {
        void PostSolve(b2Contact* contact, const b2ContactImpulse*) override
        {
            contact->GetFixtureB()->GetBody()->SetLinearVelocity(b2Vec2(0.0f, 7.0f));
        }
    };
    Scene scene;
    Kicker kicker;
    scene.world.SetContactListener(&kicker);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    scene.Step();
    EXPECT_EQ(box->GetLinearVelocity(), b2Vec2(0.0f, 7.0f));
}

// ---- Materials

constexpr float32 kGravity = 10.0f;

/// A world whose gravity is turned instead of the ground: a slope without rounding of its corners.
b2Vec2 GravityOnSlope(float32 angle)
{
    return kGravity * b2Vec2(std::sin(angle), -std::cos(angle));
}

// s = (g sin a - mu g cos a) t^2 / 2
TEST(DynamicsFriction, SlidesABoxDownASlopeByTheClosedForm)
{
    constexpr float32 angle = 0.5f;
    Scene scene(GravityOnSlope(angle));
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
    Scene::AddBox(ground, 100.0f, 1.0f, 0.3f);
    b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 0.515f);
    Scene::AddBox(box, 0.5f, 0.5f, 0.3f);
    scene.Step(120);
    const float32 acceleration = kGravity * (std::sin(angle) - 0.3f * std::cos(angle));
    EXPECT_NEAR(box->GetPosition().x, 0.5f * acceleration * 4.0f,
                0.02f * 0.5f * acceleration * 4.0f);
    EXPECT_NEAR(box->GetLinearVelocity().x, acceleration * 2.0f, 0.05f);
}

TEST(DynamicsFriction, HoldsABoxUpToTheAngleOfRepose)
{
    for (const float32 mu : {0.2f, 0.5f, 1.0f})
    {
        const float32 repose = std::atan(mu);
        for (const float32 share : {0.95f, 1.05f})
        {
            Scene scene(GravityOnSlope(share * repose));
            b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
            Scene::AddBox(ground, 100.0f, 1.0f, mu);
            b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 0.115f);
            Scene::AddBox(box, 0.5f, 0.1f, mu);
            scene.Step(120);
            if (share < 1.0f)
            {
                EXPECT_NEAR(box->GetPosition().x, 0.0f, 0.01f) << mu;
            }
            else
            {
                EXPECT_GT(box->GetPosition().x, 0.1f) << mu;
            }
        }
    }
}

TEST(DynamicsFriction, MixesByTheGeometricMeanUntilOverridden)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
    Scene::AddBox(ground, 50.0f, 1.0f, 0.9f);
    b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 0.515f);
    Scene::AddBox(box, 0.5f, 0.5f, 0.4f);
    scene.Step();
    b2Contact* contact = box->GetContactList()->contact;
    EXPECT_NEAR(contact->GetFriction(), 0.6f, 1e-6f);
    contact->SetFriction(0.0f);
    box->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    scene.Step(30);
    EXPECT_NEAR(box->GetLinearVelocity().x, 1.0f, 1e-5f);
    contact->ResetFriction();
    EXPECT_NEAR(contact->GetFriction(), 0.6f, 1e-6f);
    scene.Step(30);
    EXPECT_NEAR(box->GetLinearVelocity().x, 0.0f, 1e-3f);
}

TEST(DynamicsFriction, MovesABodyAtTheTangentSpeed)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.515f);
    events.preSolve = [](b2Contact& contact) { contact.SetTangentSpeed(2.0f); };
    scene.Step(180);
    EXPECT_NEAR(b2Abs(box->GetLinearVelocity().x), 2.0f, 1e-3f);
    EXPECT_TRUE(box->IsAwake());
}

/// The speed after a ball has hit the ground at the given speed.
float32 SpeedAfterBounce(float32 speed, float32 restitutionBall, float32 restitutionGround)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
    Scene::AddBox(ground, 50.0f, 1.0f, 0.2f, restitutionGround);
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 1.0f);
    Scene::AddBall(ball, 0.5f, 0.2f, restitutionBall);
    ball->SetLinearVelocity(b2Vec2(0.0f, -speed));
    scene.Step(int(60.0f / speed) + 10);
    return ball->GetLinearVelocity().y;
}

TEST(DynamicsRestitution, IsTheLargerOfTheTwo)
{
    EXPECT_NEAR(SpeedAfterBounce(5.0f, 0.0f, 0.0f), 0.0f, 1e-4f);
    EXPECT_NEAR(SpeedAfterBounce(5.0f, 1.0f, 0.0f), 5.0f, 1e-4f);
    EXPECT_NEAR(SpeedAfterBounce(5.0f, 0.5f, 0.25f), 2.5f, 1e-4f);
    EXPECT_NEAR(SpeedAfterBounce(5.0f, 0.25f, 0.5f), 2.5f, 1e-4f);
    EXPECT_NEAR(SpeedAfterBounce(60.0f, 1.0f, 1.0f), 60.0f, 1e-3f) << "also when it is fast";
}

TEST(DynamicsRestitution, IsIgnoredBelowTheThreshold)
{
    EXPECT_NEAR(SpeedAfterBounce(0.95f * b2_velocityThreshold, 1.0f, 1.0f), 0.0f, 1e-4f);
    EXPECT_NEAR(SpeedAfterBounce(1.05f * b2_velocityThreshold, 1.0f, 1.0f), 1.05f, 1e-4f);
}

TEST(DynamicsRestitution, CanBeOverriddenInPreSolve)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Recorder events;
    scene.world.SetContactListener(&events);
    events.preSolve = [](b2Contact& contact) { contact.SetRestitution(0.5f); };
    scene.Ground();
    b2Body* ball = scene.Ball(0.0f, 1.0f);
    ball->SetLinearVelocity(b2Vec2(0.0f, -4.0f));
    scene.Step(20);
    EXPECT_NEAR(ball->GetLinearVelocity().y, 2.0f, 1e-4f);
}

TEST(DynamicsRestitution, ExchangesTheSpeedsOfEqualBalls)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* moving = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2Body* resting = scene.Body(b2_dynamicBody, 2.0f, 0.0f);
    Scene::AddBall(moving, 0.5f, 0.0f, 1.0f);
    Scene::AddBall(resting, 0.5f, 0.0f, 1.0f);
    moving->SetLinearVelocity(b2Vec2(6.0f, 0.0f));
    scene.Step(30);
    EXPECT_NEAR(moving->GetLinearVelocity().x, 0.0f, 1e-4f);
    EXPECT_NEAR(resting->GetLinearVelocity().x, 6.0f, 1e-4f);
}

// ---- Filters

/// Do two overlapping fixtures with these filters, on bodies of these types, get a contact?
bool Meet(const b2Filter& one, const b2Filter& another, b2BodyType typeOne = b2_dynamicBody,
          b2BodyType typeOther = b2_dynamicBody, bool sensors = false)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* bodies[2] = {scene.Body(typeOne, 0.0f, 0.0f), scene.Body(typeOther, 0.3f, 0.0f)};
    const b2Filter* filters[2] = {&one, &another};
    b2CircleShape shape;
    shape.m_radius = 0.5f;
    for (int i = 0; i < 2; ++i)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.filter = *filters[i];
        def.isSensor = sensors;
        bodies[i]->CreateFixture(&def);
    }
    scene.Step();
    const bool meet = scene.world.GetContactCount() == 1;
    EXPECT_TRUE(!meet || scene.world.GetContactList()->IsTouching());
    return meet;
}

b2Filter Filter(int category, int mask, int group)
{
    b2Filter filter;
    filter.categoryBits = uint16(category);
    filter.maskBits = uint16(mask);
    filter.groupIndex = int16(group);
    return filter;
}

TEST(DynamicsFilters, NeedBothMasksToHaveTheOthersCategory)
{
    for (int i = 0; i < 16; ++i)
    {
        const int categoryA = 1 << (i % 4);
        const int maskA = i * 37 % 16;
        for (int j = 0; j < 16; ++j)
        {
            const int categoryB = 1 << (j % 3);
            const int maskB = j * 23 % 16;
            EXPECT_EQ(Meet(Filter(categoryA, maskA, 0), Filter(categoryB, maskB, 0)),
                      (categoryA & maskB) != 0 && (categoryB & maskA) != 0);
        }
    }
}

TEST(DynamicsFilters, LetGroupsDecideBeforeCategories)
{
    EXPECT_TRUE(Meet(Filter(1, 0, 2), Filter(1, 0, 2))) << "a positive group always collides";
    EXPECT_FALSE(Meet(Filter(1, 1, -8), Filter(1, 1, -8))) << "a negative group never does";
    EXPECT_TRUE(Meet(Filter(1, 1, -8), Filter(1, 1, -7))) << "different groups: by category";
    EXPECT_FALSE(Meet(Filter(1, 0, 2), Filter(1, 1, 3)));
    EXPECT_TRUE(Meet(Filter(1, 1, 2), Filter(1, 1, 0)));
}

TEST(DynamicsFilters, NeedADynamicBodyAlsoForSensors)
{
    const b2BodyType types[] = {b2_staticBody, b2_kinematicBody, b2_dynamicBody};
    for (const b2BodyType a : types)
    {
        for (const b2BodyType b : types)
        {
            const bool oneIsDynamic = a == b2_dynamicBody || b == b2_dynamicBody;
            EXPECT_EQ(Meet(b2Filter(), b2Filter(), a, b, false), oneIsDynamic);
            EXPECT_EQ(Meet(b2Filter(), b2Filter(), a, b, true), oneIsDynamic);
        }
    }
}

TEST(DynamicsFilters, CallTheFilterOfTheProgram)
{
    struct Picky : b2ContactFilter
    {
        bool ShouldCollide(b2Fixture* a, b2Fixture* b) override
        {
            ++asked;
            return a->GetUserData() == nullptr && b->GetUserData() == nullptr;
        }
        int asked = 0;
    };
    Scene scene;
    Picky filter;
    scene.world.SetContactFilter(&filter);
    scene.Ground();
    b2Body* through = scene.Box(0.0f, 0.505f);
    b2Body* held = scene.Box(5.0f, 0.505f);
    through->GetFixtureList()->SetUserData(&filter);
    scene.Step(30);
    EXPECT_GT(filter.asked, 0);
    EXPECT_LT(through->GetPosition().y, 0.0f);
    EXPECT_NEAR(held->GetPosition().y, 0.5f, 0.02f);
    scene.world.SetContactFilter(nullptr);
    scene.Step(30);
    EXPECT_NEAR(held->GetPosition().y, 0.5f, 0.02f);
}

TEST(DynamicsFilters, LetJoinedBodiesCollideIfTheirJointAllowsIt)
{
    for (const bool collide : {false, true})
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        b2Body* a = scene.Ball(0.0f, 0.0f);
        b2Body* b = scene.Ball(0.6f, 0.0f);
        scene.Step();
        ASSERT_EQ(scene.world.GetContactCount(), 1);
        b2RevoluteJointDef def;
        def.Initialize(a, b, b2Vec2(0.3f, 0.0f));
        def.collideConnected = collide;
        b2Joint* joint = scene.world.CreateJoint(&def);
        EXPECT_EQ(scene.world.GetContactCount(), 1) << "not before the next step";
        scene.Step();
        EXPECT_EQ(scene.world.GetContactCount(), collide ? 1 : 0);
        scene.world.DestroyJoint(joint);
        scene.Step();
        EXPECT_EQ(scene.world.GetContactCount(), 1);
    }
}

TEST(DynamicsFilters, LetNoBodiesCollideIfOneOfTwoJointsForbidsIt)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Ball(0.0f, 0.0f);
    b2Body* b = scene.Ball(0.6f, 0.0f);
    b2RevoluteJointDef def;
    def.Initialize(b, a, b2Vec2(0.3f, 0.0f));
    b2Joint* strict = scene.world.CreateJoint(&def);
    def.collideConnected = true;
    scene.world.CreateJoint(&def);
    scene.Step();
    EXPECT_EQ(scene.world.GetContactCount(), 0);
    scene.world.DestroyJoint(strict);
    scene.Step();
    EXPECT_EQ(scene.world.GetContactCount(), 1);
}

// ---- Sensors

TEST(DynamicsSensors, ReportContactsButDoNotPush)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Recorder events;
    scene.world.SetContactListener(&events);
    b2Body* gate = scene.Body(b2_staticBody, 2.0f, 0.0f);
    Scene::AddBox(gate, 0.5f, 2.0f)->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    scene.Step(100);
    EXPECT_EQ(events.Take(), "be");
    EXPECT_EQ(ball->GetLinearVelocity(), b2Vec2(3.0f, 0.0f));
}

TEST(DynamicsSensors, HaveNoContactPoints)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* gate = scene.Body(b2_staticBody, 0.2f, 0.0f);
    Scene::AddBox(gate, 0.5f, 2.0f)->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    scene.Step();
    ASSERT_NE(ball->GetContactList(), nullptr);
    EXPECT_TRUE(ball->GetContactList()->contact->IsTouching());
    EXPECT_EQ(ball->GetContactList()->contact->GetManifold()->pointCount, 0);
}

TEST(DynamicsSensors, CanBecomeSolidAndBackWhileTheyTouch)
{
    Scene scene;
    Recorder events;
    scene.world.SetContactListener(&events);
    b2Body* ground = scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    scene.Step(3);
    events.Take();
    ground->GetFixtureList()->SetSensor(true);
    EXPECT_EQ(WhyBroken(scene.world, false), "");
    scene.Step(3);
    EXPECT_EQ(events.Take(), "") << "it still touches";
    EXPECT_LT(box->GetLinearVelocity().y, 0.0f);
    ground->GetFixtureList()->SetSensor(false);
    EXPECT_EQ(WhyBroken(scene.world, false), "");
    scene.Step(60);
    EXPECT_EQ(events.Take().substr(0, 4), "pqpq");
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 0.02f);
}

/// What the world says of each contact, compared with its shapes where they were when the contacts
/// were updated. Contacts that are apart are not computed again until a point may have come near.
struct TouchCheck
{
    void Note(b2World& world)
    {
        before.clear();
        for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            before[body] = body->GetTransform();
        }
    }

    void Compare(b2World& world)
    {
        for (b2Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext())
        {
            const b2Transform xfA = before.at(c->GetFixtureA()->GetBody());
            const b2Transform xfB = before.at(c->GetFixtureB()->GetBody());
            const bool nearly = Touch(*c, xfA, xfB, 0.0005f);
            if (nearly != Touch(*c, xfA, xfB, -0.0005f))
            {
                continue; // rounding decides
            }
            nearly ? ++touching : ++apart;
            ASSERT_EQ(c->IsTouching(), nearly);
        }
    }

    /// With the skin of B larger by `more` [m].
    static bool Touch(b2Contact& c, const b2Transform& xfA, const b2Transform& xfB, float32 more)
    {
        b2Manifold manifold;
        const b2Shape& a = *c.GetFixtureA()->GetShape();
        if (c.GetFixtureB()->GetType() == b2Shape::e_polygon)
        {
            b2PolygonShape b = static_cast<const b2PolygonShape&>(*c.GetFixtureB()->GetShape());
            b.m_radius += more;
            b2CollidePolygons(&manifold, static_cast<const b2PolygonShape*>(&a), xfA, &b, xfB);
            return manifold.pointCount > 0;
        }
        b2CircleShape b = static_cast<const b2CircleShape&>(*c.GetFixtureB()->GetShape());
        b.m_radius += more;
        if (a.GetType() == b2Shape::e_circle)
        {
            b2CollideCircles(&manifold, static_cast<const b2CircleShape*>(&a), xfA, &b, xfB);
        }
        else
        {
            b2CollidePolygonAndCircle(&manifold, static_cast<const b2PolygonShape*>(&a), xfA, &b,
                                      xfB);
        }
        return manifold.pointCount > 0;
    }

    std::map<const b2Body*, b2Transform> before;
    int touching = 0;
    int apart = 0;
};

TEST(DynamicsContacts, TouchExactlyWhenTheirShapesDo)
{
    Scene scene;
    scene.world.SetGravity(b2Vec2(0.0f, -2.0f));
    scene.world.SetAllowSleeping(false);
    scene.world.SetContinuousPhysics(false); // impacts update contacts at other poses
    scene.Ground();
    for (int i = 0; i < 40; ++i) // rods that turn, with their centres of mass beside their origins
    {
        b2Body* body = scene.Body(b2_dynamicBody, float32(i % 8) - 4.0f, 1.0f + float32(i / 8));
        if (i % 4 == 0)
        {
            b2CircleShape circle;
            circle.m_p.Set(0.2f, 0.1f);
            circle.m_radius = 0.15f;
            body->CreateFixture(&circle, 1.0f);
        }
        else
        {
            b2PolygonShape rod;
            rod.SetAsBox(0.05f + 0.1f * float32(i % 3), 0.1f, b2Vec2(0.2f, 0.1f),
                         0.3f * float32(i));
            body->CreateFixture(&rod, 1.0f);
        }
        body->SetAngularVelocity(float32(i % 11) - 5.0f);
        body->SetLinearVelocity(b2Vec2(float32(i % 7) - 3.0f, 0.0f));
    }
    TouchCheck check;
    for (int i = 0; i < 600; ++i)
    {
        check.Note(scene.world);
        scene.Step();
        check.Compare(scene.world);
        ASSERT_FALSE(HasFatalFailure()) << i;
    }
    EXPECT_GT(check.touching, 1000);
    EXPECT_GT(check.apart, 1000);
}

} // namespace
