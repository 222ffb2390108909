// SPDX-License-Identifier: MIT
#include "SceneFileRound.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

/// The seeds of the fuzzer of scene files, and the texts that it kept because they reached
/// something new or once broke the loader.
namespace
{

TEST(SceneFileCorpus, OfTheFuzzerIsReplayedWithoutAFinding)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(BOXREEL_CORPUS))
    {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(fuzz::WhyWrong(text), "") << entry.path().filename();
        ++count;
    }
    EXPECT_GT(count, 50);
}

} // namespace
