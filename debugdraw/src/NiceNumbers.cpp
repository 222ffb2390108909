// SPDX-License-Identifier: MIT
#include <debugdraw/NiceNumbers.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace boxreel
{
namespace
{

// Powers of ten up to this are exact; larger numbers are not drawn.
constexpr int kMaxDigits = 22;

// Difference of two computations of the same number.
constexpr double kRounding = 1e-9;

double PowerOfTen(int exponent)
{
    double power = 1.0;
    for (int i = 0; i < std::abs(exponent); ++i)
    {
        power *= 10.0;
    }
    return exponent < 0 ? 1.0 / power : power;
}

/// Returns 1, 2, 5, 10, 20, … for 0, 1, 2, 3, 4, …; below 1 for negative indices.
double NiceNumber(int index)
{
    constexpr std::array<double, 3> kLeading{1.0, 2.0, 5.0};
    const int place = ((index % 3) + 3) % 3;
    const int exponent = (index - place) / 3;
    const double leading = kLeading[static_cast<std::size_t>(place)];
    // A single division, so that 0.2 is the double nearest to 0.2.
    return exponent < 0 ? leading / PowerOfTen(-exponent) : leading * PowerOfTen(exponent);
}

std::string Fixed(double value, int decimals)
{
    std::array<char, 400> digits; // the largest double has 309
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    std::string text(digits.data(), end);
    const bool isZero = text.find_first_not_of("-0.") == std::string::npos;
    return isZero && text.front() == '-' ? text.substr(1) : text;
}

} // namespace

double NiceBelow(double limit)
{
    assert(limit > 0.0 && std::isfinite(limit));
    int index = -3 * kMaxDigits;
    while (index < 3 * kMaxDigits && NiceNumber(index + 1) <= limit * (1.0 + kRounding))
    {
        ++index;
    }
    return NiceNumber(index);
}

double NiceAbove(double limit)
{
    assert(limit > 0.0 && std::isfinite(limit));
    int index = 3 * kMaxDigits;
    while (index > -3 * kMaxDigits && NiceNumber(index - 1) >= limit * (1.0 - kRounding))
    {
        --index;
    }
    return NiceNumber(index);
}

std::string NumberBy(double value, double step)
{
    int decimals = 0;
    while (decimals < kMaxDigits && step * PowerOfTen(decimals) < 1.0 - kRounding)
    {
        ++decimals;
    }
    return Fixed(value, decimals);
}

std::string NumberMeasured(double value)
{
    int decimals = 2;
    for (double limit = 10.0; decimals > 0 && std::abs(value) >= limit; limit *= 10.0)
    {
        --decimals;
    }
    for (double limit = 1.0;
         decimals >= 2 && decimals < 6 && value != 0.0 && std::abs(value) < limit; limit /= 10.0)
    {
        ++decimals;
    }
    return Fixed(value, decimals);
}

std::string NumberPlain(double value)
{
    std::string text = Fixed(value, 3);
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
    return text;
}

} // namespace boxreel
