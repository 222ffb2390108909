// SPDX-License-Identifier: MIT
#include <base/Words.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

TEST(Lower, ChangesOnlyAsciiLetters)
{
    EXPECT_EQ(Lower(".MP4 aZ[@"), ".mp4 az[@");
    EXPECT_EQ(Lower("\xc3\x84"), "\xc3\x84") << "a letter beyond ASCII";
}

TEST(FilledTemplate, ReplacesEachWordOnceAndNotInParts)
{
    EXPECT_EQ(FilledTemplate("{{a}} and {{b}}, {{a}}", {{"a", "{{b}}"}, {"b", "two"}}),
              "{{b}} and two, {{b}}");
    EXPECT_EQ(FilledTemplate("an open {{a", {}), "an open ");
    EXPECT_EQ(FilledTemplate("", {}), "");
}

} // namespace
} // namespace boxreel
