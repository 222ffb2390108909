// SPDX-License-Identifier: MIT
#include <golden/WorldState.h>

#include "TextLines.h"

#include <algorithm>
#include <charconv>

namespace boxreel
{

namespace
{

constexpr std::string_view kHex = "0123456789abcdef";

bool IsHex(std::string_view text, std::string_view besides)
{
    return std::all_of(text.begin(), text.end(), [&](char c) {
        return kHex.find(c) != std::string_view::npos || besides.find(c) != std::string_view::npos;
    });
}

std::optional<TraceStep> ParseStep(std::string_view line)
{
    TraceStep step;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), step.step);
    const std::size_t digits = std::size_t(end - line.data());
    // "43 0123abcd 77f0…"
    if (error != std::errc() || step.step < 0 || line.size() < digits + 10 || *end != ' ' ||
        line[digits + 9] != ' ')
    {
        return std::nullopt;
    }
    step.world = line.substr(digits + 1, 8);
    step.bodies = line.substr(digits + 10);
    return IsHex(step.world, "") && IsHex(step.bodies, "./") ? std::optional<TraceStep>(step)
                                                             : std::nullopt;
}

/// Returns the positions of different digits, including those beyond the end of one string.
std::vector<int> Different(std::string_view a, std::string_view b)
{
    std::vector<int> places;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    {
        if (i >= a.size() || i >= b.size() || a[i] != b[i])
        {
            places.push_back(int(i));
        }
    }
    return places;
}

std::vector<int> BodiesThatDiffer(std::string_view expected, std::string_view actual)
{
    const std::size_t slash = expected.find('/');
    if (slash != actual.find('/'))
    {
        return {}; // different sizes of the square, so numbers do not correspond
    }
    if (slash == std::string_view::npos)
    {
        return Different(expected, actual);
    }
    std::vector<int> bodies;
    for (const int row : Different(expected.substr(0, slash), actual.substr(0, slash)))
    {
        for (const int column : Different(expected.substr(slash + 1), actual.substr(slash + 1)))
        {
            bodies.push_back(row * int(slash) + column);
        }
    }
    return bodies;
}

} // namespace

std::string ToText(const StateTrace& trace)
{
    std::string text;
    for (const TraceStep& step : trace.steps)
    {
        text += std::to_string(step.step) + ' ' + step.world + ' ' + step.bodies + '\n';
    }
    return text;
}

Result<StateTrace> ParseStateTrace(std::string_view text)
{
    StateTrace trace;
    while (const std::optional<std::string_view> line = TakeLine(text))
    {
        std::optional<TraceStep> step = ParseStep(*line);
        if (!step || (!trace.steps.empty() && step->step <= trace.steps.back().step))
        {
            return Error{ErrorKind::Unusable, Shown(*line), "is not a step number with its hashes"};
        }
        trace.steps.push_back(*std::move(step));
    }
    return trace;
}

std::optional<TraceDifference> FirstDifference(const StateTrace& expected, const StateTrace& actual)
{
    auto a = expected.steps.begin();
    auto b = actual.steps.begin();
    for (; a != expected.steps.end() && b != actual.steps.end(); ++a, ++b)
    {
        if (a->step != b->step)
        {
            return TraceDifference{std::min(a->step, b->step), {}, true};
        }
        if (a->world != b->world)
        {
            return TraceDifference{a->step, BodiesThatDiffer(a->bodies, b->bodies), false,
                                   a == expected.steps.begin() && a->step > 1};
        }
    }
    if (a != expected.steps.end() || b != actual.steps.end())
    {
        return TraceDifference{a != expected.steps.end() ? a->step : b->step, {}, true};
    }
    return std::nullopt;
}

} // namespace boxreel
