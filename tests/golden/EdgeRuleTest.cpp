// SPDX-License-Identifier: MIT
#include "TestPictures.h"

#include <golden/Compare.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace boxreel;
using namespace boxreel::test;

namespace
{

constexpr int kSide = 64;

std::uint8_t Mix(std::uint8_t under, std::uint8_t over, double share)
{
    return static_cast<std::uint8_t>(std::lround(under + (over - under) * share));
}

// Returns an upright line from `left`, `width` pixels wide. Each pixel is the mean of its area.
Frame WithLine(double left, double width, Color color, Color ground)
{
    Frame frame = Filled(kSide, kSide, ground);
    for (int x = 0; x < kSide; ++x)
    {
        const double share =
            std::max(0.0, std::min(left + width, x + 1.0) - std::max(left, double(x)));
        FillRect(frame, x, 8, x + 1, kSide - 8,
                 {Mix(ground.r, color.r, share), Mix(ground.g, color.g, share),
                  Mix(ground.b, color.b, share)});
    }
    return frame;
}

Comparison CrossMachine(const Frame& expected, const Frame& actual)
{
    return Compare(expected, actual, CompareSettings::CrossMachine());
}

// Every place of the line relative to the pixels, two widths, two grounds.
template <class Check>
void ForEveryLine(Check check)
{
    for (const auto& [color, ground] :
         {std::pair{kAwake, kDark}, {kJoint, kDark}, {kJoint, kLight}, {Color{0, 0, 0}, kLight}})
    {
        for (int tenth = 0; tenth < 10; ++tenth)
        {
            for (const double width : {1.0, 1.5, 20.0})
            {
                SCOPED_TRACE(testing::Message() << "at ." << tenth << ", " << width << " px wide");
                check(30.0 + tenth / 10.0, width, color, ground);
            }
        }
    }
}

} // namespace

TEST(EdgeRule, PassesALineThatLiesAFifthOfAPixelElsewhere)
{
    ForEveryLine([](double left, double width, Color color, Color ground) {
        const Frame expected = WithLine(left, width, color, ground);
        for (const double shift : {-0.2, -0.1, 0.1, 0.2})
        {
            const Frame actual = WithLine(left + shift, width, color, ground);
            const Comparison result = CrossMachine(expected, actual);
            EXPECT_EQ(result.overTolerance, 0) << shift << ": " << result.Text();
            EXPECT_GT(result.excusedAtEdges, 0);
            EXPECT_FALSE(Compare(expected, actual).equal) << "the same machine moves no edge";
        }
    });
}

TEST(EdgeRule, FindsALineThatLiesAPixelElsewhere)
{
    ForEveryLine([](double left, double width, Color color, Color ground) {
        for (const double shift : {-1.0, 1.0})
        {
            EXPECT_FALSE(CrossMachine(WithLine(left, width, color, ground),
                                      WithLine(left + shift, width, color, ground))
                             .equal);
        }
    });
}

TEST(EdgeRule, FindsALineThatIsGoneOrNew)
{
    ForEveryLine([](double left, double width, Color color, Color ground) {
        const Frame line = WithLine(left, width, color, ground);
        EXPECT_FALSE(CrossMachine(line, Filled(kSide, kSide, ground)).equal);
        EXPECT_FALSE(CrossMachine(Filled(kSide, kSide, ground), line).equal);
    });
}

TEST(EdgeRule, FindsALineOnePixelThicker)
{
    ForEveryLine([](double left, double width, Color color, Color ground) {
        EXPECT_FALSE(CrossMachine(WithLine(left, width, color, ground),
                                  WithLine(left, width + 1.0, color, ground))
                         .equal);
    });
}

TEST(EdgeRule, FindsADotThatIsGone)
{
    Frame expected = Filled(kSide, kSide, kDark);
    FillRect(expected, 30, 30, 33, 33, kAwake);
    EXPECT_FALSE(CrossMachine(expected, Filled(kSide, kSide, kDark)).equal);
}

// Greenish instead of gray, by less than the edge may move.
TEST(EdgeRule, FindsAForeignColourOnAnEdge)
{
    const Frame expected = WithLine(30.5, 20.0, {230, 230, 230}, kDark);
    Frame actual = expected, brighter = expected;
    for (int y = 20; y < 40; ++y)
    {
        actual.Pixel(30, y)[1] = static_cast<std::uint8_t>(actual.Pixel(30, y)[1] + 40);
        FillRect(brighter, 30, y, 31, y + 1, {168, 168, 168});
    }
    EXPECT_EQ(CrossMachine(expected, actual).overTolerance, 20);
    EXPECT_EQ(CrossMachine(expected, brighter).overTolerance, 0) << "as bright, and no foreign one";
}

TEST(EdgeRule, ExcusesNothingAwayFromEdges)
{
    const Frame expected = WithLine(30.0, 20.0, kAwake, kDark);
    Frame actual = expected;
    FillRect(actual, 36, 20, 45, 29, {220, 169, 169});
    const Comparison result = CrossMachine(expected, actual);
    EXPECT_EQ(result.overTolerance, 81);
    EXPECT_EQ(result.excusedAtEdges, 0);
}

TEST(EdgeRule, WorksAtTheBordersOfThePicture)
{
    Frame expected = Filled(20, 20, kDark);
    FillRect(expected, 0, 0, 20, 1, kAwake);
    Frame actual = expected;
    FillRect(actual, 0, 0, 20, 1, {210, 164, 164});
    EXPECT_EQ(CrossMachine(expected, actual).excusedAtEdges, 20);
    EXPECT_EQ(CrossMachine(Filled(1, 1, kDark), Filled(1, 1, kAwake)).overTolerance, 1);
}

// Rows follow each other in memory: the first pixel of the next is no neighbour of a row's last.
TEST(EdgeRule, TakesNoNeighbourFromOtherEndOfRow)
{
    for (const int column : {0, 19})
    {
        Frame expected = Filled(20, 20, kDark);
        FillRect(expected, column, 0, column + 1, 20, kAwake);
        Frame actual = expected;
        FillRect(actual, 19 - column, 5, 20 - column, 15, {66, 57, 57});
        EXPECT_EQ(CrossMachine(expected, actual).overTolerance, 10);
    }
}

// Only the expected picture decides about edges. An edge that exists only in the actual picture
// allows no difference.
TEST(EdgeRule, UsesEdgesOfTheExpectedPictureOnly)
{
    Frame actual = Filled(20, 20, kDark);
    FillRect(actual, 5, 5, 6, 15, {66, 57, 57});
    EXPECT_EQ(CrossMachine(Filled(20, 20, kDark), actual).overTolerance, 10);
}
