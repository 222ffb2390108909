// SPDX-License-Identifier: MIT
#include <base/Result.h>

#include <gtest/gtest.h>

#include <sstream>

namespace boxreel
{
namespace
{

constexpr SettingName kOptions[] = {
    {"Film::size", "", "--size", " ", "x"},
    {"Film::quality", "Quality::Lossless", "--lossless"},
    {"Film::quality", "", "--quality", "=", "", "!"},
};

TEST(ErrorText, WritesMembersWithoutATable)
{
    EXPECT_EQ(ErrorText(ErrorSetting{"Film::size", {"3", "4"}}).Text(), "size = 3x4");
    EXPECT_EQ(ErrorText(ErrorSetting{"Film::codec"}).Text(), "codec");
    const ErrorSetting codec{"codec", {"av1"}};
    EXPECT_EQ("use " + codec + " here", "use codec = av1 here");
    EXPECT_EQ((std::ostringstream() << ErrorText(codec)).str(), "codec = av1");
}

TEST(ErrorText, WritesTheNamesOfATable)
{
    const auto text = [](const ErrorText& error) { return error.Text(kOptions); };
    EXPECT_EQ(text(ErrorSetting{"Film::size", {"3", "4"}}), "--size 3x4");
    EXPECT_EQ(text("remove " + ErrorSetting{"Film::size"}), "remove --size");
    EXPECT_EQ(text(ErrorSetting{"Film::quality", {"Quality::Lossless"}}), "--lossless");
    EXPECT_EQ(text(ErrorSetting{"Film::quality", {"high"}}), "--quality=high!");
    EXPECT_EQ(text(ErrorSetting{"Film::codec", {"av1"}}), "codec = av1") << "not in the table";
}

TEST(ErrorText, LeavesOutAlternativesThatTheTableLacks)
{
    const ErrorText codec = ErrorSetting{"Film::codec", {"av1"}};
    const ErrorText remedy =
        "use " + ErrorText::AnyOf({"nut", codec, ErrorSetting{"Film::size", {"3", "4"}}});
    EXPECT_EQ(remedy.Text(), "use nut, codec = av1 or size = 3x4");
    EXPECT_EQ(remedy.Text(kOptions), "use nut or --size 3x4");
    EXPECT_EQ(ErrorText::AnyOf({codec}).Text(kOptions), "");
}

TEST(Error, LeavesEmptyPartsOutOfItsText)
{
    const Error error{ErrorKind::Failed, "film", "", ErrorSetting{"Film::size"}};
    EXPECT_EQ(error.Text(), "film; size");
    EXPECT_EQ(error.Text(kOptions), "film; --size");
    EXPECT_EQ((Error{ErrorKind::Failed, "", "is full"}).Text(), "is full");
}

} // namespace
} // namespace boxreel
