// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// The chapter about contacts up to the pre-solve event, section by section.
namespace
{

using dynamics::kStep;
using dynamics::Scene;

/// A world with a ground and a box that rests on it.
class RestingBox : public ::testing::Test
{
protected:
    RestingBox() { scene.Step(20); }

    b2Contact* Contact() { return myBody->GetContactList()->contact; }

    Scene scene;
    b2World* myWorld = &scene.world;
    b2Body* ground = scene.Ground();
    b2Body* myBody = scene.Box(0.0f, 0.5f + dynamics::kRestingGap);
};

using ContactsAbout = RestingBox;
using TouchingContact = RestingBox;
using ContactClass = RestingBox;
using AccessingContacts = RestingBox;

TEST_F(ContactsAbout, ExistForEachNearChildOfAChain)
{
    const b2Vec2 vs[6] = {{20.0f, 5.0f}, {21.0f, 5.0f}, {22.0f, 5.0f},
                          {23.0f, 5.0f}, {24.0f, 5.0f}, {25.0f, 5.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 6);
    scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&chain, 0.0f);
    b2Body* box = scene.Box(22.5f, 5.51f, 0.9f, 0.5f);
    scene.Step();
    std::vector<int32> children;
    for (b2ContactEdge* edge = box->GetContactList(); edge; edge = edge->next)
    {
        b2Contact* contact = edge->contact;
        const bool chainIsA = contact->GetFixtureA()->GetType() == b2Shape::e_chain;
        children.push_back(chainIsA ? contact->GetChildIndexA() : contact->GetChildIndexB());
    }
    std::sort(children.begin(), children.end());
    EXPECT_EQ(children, (std::vector<int32>{1, 2, 3}));
}

TEST_F(ContactsAbout, ExistWhileTheBoxesOverlap)
{
    // Two balls whose boxes overlap at the corners only.
    b2Body* first = scene.Ball(10.0f, 10.0f, 1.0f);
    b2Body* second = scene.Ball(11.6f, 11.6f, 1.0f);
    first->SetGravityScale(0.0f);
    second->SetGravityScale(0.0f);
    scene.Step();
    ASSERT_NE(first->GetContactList(), nullptr);
    EXPECT_FALSE(first->GetContactList()->contact->IsTouching());
    second->SetTransform(b2Vec2(14.0f, 14.0f), 0.0f);
    scene.Step();
    EXPECT_EQ(first->GetContactList(), nullptr) << "gone with the overlap";
}

TEST_F(TouchingContact, HasItsPointsWhereTheShapesTouch)
{
    b2WorldManifold worldManifold;
    Contact()->GetWorldManifold(&worldManifold);
    ASSERT_EQ(Contact()->GetManifold()->pointCount, 2);
    for (const b2Vec2& point : worldManifold.points)
    {
        EXPECT_NEAR(b2Abs(point.x), 0.5f, 0.02f);
        EXPECT_NEAR(point.y, 0.0f, 0.02f);
    }
}

TEST_F(TouchingContact, HasItsNormalFromTheFirstFixtureToTheSecond)
{
    b2WorldManifold worldManifold;
    Contact()->GetWorldManifold(&worldManifold);
    const b2Vec2 fromAToB = Contact()->GetFixtureB()->GetBody()->GetWorldCenter() -
                            Contact()->GetFixtureA()->GetBody()->GetWorldCenter();
    EXPECT_NEAR(worldManifold.normal.Length(), 1.0f, 1e-6f);
    EXPECT_GT(b2Dot(worldManifold.normal, fromAToB), 0.0f);
}

TEST_F(TouchingContact, HasNegativeSeparationWhereShapesOverlap)
{
    myBody->SetTransform(b2Vec2(0.0f, 0.45f), 0.0f);
    scene.Step();
    b2WorldManifold worldManifold;
    Contact()->GetWorldManifold(&worldManifold);
    EXPECT_LT(worldManifold.separations[0], 0.0f);
}

TEST_F(TouchingContact, HasTwoPointsForBoxesAndOneForABall)
{
    EXPECT_EQ(Contact()->GetManifold()->pointCount, 2);
    b2Body* ball = scene.Ball(5.0f, 0.5f);
    scene.Step(10);
    ASSERT_NE(ball->GetContactList(), nullptr);
    EXPECT_EQ(ball->GetContactList()->contact->GetManifold()->pointCount, 1);
}

TEST_F(TouchingContact, HasTheNormalImpulseOfTheForceInAStep)
{
    const b2Manifold* manifold = Contact()->GetManifold();
    const float32 impulse = manifold->points[0].normalImpulse + manifold->points[1].normalImpulse;
    EXPECT_NEAR(impulse, 10.0f * myBody->GetMass() * kStep, 1e-3f);
}

TEST_F(TouchingContact, HasTheTangentImpulseOfTheFrictionInAStep)
{
    const float32 pull = 1.5f; // newtons, less than friction can hold
    float32 impulse = 0.0f;
    for (int i = 0; i < 20; ++i)
    {
        myBody->ApplyForceToCenter(b2Vec2(pull, 0.0f));
        scene.Step();
        const b2Manifold* manifold = Contact()->GetManifold();
        impulse = manifold->points[0].tangentImpulse + manifold->points[1].tangentImpulse;
    }
    EXPECT_NEAR(b2Abs(impulse), pull * kStep, 1e-3f);
}

TEST_F(TouchingContact, KeepsTheIdsOfItsPointsInTheNextStep)
{
    const b2Manifold before = *Contact()->GetManifold();
    scene.Step();
    const b2Manifold* after = Contact()->GetManifold();
    ASSERT_EQ(after->pointCount, 2);
    EXPECT_NE(after->points[0].id.key, after->points[1].id.key);
    EXPECT_EQ(after->points[0].id.key, before.points[0].id.key);
    EXPECT_EQ(after->points[1].id.key, before.points[1].id.key);
    b2PointState state1[2], state2[2];
    b2GetPointStates(state1, state2, &before, after);
    EXPECT_EQ(state1[0], b2_persistState);
    EXPECT_EQ(state2[1], b2_persistState);
}

TEST_F(ContactClass, GivesTheRawManifoldAndTheWorldManifold)
{
    b2Contact* myContact = Contact();
    b2Manifold* manifold = myContact->GetManifold();
    const b2Manifold* same = const_cast<const b2Contact*>(myContact)->GetManifold();
    EXPECT_EQ(manifold, same);
    b2WorldManifold atRest, moved;
    myContact->GetWorldManifold(&atRest);
    ground->SetTransform(b2Vec2(3.0f, -1.0f), 0.0f);
    myBody->SetTransform(myBody->GetPosition() + b2Vec2(3.0f, 0.0f), 0.0f);
    myContact->GetWorldManifold(&moved);
    EXPECT_NEAR(moved.points[0].x, atRest.points[0].x + 3.0f, 1e-5f)
        << "from the present positions";
}

struct MyActor
{
    int hits = 0;
};

TEST_F(ContactClass, LeadsToAnActorInTheListing)
{
    MyActor onGround;
    ground->SetUserData(&onGround);
    b2Contact* myContact = Contact();

    b2Fixture* fixtureA = myContact->GetFixtureA();
    b2Body* bodyA = fixtureA->GetBody();
    MyActor* actorA = (MyActor*)bodyA->GetUserData();
    EXPECT_EQ(actorA, &onGround);
}

TEST_F(AccessingContacts, VisitsThoseOfWorldAndBodyInTheListings)
{
    scene.Box(0.0f, 1.5f + 2.0f * dynamics::kRestingGap);
    scene.Box(20.0f, 0.5f);
    scene.Step();
    int32 inWorld = 0, onBody = 0;
    for (b2Contact* c = myWorld->GetContactList(); c; c = c->GetNext())
    {
        // process c
        ++inWorld;
    }
    for (b2ContactEdge* ce = myBody->GetContactList(); ce; ce = ce->next)
    {
        b2Contact* c = ce->contact;
        // process c
        EXPECT_TRUE(c->GetFixtureA()->GetBody() == myBody || c->GetFixtureB()->GetBody() == myBody);
        ++onBody;
    }
    EXPECT_EQ(inWorld, myWorld->GetContactCount());
    EXPECT_EQ(inWorld, 3);
    EXPECT_EQ(onBody, 2);
}

struct CountBegins : public b2ContactListener
{
    void BeginContact(b2Contact* contact) override
    {
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        begun += a->IsBullet() || b->IsBullet();
    }
    int begun = 0;
};

TEST_F(AccessingContacts, GivesTheListenerContactsThatListsMiss)
{
    CountBegins listener;
    Scene space(b2Vec2_zero);
    space.world.SetContactListener(&listener);
    Scene::AddBox(space.Body(b2_staticBody, 0.0f, 0.0f), 0.05f, 5.0f, 0.0f, 1.0f);
    b2Body* bullet = space.Ball(-1.0f, 0.0f, 0.1f);
    bullet->GetFixtureList()->SetRestitution(1.0f);
    bullet->SetBullet(true);
    bullet->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    int listed = 0;
    for (int i = 0; i < 5; ++i)
    {
        space.Step();
        for (b2Contact* c = space.world.GetContactList(); c; c = c->GetNext())
        {
            listed += c->IsTouching();
        }
    }
    EXPECT_LT(bullet->GetLinearVelocity().x, -90.0f) << "it came back";
    EXPECT_EQ(listener.begun, 1);
    EXPECT_LE(listed, 1);
    space.world.SetContactListener(nullptr);
}

} // namespace
