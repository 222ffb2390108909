// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <scenes/Scene.h>

#include <string>

/// Settings of the solver that may change while a scene goes on, by the names that scripts have for
/// them: velocity-iterations, position-iterations, sub-steps; sleep, warm-starting, continuous and
/// sub-stepping, which are on or off.
namespace boxreel
{

/// The number that `text` stands for, 1 for on and 0 for off. Unusable: no such setting, with the
/// nearest; no such value, with those that there are.
Result<int> ParseSetting(const std::string& name, const std::string& text);

/// What ParseSetting accepted.
void ApplySetting(const std::string& name, int value, b2World& world, StepSettings& steps);

} // namespace boxreel
