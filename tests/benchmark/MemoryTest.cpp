// SPDX-License-Identifier: MIT
// How much memory our benchmark program needs for the scene that has a goal for it.
#include <bench/Benchmark.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace boxreel
{
namespace
{

TEST(BenchmarkMemory, TheLargePyramidTakesAtMost15Megabytes)
{
    if (BOXREEL_IS_SANITIZED)
    {
        GTEST_SKIP() << "The sanitizers' own memory counts in the process's growth.";
    }
    const Result<std::vector<BenchScene>> scenes = ListBenchScenes(BOXREEL_BENCH);
    ASSERT_TRUE(scenes) << scenes.GetError().message;
    const auto pyramid = std::find_if(scenes->begin(), scenes->end(), [](const BenchScene& scene) {
        return scene.name == "large-pyramid";
    });
    ASSERT_NE(pyramid, scenes->end());
    EXPECT_EQ(pyramid->goalMemory, 15.0 * 1024.0);
    const BenchResult result = RunBenchScene({BOXREEL_BENCH}, *pyramid, {1, {1}});
    const BenchFigures& ours = result.engines.front();
    EXPECT_EQ(ours.verdict, "sound");
    EXPECT_GT(ours.memory, 1024.0) << "5050 boxes take more than that: nobody measured";
    EXPECT_LE(ours.memory, 15.0 * 1024.0);
}

} // namespace
} // namespace boxreel
