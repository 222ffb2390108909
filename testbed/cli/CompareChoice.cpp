// SPDX-License-Identifier: MIT
#include "CompareChoice.h"
#include "Declare.h"

#include <base/ErrorMacros.h>

#include <string>

namespace boxreel
{
namespace
{

template <class Value>
void Replace(Value& limit, const std::optional<Value>& given, const char* option,
             std::vector<std::string>& options)
{
    if (given)
    {
        limit = *given;
        options.emplace_back(option);
    }
}

} // namespace

CompareSettings Effective(const CompareChoice& choice)
{
    CompareSettings settings = choice.preset;
    std::vector<std::string>& options = settings.options;
    Replace(settings.tolerance, choice.tolerance, "--tolerance", options);
    Replace(settings.edgeShift, choice.edgeShift, "--edge-shift", options);
    Replace(settings.maxPixels, choice.maxPixels, "--max-pixels", options);
    Replace(settings.maxRatio, choice.maxRatio, "--max-ratio", options);
    Replace(settings.maxInWindow, choice.maxInWindow, "--max-in-window", options);
    Replace(settings.densityWindow, choice.window, "--window", options);
    settings.adaptsToRenderer = settings.adaptsToRenderer && options.empty();
    settings.ignored = choice.ignored;
    settings.ignoredBodies = choice.ignoredBodies;
    for (const auto& [isGiven, option] :
         {std::pair(!choice.ignored.empty(), "--ignore"),
          std::pair(!choice.ignoredBodies.empty(), "--ignore-body")})
    {
        if (isGiven)
        {
            options.emplace_back(option);
        }
    }
    return settings;
}

namespace
{

// Far more pixels than any picture has, and a side that no picture exceeds.
constexpr std::int64_t kMaxPixels = 1'000'000'000;
constexpr int kLargestSide = 65535;

/// "0.1%" or "0.001", as a number from 0 to 1.
Result<double> ParseShare(const std::string& option, const std::string& text)
{
    const bool isPercent = text.ends_with('%');
    const std::string digits = isPercent ? text.substr(0, text.size() - 1) : text;
    const Result<double> number = ParseNumber(option, digits);
    const double share = number ? (isPercent ? *number / 100.0 : *number) : -1.0;
    if (share < 0.0 || share > 1.0)
    {
        return BadValue(option, text, "must be a share from 0 to 100%, such as 0.1% or 0.001");
    }
    return share;
}

/// "10,20,300x40": left, top, width and height.
Result<PixelBounds> ParseRectangle(const std::string& option, const std::string& text)
{
    const Error refusal = BadValue(option, text,
                                   "must be X,Y,WxH in pixels from the top left corner, each up to "
                                   "65535, such as 10,20,300x40");
    const std::vector<std::string> parts = SplitAt(',', text);
    const std::vector<std::string> sides =
        parts.size() == 3 ? SplitAt('x', parts[2]) : std::vector<std::string>();
    if (sides.size() != 2)
    {
        return refusal;
    }
    const Result<std::int64_t> x = ParseWhole(option, parts[0], 0, kLargestSide);
    const Result<std::int64_t> y = ParseWhole(option, parts[1], 0, kLargestSide);
    const Result<std::int64_t> width = ParseWhole(option, sides[0], 1, kLargestSide);
    const Result<std::int64_t> height = ParseWhole(option, sides[1], 1, kLargestSide);
    if (!x || !y || !width || !height)
    {
        return refusal;
    }
    return PixelBounds{int(*x), int(*y), int(*x + *width), int(*y + *height)};
}

/// "3,17": numbers of bodies.
Result<std::vector<int>> ParseBodies(const std::string& option, const std::string& text)
{
    constexpr int kMaxBodies = 1'000'000;
    std::vector<int> bodies;
    for (const std::string& part : SplitAt(',', text))
    {
        const Result<std::int64_t> body = ParseWhole(option, part, 0, kMaxBodies);
        if (!body)
        {
            return BadValue(option, text, "must be numbers of bodies, such as 3,17",
                            "--labels shows them");
        }
        bodies.push_back(int(*body));
    }
    return bodies;
}

} // namespace

void AddIgnoredBodies(Command& command, CompareChoice& choice)
{
    const auto read = [&choice](const std::vector<std::string>& texts) -> Result<void> {
        for (const std::string& text : texts)
        {
            ASSIGN_OR_RETURN(const std::vector<int> bodies, ParseBodies("--ignore-body", text));
            choice.ignoredBodies.insert(choice.ignoredBodies.end(), bodies.begin(), bodies.end());
        }
        return {};
    };
    AddTexts(command, "--ignore-body", "N,...", read,
             "Ignore these bodies in state, draw list and picture, by number,\n"
             "such as 3,17");
}

void AddCompare(Command& command, CompareChoice& choice, const std::string& usualPreset)
{
    AddValue(command, "--preset", "NAME", choice.preset, CompareSettings::Preset,
             "Set the limits below: exact, same-machine, cross-machine\n(" + usualPreset + ")")
        .Completes({Completion::Kind::Words, CompareSettings::PresetNames()});
    AddValue(command, "--tolerance", "DISTANCE", choice.tolerance,
             NumberBetween(0.0, 1.0, "must be an OKLab distance from 0 to 1, such as 0.01"),
             "Set the tolerance of a pixel, from 0 (equal) to 1 (black and\n"
             "white) (the preset's)");
    AddValue(command, "--edge-shift", "PX", choice.edgeShift,
             NumberBetween(0.0, 0.45, "must be a number of pixels from 0 to 0.45, such as 0.2"),
             "Allow edges to shift this far (the preset's)");
    AddValue(command, "--max-pixels", "N", choice.maxPixels, WholeBetween(0, kMaxPixels),
             "Allow this many pixels over tolerance (the preset's)");
    AddValue(command, "--max-ratio", "SHARE", choice.maxRatio, ParseShare,
             "Allow this share of all pixels over tolerance, such as 0.1%\n"
             "(the preset's)");
    AddValue(command, "--max-in-window", "N", choice.maxInWindow, WholeBetween(0, kMaxPixels),
             "Allow this many pixels over tolerance in a square window\n"
             "(the preset's)");
    AddValue(command, "--window", "PX", choice.window, WholeBetween(1, kLargestSide),
             "Set the side of the window (16)");
    AddValues(command, "--ignore", "X,Y,WxH", choice.ignored, ParseRectangle,
              "Ignore this rectangle of width W and height H; repeatable");
}

} // namespace boxreel
