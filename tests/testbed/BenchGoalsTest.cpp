// SPDX-License-Identifier: MIT
// What the table and the JSON of `boxreel bench` say of goals.
#include "BenchSupport.h"

#include <gmock/gmock.h>

#include <sstream>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

TEST(BenchGoals, WritesRatiosSoThatAMissedGoalDoesNotReadAsMet)
{
    EXPECT_EQ(RatioText(1.58), "1.58x");
    EXPECT_EQ(RatioText(6.95), "6.95x");
    EXPECT_EQ(RatioText(11.7), "11.7x");
    EXPECT_EQ(RatioText(150.2), "150x");
    EXPECT_EQ(RatioText(12345.0), "12,300x");
    EXPECT_EQ(RatioText(0.0), "");
}

/// Rain of one thread and of two, which are so many times faster.
BenchResult RainOfTwoThreads(double speedUp)
{
    BenchResult result = Rain();
    result.scene.goalSpeedUp = 1.6;
    result.engines.insert(result.engines.begin() + 1, result.engines.front());
    result.engines[1].threads = 2;
    result.engines[1].mean = result.engines[0].mean / speedUp;
    Judge(result);
    return result;
}

TEST(BenchGoals, SaysWhetherTwoThreadsReachTheirGoal)
{
    const BenchResult missed = RainOfTwoThreads(1.597), met = RainOfTwoThreads(1.61);
    EXPECT_THAT(BenchTable({missed}), HasSubstr("      2    1.60x! 1.60x "));
    EXPECT_THAT(BenchTable({met}), HasSubstr("      2    1.61x  1.60x "));
    EXPECT_THAT(BenchJson({missed}), HasSubstr("\"goalSpeedUpOfTwoThreads\": 1.6"));
    EXPECT_THAT(BenchJson({missed}), HasSubstr("\"speedUpGoalMet\": false"));
    EXPECT_THAT(BenchJson({met}), HasSubstr("\"speedUpGoalMet\": true"));
    BenchResult four = met;
    four.engines[1].threads = 4;
    EXPECT_THAT(BenchTable({four}), Not(HasSubstr("1.60x"))) << "the goal is that of two threads";
    EXPECT_THAT(BenchJson({four}), Not(HasSubstr("speedUpGoalMet")));
    EXPECT_THAT(BenchJson({four}), HasSubstr("\"speedUp\": 1.6"));
}

TEST(BenchGoals, SaysWhetherOursKeepsToItsGoalOfMemory)
{
    BenchResult result = Rain();
    result.scene.goalMemory = 15360.0;
    result.engines[0].memory = 15360.0;
    result.engines[1].memory = 99999.0; // nobody's goal
    EXPECT_THAT(BenchTable({result}), HasSubstr("  15.0 MB  15.0 MB  sound\n"));
    EXPECT_THAT(BenchTable({result}), HasSubstr("  97.7 MB           sound\n"));
    EXPECT_THAT(BenchJson({result}), HasSubstr("\"goalMemoryKilobytes\": 15360.0"));
    EXPECT_THAT(BenchJson({result}), HasSubstr("\"memoryGoalMet\": true"));
    EXPECT_THAT(BenchJson({result}), Not(HasSubstr("\"memoryGoalMet\": false")));
    result.engines[0].memory = 15361.0;
    EXPECT_THAT(BenchTable({result}), HasSubstr("  15.0 MB! 15.0 MB  sound\n"));
    EXPECT_THAT(BenchJson({result}), HasSubstr("\"memoryGoalMet\": false"));
}

TEST(BenchGoals, KeepsTheTableInColumns)
{
    BenchResult result = RainOfTwoThreads(1.5);
    result.scene.goalMemory = 15360.0;
    std::istringstream lines(BenchTable({result}));
    std::string head, line;
    std::getline(lines, head);
    const std::size_t column = head.find("verdict");
    while (std::getline(lines, line))
    {
        EXPECT_EQ(line.find("sound"), column) << head << "\n" << line;
    }
}

} // namespace
} // namespace boxreel
