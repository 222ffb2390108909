// SPDX-License-Identifier: MIT
//
// Sine, cosine and arc tangent from additions, multiplications and divisions only, so that their
// bits do not depend on the C library. The angle is reduced to [-pi/4, pi/4] by subtracting quarter
// turns (Cody and Waite, Software Manual for the Elementary Functions, 1980). There the Taylor
// series converges fast.
#include "TaylorSeries.h"

#include <Box2D/Common/b2Math.h>

#include <limits>

namespace box2d
{
namespace
{

// pi/2 in three parts. The first two have 33 bits, so that their products with a count of quarter
// turns below 2^20 are exact in double precision.
constexpr double kQuarterHigh = 0x1.921fb544p+0;
constexpr double kQuarterMiddle = 0x1.0b4611a6p-34;
constexpr double kQuarterLow = 0x1.3198a2e037073p-69;
constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1; // 2/pi
constexpr double kTwoPi = 0x1.921fb54442d18p+2;
constexpr double kHalfPi = 0x1.921fb54442d18p+0;
constexpr double kLargest = 1.0e6; // maximum angle with an exact reduction

// Adding and subtracting this rounds a double to the nearest integer: above 2^52 adjacent doubles
// differ by one.
constexpr double kRounder = 0x1.8p+52;

struct Reduced
{
    double angle; // within about [-pi/4, pi/4]
    int quarter;  // 0 to 3: quarter turns subtracted
};

Reduced TakeQuarterTurnsOff(double angle)
{
    if (!(std::fabs(angle) <= kLargest))
    {
        // fmod is exact, so the bits are the same everywhere. The remainder of infinity is NaN,
        // which cannot be converted to an integer.
        angle = std::fmod(angle, kTwoPi);
        if (std::isnan(angle))
        {
            return {angle, 0};
        }
    }
    const double quarters = (angle * kQuartersPerRadian + kRounder) - kRounder;
    const double rest =
        ((angle - quarters * kQuarterHigh) - quarters * kQuarterMiddle) - quarters * kQuarterLow;
    return {rest, static_cast<int>(static_cast<std::int64_t>(quarters) & 3)};
}

// Returns 1 - x^2/3 + x^4/5 - ...
constexpr Series AlternatingInverseOdds()
{
    Series series = {{1.0}};
    for (int i = 1; i <= kMaxTerms; ++i)
    {
        series.of[i] = (i % 2 == 0 ? 1.0 : -1.0) / (2 * i + 1);
    }
    return series;
}

constexpr Series kArcTangentSeries = AlternatingInverseOdds();

template <int terms>
SineCosine<double> SineAndCosine(double angle)
{
    // Shortcut for bodies that never rotated. The series give the same.
    if (angle == 0.0)
    {
        return {angle, 1.0};
    }
    const Reduced r = TakeQuarterTurnsOff(angle);
    const double s = TaylorSine<terms>(r.angle);
    const double c = TaylorCosine<terms>(r.angle);
    const bool swap = (r.quarter & 1) != 0;
    const double first = swap ? c : s;
    const double second = swap ? s : c;
    return {(r.quarter & 2) != 0 ? -first : first, ((r.quarter + 1) & 2) != 0 ? -second : second};
}

// Returns the arc tangent of t in [0, 1]. Above tan(pi/8) the identity
//   atan(t) = pi/4 + atan((t - 1) / (t + 1))
// reduces the argument for the Taylor series t - t^3/3 + t^5/5 - ...
double ArcTangent(double t)
{
    constexpr double tanOfEighth = 0.41421356237309503;
    const bool large = t > tanOfEighth;
    const double x = large ? (t - 1.0) / (t + 1.0) : t;
    const double angle = x + x * Sum<1, kMaxTerms>(kArcTangentSeries, x * x);
    return large ? 0.5 * kHalfPi + angle : angle;
}

} // namespace
} // namespace box2d

// Six terms have an error of 1e-14, invisible after rounding to single precision.
box2d::SineCosine<float> box2d::SinCos(float angle)
{
    const auto x = static_cast<double>(angle);
    // Small rotations within a step: no reduction, and fewer terms suffice.
    const bool small = angle != 0.0f && std::fabs(angle) <= kSmallAngle;
    const SineCosine<double> exact =
        small ? SineCosine<double>{TaylorSine<kTermsOfSmall>(x), TaylorCosine<kTermsOfSmall>(x)}
              : SineAndCosine<6>(x);
    return {static_cast<float>(exact.sine), static_cast<float>(exact.cosine)};
}

// The ninth term is 1e-19 of the result.
box2d::SineCosine<double> box2d::SinCos(double angle)
{
    return SineAndCosine<9>(angle);
}

double box2d::Atan2(double y, double x)
{
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    if (std::isnan(x) || std::isnan(y))
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const bool steep = ay > ax;
    const double larger = steep ? ay : ax;
    const double smaller = steep ? ax : ay;
    // Equal sides, including infinite ones, have slope 1; two zeros count as slope 0.
    const double slope = larger == 0.0 ? 0.0 : (larger == smaller ? 1.0 : smaller / larger);
    double angle = ArcTangent(slope);
    angle = steep ? kHalfPi - angle : angle;
    angle = std::signbit(x) ? 2.0 * kHalfPi - angle : angle;
    return std::copysign(angle, y);
}
