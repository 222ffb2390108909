// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// Stacks in steps with sub-steps.
namespace
{

using namespace dynamics;

/// Unit boxes on each other, touching, by turns to the right and to the left.
std::vector<b2Body*> Leaning(Scene& scene, int height, float32 by)
{
    std::vector<b2Body*> boxes;
    for (int i = 0; i < height; ++i)
    {
        boxes.push_back(scene.Box(i % 2 == 0 ? by : -by, 0.5f + float32(i)));
    }
    return boxes;
}

TEST(SubStepsStacks, StandAtAnyHeight)
{
    for (const int32 count : {2, 4})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        scene.Ground();
        const std::vector<b2Body*> boxes = Leaning(scene, 50, 0.01f);
        scene.Step(1200);
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
            EXPECT_GT(boxes[i]->GetPosition().y, 0.45f + float32(i)) << i << " of " << count;
            EXPECT_LT(b2Abs(boxes[i]->GetPosition().x), 0.5f) << i << " of " << count;
        }
    }
}

/// Unit boxes, each row a box shorter than the one below it.
std::vector<b2Body*> Pyramid(Scene& scene, int base)
{
    std::vector<b2Body*> boxes;
    for (int row = 0; row < base; ++row)
    {
        for (int i = 0; i < base - row; ++i)
        {
            const float32 x = float32(i) - 0.5f * float32(base - row - 1);
            boxes.push_back(scene.Box(x, 0.5f + float32(row)));
        }
    }
    return boxes;
}

float32 Fastest(const std::vector<b2Body*>& boxes)
{
    float32 fastest = 0.0f;
    for (const b2Body* box : boxes)
    {
        fastest = b2Max(fastest, box->GetLinearVelocity().Length());
    }
    return fastest;
}

TEST(SubStepsStacks, ComeToRestWithFewIterationsPerSubStep)
{
    for (const int32 count : {2, 4, 8, 16})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        scene.world.SetAllowSleeping(false);
        scene.Ground();
        const std::vector<b2Body*> boxes = Pyramid(scene, 20);
        scene.Step(180);
        EXPECT_LT(Fastest(boxes), 0.05f) << count;
    }
}

bool Sleep(const std::vector<b2Body*>& boxes)
{
    for (const b2Body* box : boxes)
    {
        if (box->IsAwake())
        {
            return false;
        }
    }
    return true;
}

// They were put together without room for their skins.
TEST(SubStepsStacks, SleepWhereTheyWerePutTogether)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.Ground();
    const std::vector<b2Body*> boxes = Pyramid(scene, 20);
    scene.Step(60);
    EXPECT_TRUE(Sleep(boxes));
    EXPECT_NEAR(boxes.back()->GetPosition().y, 19.5f, 0.001f);
}

TEST(SubStepsStacks, StayAwakeWhileTheyOverlapDeeper)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.Ground();
    const std::vector<b2Body*> boxes = {scene.Box(0.0f, 0.5f), scene.Box(0.0f, 1.3f)};
    for (int i = 0; i < 300 && !Sleep(boxes); ++i)
    {
        scene.Step(1);
    }
    EXPECT_TRUE(Sleep(boxes));
    EXPECT_LT(DeepestOverlap(scene.world), 0.026f);
}

TEST(SubStepsStacks, BearALoadAThousandTimesTheirMass)
{
    for (const float32 ratio : {100.0f, 1000.0f})
    {
        Scene scene;
        scene.world.SetSubStepCount(4);
        scene.world.SetAllowSleeping(false);
        scene.Ground();
        const std::vector<b2Body*> boxes = Leaning(scene, 10, 0.0f);
        boxes.back()->GetFixtureList()->SetDensity(ratio);
        boxes.back()->ResetMassData();
        scene.Step(600);
        EXPECT_LT(DeepestOverlap(scene.world), 0.005f) << ratio;
        EXPECT_NEAR(boxes.back()->GetPosition().y, 9.5f, 0.001f) << ratio;
    }
}

TEST(SubStepsStacks, PressOnTheGroundWithTheirWeight)
{
    struct Scales : public b2ContactListener
    {
        void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
        {
            if (contact->GetFixtureA()->GetBody() == ground ||
                contact->GetFixtureB()->GetBody() == ground)
            {
                for (int32 i = 0; i < impulse->count; ++i)
                {
                    sum += impulse->normalImpulses[i];
                }
            }
        }
        const b2Body* ground = nullptr;
        float32 sum = 0.0f;
    };
    for (const int32 count : {2, 4, 16})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        scene.world.SetAllowSleeping(false);
        Scales scales;
        scales.ground = scene.Ground();
        Stack(scene, 0.0f, 5);
        scene.Step(60);
        scene.world.SetContactListener(&scales);
        scene.Step(60);
        EXPECT_NEAR(scales.sum, 50.0f, 0.05f) << count; // 5 boxes of 1 kg for a second
    }
}

TEST(SubStepsStacks, StandOnAConveyorBeltAsOnTheGround)
{
    struct Belt : public b2ContactListener
    {
        void PreSolve(b2Contact* contact, const b2Manifold*) override
        {
            if (contact->GetFixtureA()->GetBody() == ground ||
                contact->GetFixtureB()->GetBody() == ground)
            {
                contact->SetTangentSpeed(2.0f);
            }
        }
        const b2Body* ground = nullptr;
    };
    Scene scene;
    scene.world.SetSubStepCount(4);
    Belt belt;
    belt.ground = scene.Ground();
    scene.world.SetContactListener(&belt);
    const std::vector<b2Body*> boxes = Stack(scene, 0.0f, 3);
    scene.Step(180);
    for (const b2Body* box : boxes)
    {
        EXPECT_NEAR(b2Abs(box->GetLinearVelocity().x), 2.0f, 0.01f);
        EXPECT_NEAR(box->GetLinearVelocity().y, 0.0f, 0.01f);
        EXPECT_NEAR(box->GetAngle(), 0.0f, 0.01f);
    }
}

TEST(SubStepsStacks, RestTogetherWithSupportingJoints)
{
    // A box on a rope of two welded bars, above a stack. All constraints are exact together.
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.Ground();
    const std::vector<b2Body*> boxes = Stack(scene, 0.0f, 4);
    b2Body* bar = scene.Box(0.0f, 6.0f, 2.0f, 0.1f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(boxes[3], bar, b2Vec2(0.0f, 6.0f));
    scene.world.CreateJoint(&hinge);
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2Body* weight = scene.Box(2.0f * side, 5.0f, 0.2f, 0.2f);
        weight->GetFixtureList()->SetDensity(100.0f);
        weight->ResetMassData();
        hinge.Initialize(bar, weight, b2Vec2(2.0f * side, 6.0f));
        scene.world.CreateJoint(&hinge);
    }
    scene.Step(300);
    for (b2Joint* joint = scene.world.GetJointList(); joint; joint = joint->GetNext())
    {
        EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 1e-4f);
    }
    EXPECT_NEAR(boxes[3]->GetPosition().x, 0.0f, 0.01f);
    EXPECT_LT(DeepestOverlap(scene.world), 0.0055f);
}

TEST(SubStepsStacks, SeparateFromADeepOverlapWithoutAJump)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.Ground();
    std::vector<b2Body*> boxes;
    for (int i = 0; i < 4; ++i)
    {
        boxes.push_back(scene.Box(0.01f * float32(i), 0.4f + 0.6f * float32(i)));
    }
    for (int i = 0; i < 240; ++i)
    {
        scene.Step();
        for (const b2Body* box : boxes)
        {
            EXPECT_LT(box->GetLinearVelocity().Length(), 0.5f) << i;
        }
        EXPECT_EQ(WhyBroken(scene.world, true), "");
    }
    EXPECT_LT(DeepestOverlap(scene.world), 0.0055f);
}

// Only rigid rows and active limits take part in overlap correction. The target velocity of a
// spring or motor is no displacement.
TEST(SubStepsStacks, AreNotMovedFurtherBySpringsAndMotors)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(4);
    scene.Ground();
    b2Body* post = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* sprung = scene.Box(0.0f, 0.47f);
    b2Body* driven = scene.Box(5.0f, 0.47f);
    b2DistanceJointDef spring;
    spring.Initialize(post, sprung, b2Vec2(0.0f, 5.0f), sprung->GetPosition());
    spring.length = 3.5f;
    spring.frequencyHz = 1.0f; // pulls with 40 m/s^2: 5 mm in a step
    scene.world.CreateJoint(&spring);
    b2PrismaticJointDef motor;
    motor.Initialize(post, driven, driven->GetPosition(), b2Vec2(0.0f, 1.0f));
    motor.enableMotor = true;
    motor.motorSpeed = 10.0f;
    motor.maxMotorForce = 40.0f * driven->GetMass();
    scene.world.CreateJoint(&motor);
    scene.Step();
    for (const b2Body* box : {sprung, driven})
    {
        EXPECT_GT(box->GetPosition().y, 0.47f);
        EXPECT_LT(box->GetPosition().y, 0.52f);
    }
}

TEST(SubStepsStacks, FallAsleep)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.Ground();
    const std::vector<b2Body*> boxes = Leaning(scene, 10, 0.01f);
    scene.Step(300);
    EXPECT_TRUE(AllAwake(boxes, false));
}

/// A pyramid that has just been put together; the fastest of its boxes after some steps [m/s].
float32 FastestOfPyramid(int base, const b2Vec2& gravity, int steps)
{
    Scene s(gravity);
    s.world.SetSubStepCount(4);
    const b2Rot turned(std::atan2(-gravity.x, -gravity.y) * -1.0f);
    b2Body* ground = s.Body(b2_staticBody, 0.0f, 0.0f);
    ground->SetTransform(b2Mul(turned, b2Vec2(0.0f, -1.0f)), turned.GetAngle());
    s.AddBox(ground, 50.0f, 1.0f);
    std::vector<b2Body*> boxes;
    for (int row = 0; row < base; ++row)
    {
        for (int i = 0; i < base - row; ++i)
        {
            // Apart by their skins, so that nothing has to move.
            const b2Vec2 place(1.02f * (float32(i) - 0.5f * float32(base - row - 1)),
                               0.505f + 1.01f * float32(row));
            boxes.push_back(s.Box(0.0f, 0.0f));
            boxes.back()->SetTransform(b2Mul(turned, place), turned.GetAngle());
        }
    }
    s.Step(steps);
    float32 fastest = 0.0f;
    for (const b2Body* box : boxes)
    {
        fastest = b2Max(fastest, box->GetLinearVelocity().Length());
    }
    return fastest;
}

TEST(SubStepsStacks, CarryTheirLoadsFromTheFirstStep)
{
    for (const int base : {5, 20, 40})
    {
        EXPECT_LT(FastestOfPyramid(base, b2Vec2(0.0f, -10.0f), 1), 1e-3f) << base;
        EXPECT_LT(FastestOfPyramid(base, b2Vec2(0.0f, -10.0f), 30), 5e-3f) << base;
    }
    EXPECT_LT(FastestOfPyramid(20, b2Vec2(6.0f, 8.0f), 1), 1e-3f) << "up is where gravity says";
}

} // namespace
