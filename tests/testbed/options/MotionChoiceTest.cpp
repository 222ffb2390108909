// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <base/Quoting.h>
#include <options/MotionChoice.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

const BodyChoice kThese{false, {3, 17}};

template <class Value>
std::string Refusal(const Result<Value>& result)
{
    return result ? "accepted" : result.GetError().culprit;
}

TEST(MotionChoice, ReadsBodiesAsNumbersNamesOrMoving)
{
    EXPECT_EQ(*ParseBodyChoice("--trail", "moving"), BodyChoice());
    EXPECT_EQ(*ParseBodyChoice("--trail", "3,17"), kThese);
    EXPECT_EQ(*ParseBodyChoice("--trail", "left wheel,3"),
              (BodyChoice{false, {BodyRef("left wheel"), 3}}));
    EXPECT_EQ(*ParseBodyChoice("--trail", "\"3, or: so\",\"moving\""),
              (BodyChoice{false, {BodyRef("3, or: so"), BodyRef("moving")}}));
    for (const char* bad : {"", "3,", "-1", "3;17", "a:b", "1.5", "9999999999", "\"a", " a"})
    {
        EXPECT_EQ(Refusal(ParseBodyChoice("--trail", bad)), AsTyped("--trail", bad));
    }
}

TEST(MotionChoice, ReadsStrobeWithTimesOrStepsAndBodies)
{
    EXPECT_EQ(*ParseStrobe("--strobe", "250ms"), (StrobeChoice{{{250'000'000}, 0}, {}}));
    EXPECT_EQ(*ParseStrobe("--strobe", "0.5"), (StrobeChoice{{{500'000'000}, 0}, {}}));
    EXPECT_EQ(*ParseStrobe("--strobe", "15steps:3,17"), (StrobeChoice{{{}, 15}, kThese}));
    EXPECT_EQ(*ParseStrobe("--strobe", "1step"), (StrobeChoice{{{}, 1}, {}}));
    for (const char* bad : {"", "0", "0steps", "steps", "-1s", "1s:", "1s:3:4", "fast"})
    {
        EXPECT_EQ(Refusal(ParseStrobe("--strobe", bad)), AsTyped("--strobe", bad));
    }
}

TEST(MotionChoice, ReadsOnionWithCountIntervalAndBodies)
{
    EXPECT_EQ(*ParseOnion("--onion", "5"), (OnionChoice{5, {{100'000'000}, 0}, {}}));
    EXPECT_EQ(*ParseOnion("--onion", "5:50ms"), (OnionChoice{5, {{50'000'000}, 0}, {}}));
    EXPECT_EQ(*ParseOnion("--onion", "5:3steps:3,17"), (OnionChoice{5, {{}, 3}, kThese}));
    for (const char* bad : {"", "0", "101", "5:", "5:0", "5:1s:", "5:1s:3:4", "x:1s", "5:0s"})
    {
        EXPECT_EQ(Refusal(ParseOnion("--onion", bad)), AsTyped("--onion", bad));
    }
}

TEST(MotionChoice, ReadsDimensionBetweenBodiesAndPoints)
{
    EXPECT_EQ(*ParseDimension("--dimension", "3,17"), (DimensionChoice{3, 17}));
    EXPECT_EQ(*ParseDimension("--dimension", "3 to 17"), (DimensionChoice{3, 17}));
    EXPECT_EQ(*ParseDimension("--dimension", "0,-1 to 4.5,2"),
              (DimensionChoice{Vec2{0, -1}, Vec2{4.5f, 2}}));
    EXPECT_EQ(*ParseDimension("--dimension", "3 to 4.5,2"), (DimensionChoice{3, Vec2{4.5f, 2}}));
    EXPECT_EQ(*ParseDimension("--dimension", "ball to left wheel"),
              (DimensionChoice{BodyRef("ball"), BodyRef("left wheel")}));
    const DimensionChoice quoted{BodyRef("b to c"), 3};
    EXPECT_EQ(*ParseDimension("--dimension", "\"b to c\" to 3"), quoted);
    EXPECT_EQ(*ParseDimension("--dimension", "\"b to c\",3"), quoted);
    EXPECT_EQ(*ParseDimension("--dimension", "0,1 to \"b to c\""),
              (DimensionChoice{Vec2{0, 1}, BodyRef("b to c")}));
    EXPECT_EQ(Refusal(ParseDimension("--dimension", "b to c to 3")), "--dimension 'b to c to 3'");
    for (const char* bad : {"", "3", "3,3", "3,17,4", "1,2 to", "1,2 to 1,2", "1,2 to 3,4,5",
                            "0,nan to 1,1", "1e7,0 to 1,1", "1.5,2", " to "})
    {
        EXPECT_EQ(Refusal(ParseDimension("--dimension", bad)), AsTyped("--dimension", bad));
    }
}

TEST(MotionChoice, RefusesMomentsThatDoNotIncrease)
{
    EXPECT_EQ(*ParseMoments("--at", "3s"), (std::vector<Duration>{{3'000'000'000}}));
    EXPECT_EQ(*ParseMoments("--at", "0s,500ms,2"),
              (std::vector<Duration>{{0}, {500'000'000}, {2'000'000'000}}));
    EXPECT_EQ(*ParseSteps("--step", "0,30"), (std::vector<std::int64_t>{0, 30}));
    EXPECT_EQ(Refusal(ParseMoments("--at", "1s,1s")), "--at 1s,1s");
    EXPECT_EQ(Refusal(ParseSteps("--step", "30,0")), "--step 30,0");
    EXPECT_EQ(Refusal(ParseMoments("--at", "1s,")), "--at 1s,");
    EXPECT_EQ(Refusal(ParseSteps("--step", "3,,5")), "--step 3,,5");
    EXPECT_EQ(Refusal(ParseSteps("--step", "1,x")), "--step x");
    std::string many = "0";
    for (int i = 1; i < 65; ++i)
    {
        many.append(",").append(std::to_string(i));
    }
    EXPECT_THAT(ParseSteps("--step", many), RefusesWith("--step " + many, "64"));
}

} // namespace
} // namespace boxreel
