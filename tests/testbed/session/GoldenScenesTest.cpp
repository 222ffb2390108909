// SPDX-License-Identifier: MIT
// Compares every scene with its references; `boxreel golden accept` updates them.
#include "../scenes/EveryScene.h"

#include <session/GoldenScenes.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace boxreel
{
namespace
{

class GoldenScenes : public testing::TestWithParam<SceneCase>
{};

TEST_P(GoldenScenes, LookAndMoveAsApproved)
{
    const ReferenceStore store(BOXREEL_REFERENCES, BOXREEL_GOLDEN_OUTPUT);
    Result<Renderer> renderer = CreateGoldenRenderer();
    ASSERT_TRUE(renderer) << renderer.GetError().Text();
    const Result<std::vector<GoldenVerdict>> verdicts =
        VerifyGolden(GoldenSelection{GetParam(), ""}, store, *renderer);
    ASSERT_TRUE(verdicts) << verdicts.GetError().Text();
    EXPECT_EQ(verdicts->size(), 3u);
    for (const GoldenVerdict& verdict : *verdicts)
    {
        EXPECT_EQ(verdict.status, GoldenStatus::Same) << verdict.name << ": " << verdict.Text();
    }
}

/// Returns the size of the files below a folder [bytes].
std::uintmax_t SizeOf(const std::filesystem::path& folder)
{
    std::uintmax_t size = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        size += entry.is_regular_file() ? entry.file_size() : 0;
    }
    return size;
}

TEST(GoldenReferences, TakeLessThanFiveMegabytes)
{
    const std::uintmax_t size = SizeOf(BOXREEL_REFERENCES) + SizeOf(BOXREEL_SCRIPTS "/references");
    EXPECT_GT(size, 1'000'000u);
    EXPECT_LT(size, 5'000'000u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenScenes, testing::ValuesIn(EveryScene()), CaseName);

} // namespace
} // namespace boxreel
