// SPDX-License-Identifier: MIT
#include "SelfTest.h"

#include <golden/StateHash.h>
#include <scenes/Parts.h>

namespace boxreel
{
namespace
{

/// A stack that a ball hits, a chain with a load, a wheel on a spring, a box that spins fast.
void Fill(b2World& world)
{
    b2Body* const ground = AddGroundEdge(world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    for (int32 row = 0; row < 6; ++row)
    {
        for (int32 i = 0; i < 6 - row; ++i)
        {
            AddBox(world,
                   b2Vec2(1.1f * static_cast<float32>(i) + 0.55f * static_cast<float32>(row),
                          0.5f + 1.02f * static_cast<float32>(row)),
                   0.5f, 0.5f);
        }
    }
    b2Body* const ball = AddBall(world, b2Vec2(-8.0f, 3.0f), 0.6f, {.density = 5.0f});
    ball->SetLinearVelocity(b2Vec2(20.0f, 1.0f));
    b2Body* previous = ground;
    for (int32 i = 0; i < 8; ++i)
    {
        const float32 x = -12.0f + static_cast<float32>(i);
        b2Body* const link = AddBox(world, b2Vec2(x + 0.5f, 12.0f), 0.5f, 0.1f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(previous, link, b2Vec2(x, 12.0f));
        world.CreateJoint(&hinge);
        previous = link;
    }
    b2Body* const frame = AddBox(world, b2Vec2(10.0f, 2.0f), 1.0f, 0.3f);
    b2Body* const wheel = AddBall(world, b2Vec2(10.0f, 1.0f), 0.5f);
    b2WheelJointDef suspension;
    suspension.Initialize(frame, wheel, b2Vec2(10.0f, 1.0f), b2Vec2(0.0f, 1.0f));
    suspension.enableMotor = true;
    suspension.motorSpeed = 10.0f;
    suspension.maxMotorTorque = 5.0f;
    world.CreateJoint(&suspension);
    b2Body* const spinning = AddBox(world, b2Vec2(15.0f, 9.0f), 0.7f, 0.2f);
    spinning->SetAngularVelocity(50.0f);
    spinning->SetBullet(true);
}

} // namespace

std::uint64_t RunSelfTest()
{
    std::uint64_t state = 0;
    for (const int32 subSteps : {1, 4})
    {
        b2World world(b2Vec2(0.0f, -10.0f));
        world.SetSubStepCount(subSteps);
        Fill(world);
        for (int32 i = 0; i < 120; ++i)
        {
            world.Step(1.0f / 60.0f, 8, 3);
        }
        state = 31u * state + StateHash(world);
    }
    return state;
}

} // namespace boxreel
