// SPDX-License-Identifier: MIT
#include "../engine/JointScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// The chapter about joints up to the hinge and the slider, section by section. The numerical
/// guarantees of each joint are tested in tests/engine/Joint*Test.cpp.
namespace
{

using dynamics::JointScene;
using dynamics::kStep;

/// Two boxes side by side, for the listings.
class JointListing : public ::testing::Test
{
protected:
    JointListing()
    {
        myBodyA->SetSleepingAllowed(false);
        myBodyB->SetSleepingAllowed(false);
    }

    JointScene scene = JointScene(b2Vec2_zero);
    b2World* myWorld = &scene.world;
    b2Body* myBodyA = scene.Box(0.0f, 0.0f);
    b2Body* myBodyB = scene.Box(2.0f, 0.0f);
};

using Joints = JointListing;
using JointDefinition = JointListing;
using JointFactory = JointListing;
using UsingJoints = JointListing;
using DistanceJointSection = JointListing;
using RevoluteJointSection = JointListing;
using PrismaticJointSection = JointListing;

TEST_F(Joints, ConstrainBodiesToTheWorldOrToEachOther)
{
    b2Body* ground = scene.Post();
    b2RevoluteJointDef toWorld;
    toWorld.Initialize(ground, myBodyA, myBodyA->GetPosition());
    b2WeldJointDef toEachOther;
    toEachOther.Initialize(myBodyA, myBodyB, b2Vec2(1.0f, 0.0f));
    myWorld->CreateJoint(&toWorld);
    myWorld->CreateJoint(&toEachOther);
    myBodyB->ApplyLinearImpulse(b2Vec2(3.0f, 3.0f), myBodyB->GetPosition());
    scene.Step(60);
    EXPECT_NEAR(myBodyA->GetPosition().Length(), 0.0f, 0.01f);
    EXPECT_NEAR(b2Distance(myBodyA->GetPosition(), myBodyB->GetPosition()), 2.0f, 0.01f);
    EXPECT_GT(b2Abs(myBodyB->GetPosition().y), 0.1f);
}

TEST_F(Joints, ReachAPositionByAMotorThatFollowsTheError)
{
    b2PrismaticJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyA, b2Vec2_zero, b2Vec2(1.0f, 0.0f));
    jointDef.enableMotor = true;
    jointDef.maxMotorForce = 100.0f;
    auto* joint = scene.Create<b2PrismaticJoint>(jointDef);
    for (int i = 0; i < 240; ++i)
    {
        joint->SetMotorSpeed(3.0f * (1.5f - joint->GetJointTranslation()));
        scene.Step();
    }
    EXPECT_NEAR(joint->GetJointTranslation(), 1.5f, 0.01f);
}

TEST_F(Joints, HaveFrictionWithAMotorOfSpeedZero)
{
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyA, myBodyA->GetPosition());
    jointDef.enableMotor = true;
    jointDef.motorSpeed = 0.0f;
    jointDef.maxMotorTorque = 10.0f;
    myWorld->CreateJoint(&jointDef);
    for (int i = 0; i < 30; ++i)
    {
        myBodyA->ApplyTorque(9.9f);
        scene.Step();
    }
    EXPECT_NEAR(myBodyA->GetAngle(), 0.0f, 1e-4f);
    for (int i = 0; i < 30; ++i)
    {
        myBodyA->ApplyTorque(11.0f);
        scene.Step();
    }
    // One newton metre is left over for half a second.
    EXPECT_NEAR(myBodyA->GetAngularVelocity(), 0.5f / myBodyA->GetInertia(), 0.05f);
}

TEST_F(JointDefinition, HasNoEffectBetweenBodiesThatDoNotMove)
{
    b2Body* wall = scene.Post(0.0f, 5.0f);
    b2Body* lift = scene.Body(b2_kinematicBody, 0.0f, 8.0f);
    lift->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    b2DistanceJointDef jointDef;
    jointDef.Initialize(wall, lift, wall->GetPosition(), lift->GetPosition());
    ASSERT_NE(myWorld->CreateJoint(&jointDef), nullptr);
    b2DistanceJointDef still;
    still.Initialize(wall, scene.Post(), wall->GetPosition(), b2Vec2_zero);
    ASSERT_NE(myWorld->CreateJoint(&still), nullptr);
    scene.Step(60);
    EXPECT_NEAR(lift->GetPosition().x, 1.0f, 1e-4f);
    EXPECT_EQ(wall->GetPosition(), b2Vec2(0.0f, 5.0f));
}

TEST_F(JointDefinition, HoldsUserDataAndWhetherTheBodiesCollide)
{
    int data = 0;
    b2DistanceJointDef jointDef;
    EXPECT_FALSE(jointDef.collideConnected);
    EXPECT_EQ(jointDef.userData, nullptr);
    jointDef.Initialize(myBodyA, myBodyB, b2Vec2_zero, b2Vec2(2.0f, 0.0f));
    jointDef.userData = &data;
    jointDef.collideConnected = true;
    b2Joint* joint = myWorld->CreateJoint(&jointDef);
    EXPECT_EQ(joint->GetUserData(), &data);
    EXPECT_TRUE(joint->GetCollideConnected());
}

/// Does a ball that hangs above a box fall onto it when a rope joins the two?
bool JoinedBodiesCollide(bool collideConnected)
{
    JointScene scene;
    b2Body* box = scene.Body(b2_staticBody, 0.0f, 0.0f);
    JointScene::AddBox(box, 0.5f, 0.5f);
    b2Body* ball = scene.Ball(0.0f, 2.0f);
    b2RopeJointDef rope;
    rope.bodyA = box;
    rope.bodyB = ball;
    rope.localAnchorA.SetZero();
    rope.localAnchorB.SetZero();
    rope.maxLength = 20.0f;
    rope.collideConnected = collideConnected;
    scene.world.CreateJoint(&rope);
    scene.Step(90);
    return ball->GetPosition().y > 0.9f;
}

TEST_F(JointDefinition, PreventsCollisionUnlessCollideConnectedIsSet)
{
    EXPECT_FALSE(JoinedBodiesCollide(false));
    EXPECT_TRUE(JoinedBodiesCollide(true));
}

TEST_F(JointDefinition, PullsBodiesTogetherByItsLocalAnchors)
{
    b2RevoluteJointDef jointDef;
    jointDef.bodyA = myBodyA;
    jointDef.bodyB = myBodyB;
    jointDef.localAnchorA.Set(0.75f, 0.0f);
    jointDef.localAnchorB.Set(-0.75f, 0.0f); // half a metre from the anchor on the other body
    auto* joint = scene.Create<b2RevoluteJoint>(jointDef);
    EXPECT_NEAR(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 0.5f, 1e-5f);
    scene.Step(30);
    EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), b2_linearSlop);
}

TEST_F(JointDefinition, UsesThePresentTransformsInInitialize)
{
    myBodyB->SetTransform(b2Vec2(2.0f, 0.0f), 0.5f * b2_pi);
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, b2Vec2(1.0f, 0.0f));
    EXPECT_NEAR(b2Distance(jointDef.localAnchorA, b2Vec2(1.0f, 0.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(jointDef.localAnchorB, b2Vec2(0.0f, 1.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(jointDef.referenceAngle, 0.5f * b2_pi, 1e-6f);
}

TEST_F(JointFactory, CreatesAndDestroysAHingeInTheListing)
{
    b2RevoluteJointDef jointDef;
    // The specification sets an anchor point of the definition, which hinges do not have.
    jointDef.Initialize(myBodyA, myBodyB, myBodyA->GetCenterPosition());
    b2RevoluteJoint* joint = (b2RevoluteJoint*)myWorld->CreateJoint(&jointDef);
    EXPECT_EQ(joint->GetAnchorA(), myBodyA->GetPosition());
    EXPECT_EQ(myWorld->GetJointList(), joint);
    myWorld->DestroyJoint(joint);
    joint = NULL;
    EXPECT_EQ(myWorld->GetJointList(), nullptr);
}

TEST_F(JointFactory, DestroysJointsWithTheirBodies)
{
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, myBodyA->GetWorldCenter());
    myWorld->CreateJoint(&jointDef);
    myWorld->DestroyBody(myBodyB);
    EXPECT_EQ(myWorld->GetJointCount(), 0);
    EXPECT_EQ(myBodyA->GetJointList(), nullptr);
}

TEST_F(UsingJoints, ReturnsTheirBodiesAnchorsAndUserData)
{
    int data = 0;
    b2DistanceJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, b2Vec2(0.5f, 0.0f), b2Vec2(1.5f, 0.0f));
    jointDef.userData = &data;
    b2Joint* joint = myWorld->CreateJoint(&jointDef);
    EXPECT_EQ(joint->GetBodyA(), myBodyA);
    EXPECT_EQ(joint->GetBodyB(), myBodyB);
    EXPECT_EQ(joint->GetAnchorA(), b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(joint->GetAnchorB(), b2Vec2(1.5f, 0.0f));
    EXPECT_EQ(joint->GetUserData(), &data);
}

TEST_F(UsingJoints, ReturnsTheForceAndTorqueOnTheSecondBody)
{
    JointScene hanging;
    b2Body* load = hanging.Load(1.0f, 0.0f);
    b2WeldJointDef jointDef;
    jointDef.Initialize(hanging.Post(), load, b2Vec2_zero);
    b2Joint* joint = hanging.world.CreateJoint(&jointDef);
    hanging.Step(120);
    b2Vec2 force = joint->GetReactionForce();
    float32 torque = joint->GetReactionTorque();
    // Weight at an arm of a metre: held up, and turned back counter-clockwise.
    const float32 weight = 10.0f * load->GetMass();
    EXPECT_NEAR(force.x, 0.0f, 0.01f * weight);
    EXPECT_NEAR(force.y, weight, 0.01f * weight);
    EXPECT_NEAR(b2Abs(torque), weight, 0.02f * weight);
    EXPECT_FLOAT_EQ(joint->GetReactionForce(60.0f).y, force.y);
    EXPECT_FLOAT_EQ(joint->GetReactionTorque(60.0f), torque);
}

TEST_F(DistanceJointSection, KeepsTheAnchorDistanceInTheListing)
{
    const b2Vec2 worldAnchorOnBodyA(0.5f, 0.5f), worldAnchorOnBodyB(1.5f, 0.5f);
    b2DistanceJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, worldAnchorOnBodyA, worldAnchorOnBodyB);
    jointDef.collideConnected = true;
    EXPECT_FLOAT_EQ(jointDef.length, 1.0f);
    auto* joint = scene.Create<b2DistanceJoint>(jointDef);
    myBodyB->ApplyLinearImpulse(b2Vec2(1.0f, 2.0f), myBodyB->GetPosition());
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        EXPECT_NEAR(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 1.0f, 0.01f);
    }
}

TEST_F(DistanceJointSection, IsASpringOfItsFrequencyAndDamping)
{
    b2Body* post = scene.Post(0.0f, 5.0f);
    myBodyA->SetTransform(b2Vec2(0.0f, 3.5f), 0.0f);
    b2DistanceJointDef jointDef;
    jointDef.Initialize(post, myBodyA, post->GetPosition(), myBodyA->GetPosition());
    jointDef.frequencyHz = 4.0f;
    jointDef.dampingRatio = 0.5f;
    auto* joint = scene.Create<b2DistanceJoint>(jointDef);
    EXPECT_EQ(joint->GetFrequency(), 4.0f);
    EXPECT_EQ(joint->GetDampingRatio(), 0.5f);
    myBodyA->SetTransform(b2Vec2(0.0f, 3.25f), 0.0f);
    scene.Step(120);
    EXPECT_NEAR(myBodyA->GetPosition().y, 3.5f, 1e-3f);
}

TEST_F(RevoluteJointSection, JoinsAtTheFirstCentreInTheListing)
{
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, myBodyA->GetWorldCenter());
    auto* joint = scene.Create<b2RevoluteJoint>(jointDef);
    myBodyA->SetAngularVelocity(3.0f);
    scene.Step(60);
    EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), b2_linearSlop);
}

TEST_F(RevoluteJointSection, MeasuresCounterClockwiseFromZero)
{
    myBodyA->SetTransform(b2Vec2_zero, 0.7f);
    myBodyB->SetTransform(b2Vec2(2.0f, 0.0f), -0.3f);
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyB, myBodyB->GetWorldCenter());
    auto* joint = scene.Create<b2RevoluteJoint>(jointDef);
    EXPECT_NEAR(joint->GetJointAngle(), 0.0f, 1e-6f);
    myBodyB->SetAngularVelocity(1.0f);
    scene.Step(30);
    EXPECT_NEAR(joint->GetJointAngle(), 0.5f, 1e-3f);
    EXPECT_NEAR(joint->GetJointSpeed(), 1.0f, 1e-3f);
}

TEST_F(RevoluteJointSection, HasLimitsAndFrictionInRevisedListing)
{
    b2Body* bodyA = scene.Post(-2.0f, 0.0f);
    b2Body* bodyB = myBodyB;
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(bodyA, bodyB, myBodyB->GetWorldCenter());
    jointDef.lowerAngle = -0.5f * b2_pi; // -90 degrees
    jointDef.upperAngle = 0.25f * b2_pi; // 45 degrees
    jointDef.enableLimit = true;
    jointDef.maxMotorTorque = 10.0f;
    jointDef.motorSpeed = 0.0f;
    jointDef.enableMotor = true;
    auto* joint = scene.Create<b2RevoluteJoint>(jointDef);

    for (const float32 sign : {1.0f, -1.0f})
    {
        for (int i = 0; i < 180; ++i)
        {
            bodyB->ApplyTorque(sign * 15.0f);
            scene.Step();
            EXPECT_GT(joint->GetJointAngle(), -0.5f * b2_pi - 0.05f);
            EXPECT_LT(joint->GetJointAngle(), 0.25f * b2_pi + 0.05f);
        }
        EXPECT_NEAR(joint->GetJointAngle(), sign > 0.0f ? 0.25f * b2_pi : -0.5f * b2_pi,
                    2.0f * b2_angularSlop);
    }
    EXPECT_NEAR(b2Abs(joint->GetMotorTorque()), 10.0f, 0.2f);
}

TEST_F(RevoluteJointSection, HoldsItsMotorSpeedUpToItsMaxTorque)
{
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyB, myBodyB->GetWorldCenter());
    jointDef.enableMotor = true;
    jointDef.motorSpeed = -2.0f;
    jointDef.maxMotorTorque = 5.0f;
    auto* joint = scene.Create<b2RevoluteJoint>(jointDef);
    scene.Step(60);
    EXPECT_NEAR(joint->GetJointSpeed(), -2.0f, 1e-3f);
    for (int i = 0; i < 60; ++i)
    {
        myBodyB->ApplyTorque(8.0f);
        scene.Step();
    }
    EXPECT_GT(joint->GetJointSpeed(), 0.0f) << "reversed";
    EXPECT_NEAR(joint->GetMotorTorque(), -5.0f, 1e-2f);
}

TEST_F(RevoluteJointSection, IsDrivenByTheGameLoops)
{
    b2RevoluteJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyB, myBodyB->GetWorldCenter());
    jointDef.enableMotor = true;
    b2RevoluteJoint* myJoint = scene.Create<b2RevoluteJoint>(jointDef);
    myJoint->SetMaxMotorTorque(1000.0f);
    for (int i = 0; i < 120; ++i)
    {
        const float32 time = float32(i) * kStep;
        myJoint->SetMotorSpeed(cosf(0.5f * time));
        scene.Step();
        EXPECT_NEAR(myJoint->GetJointSpeed(), cosf(0.5f * time), 1e-3f);
    }

    const float32 angleTarget = -0.5f;
    for (int i = 0; i < 3600; ++i)
    {
        float32 angleError = myJoint->GetJointAngle() - angleTarget;
        float32 gain = 0.1f;
        myJoint->SetMotorSpeed(-gain * angleError);
        scene.Step();
    }
    // The remaining error after a minute. The sine wave has reached 2 sin(1).
    const float32 start = 2.0f * std::sin(1.0f) - angleTarget;
    EXPECT_NEAR(myJoint->GetJointAngle() - angleTarget, start * std::exp(-6.0f), 1e-4f);
}

TEST_F(PrismaticJointSection, SlidesBetweenItsLimitsInTheListing)
{
    b2Body* ground = scene.Post(0.0f, 5.0f);
    myBodyB->SetTransform(b2Vec2(2.0f, 5.0f), 0.3f);
    b2PrismaticJointDef jointDef;
    b2Vec2 worldAxis(1.0f, 0.0f);
    jointDef.Initialize(ground, myBodyB, ground->GetWorldCenter(), worldAxis);
    jointDef.lowerTranslation = -5.0f;
    jointDef.upperTranslation = 2.5f;
    jointDef.enableLimit = true;
    jointDef.maxMotorForce = 1.0f;
    jointDef.motorSpeed = 0.0f;
    jointDef.enableMotor = true;
    auto* joint = scene.Create<b2PrismaticJoint>(jointDef);
    EXPECT_NEAR(joint->GetJointTranslation(), 0.0f, 1e-5f);

    for (int i = 0; i < 240; ++i)
    {
        myBodyB->ApplyForce(b2Vec2(5.0f, 5.0f), myBodyB->GetWorldPoint(b2Vec2(0.5f, 0.0f)));
        scene.Step();
    }
    EXPECT_NEAR(joint->GetJointTranslation(), 2.5f, 2.0f * b2_linearSlop);
    EXPECT_NEAR(myBodyB->GetPosition().y, 5.0f, 2.0f * b2_linearSlop);
    EXPECT_NEAR(myBodyB->GetAngle(), 0.3f, 2.0f * b2_angularSlop);
    for (int i = 0; i < 300; ++i)
    {
        myBodyB->ApplyForceToCenter(b2Vec2(-5.0f, 0.0f));
        scene.Step();
        if (i == 30)
        {
            EXPECT_NEAR(joint->GetMotorForce(), 1.0f, 0.02f) << "against the motion";
        }
    }
    EXPECT_NEAR(joint->GetJointTranslation(), -5.0f, 2.0f * b2_linearSlop);
}

TEST_F(PrismaticJointSection, TurnsItsAxisWithTheBodies)
{
    b2PrismaticJointDef jointDef;
    jointDef.Initialize(myBodyA, myBodyB, b2Vec2_zero, b2Vec2(1.0f, 0.0f));
    auto* joint = scene.Create<b2PrismaticJoint>(jointDef);
    myBodyA->SetAngularVelocity(5.0f);
    scene.Step(60);
    const b2Vec2 axis = myBodyA->GetWorldVector(joint->GetLocalAxisA());
    EXPECT_GT(axis.y, 0.2f);
    const b2Vec2 offset = myBodyB->GetPosition() - myBodyA->GetPosition();
    EXPECT_NEAR(b2Cross(axis, offset), 0.0f, 0.01f);
}

TEST_F(PrismaticJointSection, IsReadAndDrivenByTheManualsFunctions)
{
    b2PrismaticJointDef jointDef;
    jointDef.Initialize(scene.Post(), myBodyB, myBodyB->GetWorldCenter(), b2Vec2(1.0f, 0.0f));
    jointDef.enableMotor = true;
    auto* joint = scene.Create<b2PrismaticJoint>(jointDef);
    joint->SetMotorSpeed(0.5f);
    joint->SetMotorForce(50.0f);
    EXPECT_EQ(joint->GetMaxMotorForce(), 50.0f);
    scene.Step(60);
    EXPECT_NEAR(joint->GetJointSpeed(), 0.5f, 1e-3f);
    EXPECT_NEAR(joint->GetJointTranslation(), 0.5f, 0.01f);
    EXPECT_NEAR(joint->GetMotorForce(), 0.0f, 1e-3f);
}

} // namespace
