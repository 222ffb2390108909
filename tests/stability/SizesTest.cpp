// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Bodies from 1 cm to 50 m, alone and together.
namespace
{

using namespace stability;

STABILITY_SUITE(Sizes);

std::string Named(const char* what, float32 size)
{
    char text[64];
    std::snprintf(text, sizeof text, "%s of %g m", what, double(size));
    return text;
}

constexpr float32 kSizes[] = {0.01f, 0.1f, 1.0f, 10.0f, 50.0f}; // [m]

/// Skins and slop have one size: a centimetre of way is seen at any size, and a hundredth of it.
double Way(float32 size)
{
    return 0.01 + 0.01 * double(size);
}

void JudgePile(Trial& trial, const std::string& name, const std::vector<b2Body*>& boxes, double way,
               double speed = double(b2_linearSleepTolerance))
{
    trial.world.SetAllowSleeping(false);
    const Places places(boxes);
    double trembling = 0.0;
    trial.Run(20.0, [&](double time) {
        trembling = time > 10.0 ? Worst(trial.FastestSpeed(), trembling) : 0.0;
    });
    const int32 n = trial.world.GetSubStepCount();
    Judge(name + ", way", n, places.Farthest(), "m", way);
    Judge(name + ", speed after 10 s", n, trembling, "m/s", speed);
}

TEST_P(Sizes, LetAStackOfEachStand)
{
    for (const float32 size : kSizes)
    {
        Trial trial(GetParam());
        trial.WideGround(0.6f);
        std::vector<b2Body*> boxes;
        for (int i = 0; i < 5; ++i)
        {
            const float32 y = (size + kRestingGap) * (float32(i) + 0.5f) + 0.5f * kRestingGap;
            boxes.push_back(trial.Box(0.0f, y, 0.5f * size, 0.5f * size));
        }
        JudgePile(trial, Named("five boxes", size), boxes, Way(size));
    }
}

TEST_P(Sizes, LetABallOfEachFallAndSleep)
{
    for (const float32 size : kSizes)
    {
        Trial trial(GetParam());
        trial.WideGround(0.6f);
        b2Body* ball = trial.Ball(0.0f, size + 0.5f * size, 0.5f * size);
        trial.Run(20.0);
        // A ball has no skin of its own.
        const double height = double(0.5f * size + b2_polygonRadius);
        Judge(Named("ball", size) + ", height off", GetParam(),
              1000.0 * std::abs(double(ball->GetPosition().y) - height), "mm",
              1000.0 * double(b2_linearSlop) + 1.0);
        Judge(Named("ball", size) + ", still awake", GetParam(), ball->IsAwake() ? 1.0 : 0.0, "",
              0.0);
    }
}

TEST_P(Sizes, LetASmallBoxRestOnALargeOne)
{
    for (const float32 size : {0.01f, 0.1f, 1.0f})
    {
        Trial trial(GetParam());
        trial.WideGround(0.6f);
        std::vector<b2Body*> boxes;
        boxes.push_back(trial.Box(0.0f, 25.0f + kRestingGap, 25.0f, 25.0f));
        boxes.push_back(
            trial.Box(3.0f, 50.0f + 2.0f * kRestingGap + 0.5f * size, 0.5f * size, 0.5f * size));
        JudgePile(trial, Named("on 50 m a box", size), boxes, 0.02);
    }
}

/// 10 m on two of 1 m: fifty times as heavy as each.
TEST_P(Sizes, LetALargeBoxRestOnSmallOnes)
{
    Trial trial(GetParam());
    trial.WideGround(0.6f);
    std::vector<b2Body*> boxes;
    boxes.push_back(trial.Box(-4.0f, 0.5f + kRestingGap));
    boxes.push_back(trial.Box(4.0f, 0.5f + kRestingGap));
    boxes.push_back(trial.Box(0.0f, 6.0f + 2.0f * kRestingGap, 5.0f, 5.0f));
    JudgePile(trial, "10 m on two of 1 m", boxes, Bound(GetParam(), 0.02));
}

/// From the bottom up 5 m, 2 m, 1 m, 0.5 m, 0.2 m, 0.1 m, 5 cm, 2 cm, 1 cm.
TEST_P(Sizes, LetATowerOfDecreasingBoxesStand)
{
    Trial trial(GetParam());
    trial.WideGround(0.6f);
    std::vector<b2Body*> boxes;
    float32 floor = 0.0f;
    for (const float32 size : {5.0f, 2.0f, 1.0f, 0.5f, 0.2f, 0.1f, 0.05f, 0.02f, 0.01f})
    {
        boxes.push_back(
            trial.Box(0.0f, floor + kRestingGap + 0.5f * size, 0.5f * size, 0.5f * size));
        floor += kRestingGap + size;
    }
    JudgePile(trial, "tower, 5 m to 1 cm", boxes, 0.02);
}

/// Rows of boxes of one height, but of many widths, from 0.2 m to 3 m.
TEST_P(Sizes, LetAPyramidOfManyWidthsStand)
{
    Trial trial(GetParam());
    trial.WideGround(0.6f);
    std::vector<b2Body*> boxes;
    for (int row = 0; row < 8; ++row)
    {
        const float32 half = 8.0f - float32(row); // [m]
        for (float32 x = -half; x < half - 0.3f;)
        {
            const float32 width = b2Min(0.2f + 1.4f * (1.0f + trial.Random()), half - x);
            b2Body* box = trial.Body(b2_dynamicBody, x + 0.5f * width,
                                     0.5f + kRestingGap + (1.0f + kRestingGap) * float32(row));
            Scene::AddBox(box, 0.5f * width, 0.5f, 0.6f);
            boxes.push_back(box);
            x += width + 2.0f * b2_polygonRadius;
        }
    }
    JudgePile(trial, "pyramid of many widths", boxes, 0.05,
              Bound(GetParam(), double(b2_linearSleepTolerance)));
}

} // namespace
