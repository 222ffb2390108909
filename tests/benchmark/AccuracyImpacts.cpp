// SPDX-License-Identifier: MIT
// Hits: passed on through a row, between bullets, and with walls thinner than a step is long.
#include "AccuracyParts.h"

#include <random>

namespace bench
{
namespace
{

/// Returns the sum for circles of one size. A circle that moves at 1 m/s contributes 1.
double SumOfSquaredSpeeds(const Sim& sim, BodyId first)
{
    double sum = 0.0;
    for (BodyId id = first; id < sim.BodyCount(); ++id)
    {
        const BodyState s = sim.State(id);
        sum += s.vx * s.vx + s.vy * s.vy;
    }
    return sum;
}

/// H: no gravity, friction 0, restitution 1; five circles of radius 0.5 at rest in a row, touching,
/// and a sixth that comes at 10 m/s. The kinetic energy lost half a second after the hit, and the
/// share of the speed that the last one flies off with.
class CradleExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        Material steel;
        steel.friction = 0.0;
        steel.restitution = 1.0;
        for (int i = 0; i < 6; ++i)
        {
            BodySpec spec;
            spec.x = i == 0 ? -kWay : i;
            spec.vx = i == 0 ? kSpeed : 0.0;
            m_last = sim.AddBody(spec);
            sim.AddCircle(m_last, 0.5, steel);
        }
    }
    void Look(Sim&, double) override {}
    Outcome Judge(Sim& sim) override
    {
        const double kept = SumOfSquaredSpeeds(sim, 0) / (kSpeed * kSpeed);
        return {100.0 * std::abs(1.0 - kept),
                {{"passed_on_percent", 100.0 * sim.State(m_last).vx / kSpeed}}};
    }

private:
    static constexpr double kSpeed = 10.0;
    static constexpr double kWay = 4.0; // so that 5 m and 0.5 s pass before the hit, a whole second
                                        // is half after it

    BodyId m_last = 0;
};

/// CCD: 500 circles of radius 0.1 on a grid of 1.5 m in random directions, friction 0, restitution
/// 1, no bullets, in a square of half-extent 20 with walls of boxes 0.1 m thick. Measures the
/// number of circles outside at the end, and the fraction of kinetic energy left.
class WallsExperiment final : public Experiment
{
public:
    explicit WallsExperiment(double speed) : m_speed(speed) {}

    void Build(Sim& sim) override
    {
        Material elastic;
        elastic.friction = 0.0;
        elastic.restitution = 1.0;
        const BodyId walls = AddStaticBody(sim);
        const double middle = kHalf + kWall;
        for (const double side : {-1.0, 1.0})
        {
            sim.AddBox(walls, kHalf + 2.0 * kWall, kWall, 0.0, side * middle, elastic);
            sim.AddBox(walls, kWall, kHalf + 2.0 * kWall, side * middle, 0.0, elastic);
        }
        m_first = BodyId(sim.BodyCount());
        std::mt19937 random(7);
        for (int i = 0; i < kCount; ++i)
        {
            const double angle = 2.0 * kPi * double(random()) / 4294967296.0;
            BodySpec spec;
            spec.x = -17.25 + 1.5 * (i % 24);
            spec.y = -15.0 + 1.5 * (i / 24); // NOLINT(bugprone-integer-division): a row
            spec.vx = m_speed * std::cos(angle);
            spec.vy = m_speed * std::sin(angle);
            sim.AddCircle(sim.AddBody(spec), 0.1, elastic);
        }
    }
    void Look(Sim&, double) override {}
    Outcome Judge(Sim& sim) override
    {
        int escaped = 0;
        for (BodyId id = m_first; id < sim.BodyCount(); ++id)
        {
            const BodyState s = sim.State(id);
            escaped += !(std::abs(s.x) < kHalf + kWall && std::abs(s.y) < kHalf + kWall);
        }
        const double kept = SumOfSquaredSpeeds(sim, m_first) / (kCount * m_speed * m_speed);
        return {double(escaped), {{"energy_kept_percent", 100.0 * kept}}};
    }

private:
    static constexpr int kCount = 500;
    static constexpr double kHalf = 20.0;
    static constexpr double kWall = 0.05; // half of its thickness [m]

    double m_speed;
    BodyId m_first = 0;
};

/// CCD: 100 pairs of bullets, circles of radius 0.1, head on at 100 m/s each, restitution 0, a lane
/// of 1 m for each pair. They start 10 m apart, with a small increment per pair, so they meet at
/// every part of a step. Measures the number of pairs that have passed through each other at any
/// time.
class BulletsExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        for (int i = 0; i < kPairs; ++i)
        {
            for (const double side : {-1.0, 1.0})
            {
                BodySpec spec;
                spec.x = side * (5.0 + 0.0171 * i);
                spec.y = i;
                spec.vx = -side * 100.0;
                spec.bullet = true;
                sim.AddCircle(sim.AddBody(spec), 0.1, Material());
            }
        }
        m_passed.assign(kPairs, false);
    }
    void Look(Sim& sim, double) override
    {
        for (int i = 0; i < kPairs; ++i)
        {
            const bool isInOrder = sim.State(2 * i).x < sim.State(2 * i + 1).x;
            m_passed[std::size_t(i)] = m_passed[std::size_t(i)] || !isInOrder;
        }
    }
    Outcome Judge(Sim&) override
    {
        double passed = 0.0;
        for (const bool pair : m_passed)
        {
            passed += pair;
        }
        return {passed, {}};
    }

private:
    static constexpr int kPairs = 100;

    std::vector<bool> m_passed;
};

/// CCD: 200 rods of 2 m x 0.02 m fly down at 60 m/s onto one edge. All heights and angles differ,
/// and the rods spin at 30 rad/s either way. Restitution 0, no gravity, no contact with each other.
/// Measures the number of rods whose centre is below the edge at the end.
class RodsExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        const BodyId ground = AddStaticBody(sim);
        sim.AddEdge(ground, -10.0, 0.0, 4.0 * kRods + 10.0, 0.0, Material());
        m_first = ground + 1;
        Material rod;
        rod.category = 2;
        rod.mask = 1;
        for (int i = 0; i < kRods; ++i)
        {
            BodySpec spec;
            spec.x = 4.0 * i;
            spec.y = 5.0 + 0.013 * i;
            spec.angle = 0.37 * i;
            spec.vy = -60.0;
            spec.angularVelocity = i % 2 == 0 ? 30.0 : -30.0;
            sim.AddBox(sim.AddBody(spec), 1.0, 0.01, 0.0, 0.0, rod);
        }
    }
    void Look(Sim&, double) override {}
    Outcome Judge(Sim& sim) override
    {
        int passed = 0;
        for (int i = 0; i < kRods; ++i)
        {
            passed += !(sim.State(m_first + i).y > -0.05);
        }
        return {double(passed), {}};
    }

private:
    static constexpr int kRods = 200;

    BodyId m_first = 0;
};

} // namespace

void AppendImpactCases(AccuracyCases& cases)
{
    cases.push_back(Weightless(MakeCase<CradleExperiment>(
        "H-cradle", "a ball hits a row of five, the kinetic energy lost", "%", 1.0)));
    cases.push_back(Weightless(MakeCase<WallsExperiment>(
        "X-walls-100", "500 bodies at 100 m/s in thin walls, escaped in 5 s", "bodies", 5.0,
        100.0)));
    cases.push_back(Weightless(MakeCase<WallsExperiment>(
        "X-walls-300", "500 bodies at 300 m/s in thin walls, escaped in 5 s", "bodies", 5.0,
        300.0)));
    cases.push_back(Weightless(MakeCase<BulletsExperiment>(
        "X-bullets", "100 pairs of bullets head on, those that pass through each other", "pairs",
        0.5)));
    cases.push_back(Weightless(MakeCase<RodsExperiment>(
        "X-rods", "200 thin rods fly and spin onto an edge, those that pass through", "rods",
        0.5)));
}

} // namespace bench
