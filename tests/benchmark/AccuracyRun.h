// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The commands for accuracy of an engine's program: each runs to its end and returns the program's
/// exit code. Called by Main.cpp only.
namespace bench
{

/// Prints one line of JSON per case: name, description, the unit of its error, and the maximum
/// number of sub-steps of this engine.
int ListAccuracy();

/// Runs a case, first with a look after each step, then again, as often as the clock needs,
/// without: only that is timed. `numbers`: velocity iterations, position iterations, steps a
/// second, sub-steps, and perhaps how many steps are to be timed only. Prints one line of JSON.
int RunAccuracy(const std::string& name, const std::vector<std::string>& numbers);

} // namespace bench
