// SPDX-License-Identifier: MIT
#pragma once

#include "RandomWorlds.h"

#include <iosfwd>
#include <string>

/// Lets a random world run, and says what went wrong in it.
namespace stability
{

/// Energy above the input, as a fraction of it. Two errors are allowed for: half a step of
/// gravity's work, h m g.v / 2, which symplectic integration is off by, and a limit or contact that
/// is one slop too deep. Both are below a thousandth of the energy of these worlds. A world that
/// diverges gains more in a step.
inline constexpr double kMaxExcess = 0.01;

/// Maximum distance of a shape outside the walls [m]; its centre never is outside. In the worlds 0
/// to 99 it is at most 0.44, for long bodies that something heavy presses against a wall. Others
/// have reached 0.97.
inline constexpr double kMaxOut = 1.0;

/// The worst of a run.
struct Trial
{
    double excess = 0.0;       ///< of energy above what was put in, as a share of that
    float32 excessTime = 0.0f; ///< [s]
    double out = 0.0;          ///< of any shape beyond the walls [m]
    float32 outTime = 0.0f;    ///< [s]
    int outBody = -1;
    double centreOut = -1e9; ///< of a centre beyond the walls [m]; negative within
    bool finite = true;
};

/// With a time line, when there is one to print to.
Trial RunWorld(const WorldPlan& plan, std::ostream* timeLine = nullptr);

/// Why a trial fails, as a sentence; empty when it does not.
std::string WhyFailed(const Trial& trial);

/// Takes out bodies and joints for as long as it still fails.
WorldPlan Reduced(WorldPlan plan);

} // namespace stability
