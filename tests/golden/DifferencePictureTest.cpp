// SPDX-License-Identifier: MIT
#include <golden/Compare.h>

#include "TestPictures.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace boxreel;
using namespace boxreel::test;

namespace
{

Color At(const Frame& frame, int x, int y)
{
    const std::uint8_t* p = frame.Pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
}

bool IsGray(Color color)
{
    return color.r == color.g && color.g == color.b && color.a == 255;
}

constexpr Color kStrong{255, 40, 60, 255};
constexpr Color kWeak{48, 90, 150, 255};

} // namespace

TEST(DifferencePicture, IsExpectedPictureInDarkGrayWhenEqual)
{
    const Frame picture = Painted(SmallScene(), {.ground = kLight});
    const Frame difference = Compare(picture, picture).difference;
    ASSERT_EQ(difference.width, picture.width);
    ASSERT_EQ(difference.height, picture.height);
    ASSERT_EQ(difference.rgba.size(), picture.rgba.size());
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            ASSERT_TRUE(IsGray(At(difference, x, y)));
            ASSERT_LT(At(difference, x, y).r, 128);
        }
    }
    EXPECT_FALSE(At(difference, 0, 0) == At(difference, 160, 168))
        << "the drawing can still be seen";
}

TEST(DifferencePicture, MarksPixelsOverToleranceStrongly)
{
    const Frame expected = Filled(100, 80, kDark);
    Frame actual = expected;
    FillRect(actual, 30, 40, 50, 60, {27, 27, 27});
    FillRect(actual, 30, 40, 32, 41, kAwake);
    CompareSettings settings;
    settings.tolerance = 0.01;
    const Frame difference = Compare(expected, actual, settings).difference;
    EXPECT_EQ(At(difference, 30, 40), kStrong);
    EXPECT_EQ(At(difference, 31, 40), kStrong);
    EXPECT_EQ(At(difference, 49, 59), kWeak);
    EXPECT_TRUE(IsGray(At(difference, 50, 60)));
}

TEST(DifferencePicture, HasThinBoxAroundPixelsOverTolerance)
{
    const Frame expected = Filled(100, 80, kDark);
    Frame actual = expected;
    FillRect(actual, 50, 40, 51, 41, kAwake);
    const Frame difference = Compare(expected, actual).difference;
    const Color white{255, 255, 255, 255};
    EXPECT_EQ(At(difference, 44, 34), white);
    EXPECT_EQ(At(difference, 56, 46), white);
    EXPECT_EQ(At(difference, 50, 34), white);
    EXPECT_EQ(At(difference, 44, 40), white);
    EXPECT_TRUE(IsGray(At(difference, 45, 35)) && At(difference, 45, 35).r < 128);
    EXPECT_EQ(At(difference, 50, 40), kStrong);
}

TEST(DifferencePicture, OmitsBoxWithoutRoomForIt)
{
    const Frame expected = Filled(8, 8, kDark);
    const Frame difference = Compare(expected, Filled(8, 8, kAwake)).difference;
    for (int i = 0; i < 8; ++i)
    {
        EXPECT_EQ(At(difference, i, i), kStrong);
    }
}

TEST(DifferencePicture, HasLargerSizeAndMarksUnmatchedPixels)
{
    const Frame difference = Compare(Filled(20, 30, kDark), Filled(25, 10, kDark)).difference;
    ASSERT_EQ(difference.width, 25);
    ASSERT_EQ(difference.height, 30);
    EXPECT_TRUE(IsGray(At(difference, 19, 9)));
    EXPECT_EQ(At(difference, 20, 9), kStrong);
    EXPECT_EQ(At(difference, 19, 10), kStrong);
    EXPECT_EQ(At(difference, 24, 29), kStrong);
}

TEST(DifferencePicture, HatchesWhatIsIgnored)
{
    const Frame expected = Filled(100, 80, kDark);
    CompareSettings settings;
    settings.ignored = {{20, 30, 40, 50}};
    for (const Frame& actual : {expected, Filled(100, 80, kAwake)})
    {
        const Frame difference = Compare(expected, actual, settings).difference;
        int hatched = 0;
        for (int y = 30; y < 50; ++y)
        {
            for (int x = 20; x < 40; ++x)
            {
                ASSERT_FALSE(At(difference, x, y) == kStrong);
                hatched += !IsGray(At(difference, x, y));
            }
        }
        EXPECT_NEAR(hatched, 400 / 6, 4);
        const bool differs = !(actual == expected);
        EXPECT_EQ(At(difference, 40, 49) == kStrong, differs);
        EXPECT_EQ(At(difference, 19, 30) == kStrong, differs);
    }
}

TEST(SideBySide, ShowsExpectedActualAndDifferenceBetweenSeparators)
{
    const Frame picture =
        SideBySide(Filled(10, 6, kAwake), Filled(10, 6, kStatic), Filled(10, 6, kJoint));
    ASSERT_EQ(picture.width, 38);
    ASSERT_EQ(picture.height, 6);
    EXPECT_EQ(At(picture, 0, 0), kAwake);
    EXPECT_EQ(At(picture, 9, 5), kAwake);
    EXPECT_TRUE(IsGray(At(picture, 10, 0)));
    EXPECT_TRUE(IsGray(At(picture, 13, 5)));
    EXPECT_EQ(At(picture, 14, 0), kStatic);
    EXPECT_EQ(At(picture, 23, 5), kStatic);
    EXPECT_TRUE(IsGray(At(picture, 24, 3)));
    EXPECT_EQ(At(picture, 28, 0), kJoint);
    EXPECT_EQ(At(picture, 37, 5), kJoint);
}

TEST(SideBySide, PadsWhatIsSmaller)
{
    const Frame picture =
        SideBySide(Filled(10, 6, kAwake), Filled(4, 9, kStatic), Filled(10, 9, kJoint));
    ASSERT_EQ(picture.width, 38);
    ASSERT_EQ(picture.height, 9);
    EXPECT_TRUE(IsGray(At(picture, 0, 6)));
    EXPECT_EQ(At(picture, 14, 8), kStatic);
    EXPECT_TRUE(IsGray(At(picture, 18, 8)));
    EXPECT_EQ(At(picture, 37, 8), kJoint);
}

TEST(SideBySide, AcceptsAPictureWithoutPixels)
{
    const Frame picture = SideBySide(Filled(10, 6, kAwake), Frame(), Filled(10, 6, kJoint));
    EXPECT_EQ(picture.width, 38);
    EXPECT_EQ(At(picture, 37, 5), kJoint);
}
