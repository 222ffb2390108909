// SPDX-License-Identifier: MIT
#include "Errors.h"

#include <base/Nearest.h>

#include <gtest/gtest.h>

#include <utility>

namespace boxreel
{
namespace
{

TEST(EditDistance, CountsSingleMistakes)
{
    EXPECT_EQ(EditDistance("pyramid", "pyramid"), 0);
    EXPECT_EQ(EditDistance("pyramd", "pyramid"), 1) << "left out";
    EXPECT_EQ(EditDistance("pyraamid", "pyramid"), 1) << "typed twice";
    EXPECT_EQ(EditDistance("pyremid", "pyramid"), 1) << "another letter";
    EXPECT_EQ(EditDistance("pyarmid", "pyramid"), 1) << "swapped";
    EXPECT_EQ(EditDistance("", "abc"), 3);
    EXPECT_EQ(EditDistance("abc", ""), 3);
    EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
}

TEST(NearestWord, FindsTheIntendedWord)
{
    const std::vector<std::string> words{"bridge", "pyramid", "--seconds", "--seed"};
    EXPECT_EQ(NearestWord("piramid", words), 1);
    EXPECT_EQ(NearestWord("--secnds", words), 2);
    EXPECT_EQ(NearestWord("pyr", words), 1) << "a beginning is enough";
}

TEST(NearestWord, IgnoresCase)
{
    EXPECT_EQ(NearestWord("PIRAMID", {"bridge", "pyramid"}), 1);
    EXPECT_EQ(NearestWord("pyr", {"bridge", "Pyramid"}), 1);
}

TEST(NearestWord, FindsNothingWithoutASimilarWord)
{
    const std::vector<std::string> words{"bridge", "pyramid"};
    EXPECT_EQ(NearestWord("z", {"x", "y"}), -1) << "none of its letters";
    EXPECT_EQ(NearestWord("xylophone", words), -1);
    EXPECT_EQ(NearestWord("", words), -1);
    EXPECT_EQ(NearestWord("pyramid", {}), -1);
}

TEST(NotOneOf, NamesOptionAndSuggestsNearWord)
{
    const std::vector<std::string> words{"low", "high"};
    for (const auto& [typed, culprit] :
         {std::pair("hihg", "--quality hihg"), {"best", "--quality best"}, {"", "--quality ''"}})
    {
        const Error error = NotOneOf("--quality", typed, words);
        EXPECT_THAT(error, IsError(ErrorKind::Unusable, culprit));
        EXPECT_EQ(error.remedy.Text().find("'high'") != std::string::npos,
                  typed == std::string("hihg"));
    }
    EXPECT_EQ(DidYouMean("best", words, "write it"), "write it");
}

} // namespace
} // namespace boxreel
