// SPDX-License-Identifier: MIT
// Single bodies: only time stepping, a slope and a floor can cause errors.
#include "AccuracyParts.h"
#include "References.h"

#include <algorithm>

namespace bench
{
namespace
{

/// A: a circle of radius 0.5 thrown at (10, 20) m/s; how far from the parabola it is at the end.
class ProjectileExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        BodySpec spec;
        spec.vx = 10.0;
        spec.vy = 20.0;
        m_body = sim.AddBody(spec);
        sim.AddCircle(m_body, 0.5, Material());
    }
    void Look(Sim&, double time) override { m_time = time; }
    Outcome Judge(Sim& sim) override
    {
        const BodyState s = sim.State(m_body);
        const RealPoint truth = ProjectilePosition(10, 20, kGravity, m_time);
        return {Distance({s.x, s.y}, {double(truth.x), double(truth.y)}), {}};
    }

private:
    BodyId m_body = 0;
    double m_time = 0.0;
};

/// F: a box of half-size 0.5 on a slope of 30 degrees (an edge), friction 0.3 on both. Measures the
/// error of its path along the slope, as a fraction of that path.
class SlopeExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        Material rough;
        rough.friction = kFriction;
        const double cosine = std::cos(kSlope), sine = std::sin(kSlope);
        sim.AddEdge(AddStaticBody(sim), -5.0 * cosine, 5.0 * sine, 50.0 * cosine, -50.0 * sine,
                    rough);
        m_start = {0.5 * sine, 0.5 * cosine};
        m_body = AddBodyAt(sim, m_start.x, m_start.y, -kSlope);
        sim.AddBox(m_body, 0.5, 0.5, 0.0, 0.0, rough);
    }
    void Look(Sim&, double time) override { m_time = time; }
    Outcome Judge(Sim& sim) override
    {
        const BodyState s = sim.State(m_body);
        const double way =
            (s.x - m_start.x) * std::cos(kSlope) - (s.y - m_start.y) * std::sin(kSlope);
        const auto truth = double(SlideDistance(kGravity, kSlope, kFriction, m_time));
        return {100.0 * std::abs(way / truth - 1.0), {}};
    }

private:
    static constexpr double kSlope = kPi / 6.0;
    static constexpr double kFriction = 0.3;

    BodyId m_body = 0;
    Place m_start;
    double m_time = 0.0;
};

/// G: a circle of radius 0.5 falls from 10 m above the floor (an edge). The height of an apex is
/// that of the highest look, as a viewer sees it. The error is a share of the true apex.
class BounceExperiment final : public Experiment
{
public:
    /// `apex`: which is judged, the first being that after the first impact; 0: the last of the
    /// run.
    BounceExperiment(double restitution, int apex) : m_restitution(restitution), m_judged(apex) {}

    void Build(Sim& sim) override
    {
        Material elastic;
        elastic.restitution = m_restitution;
        sim.AddEdge(AddStaticBody(sim), -20.0, 0.0, 20.0, 0.0, elastic);
        m_body = AddBodyAt(sim, 0.0, kHeight + 0.5);
        sim.AddCircle(m_body, 0.5, elastic);
    }
    void Look(Sim& sim, double) override
    {
        const BodyState s = sim.State(m_body);
        const bool rises = s.vy > 0.0;
        if (rises && !m_rises)
        {
            m_highest = 0.0;
        }
        m_highest = std::max(m_highest, s.y - 0.5);
        if (!rises && m_rises && (m_judged == 0 || m_apexes < m_judged))
        {
            ++m_apexes;
            m_apex = m_highest;
        }
        m_rises = rises;
    }
    Outcome Judge(Sim&) override
    {
        if (m_apexes == 0 || m_apexes < m_judged)
        {
            return {100.0, {{"apexes", double(m_apexes)}}}; // it does not bounce so often
        }
        const auto truth = double(ApexHeight(kHeight, m_restitution, m_apexes));
        return {100.0 * std::abs(m_apex / truth - 1.0), {{"apexes", double(m_apexes)}}};
    }

private:
    static constexpr double kHeight = 10.0;

    double m_restitution;
    int m_judged;
    BodyId m_body = 0;
    bool m_rises = false;
    double m_highest = 0.0, m_apex = 0.0;
    int m_apexes = 0;
};

/// K: a circle of radius 0.5 at (10 km, 0) moves along x at 0.02 m/s. Measures the error of its
/// path as a fraction of it. One minute, so the resolution of single precision (0.5 mm there) is
/// 0.04 %.
class FarExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        BodySpec spec;
        spec.x = kStart;
        spec.vx = kSpeed;
        m_body = sim.AddBody(spec);
        sim.AddCircle(m_body, 0.5, Material());
    }
    void Look(Sim&, double time) override { m_time = time; }
    Outcome Judge(Sim& sim) override
    {
        const double way = sim.State(m_body).x - kStart;
        return {100.0 * std::abs(way / (kSpeed * m_time) - 1.0), {}};
    }

private:
    static constexpr double kStart = 10000.0;
    static constexpr double kSpeed = 0.02;

    BodyId m_body = 0;
    double m_time = 0.0;
};

} // namespace

void AppendMotionCases(AccuracyCases& cases)
{
    cases.push_back(MakeCase<ProjectileExperiment>(
        "A-projectile", "thrown at (10, 20) m/s, its position after 2 s", "m", 2.0));
    cases.push_back(MakeCase<SlopeExperiment>(
        "F-slope", "a box slides down 30 degrees, friction 0.3, its displacement in 2 s", "%",
        2.0));
    cases.push_back(MakeCase<BounceExperiment>("G-bounce-1", "restitution 1, the last apex of 10 s",
                                               "%", 10.0, 1.0, 0));
    cases.push_back(MakeCase<BounceExperiment>("G-bounce-half", "restitution 0.5, the second apex",
                                               "%", 4.0, 0.5, 2));
    cases.push_back(Weightless(MakeCase<FarExperiment>(
        "K-far", "at 0.02 m/s, 10 km from the origin, its displacement in 60 s", "%", 60.0)));
}

} // namespace bench
