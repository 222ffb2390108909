// SPDX-License-Identifier: MIT
#include <debugdraw/Camera.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace boxreel;

namespace
{

constexpr double kStep = 1.0 / 60.0; // [s]
const Rect kScene{{-10.0f, 0.0f}, {10.0f, 20.0f}};

Rect BoxAt(double x, double y, double half = 0.5)
{
    return {{static_cast<float>(x - half), static_cast<float>(y - half)},
            {static_cast<float>(x + half), static_cast<float>(y + half)}};
}

// Edges of the view in metres, without the rounding of VisibleArea.
struct Edges
{
    explicit Edges(const Camera& camera)
        : left(camera.centerX - 0.5 * camera.width / camera.pixelsPerMeter),
          right(camera.centerX + 0.5 * camera.width / camera.pixelsPerMeter),
          bottom(camera.centerY - 0.5 * camera.height / camera.pixelsPerMeter),
          top(camera.centerY + 0.5 * camera.height / camera.pixelsPerMeter)
    {}
    bool Holds(const Rect& box) const
    {
        return box.lower.x >= left && box.upper.x <= right && box.lower.y >= bottom &&
               box.upper.y <= top;
    }
    // Returns the distance of the nearest edge outside `inner`; negative when `inner` extends
    // beyond it [m].
    double Beyond(const Edges& inner) const
    {
        return std::min(std::min(inner.left - left, right - inner.right),
                        std::min(inner.bottom - bottom, top - inner.top));
    }
    double left, right, bottom, top;
};

// A body with random pushes that changes its direction suddenly.
struct Wanderer
{
    double x = 0.0, y = 10.0, vx = 0.0, vy = 0.0;
    void Move(std::mt19937& random)
    {
        std::uniform_real_distribution<double> push(-60.0, 60.0);
        vx = 0.98 * vx + push(random) * kStep;
        vy = 0.98 * vy + push(random) * kStep;
        if (random() % 200 == 0)
        {
            vx *= -8.0;
        }
        x += vx * kStep;
        y += vy * kStep;
    }
};

} // namespace

TEST(FitCamera, StartsAtTheViewOfTheWholeScene)
{
    FitCamera camera(1280, 720, kScene);
    EXPECT_EQ(camera.View(), FitTo(kScene, 1280, 720));
    camera.Update({BoxAt(0.0, 10.0)}, kStep);
    EXPECT_EQ(camera.View(), FitTo(kScene, 1280, 720));
}

TEST(FitCamera, KeepsEveryMovingBodyInViewAndOnlyEverGrows)
{
    const int sizes[][2] = {{1280, 720}, {720, 1280}, {333, 333}, {8192, 16}};
    int checked = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed)
    {
        std::mt19937 random(seed);
        const auto& size = sizes[seed % 4];
        FitCamera camera(size[0], size[1], kScene);
        const Edges home(camera.View());
        const double reachX = home.right - home.left; // the neighbourhood goes that far beyond
        const double reachY = home.top - home.bottom;
        std::vector<Wanderer> bodies(6);
        std::vector<Rect> boxes(bodies.size());
        for (int step = 0; step < 600; ++step)
        {
            for (std::size_t i = 0; i < bodies.size(); ++i)
            {
                bodies[i].Move(random);
                boxes[i] = BoxAt(bodies[i].x, bodies[i].y);
            }
            const Edges before(camera.View());
            camera.Update(boxes, kStep);
            const Edges after(camera.View());
            ASSERT_GE(after.Beyond(before), -1e-9)
                << "shrinks in step " << step << " of seed " << seed;
            for (const Rect& box : boxes)
            {
                const bool isNear =
                    box.lower.x > home.left - reachX && box.upper.x < home.right + reachX &&
                    box.lower.y > home.bottom - reachY && box.upper.y < home.top + reachY;
                checked += isNear ? 1 : 0;
                ASSERT_TRUE(!isNear || after.Holds(box)) << "step " << step << " of seed " << seed;
            }
            const double aspect = double(size[0]) / size[1];
            ASSERT_NEAR((after.right - after.left) / (after.top - after.bottom), aspect,
                        1e-9 * aspect);
        }
    }
    EXPECT_GT(checked, 50000);
}

TEST(FitCamera, StaysBitForBitStillWhenABoxTwitchesInside)
{
    FitCamera camera(1280, 720, kScene);
    const Camera start = camera.View();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> twitch(-0.5, 0.5);
    for (int step = 0; step < 500; ++step)
    {
        camera.Update(
            {BoxAt(9.0 + twitch(random), 19.0 + twitch(random)), BoxAt(twitch(random), 1.0)},
            kStep);
        ASSERT_EQ(camera.View(), start);
    }
}

TEST(FitCamera, MovesSmoothlyToABodyNearTheEdgeAndRests)
{
    FitCamera camera(1280, 720, kScene);
    const Edges home(camera.View());
    const Rect box = BoxAt(home.right - 1.0, 10.0);
    double largestStep = 0.0;
    double firstStep = 0.0;
    double total = 0.0;
    int stepsToRest = 0;
    for (int step = 1; step <= 600; ++step)
    {
        const Camera before = camera.View();
        camera.Update({box}, kStep);
        const double moved = Edges(camera.View()).right - Edges(before).right;
        firstStep = step == 1 ? moved : firstStep;
        largestStep = std::max(largestStep, moved);
        total += moved;
        stepsToRest = camera.View() == before ? stepsToRest : step;
    }
    EXPECT_GT(total, 1.0);
    EXPECT_LT(largestStep, 0.05 * total) << "a glide, not a jump";
    EXPECT_LT(firstStep, 0.25 * largestStep) << "starts softly";
    EXPECT_LT(stepsToRest, 300) << "comes to rest";
}

TEST(FitCamera, DoesNotMoveOnceABodyRestsAtTheEdge)
{
    FitCamera camera(1280, 720, kScene);
    const Edges home(camera.View());
    const Rect box = BoxAt(home.right + 20.0, 10.0);
    for (int step = 0; step < 400; ++step)
    {
        camera.Update({box}, kStep);
    }
    const Camera rest = camera.View();
    for (int step = 0; step < 400; ++step)
    {
        camera.Update({box}, kStep);
        ASSERT_EQ(camera.View(), rest);
    }
}

TEST(FitCamera, ShowsABodyAtOnceThatLeapsOutOfTheFrame)
{
    FitCamera camera(1280, 720, kScene);
    const Edges home(camera.View());
    const Rect box = BoxAt(0.0, home.top + 8.0);
    camera.Update({box}, kStep);
    EXPECT_TRUE(Edges(camera.View()).Holds(box));
    EXPECT_LT(Edges(camera.View()).top, box.upper.y + 0.5) << "and no farther than it must";
}

TEST(FitCamera, KeepsALevelChainInViewWhenItSwingsDownFromOneEnd)
{
    const double length = 20.0;
    FitCamera camera(1280, 720, Rect{{0.0f, -0.5f}, {20.0f, 0.5f}});
    for (int step = 0; step < 240; ++step)
    {
        const double angle = -std::min(1.6, step * kStep);
        const Rect end = BoxAt(length * std::cos(angle), length * std::sin(angle), 0.3);
        camera.Update({end, BoxAt(0.0, 0.0, 0.3)}, kStep);
        ASSERT_TRUE(Edges(camera.View()).Holds(end)) << "at step " << step;
    }
}

TEST(FitCamera, StopsShowingABodyThatFellOffTheWorld)
{
    FitCamera camera(1280, 720, kScene);
    const Edges home(camera.View());
    const double height = home.top - home.bottom;
    double y = 5.0;
    double v = 0.0;
    for (int step = 0; step < 1200; ++step)
    {
        v -= 10.0 * kStep;
        y += v * kStep;
        camera.Update({BoxAt(0.0, 10.0), BoxAt(0.0, y)}, kStep);
    }
    EXPECT_LT(y, -1000.0);
    const Edges end(camera.View());
    EXPECT_LT(end.top - end.bottom, 2.6 * height);
    FitCamera untouched(1280, 720, kScene);
    untouched.Update({BoxAt(0.0, y), BoxAt(1e30, 0.0)}, kStep);
    EXPECT_EQ(untouched.View(), FitTo(kScene, 1280, 720));
}

TEST(FitCamera, IgnoresInvalidBoxes)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    FitCamera camera(1280, 720, kScene);
    camera.Update({Rect{},
                   {{nan, nan}, {nan, nan}},
                   {{nan, 0.0f}, {60.0f, 1.0f}},
                   {{-inf, 0.0f}, {inf, 1.0f}}},
                  kStep);
    camera.Update({}, kStep);
    EXPECT_EQ(camera.View(), FitTo(kScene, 1280, 720));
}

TEST(FitCamera, FollowsBodiesFromTheDefaultViewWhenTheSceneIsEmpty)
{
    FitCamera camera(1280, 720, Rect{});
    EXPECT_EQ(camera.View(), Camera());
    camera.Update({BoxAt(70.0, 20.0)}, kStep);
    EXPECT_TRUE(Edges(camera.View()).Holds(BoxAt(70.0, 20.0)));
}

TEST(FitCamera, ShowsSameViewAtSameStepForAnyFrameRate)
{
    const auto viewsOf = [](int stepsPerFrame) {
        FitCamera camera(1280, 720, kScene);
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
            camera.Update({BoxAt(body.x, body.y)}, kStep);
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

TEST(FitCamera, MovesAlikeAtAnyStepLength)
{
    const auto rightEdgeAfterHalfASecond = [](int hertz) {
        FitCamera camera(1280, 720, kScene);
        const double edge = Edges(camera.View()).right;
        for (int step = 0; step < hertz / 2; ++step)
        {
            camera.Update({BoxAt(edge - 1.0, 10.0)}, 1.0 / hertz);
        }
        return Edges(camera.View()).right - edge;
    };
    const double way = rightEdgeAfterHalfASecond(1000);
    EXPECT_GT(way, 0.5);
    EXPECT_NEAR(rightEdgeAfterHalfASecond(60), way, 0.05 * way);
    EXPECT_NEAR(rightEdgeAfterHalfASecond(30), way, 0.08 * way);
}

TEST(FitCamera, StandsStillWhenNoTimePasses)
{
    FitCamera camera(1280, 720, kScene);
    camera.Update({BoxAt(Edges(camera.View()).right - 1.0, 10.0)}, 0.0);
    EXPECT_EQ(camera.View(), FitTo(kScene, 1280, 720));
}
