// SPDX-License-Identifier: MIT
#include "RigidFit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kQuantum = 1e-5;      // [m]
constexpr double kTolerance = 1.25e-5; // rounding of place and angle [m]

const RigidForm kBar{{{-1.0, -0.25}, {1.0, -0.25}, {1.0, 0.25}, {-1.0, 0.25}}, kQuantum};

std::vector<PagePoint> Turned(const RigidForm& form, double x, double y, double angle)
{
    std::vector<PagePoint> points;
    for (const PagePoint p : form.points)
    {
        points.push_back({x + std::cos(angle) * p.x - std::sin(angle) * p.y,
                          y + std::sin(angle) * p.x + std::cos(angle) * p.y});
    }
    return points;
}

TEST(RigidFit, FindsPlaceAndAngle)
{
    const auto place = FitPlace(kBar, Turned(kBar, 3.0, -2.0, 0.7), kQuantum, 0, kTolerance);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->x, 300'000);
    EXPECT_EQ(place->y, -200'000);
    EXPECT_EQ(place->angle, 70'000);
}

TEST(RigidFit, CountsTurnsFromTheGuess)
{
    const auto place =
        FitPlace(kBar, Turned(kBar, 0.0, 0.0, 20.0), kQuantum, 1'990'000, kTolerance);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->angle, 2'000'000);
}

TEST(RigidFit, RefusesPointsThatDoNotMoveRigidly)
{
    std::vector<PagePoint> points = Turned(kBar, 3.0, -2.0, 0.7);
    points[2].x += 1e-4;
    EXPECT_FALSE(FitPlace(kBar, points, kQuantum, 0, kTolerance));
    points.pop_back();
    EXPECT_FALSE(FitPlace(kBar, points, kQuantum, 0, kTolerance));
}

} // namespace
} // namespace boxreel
