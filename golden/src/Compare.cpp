// SPDX-License-Identifier: MIT
#include "DensityWindow.h"
#include "DifferencePicture.h"
#include "PixelMarks.h"
#include <golden/Compare.h>

#include <base/Nearest.h>

#include <algorithm>
#include <cassert>
#include <vector>

namespace boxreel
{

namespace
{

[[maybe_unused]] bool IsWhole(const Frame& frame)
{
    return frame.width >= 0 && frame.height >= 0 &&
           frame.rgba.size() == std::size_t(frame.width) * std::size_t(frame.height) * 4;
}

} // namespace

CompareSettings CompareSettings::Exact()
{
    CompareSettings settings;
    settings.preset = "exact";
    settings.adaptsToRenderer = false;
    settings.tolerance = 0.0;
    settings.maxPixels = 0;
    settings.maxInWindow = 0;
    return settings;
}

CompareSettings CompareSettings::SameMachine()
{
    CompareSettings settings;
    settings.adaptsToRenderer = false;
    return settings;
}

CompareSettings CompareSettings::CrossMachine()
{
    CompareSettings settings;
    settings.preset = "cross-machine";
    settings.adaptsToRenderer = false;
    settings.tolerance = 0.01;
    settings.edgeShift = 0.2;
    settings.maxPixels = kAnyNumberOfPixels;
    settings.maxRatio = 0.0005;
    settings.maxInWindow = 8;
    return settings;
}

std::vector<std::string> DifferentLimits(const CompareSettings& one, const CompareSettings& other)
{
    std::vector<std::string> names;
    VisitLimits(
        [&names](const char* name, const auto& a, const auto& b) {
            if (a != b)
            {
                names.emplace_back(name);
            }
        },
        one, other);
    return names;
}

std::optional<CompareSettings> ForOtherRenderer(const CompareSettings& settings)
{
    if (!settings.adaptsToRenderer || !DifferentLimits(settings, CompareSettings()).empty())
    {
        return std::nullopt;
    }
    CompareSettings other = CompareSettings::CrossMachine();
    other.options = settings.options;
    other.ignored = settings.ignored;
    other.ignoredBodies = settings.ignoredBodies;
    other.paintsDifference = settings.paintsDifference;
    return other;
}

std::vector<std::string> CompareSettings::PresetNames()
{
    return {Exact().preset, SameMachine().preset, CrossMachine().preset};
}

Result<CompareSettings> CompareSettings::Preset(const std::string& option, const std::string& name)
{
    for (const CompareSettings& settings : {Exact(), SameMachine(), CrossMachine()})
    {
        if (settings.preset == name)
        {
            return settings;
        }
    }
    return NotOneOf(option, name, PresetNames());
}

Comparison Compare(const Frame& expected, const Frame& actual, const CompareSettings& settings)
{
    assert(IsWhole(expected) && IsWhole(actual) && "a frame holds width * height * 4 bytes");
    assert(settings.densityWindow >= 1 && "a window is at least one pixel");

    Comparison result;
    result.expectedSize = {expected.width, expected.height};
    result.actualSize = {actual.width, actual.height};
    result.sameSize = result.expectedSize == result.actualSize;
    result.limits = settings;
    const Marks marks = MarkDifferences(expected, actual, settings, result);
    if (result.overTolerance > 0)
    {
        result.worstWindow = WorstWindow(marks, std::max(settings.densityWindow, 1));
    }
    result.equal = result.sameSize && !result.IsAllIgnored() &&
                   result.overTolerance <= settings.maxPixels &&
                   double(result.overTolerance) <= settings.maxRatio * double(result.compared) &&
                   result.worstWindow <= settings.maxInWindow;
    if (settings.paintsDifference)
    {
        result.difference = PaintDifference(expected, marks);
    }
    return result;
}

} // namespace boxreel
