// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>

namespace
{

TEST(BodiesListing, DefinesABody)
{
    manual::Stage stage;
    b2World& world = stage.world;
    // [define]
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 2.0f); // of the body's origin, in the world [m]
    def.angle = 0.25f * b2_pi;    // 45 degrees, counter-clockwise
    def.linearDamping = 0.1f;
    def.angularDamping = 0.1f;
    b2Body* body = world.CreateBody(&def);

    def.position.x = 3.0f; // the definition was copied and can make another one
    b2Body* neighbour = world.CreateBody(&def);
    // [/define]
    EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 2.0f));
    EXPECT_EQ(neighbour->GetPosition(), b2Vec2(3.0f, 2.0f));
    EXPECT_EQ(neighbour->GetLinearDamping(), 0.1f);
}

TEST(BodiesListing, HasTheDefaultsOfTheTable)
{
    const std::string section = manual::SectionText("05-bodies.md", "## Definition");
    const b2BodyDef def;
    EXPECT_EQ(def.type, b2_staticBody);
    EXPECT_DEFAULT(section, def, position);
    EXPECT_DEFAULT(section, def, angle);
    EXPECT_DEFAULT(section, def, linearVelocity);
    EXPECT_DEFAULT(section, def, angularVelocity);
    EXPECT_DEFAULT(section, def, linearDamping);
    EXPECT_DEFAULT(section, def, angularDamping);
    EXPECT_DEFAULT(section, def, gravityScale);
    EXPECT_DEFAULT(section, def, allowSleep);
    EXPECT_DEFAULT(section, def, awake);
    EXPECT_DEFAULT(section, def, fixedRotation);
    EXPECT_DEFAULT(section, def, bullet);
    EXPECT_DEFAULT(section, def, active);
}

TEST(BodiesListing, MovesAPlatform)
{
    manual::Stage stage;
    b2Body* platform = stage.Box(0.0f, 0.0f, 2.0f, 0.2f, b2_kinematicBody);
    b2Body* rider = stage.Box(0.0f, 0.75f);
    stage.Run(1.0f);
    const b2Vec2 next(1.0f / 60.0f, 0.5f / 60.0f);
    // [platform]
    // Not SetTransform: what rides on it would not be carried along.
    platform->SetLinearVelocity(60.0f * (next - platform->GetPosition())); // there in one step
    // [/platform]
    stage.Run(1.0f / 60.0f);
    EXPECT_NEAR(b2Distance(platform->GetPosition(), next), 0.0f, 1e-5f);
    EXPECT_GT(rider->GetLinearVelocity().y, 0.4f);
}

TEST(BodiesListing, SetsAndResetsTheMass)
{
    manual::Stage stage;
    b2Body* body = stage.Box(0.0f, 5.0f);
    // [mass]
    b2MassData data;
    body->GetMassData(&data);
    data.I += data.mass * (1.5f * 1.5f); // to be about a point 1.5 m off, for I is about the origin
    data.center.Set(0.0f, -1.5f);        // a keel
    body->SetMassData(&data);
    // [/mass]
    EXPECT_EQ(body->GetLocalCenter(), b2Vec2(0.0f, -1.5f));
    EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 5.0f));
    EXPECT_FLOAT_EQ(body->GetInertia(), 1.0f / 6.0f + 2.25f);
    // [reset]
    body->ResetMassData(); // what the fixtures give
    // [/reset]
    EXPECT_EQ(body->GetLocalCenter(), b2Vec2(0.0f, 0.0f));
    EXPECT_FLOAT_EQ(body->GetMass(), 1.0f);
    EXPECT_FLOAT_EQ(body->GetInertia(), 1.0f / 6.0f);
}

TEST(BodiesListing, PushesAndKicks)
{
    manual::Stage stage(b2Vec2_zero);
    b2Body* body = stage.Box(0.0f, 0.0f); // 1 kg, 1/6 kg m^2
    // [forces]
    const b2Vec2 corner = body->GetWorldPoint(b2Vec2(0.5f, 0.5f));
    body->ApplyForce(b2Vec2(60.0f, 0.0f), corner); // [N], for the whole of the next step
    body->ApplyLinearImpulse(b2Vec2(0.0f, 2.0f), body->GetWorldCenter()); // [N s], at once
    // [/forces]
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(0.0f, 2.0f));
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    stage.Run(1.0f / 60.0f);
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 1e-5f);
    EXPECT_NEAR(body->GetAngularVelocity(), -0.5f / 60.0f * 60.0f * 6.0f, 1e-4f);

    manual::Stage sleepers;
    sleepers.Ground();
    b2Body* boat = sleepers.Box(0.0f, 0.515f);
    sleepers.Run(2.0f);
    ASSERT_FALSE(boat->IsAwake());
    const b2Vec2 wind(0.5f, 0.0f);
    // [no-wake]
    boat->ApplyForceToCenter(wind, false); // a sleeping body stays asleep
    // [/no-wake]
    EXPECT_FALSE(boat->IsAwake());
    boat->ApplyForceToCenter(wind);
    EXPECT_TRUE(boat->IsAwake());
}

TEST(BodiesListing, ChangesTheState)
{
    manual::Stage stage;
    b2Body* ground = stage.Ground();
    b2Body* crate = stage.Box(0.0f, 0.515f);
    b2WeldJointDef weld;
    weld.Initialize(ground, crate, crate->GetPosition());
    stage.world.CreateJoint(&weld);
    EXPECT_TRUE(crate->IsAwake() && crate->IsSleepingAllowed() && !crate->IsFixedRotation());
    crate->SetAngularVelocity(1.0f);
    b2MassData heavy{5.0f, b2Vec2_zero, 1.0f};
    crate->SetMassData(&heavy);
    // [set-static]
    crate->SetType(b2_staticBody); // anchored where it is: it stops and weighs nothing
    // [/set-static]
    EXPECT_EQ(crate->GetType(), b2_staticBody);
    EXPECT_EQ(crate->GetMass(), 0.0f);
    EXPECT_EQ(crate->GetAngularVelocity(), 0.0f);
    EXPECT_EQ(crate->GetContactList(), nullptr);
    EXPECT_NE(crate->GetJointList(), nullptr);
    int resting = 0;
    crate->SetAwake(false);
    // [state]
    crate->SetType(b2_dynamicBody); // loose again, awake, with the mass of its fixtures
    crate->SetFixedRotation(true);  // slides, never tips over
    if (!crate->IsAwake() && crate->IsSleepingAllowed())
    {
        ++resting;
    }
    // [/state]
    EXPECT_EQ(resting, 0) << "it is awake";
    EXPECT_EQ(crate->GetMass(), 1.0f);
    EXPECT_EQ(crate->GetInertia(), 0.0f);
    crate->SetSleepingAllowed(false);
    stage.Run(2.0f);
    EXPECT_TRUE(crate->IsAwake());
    crate->SetSleepingAllowed(true);
    stage.Run(2.0f);
    EXPECT_FALSE(crate->IsAwake());
    crate->SetSleepingAllowed(false);
    EXPECT_TRUE(crate->IsAwake());
}

TEST(BodiesListing, GoesBetweenFrames)
{
    manual::Stage stage(b2Vec2_zero);
    b2Body* ship = stage.Box(10.0f, 0.0f);
    ship->SetTransform(b2Vec2(10.0f, 0.0f), 0.5f * b2_pi);
    ship->SetAngularVelocity(1.0f);
    // [frames]
    const b2Vec2 gun = ship->GetWorldPoint(b2Vec2(2.0f, 0.0f));      // a point of the ship
    const b2Vec2 ahead = ship->GetWorldVector(b2Vec2(1.0f, 0.0f));   // a direction
    const b2Vec2 back = ship->GetLocalPoint(gun);                    // (2, 0)
    const b2Vec2 down = ship->GetLocalVector(b2Vec2(0.0f, -1.0f));   // gravity as the ship feels it
    const b2Vec2 speed = ship->GetLinearVelocityFromWorldPoint(gun); // the turning included
    // [/frames]
    EXPECT_NEAR(b2Distance(gun, b2Vec2(10.0f, 2.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(ahead, b2Vec2(0.0f, 1.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(back, b2Vec2(2.0f, 0.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(b2Distance(down, b2Vec2(-1.0f, 0.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(speed, b2Vec2(-2.0f, 0.0f)), 0.0f, 1e-5f);
}

TEST(BodiesListing, WalksOverWhatABodyHas)
{
    manual::Stage stage;
    b2Body* ground = stage.Ground();
    b2Body* body = stage.Box(0.0f, 0.515f);
    b2WeldJointDef weld;
    weld.Initialize(ground, body, body->GetPosition());
    weld.collideConnected = true;
    stage.world.CreateJoint(&weld);
    stage.Run(0.1f);
    int fixtures = 0, joints = 0, touching = 0;
    // [lists]
    for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
    {
        ++fixtures;
    }
    for (b2JointEdge* e = body->GetJointList(); e; e = e->next)
    {
        ++joints; // e->joint, and e->other: the body at its other end
    }
    for (b2ContactEdge* e = body->GetContactList(); e; e = e->next)
    {
        touching += e->contact->IsTouching(); // not all that are listed touch
    }
    // [/lists]
    EXPECT_EQ(fixtures, 1);
    EXPECT_EQ(joints, 1);
    EXPECT_EQ(touching, 1);
}

/// Whether a ball of 100 m/s is stopped by a thin wall of this type.
bool IsStopped(bool bullet, b2BodyType type)
{
    manual::Stage stage(b2Vec2_zero);
    b2Body* wall = stage.Box(0.0f, 0.0f, 0.02f, 2.0f, type);
    b2Body* ball = stage.Ball(-4.2f, 0.0f, 0.05f);
    // [bullet]
    ball->SetBullet(bullet);
    // [/bullet]
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    stage.Run(0.1f);
    return ball->GetPosition().x < wall->GetPosition().x;
}

TEST(BodiesListing, StopsBulletsAtDynamicAndAllBodiesAtStaticOnes)
{
    EXPECT_TRUE(IsStopped(true, b2_dynamicBody));
    EXPECT_FALSE(IsStopped(false, b2_dynamicBody));
    EXPECT_TRUE(IsStopped(false, b2_kinematicBody));
    EXPECT_TRUE(IsStopped(false, b2_staticBody));
}

TEST(BodiesListing, DampsAsThePageSays)
{
    for (const int32 subSteps : {1, 4})
    {
        manual::Stage stage(b2Vec2_zero);
        stage.world.SetSubStepCount(subSteps);
        b2Body* ball = stage.Ball(0.0f, 0.0f);
        ball->SetLinearDamping(5.0f);
        ball->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        stage.Run(1.0f);
        const float32 off = ball->GetLinearVelocity().x / (10.0f * std::exp(-5.0f)) - 1.0f;
        EXPECT_NEAR(100.0f * b2Abs(off), subSteps == 1 ? 22.0f : 0.03f,
                    subSteps == 1 ? 0.5f : 0.005f);
    }
}

TEST(BodiesListing, LeavesASleeperAsleepWhenGravityChanges)
{
    manual::Stage stage;
    stage.Ground();
    b2Body* box = stage.Box(0.0f, 0.515f);
    stage.Run(2.0f);
    stage.world.SetGravity(b2Vec2(0.0f, 10.0f));
    stage.Run(1.0f);
    EXPECT_FALSE(box->IsAwake());
}

} // namespace
