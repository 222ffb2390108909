// SPDX-License-Identifier: MIT
#pragma once

#include "Accuracy.h"

#include <cmath>

/// Helpers of several accuracy cases: they add a body in one line, and make a case of an
/// Experiment. Separate from Sim.h, because the timed scenes do not need them.
namespace bench
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kGravity = 10.0; ///< that pulls down, unless a case says otherwise [m/s^2]

inline BodyId AddStaticBody(Sim& sim)
{
    BodySpec spec;
    spec.kind = Kind::Static;
    return sim.AddBody(spec);
}

/// A body that moves, at rest.
inline BodyId AddBodyAt(Sim& sim, double x, double y, double angle = 0.0)
{
    BodySpec spec;
    spec.x = x;
    spec.y = y;
    spec.angle = angle;
    return sim.AddBody(spec);
}

struct Place
{
    double x = 0.0, y = 0.0;
};

/// Returns the world position of a body's own point.
inline Place WorldPoint(const BodyState& s, double x, double y)
{
    return Place{s.x + std::cos(s.angle) * x - std::sin(s.angle) * y,
                 s.y + std::sin(s.angle) * x + std::cos(s.angle) * y};
}

inline double Distance(const Place& a, const Place& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// Keeps NaN, which std::max may lose.
inline double Worst(double a, double b)
{
    return a > b || std::isnan(a) ? a : b;
}

/// A case whose experiment is constructed from the given arguments, once for each run.
template <typename Kind, typename... Arguments>
AccuracyCase MakeCase(const char* name, const char* what, const char* unit, double seconds,
                      Arguments... arguments)
{
    const auto make = [=] { return std::make_unique<Kind>(arguments...); };
    return AccuracyCase{name, what, unit, seconds, -kGravity, make};
}

/// The same without gravity.
inline AccuracyCase Weightless(AccuracyCase result)
{
    result.gravity = 0.0;
    return result;
}

} // namespace bench
