// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace
{
// Returns the distance of `actual` from the exact value in units in the last place.
template <typename Real>
long double Ulps(Real actual, long double exact)
{
    int exponent;
    std::frexp(exact, &exponent);
    const int lowest = std::numeric_limits<Real>::min_exponent;
    exponent = exponent < lowest ? lowest : exponent;
    const long double ulp = std::ldexp(1.0L, exponent - std::numeric_limits<Real>::digits);
    return std::fabs(static_cast<long double>(actual) - exact) / ulp;
}

template <typename Real>
long double WorstSinCosError(float reach, int count)
{
    Random random(7);
    long double worst = 0.0L;
    for (int i = 0; i < count; ++i)
    {
        const Real angle = static_cast<Real>(random.Real(-reach, reach)) +
                           static_cast<Real>(random.Real(-1.0e-6f, 1.0e-6f));
        const auto [s, c] = box2d::SinCos(angle);
        worst = std::max(worst, Ulps(s, std::sin(static_cast<long double>(angle))));
        worst = std::max(worst, Ulps(c, std::cos(static_cast<long double>(angle))));
    }
    return worst;
}
} // namespace

TEST(SinCos, IsWithinTheStatedUlpsInSinglePrecision)
{
    EXPECT_LE(WorstSinCosError<float>(1.0f, 200000), 0.51L);
    EXPECT_LE(WorstSinCosError<float>(10.0f, 200000), 0.51L);
    EXPECT_LE(WorstSinCosError<float>(1.0e6f, 200000), 0.51L);
}

TEST(SinCos, IsWithinTheStatedUlpsInDoublePrecision)
{
    EXPECT_LE(WorstSinCosError<double>(1.0f, 200000), 3.0L);
    EXPECT_LE(WorstSinCosError<double>(10.0f, 200000), 3.0L);
    EXPECT_LE(WorstSinCosError<double>(1.0e6f, 200000), 3.0L);
}

TEST(SinCos, IsExactAtZeroAndAccurateAtQuarterTurns)
{
    for (const float zero : {0.0f, -0.0f})
    {
        const auto [s, c] = box2d::SinCos(zero);
        EXPECT_EQ(s, 0.0f);
        EXPECT_EQ(std::signbit(s), std::signbit(zero));
        EXPECT_EQ(c, 1.0f);
    }
    for (int quarter = -4000; quarter <= 4000; ++quarter)
    {
        const double angle = quarter * 1.5707963267948966;
        const auto [sd, cd] = box2d::SinCos(angle);
        EXPECT_LE(Ulps(sd, std::sin(static_cast<long double>(angle))), 3.0L) << quarter;
        EXPECT_LE(Ulps(cd, std::cos(static_cast<long double>(angle))), 3.0L) << quarter;
    }
}

TEST(SinCos, StaysOnUnitCircleForHugeAnglesAndIsNanForInfinite)
{
    for (const float angle : {1.0e7f, -3.0e12f, 3.0e38f})
    {
        const auto [s, c] = box2d::SinCos(angle);
        EXPECT_NEAR(s * s + c * c, 1.0f, 1.0e-6f) << angle;
    }
    for (const float angle :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
    {
        const auto [s, c] = box2d::SinCos(angle);
        EXPECT_TRUE(std::isnan(s) && std::isnan(c));
    }
}

// A hash of many results, to detect another compiler or optimisation level with different results.
TEST(SinCos, HasTheSameBitsEverywhere)
{
    Random random(99);
    std::uint64_t hash = 1469598103934665603u;
    for (int i = 0; i < 100000; ++i)
    {
        const auto [s, c] = box2d::SinCos(static_cast<double>(random.Real(-100.0f, 100.0f)));
        const double angle = box2d::Atan2(s + 0.25, c);
        for (const double value : {s, c, angle})
        {
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
        }
    }
    EXPECT_EQ(hash, 8363363452426017405u);
}

TEST(Atan2, IsWithinThreeUlpsInAllQuadrants)
{
    Random random(8);
    long double worst = 0.0L;
    for (int i = 0; i < 200000; ++i)
    {
        const double x = random.Real(-3.0f, 3.0f);
        const double y = random.Real(-3.0f, 3.0f) * (i % 3 == 0 ? 1.0e-4f : 1.0f);
        const long double exact =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        worst = std::max(worst, Ulps(box2d::Atan2(y, x), exact));
    }
    EXPECT_LE(worst, 3.0L);
}

TEST(Atan2, HasTheSpecialCasesOfTheStandardLibrary)
{
    const double inf = std::numeric_limits<double>::infinity();
    for (const double y : {0.0, -0.0, 1.0, -1.0, inf, -inf})
    {
        for (const double x : {0.0, -0.0, 1.0, -1.0, inf, -inf})
        {
            const double actual = box2d::Atan2(y, x);
            EXPECT_DOUBLE_EQ(actual, std::atan2(y, x)) << y << " " << x;
            EXPECT_EQ(std::signbit(actual), std::signbit(std::atan2(y, x))) << y << " " << x;
        }
    }
    EXPECT_TRUE(std::isnan(box2d::Atan2(std::nan(""), 1.0)));
}

TEST(Rotation, ReturnsItsAngle)
{
    for (float angle = -3.1f; angle < 3.1f; angle += 0.01f)
    {
        EXPECT_NEAR(b2Rot(angle).GetAngle(), angle, 3.0e-7f);
    }
}
