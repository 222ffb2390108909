// SPDX-License-Identifier: MIT
// Pendulums, chains and a pair of rods: what joints do to energy, to momentum and to themselves.
// Nothing here collides with anything.
#include "AccuracyParts.h"
#include "References.h"

namespace bench
{
namespace
{

constexpr double kRodLength = 1.0;
constexpr double kRodThickness = 0.1;
constexpr double kRodMass = kRodLength * kRodThickness; // of density 1
/// Fine enough for the truth: a fraction of the smallest step of any engine.
constexpr Real kReferenceStep = 1.0L / 9600;

Rod TheRod()
{
    return Rod{kRodLength, kRodThickness, kRodMass};
}

/// A rod along the x axis, its left end at (x, y).
BodyId AddRod(Sim& sim, double x, double y)
{
    Material apart;
    apart.mask = 0;
    const BodyId rod = AddBodyAt(sim, x + kRodLength / 2.0, y);
    sim.AddBox(rod, kRodLength / 2.0, kRodThickness / 2.0, 0.0, 0.0, apart);
    return rod;
}

Place LeftEnd(const BodyState& rod)
{
    return WorldPoint(rod, -kRodLength / 2.0, 0.0);
}

Place RightEnd(const BodyState& rod)
{
    return WorldPoint(rod, kRodLength / 2.0, 0.0);
}

double KineticEnergy(const BodyState& rod)
{
    const auto inertia = double(TheRod().InertiaAboutCenter());
    return 0.5 * kRodMass * (rod.vx * rod.vx + rod.vy * rod.vy) + 0.5 * inertia * rod.w * rod.w;
}

/// B: a rod of 1 m x 0.1 m let go level, hinged at one end. The largest error of its energy, as a
/// share of what falling into the lowest place sets free.
class PendulumExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        const BodyId ground = AddStaticBody(sim);
        m_rod = AddRod(sim, 0.0, 0.0);
        sim.AddRevolute(ground, m_rod, 0.0, 0.0);
    }
    void Look(Sim& sim, double) override
    {
        const BodyState s = sim.State(m_rod);
        const double energy = KineticEnergy(s) + kRodMass * kGravity * s.y;
        const double fall = kRodMass * kGravity * kRodLength / 2.0;
        m_error = Worst(m_error, 100.0 * std::abs(energy) / fall);
        m_gap = Worst(m_gap, 1000.0 * Distance(LeftEnd(s), {}));
    }
    Outcome Judge(Sim&) override { return {m_error, {{"gap_mm", m_gap}}}; }

private:
    BodyId m_rod = 0;
    double m_error = 0.0, m_gap = 0.0;
};

/// C: two such rods in a row, let go level; the largest distance of the free end from where it
/// should be at that time.
class DoublePendulumExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        const BodyId ground = AddStaticBody(sim);
        const BodyId first = AddRod(sim, 0.0, 0.0);
        sim.AddRevolute(ground, first, 0.0, 0.0);
        m_second = AddRod(sim, kRodLength, 0.0);
        sim.AddRevolute(first, m_second, kRodLength, 0.0);
    }
    void Look(Sim& sim, double time) override
    {
        m_truth = m_pendulum.After(m_truth, Real(time) - m_time, kReferenceStep);
        m_time = time;
        const RealPoint tip = m_pendulum.Tip(m_truth);
        m_error =
            Worst(m_error, Distance(RightEnd(sim.State(m_second)), {double(tip.x), double(tip.y)}));
    }
    Outcome Judge(Sim&) override { return {m_error, {}}; }

private:
    BodyId m_second = 0;
    DoublePendulum m_pendulum{TheRod(), kGravity};
    DoublePendulum::State m_truth{};
    Real m_time = 0;
    double m_error = 0.0;
};

/// D: 20 links of 1 m x 0.25 m, and a ball of radius 1 hinged by its centre to the end of the last.
class ChainExperiment : public Experiment
{
public:
    /// `ratio`: the ball's mass in links. Directions: of the chain at the start.
    ChainExperiment(double ratio, double dx, double dy) : m_ratio(ratio), m_dx(dx), m_dy(dy) {}

    void Build(Sim& sim) override
    {
        Material link, ball;
        link.mask = ball.mask = 0;
        ball.density = m_ratio * kWidth / kPi;
        BodyId last = m_ground = AddStaticBody(sim);
        for (int i = 0; i < kLinks; ++i)
        {
            const BodyId next =
                AddBodyAt(sim, m_dx * (i + 0.5), m_dy * (i + 0.5), std::atan2(m_dy, m_dx));
            sim.AddBox(next, 0.5, kWidth / 2.0, 0.0, 0.0, link);
            sim.AddRevolute(last, next, m_dx * i, m_dy * i);
            last = next;
        }
        m_ball = AddBodyAt(sim, m_dx * kLinks, m_dy * kLinks);
        sim.AddCircle(m_ball, 1.0, ball);
        sim.AddRevolute(last, m_ball, m_dx * kLinks, m_dy * kLinks);
    }
    void Look(Sim& sim, double) override
    {
        Place end;
        for (int i = 0; i < kLinks; ++i)
        {
            const BodyState link = sim.State(m_ground + 1 + i);
            m_widest = Worst(m_widest, Distance(end, WorldPoint(link, -0.5, 0.0)));
            end = WorldPoint(link, 0.5, 0.0);
        }
        const BodyState ball = sim.State(m_ball);
        m_widest = Worst(m_widest, Distance(end, {ball.x, ball.y}));
        m_longest = Worst(m_longest, Distance({}, {ball.x, ball.y}));
    }

protected:
    double WidestGap() const { return 1000.0 * m_widest; } // [mm]
    /// At twice its length the chain counts as failed.
    std::string Ending() const { return Stretch() < 100.0 ? "" : "bursts"; }
    double Stretch() const { return 100.0 * Worst(0.0, m_longest / kLinks - 1.0); } // [%]

private:
    static constexpr int kLinks = 20;
    static constexpr double kWidth = 0.25;

    double m_ratio, m_dx, m_dy;
    BodyId m_ground = 0, m_ball = 0;
    double m_widest = 0.0, m_longest = 0.0;
};

/// The widest gap that opens in any hinge while the chain hangs, straight at the start.
class HangingChainExperiment final : public ChainExperiment
{
public:
    HangingChainExperiment() : ChainExperiment(100.0, 0.0, -1.0) {}
    Outcome Judge(Sim&) override
    {
        return {WidestGap(), {{"stretch_percent", Stretch()}}, Ending()};
    }
};

/// The largest distance of the ball from the fixed point, beyond the length of the chain; the chain
/// is let go level.
class SwungChainExperiment final : public ChainExperiment
{
public:
    SwungChainExperiment() : ChainExperiment(1000.0, 1.0, 0.0) {}
    Outcome Judge(Sim&) override { return {Stretch(), {{"gap_mm", WidestGap()}}, Ending()}; }
};

/// I: two such rods in a row with a common hinge. One spins at 4.5 rad/s, the other does not. The
/// velocity of the hinge is the same on both, so their common centre is at rest. Measures the final
/// error of the angular momentum, and that of the energy.
class PairExperiment final : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        Material apart;
        apart.mask = 0;
        for (const double x : {-kRodLength / 2.0, kRodLength / 2.0})
        {
            BodySpec spec;
            spec.x = x;
            spec.vy = 0.5 * kSpin * x;
            spec.angularVelocity = x < 0.0 ? kSpin : 0.0;
            m_second = sim.AddBody(spec);
            sim.AddBox(m_second, kRodLength / 2.0, kRodThickness / 2.0, 0.0, 0.0, apart);
        }
        sim.AddRevolute(m_second - 1, m_second, 0.0, 0.0);
        m_momentum = Momentum(sim);
        m_energy = Energy(sim);
    }
    void Look(Sim&, double) override {}
    Outcome Judge(Sim& sim) override
    {
        return {100.0 * std::abs(1.0 - Momentum(sim) / m_momentum),
                {{"energy_percent", 100.0 * std::abs(1.0 - Energy(sim) / m_energy)}}};
    }

private:
    static constexpr double kSpin = 4.5;

    /// About the origin, where the common centre stays.
    double Momentum(const Sim& sim) const
    {
        double sum = 0.0;
        for (const BodyId id : {m_second - 1, m_second})
        {
            const BodyState s = sim.State(id);
            sum += kRodMass * (s.x * s.vy - s.y * s.vx);
            sum += double(TheRod().InertiaAboutCenter()) * s.w;
        }
        return sum;
    }
    double Energy(const Sim& sim) const
    {
        return KineticEnergy(sim.State(m_second - 1)) + KineticEnergy(sim.State(m_second));
    }

    BodyId m_second = 0;
    double m_momentum = 0.0, m_energy = 0.0;
};

} // namespace

void AppendJointCases(AccuracyCases& cases)
{
    cases.push_back(MakeCase<PendulumExperiment>(
        "B-pendulum", "a rod let go level, the largest error of its energy in 10 s", "%", 10.0));
    cases.push_back(MakeCase<DoublePendulumExperiment>(
        "C-double-pendulum", "two rods let go level, the largest error of the free end in 2 s", "m",
        2.0));
    cases.push_back(MakeCase<HangingChainExperiment>(
        "D-chain-100", "20 links and a ball of 100, the widest gap in a hinge in 10 s", "mm",
        10.0));
    cases.push_back(MakeCase<SwungChainExperiment>(
        "D-chain-1000", "20 links and a ball of 1000 swung from level, the stretch in 10 s", "%",
        10.0));
    cases.push_back(Weightless(MakeCase<PairExperiment>(
        "I-pair", "two hinged rods, free, one spinning, the angular momentum lost in 60 s", "%",
        60.0)));
}

} // namespace bench
