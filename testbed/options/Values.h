// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <base/Words.h>
#include <recorder/FrameClock.h>

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The values of options, read strictly: the whole text counts, no locale, no rounding, no
/// surprise. `option` is what the error's sentence names, e.g. "--size". Every failure is Unusable.
namespace boxreel
{

/// A length of time in whole nanoseconds, so that "0.1" is exactly a tenth. 0 to 1,000,000 s.
struct Duration
{
    std::int64_t nanoseconds = 0;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 means the operator.
    friend auto operator<=>(const Duration&, const Duration&) = default;
};

struct PixelSize
{
    int width = 1280; ///< [px]
    int height = 720; ///< [px]
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Why the value of an option, or of a word in a script, is refused (Unusable). The culprit is both
/// as typed: "--fps 0". `option` may be empty.
Error BadValue(std::string_view option, std::string_view text, std::string problem,
               std::string remedy = {});

/// A whole number from `lowest` to `highest`, decimal.
Result<std::int64_t> ParseWhole(std::string_view option, std::string_view text, std::int64_t lowest,
                                std::int64_t highest);

/// "3s", "500ms", "2.5" (seconds); at most nine decimals.
Result<Duration> ParseDuration(std::string_view option, std::string_view text);

/// "1280x720", each side from 1 to 8192.
Result<PixelSize> ParseSize(std::string_view option, std::string_view text);

/// "60", "29.97", "30000/1001", from `lowest` to `highest`.
Result<Rational> ParseRatio(std::string_view option, std::string_view text, double lowest,
                            double highest);

/// A finite decimal number such as "-2.5".
Result<double> ParseNumber(std::string_view option, std::string_view text);

/// The frames that fill `length`: the nearest whole number, at least one.
std::int64_t FramesIn(Duration length, const Rational& framesPerSecond);

/// The last step at or before `time`.
std::int64_t StepAt(Duration time, const Rational& stepsPerSecond);

} // namespace boxreel
