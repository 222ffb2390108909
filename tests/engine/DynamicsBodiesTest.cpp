// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <Dynamics/State/Access.h>

#include <gtest/gtest.h>

#include <cmath>

/// Getters and setters of a body: mass, type, motion, forces.
namespace
{

using namespace dynamics;

TEST(DynamicsBodies, HaveTheMassOfTheirFixtures)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f, 1.0f, 0.5f);
    EXPECT_FLOAT_EQ(body->GetMass(), 2.0f);
    EXPECT_FLOAT_EQ(body->GetInertia(), 2.0f * (4.0f + 1.0f) / 12.0f);
    EXPECT_EQ(body->GetLocalCenter(), b2Vec2(0.0f, 0.0f));
    b2PolygonShape beside;
    beside.SetAsBox(1.0f, 0.5f, b2Vec2(2.0f, 0.0f), 0.0f);
    body->CreateFixture(&beside, 1.0f);
    EXPECT_FLOAT_EQ(body->GetMass(), 4.0f);
    EXPECT_FLOAT_EQ(body->GetLocalCenter().x, 1.0f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 0.0f)) << "the origin stays";
    body->DestroyFixture(body->GetFixtureList());
    EXPECT_FLOAT_EQ(body->GetMass(), 2.0f);
    EXPECT_FLOAT_EQ(body->GetLocalCenter().x, 0.0f);
}

TEST(DynamicsBodies, UpdateExtentsByANewFixtureAsByAReset)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 1.0f, 2.0f);
    for (int i = 0; i < 40; ++i)
    {
        b2CircleShape circle;
        circle.m_radius = 0.1f + 0.37f * static_cast<float32>((7 * i) % 11);
        circle.m_p.Set(static_cast<float32>((5 * i) % 13), static_cast<float32>((3 * i) % 17));
        body->CreateFixture(&circle, 0.0f);
        const float32 thinnest = box2d::Data(*body).minExtent;
        const float32 farthest = box2d::Data(*body).maxExtent;
        body->ResetMassData(); // measures all of them
        ASSERT_EQ(box2d::Data(*body).minExtent, thinnest) << i;
        ASSERT_EQ(box2d::Data(*body).maxExtent, farthest) << i;
        if (i % 9 == 8)
        {
            body->DestroyFixture(body->GetFixtureList());
        }
    }
}

TEST(DynamicsBodies, HaveTheInertiaOfAShapeFarFromTheirOrigin)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f, b2Vec2(1000.0f, 0.0f), 0.0f);
    body->CreateFixture(&box, 1.0f);
    body->ApplyAngularImpulse(1.0f);
    EXPECT_NEAR(body->GetAngularVelocity(), 6.0f, 0.01f);
}

TEST(DynamicsBodies, HaveAKilogramAndNoRotationWhenSetToNoMass)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(0.0f, 0.0f);
    b2MassData none;
    none.mass = 0.0f;
    none.center.SetZero();
    none.I = 0.0f;
    body->SetMassData(&none);
    EXPECT_EQ(body->GetMass(), 1.0f);
    EXPECT_EQ(body->GetInertia(), 0.0f);
    body->ApplyAngularImpulse(10.0f);
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    body->ApplyForceToCenter(b2Vec2(60.0f, 0.0f));
    scene.Step();
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 1e-5f);
    EXPECT_EQ(scene.Body(b2_dynamicBody, 0.0f, 9.0f)->GetMass(), 1.0f);
}

TEST(DynamicsBodies, KeepSetMassDataUntilItIsReset)
{
    Scene scene;
    b2Body* body = scene.Box(3.0f, 4.0f);
    b2MassData data;
    data.mass = 7.0f;
    data.center.Set(0.25f, -0.5f);
    data.I = 20.0f;
    body->SetMassData(&data);
    b2MassData read;
    body->GetMassData(&read);
    EXPECT_EQ(read.mass, 7.0f);
    EXPECT_EQ(read.center, data.center);
    EXPECT_NEAR(read.I, 20.0f, 1e-5f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(body->GetWorldCenter(), b2Vec2(3.25f, 3.5f));
    body->ResetMassData();
    EXPECT_FLOAT_EQ(body->GetMass(), 1.0f);
    EXPECT_EQ(body->GetWorldCenter(), b2Vec2(3.0f, 4.0f));
}

TEST(DynamicsBodies, KeepSetMassDataWithANewFixtureOfNoDensity)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    b2MassData data;
    data.mass = 7.0f;
    data.center.SetZero();
    data.I = 20.0f;
    body->SetMassData(&data);
    b2CircleShape feeler;
    feeler.m_radius = 2.0f;
    body->CreateFixture(&feeler, 0.0f);
    EXPECT_EQ(body->GetMass(), 7.0f);
}

TEST(DynamicsBodies, UseANewDensityFromTheNextReset)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->GetFixtureList()->SetDensity(5.0f);
    EXPECT_FLOAT_EQ(body->GetMass(), 1.0f);
    body->ResetMassData();
    EXPECT_FLOAT_EQ(body->GetMass(), 5.0f);
}

TEST(DynamicsBodies, HaveNoMassWhenStaticOrKinematic)
{
    Scene scene;
    b2Body* kinematic = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    Scene::AddBox(kinematic, 1.0f, 1.0f);
    for (const b2Body* body : {scene.Ground(), kinematic})
    {
        EXPECT_EQ(body->GetMass(), 0.0f);
        EXPECT_EQ(body->GetInertia(), 0.0f);
    }
}

TEST(DynamicsBodies, HaveNoInertiaForAnyCentreIfRotationIsFixed)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f, b2Vec2(2.0f, 0.0f), 0.0f);
    body->CreateFixture(&box, 1.0f);
    body->SetFixedRotation(true);
    EXPECT_EQ(body->GetInertia(), 0.0f);
    body->ApplyLinearImpulse(b2Vec2(0.0f, 10.0f), b2Vec2(5.0f, 0.0f));
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    body->SetFixedRotation(false);
    EXPECT_NEAR(body->GetInertia(), 1.0f / 6.0f + 4.0f, 1e-5f);
}

TEST(DynamicsBodies, KeepPlaceAndPointVelocitiesWhenMassChanges)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(1.0f, 2.0f);
    body->SetAngularVelocity(2.0f);
    body->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    const b2Vec2 point(1.5f, 2.5f);
    const b2Vec2 before = body->GetLinearVelocityFromWorldPoint(point);
    b2PolygonShape beside;
    beside.SetAsBox(0.5f, 0.5f, b2Vec2(3.0f, 1.0f), 0.0f);
    body->CreateFixture(&beside, 1.0f);
    const b2Vec2 after = body->GetLinearVelocityFromWorldPoint(point);
    EXPECT_NEAR(after.x, before.x, 1e-5f);
    EXPECT_NEAR(after.y, before.y, 1e-5f);
}

TEST(DynamicsBodies, KeepVelocityBetweenDynamicAndKinematic)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->SetLinearVelocity(b2Vec2(3.0f, 1.0f));
    body->SetAngularVelocity(2.0f);
    body->SetType(b2_kinematicBody);
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(3.0f, 1.0f));
    EXPECT_EQ(body->GetAngularVelocity(), 2.0f);
    body->SetType(b2_dynamicBody);
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(3.0f, 1.0f));
    EXPECT_FLOAT_EQ(body->GetMass(), 1.0f);
    body->SetType(b2_staticBody);
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
}

TEST(DynamicsBodies, ChangeToEveryTypeWhileTouchedAndJoined)
{
    for (const b2BodyType from : {b2_staticBody, b2_kinematicBody, b2_dynamicBody})
    {
        for (const b2BodyType to : {b2_staticBody, b2_kinematicBody, b2_dynamicBody})
        {
            Scene scene;
            scene.Ground();
            b2Body* middle = scene.Body(from, 0.0f, 0.5f);
            Scene::AddBox(middle, 0.5f, 0.5f);
            b2Body* top = scene.Box(0.0f, 1.5f);
            b2Body* hung = scene.Box(3.0f, 0.5f);
            b2DistanceJointDef def;
            def.Initialize(middle, hung, middle->GetPosition(), hung->GetPosition());
            scene.world.CreateJoint(&def);
            for (const int steps : {10, 120})
            {
                scene.Step(steps);
                middle->SetType(to);
                ASSERT_EQ(WhyBroken(scene.world, false), "") << from << " to " << to;
                scene.Step(10);
                ASSERT_EQ(WhyBroken(scene.world, true), "") << from << " to " << to;
                middle->SetType(from);
                ASSERT_EQ(WhyBroken(scene.world, false), "") << to << " to " << from;
            }
            scene.Step(30);
            EXPECT_NEAR(top->GetPosition().y, 1.5f, 0.03f) << from << " to " << to;
        }
    }
}

TEST(DynamicsBodies, AreNotSimulatedWhileInactive)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(10);
    ASSERT_NE(box->GetContactList(), nullptr);
    box->SetActive(false);
    EXPECT_EQ(box->GetContactList(), nullptr);
    EXPECT_EQ(scene.world.GetProxyCount(), 1);
    const b2Vec2 place = box->GetPosition();
    scene.Step(10);
    EXPECT_EQ(box->GetPosition(), place);
    ground->SetActive(false);
    box->SetActive(true);
    scene.Step(10);
    EXPECT_LT(box->GetPosition().y, place.y);
}

TEST(DynamicsBodies, DiscardForcesWhenDeactivated)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* box = scene.Box(0.0f, 0.0f);
    box->ApplyForceToCenter(b2Vec2(600.0f, 0.0f));
    box->SetActive(false);
    scene.Step();
    box->SetActive(true);
    scene.Step();
    EXPECT_EQ(box->GetLinearVelocity().x, 0.0f);
}

TEST(DynamicsBodies, HaveExactlyThePositionThatSetTransformSets)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f, b2Vec2(0.3f, 0.7f), 0.0f);
    body->CreateFixture(&box, 1.0f);
    body->SetTransform(b2Vec2(1.1f, 2.3f), 0.7f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.1f, 2.3f));
    EXPECT_EQ(body->GetAngle(), 0.7f);
    const b2Vec2 center = b2Vec2(1.1f, 2.3f) + b2Mul(b2Rot(0.7f), b2Vec2(0.3f, 0.7f));
    EXPECT_NEAR(body->GetWorldCenter().x, center.x, 1e-6f);
    EXPECT_NEAR(body->GetWorldCenter().y, center.y, 1e-6f);
    EXPECT_TRUE(body->GetFixtureList()->TestPoint(center));
}

// dv/dt = -c v decays like 1 / (1 + h c) a step.
TEST(DynamicsBodies, AreSlowedDownByTheirDamping)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->SetLinearDamping(0.5f);
    body->SetAngularDamping(2.0f);
    body->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    body->SetAngularVelocity(3.0f);
    scene.Step(60);
    EXPECT_NEAR(body->GetLinearVelocity().x, 4.0f * std::exp(-0.5f), 0.02f);
    EXPECT_NEAR(body->GetAngularVelocity(), 3.0f * std::exp(-2.0f), 0.02f);
    body->SetLinearDamping(1e30f);
    scene.Step();
    EXPECT_NEAR(body->GetLinearVelocity().x, 0.0f, 1e-20f);
}

TEST(DynamicsBodies, FallByTheirGravityScale)
{
    Scene scene;
    b2Body* plain = scene.Ball(0.0f, 0.0f);
    b2Body* floating = scene.Ball(5.0f, 0.0f);
    b2Body* rising = scene.Ball(10.0f, 0.0f);
    floating->SetGravityScale(0.0f);
    rising->SetGravityScale(-2.0f);
    scene.Step(30);
    EXPECT_NEAR(plain->GetLinearVelocity().y, -5.0f, 1e-4f);
    EXPECT_EQ(floating->GetLinearVelocity().y, 0.0f);
    EXPECT_NEAR(rising->GetLinearVelocity().y, 10.0f, 1e-4f);
}

TEST(DynamicsBodies, AreMovedByForcesAndImpulses)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(0.0f, 0.0f); // 1 kg, 1/6 kg m^2
    body->ApplyForce(b2Vec2(0.0f, 6.0f), b2Vec2(0.5f, 0.0f));
    scene.Step();
    EXPECT_NEAR(body->GetLinearVelocity().y, 0.1f, 1e-6f);
    EXPECT_NEAR(body->GetAngularVelocity(), 0.3f, 1e-6f);
    scene.Step();
    EXPECT_NEAR(body->GetLinearVelocity().y, 0.1f, 1e-6f) << "forces last one step";
    body->SetLinearVelocity(b2Vec2(0.0f, 0.0f));
    body->SetAngularVelocity(0.0f);
    body->ApplyLinearImpulse(b2Vec2(2.0f, 0.0f), body->GetWorldCenter() + b2Vec2(0.0f, 0.5f));
    EXPECT_NEAR(body->GetLinearVelocity().x, 2.0f, 1e-6f);
    EXPECT_NEAR(body->GetAngularVelocity(), -6.0f, 1e-5f);
    body->ApplyAngularImpulse(1.0f);
    EXPECT_NEAR(body->GetAngularVelocity(), 0.0f, 1e-5f);
    body->ApplyTorque(10.0f);
    scene.Step();
    EXPECT_NEAR(body->GetAngularVelocity(), 1.0f, 1e-5f);
}

TEST(DynamicsBodies, KeepForcesUntilTheyAreClearedOnRequest)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetAutoClearForces(false);
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->ApplyForceToCenter(b2Vec2(60.0f, 0.0f));
    scene.Step(2);
    EXPECT_NEAR(body->GetLinearVelocity().x, 2.0f, 1e-5f);
    scene.world.ClearForces();
    scene.Step();
    EXPECT_NEAR(body->GetLinearVelocity().x, 2.0f, 1e-5f);
    scene.world.SetAutoClearForces(true);
    body->ApplyForceToCenter(b2Vec2(60.0f, 0.0f));
    scene.Step(2);
    EXPECT_NEAR(body->GetLinearVelocity().x, 3.0f, 1e-5f);
}

TEST(DynamicsBodies, AreWokenByForcesUnlessWakeIsFalse)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Box(0.0f, 0.0f);
    const b2Vec2 push(1.0f, 0.0f);
    const b2Vec2 point(0.0f, 0.2f);
    body->SetAwake(false);
    body->ApplyForce(push, point, false);
    body->ApplyForceToCenter(push, false);
    body->ApplyTorque(1.0f, false);
    body->ApplyLinearImpulse(push, point, false);
    body->ApplyAngularImpulse(1.0f, false);
    EXPECT_FALSE(body->IsAwake());
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    body->SetAwake(true);
    scene.Step();
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(0.0f, 0.0f)) << "nothing was kept";
    body->SetAwake(false);
    body->ApplyForce(push, point);
    EXPECT_TRUE(body->IsAwake());
}

TEST(DynamicsBodies, IgnoreForcesWhenStaticOrKinematic)
{
    Scene scene;
    for (const b2BodyType type : {b2_staticBody, b2_kinematicBody})
    {
        b2Body* body = scene.Body(type, 0.0f, 5.0f);
        Scene::AddBall(body, 0.5f);
        body->ApplyForceToCenter(b2Vec2(1e6f, 0.0f));
        body->ApplyLinearImpulse(b2Vec2(1e6f, 0.0f), b2Vec2(0.0f, 0.0f));
        body->ApplyTorque(1e6f);
        scene.Step(10);
        EXPECT_EQ(body->GetPosition(), b2Vec2(0.0f, 5.0f));
        EXPECT_EQ(body->GetAngle(), 0.0f);
    }
    b2Body* ground = scene.Ground();
    ground->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    EXPECT_EQ(ground->GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
}

TEST(DynamicsBodies, ReturnTheVelocityOfTheirPoints)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Body(b2_dynamicBody, 2.0f, 3.0f, 0.5f * b2_pi);
    Scene::AddBox(body, 0.5f, 0.5f);
    body->SetLinearVelocity(b2Vec2(1.0f, 2.0f));
    body->SetAngularVelocity(4.0f);
    const b2Vec2 world = body->GetLinearVelocityFromWorldPoint(b2Vec2(2.0f, 3.5f));
    EXPECT_NEAR(world.x, 1.0f - 4.0f * 0.5f, 1e-5f);
    EXPECT_NEAR(world.y, 2.0f, 1e-5f);
    const b2Vec2 local = body->GetLinearVelocityFromLocalPoint(b2Vec2(0.5f, 0.0f));
    EXPECT_NEAR(local.x, world.x, 1e-5f);
    EXPECT_NEAR(local.y, world.y, 1e-5f);
    EXPECT_NEAR(body->GetLocalPoint(b2Vec2(2.0f, 3.5f)).x, 0.5f, 1e-6f);
    EXPECT_NEAR(body->GetLocalVector(body->GetWorldVector(b2Vec2(0.3f, 0.4f))).y, 0.4f, 1e-6f);
}

TEST(DynamicsBodies, CarryBodiesOnTopWhenKinematic)
{
    Scene scene;
    b2Body* lift = scene.Body(b2_kinematicBody, 0.0f, -0.5f);
    Scene::AddBox(lift, 3.0f, 0.5f, 0.8f);
    b2Body* box = scene.Box(0.0f, 0.5f);
    lift->SetLinearVelocity(b2Vec2(1.0f, 1.0f));
    scene.Step(120);
    EXPECT_NEAR(lift->GetPosition().x, 2.0f, 1e-4f);
    EXPECT_NEAR(lift->GetPosition().y, 1.5f, 1e-4f) << "a load does not hold it back";
    EXPECT_NEAR(box->GetPosition().y - lift->GetPosition().y, 1.0f, 0.02f);
    EXPECT_NEAR(box->GetLinearVelocity().x, 1.0f, 0.01f);
}

TEST(DynamicsBodies, MoveSlowlyTenKilometresFromTheOrigin)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* box = scene.Box(10000.0f, 10000.0f);
    box->SetLinearVelocity(b2Vec2(0.02f, -0.02f));
    scene.Step(600);
    EXPECT_NEAR(box->GetPosition().x - 10000.0f, 0.2f, 0.002f);
    EXPECT_NEAR(box->GetPosition().y - 10000.0f, -0.2f, 0.002f);
}

/// Returns the height of the top of a stack of ten above the ground, after each second.
std::vector<float32> HeightsOfStackAt(float32 place)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, place, place - 1.0f);
    Scene::AddBox(ground, 50.0f, 1.0f);
    b2Body* top = nullptr;
    for (int i = 0; i < 10; ++i)
    {
        top = scene.Box(place, place + 0.5f + kRestingGap + (1.0f + kRestingGap) * float32(i));
    }
    scene.world.SetAllowSleeping(false);
    std::vector<float32> heights;
    for (int second = 0; second < 10; ++second)
    {
        scene.Step(60);
        heights.push_back(top->GetPosition().y - place);
        EXPECT_NEAR(top->GetPosition().x, place, 1e-6f);
        EXPECT_LT(top->GetLinearVelocity().Length(), 0.005f);
    }
    return heights;
}

TEST(DynamicsBodies, StackTenKilometresAwayAsAtTheOrigin)
{
    constexpr float32 kSpacingOfFloats = 0.001f; // at 10 km
    const std::vector<float32> near = HeightsOfStackAt(0.0f);
    const std::vector<float32> far = HeightsOfStackAt(10000.0f);
    for (std::size_t i = 0; i < near.size(); ++i)
    {
        EXPECT_NEAR(far[i], near[i], 2.0f * kSpacingOfFloats) << "second " << i + 1;
    }
}

TEST(DynamicsBodies, ReportFixturesAndJointsDestroyedWithThem)
{
    struct Listener : b2DestructionListener
    {
        void SayGoodbye(b2Joint* joint) override { joints.push_back(joint); }
        void SayGoodbye(b2Fixture* fixture) override { fixtures.push_back(fixture); }
        std::vector<b2Joint*> joints;
        std::vector<b2Fixture*> fixtures;
    };
    Scene scene;
    Listener listener;
    scene.world.SetDestructionListener(&listener);
    b2Body* body = scene.Box(0.0f, 5.0f);
    b2Body* other = scene.Box(3.0f, 5.0f);
    Scene::AddBall(body, 0.7f);
    b2RevoluteJointDef def;
    def.Initialize(body, other, b2Vec2(1.5f, 5.0f));
    b2Joint* joint = scene.world.CreateJoint(&def);
    b2Joint* explicitly = scene.world.CreateJoint(&def);
    scene.world.DestroyJoint(explicitly);
    b2Fixture* last = body->GetFixtureList();
    body->DestroyFixture(last);
    EXPECT_TRUE(listener.joints.empty() && listener.fixtures.empty());
    b2Fixture* first = body->GetFixtureList();
    scene.world.DestroyBody(body);
    EXPECT_EQ(listener.joints, std::vector<b2Joint*>{joint});
    EXPECT_EQ(listener.fixtures, std::vector<b2Fixture*>{first});
    EXPECT_EQ(other->GetJointList(), nullptr);
    EXPECT_EQ(scene.world.GetJointCount(), 0);
}

} // namespace
