// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Bodies tumble in a closed room, with restitution 1 and without friction or gravity. Their energy
/// must not change, and none may leave through walls of 10 cm.
namespace
{

using namespace stability;

STABILITY_SUITE(Gas);

constexpr float32 kRoom = 20.0f; ///< half [m]

void AddRoom(Trial& trial)
{
    b2Body* walls = trial.Body(b2_staticBody, 0.0f, 0.0f);
    for (const float32 side : {-1.0f, 1.0f})
    {
        const float32 middle = side * (kRoom + 0.05f);
        b2PolygonShape wall;
        wall.SetAsBox(kRoom + 0.1f, 0.05f, b2Vec2(0.0f, middle), 0.0f);
        Scene::Add(walls, wall, 0.0f, 1.0f);
        wall.SetAsBox(0.05f, kRoom + 0.1f, b2Vec2(middle, 0.0f), 0.0f);
        Scene::Add(walls, wall, 0.0f, 1.0f);
    }
}

/// Adds copies of the shape, with random rotations and velocities.
void AddGas(Trial& trial, const b2Shape& shape, int count, float32 speed)
{
    for (int i = 0; i < count; ++i)
    {
        const float32 x = -17.25f + 2.3f * float32(i % 16);
        const float32 y = -15.0f + 2.3f * float32(i / 16);
        b2Body* body = trial.Body(b2_dynamicBody, x, y, 3.0f * trial.Random());
        Scene::Add(body, shape, 0.0f, 1.0f);
        body->SetLinearVelocity(b2Mul(b2Rot(b2_pi * trial.Random()), b2Vec2(speed, 0.0f)));
    }
}

int Escaped(const Trial& trial)
{
    int count = 0;
    for (const b2Body* b = trial.world.GetBodyList(); b; b = b->GetNext())
    {
        count += b2Max(b2Abs(b->GetWorldCenter().x), b2Abs(b->GetWorldCenter().y)) > kRoom;
    }
    return count;
}

/// Boxes of 3 m x 1 m and plates, turned any way, at places that the gas leaves free.
void AddObstacles(Trial& trial)
{
    b2PolygonShape box;
    box.SetAsBox(1.5f, 0.5f);
    b2EdgeShape plate;
    plate.Set(b2Vec2(-1.5f, 0.0f), b2Vec2(1.5f, 0.0f));
    for (int i = 0; i < 8; ++i)
    {
        const float32 x = -16.0f + 4.5f * float32(i);
        Scene::Add(trial.Body(b2_staticBody, x, -17.6f, float32(i)), box, 0.0f, 1.0f);
        Scene::Add(trial.Body(b2_staticBody, x, 16.0f, float32(i)), plate, 0.0f, 1.0f);
    }
}

/// In the room, after others have been put into it. With one step what a step may turn by at most,
/// a quarter, slows down what tumbles, as the manual has it; sub-steps may turn further.
void JudgeGas(Trial& trial, int32 subSteps, const std::string& name, const b2Shape& shape,
              float32 speed)
{
    trial.world.SetAllowSleeping(false);
    AddRoom(trial);
    AddGas(trial, shape, 200, speed);
    const double start = trial.KineticOfAll();
    double maximum = 0.0;
    int escaped = 0;
    trial.Run(5.0, [&](double) {
        maximum = Worst(trial.KineticOfAll() / start, maximum);
        escaped = std::max(escaped, Escaped(trial));
    });
    const std::string at = name + " at " + std::to_string(int(speed)) + " m/s, ";
    Judge(at + "lost", subSteps, 100.0 * (1.0 - trial.KineticOfAll() / start), "%",
          Bound(subSteps, 0.5));
    Judge(at + "won", subSteps, 100.0 * (maximum - 1.0), "%", 0.01);
    Judge(at + "escaped", subSteps, double(escaped), "", 0.0);
}

void JudgeGas(int32 subSteps, const std::string& name, const b2Shape& shape, float32 speed)
{
    Trial trial(subSteps, b2Vec2(0.0f, 0.0f));
    JudgeGas(trial, subSteps, name, shape, speed);
}

TEST_P(Gas, KeepsItsEnergyWithSmallBoxes)
{
    b2PolygonShape box;
    box.SetAsBox(0.15f, 0.1f);
    JudgeGas(GetParam(), "boxes of 0.3 m", box, 100.0f);
    JudgeGas(GetParam(), "boxes of 0.3 m", box, 300.0f);
}

/// A body that moves farther in a step than an obstacle is wide may end the step behind it without
/// having crossed it.
TEST_P(Gas, KeepsItsEnergyAmongObstacles)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    AddObstacles(trial);
    b2PolygonShape box;
    box.SetAsBox(0.15f, 0.1f);
    JudgeGas(trial, GetParam(), "boxes of 0.3 m among obstacles", box, 300.0f);
}

TEST_P(Gas, KeepsItsEnergyWithLargeBoxes)
{
    b2PolygonShape box;
    box.SetAsBox(0.4f, 0.4f);
    JudgeGas(GetParam(), "boxes of 0.8 m", box, 100.0f);
}

TEST_P(Gas, KeepsItsEnergyWithRods)
{
    b2PolygonShape rod;
    rod.SetAsBox(0.5f, 0.02f);
    JudgeGas(GetParam(), "rods of 1 m", rod, 100.0f);
    JudgeGas(GetParam(), "rods of 1 m", rod, 300.0f);
}

/// Two points of a contact, of which one comes near and the other goes away: held together they
/// won 3 %.
TEST_P(Gas, KeepsItsEnergyWithTriangles)
{
    b2PolygonShape triangle;
    const b2Vec2 corners[] = {{-0.2f, -0.2f}, {0.2f, -0.2f}, {0.0f, 0.3f}};
    triangle.Set(corners, 3);
    JudgeGas(GetParam(), "triangles of 0.4 m", triangle, 30.0f);
    JudgeGas(GetParam(), "triangles of 0.4 m", triangle, 300.0f);
}

} // namespace
