// SPDX-License-Identifier: MIT
#include "SolverSettings.h"

#include <base/Nearest.h>
#include <base/Quoting.h>
#include <options/Values.h>

#include <algorithm>
#include <iterator>

namespace boxreel
{
namespace
{

constexpr SolverSetting kSettings[] = {
    {"velocity-iterations", "Velocity iterations", &SolverChoices::velocityIterations, 1000, 50,
     [](const b2World&, const StepSettings& steps) { return int(steps.velocityIterations); },
     [](int value, b2World&, StepSettings& steps) { steps.velocityIterations = value; }},
    {"position-iterations", "Position iterations", &SolverChoices::positionIterations, 1000, 50,
     [](const b2World&, const StepSettings& steps) { return int(steps.positionIterations); },
     [](int value, b2World&, StepSettings& steps) { steps.positionIterations = value; }},
    {"sub-steps", "Sub-steps", &SolverChoices::subSteps, 64, 64,
     [](const b2World& world, const StepSettings&) { return int(world.GetSubStepCount()); },
     [](int value, b2World& world, StepSettings&) { world.SetSubStepCount(value); }},
    {"sleep", "Sleep", &SolverChoices::sleep, 1, 1,
     [](const b2World& world, const StepSettings&) { return int(world.GetAllowSleeping()); },
     [](int value, b2World& world, StepSettings&) { world.SetAllowSleeping(value != 0); }},
    {"warm-starting", "Warm starting", &SolverChoices::warmStarting, 1, 1,
     [](const b2World& world, const StepSettings&) { return int(world.GetWarmStarting()); },
     [](int value, b2World& world, StepSettings&) { world.SetWarmStarting(value != 0); }},
    {"continuous", "Continuous", &SolverChoices::continuous, 1, 1,
     [](const b2World& world, const StepSettings&) { return int(world.GetContinuousPhysics()); },
     [](int value, b2World& world, StepSettings&) { world.SetContinuousPhysics(value != 0); }},
    {"sub-stepping", "Sub-stepping", &SolverChoices::subStepping, 1, 1,
     [](const b2World& world, const StepSettings&) { return int(world.GetSubStepping()); },
     [](int value, b2World& world, StepSettings&) { world.SetSubStepping(value != 0); }},
};

const SolverSetting* Find(const std::string& name)
{
    const auto found =
        std::find_if(std::begin(kSettings), std::end(kSettings),
                     [&](const SolverSetting& setting) { return name == setting.name; });
    return found == std::end(kSettings) ? nullptr : found;
}

bool IsFlag(const SolverSetting& setting)
{
    return std::holds_alternative<bool SolverChoices::*>(setting.member);
}

int ValueOf(const SolverSetting& setting, const SolverChoices& solver)
{
    return std::visit([&](auto member) { return int(solver.*member); }, setting.member);
}

Error UnknownSetting(const std::string& name)
{
    std::vector<std::string> names;
    for (const SolverSetting& setting : kSettings)
    {
        names.emplace_back(setting.name);
    }
    return Error{ErrorKind::Unusable, Quoted(name.empty() ? "set" : name),
                 name.empty() ? "requires a setting and its value" : "unknown setting",
                 DidYouMean(name, names, "use one of " + JoinedBy(", ", names))};
}

} // namespace

std::span<const SolverSetting> SolverSettings()
{
    return kSettings;
}

Result<int> ParseSetting(const std::string& name, const std::string& text)
{
    const SolverSetting* const setting = Find(name);
    if (setting == nullptr)
    {
        return UnknownSetting(name);
    }
    if (IsFlag(*setting))
    {
        return text == "on" || text == "off" ? Result<int>(text == "on" ? 1 : 0)
                                             : BadValue(name, text, "must be on or off");
    }
    const Result<std::int64_t> number = ParseWhole(name, text, 1, setting->maximum);
    return number ? Result<int>(static_cast<int>(*number)) : number.GetError();
}

std::string SettingText(const std::string& name, int value)
{
    return !IsFlag(*Find(name)) ? std::to_string(value) : value != 0 ? "on" : "off";
}

void ApplySetting(const std::string& name, int value, b2World& world, StepSettings& steps)
{
    Find(name)->set(value, world, steps);
}

void ReadSettings(SolverChoices& solver, const b2World& world, const StepSettings& steps)
{
    for (const SolverSetting& setting : kSettings)
    {
        const int value = setting.get(world, steps);
        if (const auto* const flag = std::get_if<bool SolverChoices::*>(&setting.member))
        {
            solver.** flag = value != 0;
        }
        else
        {
            solver.*std::get<int SolverChoices::*>(setting.member) = value;
        }
    }
}

void ApplySettings(const SolverChoices& solver, b2World& world, StepSettings& steps)
{
    for (const SolverSetting& setting : kSettings)
    {
        setting.set(ValueOf(setting, solver), world, steps);
    }
}

std::vector<std::pair<std::string, std::string>> Differences(const SolverChoices& before,
                                                             const SolverChoices& after)
{
    std::vector<std::pair<std::string, std::string>> changed;
    for (const SolverSetting& setting : kSettings)
    {
        const int value = ValueOf(setting, after);
        if (value != ValueOf(setting, before))
        {
            changed.emplace_back(setting.name, SettingText(setting.name, value));
        }
    }
    return changed;
}

} // namespace boxreel
