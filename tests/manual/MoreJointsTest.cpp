// SPDX-License-Identifier: MIT
#include "../engine/JointScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// The chapter about joints from the pulley to the motor joint, section by section. The numerical
/// guarantees of each joint are tested in tests/engine/Joint*Test.cpp.
namespace
{

using dynamics::JointScene;

/// Two boxes under two ground points, as in the listing.
struct Pulley : public JointScene
{
    explicit Pulley(float32 ratio = 1.0f, float32 densityOfSecond = 1.0f)
    {
        myBody2->GetFixtureList()->SetDensity(densityOfSecond);
        myBody2->ResetMassData();
        const b2Vec2 p1 = myBody1->GetPosition(), p2 = myBody2->GetPosition();

        b2Vec2 anchor1 = myBody1->GetWorldCenter();
        b2Vec2 anchor2 = myBody2->GetWorldCenter();
        b2Vec2 groundAnchor1(p1.x, p1.y + 10.0f);
        b2Vec2 groundAnchor2(p2.x, p2.y + 12.0f);
        b2PulleyJointDef jointDef;
        jointDef.Initialize(myBody1, myBody2, groundAnchor1, groundAnchor2, anchor1, anchor2,
                            ratio);
        joint = Create<b2PulleyJoint>(jointDef);
    }

    b2Body* myBody1 = Load(-4.0f, 0.0f);
    b2Body* myBody2 = Load(4.0f, 0.0f);
    b2PulleyJoint* joint;
};

TEST(PulleyJointSection, KeepsTheRopeLengthInTheListing)
{
    Pulley pulley(1.0f, 2.0f);
    EXPECT_NEAR(pulley.joint->GetLengthA(), 10.0f, 1e-5f);
    EXPECT_NEAR(pulley.joint->GetLengthB(), 12.0f, 1e-5f);
    pulley.Step(60);
    EXPECT_GT(pulley.myBody1->GetPosition().y, 0.5f) << "the lighter one goes up";
    EXPECT_LT(pulley.myBody2->GetPosition().y, -0.5f);
    EXPECT_NEAR(pulley.joint->GetLengthA() + pulley.joint->GetLengthB(), 22.0f, 0.02f);
}

TEST(PulleyJointSection, DoublesAPathAndHalvesAForceAtARatioOfTwo)
{
    Pulley pulley(2.0f, 2.0f); // twice the weight on the slow side: in balance
    pulley.Step(60);
    EXPECT_NEAR(pulley.myBody1->GetLinearVelocity().y, 0.0f, 1e-3f);
    pulley.myBody2->SetLinearVelocity(b2Vec2(0.0f, -1.0f));
    pulley.myBody1->SetLinearVelocity(b2Vec2(0.0f, 2.0f));
    pulley.Step(60);
    const float32 way1 = pulley.joint->GetLengthA() - 10.0f;
    const float32 way2 = pulley.joint->GetLengthB() - 12.0f;
    EXPECT_GT(way2, 0.9f);
    EXPECT_NEAR(way1, -2.0f * way2, 0.05f);
    EXPECT_NEAR(pulley.joint->GetReactionForce().Length(), 20.0f, 0.5f) << "on the second body";
}

/// A wheel on a hinge and a rack on a slider, geared.
struct Gears : public JointScene
{
    Gears() : JointScene(b2Vec2_zero)
    {
        b2RevoluteJointDef hinge;
        hinge.Initialize(ground, myBodyA, myBodyA->GetPosition());
        myRevoluteJoint = Create<b2RevoluteJoint>(hinge);
        b2PrismaticJointDef slider;
        slider.Initialize(ground, myBodyB, myBodyB->GetPosition(), b2Vec2(1.0f, 0.0f));
        myPrismaticJoint = Create<b2PrismaticJoint>(slider);
    }

    b2GearJoint* Gear(float32 ratio)
    {
        b2GearJointDef jointDef;
        jointDef.bodyA = myBodyA;
        jointDef.bodyB = myBodyB;
        jointDef.joint1 = myRevoluteJoint;
        jointDef.joint2 = myPrismaticJoint;
        jointDef.ratio = ratio;
        return Create<b2GearJoint>(jointDef);
    }

    float32 Coordinate(float32 ratio) const
    {
        return myRevoluteJoint->GetJointAngle() + ratio * myPrismaticJoint->GetJointTranslation();
    }

    b2Body* ground = Post();
    b2Body* myBodyA = Load(0.0f, 0.0f);
    b2Body* myBodyB = Load(0.0f, 3.0f);
    b2RevoluteJoint* myRevoluteJoint;
    b2PrismaticJoint* myPrismaticJoint;
};

TEST(GearJointSection, TurnsAWheelOncePerRackLengthInTheListing)
{
    Gears gears;
    const float32 myLength = 2.0f;
    const float32 ratio = 2.0f * b2_pi / myLength;
    b2GearJoint* joint = gears.Gear(2.0f * b2_pi / myLength);
    EXPECT_EQ(joint->GetRatio(), ratio);
    EXPECT_EQ(joint->GetJoint1(), gears.myRevoluteJoint);
    EXPECT_EQ(joint->GetJoint2(), gears.myPrismaticJoint);
    gears.myBodyB->SetLinearVelocity(b2Vec2(-4.0f, 0.0f));
    gears.Step(60);
    EXPECT_LT(gears.myPrismaticJoint->GetJointTranslation(), -0.1f);
    EXPECT_GT(gears.myRevoluteJoint->GetJointAngle(), 0.1f);
    EXPECT_NEAR(gears.Coordinate(ratio), 0.0f, 0.01f);
}

TEST(GearJointSection, AcceptsANegativeRatio)
{
    Gears gears;
    gears.Gear(-1.5f);
    gears.myBodyB->SetLinearVelocity(b2Vec2(2.0f, 0.0f));
    gears.Step(60);
    EXPECT_GT(gears.myRevoluteJoint->GetJointAngle(), 0.1f);
    EXPECT_NEAR(gears.Coordinate(-1.5f), 0.0f, 0.01f);
}

TEST(GearJointSection, IsDestroyedWithItsJoints)
{
    // The specification requires gears to be deleted first and warns of a crash.
    Gears gears;
    gears.Gear(1.0f);
    gears.world.DestroyJoint(gears.myRevoluteJoint);
    EXPECT_EQ(gears.world.GetJointCount(), 1);
    EXPECT_EQ(gears.world.GetJointList(), gears.myPrismaticJoint);
    gears.Step(10);
}

TEST(MouseJointSection, DrivesAPointOfABodyTowardsTheTarget)
{
    JointScene scene;
    b2Body* body = scene.Load(0.0f, 0.0f);
    b2MouseJointDef jointDef;
    jointDef.bodyA = scene.Post();
    jointDef.bodyB = body;
    jointDef.target = body->GetWorldPoint(b2Vec2(0.25f, 0.5f));
    jointDef.maxForce = 1000.0f * body->GetMass();
    jointDef.frequencyHz = 5.0f;
    jointDef.dampingRatio = 0.7f;
    auto* joint = scene.Create<b2MouseJoint>(jointDef);
    EXPECT_EQ(joint->GetAnchorB(), jointDef.target) << "where it grabbed";
    joint->SetTarget(b2Vec2(3.0f, 4.0f));
    scene.Step(600);
    // It hangs below the target by what the spring gives under the weight.
    EXPECT_NEAR(b2Distance(joint->GetAnchorB(), b2Vec2(3.0f, 4.0f)), 0.0f, 0.02f);
    EXPECT_GT(b2Abs(body->GetAngle()), 0.1f) << "rotation is free";
}

TEST(MouseJointSection, PullsNoBodyThroughAWallWithItsMaxForce)
{
    JointScene scene(b2Vec2_zero);
    scene.Wall(2.0f);
    b2Body* body = scene.Load(0.0f, 0.0f);
    b2MouseJointDef jointDef;
    jointDef.bodyA = scene.Post();
    jointDef.bodyB = body;
    jointDef.target = body->GetPosition();
    jointDef.maxForce = 20.0f * body->GetMass();
    auto* joint = scene.Create<b2MouseJoint>(jointDef);
    joint->SetTarget(b2Vec2(10.0f, 0.0f));
    scene.Step(120);
    EXPECT_LT(body->GetPosition().x, 1.5f);
    EXPECT_NEAR(joint->GetReactionForce().Length(), 20.0f * body->GetMass(), 0.1f);
}

TEST(WheelJointSection, KeepsAPointOnALineWithASpring)
{
    JointScene scene;
    scene.Ground();
    b2Body* chassis = scene.Load(0.0f, 2.0f, 1.0f, 0.25f);
    b2Body* wheel = scene.Ball(0.0f, 1.0f, 0.4f);
    b2WheelJointDef jointDef;
    jointDef.Initialize(chassis, wheel, wheel->GetPosition(), b2Vec2(0.0f, 1.0f));
    jointDef.frequencyHz = 4.0f;
    jointDef.dampingRatio = 0.7f;
    auto* joint = scene.Create<b2WheelJoint>(jointDef);
    wheel->SetAngularVelocity(-5.0f);
    for (int i = 0; i < 60; ++i)
    {
        scene.Step();
        const b2Vec2 axis = chassis->GetWorldVector(joint->GetLocalAxisA());
        EXPECT_NEAR(b2Cross(axis, joint->GetAnchorB() - joint->GetAnchorA()), 0.0f, 0.02f);
    }
    EXPECT_LT(joint->GetSpringDampingRatio(), 1.0f);
    EXPECT_GT(joint->GetJointTranslation(), 0.0f) << "pressed together";
}

TEST(WeldJointSection, HoldsBodiesButFlexesInAChain)
{
    JointScene scene;
    b2Body* previous = scene.Post(-0.5f, 0.0f);
    for (int i = 0; i < 8; ++i)
    {
        b2Body* body = scene.Load(0.5f + float32(i), 0.0f, 0.5f, 0.125f);
        b2WeldJointDef jointDef;
        jointDef.Initialize(previous, body, b2Vec2(float32(i), 0.0f));
        scene.world.CreateJoint(&jointDef);
        previous = body;
    }
    scene.Step(240);
    EXPECT_LT(previous->GetPosition().y, -0.01f) << "it sags";
    EXPECT_GT(previous->GetPosition().x, 5.0f) << "but it holds";
    EXPECT_LT(b2Abs(previous->GetAngle()), 0.5f * b2_pi);
}

TEST(WeldJointSection, IsNotNeededForABreakableBody)
{
    JointScene scene;
    b2Body* whole = scene.Body(b2_dynamicBody, 0.0f, 5.0f);
    b2PolygonShape left, right;
    left.SetAsBox(0.5f, 0.5f, b2Vec2(-0.5f, 0.0f), 0.0f);
    right.SetAsBox(0.5f, 0.5f, b2Vec2(0.5f, 0.0f), 0.0f);
    whole->CreateFixture(&left, 1.0f);
    b2Fixture* piece = whole->CreateFixture(&right, 1.0f);
    scene.Step(10);
    const float32 before = whole->GetMass();

    whole->DestroyFixture(piece);
    b2Body* broken = scene.Body(b2_dynamicBody, whole->GetPosition().x, whole->GetPosition().y);
    broken->CreateFixture(&right, 1.0f);
    EXPECT_FLOAT_EQ(whole->GetMass() + broken->GetMass(), before);
    scene.Step(10);
    EXPECT_EQ(scene.world.GetBodyCount(), 2);
}

TEST(RopeJointSection, KeepsAChainFromStretchingUnderAHighLoad)
{
    float32 lowest[2];
    for (const bool roped : {false, true})
    {
        JointScene scene;
        b2Body* post = scene.Post();
        b2Body* previous = post;
        for (int i = 0; i < 10; ++i)
        {
            const bool last = i == 9;
            b2Body* link = scene.Load(0.0f, -0.5f - float32(i), last ? 1.5f : 0.125f, 0.5f);
            link->GetFixtureList()->SetDensity(last ? 100.0f : 1.0f);
            link->ResetMassData();
            b2RevoluteJointDef hinge;
            hinge.Initialize(previous, link, b2Vec2(0.0f, -float32(i)));
            scene.world.CreateJoint(&hinge);
            previous = link;
        }
        if (roped)
        {
            b2RopeJointDef rope;
            rope.bodyA = post;
            rope.bodyB = previous;
            rope.localAnchorA.SetZero();
            rope.localAnchorB.Set(0.0f, 0.5f);
            rope.maxLength = 9.0f;
            scene.world.CreateJoint(&rope);
        }
        scene.Step(240);
        lowest[roped] = previous->GetPosition().y + 9.5f;
    }
    EXPECT_GT(lowest[true], -0.02f);
    EXPECT_LT(lowest[false], 2.0f * lowest[true] - 0.01f) << "stretches without the rope";
}

TEST(FrictionJointSection, BrakesSlidingAndTurningFromAbove)
{
    JointScene scene(b2Vec2_zero);
    b2Body* body = scene.Load(0.0f, 0.0f);
    b2FrictionJointDef jointDef;
    jointDef.Initialize(scene.Post(), body, body->GetPosition());
    jointDef.maxForce = 2.0f * body->GetMass();
    jointDef.maxTorque = 1.0f * body->GetInertia();
    scene.world.CreateJoint(&jointDef);
    body->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    body->SetAngularVelocity(2.0f);
    scene.Step(60);
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 0.01f);
    EXPECT_NEAR(body->GetAngularVelocity(), 1.0f, 0.01f);
    scene.Step(120);
    EXPECT_NEAR(body->GetLinearVelocity().x, 0.0f, 1e-4f);
    EXPECT_NEAR(body->GetAngularVelocity(), 0.0f, 1e-4f);
}

TEST(MotorJointSection, ReachesTheOffsetsAndStopsWhereItIsBlocked)
{
    JointScene scene(b2Vec2_zero);
    b2Body* body = scene.Load(0.0f, 0.0f);
    b2MotorJointDef jointDef;
    jointDef.Initialize(scene.Post(), body);
    jointDef.maxForce = 50.0f;
    jointDef.maxTorque = 50.0f;
    auto* joint = scene.Create<b2MotorJoint>(jointDef);
    joint->SetLinearOffset(b2Vec2(1.0f, 2.0f));
    joint->SetAngularOffset(0.5f);
    scene.Step(240);
    EXPECT_NEAR(b2Distance(body->GetPosition(), b2Vec2(1.0f, 2.0f)), 0.0f, 0.01f);
    EXPECT_NEAR(body->GetAngle(), 0.5f, 0.01f);

    joint->SetAngularOffset(0.0f);
    scene.Step(120);
    scene.Wall(3.0f);
    joint->SetLinearOffset(b2Vec2(10.0f, 2.0f));
    scene.Step(240);
    EXPECT_LT(body->GetPosition().x, 2.5f);
    ASSERT_NE(body->GetContactList(), nullptr);
    const b2Manifold* manifold = body->GetContactList()->contact->GetManifold();
    float32 impulse = 0.0f;
    for (int32 i = 0; i < manifold->pointCount; ++i)
    {
        impulse += manifold->points[i].normalImpulse;
    }
    EXPECT_NEAR(impulse * 60.0f, 50.0f, 1.0f) << "the wall feels the motor's force";
}

} // namespace
