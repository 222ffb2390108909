// SPDX-License-Identifier: MIT
#include <debugdraw/FollowCamera.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace boxreel;

namespace
{

constexpr double kStep = 1.0 / 60.0; // [s]
constexpr double kHeight = 10.0;     // of the view [m]
constexpr double kCalm = 0.4;        // [m], of such a view
constexpr double kRounding = 1e-6;   // boxes are floats

Rect BoxAt(double x, double y, double half = 0.5)
{
    return {{static_cast<float>(x - half), static_cast<float>(y - half)},
            {static_cast<float>(x + half), static_cast<float>(y + half)}};
}

double HeightOf(const Camera& camera)
{
    return camera.height / camera.pixelsPerMeter;
}

bool Shows(const Camera& camera, const Rect& box)
{
    const double halfHeight = 0.5 * HeightOf(camera) + kRounding;
    const double halfWidth = halfHeight * camera.width / camera.height;
    return box.lower.x >= camera.centerX - halfWidth && box.upper.x <= camera.centerX + halfWidth &&
           box.lower.y >= camera.centerY - halfHeight && box.upper.y <= camera.centerY + halfHeight;
}

// A body that is pushed about, jerks, and is carried off at times.
struct Wanderer
{
    double x = 0.0, y = 10.0, vx = 0.0, vy = 0.0;
    void Move(std::mt19937& random)
    {
        std::uniform_real_distribution<double> push(-90.0, 90.0);
        vx = 0.98 * vx + push(random) * kStep;
        vy = 0.98 * vy + push(random) * kStep;
        if (random() % 100 == 0)
        {
            vx *= -6.0;
        }
        x += vx * kStep;
        y += vy * kStep;
    }
};

} // namespace

TEST(FollowCamera, StartsWithTheSubjectInTheMiddle)
{
    const FollowCamera camera(1280, 720, BoxAt(30.0, -5.0), kHeight);
    EXPECT_EQ(camera.View().centerX, 30.0);
    EXPECT_EQ(camera.View().centerY, -5.0);
    EXPECT_EQ(camera.View().pixelsPerMeter, 72.0);
}

TEST(FollowCamera, StaysBitForBitStillWhenABoxTwitches)
{
    for (const std::optional<double> height : {std::optional<double>(0.5), std::optional(kHeight),
                                               std::optional(200.0), std::optional<double>()})
    {
        FollowCamera camera(1280, 720, BoxAt(3.0, 4.0), height);
        const Camera start = camera.View();
        std::mt19937 random(4);
        std::uniform_real_distribution<double> twitch(-0.0199, 0.0199); // [m]
        for (int step = 0; step < 500; ++step)
        {
            camera.Update(BoxAt(3.0 + twitch(random), 4.0 + twitch(random),
                                0.5 + 0.5 * std::abs(twitch(random))),
                          kStep);
            ASSERT_EQ(camera.View(), start) << "step " << step;
        }
    }
}

TEST(FollowCamera, StaysAtRestWhenBoxMovesSlightly)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-50.0, 50.0);
    std::uniform_real_distribution<double> twitch(-0.02, 0.02);
    for (int i = 0; i < 50; ++i)
    {
        FollowCamera camera(1280, 720, BoxAt(0.0, 0.0), kHeight);
        const double x = place(random);
        const double y = place(random);
        const auto shake = [&] {
            camera.Update(BoxAt(x + twitch(random), y + twitch(random)), kStep);
        };
        for (int step = 0; step < 240; ++step)
        {
            shake();
        }
        EXPECT_NEAR(camera.View().centerX, x, kCalm + 0.02);
        EXPECT_NEAR(camera.View().centerY, y, kCalm + 0.02);
        const Camera rest = camera.View();
        for (int step = 0; step < 240; ++step)
        {
            shake();
        }
        // Only a twitch farther than any before moves it, by less than the whole shaking.
        EXPECT_LT(std::abs(camera.View().centerX - rest.centerX) * rest.pixelsPerMeter, 1.0);
        EXPECT_LT(std::abs(camera.View().centerY - rest.centerY) * rest.pixelsPerMeter, 1.0);
    }
}

TEST(FollowCamera, DoesNotGoBeyondABodyThatStops)
{
    for (const double speed : {0.5, 5.0, 50.0, 500.0}) // [m/s]
    {
        FollowCamera camera(1280, 720, BoxAt(0.0, 0.0), kHeight);
        double before = 0.0;
        for (int step = 1; step <= 600; ++step)
        {
            const double x = speed * kStep * std::min(step, 120);
            camera.Update(BoxAt(x, 0.0), kStep);
            ASSERT_GE(camera.View().centerX, before) << "turns back at " << speed << " m/s";
            ASSERT_LE(camera.View().centerX, x + kRounding * speed);
            if (step > 120 && step < 130 && speed > 1.0)
            {
                ASSERT_GT(camera.View().centerX, before) << "hesitates at " << speed << " m/s";
            }
            before = camera.View().centerX;
        }
        const double end = speed * 2.0;
        EXPECT_NEAR(before, end, std::min(kCalm, end) + kRounding * end);
    }
}

TEST(FollowCamera, KeepsSubjectInFrameAndCentreInItsBounds)
{
    const int sizes[][2] = {{1280, 720}, {720, 1280}, {333, 333}, {8191, 4321}};
    for (std::uint32_t seed = 0; seed < 40; ++seed)
    {
        std::mt19937 random(seed);
        const auto& size = sizes[seed % 4];
        Wanderer body;
        Rect been{{0.0f, 10.0f}, {0.0f, 10.0f}};
        const bool resizes = seed % 3 == 0;
        FollowCamera camera(size[0], size[1], BoxAt(0.0, 10.0),
                            resizes ? std::nullopt : std::optional(kHeight));
        for (int step = 0; step < 600; ++step)
        {
            body.Move(random);
            const Rect box = BoxAt(body.x, body.y);
            been.Include(Vec2{static_cast<float>(body.x), static_cast<float>(body.y)});
            camera.Update(box, kStep);
            const Camera& view = camera.View();
            ASSERT_TRUE(Shows(view, box)) << "step " << step << " of seed " << seed;
            ASSERT_GE(view.centerX, been.lower.x - 1e-4);
            ASSERT_LE(view.centerX, been.upper.x + 1e-4);
            ASSERT_GE(view.centerY, been.lower.y - 1e-4);
            ASSERT_LE(view.centerY, been.upper.y + 1e-4);
        }
        EXPECT_GT(been.upper.x - been.lower.x, 10.0f) << "it went somewhere";
    }
}

TEST(FollowCamera, StartsAndStopsSoftly)
{
    FollowCamera camera(1280, 720, BoxAt(0.0, 0.0), kHeight);
    double before = 0.0;
    double speedBefore = 0.0;
    for (int step = 1; step <= 300; ++step)
    {
        camera.Update(BoxAt(3.0 * kStep * std::min(step, 120), 0.0), kStep);
        const double speed = (camera.View().centerX - before) / kStep;
        ASSERT_LE(std::abs(speed - speedBefore), 0.45) << "of 3 m/s in step " << step;
        before = camera.View().centerX;
        speedBefore = speed;
    }
    EXPECT_EQ(speedBefore, 0.0) << "comes to rest";
}

TEST(FollowCamera, ShowsSameViewAtSameStepForAnyFrameRate)
{
    const auto viewsOf = [](int stepsPerFrame) {
        FollowCamera camera(1280, 720, BoxAt(0.0, 10.0), kHeight);
        std::mt19937 random(9);
        Wanderer body;
        std::vector<Camera> frames;
        for (int step = 0; step < 600; ++step)
        {
            if (step % stepsPerFrame == 0)
            {
                frames.push_back(camera.View());
            }
            body.Move(random);
            camera.Update(BoxAt(body.x, body.y), kStep);
        }
        return frames;
    };
    const std::vector<Camera> everyStep = viewsOf(1);
    const std::vector<Camera> everyFifth = viewsOf(5);
    ASSERT_NE(everyStep.front(), everyStep.back());
    for (std::size_t i = 0; i < everyFifth.size(); ++i)
    {
        EXPECT_EQ(everyFifth[i], everyStep[5 * i]);
    }
}

TEST(FollowCamera, MovesAlikeAtAnyStepLength)
{
    const auto wayInATenthOfASecond = [](int hertz) {
        FollowCamera camera(1280, 720, BoxAt(0.0, 0.0), kHeight);
        for (int step = 1; step <= hertz / 10; ++step)
        {
            camera.Update(BoxAt(2.0, 0.0), 1.0 / hertz);
        }
        return camera.View().centerX;
    };
    const double way = wayInATenthOfASecond(10000);
    // A critically damped spring whose low-passes take T each: 1 - (1 + t/T) exp(-t/T).
    const double t = 0.1 / 0.12;
    EXPECT_NEAR(way, (2.0 - kCalm) * (1.0 - (1.0 + t) * std::exp(-t)), 1e-3);
    EXPECT_NEAR(wayInATenthOfASecond(1000), way, 0.01 * way);
    EXPECT_NEAR(wayInATenthOfASecond(240), way, 0.04 * way);
    EXPECT_NEAR(wayInATenthOfASecond(60), way, 0.15 * way);
}

TEST(FollowCamera, TakesTheHeightThatItsSubjectNeedsWithAMargin)
{
    const Rect subject{{-10.0f, 0.0f}, {10.0f, 4.0f}};
    FollowCamera camera(1000, 1000, subject);
    EXPECT_EQ(camera.View(), FitTo(subject, 1000, 1000, 0.15));
    const Rect wider{{-30.0f, 0.0f}, {10.0f, 4.0f}};
    for (int step = 0; step < 300; ++step)
    {
        camera.Update(wider, kStep);
        ASSERT_TRUE(Shows(camera.View(), wider)) << "at once";
    }
    const double grown = HeightOf(camera.View());
    EXPECT_GT(grown, 40.0 * 1.15) << "a margin is left";
    for (int step = 0; step < 300; ++step)
    {
        camera.Update(subject, kStep);
    }
    EXPECT_LT(HeightOf(camera.View()), 0.9 * grown) << "and returns";
    EXPECT_GT(HeightOf(camera.View()), 20.0 * 1.15);
}

TEST(FollowCamera, KeepsItsHeightWhileASquareRolls)
{
    FollowCamera camera(1280, 720, BoxAt(0.0, 0.0, 2.0));
    double height = 0.0;
    for (int step = 0; step < 600; ++step)
    {
        const double angle = 2.0 * 3.14159265358979 * step / 160.0; // reaches 45 degrees
        const double half = 2.0 * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
        camera.Update(BoxAt(0.0, 0.0, half), kStep);
        if (step == 200) // more than a quarter turn
        {
            height = HeightOf(camera.View());
        }
        if (step >= 200)
        {
            ASSERT_NEAR(HeightOf(camera.View()), height, 1e-6) << "breathes in step " << step;
        }
    }
}

TEST(FollowCamera, IgnoresInvalidSubjects)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    FollowCamera camera(1280, 720, BoxAt(3.0, 4.0), kHeight);
    const Camera start = camera.View();
    for (const Rect& none : {Rect{}, Rect{{nan, nan}, {nan, nan}}, Rect{{-inf, 0.0f}, {inf, 1.0f}}})
    {
        camera.Update(none, kStep);
        EXPECT_EQ(camera.View(), start);
    }
    camera.Update(BoxAt(6.0, 4.0), kStep);
    for (int step = 0; step < 300; ++step)
    {
        camera.Update(Rect{}, kStep);
    }
    EXPECT_NEAR(camera.View().centerX, 6.0 - kCalm, kRounding) << "settles where it was going";
    FollowCamera lost(1280, 720, Rect{});
    EXPECT_EQ(lost.View(), Camera());
    lost.Update(BoxAt(0.0, 21.0), kStep);
    EXPECT_TRUE(Shows(lost.View(), BoxAt(0.0, 21.0))) << "and finds one that comes";
}

TEST(FollowCamera, StandsStillWhenNoTimePasses)
{
    FollowCamera camera(1280, 720, BoxAt(0.0, 0.0), kHeight);
    const Camera start = camera.View();
    camera.Update(BoxAt(1.0, 0.0), 0.0);
    EXPECT_EQ(camera.View(), start);
}
