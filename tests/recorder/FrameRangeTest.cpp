// SPDX-License-Identifier: MIT
#include <recorder/FrameRange.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

using boxreel::FrameRange;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::int64_t> NumbersOf(const FrameRange& range)
{
    std::vector<std::int64_t> numbers;
    for (std::int64_t i = 0; i < range.Count(); ++i)
    {
        numbers.push_back(range.At(i));
    }
    return numbers;
}

TEST(FrameRange, IsEveryFrameByDefault)
{
    EXPECT_EQ(FrameRange().First(), 0);
    EXPECT_TRUE(FrameRange().IsWhole());
    EXPECT_EQ(FrameRange().At(123456789), 123456789);
}

TEST(FrameRange, ReadsRunsSinglesAndEveryNth)
{
    EXPECT_THAT(NumbersOf(*FrameRange::Parse("200-203")), ElementsAre(200, 201, 202, 203));
    EXPECT_THAT(NumbersOf(*FrameRange::Parse("7")), ElementsAre(7));
    EXPECT_THAT(NumbersOf(*FrameRange::Parse("1-3,5,7-12:2")), ElementsAre(1, 2, 3, 5, 7, 9, 11));
    EXPECT_TRUE(FrameRange::Parse("200-399")->IsWhole());
    EXPECT_FALSE(FrameRange::Parse("1-3,5")->IsWhole());
    EXPECT_FALSE(FrameRange::Parse("0-8:2")->IsWhole());
}

TEST(FrameRange, IsWrittenAsItIsRead)
{
    for (const char* text : {"0-599", "7", "1-3,5,7-20:2"})
    {
        EXPECT_EQ(FrameRange::Parse(text)->Text(), text);
    }
}

TEST(FrameRange, EndsWithTheFilm)
{
    const FrameRange range = *FrameRange::Parse("1-3,5,7-20:2");
    EXPECT_THAT(NumbersOf(range.Below(10)), ElementsAre(1, 2, 3, 5, 7, 9));
    EXPECT_THAT(NumbersOf(range.Below(3)), ElementsAre(1, 2));
    EXPECT_EQ(range.Below(1).Count(), 0);
}

TEST(FrameRange, RefusesInvalidTextAndNamesThePart)
{
    // What was given, and the part of it at fault.
    const std::pair<std::string, std::string> cases[] = {{"", "''"},
                                                         {"a", "'a'"},
                                                         {"-5", "'-5'"},
                                                         {"5-", "'5-'"},
                                                         {"1-2-3", "'1-2-3'"},
                                                         {"9-7", "'9-7'"},
                                                         {"1-5,5-6", "'5-6'"},
                                                         {"1-5:0", "'1-5:0'"},
                                                         {"1,,2", "''"},
                                                         {"1 - 5", "'1 - 5'"},
                                                         {"99999999999999", "'99999999999999'"}};
    for (const auto& [text, part] : cases)
    {
        const auto range = FrameRange::Parse(text);
        ASSERT_FALSE(range) << text;
        EXPECT_EQ(range.GetError().culprit, "'" + text + "'");
        EXPECT_THAT(range.GetError().problem, testing::StartsWith(part + " "));
    }
}

} // namespace
