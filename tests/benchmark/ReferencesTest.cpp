// SPDX-License-Identifier: MIT
#include "References.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bench
{
namespace
{

constexpr Real kPi = 3.141592653589793238462643383280L;
constexpr Real kGravity = 10;
constexpr Real kStep = 1.0L / 9600; // that the cases use
const Rod kRod;

Real Distance(const RealPoint& a, const RealPoint& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(References, EqualIntegrationOfTheProjectile)
{
    // A parabola is of second order, so one step of the method is exact.
    std::array<Real, 4> state{0, 0, 10, 20};
    state = RungeKutta4(state, 2.0L, [](const std::array<Real, 4>& s) {
        return std::array<Real, 4>{s[2], s[3], 0, -kGravity};
    });
    EXPECT_LT(Distance(ProjectilePosition(10, 20, kGravity, 2), {state[0], state[1]}), 1e-15L);
}

TEST(References, EqualIntegrationOfTheSlide)
{
    const Real slope = kPi / 6, friction = 0.3L;
    std::array<Real, 2> state{0, 0};
    for (int i = 0; i < 2000; ++i)
    {
        state = RungeKutta4(state, 0.001L, [&](const std::array<Real, 2>& s) {
            const Real normal = kGravity * std::cos(slope);
            return std::array<Real, 2>{s[1], kGravity * std::sin(slope) - friction * normal};
        });
    }
    EXPECT_LT(std::abs(SlideDistance(kGravity, slope, friction, 2) - state[0]), 1e-14L);
}

/// Free fall in short steps. The step before an impact lasts for the time that is left.
Real HighestAfter(Real height, Real restitution, int impacts)
{
    const auto fall = [](const std::array<Real, 2>& s) {
        return std::array<Real, 2>{s[1], -kGravity};
    };
    std::array<Real, 2> state{height, 0};
    for (Real highest = 0;;)
    {
        const Real hit =
            (state[1] + std::sqrt(state[1] * state[1] + 2 * kGravity * state[0])) / kGravity;
        if (hit <= 1e-3L && impacts > 0)
        {
            state = {0, -restitution * RungeKutta4(state, hit, fall)[1]};
            --impacts;
        }
        state = RungeKutta4(state, 1e-3L, fall);
        highest = std::max(highest, impacts > 0 ? 0 : state[0]);
        if (impacts == 0 && state[1] < 0)
        {
            return highest;
        }
    }
}

TEST(References, EqualApexesOfABouncingBall)
{
    const Real kBetweenLooks = kGravity * 1e-6L / 8; // an apex between two looks
    EXPECT_NEAR(double(ApexHeight(10, 1, 3)), 10.0, 1e-14);
    EXPECT_NEAR(double(ApexHeight(10, 0.5L, 2)), double(HighestAfter(10, 0.5L, 2)),
                double(kBetweenLooks));
    EXPECT_NEAR(double(ApexHeight(10, 0.8L, 3)), double(HighestAfter(10, 0.8L, 3)),
                double(kBetweenLooks));
}

TEST(References, KeepEnergyOfASinglePendulum)
{
    const RodPendulum pendulum(kRod, kGravity);
    RodPendulum::State state{0, 0};
    for (int i = 0; i < 100; ++i)
    {
        state = pendulum.After(state, 0.1L, kStep);
        EXPECT_LT(std::abs(pendulum.Energy(state)), 1e-12L);
    }
    EXPECT_GT(std::abs(state[0]), 0.1L) << "it has to have moved";
}

TEST(References, EqualClosedFormPeriodOfSmallSwings)
{
    const RodPendulum pendulum(kRod, kGravity);
    const Real amplitude = 1e-4L;
    const RodPendulum::State start{-kPi / 2 + amplitude, 0};
    const Real period = pendulum.PeriodOfSmallSwings();
    const RodPendulum::State quarter = pendulum.After(start, period / 4, kStep);
    const RodPendulum::State whole = pendulum.After(start, period, kStep);
    // A swing of finite size is longer by amplitude^2 / 16 of itself.
    EXPECT_LT(std::abs(quarter[0] + kPi / 2), amplitude * amplitude * amplitude);
    EXPECT_LT(std::abs(whole[0] - start[0]), amplitude * amplitude * amplitude);
    // A thin rod of length l: 2 pi sqrt(2 l / (3 g)).
    const RodPendulum thin(Rod{1, 0, 1}, kGravity);
    EXPECT_NEAR(double(thin.PeriodOfSmallSwings()), double(2 * kPi * std::sqrt(2 / (3 * kGravity))),
                1e-15);
}

TEST(References, KeepEnergyOfADoublePendulum)
{
    const DoublePendulum pendulum(kRod, kGravity);
    DoublePendulum::State state{0, 0, 0, 0};
    for (int i = 0; i < 20; ++i)
    {
        state = pendulum.After(state, 0.1L, kStep);
        EXPECT_LT(std::abs(pendulum.Energy(state)), 1e-12L);
    }
    EXPECT_GT(std::abs(state[0] - state[1]), 0.1L) << "the rods have to have parted";
}

TEST(References, SatisfyNewtonsLawsForADoublePendulum)
{
    // Newton's laws for both rods, without Lagrange. The accelerations give the forces in the
    // joints. These must cause the rotation of each rod about its own centre.
    const DoublePendulum pendulum(kRod, kGravity);
    const DoublePendulum::State s{0.3L, -0.9L, 1.7L, -2.1L};
    const Real h = 1e-5L;
    const DoublePendulum::State before = pendulum.After({s[0], s[1], -s[2], -s[3]}, h, h);
    const DoublePendulum::State after = pendulum.After(s, h, h);
    const Real a1 = (after[2] + before[2]) / (2 * h), a2 = (after[3] + before[3]) / (2 * h);
    const Real l = kRod.length, m = kRod.mass;
    // The acceleration of a rotating point: e = (cos, sin) times -w^2, and its normal times a.
    const auto ax = [](Real angle, Real w, Real a) {
        return -w * w * std::cos(angle) - a * std::sin(angle);
    };
    const auto ay = [](Real angle, Real w, Real a) {
        return -w * w * std::sin(angle) + a * std::cos(angle);
    };
    const Real x1 = l / 2 * ax(s[0], s[2], a1), y1 = l / 2 * ay(s[0], s[2], a1);
    const Real x2 = 2 * x1 + l / 2 * ax(s[1], s[3], a2), y2 = 2 * y1 + l / 2 * ay(s[1], s[3], a2);
    const Real elbowX = m * x2, elbowY = m * (y2 + kGravity); // on the second rod
    const Real pivotX = m * x1 + elbowX, pivotY = m * (y1 + kGravity) + elbowY;
    const auto torque = [l](Real angle, Real fx, Real fy) {
        return l / 2 * (std::cos(angle) * fy - std::sin(angle) * fx);
    };
    const Real inertia = kRod.InertiaAboutCenter();
    EXPECT_LT(std::abs(inertia * a2 + torque(s[1], elbowX, elbowY)), 1e-7L);
    EXPECT_LT(std::abs(inertia * a1 + torque(s[0], pivotX + elbowX, pivotY + elbowY)), 1e-7L);
}

TEST(References, DoNotChangeWhenTheStepIsHalved)
{
    const DoublePendulum pendulum(kRod, kGravity);
    const DoublePendulum::State coarse = pendulum.After({0, 0, 0, 0}, 2, kStep);
    const DoublePendulum::State fine = pendulum.After({0, 0, 0, 0}, 2, kStep / 2);
    EXPECT_LT(Distance(pendulum.Tip(coarse), pendulum.Tip(fine)), 1e-10L);
}

TEST(References, ConvergeWithFourthOrder)
{
    const DoublePendulum pendulum(kRod, kGravity);
    const auto tip = [&](Real step) { return pendulum.Tip(pendulum.After({0, 0, 0, 0}, 1, step)); };
    const RealPoint exact = tip(kStep);
    const Real ratio = Distance(tip(1.0L / 200), exact) / Distance(tip(1.0L / 400), exact);
    EXPECT_GT(std::log2(ratio), 3.8L);
    EXPECT_LT(std::log2(ratio), 4.2L);
}

} // namespace
} // namespace bench
