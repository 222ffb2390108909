// SPDX-License-Identifier: MIT
#include "../base/ReadBytes.h"
#include "SceneFileRound.h"

#include <gtest/gtest.h>

#include <filesystem>

/// The seeds of the fuzzer of scene files, and the texts that it kept because they reached
/// something new or once broke the loader.
namespace
{

TEST(SceneFileCorpus, IsReplayedWithoutAFinding)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(BOXREEL_CORPUS))
    {
        EXPECT_EQ(fuzz::WhyWrong(ReadBytes(entry.path())), "") << entry.path().filename();
        ++count;
    }
    EXPECT_GT(count, 50);
}

} // namespace
