// SPDX-License-Identifier: MIT
#include "MotionChoice.h"

#include <base/ErrorMacros.h>

#include <cmath>

namespace boxreel
{
namespace
{

constexpr std::int64_t kMaxSteps = 1'000'000'000;
constexpr std::int64_t kMaxPoses = 100; // of an onion skin: more are indistinguishable
constexpr std::size_t kMaxMoments = 64; // smaller pictures would show nothing
constexpr double kFarthest = 1e6;       // [m], where single precision has steps of 6 cm

std::optional<BodyChoice> ReadBodies(std::string_view text)
{
    if (text == "moving")
    {
        return BodyChoice{true, {}};
    }
    const std::optional<std::vector<BodyRef>> bodies = ReadBodyRefs(text);
    return bodies ? std::optional(BodyChoice{false, *bodies}) : std::nullopt;
}

/// Above 0.
std::optional<Interval> ReadInterval(std::string_view text)
{
    for (const std::string_view unit : {"steps", "step"})
    {
        if (text.ends_with(unit))
        {
            text.remove_suffix(unit.size());
            const Result<std::int64_t> steps = ParseWhole("", text, 1, kMaxSteps);
            return steps ? std::optional(Interval{{}, *steps}) : std::nullopt;
        }
    }
    const Result<Duration> time = ParseDuration("", text);
    return time && time->nanoseconds > 0 ? std::optional(Interval{*time, 0}) : std::nullopt;
}

std::optional<MeasuredEnd> ReadEnd(std::string_view text)
{
    const std::vector<std::string> parts = SplitOutsideQuotes(",", text);
    if (parts.size() == 1)
    {
        const std::optional<BodyRef> body = ReadBodyRef(parts[0]);
        return body ? std::optional(MeasuredEnd(*body)) : std::nullopt;
    }
    const Result<double> x = ParseNumber("", parts[0]);
    const Result<double> y = ParseNumber("", parts[1]);
    if (parts.size() != 2 || !x || !y || std::max(std::abs(*x), std::abs(*y)) > kFarthest)
    {
        return std::nullopt;
    }
    return MeasuredEnd(Vec2{static_cast<float>(*x), static_cast<float>(*y)});
}

/// A list with commas, each larger than the one before.
template <class Value, class Parse>
Result<std::vector<Value>> ParseGrowing(const std::string& option, const std::string& text,
                                        const Parse& parse)
{
    std::vector<Value> values;
    for (const std::string& part : SplitAt(',', text))
    {
        if (part.empty() && !text.empty())
        {
            return BadValue(option, text, "a value is missing beside a comma");
        }
        ASSIGN_OR_RETURN(const Value value, parse(part));
        if (!values.empty() && !(values.back() < value))
        {
            return BadValue(option, text, "values must increase", "put the earliest first");
        }
        values.push_back(value);
    }
    if (values.size() > kMaxMoments)
    {
        return BadValue(option, text, "at most 64 moments are possible");
    }
    return values;
}

} // namespace

Result<BodyChoice> ParseBodyChoice(const std::string& option, const std::string& text)
{
    const std::optional<BodyChoice> bodies = ReadBodies(text);
    return bodies ? Result<BodyChoice>(*bodies)
                  : BadValue(option, text,
                             "must be numbers or names of bodies, such as 3,17, or moving");
}

Result<StrobeChoice> ParseStrobe(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = SplitOutsideQuotes(":", text);
    const std::optional<Interval> every = ReadInterval(parts[0]);
    const std::optional<BodyChoice> bodies = ReadBodies(parts.size() > 1 ? parts[1] : "moving");
    if (!every || !bodies || parts.size() > 2)
    {
        return BadValue(option, text,
                        "must be a time or steps, then optional bodies, such as 250ms, 15steps or "
                        "250ms:3,17");
    }
    return StrobeChoice{*every, *bodies};
}

Result<OnionChoice> ParseOnion(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = SplitOutsideQuotes(":", text);
    OnionChoice onion;
    const Result<std::int64_t> count = ParseWhole("", parts[0], 1, kMaxPoses);
    const std::optional<Interval> every =
        parts.size() > 1 ? ReadInterval(parts[1]) : std::optional(onion.every);
    const std::optional<BodyChoice> bodies = ReadBodies(parts.size() > 2 ? parts[2] : "moving");
    if (!count || !every || !bodies || parts.size() > 3)
    {
        return BadValue(option, text,
                        "must be 1 to 100 poses, then optional interval and bodies, such as 5, "
                        "5:100ms or 5:6steps:3,17");
    }
    return OnionChoice{*count, *every, *bodies};
}

Result<DimensionChoice> ParseDimension(const std::string& option, const std::string& text)
{
    std::vector<std::string> ends = SplitOutsideQuotes(" to ", text);
    if (ends.size() > 2)
    {
        return BadValue(option, text, "has more than two ends",
                        "quote a name that contains \" to \", such as '\"b to c\" to 3'");
    }
    if (ends.size() == 1)
    {
        ends = SplitOutsideQuotes(",", text); // of bodies, like elsewhere
    }
    const std::optional<MeasuredEnd> from = ReadEnd(ends.front());
    const std::optional<MeasuredEnd> end = ReadEnd(ends.back());
    if (ends.size() == 2 && from && end && *from != *end && !text.ends_with(" to"))
    {
        return DimensionChoice{*from, *end};
    }
    return BadValue(option, text,
                    "must be two bodies, such as 3,17, or two ends, each a body or a point X,Y in "
                    "metres, such as \"0,0 to 4.5,2\" or \"3 to 4.5,2\"");
}

Result<std::vector<Duration>> ParseMoments(const std::string& option, const std::string& text)
{
    return ParseGrowing<Duration>(
        option, text, [&](const std::string& part) { return ParseDuration(option, part); });
}

Result<std::vector<std::int64_t>> ParseSteps(const std::string& option, const std::string& text)
{
    return ParseGrowing<std::int64_t>(option, text, [&](const std::string& part) {
        return ParseWhole(option, part, 0, kMaxSteps);
    });
}

} // namespace boxreel
