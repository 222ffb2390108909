// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/Joints/JointEnergy.h>

#include <gtest/gtest.h>

#include <vector>

/// The energy of springs, compared with the textbook.
namespace
{

using namespace dynamics;

constexpr double kOmega = 2.0 * double(b2_pi) * 2.0; ///< of 2 Hz [1/s]

TEST(JointEnergy, IsHalfTheStiffnessTimesTheStretchSquared)
{
    Scene scene;
    b2Body* box = scene.Box(3.0f, 0.0f); // 1 kg
    b2DistanceJointDef def;
    def.Initialize(scene.Ground(), box, b2Vec2(0.0f, 0.0f), b2Vec2(3.0f, 0.0f));
    def.length = 2.5f;
    def.frequencyHz = 2.0f;
    b2Joint* joint = scene.world.CreateJoint(&def);
    ASSERT_TRUE(box2d::HasSpring(*joint));
    EXPECT_NEAR(box2d::SpringOf(*joint, nullptr).Energy(), 0.5 * kOmega * kOmega * 0.25, 1e-3);
}

TEST(JointEnergy, GrowsLinearlyBeyondTheMaxForceOfAMouse)
{
    Scene scene;
    b2Body* box = scene.Box(0.0f, 0.0f);
    b2MouseJointDef def;
    def.bodyA = scene.Ground();
    def.bodyB = box;
    def.target.Set(0.0f, 0.0f);
    def.frequencyHz = 2.0f;
    def.maxForce = 50.0f;
    auto* mouse = static_cast<b2MouseJoint*>(scene.world.CreateJoint(&def));
    mouse->SetTarget(b2Vec2(4.0f, 0.0f));
    const double k = kOmega * kOmega;
    EXPECT_NEAR(box2d::SpringOf(*mouse, nullptr).Energy(), 50.0 * 4.0 - 0.5 * 50.0 * 50.0 / k,
                1e-3);
}

TEST(JointEnergy, UsesSmallerEnergyWhenStiffnessChanges)
{
    box2d::SpringState before;
    before.stiffness = 10.0;
    before.error = 1.0;
    box2d::SpringState after;
    after.stiffness = 30.0;
    after.error = 2.0;
    EXPECT_DOUBLE_EQ(box2d::StoredBetween(before, after), 15.0);
    EXPECT_DOUBLE_EQ(box2d::StoredBetween(after, before), -45.0);
}

TEST(MotorWork, IsForceTimesSpeedTimesTime)
{
    Scene scene;
    b2Body* box = scene.Box(3.0f, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(scene.Ground(), box, b2Vec2(3.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    def.motorSpeed = -4.0f;
    def.maxMotorForce = 30.0f;
    auto* joint = static_cast<b2PrismaticJoint*>(scene.world.CreateJoint(&def));
    EXPECT_FALSE(box2d::HasMotor(*joint));
    joint->EnableMotor(true);
    EXPECT_TRUE(box2d::HasMotor(*joint));
    EXPECT_NEAR(box2d::MaxMotorWork(*joint, nullptr, 0.5f), 60.0, 1e-4);
}

TEST(MotorWork, OfAMotorJointCorrectsAShareOfItsErrorInAStep)
{
    Scene scene;
    b2Body* box = scene.Box(3.0f, 0.0f);
    b2MotorJointDef def;
    def.Initialize(scene.Ground(), box);
    def.maxForce = 20.0f;
    def.correctionFactor = 0.3f;
    auto* joint = static_cast<b2MotorJoint*>(scene.world.CreateJoint(&def));
    joint->SetLinearOffset(joint->GetLinearOffset() + b2Vec2(2.0f, 0.0f));
    std::vector<box2d::SolverBody> bodies(2);
    bodies[std::size_t(box2d::Data(*box).SolverIndex())].v.Set(1000.0f, 0.0f);
    EXPECT_NEAR(box2d::MaxMotorWork(*joint, bodies.data(), 0.1f), 20.0 * 0.3 * 2.0, 1e-3);
}

} // namespace
