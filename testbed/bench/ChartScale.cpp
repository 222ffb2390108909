// SPDX-License-Identifier: MIT
#include "ChartScale.h"

#include <algorithm>
#include <cassert>
#include <cstdio>

namespace boxreel
{
namespace
{

/// The largest of 1, 2, 5, 10, 20, … and of their tenths that is not above `value`.
double RoundBelow(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    const double share = value / decade * (1.0 + 1e-9);
    return decade * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

double RoundAbove(double value)
{
    const double below = RoundBelow(value);
    if (below >= value * (1.0 - 1e-9))
    {
        return below;
    }
    const double doubled = RoundBelow(2.0 * below);
    return doubled >= value * (1.0 - 1e-9) ? doubled : RoundBelow(2.5 * below);
}

} // namespace

ChartScale::ChartScale(const ChartAxis& axis, const std::vector<double>& values, double from,
                       double to)
    : m_logarithmic(axis.logarithmic), m_from(from), m_to(to)
{
    bool any = false;
    for (const double value : values)
    {
        if (std::isfinite(value))
        {
            assert(!m_logarithmic || value > 0.0);
            m_low = any ? std::min(m_low, value) : value;
            m_high = any ? std::max(m_high, value) : value;
            any = true;
        }
    }
    m_low = any ? m_low : 1.0;
    m_high = any ? m_high : 10.0;
    m_logarithmic ? MakeLogarithmic() : MakeLinear();
}

double ChartScale::At(double value) const
{
    const double share = m_logarithmic ? std::log(value / m_low) / std::log(m_high / m_low)
                                       : (value - m_low) / (m_high - m_low);
    return m_from + share * (m_to - m_from);
}

void ChartScale::MakeLinear()
{
    if (m_high <= m_low)
    {
        m_high = m_low + 1.0;
    }
    // Five to ten intervals.
    double step = RoundBelow((m_high - m_low) / 5.0);
    m_low = step * std::floor(m_low / step + 1e-9);
    m_high = step * std::ceil(m_high / step - 1e-9);
    const int count = int(std::lround((m_high - m_low) / step));
    for (int i = 0; i <= count; ++i)
    {
        const double value = m_low + step * i;
        m_ticks.push_back({value, ChartNumber(value)});
    }
}

void ChartScale::MakeLogarithmic()
{
    m_low = RoundBelow(m_low);
    m_high = RoundAbove(std::max(m_high, 2.0 * m_low));
    const double decades = std::log10(m_high / m_low);
    const int firstPower = int(std::floor(std::log10(m_low) + 1e-9));
    const int lastPower = int(std::floor(std::log10(m_high * 1.001)));
    for (int power = firstPower; power <= lastPower; ++power)
    {
        const double decade = std::pow(10.0, power);
        for (int digit = 1; digit <= 9; ++digit)
        {
            const double value = decade * digit;
            const bool isDense = digit != 1 && decades > 9.0; // thin lines would become a tint
            if (isDense || value < m_low * 0.999 || value > m_high * 1.001)
            {
                continue;
            }
            // Few decades have room for more numbers.
            const bool named = digit == 1 || (decades < 3.5 && (digit == 2 || digit == 5));
            m_ticks.push_back({value, named ? ChartPower(value) : ""});
        }
    }
}

std::string ChartPower(double value)
{
    const double exponent = value > 0.0 ? std::log10(value) : 0.0;
    const int power = int(std::lround(exponent));
    if (std::abs(exponent - power) > 1e-9 || (power > -5 && power < 6))
    {
        return ChartNumber(value);
    }
    static constexpr const char* kRaised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                              "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = power < 0 ? "10\u207b" : "10";
    for (const char digit : std::to_string(std::abs(power)))
    {
        text += kRaised[digit - '0'];
    }
    return text;
}

std::string ChartNumber(double value)
{
    char digits[64];
    if (std::abs(value) < 1000.0)
    {
        std::snprintf(digits, sizeof digits, "%.4g", std::abs(value) < 1e-12 ? 0.0 : value);
        return digits;
    }
    std::snprintf(digits, sizeof digits, "%.0f", value);
    std::string text = digits;
    const std::size_t first = text.front() == '-' ? 1 : 0;
    for (std::size_t at = text.size(); at > first + 3;)
    {
        at -= 3;
        text.insert(at, 1, ',');
    }
    return text;
}

} // namespace boxreel
