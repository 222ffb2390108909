// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Kinematic bodies push every body in their path, even against static ones. No impulse can prevent
/// that: jammed bodies overlap and stay calm.
namespace
{

using namespace stability;

STABILITY_SUITE(KinematicBody);

/// A body squeezed out of a stack is slower than this [m/s]: it rises by two metres.
constexpr double kSqueezedOut = 6.5;
/// A body that cannot get out is slower than this [m/s].
constexpr double kJammed = 1.0;
/// Maximum impulse of a step per kilogram of all pressed bodies [m/s]. It is far above the
/// requirement of weight and the pusher's speed, and far below an unbounded one.
constexpr double kPressed = 100.0;
/// Some seconds after the pusher has gone [m/s].
constexpr double kAtRest = 0.02;

class Impulses : public b2ContactListener
{
public:
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override
    {
        for (int32 i = 0; i < impulse->count; ++i)
        {
            largest = Worst(double(impulse->normalImpulses[i]), largest);
        }
    }

    double largest = 0.0; ///< [Ns]
};

b2Body* Pusher(Trial& trial, float32 x, float32 y, float32 hx, float32 hy)
{
    b2Body* body = trial.Body(b2_kinematicBody, x, y);
    Scene::AddBox(body, hx, hy, 0.6f);
    return body;
}

double FastestOf(const std::vector<b2Body*>& bodies)
{
    double fastest = 0.0;
    for (const b2Body* body : bodies)
    {
        fastest = Worst(double(body->GetLinearVelocity().Length()), fastest);
    }
    return fastest;
}

/// The pusher moves forward for this time, and back for a second.
void TryPress(Trial& trial, const std::string& name, b2Body* pusher,
              const std::vector<b2Body*>& bodies, double seconds, double mostSpeed)
{
    Impulses impulses;
    trial.world.SetContactListener(&impulses);
    double pressed = 0.0, released = 0.0;
    trial.Run(seconds, [&](double) { pressed = Worst(FastestOf(bodies), pressed); });
    pusher->SetLinearVelocity(-pusher->GetLinearVelocity());
    pusher->SetAngularVelocity(-pusher->GetAngularVelocity());
    trial.Run(1.0, [&](double) { released = Worst(FastestOf(bodies), released); });
    pusher->SetLinearVelocity(b2Vec2(0.0f, 0.0f));
    pusher->SetAngularVelocity(0.0f);
    trial.Run(4.0, [&](double) { released = Worst(FastestOf(bodies), released); });
    trial.world.SetContactListener(nullptr);
    const int32 n = trial.world.GetSubStepCount();
    double mass = 0.0;
    for (const b2Body* body : bodies)
    {
        mass += double(body->GetMass());
    }
    Judge("pressed: " + name + ", fastest", n, pressed, "m/s", Bound(n, mostSpeed));
    Judge("pressed: " + name + ", impulse", n, impulses.largest / mass, "m/s", Bound(n, kPressed));
    Judge("pressed: " + name + ", let go", n, released, "m/s", Bound(n, mostSpeed));
    Judge("pressed: " + name + ", at rest", n, FastestOf(bodies), "m/s", Bound(n, kAtRest));
}

/// Columns of unit boxes between a wall and a pusher.
void TryWall(int32 subSteps, const std::string& name, int columns, int rows, float32 speed,
             double mostSpeed)
{
    Trial trial(subSteps);
    trial.WideGround(0.6f);
    Scene::AddBox(trial.Body(b2_staticBody, -1.0f, 5.0f), 1.0f, 6.0f, 0.6f);
    std::vector<b2Body*> boxes;
    for (int i = 0; i < columns * rows; ++i)
    {
        boxes.push_back(
            trial.Box(0.55f + 1.05f * float32(i % columns), 0.51f + 1.03f * float32(i / columns)));
        boxes.back()->GetFixtureList()->SetFriction(0.6f);
    }
    b2Body* pusher = Pusher(trial, 1.05f * float32(columns) + 1.4f, 7.0f, 1.0f, 7.5f);
    pusher->SetLinearVelocity(b2Vec2(-speed, 0.0f));
    // Until 5 cm of them have no room.
    TryPress(trial, name, pusher, boxes, (0.05 * columns + 0.45) / double(speed), mostSpeed);
}

TEST_P(KinematicBody, PressesABoxAgainstAWall)
{
    TryWall(GetParam(), "a box, 5 cm/s", 1, 1, 0.05f, kJammed);
    TryWall(GetParam(), "a box, 1 m/s", 1, 1, 1.0f, 2.0 * kJammed);
}

TEST_P(KinematicBody, PressesARowAgainstAWall)
{
    TryWall(GetParam(), "row of five, 20 cm/s", 5, 1, 0.2f, kSqueezedOut);
    TryWall(GetParam(), "row of five, 1 m/s", 5, 1, 1.0f, kSqueezedOut);
}

TEST_P(KinematicBody, PressesAPileAgainstAWall)
{
    TryWall(GetParam(), "pile of five by four", 5, 4, 0.2f, kSqueezedOut);
}

TEST_P(KinematicBody, PressesAStackAgainstTheCeiling)
{
    Trial trial(GetParam());
    trial.WideGround();
    Scene::AddBox(trial.Body(b2_staticBody, 0.0f, 6.0f), 3.0f, 1.0f, 0.6f);
    b2Body* lift = Pusher(trial, 0.0f, 0.5f, 2.0f, 0.1f);
    const std::vector<b2Body*> boxes = {trial.Box(0.0f, 1.12f), trial.Box(0.0f, 2.14f),
                                        trial.Box(0.0f, 3.16f)};
    lift->SetLinearVelocity(b2Vec2(0.0f, 0.5f));
    TryPress(trial, "lift against a ceiling", lift, boxes, 3.6, kSqueezedOut);
}

TEST_P(KinematicBody, ClosesADoorOnBoxesAtAWall)
{
    Trial trial(GetParam());
    trial.WideGround(0.6f);
    Scene::AddBox(trial.Body(b2_staticBody, -1.0f, 10.0f), 1.0f, 10.0f, 0.6f);
    b2Body* door = trial.Body(b2_kinematicBody, 0.0f, 1.0f, -1.2f);
    b2PolygonShape leaf;
    leaf.SetAsBox(2.0f, 0.1f, b2Vec2(2.0f, 0.0f), 0.0f);
    door->CreateFixture(&leaf, 0.0f);
    const std::vector<b2Body*> boxes = {trial.Box(1.5f, 3.0f, 0.4f, 0.4f),
                                        trial.Box(2.4f, 3.0f, 0.4f, 0.4f)};
    door->SetAngularVelocity(1.0f);
    // Its tip goes at 4 m/s, and throws as it should.
    TryPress(trial, "door at a wall", door, boxes, 2.5, 2.0 * kSqueezedOut);
}

} // namespace
