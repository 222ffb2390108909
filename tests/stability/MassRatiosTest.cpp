// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Heavy bodies on light ones, and heavy bodies at the end of light ones.
namespace
{

using namespace stability;

STABILITY_SUITE(MassRatios);

constexpr float32 kRatios[] = {1.0f, 10.0f, 100.0f, 1000.0f};

std::string Named(const char* what, float32 ratio)
{
    return what + std::string(", ") + std::to_string(int(ratio)) + ":1";
}

/// Deeper than the slop is an overlap that one sees [m]; deeper than a skin the cores touch.
constexpr double kOverlap = double(b2_linearSlop);

/// Ten unit boxes, each so dense as `densityOf` says.
template <class Density>
void TryStack(int32 subSteps, const std::string& name, const Density& densityOf, bool bound)
{
    Trial trial(subSteps);
    trial.world.SetAllowSleeping(false);
    trial.Ground();
    const std::vector<b2Body*> boxes = Stack(trial, 0.0f, 10);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        Trial::SetDensity(boxes[i], densityOf(i));
    }
    const Places places(boxes);
    const double before = trial.EnergyOfAll();
    double overlap = 0.0, maximum = before;
    trial.Run(20.0, [&](double time) {
        overlap = time > 10.0 ? Worst(trial.DeepestOverlap(), overlap) : 0.0;
        maximum = Worst(trial.EnergyOfAll(), maximum);
    });
    Judge(name + ", overlap", subSteps, 1000.0 * overlap, "mm",
          bound ? 1000.0 * Bound(subSteps, kOverlap, double(b2_polygonRadius)) : kNoBound);
    Judge(name + ", way", subSteps, places.Farthest(), "m", bound ? 0.05 : kNoBound);
    // Standing upright is as high as they can be: a boost would be seen.
    Judge(name + ", energy won", subSteps, 100.0 * (maximum / before - 1.0), "%", 0.5);
}

TEST_P(MassRatios, LetAStackBearAHeavyTop)
{
    for (const float32 ratio : kRatios)
    {
        TryStack(
            GetParam(), Named("stack, top", ratio),
            [ratio](std::size_t i) { return i == 9 ? ratio : 1.0f; },
            GetParam() > 1 || ratio < 50.0f);
    }
}

TEST_P(MassRatios, LetAStackOfHeavyAndLightBoxesStand)
{
    for (const float32 ratio : kRatios)
    {
        TryStack(
            GetParam(), Named("stack by turns", ratio),
            [ratio](std::size_t i) { return i % 2 == 1 ? ratio : 1.0f; },
            GetParam() > 1 || ratio < 5.0f);
    }
}

/// 20 links of 1 m x 0.25 m, released in a direction, and a ball of a multiple of a link's mass.
class Chain
{
public:
    static constexpr int kLinks = 20;

    Chain(int32 subSteps, float32 ratio, const b2Vec2& along) : trial(subSteps)
    {
        b2Body* last = trial.Post();
        for (int i = 0; i < kLinks; ++i)
        {
            const b2Vec2 middle = (float32(i) + 0.5f) * along;
            const bool level = along.y == 0.0f;
            b2Body* link =
                trial.Part(middle.x, middle.y, level ? 0.5f : 0.125f, level ? 0.125f : 0.5f);
            joints.push_back(trial.Hinge(last, link, float32(i) * along.x, float32(i) * along.y));
            last = link;
        }
        const b2Vec2 end = float32(kLinks) * along;
        ball = trial.Part(end.x, end.y, 0.5f, 0.5f);
        Trial::SetDensity(ball, 0.25f * ratio);
        joints.push_back(trial.Hinge(last, ball, end.x, end.y));
    }

    double WidestGap() const // [m]
    {
        double widest = 0.0;
        for (const b2Joint* joint : joints)
        {
            widest = Worst(double(Gap(joint)), widest);
        }
        return widest;
    }
    double Stretch() const // [%]
    {
        return 100.0 * (double(ball->GetPosition().Length()) / kLinks - 1.0);
    }

    Trial trial;
    std::vector<b2Joint*> joints;
    b2Body* ball;
};

TEST_P(MassRatios, KeepAHangingChainClosed)
{
    for (const float32 ratio : kRatios)
    {
        Chain chain(GetParam(), ratio, b2Vec2(0.0f, -1.0f));
        double widest = 0.0, fastest = 0.0;
        chain.trial.Run(20.0, [&](double time) {
            widest = Worst(chain.WidestGap(), widest);
            fastest = time > 10.0 ? Worst(chain.trial.FastestSpeed(), fastest) : 0.0;
        });
        const std::string name = Named("chain hangs", ratio);
        Judge(name + ", gap", GetParam(), 1000.0 * widest, "mm", Bound(GetParam(), 1.0));
        Judge(name + ", speed after 10 s", GetParam(), fastest, "m/s", Bound(GetParam(), 0.01));
    }
}

/// The history of a chain.
struct Swing
{
    double widest = 0.0, stretch = 0.0, won = 0.0, maximum = 0.0;

    void Look(const Chain& chain, double before)
    {
        widest = Worst(chain.WidestGap(), widest);
        stretch = Worst(chain.Stretch(), stretch);
        won = Worst(chain.trial.EnergyOfAll() - before, won);
        maximum = Worst(chain.trial.KineticOfAll(), maximum);
    }
    double Won() const { return 100.0 * won / maximum; } // [%]
};

/// For 10 s, as in the benchmark, and 20 s, when the ball has gone to and fro twice and the links
/// are thrown about where it turns.
TEST_P(MassRatios, KeepASwingingChainClosed)
{
    for (const float32 ratio : kRatios)
    {
        Chain chain(GetParam(), ratio, b2Vec2(1.0f, 0.0f));
        const double before = chain.trial.EnergyOfAll();
        Swing first, all;
        chain.trial.Run(20.0, [&](double time) {
            all.Look(chain, before);
            first = time <= 10.0 ? all : first;
        });
        const std::string name = Named("chain swings", ratio);
        const int32 n = GetParam();
        Judge(name + ", gap in 10 s", n, 1000.0 * first.widest, "mm", FromRecommended(n, 1.0));
        Judge(name + ", stretch in 10 s", n, first.stretch, "%", FromRecommended(n, 1.0));
        Judge(name + ", energy won in 10 s", n, first.Won(), "%", 1.0);
        Judge(name + ", gap in 20 s", n, 1000.0 * all.widest, "mm", kNoBound);
        // Where links swung faster than drifts can follow, 20 to 49 % were won here.
        Judge(name + ", energy won in 20 s", n, all.Won(), "%", 1.0);
    }
}

b2Joint* TieWithRope(Trial& trial, b2Body* a, b2Body* b)
{
    b2RopeJointDef def;
    def.bodyA = a;
    def.bodyB = b;
    def.localAnchorA.SetZero();
    def.localAnchorB.SetZero();
    def.maxLength = b2Distance(a->GetPosition(), b->GetPosition());
    return trial.Create<b2RopeJoint>(def);
}

/// From edge to edge: the blocks turn as well.
b2Joint* TieWithRod(Trial& trial, b2Body* a, b2Body* b)
{
    const b2Vec2 arm(0.2f, 0.0f);
    return trial.Rod(a, b, a->GetPosition() + arm, b->GetPosition() - arm);
}

/// A number of blocks and a ball, each tied to the next over a metre and released level. Light
/// blocks swing between ropes and rods faster than sub-steps resolve, and ropes become taut
/// suddenly.
template <class Tie>
void TryTied(int32 subSteps, const std::string& name, int32 blocks, float32 ratio, const Tie& tie)
{
    Trial trial(subSteps);
    b2Body* last = trial.Post();
    for (int32 i = 1; i <= blocks + 1; ++i)
    {
        b2Body* next = trial.Part(float32(i), 0.0f, 0.2f, 0.2f);
        tie(trial, last, next);
        last = next;
    }
    Trial::SetDensity(last, ratio);
    const double before = trial.EnergyOfAll();
    double farthest = 0.0, won = 0.0, maximum = 0.0;
    trial.Run(10.0, [&](double) {
        farthest = Worst(double(last->GetPosition().Length()), farthest);
        won = Worst(trial.EnergyOfAll() - before, won);
        maximum = Worst(trial.KineticOfAll(), maximum);
    });
    const std::string all = Named((std::to_string(blocks + 1) + " " + name).c_str(), ratio);
    const double length = double(blocks + 1);
    Judge(all + ", stretch", subSteps, 100.0 * (farthest / length - 1.0), "%",
          Bound(subSteps, 2.0));
    Judge(all + ", energy won", subSteps, 100.0 * won / maximum, "%", 2.0);
}

TEST_P(MassRatios, LetRopesAndRodsHoldAHeavyBall)
{
    for (const int32 blocks : {5, 10, 20})
    {
        for (const float32 ratio : {100.0f, 1000.0f})
        {
            TryTied(GetParam(), "ropes", blocks, ratio, TieWithRope);
            TryTied(GetParam(), "rods", blocks, ratio, TieWithRod);
        }
    }
}

/// Slim blocks and a ball, tied by short rods and released above the anchor: the ball tears at
/// links that point in all directions.
TEST_P(MassRatios, LetRodsHoldABallThatFallsFromAbove)
{
    for (const int32 blocks : {6, 11, 21})
    {
        for (const float32 angle : {2.0f, 2.6f}) // from below
        {
            Trial trial(GetParam());
            const b2Vec2 along = b2Mul(b2Rot(angle), b2Vec2(0.0f, -1.0f));
            b2Body* last = trial.Post();
            b2Vec2 end(0.0f, 0.0f);
            std::vector<b2Joint*> rods;
            for (int32 i = 0; i <= blocks; ++i)
            {
                const b2Vec2 start = end + 0.2f * along;
                end = start + 0.4f * along;
                const b2Vec2 middle = 0.5f * (start + end);
                b2Body* next = trial.Part(middle.x, middle.y, 0.05f, 0.2f);
                next->SetTransform(middle, angle);
                rods.push_back(trial.Rod(last, next, start - 0.2f * along, start));
                last = next;
            }
            Trial::SetDensity(last, 1000.0f);
            const double before = trial.EnergyOfAll();
            double widest = 0.0, won = 0.0, maximum = 0.0;
            trial.Run(10.0, [&](double) {
                for (const b2Joint* rod : rods)
                {
                    const double length = b2Distance(rod->GetAnchorA(), rod->GetAnchorB());
                    widest = Worst(std::abs(length - 0.2), widest);
                }
                won = Worst(trial.EnergyOfAll() - before, won);
                maximum = Worst(trial.KineticOfAll(), maximum);
            });
            const std::string name = std::to_string(blocks + 1) + " rods from " +
                                     std::to_string(int32(angle * 180.0f / b2_pi)) + " degrees";
            Judge(name + ", gap", GetParam(), widest, "m", Bound(GetParam(), 0.1));
            Judge(name + ", energy won", GetParam(), 100.0 * won / maximum, "%",
                  Bound(GetParam(), 2.0));
        }
    }
}

/// Hinges that turn by so much and no more: where they stop, they carry.
TEST_P(MassRatios, KeepASwingingChainWithLimitsClosed)
{
    for (const float32 angle : {0.3f, 1.0f})
    {
        Chain chain(GetParam(), 1000.0f, b2Vec2(1.0f, 0.0f));
        for (std::size_t i = 1; i < chain.joints.size(); ++i)
        {
            auto* hinge = static_cast<b2RevoluteJoint*>(chain.joints[i]);
            hinge->SetLimits(-angle, angle);
            hinge->EnableLimit(true);
        }
        const double before = chain.trial.EnergyOfAll();
        Swing swing;
        chain.trial.Run(10.0, [&](double) { swing.Look(chain, before); });
        const std::string name = Named("chain with limits", 1000.0f);
        Judge(name + ", stretch", GetParam(), swing.stretch, "%", Bound(GetParam(), 1.0));
        Judge(name + ", energy won", GetParam(), swing.Won(), "%", 2.0);
    }
}

} // namespace
