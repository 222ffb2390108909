// SPDX-License-Identifier: MIT
#pragma once

#include "SubStepsScene.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

/// The common part of the stability suite: a world that is watched while it runs, and the verdict.
/// A verdict is a number with its bound that is printed, recorded and checked. Used only by the
/// tests in this folder. Never checks times.
namespace stability
{

using namespace dynamics;

/// The setting that is recommended: at 60 Hz every scene has to be good with it.
inline constexpr int32 kRecommended = 4;

/// For numbers that are shown and not held to anything.
inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Prints one line (case, sub-steps, number, unit, bound), records it, and fails if the number
/// is above the bound or none.
inline void Judge(const std::string& name, int32 subSteps, double value, const std::string& unit,
                  double bound)
{
    char limit[32] = "-";
    if (bound < kNoBound)
    {
        std::snprintf(limit, sizeof limit, "%.4g", bound);
    }
    std::printf("verdict | %-44s | %2d | %11.4g %-5s | %8s | %s\n", name.c_str(), int(subSteps),
                value, unit.c_str(), limit, value <= bound ? "ok" : "BAD");
    testing::Test::RecordProperty(name + ", sub-steps " + std::to_string(subSteps),
                                  std::to_string(value) + " " + unit);
    EXPECT_TRUE(value <= bound) << name << " with " << subSteps << " sub-steps: " << value << " "
                                << unit << ", the bound is " << bound;
}

/// One bound for sub-steps, and one for the default scheme.
inline double FromRecommended(int32 subSteps, double bound)
{
    return subSteps >= kRecommended ? bound : kNoBound;
}
inline double Bound(int32 subSteps, double small, double defaultScheme = kNoBound)
{
    return subSteps == 1 ? defaultScheme : small;
}

/// The larger one; a NaN stays.
inline double Worst(double a, double b)
{
    return a > b || std::isnan(a) ? a : b;
}

/// A world with this number of sub-steps. Every trial checks that all numbers stay finite and the
/// data structures valid.
class Trial : public SmallScene
{
public:
    explicit Trial(int32 subSteps, const b2Vec2& gravity = b2Vec2(0.0f, -kGravity))
        : SmallScene(gravity, subSteps)
    {
        world.SetContinuousPhysics(true);
    }

    /// Runs for so long [s]; `look` is called after every step, with the time [s].
    template <class Look>
    void Run(double seconds, const Look& look)
    {
        Run(
            seconds, [](int) { return kStep; }, look);
    }
    void Run(double seconds)
    {
        Run(seconds, [](double) {});
    }
    /// The same with steps of changing length: `lengthOf(i)` [s].
    template <class Length, class Look>
    void Run(double seconds, const Length& lengthOf, const Look& look)
    {
        double time = 0.0;
        for (int i = 0; time < seconds - 1e-4; ++i)
        {
            const float32 step = lengthOf(i);
            world.Step(step, 8, 3);
            time += double(step);
            ASSERT_TRUE(AllFinite()) << "after " << time << " s";
            if (i % 60 == 0)
            {
                ASSERT_EQ(WhyBroken(world, true), "") << "after " << time << " s";
            }
            look(time);
        }
    }

    bool AllFinite() const
    {
        for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            if (!b->GetPosition().IsValid() || !b2IsValid(b->GetAngle()) ||
                !b->GetLinearVelocity().IsValid() || !b2IsValid(b->GetAngularVelocity()))
            {
                return false;
            }
        }
        return true;
    }
    /// Returns the maximum speed of any body's centre [m/s].
    double FastestSpeed() const
    {
        double fastest = 0.0;
        for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            fastest = Worst(double(b->GetLinearVelocity().Length()), fastest);
        }
        return fastest;
    }
    /// Returns the kinetic energy of all bodies [J].
    double KineticOfAll() const
    {
        double sum = 0.0;
        for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            sum += b->GetType() == b2_dynamicBody ? KineticOf(*b) : 0.0;
        }
        return sum;
    }
    /// Returns the kinetic and potential energy of all bodies [J].
    double EnergyOfAll() const
    {
        double sum = 0.0;
        for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            if (b->GetType() == b2_dynamicBody)
            {
                const b2Vec2 g = b->GetGravityScale() * world.GetGravity();
                const b2Vec2 c = b->GetWorldCenter();
                sum += KineticOf(*b) - double(b->GetMass()) *
                                           (double(g.x) * double(c.x) + double(g.y) * double(c.y));
            }
        }
        return sum;
    }
    /// 2 km wide, so that nothing that falls over comes to its end; its top is at y = 0.
    b2Body* WideGround(float32 friction = 0.2f)
    {
        b2Body* ground = Body(b2_staticBody, 0.0f, -50.0f);
        Scene::AddBox(ground, 1000.0f, 50.0f, friction);
        return ground;
    }
    double DeepestOverlap() const { return double(dynamics::DeepestOverlap(world)); }

    static void SetDensity(b2Body* body, float32 density)
    {
        body->GetFixtureList()->SetDensity(density);
        body->ResetMassData();
    }

private:
    static double KineticOf(const b2Body& b)
    {
        const double w = double(b.GetAngularVelocity());
        const b2Vec2 v = b.GetLinearVelocity();
        // About the centre: b2Body::GetInertia is about the origin.
        const double inertia = double(b.GetInertia()) -
                               double(b.GetMass()) * double(b.GetLocalCenter().LengthSquared());
        return 0.5 * double(b.GetMass()) * (double(v.x) * double(v.x) + double(v.y) * double(v.y)) +
               0.5 * inertia * w * w;
    }
};

/// The start positions of bodies, for measuring their displacement.
class Places
{
public:
    explicit Places(const std::vector<b2Body*>& bodies) : m_bodies(bodies)
    {
        for (const b2Body* body : bodies)
        {
            m_places.push_back(body->GetPosition());
        }
    }

    /// Returns the displacement of a body [m].
    double WayOf(std::size_t body) const
    {
        return double(b2Distance(m_bodies[body]->GetPosition(), m_places[body]));
    }
    /// The farthest way of any [m].
    double Farthest() const
    {
        double farthest = 0.0;
        for (std::size_t i = 0; i < m_bodies.size(); ++i)
        {
            farthest = Worst(WayOf(i), farthest);
        }
        return farthest;
    }

private:
    std::vector<b2Body*> m_bodies;
    std::vector<b2Vec2> m_places;
};

/// Every test runs with the default scheme, the recommended number of sub-steps, and coarser and
/// finer ones. The variable BOXREEL_SUB_STEPS selects a single number. The finest takes the most
/// time, so it is a separate run.
class EverySubStepCount : public testing::TestWithParam<int32>
{};

inline std::vector<int32> SubStepCounts()
{
    const char* const one = std::getenv("BOXREEL_SUB_STEPS");
    return one != nullptr ? std::vector<int32>{std::atoi(one)} : std::vector<int32>{1, 2, 4, 8};
}

#define STABILITY_SUITE(name)                                                                      \
    class name : public stability::EverySubStepCount                                               \
    {};                                                                                            \
    INSTANTIATE_TEST_SUITE_P(SubSteps, name, testing::ValuesIn(stability::SubStepCounts()),        \
                             testing::PrintToStringParamName())

} // namespace stability
