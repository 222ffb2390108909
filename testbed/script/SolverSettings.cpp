// SPDX-License-Identifier: MIT
#include "ScriptSettings.h"

#include <base/Nearest.h>
#include <base/Quoting.h>
#include <options/Values.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace boxreel
{
namespace
{

struct Setting
{
    const char* name;
    int maximum; // 0: on or off
    void (*apply)(int value, b2World& world, StepSettings& steps);
};

constexpr Setting kSettings[] = {
    {"velocity-iterations", 1000,
     [](int value, b2World&, StepSettings& steps) { steps.velocityIterations = value; }},
    {"position-iterations", 1000,
     [](int value, b2World&, StepSettings& steps) { steps.positionIterations = value; }},
    {"sub-steps", 64,
     [](int value, b2World& world, StepSettings&) { world.SetSubStepCount(value); }},
    {"sleep", 0,
     [](int value, b2World& world, StepSettings&) { world.SetAllowSleeping(value != 0); }},
    {"warm-starting", 0,
     [](int value, b2World& world, StepSettings&) { world.SetWarmStarting(value != 0); }},
    {"continuous", 0,
     [](int value, b2World& world, StepSettings&) { world.SetContinuousPhysics(value != 0); }},
    {"sub-stepping", 0,
     [](int value, b2World& world, StepSettings&) { world.SetSubStepping(value != 0); }},
};

const Setting* Find(const std::string& name)
{
    const auto found = std::find_if(std::begin(kSettings), std::end(kSettings),
                                    [&](const Setting& setting) { return name == setting.name; });
    return found == std::end(kSettings) ? nullptr : found;
}

Error UnknownSetting(const std::string& name)
{
    std::vector<std::string> names;
    for (const Setting& setting : kSettings)
    {
        names.emplace_back(setting.name);
    }
    return Error{ErrorKind::Unusable, Quoted(name.empty() ? "set" : name),
                 name.empty() ? "requires a setting and its value" : "unknown setting",
                 DidYouMean(name, names, "use one of " + JoinedBy(", ", names))};
}

} // namespace

Result<int> ParseSetting(const std::string& name, const std::string& text)
{
    const Setting* const setting = Find(name);
    if (setting == nullptr)
    {
        return UnknownSetting(name);
    }
    if (setting->maximum == 0)
    {
        return text == "on" || text == "off" ? Result<int>(text == "on" ? 1 : 0)
                                             : BadValue(name, text, "must be on or off");
    }
    const Result<std::int64_t> number = ParseWhole(name, text, 1, setting->maximum);
    return number ? Result<int>(static_cast<int>(*number)) : number.GetError();
}

std::string SettingText(const std::string& name, int value)
{
    return Find(name)->maximum != 0 ? std::to_string(value) : value != 0 ? "on" : "off";
}

void ApplySetting(const std::string& name, int value, b2World& world, StepSettings& steps)
{
    Find(name)->apply(value, world, steps);
}

} // namespace boxreel
