// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <string_view>

/// @file
/// The simulation step that a frame shows, in integers, so that long films do not drift.
/// Independent of worlds and files.
namespace boxreel
{

/// A positive fraction in lowest terms. "60", "29.97", "0.25", "30000/1001" are all exact.
struct Rational
{
    std::int64_t num = 1; ///< 1 to 1,000,000,000
    std::int64_t den = 1; ///< 1 to 1,000,000,000

    /// Parses a decimal or a fraction of two integers. An Error (Unusable) unless it is above zero,
    /// with at most nine digits on either side of the point or the slash.
    static Result<Rational> Parse(std::string_view text);
    /// Returns the quotient, rounded.
    double ToDouble() const { return double(num) / double(den); }
    /// True if all members are equal.
    friend bool operator==(const Rational&, const Rational&) = default;
};

/// Frame k shows the simulated time k * speed / fps: the state after floor(time * hz) steps. Exact
/// for every frame up to 10^11 and any Rational.
struct FrameClock
{
    Rational framesPerSecond{60, 1}; ///< of the film
    Rational stepsPerSecond{60, 1};  ///< of the world
    Rational speed{1, 1};            ///< simulated seconds per second of film

    std::int64_t StepOfFrame(std::int64_t frame) const;  ///< steps before the frame; frame >= 0
    double FractionOfFrame(std::int64_t frame) const;    ///< remaining fraction of the next step, <
                                                         ///< 1
    double SecondsOfFrame(std::int64_t frame) const;     ///< simulated time shown [s]
    double FilmSecondsOfFrame(std::int64_t frame) const; ///< time in the film [s]
};

} // namespace boxreel
