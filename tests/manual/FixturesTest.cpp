// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// The chapter about fixtures, section by section; sensors have a file of their own.
namespace
{

using dynamics::Scene;

/// Two dynamic boxes, one in the other, made from these definitions: are they in contact after a
/// step?
bool Collide(b2FixtureDef defA, b2FixtureDef defB)
{
    Scene scene(b2Vec2_zero);
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f);
    defA.shape = &shape;
    defB.shape = &shape;
    scene.Body(b2_dynamicBody, 0.0f, 0.0f)->CreateFixture(&defA);
    scene.Body(b2_dynamicBody, 0.4f, 0.0f)->CreateFixture(&defB);
    scene.Step();
    return scene.world.GetContactCount() > 0;
}

TEST(Fixtures, HaveTheValuesOfTheirDefinition)
{
    Scene scene;
    int data = 0;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    EXPECT_EQ(body->GetFixtureList(), nullptr);
    b2CircleShape shape;
    shape.m_radius = 0.5f;
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 2.0f;
    def.friction = 0.7f;
    def.restitution = 0.4f;
    def.isSensor = true;
    def.userData = &data;
    def.filter.groupIndex = 3;
    b2Fixture* fixture = body->CreateFixture(&def);
    EXPECT_EQ(fixture->GetShape()->GetType(), b2Shape::e_circle);
    EXPECT_EQ(fixture->GetDensity(), 2.0f);
    EXPECT_EQ(fixture->GetFriction(), 0.7f);
    EXPECT_EQ(fixture->GetRestitution(), 0.4f);
    EXPECT_TRUE(fixture->IsSensor());
    EXPECT_EQ(fixture->GetUserData(), &data);
    EXPECT_EQ(fixture->GetFilterData().groupIndex, 3);
    EXPECT_EQ(fixture->GetBody(), body);
    EXPECT_EQ(scene.world.GetProxyCount(), 1);
}

TEST(FixtureShape, IsReplacedWithEffectFromTheNextStep)
{
    Scene scene(b2Vec2_zero);
    b2CircleShape shape;
    shape.m_radius = 1.4f;
    b2Body* left = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2Fixture* fixture = left->CreateFixture(&shape, 1.0f);
    scene.Body(b2_dynamicBody, 3.0f, 0.0f)->CreateFixture(&shape, 1.0f);
    scene.Step();
    const float32 mass = left->GetMass();
    shape.m_radius = 1.7f;
    EXPECT_TRUE(fixture->SetShape(shape));
    EXPECT_EQ(fixture->GetShape()->m_radius, 1.7f);
    EXPECT_EQ(left->GetMass(), mass);
    scene.Step();
    ASSERT_EQ(scene.world.GetContactCount(), 1);
    EXPECT_TRUE(scene.world.GetContactList()->IsTouching());
    left->ResetMassData();
    EXPECT_GT(left->GetMass(), mass);
}

TEST(FixtureShape, CanChangeTheNumberOfEdgesOfAChain)
{
    Scene scene;
    const b2Vec2 points[] = {{-9.0f, 0.0f}, {-1.0f, 0.0f}, {1.0f, 0.0f}, {9.0f, 0.0f}};
    b2ChainShape chain;
    chain.CreateChain(points, 3);
    b2Fixture* ground = scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&chain, 0.0f);
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 0.5f);
    ball->CreateFixture(&circle, 1.0f);
    scene.Step();
    b2ChainShape longer;
    longer.CreateChain(points, 4);
    EXPECT_TRUE(ground->SetShape(longer));
    EXPECT_EQ(scene.world.GetProxyCount(), 4);
    for (int i = 0; i < 60; ++i)
    {
        scene.Step();
    }
    EXPECT_NEAR(ball->GetPosition().y, 0.5f, 0.02f);
}

TEST(FixtureCreation, CreatesAndDestroysOneInTheListings)
{
    Scene scene;
    b2Body* myBody = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2PolygonShape myShape;
    myShape.SetAsBox(1.0f, 1.0f);
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &myShape;
    fixtureDef.density = 1.0f;
    b2Fixture* myFixture = myBody->CreateFixture(&fixtureDef);
    EXPECT_EQ(myBody->GetFixtureList(), myFixture);
    EXPECT_FLOAT_EQ(myBody->GetMass(), 4.0f);
    myBody->DestroyFixture(myFixture);
    EXPECT_EQ(myBody->GetFixtureList(), nullptr);
}

TEST(FixtureCreation, AddsTheMassesOfSeveralFixtures)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2Fixture* first = Scene::AddBox(body, 0.5f, 0.5f);
    Scene::AddBox(body, 1.0f, 0.5f);
    EXPECT_FLOAT_EQ(body->GetMass(), 3.0f);
    body->DestroyFixture(first);
    EXPECT_FLOAT_EQ(body->GetMass(), 2.0f);
}

/// The deceleration of a box that slides on the ground over that of free fall.
float32 SlidingFriction(float32 ofGround, float32 ofBox, float32 density = 1.0f)
{
    Scene scene;
    Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -1.0f), 50.0f, 1.0f, ofGround);
    b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 0.5f + dynamics::kRestingGap);
    Scene::AddBox(box, 0.5f, 0.5f, ofBox)->SetDensity(density);
    box->ResetMassData();
    scene.Step(30);
    box->SetLinearVelocity(b2Vec2(8.0f, 0.0f));
    scene.Step(30);
    return (8.0f - box->GetLinearVelocity().x) / (0.5f * 10.0f);
}

TEST(Friction, IsTheGeometricMeanOfTheTwo)
{
    Scene scene;
    b2Fixture* fixtureA = Scene::AddBox(scene.Body(b2_dynamicBody, 0.0f, 0.0f), 1.0f, 1.0f, 0.9f);
    b2Fixture* fixtureB = Scene::AddBox(scene.Body(b2_dynamicBody, 0.0f, 1.0f), 1.0f, 1.0f, 0.4f);
    float32 friction;
    friction = sqrtf(fixtureA->GetFriction() * fixtureB->GetFriction());
    EXPECT_FLOAT_EQ(b2MixFriction(0.9f, 0.4f), friction);
    scene.Step();
    ASSERT_NE(scene.world.GetContactList(), nullptr);
    EXPECT_FLOAT_EQ(scene.world.GetContactList()->GetFriction(), friction);
    EXPECT_NEAR(SlidingFriction(0.9f, 0.4f), friction, 0.02f);
}

TEST(Friction, IsZeroIfEitherFixtureHasZero)
{
    EXPECT_NEAR(SlidingFriction(0.0f, 1.0f), 0.0f, 1e-4f);
}

TEST(Friction, IsProportionalToTheNormalForce)
{
    // Ten times the weight gives ten times the force, so the same deceleration.
    EXPECT_NEAR(SlidingFriction(0.5f, 0.5f, 10.0f), SlidingFriction(0.5f, 0.5f, 1.0f), 1e-3f);
}

/// Returns the height of the lower side of a ball after the bounce from five metres.
float32 Rebound(float32 ofGround, float32 ofBall, float32 height = 5.0f)
{
    Scene scene;
    Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -1.0f), 50.0f, 1.0f, 0.2f, ofGround);
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 0.5f + height);
    Scene::AddBall(ball, 0.5f, 0.2f, ofBall);
    bool bounced = false;
    float32 highest = 0.0f;
    for (int i = 0; i < 180; ++i)
    {
        scene.Step();
        bounced = bounced || ball->GetContactList() != nullptr;
        if (bounced && ball->GetLinearVelocity().y > 0.0f)
        {
            highest = b2Max(highest, ball->GetPosition().y - 0.5f);
        }
    }
    return highest;
}

TEST(Restitution, GivesNoReboundAtZeroAndAFullOneAtOne)
{
    EXPECT_LT(Rebound(0.0f, 0.0f), 0.1f);
    EXPECT_NEAR(Rebound(0.0f, 1.0f), 5.0f, 0.4f);
}

TEST(Restitution, IsTheLargerOfTheTwo)
{
    Scene scene;
    b2Fixture* fixtureA =
        Scene::AddBox(scene.Body(b2_dynamicBody, 0.0f, 0.0f), 1.0f, 1.0f, 0.2f, 0.1f);
    b2Fixture* fixtureB =
        Scene::AddBox(scene.Body(b2_dynamicBody, 0.0f, 1.0f), 1.0f, 1.0f, 0.2f, 0.8f);
    float32 restitution;
    restitution = b2Max(fixtureA->GetRestitution(), fixtureB->GetRestitution());
    EXPECT_EQ(restitution, 0.8f);
    scene.Step();
    ASSERT_NE(scene.world.GetContactList(), nullptr);
    EXPECT_EQ(scene.world.GetContactList()->GetRestitution(), restitution);
}

TEST(Restitution, IsIgnoredInSlowImpacts)
{
    // A fall from here ends below the threshold.
    const float32 height = 0.4f * b2_velocityThreshold * b2_velocityThreshold / 20.0f;
    EXPECT_LT(Rebound(1.0f, 1.0f, height), 0.5f * height + b2_linearSlop);
}

TEST(Filtering, FollowsTheRuleOfCategoriesAndMasks)
{
    b2FixtureDef playerFixtureDef, monsterFixtureDef;
    playerFixtureDef.filter.categoryBits = 0x0002;
    monsterFixtureDef.filter.categoryBits = 0x0004;
    playerFixtureDef.filter.maskBits = 0x0004;
    monsterFixtureDef.filter.maskBits = 0x0002;
    EXPECT_TRUE(Collide(playerFixtureDef, monsterFixtureDef));
    EXPECT_FALSE(Collide(playerFixtureDef, playerFixtureDef));
    EXPECT_FALSE(Collide(monsterFixtureDef, monsterFixtureDef));
}

TEST(Filtering, AgreesWithTheRuleForEveryPairOfMasks)
{
    for (int bits = 0; bits < 16; ++bits)
    {
        b2FixtureDef fixtureA, fixtureB;
        fixtureA.filter.categoryBits = (bits & 1) ? 0x8000 : 0x0002;
        fixtureB.filter.categoryBits = (bits & 2) ? 0x8000 : 0x0002;
        fixtureA.filter.maskBits = (bits & 4) ? 0x8000 : 0x0002;
        fixtureB.filter.maskBits = (bits & 8) ? 0x8000 : 0x0002;
        uint16 catA = fixtureA.filter.categoryBits;
        uint16 maskA = fixtureA.filter.maskBits;
        uint16 catB = fixtureB.filter.categoryBits;
        uint16 maskB = fixtureB.filter.maskBits;
        bool expected = false;
        if ((catA & maskB) != 0 && (catB & maskA) != 0)
        {
            expected = true;
        }
        EXPECT_EQ(Collide(fixtureA, fixtureB), expected) << bits;
    }
}

TEST(Filtering, LetsPositiveGroupsCollideAndNegativeOnesNot)
{
    b2FixtureDef fixture1Def, fixture2Def, fixture3Def, fixture4Def;
    fixture1Def.filter.groupIndex = 2;
    fixture2Def.filter.groupIndex = 2;
    fixture3Def.filter.groupIndex = -8;
    fixture4Def.filter.groupIndex = -8;
    EXPECT_TRUE(Collide(fixture1Def, fixture2Def));
    EXPECT_FALSE(Collide(fixture3Def, fixture4Def));
    // Groups come before categories.
    fixture1Def.filter.maskBits = 0;
    EXPECT_TRUE(Collide(fixture1Def, fixture2Def));
    // Different groups: categories and masks decide.
    EXPECT_TRUE(Collide(fixture2Def, fixture3Def));
    EXPECT_FALSE(Collide(fixture1Def, fixture3Def));
}

TEST(Filtering, NeverLetsFixturesOfOneBodyCollide)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2Filter always;
    always.groupIndex = 1;
    Scene::AddBox(body, 1.0f, 1.0f)->SetFilterData(always);
    Scene::AddBall(body, 1.0f)->SetFilterData(always);
    scene.Step(3);
    EXPECT_EQ(scene.world.GetContactCount(), 0);
}

} // namespace
