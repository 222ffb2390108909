// SPDX-License-Identifier: MIT
#include "Values.h"

#include <base/Quoting.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

namespace boxreel
{
namespace
{

// Times and rates are whole numbers of up to 15 and 9 digits: their products need more than 64
// bits.
__extension__ typedef __int128 Wide;

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::int64_t kLongestSeconds = 1'000'000; // eleven days, far beyond any film
constexpr int kLargestSide = 8192;                  // what the renderer draws in one piece

bool IsDigits(std::string_view text)
{
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

template <class T>
bool ReadAll(std::string_view text, T& value)
{
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end;
}

/// Digits with an optional point, as nanoseconds of `unit` nanoseconds each; false when it is not a
/// number or is too long.
bool ReadNanoseconds(std::string_view text, std::int64_t unit, std::int64_t& nanoseconds)
{
    const std::size_t point = text.find('.');
    const std::string_view whole = text.substr(0, point);
    const std::string_view decimals = point == std::string_view::npos ? "" : text.substr(point + 1);
    if (!IsDigits(whole) || (point != std::string_view::npos && !IsDigits(decimals)))
    {
        return false;
    }
    std::int64_t units = 0;
    if (!ReadAll(whole, units) || units > kLongestSeconds * (kNanosecondsPerSecond / unit))
    {
        return false;
    }
    nanoseconds = units * unit;
    std::int64_t place = unit;
    for (const char digit : decimals)
    {
        // Digits below a nanosecond are rounded.
        if (place == 1)
        {
            nanoseconds += digit >= '5';
            break;
        }
        place /= 10;
        nanoseconds += place * (digit - '0');
    }
    return nanoseconds <= kLongestSeconds * kNanosecondsPerSecond;
}

} // namespace

Error BadValue(std::string_view option, std::string_view text, std::string problem,
               std::string remedy)
{
    return {ErrorKind::Unusable, AsTyped(option, text), std::move(problem), std::move(remedy)};
}

Result<std::int64_t> ParseWhole(std::string_view option, std::string_view text, std::int64_t lowest,
                                std::int64_t highest)
{
    std::int64_t value = 0;
    if (!ReadAll(text, value) || value < lowest || value > highest)
    {
        return BadValue(option, text,
                        "must be a whole number from " + std::to_string(lowest) + " to " +
                            std::to_string(highest));
    }
    return value;
}

Result<Duration> ParseDuration(std::string_view option, std::string_view text)
{
    std::string_view number = text;
    std::int64_t unit = kNanosecondsPerSecond;
    if (number.ends_with("ms"))
    {
        number.remove_suffix(2);
        unit = 1'000'000;
    }
    else if (number.ends_with("s"))
    {
        number.remove_suffix(1);
    }
    Duration duration;
    if (!ReadNanoseconds(number, unit, duration.nanoseconds))
    {
        double value = 0.0;
        if (number.find_first_of("eE") != std::string_view::npos && ReadAll(number, value))
        {
            return BadValue(option, text,
                            "must be a time from 0 to 1000000 s without an exponent, such as 2.5");
        }
        return BadValue(option, text,
                        "must be a time from 0 to 1000000 s, such as 3s, 2.5 or 500ms");
    }
    return duration;
}

Result<PixelSize> ParseSize(std::string_view option, std::string_view text)
{
    PixelSize size;
    const std::size_t cross = text.find('x');
    const bool read = cross != std::string_view::npos && IsDigits(text.substr(0, cross)) &&
                      IsDigits(text.substr(cross + 1)) &&
                      ReadAll(text.substr(0, cross), size.width) &&
                      ReadAll(text.substr(cross + 1), size.height);
    if (!read || std::min(size.width, size.height) < 1 ||
        std::max(size.width, size.height) > kLargestSide)
    {
        return BadValue(option, text,
                        "must be WIDTHxHEIGHT in pixels, each from 1 to " +
                            std::to_string(kLargestSide) + ", such as 1280x720");
    }
    return size;
}

Result<Rational> ParseRatio(std::string_view option, std::string_view text, double lowest,
                            double highest)
{
    const Result<Rational> ratio = Rational::Parse(text);
    if (!ratio || ratio->ToDouble() < lowest || ratio->ToDouble() > highest)
    {
        char range[120];
        std::snprintf(range, sizeof range,
                      "must be a number from %g to %g, such as 60%s or 30000/1001", lowest, highest,
                      lowest <= 0.25 ? ", 0.25" : "");
        return BadValue(option, text, range);
    }
    return *ratio;
}

Result<double> ParseNumber(std::string_view option, std::string_view text)
{
    double value = 0.0;
    if (!ReadAll(text, value) || !std::isfinite(value))
    {
        return BadValue(option, text, "must be a number, such as 2.5");
    }
    return value;
}

std::int64_t FramesIn(Duration length, const Rational& framesPerSecond)
{
    const Wide divisor = Wide(framesPerSecond.den) * kNanosecondsPerSecond;
    const Wide frames = (Wide(length.nanoseconds) * framesPerSecond.num + divisor / 2) / divisor;
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(frames));
}

std::int64_t StepAt(Duration time, const Rational& stepsPerSecond)
{
    const Wide steps = Wide(time.nanoseconds) * stepsPerSecond.num;
    return static_cast<std::int64_t>(steps / (Wide(stepsPerSecond.den) * kNanosecondsPerSecond));
}

} // namespace boxreel
