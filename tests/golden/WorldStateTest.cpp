// SPDX-License-Identifier: MIT
#include "../base/Errors.h"

#include <golden/WorldState.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace boxreel;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

WorldState State()
{
    return {{{0, 0, 0, 0, 0, 0, 0},
             {1, 0.1f, 1.051f, 0.5f, 1, 2, 3},
             {4, -3, 1e-30f, 0, 0, -9.81f, 0}}};
}

StateTrace Trace(std::initializer_list<TraceStep> steps)
{
    return {steps};
}

} // namespace

TEST(WorldStateText, HasOneLinePerBodyWithoutZeroVelocities)
{
    EXPECT_EQ(ToText(State()), "0 0 0 0\n1 0.1 1.051 0.5 1 2 3\n4 -3 1e-30 0 0 -9.81 0\n");
}

TEST(WorldStateText, ReadsBackToTheSameBits)
{
    WorldState state = State();
    state.bodies[0].x = std::numeric_limits<float>::denorm_min();
    state.bodies[0].y = std::numeric_limits<float>::max();
    state.bodies[0].angle = std::nextafterf(0.1f, 1.0f);
    const Result<WorldState> back = ParseWorldState(ToText(state));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->bodies, state.bodies);
    EXPECT_TRUE(ParseWorldState("")->bodies.empty());
}

/// In double quotes.
std::string LastLine(std::string text)
{
    text.pop_back();
    return '"' + text.substr(text.rfind('\n') + 1) + '"';
}

TEST(WorldStateText, IsRefusedWithTheInvalidLine)
{
    for (const char* bad :
         {"x 1 2 3\n", "0 1 2\n", "0 1 2 3 4\n", "0 1 2 3 4 5 6 7\n", "-1 0 0 0\n", "0 1 nan 3\n",
          "0 inf 2 3\n", "0 1 2 3x\n", "1 0 0 0\n1 0 0 0\n", "0  1 2 3\n"})
    {
        EXPECT_THAT(ParseWorldState(bad), Refuses(LastLine(bad)));
    }
}

TEST(WorldStateDifference, ReportsBodyWithLargestDistance)
{
    WorldState moved = State();
    moved.bodies[1].y -= 0.031f;
    moved.bodies[2].velocityY = 0;
    const StateDifference difference = DifferenceOf(State(), moved);
    EXPECT_EQ(difference.different, 2u);
    EXPECT_EQ(difference.compared, 3u);
    EXPECT_EQ(difference.expected, State().bodies[1]);
    EXPECT_EQ(difference.actual, moved.bodies[1]);
    EXPECT_EQ(Describe(difference),
              "2 of 3 bodies differ, most of all body 1: 0.031 m lower (y 1.02 instead of 1.051)");
}

TEST(WorldStateDifference, ReportsQuantityThatDiffersInPlace)
{
    WorldState other = State();
    other.bodies[1].angle = 0.75f;
    EXPECT_THAT(Describe(DifferenceOf(State(), other)), HasSubstr("(angle 0.75 instead of 0.5)"));
    other = State();
    other.bodies[1].velocityX = 5;
    EXPECT_THAT(Describe(DifferenceOf(State(), other)), HasSubstr("(x 5 instead of 1)"));
    other = State();
    other.bodies[1].velocityY = 5;
    EXPECT_THAT(Describe(DifferenceOf(State(), other)), HasSubstr("(y 5 instead of 2)"));
    other = State();
    other.bodies[1].angularVelocity = 5;
    EXPECT_THAT(Describe(DifferenceOf(State(), other)), HasSubstr("(rad/s 5 instead of 3)"));
    EXPECT_EQ(DifferenceOf(State(), State()).different, 0u);
}

TEST(WorldStateDifference, ReportsMissingAndExtraBodies)
{
    WorldState fewer = State();
    fewer.bodies.erase(fewer.bodies.begin() + 1);
    EXPECT_THAT(DifferenceOf(State(), fewer).missing, ElementsAre(1));
    EXPECT_THAT(DifferenceOf(fewer, State()).extra, ElementsAre(1));
    EXPECT_THAT(DifferenceOf(State(), WorldState{}).missing, ElementsAre(0, 1, 4));
}

TEST(StateTraceText, HasOneLinePerStepAndIsReadBack)
{
    const StateTrace trace =
        Trace({{1, "0123abcd", "0.f"}, {2, "00000000", "12/34"}, {9, "ffffffff", ""}});
    const std::string text = ToText(trace);
    EXPECT_EQ(text, "1 0123abcd 0.f\n2 00000000 12/34\n9 ffffffff \n");
    const Result<StateTrace> back = ParseStateTrace(text);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->steps, trace.steps);
}

TEST(StateTraceText, IsRefusedWithTheInvalidLine)
{
    for (const char* bad : {"1\n", "1 0123abc 0\n", "1 0123abcg 0\n", "1 0123abcd xyz\n",
                            "1 0123abcd\n", "-1 0123abcd 0\n", "2 0123abcd 0\n1 0123abcd 0\n"})
    {
        EXPECT_THAT(ParseStateTrace(bad), Refuses(LastLine(bad)));
    }
    EXPECT_THAT(ParseStateTrace("\x1b[2J\xff\r\n"), Refuses("\"?[2J??\""))
        << "nothing that a terminal obeys";
}

TEST(StateTraceDifference, ReportsFirstStepAndBodiesThatDiffer)
{
    const StateTrace expected =
        Trace({{1, "00000000", "000"}, {2, "00000001", "123"}, {3, "00000002", "456"}});
    StateTrace actual = expected;
    EXPECT_FALSE(FirstDifference(expected, actual));
    actual.steps[1] = {2, "00000009", "153"};
    actual.steps[2] = {3, "00000008", "777"};
    const auto difference = FirstDifference(expected, actual);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->step, 2);
    EXPECT_THAT(difference->bodies, ElementsAre(1));
    EXPECT_FALSE(difference->isFirst);
    EXPECT_FALSE(difference->isOfOne);
    EXPECT_EQ(Describe(*difference), "from step 2 on, body 1 first");
}

TEST(StateTraceDifference, IsAtAStepThatOnlyOneTraceHas)
{
    const StateTrace whole =
        Trace({{1, "00000000", "000"}, {2, "00000001", "123"}, {3, "00000002", "456"}});
    for (std::size_t gone = 0; gone < 3; ++gone)
    {
        StateTrace cut = whole;
        cut.steps.erase(cut.steps.begin() + std::ptrdiff_t(gone));
        for (const auto& difference : {FirstDifference(whole, cut), FirstDifference(cut, whole)})
        {
            ASSERT_TRUE(difference) << gone;
            EXPECT_EQ(difference->step, std::int64_t(gone) + 1);
            EXPECT_TRUE(difference->isOfOne);
        }
    }
    EXPECT_EQ(FirstDifference(StateTrace(), whole)->step, 1) << "nothing is not the same as all";
    EXPECT_FALSE(FirstDifference(StateTrace(), StateTrace()));
}

TEST(StateTraceDifference, ReportsBodiesOfOneTraceAsDifferent)
{
    const auto difference =
        FirstDifference(Trace({{1, "00000000", "00"}}), Trace({{1, "00000001", "0012345"}}));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->step, 1);
    EXPECT_THAT(difference->bodies, ElementsAre(2, 3, 4, 5, 6));
}

TEST(StateTraceDifference, FindsBodyByRowAndColumnDigits)
{
    const auto difference = FirstDifference(Trace({{7, "00000000", "0000/0000"}}),
                                            Trace({{7, "00000001", "0010/0500"}}));
    ASSERT_TRUE(difference);
    EXPECT_THAT(difference->bodies, ElementsAre(2 * 4 + 1));
}

TEST(StateTraceDifference, ReportsWhetherStepIsFirstOfTrace)
{
    const StateTrace expected = Trace({{31, "00000000", "000"}, {32, "00000001", "123"}});
    StateTrace actual = expected;
    actual.steps[1] = {32, "00000009", "153"};
    EXPECT_FALSE(FirstDifference(expected, actual)->isFirst);
    actual.steps[0] = {31, "00000008", "020"};
    const auto first = FirstDifference(expected, actual);
    EXPECT_TRUE(first->isFirst);
    EXPECT_EQ(first->step, 31);
    EXPECT_THAT(first->bodies, ElementsAre(1));
    EXPECT_FALSE(
        FirstDifference(Trace({{1, "00000000", "0"}}), Trace({{1, "00000001", "1"}}))->isFirst)
        << "there is no step before the first";
}

TEST(StateTraceDifference, FindsStepWithoutDigitsOfBodies)
{
    for (const char* digits : {"00", "0/0"})
    {
        const auto difference =
            FirstDifference(Trace({{7, "00000000", "00"}}), Trace({{7, "00000001", digits}}));
        ASSERT_TRUE(difference);
        EXPECT_EQ(difference->step, 7);
        EXPECT_THAT(difference->bodies, testing::IsEmpty());
    }
}
