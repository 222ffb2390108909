// SPDX-License-Identifier: MIT
#include "GifRate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace boxreel
{
namespace
{

Rational Reduced(std::int64_t num, std::int64_t den)
{
    const std::int64_t divisor = std::gcd(num, den);
    return {num / divisor, den / divisor};
}

/// Returns the mean rate over single-frame delays. Rounded, these are two neighbouring values;
/// longer ones are held frames.
Rational MeanRate(std::span<const std::int64_t> delays)
{
    const std::int64_t shortest = *std::ranges::min_element(delays);
    std::int64_t frames = 0;
    std::int64_t length = 0;
    for (const std::int64_t delay : delays)
    {
        frames += delay <= shortest + 1 ? 1 : 0;
        length += delay <= shortest + 1 ? delay : 0;
    }
    return Reduced(100 * frames, length);
}

/// True if frames start at multiples of the rate's period, rounded to 1/100 s. A part starts at a
/// rounded time, so a common offset is allowed.
bool Fits(const Rational& rate, std::span<const std::int64_t> delays)
{
    constexpr double kRounding = 1e-9; // of the divisions below
    std::int64_t time = 0;
    std::int64_t before = 0;
    double minimum = 0.0;
    double maximum = 0.0;
    for (const std::int64_t delay : delays)
    {
        time += delay;
        const std::int64_t periods = std::llround(double(time) * rate.ToDouble() / 100.0);
        const double off = double(periods) * 100.0 / rate.ToDouble() - double(time);
        minimum = std::min(minimum, off);
        maximum = std::max(maximum, off);
        if (periods <= before || maximum - minimum > 1.0 + kRounding)
        {
            return false;
        }
        before = periods;
    }
    return true;
}

/// Returns the rate nearest to `mean` that fits, if any.
std::optional<Rational> Nearest(std::span<const Rational> rates, const Rational& mean,
                                std::span<const std::int64_t> delays)
{
    const std::int64_t shortest = *std::ranges::min_element(delays);
    std::optional<Rational> best;
    for (const Rational& rate : rates)
    {
        const auto far = [&mean](const Rational& other) {
            return std::abs(other.ToDouble() - mean.ToDouble());
        };
        const bool isOneFrame = std::llround(double(shortest) * rate.ToDouble() / 100.0) == 1;
        if (isOneFrame && (!best || far(rate) < far(*best)) && Fits(rate, delays))
        {
            best = rate;
        }
    }
    return best;
}

} // namespace

Rational RateOfGif(std::span<const std::int64_t> delays)
{
    if (delays.empty())
    {
        return {1, 1};
    }
    const Rational mean = MeanRate(delays);
    if (100 * mean.den % mean.num == 0 && Fits(mean, delays)) // all single-frame delays are equal
    {
        return mean;
    }
    std::vector<Rational> whole; // up to one frame per 1/100 s, the shortest delay
    for (std::int64_t rate = 1; rate <= 100; ++rate)
    {
        whole.push_back({rate, 1});
    }
    constexpr Rational kTelevision[] = {{24000, 1001}, {30000, 1001}, {48000, 1001}, {60000, 1001}};
    const std::optional<Rational> best = Nearest(whole, mean, delays);
    return best ? *best : Nearest(kTelevision, mean, delays).value_or(mean);
}

} // namespace boxreel
