// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>

namespace
{

constexpr const char* kPage = "07-joints.md";

float32 Gap(const b2Joint* joint)
{
    return b2Distance(joint->GetAnchorA(), joint->GetAnchorB());
}

TEST(JointsListing, MakesAHingeInTwoWays)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* wall = stage.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* door = stage.Box(1.0f, 5.0f, 1.0f, 0.1f);
    // [make]
    b2RevoluteJointDef def;
    def.Initialize(wall, door, b2Vec2(0.0f, 5.0f)); // a point of the world, as the bodies stand now
    auto* hinge = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    // [/make]
    EXPECT_EQ(hinge->GetLocalAnchorB(), b2Vec2(-1.0f, 0.0f));
    world.DestroyJoint(hinge);
    // [make-local]
    def.bodyA = wall;
    def.bodyB = door;
    def.localAnchorA.Set(0.0f, 0.0f);  // in the wall's frame
    def.localAnchorB.Set(-1.0f, 0.0f); // in the door's frame
    def.referenceAngle = 0.0f;         // the door's angle minus the wall's where the joint's is 0
    hinge = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    // [/make-local]
    stage.Run(2.0f);
    EXPECT_LT(Gap(hinge), b2_linearSlop);
    EXPECT_GT(b2Abs(hinge->GetJointAngle()), 0.1f);
}

TEST(JointsListing, BreaksAJointThatBearsTooMuch)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* hook = stage.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* load = stage.Box(0.0f, 4.0f); // 1 kg: 10 N
    b2WeldJointDef def;
    def.Initialize(hook, load, b2Vec2(0.0f, 5.0f));
    b2Joint* joint = world.CreateJoint(&def);
    stage.Run(1.0f);
    const float32 strength = 15.0f; // [N]
    // [break]
    if (joint && joint->GetReactionForce().Length() > strength) // on body B, in the last step [N]
    {
        world.DestroyJoint(joint);
        joint = nullptr;
    }
    // [/break]
    ASSERT_NE(joint, nullptr);
    EXPECT_NEAR(joint->GetReactionForce().y, 10.0f, 0.1f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 10.0f, 0.1f);
    for (int i = 0; i < 30 && joint; ++i)
    {
        load->ApplyForceToCenter(b2Vec2(0.0f, -10.0f));
        stage.Run(1.0f / 60.0f);
        if (joint->GetReactionForce().Length() > strength)
        {
            world.DestroyJoint(joint);
            joint = nullptr;
        }
    }
    EXPECT_EQ(joint, nullptr);
}

TEST(JointsListing, SwingsOnARodAndBouncesOnASpring)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* ceiling = stage.Body(b2_staticBody, 0.0f, 10.0f);
    b2Body* bob = stage.Ball(3.0f, 10.0f);
    b2Body* load = stage.Box(10.0f, 7.0f);
    // [distance]
    b2DistanceJointDef rod;
    rod.Initialize(ceiling, bob, ceiling->GetPosition(), bob->GetPosition()); // 3 m, as they stand
    world.CreateJoint(&rod);

    b2DistanceJointDef spring;
    spring.Initialize(ceiling, load, b2Vec2(10.0f, 10.0f), load->GetPosition());
    spring.frequencyHz = 1.0f;
    spring.dampingRatio = 0.5f;
    world.CreateJoint(&spring);
    // [/distance]
    EXPECT_EQ(rod.length, 3.0f);
    stage.Run(0.5f);
    EXPECT_NEAR(b2Distance(ceiling->GetPosition(), bob->GetPosition()), 3.0f, b2_linearSlop);
    stage.Run(9.5f);
    // A spring of f hertz stretches by g / (2 pi f)^2 under any mass.
    EXPECT_NEAR(7.0f - load->GetPosition().y, 0.25f, 0.005f);

    auto* winch = static_cast<b2DistanceJoint*>(world.CreateJoint(&rod));
    for (int i = 0; i < 100; ++i)
    {
        // [haul]
        winch->SetLength(winch->GetLength() - 0.01f); // hauls in 1 cm [m]; before each step
        // [/haul]
    }
    EXPECT_NEAR(winch->GetLength(), 2.0f, 1e-4f);
    EXPECT_EQ(winch->SetLength(0.5f), 0.5f);
    world.DestroyJoint(winch);

    const std::string section = manual::SectionText(kPage, "## Distance joint");
    EXPECT_DEFAULT(section, b2DistanceJointDef(), length);
    EXPECT_DEFAULT(section, b2DistanceJointDef(), frequencyHz);
    EXPECT_DEFAULT(section, b2DistanceJointDef(), dampingRatio);
}

TEST(JointsListing, LimitsAndDrivesAHinge)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* upper = stage.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* lower = stage.Box(1.0f, 0.0f, 1.0f, 0.1f);
    // [revolute]
    b2RevoluteJointDef elbow;
    elbow.Initialize(upper, lower, b2Vec2(0.0f, 0.0f));
    elbow.enableLimit = true;
    elbow.lowerAngle = -0.5f * b2_pi; // 90 degrees clockwise
    elbow.upperAngle = 0.25f * b2_pi; // 45 degrees counter-clockwise
    elbow.enableMotor = true;         // with speed 0 and a small torque: friction in the hinge
    elbow.motorSpeed = 0.0f;
    elbow.maxMotorTorque = 2.0f;
    auto* joint = static_cast<b2RevoluteJoint*>(world.CreateJoint(&elbow));
    // [/revolute]
    for (const float32 torque : {10.0f, -10.0f})
    {
        for (int i = 0; i < 120; ++i)
        {
            lower->ApplyTorque(torque);
            stage.Run(1.0f / 60.0f);
        }
        EXPECT_NEAR(joint->GetJointAngle(), torque > 0.0f ? elbow.upperAngle : elbow.lowerAngle,
                    b2_angularSlop);
    }
    const float32 before = joint->GetJointAngle();
    for (int i = 0; i < 60; ++i)
    {
        lower->ApplyTorque(1.5f); // less than the friction holds
        stage.Run(1.0f / 60.0f);
    }
    EXPECT_NEAR(joint->GetJointAngle(), before, 0.02f);

    const float32 target = 0.2f;
    joint->SetMaxMotorTorque(100.0f);
    for (int i = 0; i < 120; ++i)
    {
        // [track]
        joint->SetMotorSpeed(5.0f * (target - joint->GetJointAngle())); // [rad/s], before each step
        // [/track]
        stage.Run(1.0f / 60.0f);
    }
    EXPECT_NEAR(joint->GetJointAngle(), target, 0.001f);

    // [hinge-setters]
    joint->SetLimits(-0.1f, 0.1f);  // [rad], lower first
    joint->EnableLimit(true);       // the limits are kept while they are disabled
    joint->SetMaxMotorTorque(5.0f); // [N m]
    joint->EnableMotor(false);      // hangs freely between its limits
    // [/hinge-setters]
    stage.Run(1.0f);
    EXPECT_NEAR(joint->GetJointAngle(), 0.1f, b2_angularSlop);
    EXPECT_EQ(joint->GetMaxMotorTorque(), 5.0f);
    EXPECT_FALSE(joint->IsMotorEnabled());
    joint->EnableLimit(false);
    EXPECT_FALSE(joint->IsLimitEnabled());
    EXPECT_EQ(joint->GetUpperLimit(), 0.1f);

    const std::string section = manual::SectionText(kPage, "## Revolute joint");
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), referenceAngle);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), enableLimit);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), lowerAngle);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), upperAngle);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), enableMotor);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), motorSpeed);
    EXPECT_DEFAULT(section, b2RevoluteJointDef(), maxMotorTorque);
}

TEST(JointsListing, LiftsOnASlider)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* shaft = stage.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* cabin = stage.Box(0.0f, 1.0f, 1.0f, 1.0f); // 4 kg: 40 N
    // [prismatic]
    b2PrismaticJointDef lift;
    lift.Initialize(shaft, cabin, cabin->GetPosition(), b2Vec2(0.0f, 1.0f)); // along y
    lift.enableLimit = true;
    lift.lowerTranslation = 0.0f;
    lift.upperTranslation = 6.0f;
    lift.enableMotor = true;
    lift.motorSpeed = 2.0f;      // [m/s]
    lift.maxMotorForce = 100.0f; // [N]
    auto* joint = static_cast<b2PrismaticJoint*>(world.CreateJoint(&lift));
    // [/prismatic]
    stage.Run(1.0f);
    EXPECT_NEAR(joint->GetJointSpeed(), 2.0f, 0.01f);
    EXPECT_NEAR(joint->GetMotorForce(), 40.0f, 0.5f);
    stage.Run(4.0f);
    EXPECT_NEAR(joint->GetJointTranslation(), 6.0f, b2_linearSlop);
    // [brake]
    joint->SetMotorSpeed(0.0f);
    joint->SetMaxMotorForce(1000.0f); // [N]: holds what weighs less
    // [/brake]
    joint->EnableLimit(false);
    stage.Run(1.0f);
    EXPECT_NEAR(joint->GetJointTranslation(), 6.0f, 2.0f * b2_linearSlop);
    EXPECT_EQ(joint->GetMaxMotorForce(), 1000.0f);

    const std::string section = manual::SectionText(kPage, "## Prismatic joint");
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), localAxisA);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), referenceAngle);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), enableLimit);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), lowerTranslation);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), upperTranslation);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), enableMotor);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), motorSpeed);
    EXPECT_DEFAULT(section, b2PrismaticJointDef(), maxMotorForce);
}

TEST(JointsListing, HoistsWithAPulley)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* counterweight = stage.Box(-2.0f, 5.0f); // 1 kg each
    b2Body* crate = stage.Box(2.0f, 5.0f);
    // [pulley]
    b2PulleyJointDef def;
    def.Initialize(counterweight, crate,                      //
                   b2Vec2(-2.0f, 15.0f), b2Vec2(2.0f, 15.0f), // the two wheels, in the world
                   counterweight->GetPosition(), crate->GetPosition(), // where the rope is tied
                   2.0f); // block and tackle on B's side
    auto* pulley = static_cast<b2PulleyJoint*>(world.CreateJoint(&def));
    // [/pulley]
    const float32 whole = pulley->GetLengthA() + 2.0f * pulley->GetLengthB();
    stage.Run(1.0f);
    EXPECT_NEAR(pulley->GetLengthA() + 2.0f * pulley->GetLengthB(), whole, b2_linearSlop);
    // Half the weight would do at A, and there is all of it.
    EXPECT_LT(counterweight->GetPosition().y, 4.5f);
    EXPECT_NEAR(crate->GetPosition().y - 5.0f, 0.5f * (5.0f - counterweight->GetPosition().y),
                0.01f);

    const std::string section = manual::SectionText(kPage, "## Pulley joint");
    EXPECT_DEFAULT(section, b2PulleyJointDef(), groundAnchorA);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), groundAnchorB);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), localAnchorA);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), localAnchorB);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), lengthA);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), lengthB);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), ratio);
    EXPECT_DEFAULT(section, b2PulleyJointDef(), collideConnected);
}

TEST(JointsListing, PushesWithAPulleyToo)
{
    manual::Stage stage(b2Vec2_zero);
    b2Body* a = stage.Ball(-2.0f, 5.0f);
    b2Body* b = stage.Ball(2.0f, 5.0f);
    b2PulleyJointDef def;
    def.Initialize(a, b, b2Vec2(-2.0f, 15.0f), b2Vec2(2.0f, 15.0f), a->GetPosition(),
                   b->GetPosition(), 1.0f);
    stage.world.CreateJoint(&def);
    a->SetLinearVelocity(b2Vec2(0.0f, 2.0f));
    stage.Run(1.0f);
    EXPECT_NEAR(a->GetPosition().y, 6.0f, 0.05f);
    EXPECT_NEAR(b->GetPosition().y, 4.0f, 0.05f) << "pushed down, as by a rod";
}

TEST(JointsListing, DrivesARackByAWheel)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* frame = stage.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* wheel = stage.Ball(0.0f, 0.0f, 0.5f);
    b2Body* rack = stage.Box(0.0f, -0.6f, 2.0f, 0.1f);
    b2RevoluteJointDef axle;
    axle.Initialize(frame, wheel, wheel->GetPosition());
    b2Joint* hinge = world.CreateJoint(&axle);
    b2PrismaticJointDef rail;
    rail.Initialize(frame, rack, rack->GetPosition(), b2Vec2(1.0f, 0.0f));
    b2Joint* slider = world.CreateJoint(&rail);
    // [gear]
    b2GearJointDef def;
    def.bodyA = wheel; // one body of each joint, and not the same
    def.bodyB = rack;
    def.joint1 = hinge;
    def.joint2 = slider;
    def.ratio = -1.0f / 0.5f; // angle - translation / radius stays as it is: a wheel of 0.5 m
    world.CreateJoint(&def);
    // [/gear]
    wheel->SetAngularVelocity(2.0f);
    stage.Run(1.0f);
    EXPECT_GT(rack->GetPosition().x, 0.05f) << "below the wheel, which turns to the left";
    EXPECT_NEAR(wheel->GetAngle() - rack->GetPosition().x / 0.5f, 0.0f, 0.01f);
    // [gear-end]
    world.DestroyJoint(hinge); // the gear goes with it
    // [/gear-end]
    EXPECT_EQ(world.GetJointCount(), 1);
    const std::string section = manual::SectionText(kPage, "## Gear joint");
    EXPECT_DEFAULT(section, b2GearJointDef(), ratio);
}

TEST(JointsListing, DragsWithTheMouse)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* ground = stage.Ground();
    b2Body* body = stage.Box(0.0f, 0.515f);
    const b2Vec2 pointer(0.3f, 0.7f);
    // [mouse]
    b2MouseJointDef def;
    def.bodyA = ground; // any other body; it takes no part
    def.bodyB = body;
    def.target = pointer;                    // where the button went down
    def.maxForce = 100.0f * body->GetMass(); // ten times its weight
    auto* mouse = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
    // ... and for each motion of the pointer:
    mouse->SetTarget(pointer + b2Vec2(1.0f, 2.0f));
    // [/mouse]
    stage.Run(5.0f);
    EXPECT_LT(b2Distance(mouse->GetAnchorB(), mouse->GetTarget()), 0.05f);
    const std::string section = manual::SectionText(kPage, "## Mouse joint");
    EXPECT_DEFAULT(section, b2MouseJointDef(), target);
    EXPECT_DEFAULT(section, b2MouseJointDef(), maxForce);
    EXPECT_DEFAULT(section, b2MouseJointDef(), frequencyHz);
    EXPECT_DEFAULT(section, b2MouseJointDef(), dampingRatio);
}

TEST(JointsListing, DrivesACar)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Ground();
    b2Body* car = stage.Box(0.0f, 1.0f, 1.5f, 0.25f);
    b2Body* front = stage.Ball(1.0f, 0.5f, 0.4f);
    b2Body* rear = stage.Ball(-1.0f, 0.5f, 0.4f);
    front->GetFixtureList()->SetFriction(0.9f);
    rear->GetFixtureList()->SetFriction(0.9f);
    // [wheel]
    b2WheelJointDef def;
    def.Initialize(car, front, front->GetPosition(), b2Vec2(0.0f, 1.0f)); // sprung along y
    def.frequencyHz = 4.0f;
    def.dampingRatio = 0.7f;
    world.CreateJoint(&def);
    def.Initialize(car, rear, rear->GetPosition(), b2Vec2(0.0f, 1.0f));
    def.enableMotor = true;
    def.motorSpeed = -10.0f; // clockwise: to the right [rad/s]
    def.maxMotorTorque = 5.0f;
    auto* drive = static_cast<b2WheelJoint*>(world.CreateJoint(&def));
    // [/wheel]
    stage.Run(5.0f);
    EXPECT_NEAR(car->GetLinearVelocity().x, 4.0f, 0.1f) << "10 rad/s on wheels of 0.4 m";
    EXPECT_NEAR(drive->GetJointSpeed(), -10.0f, 0.3f);
    EXPECT_NEAR(car->GetAngle(), 0.0f, 0.05f);
    const std::string section = manual::SectionText(kPage, "## Wheel joint");
    EXPECT_DEFAULT(section, b2WheelJointDef(), localAxisA);
    EXPECT_DEFAULT(section, b2WheelJointDef(), frequencyHz);
    EXPECT_DEFAULT(section, b2WheelJointDef(), dampingRatio);
    EXPECT_DEFAULT(section, b2WheelJointDef(), enableMotor);
    EXPECT_DEFAULT(section, b2WheelJointDef(), motorSpeed);
    EXPECT_DEFAULT(section, b2WheelJointDef(), maxMotorTorque);
}

/// How far the end of ten boards of 1 m sinks that are welded to a wall.
float32 Sag(int32 subSteps)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* last = stage.Body(b2_staticBody, 0.0f, 0.0f);
    for (int i = 0; i < 10; ++i)
    {
        b2Body* board = stage.Box(float32(i) + 0.5f, 0.0f, 0.5f, 0.05f);
        // [weld]
        b2WeldJointDef def;
        def.Initialize(last, board, b2Vec2(float32(i), 0.0f));
        world.CreateJoint(&def);
        // [/weld]
        last = board;
    }
    world.SetSubStepCount(subSteps);
    stage.Run(5.0f);
    return -last->GetPosition().y;
}

TEST(JointsListing, WeldsBoards)
{
    EXPECT_GT(Sag(1), 1.0f);
    EXPECT_LT(Sag(4), 0.0001f);
    const std::string section = manual::SectionText(kPage, "## Weld joint");
    EXPECT_DEFAULT(section, b2WeldJointDef(), referenceAngle);
    EXPECT_DEFAULT(section, b2WeldJointDef(), frequencyHz);
    EXPECT_DEFAULT(section, b2WeldJointDef(), dampingRatio);
}

TEST(JointsListing, CatchesAFallOnARope)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* hook = stage.Body(b2_staticBody, 0.0f, 10.0f);
    b2Body* climber = stage.Ball(1.0f, 10.0f, 0.3f);
    // [rope]
    b2RopeJointDef def;
    def.bodyA = hook;
    def.bodyB = climber;
    def.localAnchorA.SetZero(); // by default (-1, 0) and (1, 0)
    def.localAnchorB.SetZero();
    def.maxLength = 4.0f;
    auto* rope = static_cast<b2RopeJoint*>(world.CreateJoint(&def));
    // [/rope]
    stage.Run(0.5f);
    EXPECT_EQ(rope->GetLimitState(), e_inactiveLimit);
    EXPECT_NEAR(climber->GetLinearVelocity().y, -5.0f, 1e-4f) << "falls freely";
    float32 longest = 0.0f;
    for (int i = 0; i < 120; ++i)
    {
        stage.Run(1.0f / 60.0f);
        longest = b2Max(longest, Gap(rope));
    }
    EXPECT_NEAR(longest, 4.0f, 0.01f);
    const std::string section = manual::SectionText(kPage, "## Rope joint");
    EXPECT_DEFAULT(section, b2RopeJointDef(), localAnchorA);
    EXPECT_DEFAULT(section, b2RopeJointDef(), localAnchorB);
    EXPECT_DEFAULT(section, b2RopeJointDef(), maxLength);
}

TEST(JointsListing, BrakesOnAFloorSeenFromAbove)
{
    manual::Stage stage(b2Vec2_zero); // seen from above: gravity points away from us
    b2World& world = stage.world;
    b2Body* floor = stage.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* puck = stage.Ball(0.0f, 0.0f);
    // [friction]
    const float32 mu = 0.3f, g = 10.0f;
    b2FrictionJointDef def;
    def.Initialize(floor, puck, puck->GetWorldCenter());
    def.maxForce = mu * g * puck->GetMass();             // [N]
    def.maxTorque = def.maxForce * (2.0f / 3.0f) * 0.5f; // of a disc of 0.5 m [N m]
    world.CreateJoint(&def);
    // [/friction]
    puck->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    stage.Run(0.5f);
    EXPECT_NEAR(puck->GetLinearVelocity().x, 1.5f, 0.01f);
    stage.Run(1.0f);
    EXPECT_NEAR(puck->GetPosition().x, 1.5f, 0.05f) << "v^2 / (2 mu g)";
    const std::string section = manual::SectionText(kPage, "## Friction joint");
    EXPECT_DEFAULT(section, b2FrictionJointDef(), maxForce);
    EXPECT_DEFAULT(section, b2FrictionJointDef(), maxTorque);
}

TEST(JointsListing, CarriesABodyAlongAWay)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* base = stage.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* hand = stage.Box(0.0f, 0.0f, 0.3f, 0.3f);
    // [motor]
    b2MotorJointDef def;
    def.Initialize(base, hand); // the target is where they are now
    def.maxForce = 50.0f;
    def.maxTorque = 20.0f;
    auto* motor = static_cast<b2MotorJoint*>(world.CreateJoint(&def));
    // ... and whenever the target moves:
    motor->SetLinearOffset(b2Vec2(2.0f, 1.0f)); // of B's origin, in A's frame [m]
    motor->SetAngularOffset(0.5f);              // [rad]
    // [/motor]
    stage.Run(3.0f);
    EXPECT_NEAR(b2Distance(hand->GetPosition(), b2Vec2(2.0f, 1.0f)), 0.0f, 0.01f);
    EXPECT_NEAR(hand->GetAngle(), 0.5f, 0.01f);
    const std::string section = manual::SectionText(kPage, "## Motor joint");
    EXPECT_DEFAULT(section, b2MotorJointDef(), linearOffset);
    EXPECT_DEFAULT(section, b2MotorJointDef(), angularOffset);
    EXPECT_DEFAULT(section, b2MotorJointDef(), maxForce);
    EXPECT_DEFAULT(section, b2MotorJointDef(), maxTorque);
    EXPECT_DEFAULT(section, b2MotorJointDef(), correctionFactor);
}

TEST(JointsListing, HangsAnOrnamentalRope)
{
    // [ornament]
    b2Vec2 points[20];
    float32 masses[20];
    for (int i = 0; i < 20; ++i)
    {
        points[i].Set(0.25f * float32(i), 10.0f);
        masses[i] = i == 0 ? 0.0f : 1.0f; // no mass: held where it is
    }
    b2RopeDef def;
    def.vertices = points;
    def.masses = masses;
    def.count = 20;
    def.gravity.Set(0.0f, -10.0f);
    b2Rope rope; // belongs to no world: no bodies, no collision
    rope.Initialize(&def);
    for (int i = 0; i < 300; ++i)
    {
        rope.Step(1.0f / 60.0f, 3); // the time step, and iterations
    }
    // [/ornament]
    EXPECT_EQ(rope.GetVertices()[0], b2Vec2(0.0f, 10.0f));
    EXPECT_LT(rope.GetVertices()[19].y, 8.0f);
    const std::string section = manual::SectionText(kPage, "## Ropes without bodies");
    EXPECT_DEFAULT(section, b2RopeDef(), damping);
    EXPECT_DEFAULT(section, b2RopeDef(), k2);
    EXPECT_DEFAULT(section, b2RopeDef(), k3);
}

} // namespace
