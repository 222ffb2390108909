// SPDX-License-Identifier: MIT
#include "References.h"

#include <cmath>

namespace bench
{
namespace
{

constexpr Real kTwoPi = 6.283185307179586476925286766559L;

/// In equal steps no longer than `step`.
template <std::size_t N, typename Derivative>
std::array<Real, N> Integrate(std::array<Real, N> state, Real time, Real step, Derivative f)
{
    const long count = std::lround(std::ceil(time / step - 1e-9L));
    for (long i = 0; i < count; ++i)
    {
        state = RungeKutta4(state, time / Real(count), f);
    }
    return state;
}

} // namespace

RealPoint ProjectilePosition(Real vx, Real vy, Real gravity, Real time)
{
    return RealPoint{vx * time, vy * time - gravity * time * time / 2};
}

Real SlideDistance(Real gravity, Real slope, Real friction, Real time)
{
    return gravity * (std::sin(slope) - friction * std::cos(slope)) * time * time / 2;
}

Real ApexHeight(Real height, Real restitution, int impacts)
{
    return height * std::pow(restitution, Real(2 * impacts));
}

Real Rod::InertiaAboutCenter() const
{
    return mass * (length * length + thickness * thickness) / 12;
}

Real Rod::InertiaAboutEnd() const
{
    return InertiaAboutCenter() + mass * length * length / 4;
}

RodPendulum::State RodPendulum::After(State state, Real time, Real step) const
{
    // J a = - m g l/2 cos(theta), J about the fixed end
    const Real pull = m_rod.mass * m_gravity * m_rod.length / (2 * m_rod.InertiaAboutEnd());
    return Integrate(state, time, step, [pull](const State& s) {
        return State{s[1], -pull * std::cos(s[0])};
    });
}

Real RodPendulum::Energy(const State& state) const
{
    return m_rod.InertiaAboutEnd() * state[1] * state[1] / 2 +
           m_rod.mass * m_gravity * m_rod.length / 2 * std::sin(state[0]);
}

Real RodPendulum::PeriodOfSmallSwings() const
{
    return kTwoPi *
           std::sqrt(2 * m_rod.InertiaAboutEnd() / (m_rod.mass * m_gravity * m_rod.length));
}

// With D = theta1 - theta2, J about an end, the second rod carried by the first:
//   T = A/2 w1^2 + B/2 w2^2 + C cos(D) w1 w2,   A = J + m l^2,  B = J,  C = m l^2 / 2
//   V = m g l (3/2 sin(theta1) + 1/2 sin(theta2))
// Lagrange's equations:
//   A a1 + C cos(D) a2 = - C sin(D) w2^2 - 3/2 m g l cos(theta1)
//   C cos(D) a1 + B a2 =   C sin(D) w1^2 - 1/2 m g l cos(theta2)
DoublePendulum::State DoublePendulum::Derivative(const State& s) const
{
    const Real ml = m_rod.mass * m_rod.length;
    const Real A = m_rod.InertiaAboutEnd() + ml * m_rod.length;
    const Real B = m_rod.InertiaAboutEnd();
    const Real C = ml * m_rod.length / 2;
    const Real coupling = C * std::cos(s[0] - s[1]);
    const Real swirl = C * std::sin(s[0] - s[1]);
    const Real pull1 = -swirl * s[3] * s[3] - 1.5L * ml * m_gravity * std::cos(s[0]);
    const Real pull2 = swirl * s[2] * s[2] - 0.5L * ml * m_gravity * std::cos(s[1]);
    const Real determinant = A * B - coupling * coupling;
    return State{s[2], s[3], (B * pull1 - coupling * pull2) / determinant,
                 (A * pull2 - coupling * pull1) / determinant};
}

DoublePendulum::State DoublePendulum::After(State state, Real time, Real step) const
{
    return Integrate(state, time, step, [this](const State& s) { return Derivative(s); });
}

Real DoublePendulum::Energy(const State& s) const
{
    // From the motion of the two centres, not from the Lagrangian above: each checks the other.
    const Real l = m_rod.length;
    const auto square = [](Real vx, Real vy) { return vx * vx + vy * vy; };
    const Real elbowX = -l * std::sin(s[0]) * s[2], elbowY = l * std::cos(s[0]) * s[2];
    const Real first = square(elbowX / 2, elbowY / 2);
    const Real second =
        square(elbowX - l / 2 * std::sin(s[1]) * s[3], elbowY + l / 2 * std::cos(s[1]) * s[3]);
    const Real spin = m_rod.InertiaAboutCenter() * (s[2] * s[2] + s[3] * s[3]) / 2;
    const Real height = 1.5L * l * std::sin(s[0]) + l / 2 * std::sin(s[1]);
    return m_rod.mass * (first + second) / 2 + spin + m_rod.mass * m_gravity * height;
}

RealPoint DoublePendulum::Tip(const State& s) const
{
    return RealPoint{m_rod.length * (std::cos(s[0]) + std::cos(s[1])),
                     m_rod.length * (std::sin(s[0]) + std::sin(s[1]))};
}

} // namespace bench
