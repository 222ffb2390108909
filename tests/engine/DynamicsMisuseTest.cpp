// SPDX-License-Identifier: MIT
#include "DynamicsMisuse.h"
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

/// Misuse by the caller. With asserts, each mistake ends the program with a message. Without
/// asserts, it is ignored or corrected, and the world stays valid.
namespace
{

using namespace dynamics;

/// After a mistake the world must still be whole, and go on.
void ExpectWhole(Scene& scene)
{
    EXPECT_EQ(WhyBroken(scene.world, false), "");
    scene.Step(3);
    EXPECT_EQ(WhyBroken(scene.world, true), "");
}

class DynamicsMisuse : public testing::Test
{
protected:
    DynamicsMisuse()
    {
        testing::FLAGS_gtest_death_test_style = "fast";
        ground = scene.Ground();
        box = scene.Box(0.0f, 0.515f);
        other = scene.Box(0.2f, 1.53f);
    }
    ~DynamicsMisuse() override { ExpectWhole(scene); }

    Scene scene;
    b2Body* ground = nullptr;
    b2Body* box = nullptr;
    b2Body* other = nullptr;
};

TEST_F(DynamicsMisuse, IsRefusedInBodyDefinitions)
{
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (const float32 bad : {kNaN, kInfinity, -kInfinity})
    {
        b2BodyDef wrong = def;
        wrong.position.x = bad;
        ExpectMisuse("position", [&] { scene.world.CreateBody(&wrong); });
        wrong = def;
        wrong.angle = bad;
        ExpectMisuse("angle", [&] { scene.world.CreateBody(&wrong); });
        wrong = def;
        wrong.linearVelocity.y = bad;
        ExpectMisuse("velocities", [&] { scene.world.CreateBody(&wrong); });
        wrong = def;
        wrong.angularVelocity = bad;
        ExpectMisuse("velocities", [&] { scene.world.CreateBody(&wrong); });
        wrong = def;
        wrong.gravityScale = bad;
        ExpectMisuse("gravity scale", [&] { scene.world.CreateBody(&wrong); });
    }
    for (const float32 bad : {kNaN, -1.0f, -kInfinity}) // plus infinity is a damping
    {
        b2BodyDef wrong = def;
        wrong.linearDamping = bad;
        ExpectMisuse("damping", [&] { scene.world.CreateBody(&wrong); });
        wrong = def;
        wrong.angularDamping = bad;
        ExpectMisuse("damping", [&] { scene.world.CreateBody(&wrong); });
        ExpectMisuse("damping", [&] { box->SetLinearDamping(bad); });
        ExpectMisuse("damping", [&] { box->SetAngularDamping(bad); });
    }
    b2BodyDef wrong = def;
    wrong.type = static_cast<b2BodyType>(3);
    ExpectMisuse("type", [&] { scene.world.CreateBody(&wrong); });
    ExpectMisuse("definition", [&] { EXPECT_EQ(scene.world.CreateBody(nullptr), nullptr); });
}

/// An edge's box hides one bad end: it is made of the smaller and the larger numbers.
TEST_F(DynamicsMisuse, IsRefusedForEdgesWithAnEndThatIsNoNumber)
{
    for (const bool first : {true, false})
    {
        const b2Vec2 bad(kNaN, 0.0f);
        b2EdgeShape edge;
        edge.Set(first ? bad : b2Vec2_zero, first ? b2Vec2_zero : bad);
        ExpectMisuse("finite", [&] { box->CreateFixture(&edge, 0.0f); });
    }
}

TEST_F(DynamicsMisuse, IsRefusedForMassDataWithoutAPlace)
{
    ExpectMisuse("GetMassData", [&] { box->GetMassData(nullptr); });
}

TEST_F(DynamicsMisuse, IsRefusedForPlacesBeyondTheWorldsReach)
{
    for (const float32 far : {1.1e15f, 1e20f, -1e38f})
    {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position.Set(0.0f, far);
        ExpectMisuse("within 1e15", [&] { scene.world.CreateBody(&def); });
        ExpectMisuse("within 1e15", [&] { box->SetTransform(b2Vec2(far, 0.0f), 0.0f); });
        ExpectMisuse("within 1e15", [&] { scene.world.ShiftOrigin(b2Vec2(far, 0.0f)); });
        b2EdgeShape edge;
        edge.Set(b2Vec2(0.0f, 0.0f), b2Vec2(far, 0.0f));
        ExpectMisuse("within 1e15", [&] { box->CreateFixture(&edge, 0.0f); });
        edge.Set(b2Vec2(far, 0.0f), b2Vec2(0.0f, 0.0f));
        ExpectMisuse("within 1e15", [&] { box->CreateFixture(&edge, 0.0f); });
        b2MouseJointDef mouse;
        mouse.bodyA = ground;
        mouse.bodyB = box;
        mouse.target.Set(far, 0.0f);
        mouse.maxForce = 1.0f;
        ExpectMisuse("within 1e15", [&] { scene.world.CreateJoint(&mouse); });
    }
}

TEST_F(DynamicsMisuse, IsRefusedByTheSettersOfABody)
{
    for (const float32 bad : {kNaN, kInfinity, -kInfinity})
    {
        ExpectMisuse("finite", [&] { box->SetTransform(b2Vec2(bad, 0.0f), 0.0f); });
        ExpectMisuse("finite", [&] { box->SetTransform(b2Vec2(0.0f, 0.0f), bad); });
        ExpectMisuse("finite", [&] { box->SetLinearVelocity(b2Vec2(0.0f, bad)); });
        ExpectMisuse("finite", [&] { box->SetAngularVelocity(bad); });
        ExpectMisuse("gravity scale", [&] { box->SetGravityScale(bad); });
        ExpectMisuse("finite", [&] { box->ApplyForce(b2Vec2(bad, 0.0f), b2Vec2(0.0f, 0.0f)); });
        ExpectMisuse("finite", [&] { box->ApplyForce(b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, bad)); });
        ExpectMisuse("finite", [&] { box->ApplyForceToCenter(b2Vec2(bad, 0.0f)); });
        ExpectMisuse("finite", [&] { box->ApplyTorque(bad); });
        ExpectMisuse("finite", [&] { box->ApplyLinearImpulse(b2Vec2(bad, 0.0f), b2Vec2()); });
        ExpectMisuse("finite", [&] { box->ApplyAngularImpulse(bad); });
    }
    ExpectMisuse("type", [&] { box->SetType(static_cast<b2BodyType>(3)); });
}

TEST_F(DynamicsMisuse, IsRefusedInMassData)
{
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        b2MassData data;
        data.mass = bad;
        data.center.SetZero();
        data.I = 1.0f;
        ExpectMisuse("mass", [&] { box->SetMassData(&data); });
        data.mass = 1.0f;
        data.I = bad;
        ExpectMisuse("mass", [&] { box->SetMassData(&data); });
    }
    b2MassData data;
    data.mass = 1.0f;
    data.I = 1.0f;
    data.center.Set(kNaN, 0.0f);
    ExpectMisuse("mass", [&] { box->SetMassData(&data); });
    ExpectMisuse("mass", [&] { box->SetMassData(nullptr); });
    EXPECT_GT(box->GetMass(), 0.0f);
}

TEST_F(DynamicsMisuse, IsRefusedInFixtureDefinitions)
{
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    b2FixtureDef def;
    ExpectMisuse("shape", [&] { EXPECT_EQ(box->CreateFixture(&def), nullptr); });
    ExpectMisuse("definition", [&] { EXPECT_EQ(box->CreateFixture(nullptr), nullptr); });
    def.shape = &circle;
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        b2FixtureDef wrong = def;
        wrong.density = bad;
        ExpectMisuse("density", [&] { box->CreateFixture(&wrong); });
        wrong = def;
        wrong.friction = bad;
        ExpectMisuse("friction", [&] { box->CreateFixture(&wrong); });
        wrong = def;
        wrong.restitution = bad;
        ExpectMisuse("restitution", [&] { box->CreateFixture(&wrong); });
        b2Fixture* fixture = box->GetFixtureList();
        ExpectMisuse("density", [&] { fixture->SetDensity(bad); });
        ExpectMisuse("friction", [&] { fixture->SetFriction(bad); });
        ExpectMisuse("restitution", [&] { fixture->SetRestitution(bad); });
    }
    ExpectMisuse("of this body", [&] { box->DestroyFixture(other->GetFixtureList()); });
    ExpectMisuse("of this body", [&] { box->DestroyFixture(nullptr); });
}

TEST_F(DynamicsMisuse, IsRefusedInShapes)
{
    const int32 proxies = scene.world.GetProxyCount();
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        b2CircleShape circle;
        circle.m_radius = bad;
        ExpectMisuse("shape", [&] { EXPECT_EQ(box->CreateFixture(&circle, 1.0f), nullptr); });
    }
    b2CircleShape far;
    far.m_radius = 1.0f;
    far.m_p.Set(kNaN, 0.0f);
    ExpectMisuse("shape", [&] { EXPECT_EQ(box->CreateFixture(&far, 1.0f), nullptr); });
    b2PolygonShape empty;
    ExpectMisuse("shape", [&] { EXPECT_EQ(box->CreateFixture(&empty, 1.0f), nullptr); });
    b2ChainShape chain;
    ExpectMisuse("shape", [&] { EXPECT_EQ(box->CreateFixture(&chain, 1.0f), nullptr); });
    EXPECT_EQ(scene.world.GetProxyCount(), proxies);
}

TEST_F(DynamicsMisuse, IsRefusedInJointDefinitions)
{
    b2RevoluteJointDef def;
    ExpectMisuse("two bodies", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });
    def.Initialize(box, box, b2Vec2(0.0f, 0.0f));
    ExpectMisuse("different", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });
    ExpectMisuse("definition", [&] { EXPECT_EQ(scene.world.CreateJoint(nullptr), nullptr); });
    b2JointDef none;
    none.bodyA = box;
    none.bodyB = other;
    ExpectMisuse("type", [&] { EXPECT_EQ(scene.world.CreateJoint(&none), nullptr); });
    Scene elsewhere;
    def.Initialize(box, elsewhere.Box(0.0f, 0.0f), b2Vec2(0.0f, 0.0f));
    ExpectMisuse("of this world", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });
    ExpectMisuse("joint", [&] { scene.world.DestroyJoint(nullptr); });
    EXPECT_EQ(scene.world.GetJointCount(), 0);
}

TEST_F(DynamicsMisuse, IsRefusedInNumbersOfJointDefinitions)
{
    for (const float32 bad : {kNaN, kInfinity})
    {
        b2DistanceJointDef def;
        def.Initialize(ground, box, b2Vec2(0.0f, 3.0f), b2Vec2(0.0f, 1.0f));
        def.localAnchorB.x = bad;
        ExpectMisuse("finite", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });
        def.localAnchorB.x = 0.0f;
        def.length = bad;
        ExpectMisuse("length", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });
        def.length = 1.0f;
        def.frequencyHz = bad;
        ExpectMisuse("frequency", [&] { EXPECT_EQ(scene.world.CreateJoint(&def), nullptr); });

        b2RevoluteJointDef hinge;
        hinge.Initialize(ground, box, b2Vec2(0.0f, 1.0f));
        hinge.motorSpeed = bad;
        ExpectMisuse("motor", [&] { EXPECT_EQ(scene.world.CreateJoint(&hinge), nullptr); });
        hinge.motorSpeed = 0.0f;
        hinge.referenceAngle = bad;
        ExpectMisuse("angle", [&] { EXPECT_EQ(scene.world.CreateJoint(&hinge), nullptr); });
    }
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, box, b2Vec2(0.0f, 1.0f));
    hinge.enableLimit = true;
    hinge.lowerAngle = 1.0f;
    hinge.upperAngle = -1.0f;
    ExpectMisuse("limit", [&] { EXPECT_EQ(scene.world.CreateJoint(&hinge), nullptr); });
    hinge.upperAngle = 2.0f;
    auto* joint = static_cast<b2RevoluteJoint*>(scene.world.CreateJoint(&hinge));
    ASSERT_NE(joint, nullptr);
    ExpectMisuse("limit", [&] { joint->SetLimits(1.0f, -1.0f); });
    ExpectMisuse("limit", [&] { joint->SetLimits(kNaN, kNaN); });
    ExpectMisuse("motor", [&] { joint->SetMotorSpeed(kNaN); });
    ExpectMisuse("motor", [&] { joint->SetMaxMotorTorque(kNaN); });
    ExpectMisuse("motor", [&] { joint->SetMaxMotorTorque(-1.0f); });
    EXPECT_EQ(joint->GetLowerLimit(), 1.0f);
    EXPECT_EQ(joint->GetMotorSpeed(), 0.0f);
    EXPECT_EQ(joint->GetMaxMotorTorque(), 0.0f);
}

TEST_F(DynamicsMisuse, IsRefusedInNumbersOfTheWorld)
{
    ExpectMisuse("gravity", [&] { scene.world.SetGravity(b2Vec2(kNaN, 0.0f)); });
    ExpectMisuse("gravity", [] { b2World world(b2Vec2(0.0f, kInfinity)); });
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("restitution threshold", [&] { scene.world.SetRestitutionThreshold(bad); });
    }
    ExpectMisuse("finite", [&] { scene.world.ShiftOrigin(b2Vec2(kNaN, 0.0f)); });
    ExpectMisuse("time step", [&] { scene.world.Step(kNaN, 8, 3); });
    ExpectMisuse("time step", [&] { scene.world.Step(kInfinity, 8, 3); });
    ExpectMisuse("time step", [&] { scene.world.Step(-kStep, 8, 3); });
    ExpectMisuse("iterations", [&] { scene.world.Step(kStep, -1, 3); });
    ExpectMisuse("iterations", [&] { scene.world.Step(kStep, 8, -1); });
    EXPECT_TRUE(scene.world.GetGravity().IsValid());
    EXPECT_EQ(scene.world.GetRestitutionThreshold(), b2_velocityThreshold);
}

TEST_F(DynamicsMisuse, IsRefusedInContactMaterials)
{
    scene.Step();
    b2Contact* contact = box->GetContactList()->contact;
    for (const float32 bad : {kNaN, kInfinity, -1.0f})
    {
        ExpectMisuse("friction", [&] { contact->SetFriction(bad); });
        ExpectMisuse("restitution", [&] { contact->SetRestitution(bad); });
    }
    ExpectMisuse("tangent speed", [&] { contact->SetTangentSpeed(kNaN); });
}

TEST_F(DynamicsMisuse, IsRefusedFromContactListeners)
{
    struct Meddler : b2ContactListener
    {
        void PreSolve(b2Contact* contact, const b2Manifold*) override { meddle(contact); }
        std::function<void(b2Contact*)> meddle;
    };
    Meddler meddler;
    scene.world.SetContactListener(&meddler);
    const auto fromCallback = [&](const std::function<void()>& meddle) {
        ExpectMisuse("callback", [&] {
            meddler.meddle = [&](b2Contact*) { meddle(); };
            scene.Step(3);
        });
        EXPECT_EQ(scene.world.GetBodyCount(), 3);
        EXPECT_EQ(scene.world.GetJointCount(), 0);
    };
    b2BodyDef bodyDef;
    b2CircleShape circle;
    circle.m_radius = 0.1f;
    b2DistanceJointDef jointDef;
    jointDef.Initialize(box, other, box->GetPosition(), other->GetPosition());
    fromCallback([&] { EXPECT_EQ(scene.world.CreateBody(&bodyDef), nullptr); });
    fromCallback([&] { scene.world.DestroyBody(box); });
    fromCallback([&] { EXPECT_EQ(scene.world.CreateJoint(&jointDef), nullptr); });
    fromCallback([&] { EXPECT_EQ(box->CreateFixture(&circle, 1.0f), nullptr); });
    fromCallback([&] { box->DestroyFixture(box->GetFixtureList()); });
    fromCallback([&] { box->SetTransform(b2Vec2(9.0f, 9.0f), 0.0f); });
    fromCallback([&] { box->SetType(b2_staticBody); });
    fromCallback([&] { box->SetActive(false); });
    fromCallback([&] { scene.world.Step(kStep, 8, 3); });
    fromCallback([&] { scene.world.ShiftOrigin(b2Vec2(1.0f, 1.0f)); });
    meddler.meddle = [](b2Contact*) {};
    scene.Step();
    scene.world.SetContactListener(nullptr);
}

TEST_F(DynamicsMisuse, IsRefusedFromQueriesAndRayCasts)
{
    struct Destroyer : b2QueryCallback, b2RayCastCallback
    {
        bool ReportFixture(b2Fixture* fixture) override
        {
            world->DestroyBody(fixture->GetBody());
            return true;
        }
        float32 ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float32) override
        {
            world->DestroyBody(fixture->GetBody());
            return 1.0f;
        }
        b2World* world = nullptr;
    };
    Destroyer destroyer;
    destroyer.world = &scene.world;
    b2AABB all;
    all.lowerBound.Set(-100.0f, -100.0f);
    all.upperBound.Set(100.0f, 100.0f);
    ExpectMisuse("callback", [&] { scene.world.QueryAABB(&destroyer, all); });
    ExpectMisuse("callback",
                 [&] { scene.world.RayCast(&destroyer, b2Vec2(0.0f, 9.0f), b2Vec2(0.0f, -9.0f)); });
    EXPECT_EQ(scene.world.GetBodyCount(), 3);
    EXPECT_FALSE(scene.world.IsLocked());
}

TEST_F(DynamicsMisuse, IsRefusedFromEndContactAndSayGoodbye)
{
    struct Destroyer : b2ContactListener, b2DestructionListener
    {
        void EndContact(b2Contact*) override { world->DestroyBody(victim); }
        void SayGoodbye(b2Joint*) override { world->DestroyBody(victim); }
        void SayGoodbye(b2Fixture*) override { world->DestroyBody(victim); }
        b2World* world = nullptr;
        b2Body* victim = nullptr;
    };
    scene.Step();
    b2DistanceJointDef def;
    def.Initialize(box, other, box->GetPosition(), other->GetPosition());
    def.collideConnected = true;
    scene.world.CreateJoint(&def);
    Destroyer destroyer;
    destroyer.world = &scene.world;
    destroyer.victim = other;
    scene.world.SetContactListener(&destroyer);
    ExpectMisuse("callback", [&] { box->SetActive(false); });
    scene.world.SetContactListener(nullptr);
    scene.world.SetDestructionListener(&destroyer);
    ExpectMisuse("callback", [&] { scene.world.DestroyBody(box); });
    scene.world.SetDestructionListener(nullptr);
}

// ---- Odd numbers that are not forbidden

TEST_F(DynamicsMisuse, IsRefusedForObjectsOfAnotherWorld)
{
    Scene elsewhere;
    b2Body* post = elsewhere.Ground();
    b2Body* wheel = elsewhere.Box(0.0f, 5.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, wheel, wheel->GetPosition());
    b2Joint* foreign = elsewhere.world.CreateJoint(&hinge);
    hinge.Initialize(ground, box, box->GetPosition());
    b2Joint* own = scene.world.CreateJoint(&hinge);
    ExpectMisuse("of this world", [&] { scene.world.DestroyJoint(foreign); });
    ExpectMisuse("of this world", [&] { scene.world.DestroyBody(wheel); });
    b2GearJointDef gear;
    gear.bodyA = box;
    gear.bodyB = other;
    gear.joint1 = own;
    gear.joint2 = foreign;
    ExpectMisuse("world", [&] { EXPECT_EQ(scene.world.CreateJoint(&gear), nullptr); });
    EXPECT_EQ(elsewhere.world.GetJointCount(), 1);
}

TEST_F(DynamicsMisuse, IsRefusedInQueriesWithoutACallback)
{
    b2AABB everything;
    everything.lowerBound.Set(-9.0f, -9.0f);
    everything.upperBound.Set(9.0f, 9.0f);
    ExpectMisuse("callback", [&] { scene.world.QueryAABB(nullptr, everything); });
    ExpectMisuse("callback", [&] { scene.world.RayCast(nullptr, b2Vec2(), b2Vec2(1.0f, 0.0f)); });
}

} // namespace
