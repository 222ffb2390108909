// SPDX-License-Identifier: MIT
#include <golden/WorldState.h>

#include "TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

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

std::string Rounded(double value)
{
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 3).ptr;
    return {digits, end};
}

std::string Exact(float value)
{
    std::string text;
    AddNumber(text, value);
    return text.substr(1);
}

std::string Instead(const char* quantity, float expected, float actual)
{
    return std::string(" (") + quantity + " " + Exact(actual) + " instead of " + Exact(expected) +
           ")";
}

double Offset(const BodyState& a, const BodyState& b)
{
    return std::hypot(double(a.x) - double(b.x), double(a.y) - double(b.y));
}

/// The most significant difference first: positions before angles before velocities.
std::string DescribeBody(const BodyState& expected, const BodyState& actual)
{
    const double dx = double(actual.x) - double(expected.x);
    const double dy = double(actual.y) - double(expected.y);
    if (std::abs(dy) > 0.0 && std::abs(dy) >= std::abs(dx))
    {
        return Rounded(std::abs(dy)) + (dy < 0.0 ? " m lower" : " m higher") +
               Instead("y", expected.y, actual.y);
    }
    if (dx != 0.0)
    {
        return Rounded(std::abs(dx)) + " m further to the " + (dx < 0.0 ? "left" : "right") +
               Instead("x", expected.x, actual.x);
    }
    if (expected.angle != actual.angle)
    {
        const double turned = double(actual.angle) - double(expected.angle);
        return "turned by " + Rounded(turned) + " rad more" +
               Instead("angle", expected.angle, actual.angle);
    }
    if (expected.velocityX != actual.velocityX)
    {
        return "at the same place with another velocity" +
               Instead("x", expected.velocityX, actual.velocityX);
    }
    if (expected.velocityY != actual.velocityY)
    {
        return "at the same place with another velocity" +
               Instead("y", expected.velocityY, actual.velocityY);
    }
    return "at the same place with another angular velocity" +
           Instead("rad/s", expected.angularVelocity, actual.angularVelocity);
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

std::string Numbers(const std::vector<int>& numbers, const char* what)
{
    return numbers.empty()       ? ""
           : numbers.size() == 1 ? "body " + std::to_string(numbers.front()) + " is " + what
                                 : std::to_string(numbers.size()) + " bodies are " + what +
                                       " (number " + std::to_string(numbers.front()) + " first)";
}

void Join(std::string& text, const std::string& more)
{
    text.append(text.empty() || more.empty() ? "" : ", ").append(more);
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
            return Error{ErrorKind::Unusable,
                         Shown(*line) + " is no body's number with its place and velocity"};
        }
        state.bodies.push_back(*body);
    }
    return state;
}

std::string DescribeDifference(const WorldState& expected, const WorldState& actual)
{
    const Matched matched = Match(expected, actual);
    std::string text = Numbers(matched.missing, "missing");
    Join(text, Numbers(matched.extra, "one too many"));
    std::size_t different = 0;
    const std::pair<const BodyState*, const BodyState*>* most = nullptr;
    for (const auto& pair : matched.pairs)
    {
        if (*pair.first == *pair.second)
        {
            continue;
        }
        ++different;
        if (most == nullptr ||
            Offset(*pair.first, *pair.second) > Offset(*most->first, *most->second))
        {
            most = &pair;
        }
    }
    if (most != nullptr)
    {
        Join(text,
             std::to_string(different) + " of " + std::to_string(matched.pairs.size()) +
                 (different == 1 ? " bodies differs, body " : " bodies differ, most of all body ") +
                 std::to_string(most->first->number) + ": " +
                 DescribeBody(*most->first, *most->second));
    }
    return text;
}

} // namespace boxreel
