// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <scenes/Scene.h>

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// The settings of the solver that may change during a run, in one table. Scripts, panels, sessions
/// and the file of the window's settings all read it.
namespace boxreel
{

/// The settings of the world's solver.
struct SolverChoices
{
    int velocityIterations = 8;
    int positionIterations = 3;
    int subSteps = 1;
    int hertz = 60; ///< constant during a run, so not in the table
    bool sleep = true;
    bool warmStarting = true;
    bool continuous = true;
    bool subStepping = false; ///< one time of impact a step
    friend bool operator==(const SolverChoices&, const SolverChoices&) = default;
};

struct SolverSetting
{
    const char* name;  ///< in scripts
    const char* label; ///< on the panel, and with small letters in the file of the window
    std::variant<int SolverChoices::*, bool SolverChoices::*> member;
    int maximum;       ///< of a number, whose minimum is 1
    int sliderMaximum; ///< on the panel
    int (*get)(const b2World& world, const StepSettings& steps);
    void (*set)(int value, b2World& world, StepSettings& steps);
};

/// Returns the table: numbers, then what is on (1) or off (0), in the order of the panel.
std::span<const SolverSetting> SolverSettings();

/// Returns the value (on 1, off 0). Error: unknown setting or value.
Result<int> ParseSetting(const std::string& name, const std::string& text);

/// Returns the value as a script has it: "on", "off" or a number.
std::string SettingText(const std::string& name, int value);

/// Applies a value that ParseSetting returned.
void ApplySetting(const std::string& name, int value, b2World& world, StepSettings& steps);

/// Reads the settings of the table; the rate stays as it is.
void ReadSettings(SolverChoices& solver, const b2World& world, const StepSettings& steps);

/// Applies the settings of the table.
void ApplySettings(const SolverChoices& solver, b2World& world, StepSettings& steps);

/// Returns the names and new values of the settings that differ, as in scripts: {"sleep", "off"}.
std::vector<std::pair<std::string, std::string>> Differences(const SolverChoices& before,
                                                             const SolverChoices& after);

} // namespace boxreel
