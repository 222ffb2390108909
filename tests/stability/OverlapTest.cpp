// SPDX-License-Identifier: MIT
#include "Trial.h"

#include <algorithm>

/// Bodies that start deep inside another leave it: completely, without a jump, and with no speed
/// left.
namespace
{

using namespace stability;

STABILITY_SUITE(Overlap);

/// Slower than what falls a hand's breadth, so nothing is shot out [m/s].
constexpr double kShotOut = 1.0;
/// Maximum push [m per frame]: with sub-steps a contact pushes out by 3 m/s, 5 cm per frame.
/// Several contacts in a row, or in one place, add up to at most four times that.
constexpr double kNoJump = 0.055;
constexpr double kNoJumpInARow = 0.205;
/// The same for falling bodies: beyond the displacement of the larger of the speeds before and
/// after a step. Impacts within the step may push once more, and change the speed in between.
constexpr double kNoJumpInAFall = 0.25;
/// One step, the manual's scheme, takes 20 cm with each of its iterations.
constexpr double kJumpOfOneStep = 0.45;
constexpr double kJumpOfOneStepInAJam = 0.6;
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

TEST_P(Overlap, IsCorrectedBetweenTwoBoxes)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Box(0.0f, 0.0f);
    trial.Box(0.2f, 0.1f);
    TryApart(trial, "two boxes");
}

TEST_P(Overlap, IsCorrectedBetweenTwoBoxesInOnePlace)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Box(0.0f, 0.0f);
    trial.Box(0.0f, 0.0f);
    TryApart(trial, "two boxes, same place");
}

TEST_P(Overlap, IsCorrectedBetweenTwoBallsInOnePlace)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Ball(0.0f, 0.0f);
    trial.Ball(0.0f, 0.0f);
    TryApart(trial, "two balls, same place");
}

TEST_P(Overlap, IsCorrectedBetweenALightBoxAndAHeavyOne)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    Trial::SetDensity(trial.Box(0.0f, 0.0f, 1.0f, 1.0f), 1000.0f);
    trial.Box(0.6f, 0.1f, 0.2f, 0.2f);
    TryApart(trial, "light in heavy");
}

TEST_P(Overlap, IsCorrectedForATurnedBoxInTheGround)
{
    Trial trial(GetParam());
    trial.WideGround();
    Scene::AddBox(trial.Body(b2_dynamicBody, 0.0f, -0.3f, 0.5f), 0.5f, 0.5f);
    TryApart(trial, "box in the ground");
}

TEST_P(Overlap, IsCorrectedInAPressedPile)
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

TEST_P(Overlap, IsCorrectedBetweenTwentyBodiesInOnePlace)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    for (int i = 0; i < 20; ++i)
    {
        const float32 x = 0.4f * trial.Random(), y = 0.4f * trial.Random();
        i % 2 == 0 ? trial.Box(x, y, 0.3f, 0.3f) : trial.Ball(x, y, 0.3f);
    }
    TryApart(trial, "twenty in one place", kNoJumpInARow);
}

/// Bodies in a box of 2 `half` by 2 `half` that also fall.
struct Jam
{
    Trial trial;
    float32 half;
    float32 heavy; ///< times as heavy as the others is every second one

    Jam(int32 n, float32 halfOfBox, float32 ratio) : trial(n), half(halfOfBox), heavy(ratio)
    {
        b2Body* walls = trial.Body(b2_staticBody, 0.0f, 0.0f);
        for (int i = 0; i < 4; ++i)
        {
            const b2Vec2 out = b2Mul(b2Rot(0.5f * b2_pi * float32(i)), b2Vec2(half, 0.0f));
            b2EdgeShape edge;
            edge.Set(out - b2Cross(1.0f, out), out + b2Cross(1.0f, out));
            walls->CreateFixture(&edge, 0.0f);
        }
    }

    void Add(b2Body* box)
    {
        Trial::SetDensity(box, bodies.size() % 2 == 1 ? heavy : 1.0f);
        bodies.push_back(box);
    }

    /// Measures the maximum displacement of a body in a step beyond that of its speed [m], and the
    /// maximum energy gain of a step [J/kg]. The gain may come only from lifting.
    void Watch(double seconds)
    {
        for (const b2Body* body : bodies)
        {
            mass += double(body->GetMass());
        }
        std::vector<double> speeds(bodies.size(), 0.0);
        Places last(bodies);
        double energy = trial.EnergyOfAll();
        std::vector<double> heights; // potential energy by step
        constexpr int kFall = 120;   // steps of a fall of 20 m
        trial.Run(seconds, [&](double time) {
            for (std::size_t i = 0; i < bodies.size(); ++i)
            {
                const double speed = double(bodies[i]->GetLinearVelocity().Length());
                const double fastest = speed > speeds[i] ? speed : speeds[i];
                const double way = last.WayOf(i) - fastest * double(kStep);
                double& farthest = heavy > 1.0f && i % 2 == 0 ? lightJump : jump;
                farthest = Worst(way, farthest);
                speeds[i] = speed;
            }
            last = Places(bodies);
            won = Worst((trial.EnergyOfAll() - energy) / mass, won);
            energy = trial.EnergyOfAll();
            kinetic = Worst(trial.KineticOfAll() / mass, kinetic);
            heights.push_back(energy - trial.KineticOfAll());
            if (time > 0.5 * seconds)
            {
                const double highest = *std::max_element(heights.end() - kFall, heights.end());
                late = Worst((energy - highest) / mass, late);
                motion = Worst(trial.KineticOfAll() / mass, motion);
            }
        });
    }

    double MostJump() const
    {
        return Bound(trial.world.GetSubStepCount(), kNoJumpInAFall, kJumpOfOneStepInAJam);
    }

    std::vector<b2Body*> bodies;
    double mass = 0.0, jump = 0.0, won = 0.0, kinetic = 0.0;
    double lightJump = 0.0; ///< of light things between heavy ones: thrown, and caught in the step
    /// Kinetic in the second half of the time, beyond that of a fall: what is jammed in mid-air, or
    /// pushed up there, may come free at any time [J/kg].
    double late = 0.0;
    double motion = 0.0; ///< kinetic in the second half of the time [J/kg]
};

/// Half inside each other, and more than there is room for side by side: they fall as they are.
void TryRow(int32 n, int count, float32 heavy, const std::string& name)
{
    constexpr double kFall = double(kGravity) * 9.5; // to the floor [J/kg]
    Jam jam(n, 10.0f, heavy);
    for (int i = 0; i < count; ++i)
    {
        jam.Add(jam.trial.Box(0.5f * float32(i) - 0.25f * float32(count), 0.0f));
    }
    jam.Watch(8.0);
    Judge("overlap: " + name + ", way in a step", n, jam.jump, "m", jam.MostJump());
    Judge("overlap: " + name + ", way of light ones", n, jam.lightJump, "m", kNoBound);
    Judge("overlap: " + name + ", won in a step", n, jam.won, "J/kg", 0.01 * kFall);
    Judge("overlap: " + name + ", kinetic", n, jam.kinetic, "J/kg", 1.05 * kFall);
    Judge("overlap: " + name + ", kinetic, late, beyond a fall", n, jam.late, "J/kg",
          0.5 * kShotOut * kShotOut);
}

TEST_P(Overlap, StaysCalmInARowOf22BetweenWalls)
{
    TryRow(GetParam(), 22, 1.0f, "row of 22 between walls");
}

TEST_P(Overlap, StaysCalmInARowOf30BetweenWalls)
{
    TryRow(GetParam(), 30, 1.0f, "row of 30 between walls");
}

TEST_P(Overlap, StaysCalmInARowOf22LightAndHeavyBoxes)
{
    TryRow(GetParam(), 22, 1000.0f, "row of 22, 1000:1 in turn");
}

TEST_P(Overlap, StaysCalmInARowOf30LightAndHeavyBoxes)
{
    TryRow(GetParam(), 30, 1000.0f, "row of 30, 1000:1 in turn");
}

/// Twenty boxes of a square metre in sixteen: they stay overlapped, and calm.
void TryConfined(int32 n, float32 heavy, const std::string& name)
{
    Jam jam(n, 2.0f, heavy);
    for (int i = 0; i < 20; ++i)
    {
        const float32 x = 1.4f * jam.trial.Random(), y = 1.4f * jam.trial.Random();
        jam.Add(jam.trial.Box(x, y));
    }
    jam.Watch(8.0);
    Judge("overlap: " + name + ", way in a step", n, jam.jump, "m", jam.MostJump());
    Judge("overlap: " + name + ", way of light ones", n, jam.lightJump, "m", kNoBound);
    Judge("overlap: " + name + ", won in a step", n, jam.won, "J/kg", 0.5);
    Judge("overlap: " + name + ", kinetic, late", n, jam.motion, "J/kg", 0.5 * kShotOut * kShotOut);
}

TEST_P(Overlap, StaysCalmInAnOverfilledBox)
{
    TryConfined(GetParam(), 1.0f, "twenty in a box for sixteen");
}

TEST_P(Overlap, StaysCalmInAnOverfilledBoxOfUnequalMasses)
{
    TryConfined(GetParam(), 1000.0f, "the same, 1000:1 in turn");
}

TEST_P(Overlap, DoesNotEjectABoxWedgedBetweenWalls)
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
