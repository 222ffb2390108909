// SPDX-License-Identifier: MIT
// Structures that must stand: stacks with too much load on top, tall crooked ones, a card house.
#include "AccuracyParts.h"

#include <string>

namespace bench
{
namespace
{

/// A stack, and the displacement of its bodies.
class PileExperiment : public Experiment
{
public:
    void Build(Sim& sim) override
    {
        sim.AddBox(AddStaticBody(sim), 100.0, 1.0, 0.0, -1.0, Material());
        m_first = BodyId(sim.BodyCount());
        Fill(sim);
        for (BodyId id = m_first; id < sim.BodyCount(); ++id)
        {
            const BodyState s = sim.State(id);
            m_start.push_back({s.x, s.y});
        }
    }
    void Look(Sim&, double) override {}

protected:
    virtual void Fill(Sim& sim) = 0;

    /// The farthest that any body has come from its place, sideways or down [m]. Up does not count:
    /// bodies that are put without room for their skins are pushed apart, which is no error.
    double FarthestWay(const Sim& sim) const
    {
        double farthest = 0.0;
        for (std::size_t i = 0; i < m_start.size(); ++i)
        {
            const BodyState s = sim.State(m_first + BodyId(i));
            farthest = Worst(farthest, Way({s.x, s.y}, m_start[i]));
        }
        return farthest;
    }
    /// Bodies that lie lower than where they were put, by more than `limit` [m].
    int Fallen(const Sim& sim, double limit) const
    {
        int fallen = 0;
        for (std::size_t i = 0; i < m_start.size(); ++i)
        {
            fallen += !(sim.State(m_first + BodyId(i)).y > m_start[i].y - limit);
        }
        return fallen;
    }

    static std::string Ending(int fallen) { return fallen > 0 ? "falls" : ""; }

private:
    static double Way(const Place& at, const Place& start)
    {
        return std::hypot(at.x - start.x, Worst(0.0, start.y - at.y));
    }

    BodyId m_first = 0;
    std::vector<Place> m_start;
};

/// E: ten boxes of half-size 0.5, straight and touching, the top one `ratio` times as heavy. While
/// it stands, the error is the maximum overlap in the second half, as the engine defines it, skins
/// included. Once a box is half a box lower, it is the maximum displacement of any box.
class HeavyTopExperiment final : public PileExperiment
{
public:
    explicit HeavyTopExperiment(double ratio) : m_ratio(ratio) {}

    void Look(Sim& sim, double time) override
    {
        if (time > 10.0)
        {
            m_overlap = Worst(m_overlap, sim.LookAtContacts().deepest);
        }
    }
    Outcome Judge(Sim& sim) override
    {
        const int fallen = Fallen(sim, 0.5);
        return {1000.0 * (fallen > 0 ? FarthestWay(sim) : m_overlap),
                {{"fallen", double(fallen)}, {"overlap_mm", 1000.0 * m_overlap}},
                Ending(fallen)};
    }

private:
    void Fill(Sim& sim) override
    {
        for (int i = 0; i < 10; ++i)
        {
            Material material;
            material.density = i == 9 ? m_ratio : 1.0;
            sim.AddBox(AddBodyAt(sim, 0.0, 0.5 + i), 0.5, 0.5, 0.0, 0.0, material);
        }
    }

    double m_ratio;
    double m_overlap = 0.0;
};

/// J: boxes of half-size 0.5, touching, alternating 1 cm to the right and to the left. The error is
/// the maximum displacement of any box: centimetres while it stands.
class StackExperiment final : public PileExperiment
{
public:
    explicit StackExperiment(int count) : m_count(count) {}

    Outcome Judge(Sim& sim) override
    {
        const int fallen = Fallen(sim, 0.5);
        return {FarthestWay(sim), {{"fallen", double(fallen)}}, Ending(fallen)};
    }

private:
    void Fill(Sim& sim) override
    {
        for (int i = 0; i < m_count; ++i)
        {
            const BodyId box = AddBodyAt(sim, i % 2 == 0 ? 0.01 : -0.01, 0.5 + i);
            sim.AddBox(box, 0.5, 0.5, 0.0, 0.0, Material());
        }
    }

    int m_count;
};

/// J: five rows of tents. Each tent has two cards of 1 m x 0.05 m that lean by 25 degrees and meet
/// in a corner. There are five tents in the lowest row and one on top. Cards on the tents of a row,
/// the outer ones a little longer, carry the next row. Friction 0.8. The error is the maximum
/// displacement of any card.
class CardHouseExperiment final : public PileExperiment
{
public:
    Outcome Judge(Sim& sim) override
    {
        const int fallen = Fallen(sim, 0.1);
        return {FarthestWay(sim), {{"fallen", double(fallen)}}, Ending(fallen)};
    }

private:
    static constexpr double kHalf = 0.5, kThin = 0.025; // half-sizes of a card [m]
    static constexpr double kLean = 25.0 * kPi / 180.0;
    static constexpr double kPitch = 1.02; // from ridge to ridge [m]
    static constexpr double kGap = 0.01;   // between two lying cards, half of it [m]

    void Fill(Sim& sim) override
    {
        Material paper;
        paper.friction = 0.8;
        // Half the width and half the height of what a leaning card takes.
        const double width = kHalf * std::sin(kLean) + kThin * std::cos(kLean);
        const double height = kHalf * std::cos(kLean) + kThin * std::sin(kLean);
        double floor = 0.0;
        for (int tents = 5; tents > 0; --tents)
        {
            const double left = -0.5 * kPitch * (tents - 1);
            for (int i = 0; i < tents; ++i)
            {
                const double ridge = left + kPitch * i;
                const BodyId first = AddBodyAt(sim, ridge - width, floor + height, -kLean);
                sim.AddBox(first, kThin, kHalf, 0.0, 0.0, paper);
                const BodyId second = AddBodyAt(sim, ridge + width, floor + height, kLean);
                sim.AddBox(second, kThin, kHalf, 0.0, 0.0, paper);
            }
            for (int i = 0; i + 1 < tents; ++i)
            {
                const double from = left + kPitch * i + (i == 0 ? -kOver : kGap);
                const double to = left + kPitch * (i + 1) - (i + 2 == tents ? -kOver : kGap);
                const double y = floor + 2.0 * height + kThin;
                const BodyId card = AddBodyAt(sim, 0.5 * (from + to), y);
                sim.AddBox(card, 0.5 * (to - from), kThin, 0.0, 0.0, paper);
            }
            floor += 2.0 * height + 2.0 * kThin;
        }
    }

    static constexpr double kOver = 0.1; // beyond the outer ridges [m]
};

} // namespace

void AppendPileCases(AccuracyCases& cases)
{
    cases.push_back(MakeCase<HeavyTopExperiment>(
        "E-heavy-top-100", "ten boxes, the top one 100 times as heavy, the deepest overlap", "mm",
        20.0, 100.0));
    cases.push_back(MakeCase<HeavyTopExperiment>(
        "E-heavy-top-1000", "ten boxes, the top one 1000 times as heavy, the deepest overlap", "mm",
        20.0, 1000.0));
    for (const int count : {16, 20, 30, 50})
    {
        const std::string number = std::to_string(count);
        cases.push_back(MakeCase<StackExperiment>(
            ("J-stack-" + number).c_str(),
            (number + " boxes offset by 1 cm in alternation, the largest displacement in 20 s")
                .c_str(),
            "m", 20.0, count));
    }
    cases.push_back(MakeCase<CardHouseExperiment>(
        "J-card-house", "five rows of cards, the largest displacement in 20 s", "m", 20.0));
}

} // namespace bench
