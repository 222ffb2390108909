// SPDX-License-Identifier: MIT
#include <golden/WorldState.h>

#include "TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace boxreel
{

namespace
{

void AddNumber(std::string& text, float value)
{
    char digits[32];
    const float zero = value == 0.0f ? 0.0f : value; // not -0
    const auto end = std::to_chars(digits, digits + sizeof digits, zero).ptr;
    text += ' ';
    text.append(digits, end);
}

bool HasVelocity(const BodyState& body)
{
    return body.velocityX != 0.0f || body.velocityY != 0.0f || body.angularVelocity != 0.0f;
}

double Offset(const BodyState& a, const BodyState& b)
{
    return std::hypot(double(a.x) - double(b.x), double(a.y) - double(b.y));
}

std::optional<BodyState> ParseBody(std::string_view line)
{
    BodyState body;
    const char* at = line.data();
    const char* const end = line.data() + line.size();
    const auto number = std::from_chars(at, end, body.number);
    if (number.ec != std::errc() || body.number < 0)
    {
        return std::nullopt;
    }
    at = number.ptr;
    float* const values[] = {&body.x,         &body.y,         &body.angle,
                             &body.velocityX, &body.velocityY, &body.angularVelocity};
    int read = 0;
    for (; read < 6 && at != end; ++read)
    {
        const auto value = *at == ' ' ? std::from_chars(at + 1, end, *values[read])
                                      : std::from_chars_result{at, std::errc::invalid_argument};
        if (value.ec != std::errc() || !std::isfinite(*values[read]))
        {
            return std::nullopt;
        }
        at = value.ptr;
    }
    return at == end && (read == 3 || read == 6) ? std::optional<BodyState>(body) : std::nullopt;
}

/// The bodies of only one world, and the pairs of common bodies.
struct Matched
{
    std::vector<int> missing, extra;
    std::vector<std::pair<const BodyState*, const BodyState*>> pairs;
};

Matched Match(const WorldState& expected, const WorldState& actual)
{
    Matched matched;
    auto a = expected.bodies.begin();
    auto b = actual.bodies.begin();
    while (a != expected.bodies.end() || b != actual.bodies.end())
    {
        if (b == actual.bodies.end() || (a != expected.bodies.end() && a->number < b->number))
        {
            matched.missing.push_back((a++)->number);
        }
        else if (a == expected.bodies.end() || b->number < a->number)
        {
            matched.extra.push_back((b++)->number);
        }
        else
        {
            matched.pairs.emplace_back(&*a++, &*b++);
        }
    }
    return matched;
}

} // namespace

std::string ToText(const WorldState& state)
{
    std::string text;
    for (const BodyState& body : state.bodies)
    {
        text += std::to_string(body.number);
        AddNumber(text, body.x);
        AddNumber(text, body.y);
        AddNumber(text, body.angle);
        if (HasVelocity(body))
        {
            AddNumber(text, body.velocityX);
            AddNumber(text, body.velocityY);
            AddNumber(text, body.angularVelocity);
        }
        text += '\n';
    }
    return text;
}

Result<WorldState> ParseWorldState(std::string_view text)
{
    WorldState state;
    while (const std::optional<std::string_view> line = TakeLine(text))
    {
        const std::optional<BodyState> body = ParseBody(*line);
        if (!body || (!state.bodies.empty() && body->number <= state.bodies.back().number))
        {
            return Error{ErrorKind::Unusable, Shown(*line),
                         "is not a body number with position and velocity"};
        }
        state.bodies.push_back(*body);
    }
    return state;
}

StateDifference DifferenceOf(const WorldState& expected, const WorldState& actual)
{
    Matched matched = Match(expected, actual);
    StateDifference difference;
    difference.missing = std::move(matched.missing);
    difference.extra = std::move(matched.extra);
    difference.compared = matched.pairs.size();
    for (const auto& [before, now] : matched.pairs)
    {
        if (*before == *now)
        {
            continue;
        }
        if (difference.different++ == 0 ||
            Offset(*before, *now) > Offset(difference.expected, difference.actual))
        {
            difference.expected = *before;
            difference.actual = *now;
        }
    }
    return difference;
}

} // namespace boxreel
