// SPDX-License-Identifier: MIT
#include "Trial.h"

#include <algorithm>
#include <cmath>
#include <iterator>

/// Large piles that are thrown together come to rest, and hold their own weight: their islands have
/// too many contacts to be solved directly.
namespace
{

using namespace stability;

STABILITY_SUITE(Piles);

/// A container of this width, with its floor at 0 [m].
void AddContainer(Trial& trial, float32 width)
{
    b2Body* walls = trial.Body(b2_staticBody, 0.0f, 0.0f);
    b2PolygonShape wall;
    wall.SetAsBox(0.5f * width + 2.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
    Scene::Add(walls, wall, 0.0f, 0.0f);
    for (const float32 side : {-1.0f, 1.0f})
    {
        wall.SetAsBox(1.0f, 50.0f, b2Vec2(side * (0.5f * width + 1.0f), 50.0f), 0.0f);
        Scene::Add(walls, wall, 0.0f, 0.0f);
    }
}

/// Returns the mean of a function over all moving bodies.
template <class Function>
double Mean(const Trial& trial, Function&& function)
{
    double sum = 0.0;
    int count = 0;
    for (const b2Body* b = trial.world.GetBodyList(); b; b = b->GetNext())
    {
        if (b->GetType() == b2_dynamicBody)
        {
            sum += double(function(*b));
            ++count;
        }
    }
    return sum / count;
}

double MeanHeight(const Trial& trial)
{
    return Mean(trial, [](const b2Body& body) { return body.GetWorldCenter().y; });
}

double MeanSpeed(const Trial& trial)
{
    return Mean(trial, [](const b2Body& body) { return body.GetLinearVelocity().Length(); });
}

/// The root mean square of what touches, at the first point [m].
double MeanOverlap(Trial& trial)
{
    double sum = 0.0;
    int count = 0;
    for (b2Contact* c = trial.world.GetContactList(); c; c = c->GetNext())
    {
        if (c->IsTouching())
        {
            b2WorldManifold manifold;
            c->GetWorldManifold(&manifold);
            const double overlap = std::fmax(-double(manifold.separations[0]), 0.0);
            sum += overlap * overlap;
            ++count;
        }
    }
    return std::sqrt(sum / b2Max(count, 1));
}

TEST_P(Piles, OfCirclesDoNotSinkIntoThemselves)
{
    Trial trial(GetParam());
    AddContainer(trial, 40.0f);
    b2CircleShape circle;
    circle.m_radius = 0.25f;
    for (int i = 0; i < 1000; ++i)
    {
        const int row = i / 50;
        const float32 x = -19.4f + 0.78f * float32(i % 50) + (row % 2 == 1 ? 0.2f : 0.0f);
        Scene::Add(trial.Body(b2_dynamicBody, x, 1.0f + 0.6f * float32(row)), circle, 1.0f, 0.0f);
    }
    trial.Run(4.0);
    const double before = MeanHeight(trial);
    trial.Run(4.0);
    Judge("pile of 1000 circles, sinks in 4 s by", GetParam(), before - MeanHeight(trial), "m",
          0.0);
    Judge("pile of 1000 circles, mean overlap", GetParam(), MeanOverlap(trial), "m", 0.012);
    Judge("pile of 1000 circles, kinetic", GetParam(), trial.KineticOfAll(), "J", 0.2);
}

/// Returns the mean speed of 400 chains of rods 8 s after they fell, shifted to the right [m/s].
double SpeedOfRods(int32 subSteps, float32 shift)
{
    Trial trial(subSteps);
    AddContainer(trial, 20.0f);
    b2PolygonShape rod;
    rod.SetAsBox(0.2f, 0.07f);
    for (int i = 0; i < 400; ++i)
    {
        const float32 x = -8.4f + shift + 2.4f * float32(i % 8);
        const float32 y = 1.0f + 0.8f * float32(i / 8);
        b2Body* last = nullptr;
        for (int limb = 0; limb < 5; ++limb)
        {
            const float32 place = x + 0.4f * float32(limb - 2);
            b2Body* body = trial.Body(b2_dynamicBody, place, y);
            Scene::Add(body, rod, 1.0f, 0.0f);
            if (last != nullptr)
            {
                b2RevoluteJointDef hinge;
                hinge.Initialize(last, body, b2Vec2(place - 0.2f, y));
                trial.world.CreateJoint(&hinge);
            }
            last = body;
        }
    }
    trial.Run(8.0);
    return MeanSpeed(trial);
}

/// With one step, limbs that turn fast kept nothing of what held them, and never stopped. A pile
/// may still slide then, and which one does changes with the bits: the median of three is judged.
TEST_P(Piles, OfJointedRodsComeToRest)
{
    double speeds[3];
    for (int i = 0; i < 3; ++i)
    {
        speeds[i] = SpeedOfRods(GetParam(), 0.001f * float32(i));
    }
    std::sort(std::begin(speeds), std::end(speeds));
    Judge("3 piles of 400 chains of rods, speed", GetParam(), speeds[1], "m/s", 0.2);
}

} // namespace
