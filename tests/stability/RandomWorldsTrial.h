// SPDX-License-Identifier: MIT
#pragma once

#include "RandomWorlds.h"

#include <iosfwd>
#include <string>

/// Lets a random world run, and says what went wrong in it.
namespace stability
{

/// Energy above what was put in, as a share of it. Half a step of gravity's work, h m g.v / 2, is
/// not yet where one step of symplectic integration says, and a limit or a contact may be a slop
/// too deep; both are below a thousandth of what these worlds hold. What bursts gains more in a
/// step.
inline constexpr double kMaxExcess = 0.01;

/// What may stick out of the walls [m], though its centre never does: 0.44 at most in the worlds 0
/// to 99, of long bodies that something heavy presses against a wall; 0.97 has been seen in others.
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
