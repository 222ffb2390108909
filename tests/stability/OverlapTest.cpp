// SPDX-License-Identifier: MIT
#include "Trial.h"

/// What starts deep in something else comes out of it: in the end, without a jump, and with no
/// speed left.
namespace
{

using namespace stability;

STABILITY_SUITE(Overlap);

/// Slower than what falls a hand's breadth, so nothing is shot out [m/s].
constexpr double kShotOut = 1.0;
/// No jump [m a frame]: in small steps a contact pushes out by 3 m/s, 5 cm a frame. Where several
/// lie in a row, or in one place, they add up to some times that.
constexpr double kNoJump = 0.055;
constexpr double kNoJumpInARow = 0.2;
/// One step, the manual's scheme, takes 20 cm with each of its iterations.
constexpr double kJumpOfOneStep = 0.45;
/// Wedged in walls that leave no room: how far it comes from its place in 5 s [m].
constexpr double kWedged = 0.2;

/// Watches bodies that are let go in each other. Without gravity all speed is an error.
void TryApart(Trial& trial, const std::string& name, double mostJump = kNoJump,
              double mostSpeed = kShotOut)
{
    trial.world.SetAllowSleeping(false);
    double fastest = 0.0, kinetic = 0.0, jump = 0.0, mass = 0.0;
    std::vector<b2Body*> bodies;
    for (b2Body* b = trial.world.GetBodyList(); b; b = b->GetNext())
    {
        bodies.push_back(b);
        mass += double(b->GetMass());
    }
    Places last(bodies);
    trial.Run(5.0, [&](double) {
        fastest = Worst(trial.FastestSpeed(), fastest);
        kinetic = Worst(trial.KineticOfAll() / mass, kinetic);
        jump = Worst(last.Farthest(), jump);
        last = Places(bodies);
    });
    const int32 n = trial.world.GetSubStepCount();
    Judge("overlap: " + name + ", fastest", n, fastest, "m/s", mostSpeed);
    Judge("overlap: " + name + ", kinetic", n, kinetic, "J/kg", 0.5 * mostSpeed * mostSpeed);
    Judge("overlap: " + name + ", way in a step", n, jump, "m", Bound(n, mostJump, kJumpOfOneStep));
    Judge("overlap: " + name + ", left", n, 1000.0 * trial.DeepestOverlap(), "mm",
          2000.0 * double(b2_linearSlop));
}

TEST_P(Overlap, OfTwoBoxesGoes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Box(0.0f, 0.0f);
    trial.Box(0.2f, 0.1f);
    TryApart(trial, "two boxes");
}

TEST_P(Overlap, OfTwoBoxesInTheSamePlaceGoes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Box(0.0f, 0.0f);
    trial.Box(0.0f, 0.0f);
    TryApart(trial, "two boxes, same place");
}

TEST_P(Overlap, OfTwoBallsInTheSamePlaceGoes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Ball(0.0f, 0.0f);
    trial.Ball(0.0f, 0.0f);
    TryApart(trial, "two balls, same place");
}

TEST_P(Overlap, OfALightBoxInAHeavyOneGoes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    Trial::SetDensity(trial.Box(0.0f, 0.0f, 1.0f, 1.0f), 1000.0f);
    trial.Box(0.6f, 0.1f, 0.2f, 0.2f);
    TryApart(trial, "light in heavy");
}

TEST_P(Overlap, OfATurnedBoxInTheGroundGoes)
{
    Trial trial(GetParam());
    trial.WideGround();
    Scene::AddBox(trial.Body(b2_dynamicBody, 0.0f, -0.3f, 0.5f), 0.5f, 0.5f);
    TryApart(trial, "box in the ground");
}

TEST_P(Overlap, OfAPressedPileGoes)
{
    Trial trial(GetParam());
    trial.WideGround();
    for (int i = 0; i < 6; ++i)
    {
        trial.Box(0.02f * float32(i), 0.4f + 0.5f * float32(i));
    }
    // In one step the pile is pushed apart, leans and falls over: from 5.5 m at most.
    const double fall = std::sqrt(2.0 * double(kGravity) * 5.5);
    TryApart(trial, "pile of six, half as high", kNoJumpInARow, Bound(GetParam(), kShotOut, fall));
}

TEST_P(Overlap, OfTwentyThingsInOnePlaceGoes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    for (int i = 0; i < 20; ++i)
    {
        const float32 x = 0.4f * trial.Random(), y = 0.4f * trial.Random();
        i % 2 == 0 ? trial.Box(x, y, 0.3f, 0.3f) : trial.Ball(x, y, 0.3f);
    }
    TryApart(trial, "twenty in one place", kNoJumpInARow);
}

TEST_P(Overlap, OfABoxWedgedBetweenWallsDoesNotShootItOut)
{
    // It can never come free: the walls are too close.
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Wall(-0.5f, 0.2f);
    trial.Wall(0.5f, 0.2f);
    b2Body* box = trial.Box(0.0f, 0.0f);
    trial.world.SetAllowSleeping(false);
    double fastest = 0.0;
    trial.Run(5.0, [&](double) { fastest = Worst(trial.FastestSpeed(), fastest); });
    Judge("overlap: wedged between walls, fastest", GetParam(), fastest, "m/s", kShotOut);
    Judge("overlap: wedged between walls, way", GetParam(), double(box->GetPosition().Length()),
          "m", kWedged);
}

} // namespace
