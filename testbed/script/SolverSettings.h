// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <scenes/Scene.h>

#include <string>

/// Solver settings that may change during a run, with their names in scripts: velocity-iterations,
/// position-iterations and sub-steps; sleep, warm-starting, continuous and sub-stepping, which are
/// on or off.
namespace boxreel
{

/// Returns the value (on 1, off 0). Error: unknown setting or value.
Result<int> ParseSetting(const std::string& name, const std::string& text);

/// Returns the value as a script has it: "on", "off" or a number.
std::string SettingText(const std::string& name, int value);

/// Applies a value that ParseSetting returned.
void ApplySetting(const std::string& name, int value, b2World& world, StepSettings& steps);

} // namespace boxreel
