// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

/// The exact results of the accuracy benchmark's cases. Closed forms where they exist. Otherwise
/// the Runge-Kutta method of fourth order in long double, with steps so small that halving them
/// changes nothing that the cases measure. Metres, seconds, radians, kilograms; y points up.
/// Independent of engines.
namespace bench
{

using Real = long double;

struct RealPoint
{
    Real x = 0, y = 0;
};

/// Thrown from the origin; `gravity` is what pulls down, above 0 [m/s^2].
RealPoint ProjectilePosition(Real vx, Real vy, Real gravity, Real time);

/// Returns the distance that a body slides down from rest, at a slope so steep that it slides [m].
Real SlideDistance(Real gravity, Real slope, Real friction, Real time);

/// Returns the apex of a bounce from `height` after this many impacts [m].
Real ApexHeight(Real height, Real restitution, int impacts);

/// One step of size h for y' = f(y).
template <std::size_t N, typename Derivative>
std::array<Real, N> RungeKutta4(const std::array<Real, N>& y, Real h, Derivative f)
{
    const auto moved = [&y](const std::array<Real, N>& k, Real by) {
        std::array<Real, N> result = y;
        for (std::size_t i = 0; i < N; ++i)
        {
            result[i] += by * k[i];
        }
        return result;
    };
    const std::array<Real, N> k1 = f(y);
    const std::array<Real, N> k2 = f(moved(k1, h / 2));
    const std::array<Real, N> k3 = f(moved(k2, h / 2));
    const std::array<Real, N> k4 = f(moved(k3, h));
    std::array<Real, N> result = y;
    for (std::size_t i = 0; i < N; ++i)
    {
        result[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return result;
}

/// A rectangle that hangs by the middle of one short side.
struct Rod
{
    Real length = 1;
    Real thickness = 0.1L;
    Real mass = 1;

    Real InertiaAboutCenter() const;
    Real InertiaAboutEnd() const;
};

/// One rod from a fixed point. State: its angle from the x axis and its angular velocity.
class RodPendulum
{
public:
    using State = std::array<Real, 2>;

    RodPendulum(const Rod& rod, Real gravity) : m_rod(rod), m_gravity(gravity) {}

    State After(State state, Real time, Real step) const;
    /// 0 when it rests, level [J].
    Real Energy(const State& state) const;
    /// Returns the period of oscillations so small that their amplitude does not matter [s].
    Real PeriodOfSmallSwings() const;

private:
    Rod m_rod;
    Real m_gravity;
};

/// Two equal rods, the second hanging from the end of the first. State: the angles from the x axis,
/// then the angular velocities.
class DoublePendulum
{
public:
    using State = std::array<Real, 4>;

    DoublePendulum(const Rod& rod, Real gravity) : m_rod(rod), m_gravity(gravity) {}

    State After(State state, Real time, Real step) const;
    /// 0 when both rest, level [J].
    Real Energy(const State& state) const;
    /// The free end, from the fixed point.
    RealPoint Tip(const State& state) const;

private:
    State Derivative(const State& state) const;

    Rod m_rod;
    Real m_gravity;
};

} // namespace bench
