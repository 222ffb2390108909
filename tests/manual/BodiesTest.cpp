// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <limits>

/// The chapter about bodies, section by section.
namespace
{

using dynamics::kStep;
using dynamics::Scene;

/// Do bodies of these types stop each other when one is driven into the other? The first moves.
bool Collide(b2BodyType typeA, b2BodyType typeB)
{
    Scene scene(b2Vec2_zero);
    b2Body* a = scene.Body(typeA, -2.0f, 0.0f);
    b2Body* b = scene.Body(typeB, 0.0f, 0.0f);
    Scene::AddBox(a, 0.5f, 0.5f);
    Scene::AddBox(b, 0.5f, 0.5f);
    a->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    bool touched = false;
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        touched = touched || scene.world.GetContactCount() > 0;
    }
    return touched;
}

TEST(StaticBody, HasNoMassAndNoVelocityAndDoesNotMoveByItself)
{
    Scene scene;
    b2Body* body = scene.Body(b2_staticBody, 1.0f, 2.0f);
    Scene::AddBox(body, 1.0f, 1.0f);
    body->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    body->SetAngularVelocity(1.0f);
    body->ApplyForceToCenter(b2Vec2(100.0f, 0.0f));
    scene.Step(10);
    EXPECT_EQ(body->GetMass(), 0.0f);
    EXPECT_EQ(body->GetInertia(), 0.0f);
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2_zero);
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.0f, 2.0f));
    body->SetTransform(b2Vec2(3.0f, 4.0f), 0.5f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(3.0f, 4.0f));
}

TEST(KinematicBody, MovesByItsVelocityAndIgnoresForces)
{
    Scene scene;
    b2Body* body = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    Scene::AddBox(body, 1.0f, 1.0f);
    body->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    body->ApplyForceToCenter(b2Vec2(0.0f, 100.0f));
    scene.Step(60);
    EXPECT_NEAR(body->GetPosition().x, 1.0f, 1e-4f);
    EXPECT_EQ(body->GetPosition().y, 0.0f);
    EXPECT_EQ(body->GetMass(), 0.0f);
}

TEST(KinematicBody, PushesLikeAnInfiniteMass)
{
    Scene scene(b2Vec2_zero);
    b2Body* pusher = scene.Body(b2_kinematicBody, -2.0f, 0.0f);
    Scene::AddBox(pusher, 0.5f, 0.5f);
    b2Body* box = scene.Box(0.0f, 0.0f);
    pusher->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    scene.Step(120);
    EXPECT_EQ(pusher->GetLinearVelocity(), b2Vec2(1.0f, 0.0f));
    EXPECT_GT(box->GetPosition().x, 0.9f);
}

TEST(BodyTypes, CollideOnlyInPairsWithADynamicBody)
{
    EXPECT_FALSE(Collide(b2_kinematicBody, b2_staticBody));
    EXPECT_FALSE(Collide(b2_kinematicBody, b2_kinematicBody));
    EXPECT_TRUE(Collide(b2_dynamicBody, b2_staticBody));
    EXPECT_TRUE(Collide(b2_dynamicBody, b2_kinematicBody));
    EXPECT_TRUE(Collide(b2_dynamicBody, b2_dynamicBody));

    Scene scene;
    Scene::AddBox(scene.Body(b2_staticBody, 0.0f, 0.0f), 1.0f, 1.0f);
    Scene::AddBox(scene.Body(b2_staticBody, 0.5f, 0.0f), 1.0f, 1.0f);
    scene.Step();
    EXPECT_EQ(scene.world.GetContactCount(), 0);
}

TEST(Bodies, KeepTheirFixturesRigidlyAndWithoutCollision)
{
    Scene scene;
    scene.Ground();
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 3.0f, 0.4f);
    b2Fixture* box = Scene::AddBox(body, 0.5f, 0.5f);
    b2Fixture* ball = Scene::AddBall(body, 0.6f);
    scene.Step(200);
    for (b2Contact* c = scene.world.GetContactList(); c; c = c->GetNext())
    {
        EXPECT_NE(c->GetFixtureA()->GetBody(), c->GetFixtureB()->GetBody());
    }
    EXPECT_TRUE(box->TestPoint(body->GetWorldPoint(b2Vec2(0.45f, 0.45f))));
    EXPECT_TRUE(ball->TestPoint(body->GetWorldPoint(b2Vec2(0.0f, 0.59f))));
}

TEST(BodyDefinition, CanBeRecycledForSeveralBodies)
{
    b2World world(b2Vec2_zero);
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(1.0f, 0.0f);
    b2Body* first = world.CreateBody(&bodyDef);
    bodyDef.position.Set(2.0f, 0.0f);
    b2Body* second = world.CreateBody(&bodyDef);
    EXPECT_EQ(first->GetPosition().x, 1.0f);
    EXPECT_EQ(second->GetPosition().x, 2.0f);
    EXPECT_EQ(second->GetType(), b2_dynamicBody);
}

TEST(PositionAndAngle, SetTheOriginNotTheMassInTheListing)
{
    b2World world(b2Vec2_zero);
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(0.0f, 2.0f); // [m]
    bodyDef.angle = 0.25f * b2_pi;    // [rad]
    b2Body* body = world.CreateBody(&bodyDef);
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f, b2Vec2(1.0f, 0.0f), 0.0f);
    body->CreateFixture(&shape, 1.0f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 2.0f));
    EXPECT_FLOAT_EQ(body->GetAngle(), 0.25f * b2_pi);
    EXPECT_NEAR(body->GetWorldCenter().x, std::sqrt(0.5f), 1e-5f);

    b2MassData mass;
    body->GetMassData(&mass);
    mass.center.Set(0.0f, 0.0f);
    mass.I = 1.0f;
    body->SetMassData(&mass);
    EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 2.0f));
    EXPECT_TRUE(body->GetFixtureList()->TestPoint(body->GetWorldPoint(b2Vec2(1.4f, 0.4f))));
}

/// The speed that is left of 1 m/s and 1 rad/s after a second.
b2Vec2 DampedFor(float32 linear, float32 angular, int stepsASecond)
{
    b2World world(b2Vec2_zero);
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.linearDamping = linear;
    bodyDef.angularDamping = angular;
    bodyDef.linearVelocity.Set(1.0f, 0.0f);
    bodyDef.angularVelocity = 1.0f;
    b2Body* body = world.CreateBody(&bodyDef);
    Scene::AddBox(body, 0.5f, 0.5f);
    for (int i = 0; i < stepsASecond; ++i)
    {
        world.Step(1.0f / float32(stepsASecond), 8, 3);
    }
    return b2Vec2(body->GetLinearVelocity().x, body->GetAngularVelocity());
}

TEST(Damping, SlowsOnlyTheTurningInTheListing)
{
    b2BodyDef bodyDef;
    bodyDef.linearDamping = 0.0f;
    bodyDef.angularDamping = 0.01f;
    const b2Vec2 left = DampedFor(bodyDef.linearDamping, bodyDef.angularDamping, 60);
    EXPECT_EQ(left.x, 1.0f);
    EXPECT_NEAR(left.y, std::exp(-0.01f), 1e-4f);
}

TEST(Damping, DependsLittleOnTheStepAndStopsWhenInfinite)
{
    EXPECT_NEAR(DampedFor(0.1f, 0.1f, 30).x, DampedFor(0.1f, 0.1f, 120).x, 1e-3f);
    EXPECT_GT(b2Abs(DampedFor(20.0f, 0.0f, 10).x - DampedFor(20.0f, 0.0f, 20).x), 1e-6f);
    const float32 infinity = std::numeric_limits<float32>::infinity();
    EXPECT_EQ(DampedFor(infinity, infinity, 60), b2Vec2_zero);
}

TEST(GravityScale, LetsABodyFloatAtZero)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    // Gravity does not act on this body.
    bodyDef.gravityScale = 0.0f;
    b2Body* floating = world.CreateBody(&bodyDef);
    bodyDef.gravityScale = 2.0f;
    b2Body* heavy = world.CreateBody(&bodyDef);
    Scene::AddBox(floating, 0.5f, 0.5f);
    Scene::AddBall(heavy, 0.1f);
    heavy->SetTransform(b2Vec2(5.0f, 0.0f), 0.0f);
    world.Step(kStep, 8, 3);
    EXPECT_EQ(floating->GetPosition().y, 0.0f);
    EXPECT_NEAR(heavy->GetLinearVelocity().y, -20.0f * kStep, 1e-5f);
}

TEST(SleepParameters, LetABodySleepOrForbidIt)
{
    Scene scene;
    scene.Ground();
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.allowSleep = true;
    bodyDef.awake = true;
    bodyDef.position.Set(0.0f, 0.52f);
    b2Body* sleeper = scene.world.CreateBody(&bodyDef);
    Scene::AddBox(sleeper, 0.5f, 0.5f);
    bodyDef.allowSleep = false;
    bodyDef.position.Set(5.0f, 0.52f);
    b2Body* restless = scene.world.CreateBody(&bodyDef);
    Scene::AddBox(restless, 0.5f, 0.5f);
    EXPECT_TRUE(sleeper->IsAwake());
    scene.Step(120);
    EXPECT_FALSE(sleeper->IsAwake());
    EXPECT_TRUE(restless->IsAwake());
    sleeper->SetAwake(true);
    EXPECT_TRUE(sleeper->IsAwake());
}

TEST(SleepParameters, KeepABodyAsleepUntilItIsHit)
{
    Scene scene;
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.awake = false;
    b2Body* sleeper = scene.world.CreateBody(&bodyDef);
    Scene::AddBox(sleeper, 0.5f, 0.5f);
    scene.Step(30);
    EXPECT_FALSE(sleeper->IsAwake());
    EXPECT_EQ(sleeper->GetPosition().y, 0.0f);
    scene.Box(0.0f, 1.5f);
    scene.Step(30);
    EXPECT_TRUE(sleeper->IsAwake());
}

TEST(SleepParameters, EndSleepWhenAJointOrContactIsDestroyed)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* support = scene.Body(b2_staticBody, 10.0f, 5.0f);
    Scene::AddBox(support, 1.0f, 0.5f);
    b2Body* onSupport = scene.Box(10.0f, 6.02f);
    b2Body* hanging = scene.Box(0.0f, 5.0f);
    b2RevoluteJointDef def;
    def.Initialize(ground, hanging, hanging->GetPosition());
    b2Joint* joint = scene.world.CreateJoint(&def);
    scene.Step(120);
    ASSERT_FALSE(hanging->IsAwake() || onSupport->IsAwake());
    scene.world.DestroyJoint(joint);
    EXPECT_TRUE(hanging->IsAwake());
    scene.world.DestroyBody(support);
    EXPECT_TRUE(onSupport->IsAwake());
}

TEST(FixedRotation, KeepsABodyUprightUnderLoad)
{
    Scene scene;
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.fixedRotation = true;
    b2Body* body = scene.world.CreateBody(&bodyDef);
    Scene::AddBox(body, 0.5f, 1.0f);
    body->ApplyTorque(1000.0f);
    body->ApplyForce(b2Vec2(100.0f, 0.0f), b2Vec2(0.0f, 1.0f));
    scene.Step(10);
    EXPECT_EQ(body->GetAngle(), 0.0f);
    EXPECT_EQ(body->GetInertia(), 0.0f);
}

/// Returns the position of a body at 100 m/s after a tenth of a second, with a thin obstacle on its
/// path.
float32 EndOfShot(b2BodyType obstacle, bool bullet)
{
    Scene scene(b2Vec2_zero);
    b2Body* wall = scene.Body(obstacle, 0.0f, 0.0f);
    b2PolygonShape shape;
    shape.SetAsBox(0.02f, 5.0f);
    wall->CreateFixture(&shape, 1000.0f);
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.bullet = bullet;
    bodyDef.position.Set(-4.2f, 0.0f);
    bodyDef.linearVelocity.Set(100.0f, 0.0f);
    b2Body* shot = scene.world.CreateBody(&bodyDef);
    Scene::AddBall(shot, 0.05f);
    scene.Step(6);
    return shot->GetPosition().x - wall->GetPosition().x;
}

TEST(Bullets, StopAtDynamicBodiesWhereOthersPass)
{
    EXPECT_LT(EndOfShot(b2_dynamicBody, true), 0.0f);
    EXPECT_GT(EndOfShot(b2_dynamicBody, false), 0.0f);
}

TEST(Bullets, AreNotNeededAgainstStaticBodies)
{
    EXPECT_LT(EndOfShot(b2_staticBody, false), 0.0f);
}

TEST(Bullets, ChangeNothingIfKinematic)
{
    b2Vec2 ends[2];
    for (const bool bullet : {false, true})
    {
        Scene scene(b2Vec2_zero);
        b2Body* crate = scene.Box(2.0f, 0.3f, 0.1f, 0.5f);
        b2Body* ram = scene.Body(b2_kinematicBody, -1.0f, 0.0f);
        Scene::AddBox(ram, 0.2f, 0.2f);
        ram->SetBullet(bullet);
        ram->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
        scene.Step(30);
        ends[bullet] = crate->GetPosition();
    }
    EXPECT_EQ(ends[true], ends[false]);
}

TEST(Activation, KeepsInactiveBodiesOutOfTheBroadPhase)
{
    Scene scene;
    scene.Ground();
    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.active = false;
    bodyDef.position.Set(0.0f, 2.0f);
    b2Body* body = scene.world.CreateBody(&bodyDef);
    Scene::AddBox(body, 0.5f, 0.5f);
    EXPECT_EQ(scene.world.GetProxyCount(), 1);
    scene.Ball(0.0f, 3.0f);
    scene.Step(30);
    EXPECT_EQ(body->GetPosition().y, 2.0f);
    EXPECT_EQ(body->GetContactList(), nullptr);
    body->SetActive(true);
    EXPECT_EQ(scene.world.GetProxyCount(), 3);
    scene.Step(30);
    EXPECT_LT(body->GetPosition().y, 2.0f);
}

TEST(Activation, StopsJointsOfInactiveBodies)
{
    Scene scene;
    b2Body* anchor = scene.Body(b2_dynamicBody, 0.0f, 5.0f);
    Scene::AddBox(anchor, 0.1f, 0.1f);
    b2Body* body = scene.Box(0.0f, 0.0f);
    b2DistanceJointDef def;
    def.Initialize(anchor, body, anchor->GetPosition(), body->GetPosition());
    scene.world.CreateJoint(&def);
    anchor->SetActive(false);
    scene.Step(60);
    EXPECT_NEAR(body->GetLinearVelocity().y, -10.0f, 1e-3f);
}

TEST(UserData, IsThePointerOfTheDefinition)
{
    int myActor = 0;
    b2World world(b2Vec2_zero);
    b2BodyDef bodyDef;
    bodyDef.userData = &myActor;
    EXPECT_EQ(world.CreateBody(&bodyDef)->GetUserData(), &myActor);
}

TEST(BodyFactory, CreatesAndDestroysInTheListing)
{
    b2World world(b2Vec2_zero);
    b2World* myWorld = &world;
    b2BodyDef bodyDef;
    b2Body* dynamicBody = myWorld->CreateBody(&bodyDef);
    EXPECT_EQ(myWorld->GetBodyList(), dynamicBody);
    myWorld->DestroyBody(dynamicBody);
    dynamicBody = NULL;
    EXPECT_EQ(myWorld->GetBodyList(), nullptr);
}

TEST(BodyFactory, DestroysABodyWithItsFixturesAndJoints)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* body = scene.Box(0.0f, 2.0f);
    b2RevoluteJointDef def;
    def.Initialize(ground, body, body->GetPosition());
    scene.world.CreateJoint(&def);
    scene.world.DestroyBody(body);
    EXPECT_EQ(scene.world.GetJointCount(), 0);
    EXPECT_EQ(scene.world.GetProxyCount(), 1);
    EXPECT_EQ(ground->GetJointList(), nullptr);
}

TEST(StateInformation, IsSetAndReadByTheNamesOfTheManual)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    for (const bool flag : {true, false})
    {
        body->SetBullet(flag);
        EXPECT_EQ(body->IsBullet(), flag);
        body->SetSleepingAllowed(flag);
        EXPECT_EQ(body->IsSleepingAllowed(), flag);
        body->SetAwake(flag);
        EXPECT_EQ(body->IsAwake(), flag);
        body->SetActive(flag);
        EXPECT_EQ(body->IsActive(), flag);
        body->SetFixedRotation(flag);
        EXPECT_EQ(body->IsFixedRotation(), flag);
    }
    for (const b2BodyType type : {b2_staticBody, b2_kinematicBody, b2_dynamicBody})
    {
        body->SetType(type);
        EXPECT_EQ(body->GetType(), type);
    }
}

TEST(PositionAndVelocity, AreReadAndSetByTheNamesOfTheManual)
{
    Scene scene(b2Vec2_zero);
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2PolygonShape corner;
    corner.SetAsBox(0.5f, 0.5f, b2Vec2(0.5f, 0.5f), 0.0f);
    body->CreateFixture(&corner, 1.0f);
    const bool moved = body->SetTransform(b2Vec2(1.0f, 2.0f), 0.5f * b2_pi);
    EXPECT_TRUE(moved);
    const b2Transform& transform = body->GetTransform();
    const b2Vec2& position = body->GetPosition();
    EXPECT_EQ(position, transform.p);
    EXPECT_EQ(body->GetAngle(), 0.5f * b2_pi);
    const b2Vec2& center = body->GetWorldCenter();
    EXPECT_NEAR(b2Distance(center, b2Vec2(0.5f, 2.5f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(body->GetLocalCenter(), b2Vec2(0.5f, 0.5f)), 0.0f, 1e-6f);
}

TEST(PositionAndVelocity, IncludeTheVelocityOfTheCentreOfMass)
{
    Scene scene(b2Vec2_zero);
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->SetAngularVelocity(2.0f);
    b2MassData mass;
    body->GetMassData(&mass);
    mass.center.Set(0.25f, 0.0f);
    mass.I = 1.0f;
    body->SetMassData(&mass);
    EXPECT_NEAR(body->GetLinearVelocity().y, 0.5f, 1e-5f);
}

} // namespace
