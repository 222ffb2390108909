// SPDX-License-Identifier: MIT
#include "Trial.h"

#include <algorithm>

/// Chains that swing against obstacles. Links are thrown, stopped within a step, pressed against
/// static bodies by the load below, and pushed out again. Their joints must stay closed.
namespace
{

using namespace stability;

STABILITY_SUITE(ChainImpact);

/// A link may open for a frame, by an amount that is hardly visible.
constexpr double kHardlyOpen = 0.02; // [m]
constexpr double kOpenAfterwards = 1e-3;
/// Under the weight of a thousand links, which tears links open and keeps tearing.
constexpr double kTornOpen = 0.3;
constexpr double kTornOpenAfterwards = 0.03;

/// 20 links of 1 m and a ball of 1 m radius, let go from level.
class Chain
{
public:
    Chain(int32 subSteps, float32 ratio) : trial(subSteps)
    {
        b2Body* last = trial.Post();
        for (int i = 0; i < 20; ++i)
        {
            b2Body* link = trial.Load(float32(i) + 0.5f, 0.0f, 0.5f, 0.125f);
            bodies.push_back(link);
            joints.push_back(trial.Hinge(last, link, float32(i), 0.0f));
            last = link;
        }
        b2Body* ball = trial.Body(b2_dynamicBody, 20.0f, 0.0f);
        b2CircleShape round;
        round.m_radius = 1.0f;
        ball->CreateFixture(&round, ratio * 0.25f / b2_pi)->SetFriction(0.6f);
        bodies.push_back(ball);
        joints.push_back(trial.Hinge(last, ball, 20.0f, 0.0f));
    }

    void AddPost(float32 x, float32 y)
    {
        b2CircleShape round;
        round.m_radius = 1.0f;
        trial.Body(b2_staticBody, x, y)->CreateFixture(&round, 0.0f)->SetFriction(0.6f);
    }
    void AddGround(float32 y)
    {
        b2EdgeShape edge;
        edge.Set(b2Vec2(-50.0f, y), b2Vec2(50.0f, y));
        trial.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&edge, 0.0f)->SetFriction(0.6f);
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

    Trial trial;
    std::vector<b2Body*> bodies;
    std::vector<b2Joint*> joints;
};

struct Outcome
{
    double widest = 0.0; ///< gap [m]
    double left = 0.0;   ///< the same after 10 s [m]
    double won = 0.0;    ///< energy, as a part of the greatest kinetic energy
};

Outcome SwingFor10Seconds(Chain& chain)
{
    Outcome found;
    const double before = chain.trial.EnergyOfAll();
    double won = 0.0, maximum = 0.0;
    chain.trial.Run(10.0, [&](double time) {
        found.left = time > 9.9 ? Worst(chain.WidestGap(), found.left) : 0.0;
        found.widest = Worst(chain.WidestGap(), found.widest);
        won = Worst(chain.trial.EnergyOfAll() - before, won);
        maximum = Worst(chain.trial.KineticOfAll(), maximum);
    });
    found.won = won / maximum;
    return found;
}

/// The worst of three, or the median for what is left after 10 s: how far a whipped chain is torn
/// then changes with the bits.
Outcome OfThree(const Outcome (&found)[3])
{
    Outcome worst;
    for (const Outcome& one : found)
    {
        worst.widest = Worst(one.widest, worst.widest);
        worst.won = Worst(one.won, worst.won);
    }
    const double a = found[0].left, b = found[1].left, c = found[2].left;
    worst.left = std::max(std::min(a, b), std::min(std::max(a, b), c));
    return worst;
}

/// Tries chains of each weight against the obstacle of `add`, which is 2 cm elsewhere each time.
template <class Add>
void TryChains(int32 n, const std::string& against, const Add& add)
{
    for (const float32 ratio : {1.0f, 10.0f, 100.0f, 1000.0f})
    {
        Outcome found[3];
        for (int32 i = 0; i < 3; ++i)
        {
            Chain chain(n, ratio);
            add(chain, 0.02f * float32(i));
            found[i] = SwingFor10Seconds(chain);
        }
        const std::string name = "chain against " + against + ", " + std::to_string(int(ratio));
        const Outcome worst = OfThree(found);
        const bool torn = ratio > 100.0f;
        Judge(name + ":1, gap", n, worst.widest, "m", Bound(n, torn ? kTornOpen : kHardlyOpen));
        Judge(name + ":1, gap after 10 s", n, worst.left, "m",
              Bound(n, torn ? kTornOpenAfterwards : kOpenAfterwards));
        Judge(name + ":1, energy won", n, 100.0 * worst.won, "%", Bound(n, 1.0));
    }
}

TEST_P(ChainImpact, KeepsTheChainTogetherOnAPostBelowIt)
{
    TryChains(GetParam(), "a post",
              [](Chain& chain, float32 shift) { chain.AddPost(6.0f + shift, -1.2f); });
}

TEST_P(ChainImpact, KeepsTheChainTogetherOnAPostBelowTheAnchor)
{
    TryChains(GetParam(), "a low post",
              [](Chain& chain, float32 shift) { chain.AddPost(shift, -10.0f); });
}

TEST_P(ChainImpact, KeepsTheChainTogetherOnTheGround)
{
    TryChains(GetParam(), "the ground",
              [](Chain& chain, float32 shift) { chain.AddGround(-15.0f - shift); });
}

/// The ball touches the last link but one. Its end would have to be nearer than the ball's radius
/// to resolve the overlap of their skins, so pushes rotate the links between again and again.
TEST_P(ChainImpact, StaysTogetherWhenAnOverlapCannotBeResolved)
{
    Chain chain(GetParam(), 10.0f);
    double widest = 0.0;
    chain.trial.Run(1.0, [&](double) { widest = Worst(chain.WidestGap(), widest); });
    Judge("chain pushed without a way out, gap", GetParam(), widest, "m",
          Bound(GetParam(), kOpenAfterwards));
}

/// In the frame in which the first of them is stopped by a thin wall the second flies on.
TEST_P(ChainImpact, PullsABodyBackToTheOneThatAWallStopped)
{
    for (const float32 ratio : {1.0f, 10.0f, 100.0f})
    {
        Trial trial(GetParam(), b2Vec2_zero);
        b2EdgeShape edge;
        edge.Set(b2Vec2(5.0f, -5.0f), b2Vec2(5.0f, 5.0f));
        b2Body* wall = trial.Body(b2_staticBody, 0.0f, 0.0f);
        wall->CreateFixture(&edge, 0.0f);
        b2Body* first = trial.Load(0.0f, 0.0f, 0.5f, 0.125f);
        b2Body* second = trial.Load(-1.0f, 0.0f, 0.5f, 0.125f);
        Trial::SetDensity(second, ratio * first->GetFixtureList()->GetDensity());
        const b2Joint* joint = trial.Hinge(first, second, -0.5f, 0.0f);
        first->SetLinearVelocity(b2Vec2(40.0f, 0.0f));
        second->SetLinearVelocity(b2Vec2(40.0f, 0.0f));
        const double before = trial.KineticOfAll();
        double widest = 0.0, maximum = before, through = 0.0;
        trial.Run(2.0, [&](double) {
            widest = Worst(double(Gap(joint)), widest);
            maximum = Worst(trial.KineticOfAll(), maximum);
            through = Worst(double(first->GetPosition().x) - 5.0, through);
        });
        const std::string name = "pair thrown at a wall, " + std::to_string(int(ratio)) + ":1";
        Judge(name + ", gap", GetParam(), widest, "m", Bound(GetParam(), kHardlyOpen));
        Judge(name + ", energy won", GetParam(), 100.0 * (maximum / before - 1.0), "%",
              Bound(GetParam(), 0.5));
        Judge(name + ", centre beyond the wall", GetParam(), through, "m", 0.0);
    }
}

} // namespace
