// SPDX-License-Identifier: MIT
#include <base/Counting.h>
#include <base/Quoting.h>

#include <gtest/gtest.h>

namespace
{

using namespace boxreel;

TEST(AsTyped, QuotesValuesThatNeedIt)
{
    EXPECT_EQ(AsTyped("--fps", "0"), "--fps 0");
    EXPECT_EQ(AsTyped("--label", "two words"), "--label 'two words'");
    EXPECT_EQ(AsTyped("--out", ""), "--out ''");
    EXPECT_EQ(AsTyped("", "0"), "0");
}

TEST(ShellQuoted, EscapesSingleQuotes)
{
    EXPECT_EQ(ShellQuoted("it's $HOME"), "'it'\\''s $HOME'");
    EXPECT_EQ(ShellQuoted(""), "''");
}

TEST(ZshEscaped, ReturnsOneLineWithSignsEscaped)
{
    EXPECT_EQ(ZshEscaped("[a]:b\\\nc"), "\\[a\\]\\:b\\\\ c");
}

TEST(MarkupEscaped, EscapesMarkupSigns)
{
    EXPECT_EQ(MarkupEscaped("<a b=\"c\">'d' & e"), "&lt;a b=&quot;c&quot;&gt;'d' &amp; e");
}

TEST(JsonForScript, EscapesEachLessThanSign)
{
    EXPECT_EQ(JsonForScript("[\"</script>\", \"a<<b\"]"),
              "[\"\\u003c/script>\", \"a\\u003c\\u003cb\"]");
    EXPECT_EQ(JsonForScript("{\"a\":1}"), "{\"a\":1}");
}

TEST(Base64, MatchesRfc4648)
{
    constexpr std::pair<std::string_view, std::string_view> kVectors[] = {{"", ""},
                                                                          {"f", "Zg=="},
                                                                          {"fo", "Zm8="},
                                                                          {"foo", "Zm9v"},
                                                                          {"foob", "Zm9vYg=="},
                                                                          {"fooba", "Zm9vYmE="},
                                                                          {"foobar", "Zm9vYmFy"},
                                                                          {"\xff\xfe", "//4="}};
    for (const auto& [bytes, text] : kVectors)
    {
        EXPECT_EQ(Base64(bytes), text);
    }
}

TEST(HexByte, HasTwoDigits)
{
    EXPECT_EQ(HexByte(0), "00");
    EXPECT_EQ(HexByte(0xa7), "a7");
}

TEST(SizeText, IsInMegabytesFromOneMegabyteOn)
{
    EXPECT_EQ(SizeText(64u << 20), "64 MB");
    EXPECT_EQ(SizeText(1u << 20), "1 MB");
    EXPECT_EQ(SizeText((1u << 20) - 1), "1048575 bytes");
    EXPECT_EQ(SizeText(1), "1 byte");
}

TEST(Counted, IsSingularForOneOnly)
{
    EXPECT_EQ(Counted(0, "frame"), "0 frames");
    EXPECT_EQ(Counted(1, "frame"), "1 frame");
    EXPECT_EQ(Counted(1, "body"), "1 body");
    EXPECT_EQ(Counted(2, "body"), "2 bodies");
    EXPECT_EQ(Counted(std::size_t(2), "frame"), "2 frames");
}

} // namespace
