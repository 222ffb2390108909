// SPDX-License-Identifier: MIT
#include <debugdraw/TextWidth.h>

#include <gmock/gmock.h>

using namespace boxreel;
using testing::ElementsAre;

TEST(TextWidth, TreatsTabsAsSpaces)
{
    EXPECT_EQ(TextWidth("two\ttabs"), TextWidth("two tabs"));
    EXPECT_EQ(WrapText("two\ttabs", 30.0), WrapText("two tabs", 30.0));
}

TEST(TextWidth, AddsUpLetters)
{
    EXPECT_EQ(TextWidth(""), 0.0);
    EXPECT_NEAR(TextWidth("0"), 8.2, 0.05);
    EXPECT_NEAR(TextWidth("0000000000"), 82.0, 0.5);
    EXPECT_GT(TextWidth("W"), TextWidth("i"));
    EXPECT_EQ(TextWidth("µ"), TextWidth("0")) << "one letter of two bytes";
}

TEST(TextWidth, IsFiniteForInvalidText)
{
    EXPECT_GT(TextWidth("\xff\xfe"), 0.0);
    EXPECT_GT(TextWidth("\xe2\x82"), 0.0);
    EXPECT_EQ(TextWidth("\n\x01"), 0.0);
}

TEST(WrapText, BreaksAtSpacesAndKeepsEveryWord)
{
    EXPECT_THAT(WrapText("a caption", 1000.0), ElementsAre("a caption"));
    EXPECT_THAT(WrapText("00 00 00", 40.0), ElementsAre("00 00", "00"));
    EXPECT_THAT(WrapText("one\ntwo", 1000.0), ElementsAre("one", "two"));
    EXPECT_THAT(WrapText("", 10.0), ElementsAre(""));
    for (const std::string& line : WrapText("several words of one sentence in lines", 90.0))
    {
        EXPECT_LE(TextWidth(line), 90.0) << line;
    }
}

TEST(WrapText, BreaksAWordLongerThanTheLine)
{
    EXPECT_THAT(WrapText("000000 0", 34.0), ElementsAre("0000", "00 0"));
    EXPECT_THAT(WrapText("µµ", 1.0), ElementsAre("µ", "µ")) << "a letter a line at least";
}
