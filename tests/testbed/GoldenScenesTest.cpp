// SPDX-License-Identifier: MIT
// Every scene against what was approved; `boxreel golden accept` approves.
#include "GoldenScenes.h"
#include "EveryScene.h"

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
    ASSERT_TRUE(renderer) << renderer.GetError().message;
    const Result<std::vector<GoldenVerdict>> verdicts =
        VerifyGolden(GoldenSelection{GetParam(), ""}, store, *renderer);
    ASSERT_TRUE(verdicts) << verdicts.GetError().message;
    EXPECT_EQ(verdicts->size(), 3u);
    for (const GoldenVerdict& verdict : *verdicts)
    {
        EXPECT_EQ(verdict.status, GoldenStatus::Same) << verdict.name << ": " << verdict.message;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenScenes, testing::ValuesIn(EveryScene()), CaseName);

} // namespace
} // namespace boxreel
