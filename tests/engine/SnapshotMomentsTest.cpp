// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"
#include "SnapshotSupport.h"

#include <functional>

/// Snapshots at moments in which a world is in the middle of something.
namespace
{

using namespace snapshots;
using dynamics::Scene;

/// Saves the scene, restores it in another world and compares, for each number of sub-steps.
void ExpectGoesOn(const std::function<void(Scene&)>& build, const Steps& steps = {})
{
    for (const int subSteps : {1, 2, 4})
    {
        SCOPED_TRACE(subSteps);
        Scene scene;
        scene.world.SetSubStepCount(subSteps);
        build(scene);
        b2World restored(b2Vec2(0.0f, 0.0f));
        ExpectRestored(restored, b2SaveSnapshot(scene.world));
        ExpectSameWay(scene.world, restored, steps);
    }
}

void BuildStacks(Scene& scene)
{
    scene.Ground();
    for (int i = 0; i < 6; ++i)
    {
        dynamics::Stack(scene, 3.0f * float32(i), 2 + i);
    }
}

TEST(Snapshot, ContinuesFromBeforeTheFirstStep)
{
    ExpectGoesOn(BuildStacks);
}

TEST(Snapshot, ContinuesASleepingWorldThatABallHits)
{
    ExpectGoesOn([](Scene& scene) {
        BuildStacks(scene);
        scene.Step(240);
        EXPECT_FALSE(BodyAt(scene.world, 0)->IsAwake());
        b2Body* const ball = scene.Ball(-20.0f, 1.0f, 0.8f);
        ball->SetLinearVelocity(b2Vec2(25.0f, 4.0f));
    });
}

TEST(Snapshot, ContinuesWhileSomeBodiesWakeAndTheRestSleep)
{
    ExpectGoesOn([](Scene& scene) {
        BuildStacks(scene);
        scene.Step(240);
        BodyAt(scene.world, 3)->SetAwake(true);
        BodyAt(scene.world, 9)->ApplyLinearImpulse(b2Vec2(3.0f, 1.0f), b2Vec2(0.0f, 0.0f));
    });
}

/// The box may sleep once the island has been taken apart, and not before.
TEST(Snapshot, ContinuesAfterAJointToAPendulumIsDestroyed)
{
    ExpectGoesOn([](Scene& scene) {
        scene.Ground();
        b2Body* const box = scene.Box(8.0f, 0.5f + dynamics::kRestingGap);
        b2Body* const ball = scene.Ball(4.0f, 10.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(scene.Wall(0.0f), ball, b2Vec2(0.0f, 10.0f));
        scene.world.CreateJoint(&hinge);
        b2RopeJointDef rope;
        rope.bodyA = box;
        rope.bodyB = ball;
        rope.maxLength = 40.0f;
        b2Joint* const loose = scene.world.CreateJoint(&rope);
        scene.Step(20);
        scene.world.DestroyJoint(loose);
        scene.Step();
    });
}

TEST(Snapshot, ContinuesWithOneOfTwoJoinedBodiesPutToSleep)
{
    ExpectGoesOn([](Scene& scene) {
        b2Body* const post = scene.Wall(0.0f);
        b2Body* above = post;
        for (int i = 0; i < 5; ++i)
        {
            b2Body* const link = scene.Box(1.0f + float32(i), 10.0f, 0.5f, 0.1f);
            b2RevoluteJointDef hinge;
            hinge.Initialize(above, link, b2Vec2(0.5f + float32(i), 10.0f));
            hinge.enableMotor = i % 2 == 0;
            hinge.maxMotorTorque = 20.0f;
            scene.world.CreateJoint(&hinge);
            above = link;
        }
        scene.Step(30);
        above->SetAwake(false);
    });
}

/// A rod takes the place of a hinge among the joints, with the form of the hinge's rows. The first
/// step finds the number of drifts from it, but not from the hinge's impulses.
TEST(Snapshot, ContinuesWithARodInThePlaceOfAHinge)
{
    ExpectGoesOn([](Scene& scene) {
        b2Body* const platform = scene.Body(b2_kinematicBody, 0.0f, 10.0f);
        platform->SetLinearVelocity(b2Vec2(0.1f, 0.0f));
        b2Body* const ball = scene.Ball(1.0f, 9.0f);
        b2Body* const load = scene.Ball(1.0f, 7.0f, 0.5f);
        load->GetFixtureList()->SetDensity(1000.0f);
        load->ResetMassData();
        b2RevoluteJointDef hinge;
        hinge.Initialize(platform, ball, b2Vec2(0.0f, 10.0f));
        b2Joint* const first = scene.world.CreateJoint(&hinge);
        hinge.Initialize(ball, load, b2Vec2(1.0f, 8.5f));
        b2Joint* const second = scene.world.CreateJoint(&hinge);
        scene.Step(5);
        scene.world.DestroyJoint(first);
        scene.world.DestroyJoint(second);
        b2DistanceJointDef rod;
        rod.Initialize(platform, ball, platform->GetPosition(), b2Vec2(1.3f, 9.2f));
        scene.world.CreateJoint(&rod);
        rod.Initialize(ball, load, b2Vec2(1.2f, 8.8f), load->GetPosition());
        scene.world.CreateJoint(&rod);
    });
}

/// The ball is put to sleep between the impacts of a step, while the list of joints changes. The
/// next step wakes it, and the rope moves it again.
TEST(Snapshot, ContinuesAfterAJoinedBodySleptWithinAStep)
{
    ExpectGoesOn([](Scene& scene) {
        scene.Ground();
        scene.world.SetSubStepping(true);
        b2Body* const ball = scene.Ball(0.0f, 10.0f);
        b2Body* const other = scene.Ball(3.0f, 10.0f);
        other->SetLinearVelocity(b2Vec2(4.0f, 3.0f));
        b2RopeJointDef rope;
        rope.bodyA = ball;
        rope.bodyB = other;
        rope.maxLength = 3.0f;
        scene.world.CreateJoint(&rope);
        rope.maxLength = 30.0f;
        b2Joint* const loose = scene.world.CreateJoint(&rope);
        for (int i = 0; i < 4; ++i)
        {
            b2Body* const bullet =
                scene.Ball(10.0f + 5.0f * float32(i), 1.0f + float32(i) / 3.0f, 0.2f);
            bullet->SetBullet(true);
            bullet->SetLinearVelocity(b2Vec2(0.0f, -200.0f));
        }
        scene.Step();
        scene.world.DestroyJoint(loose);
        ball->SetAwake(false);
        scene.Step();
        EXPECT_FALSE(ball->IsAwake());
        scene.Step(4);
        scene.world.SetSubStepping(false);
        EXPECT_TRUE(ball->IsAwake());
    });
}

/// A heavy ball tears the rods at about one second: bodies have added masses from then on.
TEST(Snapshot, ContinuesWhileAHeavyBallTearsItsRods)
{
    for (const int before : {50, 60, 65, 70, 80, 100})
    {
        SCOPED_TRACE(before);
        const auto build = [&](Scene& scene) {
            const b2Vec2 along = b2Mul(b2Rot(2.0f), b2Vec2(0.0f, -1.0f));
            b2Body* last = scene.Body(b2_staticBody, 0.0f, 0.0f);
            for (int i = 0; i <= 11; ++i)
            {
                const b2Vec2 start = (0.2f + 0.6f * float32(i)) * along;
                b2Body* const next =
                    scene.Box(start.x + 0.2f * along.x, start.y + 0.2f * along.y, 0.05f, 0.2f);
                next->SetTransform(next->GetPosition(), 2.0f);
                b2DistanceJointDef rod;
                rod.Initialize(last, next, start - 0.2f * along, start);
                scene.world.CreateJoint(&rod);
                last = next;
            }
            last->GetFixtureList()->SetDensity(1000.0f);
            last->ResetMassData();
            scene.Step(before);
        };
        ExpectGoesOn(build, {.count = 40});
    }
}

/// Contacts stay in the order that they were put in when the bodies had other places among those
/// that are awake; small piles are solved in that order.
TEST(Snapshot, ContinuesAfterAwakeBodiesWereRenumbered)
{
    ExpectGoesOn([](Scene& scene) {
        std::vector<b2Body*> flying;
        for (int i = 0; i < 40; ++i)
        {
            flying.push_back(scene.Ball(3.0f * float32(i), 900.0f));
        }
        BuildStacks(scene);
        for (int i = 0; i < 5; ++i)
        {
            dynamics::Stack(scene, 40.0f + 3.0f * float32(i), 9);
        }
        scene.Step(20);
        for (b2Body* body : flying)
        {
            scene.world.DestroyBody(body);
        }
    });
}

/// Slow and askew, so that manifolds are kept from earlier poses.
TEST(Snapshot, ContinuesWhileAPileSettles)
{
    for (const int before : {40, 90, 150})
    {
        SCOPED_TRACE(before);
        ExpectGoesOn([&](Scene& scene) {
            scene.Ground();
            scene.Wall(-4.0f);
            scene.Wall(4.0f);
            for (int i = 0; i < 50; ++i)
            {
                b2Body* const body = scene.Body(b2_dynamicBody, float32(i * 5 % 7) - 3.0f,
                                                1.0f + 0.6f * float32(i), 0.37f * float32(i));
                Scene::AddBox(body, 0.3f + 0.02f * float32(i % 5), 0.35f, 0.6f);
            }
            scene.Step(before);
        });
    }
}

TEST(Snapshot, ContinuesWhileBulletsFly)
{
    ExpectGoesOn([](Scene& scene) {
        scene.world.SetGravity(b2Vec2(0.0f, 0.0f));
        for (const float32 x : {-12.0f, 12.0f})
        {
            scene.Wall(x, 0.02f);
        }
        for (int i = 0; i < 60; ++i)
        {
            b2Body* const ball =
                scene.Ball(0.3f * float32(i) - 9.0f, float32(i * 7 % 19) * 0.5f - 4.5f, 0.08f);
            ball->SetBullet(true);
            ball->SetLinearVelocity(b2Vec2(float32(i * 37 % 200) - 100.0f, float32(i % 9) - 4.0f));
            ball->GetFixtureList()->SetRestitution(0.9f);
        }
        scene.Step(17);
    });
}

TEST(Snapshot, ContinuesBetweenTheImpactsOfAStep)
{
    ExpectGoesOn([](Scene& scene) {
        scene.world.SetSubStepping(true);
        scene.Wall(-5.0f);
        scene.Wall(5.0f);
        for (int i = 0; i < 8; ++i)
        {
            scene.Ball(float32(i) - 4.0f, float32(i), 0.2f)
                ->SetLinearVelocity(b2Vec2(60.0f - 20.0f * float32(i), 3.0f));
        }
        scene.Step(13);
    });
}

/// Enough static shapes that their tree is rebuilt after the snapshot.
TEST(Snapshot, ContinuesWhileTheGroundGrows)
{
    const auto grow = [](b2World& world, int step) {
        b2BodyDef definition;
        definition.position.Set(float32(step % 40) - 20.0f, -3.0f - 0.1f * float32(step));
        b2Body* const body = world.CreateBody(&definition);
        b2CircleShape shape;
        shape.m_radius = 0.3f;
        for (int i = 0; i < 12; ++i)
        {
            shape.m_p.Set(float32(i), 0.0f);
            body->CreateFixture(&shape, 0.0f);
        }
    };
    Scene scene;
    for (int i = 0; i < 30; ++i)
    {
        scene.Ball(float32(i) - 15.0f, 2.0f, 0.3f);
        grow(scene.world, i);
    }
    scene.Step(10);
    b2World restored(b2Vec2(0.0f, 0.0f));
    ExpectRestored(restored, b2SaveSnapshot(scene.world));
    ExpectSameWay(scene.world, restored, Steps(), grow);
}

/// A gear's two joints, its frame and a motor against a limit.
void BuildGears(Scene& scene)
{
    b2Body* const frame = scene.Ground();
    b2Joint* parts[2];
    for (int i = 0; i < 2; ++i)
    {
        b2Body* const wheel = scene.Ball(3.0f * float32(i), 5.0f, 1.0f);
        b2RevoluteJointDef axle;
        axle.Initialize(frame, wheel, wheel->GetPosition());
        axle.enableMotor = i == 0;
        axle.motorSpeed = 3.0f;
        axle.maxMotorTorque = 100.0f;
        axle.enableLimit = i == 1;
        axle.lowerAngle = -4.0f;
        axle.upperAngle = 4.0f;
        parts[i] = scene.world.CreateJoint(&axle);
    }
    b2GearJointDef gear;
    gear.bodyA = parts[0]->GetBodyB();
    gear.bodyB = parts[1]->GetBodyB();
    gear.joint1 = parts[0];
    gear.joint2 = parts[1];
    gear.ratio = -0.7f;
    scene.world.CreateJoint(&gear);
}

TEST(Snapshot, ContinuesWhileGearsTurnIntoTheirLimits)
{
    ExpectGoesOn([](Scene& scene) {
        BuildGears(scene);
        scene.Step(40);
    });
}

TEST(Snapshot, ContinuesAGearWhoseBodyHasChangedItsType)
{
    ExpectGoesOn([](Scene& scene) {
        BuildGears(scene);
        BodyAt(scene.world, 0)->SetType(b2_kinematicBody);
        scene.Step(5);
    });
}

/// A light link between a post and a load of a thousand times its mass, with an energy account. A
/// recent user change must not be removed.
void BuildLoad(Scene& scene)
{
    b2Body* const post = scene.Wall(0.0f);
    b2Body* const link = scene.Box(1.0f, 8.0f, 1.0f, 0.05f);
    b2Body* const load = scene.Box(4.0f, 8.0f, 1.0f, 1.0f);
    load->GetFixtureList()->SetDensity(50.0f);
    load->ResetMassData();
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, link, b2Vec2(0.0f, 8.0f));
    scene.world.CreateJoint(&hinge);
    b2RopeJointDef rope;
    rope.bodyA = link;
    rope.bodyB = load;
    rope.localAnchorA.Set(1.0f, 0.0f);
    rope.localAnchorB.Set(-1.0f, 0.0f);
    rope.maxLength = 1.0f;
    scene.world.CreateJoint(&rope);
    scene.Step(45);
}

TEST(Snapshot, ContinuesAfterTheProgramHasMovedABody)
{
    ExpectGoesOn([](Scene& scene) {
        BuildLoad(scene);
        b2Body* const load = BodyAt(scene.world, 0);
        load->SetTransform(load->GetPosition() + b2Vec2(2.0f, -1.5f), load->GetAngle());
    });
}

TEST(Snapshot, ContinuesAfterTheProgramHasShortenedARope)
{
    ExpectGoesOn([](Scene& scene) {
        BuildLoad(scene);
        static_cast<b2RopeJoint*>(JointAt(scene.world, 0))->SetMaxLength(0.4f);
    });
}

TEST(Snapshot, ContinuesWhenTheSubStepCountChangesNext)
{
    for (const int before : {1, 4})
    {
        SCOPED_TRACE(before);
        Scene scene;
        scene.world.SetSubStepCount(before);
        BuildStacks(scene);
        BuildGears(scene);
        scene.Step(20);
        b2World restored(b2Vec2(0.0f, 0.0f));
        ExpectRestored(restored, b2SaveSnapshot(scene.world));
        ExpectSameWay(scene.world, restored, Steps(), [&](b2World& world, int step) {
            world.SetSubStepCount(step % 20 < 10 ? 5 - before : before);
        });
    }
}

TEST(Snapshot, EmptiesAWorldWhenTakenOfAnEmptyOne)
{
    const b2World empty(b2Vec2(1.0f, 2.0f), false);
    Scene scene;
    BuildStacks(scene);
    scene.Step(3);
    ExpectRestored(scene.world, b2SaveSnapshot(empty));
    EXPECT_EQ(scene.world.GetBodyCount(), 0);
    EXPECT_EQ(scene.world.GetContactCount(), 0);
    EXPECT_EQ(scene.world.GetProxyCount(), 0);
    EXPECT_EQ(scene.world.GetGravity(), b2Vec2(1.0f, 2.0f));
    EXPECT_FALSE(scene.world.GetAllowSleeping());
    scene.Step();
}

/// Via a world with other content.
TEST(Snapshot, GivesTheSameStateEachTimeItIsRestored)
{
    Scene scene;
    BuildStacks(scene);
    scene.Step(50);
    const Bytes bytes = b2SaveSnapshot(scene.world);
    Bytes ends[3];
    for (Bytes& end : ends)
    {
        ExpectRestored(scene.world, bytes);
        scene.Step(77);
        end = b2SaveSnapshot(scene.world);
    }
    EXPECT_TRUE(ends[0] == ends[1]);
    EXPECT_TRUE(ends[0] == ends[2]);
}

} // namespace
