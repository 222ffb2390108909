// SPDX-License-Identifier: MIT
#include <debugdraw/CameraPath.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

using namespace boxreel;

namespace
{

double HeightOf(const Camera& camera)
{
    return camera.height / camera.pixelsPerMeter;
}

CameraPath InAndOut()
{
    return CameraPath(1280, 720,
                      {{0.0, 0.0, 20.0, 50.0}, {3.0, 10.0, 5.0, 12.0}, {6.0, 0.0, 20.0, 50.0}});
}

std::vector<CameraKey> RandomKeys(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<CameraKey> keys(2 + random() % 5);
    double time = 0.0;
    for (CameraKey& key : keys)
    {
        time += 0.1 + 3.0 * unit(random);
        key = {time, 200.0 * unit(random) - 100.0, 200.0 * unit(random) - 100.0,
               0.1 + 100.0 * unit(random) * unit(random)};
    }
    return keys;
}

} // namespace

TEST(CameraPath, ShowsEachKeyAtItsTime)
{
    const CameraPath path = InAndOut();
    const Camera middle = path.At(3.0);
    EXPECT_EQ(middle.centerX, 10.0);
    EXPECT_EQ(middle.centerY, 5.0);
    EXPECT_EQ(middle.pixelsPerMeter, 60.0);
    EXPECT_EQ(middle.width, 1280);
    EXPECT_EQ(middle.height, 720);
    EXPECT_EQ(path.At(0.0), Camera());
}

TEST(CameraPath, StandsStillBeforeTheFirstKeyAndAfterTheLast)
{
    const CameraPath path(1280, 720, {{1.0, 0.0, 0.0, 50.0}, {2.0, 5.0, 5.0, 20.0}});
    EXPECT_EQ(path.At(0.0), path.At(1.0));
    EXPECT_EQ(path.At(2.0), path.At(1e6));
    EXPECT_NE(path.At(0.0), path.At(2.0));
}

TEST(CameraPath, ZoomsByConstantFactorPerShareOfThePath)
{
    const CameraPath path(1280, 720, {{0.0, 0.0, 0.0, 100.0}, {1.0, 0.0, 0.0, 1.0}});
    EXPECT_NEAR(HeightOf(path.At(0.5)), 10.0, 1e-12);
    for (int i = 0; i <= 1000; ++i)
    {
        const double t = i / 1000.0;
        const double eased = t * t * (3.0 - 2.0 * t);
        const double expected = 100.0 * std::pow(0.01, eased);
        ASSERT_NEAR(HeightOf(path.At(t)), expected, 1e-12 * expected) << "at " << t << " s";
    }
}

TEST(CameraPath, KeepsOnePointOfTheWorldInItsPlaceWhileItZooms)
{
    const Camera from = InAndOut().At(0.0);
    const Camera to = InAndOut().At(3.0);
    // The point at which (x - centre) / height is the same in both.
    const double share = HeightOf(from) / (HeightOf(from) - HeightOf(to));
    const double x = from.centerX + share * (to.centerX - from.centerX);
    const double place = (x - from.centerX) * from.pixelsPerMeter;
    for (int i = 1; i <= 300; ++i)
    {
        const Camera now = InAndOut().At(i / 100.0);
        ASSERT_NEAR((x - now.centerX) * now.pixelsPerMeter, place, 1e-9) << "pixels";
    }
}

TEST(CameraPath, PansWhereTheHeightsAreTheSameOrNearly)
{
    for (const double height :
         {50.0, 50.0 * (1.0 + 1e-13), 50.0 * (1.0 + 1e-9), 50.0 * (1.0 + 1e-5)})
    {
        const CameraPath path(1280, 720, {{0.0, -10.0, 0.0, 50.0}, {1.0, 10.0, 0.0, height}});
        EXPECT_NEAR(path.At(0.5).centerX, 0.0, 1e-4);
        EXPECT_NEAR(path.At(0.25).centerX, -10.0 + 20.0 * 0.15625, 1e-4);
    }
}

TEST(CameraPath, StaysBetweenKeys)
{
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i)
    {
        const std::vector<CameraKey> keys = RandomKeys(random);
        const CameraPath path(1280, 720, keys);
        for (std::size_t k = 0; k + 1 < keys.size(); ++k)
        {
            const CameraKey& a = keys[k];
            const CameraKey& b = keys[k + 1];
            double before = 0.0;
            for (int step = 0; step <= 50; ++step)
            {
                const Camera now = path.At(a.time + (b.time - a.time) * step / 50.0);
                const double way = (now.centerX - a.centerX) / (b.centerX - a.centerX);
                ASSERT_GE(way, before - 1e-9);
                ASSERT_LE(way, 1.0 + 1e-9);
                ASSERT_GE(HeightOf(now), std::min(a.height, b.height) * (1.0 - 1e-12));
                ASSERT_LE(HeightOf(now), std::max(a.height, b.height) * (1.0 + 1e-12));
                before = way;
            }
        }
    }
}

TEST(CameraPath, LeavesAndReachesAKeyAtRest)
{
    const CameraPath path = InAndOut();
    const double moment = 1e-4; // [s]
    for (const double time : {0.0, 3.0, 6.0})
    {
        const double pixels = 720.0 / 12.0;
        EXPECT_LT(std::abs(path.At(time + moment).centerX - path.At(time).centerX) * pixels, 1e-4);
        EXPECT_LT(std::abs(path.At(time - moment).centerX - path.At(time).centerX) * pixels, 1e-4);
    }
    EXPECT_GT(std::abs(path.At(1.5 + moment).centerX - path.At(1.5).centerX), 1e-4);
}

TEST(CameraPath, IsTheSamePathBackwards)
{
    const CameraPath path = InAndOut();
    for (double t = 0.0; t < 3.0; t += 0.1)
    {
        EXPECT_NEAR(path.At(t).centerX, path.At(6.0 - t).centerX, 1e-9);
        EXPECT_NEAR(path.At(t).pixelsPerMeter, path.At(6.0 - t).pixelsPerMeter, 1e-9);
    }
}

TEST(CameraPath, ReportsInvalidKeys)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const CameraKey a{0.0, 0.0, 0.0, 50.0};
    const CameraKey b{1.0, 0.0, 0.0, 50.0};
    EXPECT_EQ(WhyNotPath({a, b}), "");
    for (const std::vector<CameraKey>& few : {std::vector<CameraKey>{}, {a}})
    {
        EXPECT_EQ(WhyNotPath(few), WhyNotPath({}));
    }
    for (const std::vector<CameraKey>& wrong : {std::vector{b, a}, {a, a}, {a, b, b}, {a, b, a}})
    {
        EXPECT_EQ(WhyNotPath(wrong), WhyNotPath({b, a}));
    }
    for (const CameraKey& bad : {CameraKey{nan, 0.0, 0.0, 1.0}, CameraKey{1.0, inf, 0.0, 1.0},
                                 CameraKey{1.0, 0.0, nan, 1.0}, CameraKey{1.0, 0.0, 0.0, inf},
                                 CameraKey{1.0, 0.0, 0.0, 0.0}, CameraKey{1.0, 0.0, 0.0, -5.0}})
    {
        EXPECT_EQ(WhyNotPath({a, bad}), WhyNotPath({bad, b}));
    }
    const std::set<std::string> reasons{"", WhyNotPath({}), WhyNotPath({b, a}),
                                        WhyNotPath({a, CameraKey{1.0, inf, 0.0, 1.0}})};
    EXPECT_EQ(reasons.size(), 4u) << "each has its own";
}
