// SPDX-License-Identifier: MIT
#pragma once

#include "Simd.h"

/// Taylor series of sine and cosine, summed with the smallest terms first. They have no external
/// linkage, because sources of every instruction set include them.
namespace box2d
{
namespace
{

constexpr int kMaxTerms = 20;

/// Element i is the coefficient of x^(2 i).
struct Series
{
    double of[kMaxTerms + 1];
};

/// Returns 1 - x^2/2! + x^4/4! - ... with first = 0, 1 - x^2/3! + x^4/5! - ... with first = 1.
constexpr Series AlternatingInverseFactorials(int first)
{
    Series series = {{1.0}};
    for (int i = 1; i <= kMaxTerms; ++i)
    {
        series.of[i] = -series.of[i - 1] / ((2 * i + first) * (2 * i + first - 1));
    }
    return series;
}

constexpr Series kCosineSeries = AlternatingInverseFactorials(0);
constexpr Series kSineSeries = AlternatingInverseFactorials(1);

/// Returns the sum of the terms from x^(2 first) to x^(2 last).
template <int first, int last>
BOX2D_INLINE double Sum(const Series& series, double x2)
{
    double sum = series.of[last];
    for (int i = last - 1; i >= first; --i)
    {
        sum = series.of[i] + x2 * sum;
    }
    for (int i = 0; i < first; ++i)
    {
        sum *= x2;
    }
    return sum;
}

template <int terms>
BOX2D_INLINE double TaylorSine(double x)
{
    return x + x * Sum<1, terms>(kSineSeries, x * x);
}

template <int terms>
BOX2D_INLINE double TaylorCosine(double x)
{
    // Computes 1 - x^2/2 separately and adds its rounding error.
    const double x2 = x * x;
    const double half = 0.5 * x2;
    const double head = 1.0 - half;
    return head + (((1.0 - head) - half) + Sum<2, terms>(kCosineSeries, x2));
}

/// Up to this angle [rad] a few terms suffice: x^9/9! and x^8/8! have an error of 1e-15.
constexpr float kSmallAngle = 0.125f;
constexpr int kTermsOfSmall = 4;

} // namespace
} // namespace box2d
