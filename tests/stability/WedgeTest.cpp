// SPDX-License-Identifier: MIT
#include "Trial.h"

/// A body with restitution 1 and without friction flies into a wedge of 10 degrees and out again.
/// Its energy must not change. Impacts of all speeds bounce: where a point meets one wall without a
/// bounce while others press it there, the energy of their impulses would be lost.
namespace
{

using namespace stability;

constexpr int kFlights = 400;
constexpr float32 kOut = 13.0f; ///< above its start [m]

/// The wedge opens upward from the origin. Walls are 60 m long.
struct Flight : Trial
{
    Flight(int32 subSteps, float32 gravity) : Trial(subSteps, b2Vec2(0.0f, gravity))
    {
        const float32 half = 5.0f * b2_pi / 180.0f;
        const b2Vec2 end(60.0f * std::sin(half), 60.0f * std::cos(half));
        const b2Vec2 points[] = {b2Vec2(-end.x, end.y), b2Vec2_zero, end};
        b2ChainShape walls;
        walls.CreateChain(points, 3);
        Scene::Add(Body(b2_staticBody, 0.0f, 0.0f), walls, 0.0f, 1.0f);
        world.SetRestitutionThreshold(0.001f);
    }

    /// Throws a ball or a box into the wedge, and returns the share of its energy that is left.
    double Throw(bool isBall, const b2Vec2& from, float32 direction, float32 speed, float32 spin,
                 int steps = 60)
    {
        b2Body* body = Body(b2_dynamicBody, from.x, from.y, spin);
        body->SetSleepingAllowed(false);
        if (isBall)
        {
            Scene::AddBall(body, 0.15f, 0.0f, 1.0f);
        }
        else
        {
            Scene::AddBox(body, 0.15f, 0.15f, 0.0f, 1.0f);
        }
        body->SetLinearVelocity(speed * b2Vec2(std::sin(direction), -std::cos(direction)));
        body->SetAngularVelocity(isBall ? 0.0f : spin);
        const double before = EnergyOfAll();
        for (int i = 0; i < steps && body->GetPosition().y < kOut; ++i)
        {
            Step();
        }
        return EnergyOfAll() / before;
    }
};

struct Range
{
    double least = 1.0, most = 1.0;
};

/// Flies at 60 to 100 m/s, 0.02 to 0.2 rad off the axis, with a spin of up to 100 rad/s.
Range FlySideways(int32 subSteps, float32 gravity, bool isBall)
{
    Range range;
    for (int i = 0; i < kFlights; ++i)
    {
        const float32 offAxis = 0.02f + 0.001f * float32(i / 2 % 181);
        const b2Vec2 from(0.001f * float32(i % 9) - 0.004f, 12.0f);
        Flight flight(subSteps, gravity);
        const double left = flight.Throw(isBall, from, i % 2 == 0 ? offAxis : -offAxis,
                                         60.0f + 0.1f * float32(i), 0.5f * float32(i) - 100.0f);
        range.least = left < range.least || std::isnan(left) ? left : range.least;
        range.most = Worst(left, range.most);
    }
    return range;
}

/// Gravity's half step, h m g v / 2, is 0.5 % of the energy in a bounce at 60 m/s.
constexpr double kKept = 0.01;

void JudgeFlights(int32 fewest, bool isBall)
{
    for (int32 subSteps = fewest; subSteps <= 16; subSteps *= 2)
    {
        for (const float32 gravity : {0.0f, -10.0f})
        {
            const Range range = FlySideways(subSteps, gravity, isBall);
            const std::string what = std::string(isBall ? "ball" : "box") + " in a wedge" +
                                     (gravity != 0.0f ? " with gravity" : "");
            Judge(what + ", lost", subSteps, 100.0 * (1.0 - range.least), "%", 100.0 * kKept);
            Judge(what + ", won", subSteps, 100.0 * (range.most - 1.0), "%", 100.0 * kKept);
        }
    }
}

/// It meets one wall after the other. It loses 0.001 % and wins 0.6 % at most.
TEST(Wedge, KeepsTheEnergyOfABallFromTheSide)
{
    JudgeFlights(1, true);
}

/// Where it turns back it touches both walls at once, and each impulse against one wall presses
/// against the other. The iterations over an impact must not end before it is solved: with 64 of
/// them a box lost up to 14 %. A whole step limits rotation to b2_maxRotation, so it stops a spin.
TEST(Wedge, KeepsTheEnergyOfABox)
{
    JudgeFlights(2, false);
}

/// It meets both walls at the same time, so that a bounce off one drives it into the other.
TEST(Wedge, ThrowsBackABallThatComesAlongItsAxis)
{
    for (const int32 subSteps : {1, 2, 4, 8, 16})
    {
        for (const float32 gravity : {0.0f, -10.0f})
        {
            Flight flight(subSteps, gravity);
            const double left = flight.Throw(true, b2Vec2(0.0f, 12.0f), 0.0f, 80.0f, 0.0f);
            const std::string name =
                gravity != 0.0f ? "along a wedge's axis with gravity" : "along a wedge's axis";
            Judge(name + ", lost", subSteps, 100.0 * (1.0 - left), "%", 100.0 * kKept);
            Judge(name + ", won", subSteps, 100.0 * (left - 1.0), "%", 100.0 * kKept);
        }
    }
}

constexpr int kLongFlight = 600; // steps, for slow bodies

/// In a step without sub-steps it often touches both walls when the step begins. There the
/// iterations of the step solved both bounces at once: 93 % was lost, or 160 % was won.
TEST(Wedge, ThrowsBackABallThatComesNearItsAxis)
{
    for (const int32 subSteps : {1, 2, 4})
    {
        Range range;
        for (int i = 0; i < kFlights; ++i)
        {
            const b2Vec2 from(0.01f * float32(i % 5 - 2), 10.0f + 0.007f * float32(i));
            Flight flight(subSteps, 0.0f);
            const double left =
                flight.Throw(true, from, 0.0f, 10.0f + 0.075f * float32(i), 0.0f, kLongFlight);
            range.least = left < range.least || std::isnan(left) ? left : range.least;
            range.most = Worst(left, range.most);
        }
        Judge("near a wedge's axis, lost", subSteps, 100.0 * (1.0 - range.least), "%",
              100.0 * kKept);
        Judge("near a wedge's axis, won", subSteps, 100.0 * (range.most - 1.0), "%", 100.0 * kKept);
    }
}

/// At 11 m/s no spin of this box can exceed b2_maxRotation. Where one of two corners left a wall
/// while the other one came, the iterations held it there, which is work. It won up to 4 %.
TEST(Wedge, KeepsTheEnergyOfASlowBoxInAWholeStep)
{
    Range range;
    for (int i = 0; i < kFlights; ++i)
    {
        const b2Vec2 from(0.01f * float32(i % 5 - 2), 10.0f + 0.007f * float32(i));
        Flight flight(1, 0.0f);
        const float32 offAxis = 0.001f * float32(i % 201 - 100);
        const double left = flight.Throw(false, from, offAxis, 9.0f + 0.005f * float32(i),
                                         0.01f * float32(i % 300), kLongFlight);
        range.least = left < range.least || std::isnan(left) ? left : range.least;
        range.most = Worst(left, range.most);
    }
    Judge("slow box in a wedge, lost", 1, 100.0 * (1.0 - range.least), "%", 100.0 * kKept);
    Judge("slow box in a wedge, won", 1, 100.0 * (range.most - 1.0), "%", 100.0 * kKept);
}

} // namespace
