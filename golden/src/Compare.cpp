// SPDX-License-Identifier: MIT
#include "DensityWindow.h"
#include "DifferencePicture.h"
#include "PixelMarks.h"
#include <golden/Compare.h>

#include <base/Counting.h>
#include <base/Nearest.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <tuple>
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

// Returns the shortest text that reads back exactly, independent of the locale.
std::string Number(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string Rounded(double value)
{
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr;
    return {text, end};
}

/// Returns a fraction as a percentage that reads back exactly: limits are never rounded.
std::string Percent(double share)
{
    for (int digits = 3; digits < 17; ++digits)
    {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, 100.0 * share,
                                       std::chars_format::general, digits)
                             .ptr;
        double percent = 0.0;
        std::from_chars(text, end, percent);
        if (percent / 100.0 == share)
        {
            return {text, end};
        }
    }
    return Number(100.0 * share);
}

std::string Size(const Frame& frame)
{
    return std::to_string(frame.width) + "x" + std::to_string(frame.height);
}

/// Returns the source of the limits: "exact", or "exact, with another tolerance and maxPixels,". A
/// program can change each limit; changes by options have their own preset name.
std::string Origin(const CompareSettings& settings)
{
    std::string changed;
    for (const CompareSettings& preset : {CompareSettings::Exact(), CompareSettings::SameMachine(),
                                          CompareSettings::CrossMachine()})
    {
        if (preset.preset != settings.preset)
        {
            continue;
        }
        for (const auto& [isOther, member] :
             {std::pair(preset.tolerance != settings.tolerance, "tolerance"),
              std::pair(preset.edgeShift != settings.edgeShift, "edgeShift"),
              std::pair(preset.maxPixels != settings.maxPixels, "maxPixels"),
              std::pair(preset.maxRatio != settings.maxRatio, "maxRatio"),
              std::pair(preset.densityWindow != settings.densityWindow, "densityWindow"),
              std::pair(preset.maxInWindow != settings.maxInWindow, "maxInWindow")})
        {
            changed +=
                !isOther ? "" : (changed.empty() ? ", with another " : ", ") + std::string(member);
        }
    }
    return settings.preset + changed + (changed.empty() ? "" : ",");
}

} // namespace

std::string DescribeLimits(const CompareSettings& settings)
{
    const std::string side = std::to_string(settings.densityWindow);
    std::string text = Origin(settings) + " allows ";
    if (settings.maxPixels != kAnyNumberOfPixels)
    {
        text += Counted(settings.maxPixels, "pixel");
    }
    if (settings.maxRatio < 1.0 || settings.maxPixels == kAnyNumberOfPixels)
    {
        text += (settings.maxPixels == kAnyNumberOfPixels ? "" : ", ") +
                Percent(settings.maxRatio) + " %";
    }
    text += " over a distance of " + Number(settings.tolerance);
    if (settings.edgeShift > 0.0)
    {
        text += " and edges " + Number(settings.edgeShift) + " px elsewhere";
    }
    return text + ", " + std::to_string(settings.maxInWindow) + " in any " + side + "x" + side;
}

namespace
{

/// A comparison without compared pixels must fail.
bool IsAllIgnored(const Comparison& result)
{
    return result.compared == 0 && result.ignored > 0;
}

std::string Verdict(const Comparison& result, const CompareSettings& settings)
{
    std::string text = result.equal ? "equal: " : "different: ";
    const std::string ignored =
        result.ignored > 0 ? ", " + Counted(result.ignored, "pixel") + " ignored" : std::string();
    if (IsAllIgnored(result))
    {
        return text + "nothing was compared" + ignored + " (" + DescribeLimits(settings) + ")";
    }
    if (result.differentPixels == 0)
    {
        return text + "no pixel differs" + ignored + " (" + DescribeLimits(settings) + ")";
    }
    if (result.overTolerance == 0)
    {
        text += Counted(result.differentPixels, "pixel") + " by no more than " +
                (result.excusedAtEdges > 0 ? "tolerance and edges allow" : "the tolerance");
    }
    else
    {
        text += Counted(result.overTolerance, "pixel") + " over the tolerance, first at " +
                std::to_string(result.firstX) + "," + std::to_string(result.firstY) + ", up to " +
                std::to_string(result.worstWindow) + " in a window";
    }
    return text + ", largest distance " + Rounded(result.largestDistance) + ignored + " (" +
           DescribeLimits(settings) + ")";
}

std::string SizeVerdict(const Frame& expected, const Frame& actual, const CompareSettings& settings)
{
    return "different: the expected picture has " + Size(expected) + " pixels, the actual one " +
           Size(actual) + " (" + DescribeLimits(settings) + ")";
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

std::optional<CompareSettings> ForOtherRenderer(const CompareSettings& settings)
{
    const CompareSettings usual;
    const auto limits = [](const CompareSettings& s) {
        return std::tie(s.tolerance, s.edgeShift, s.maxPixels, s.maxRatio, s.densityWindow,
                        s.maxInWindow);
    };
    if (!settings.adaptsToRenderer || limits(settings) != limits(usual))
    {
        return std::nullopt;
    }
    CompareSettings other = CompareSettings::CrossMachine();
    // Keeps additions such as "same-machine, with --ignore,".
    other.preset += settings.preset.substr(std::min(usual.preset.size(), settings.preset.size()));
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
    result.sameSize = expected.width == actual.width && expected.height == actual.height;
    const Marks marks = MarkDifferences(expected, actual, settings, result);
    if (result.overTolerance > 0)
    {
        result.worstWindow = WorstWindow(marks, std::max(settings.densityWindow, 1));
    }
    result.equal = result.sameSize && !IsAllIgnored(result) &&
                   result.overTolerance <= settings.maxPixels &&
                   double(result.overTolerance) <= settings.maxRatio * double(result.compared) &&
                   result.worstWindow <= settings.maxInWindow;
    result.verdict =
        result.sameSize ? Verdict(result, settings) : SizeVerdict(expected, actual, settings);
    if (settings.paintsDifference)
    {
        result.difference = PaintDifference(expected, marks);
    }
    return result;
}

} // namespace boxreel
