// SPDX-License-Identifier: MIT
#include "Trial.h"

/// 1, 10 and 100 km from the origin, where what a program reads is as coarse as 0.06, 1 and 8 mm.
namespace
{

using namespace stability;

STABILITY_SUITE(FarAway);

constexpr float32 kPlaces[] = {0.0f, 1024.0f, 10240.0f, 102400.0f}; // [m]

/// Returns the rounding of a coordinate when it is read [m].
double Grain(float32 place)
{
    return double(std::nextafter(place, 2.0f * place + 1.0f) - place);
}

std::string Named(const char* what, float32 place)
{
    return what + std::string(", ") + std::to_string(int(place / 1000.0f)) + " km out";
}

TEST_P(FarAway, KeepsAStackStanding)
{
    for (const float32 place : kPlaces)
    {
        Trial trial(GetParam());
        trial.world.SetAllowSleeping(false);
        trial.Ground()->SetTransform(b2Vec2(place, place - 1.0f), 0.0f);
        std::vector<b2Body*> boxes;
        for (int i = 0; i < 10; ++i)
        {
            boxes.push_back(trial.Box(place, place + 0.515625f + 1.015625f * float32(i)));
        }
        const Places places(boxes);
        double trembling = 0.0;
        trial.Run(20.0, [&](double time) {
            trembling = time > 10.0 ? Worst(trial.FastestSpeed(), trembling) : 0.0;
        });
        const std::string name = Named("stack of 10", place);
        Judge(name + ", way", GetParam(), places.Farthest(), "m", 0.05);
        Judge(name + ", speed after 10 s", GetParam(), trembling, "m/s",
              double(b2_linearSleepTolerance));
    }
}

/// 0.02 m/s for ten minutes, 12 m.
TEST_P(FarAway, MovesASlowBodyExactly)
{
    for (const float32 place : kPlaces)
    {
        Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
        b2Body* body = trial.Ball(place, place);
        body->SetLinearVelocity(b2Vec2(0.02f, -0.02f));
        trial.Run(600.0);
        const double x = double(body->GetPosition().x - place) / 12.0;
        const double y = double(body->GetPosition().y - place) / -12.0;
        Judge(Named("0.02 m/s for 12 m", place), GetParam(),
              100.0 * Worst(std::abs(x - 1.0), std::abs(y - 1.0)), "%", 0.1);
    }
}

/// The largest difference from the same pendulum at the origin.
TEST_P(FarAway, SwingsAPendulumAsAtTheOrigin)
{
    std::vector<float32> angles;
    for (const float32 place : kPlaces)
    {
        Trial trial(GetParam());
        b2Body* rod = trial.Part(place + 0.5f, place, 0.5f, 0.0625f);
        b2Body* second = trial.Part(place + 1.5f, place, 0.5f, 0.0625f);
        trial.Hinge(trial.Post(place, place), rod, place, place);
        const b2Joint* hinge = trial.Hinge(rod, second, place + 1.0f, place);
        double off = 0.0, widest = 0.0;
        std::size_t i = 0;
        // A double pendulum forgets where it came from, so only its beginning is compared.
        trial.Run(2.0, [&](double) {
            if (place == 0.0f)
            {
                angles.push_back(second->GetAngle());
            }
            off = Worst(double(b2Abs(second->GetAngle() - angles[i++])), off);
            widest = Worst(double(Gap(hinge)), widest);
        });
        const std::string name = Named("double pendulum", place);
        Judge(name + ", angle off", GetParam(), off, "rad", 1e-3);
        Judge(name + ", gap", GetParam(), 1000.0 * widest, "mm",
              Bound(GetParam(), 0.1 + 2000.0 * Grain(place)));
    }
}

/// A ball rolls down a slope and is thrown against a wall at 50 m/s.
TEST_P(FarAway, SolvesImpactsAsAtTheOrigin)
{
    double atOrigin = 0.0;
    for (const float32 place : kPlaces)
    {
        Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
        b2Body* wall = trial.Body(b2_staticBody, place + 10.0f, place);
        Scene::AddBox(wall, 0.03125f, 5.0f, 0.0f, 0.0f);
        b2Body* ball = trial.Body(b2_dynamicBody, place, place);
        Scene::AddBall(ball, 0.25f, 0.0f, 1.0f);
        ball->SetLinearVelocity(b2Vec2(50.0f, 3.0f));
        trial.Run(1.0);
        const double speed = double(ball->GetLinearVelocity().x);
        Judge(Named("bounce at 50 m/s", place) + ", speed lost", GetParam(),
              100.0 * std::abs(speed / -50.0 - 1.0), "%", 0.1);
        const double x = double(ball->GetPosition().x - place);
        atOrigin = place == 0.0f ? x : atOrigin;
        Judge(Named("bounce at 50 m/s", place) + ", place after 1 s off", GetParam(),
              std::abs(x - atOrigin), "m", 0.02 + Grain(place));
    }
}

} // namespace
