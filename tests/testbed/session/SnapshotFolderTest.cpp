// SPDX-License-Identifier: MIT
// The states that a session leaves to the next one. Whole films: SnapshotFilmTest.cpp.
#include "../../base/TemporaryFolder.h"
#include "../scenes/EveryScene.h"

#include <base/AtomicFile.h>
#include <session/SceneSearch.h>
#include <session/SnapshotFolder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace boxreel
{
namespace
{

TEST(SnapshotFolder, HasFewSnapshotsWithoutLargeGaps)
{
    int count = 0;
    std::int64_t last = 0;
    for (std::int64_t step = 1; step <= 1'000'000; ++step)
    {
        if (IsSnapshotDue(step, std::nullopt))
        {
            EXPECT_LE(step - last, std::max<std::int64_t>(100, step / 16)) << step;
            last = step;
            ++count;
            EXPECT_LE(count, step <= 51'200 ? 96 : 176) << step;
        }
    }
    EXPECT_GT(count, 96);
    EXPECT_FALSE(IsSnapshotDue(0, 7));
    EXPECT_TRUE(IsSnapshotDue(7'000'007, 7));
    EXPECT_FALSE(IsSnapshotDue(7'000'008, 7));
}

TEST(SnapshotFolder, RemovesPartialFilesOfKilledLocalRuns)
{
    const TemporaryFolder folder;
    char host[256] = "";
    ASSERT_EQ(gethostname(host, sizeof host - 1), 0);
    const std::string here = "part-" + SceneSlug(host) + "-";
    const auto leave = [&](const std::string& name) { std::ofstream(folder / name) << "half"; };
    const auto age = [&](const std::string& name) {
        std::filesystem::last_write_time(
            folder / name, std::filesystem::file_time_type::clock::now() - std::chrono::minutes(2));
    };
    const std::string others[] = {"a-1.part-elsewhere-1.snapshot", "a-1.snapshot", "a-1.png"};
    for (const std::string& name : others)
    {
        leave(name);
        age(name);
    }
    leave("a-1." + here + "11.snapshot");
    age("a-1." + here + "11.snapshot");
    leave("a-1." + here + "12.snapshot"); // perhaps just made by a run that goes on
    const Result<AtomicFile> written =
        AtomicFile::Create(folder / "a-1.snapshot", {.overwrite = true, .mark = here + "13"});
    ASSERT_TRUE(written);
    age("a-1." + here + "13.snapshot");
    ASSERT_TRUE(SnapshotFolder::Open(folder / ".", std::nullopt));
    EXPECT_THAT(folder.Names(), testing::UnorderedElementsAre(others[0], others[1], others[2],
                                                              "a-1." + here + "12.snapshot",
                                                              "a-1." + here + "13.snapshot"));
}

const ViewChoice kViews[] = {
    SceneView{},         FitView{},
    FitView{true},       FitBodiesView{{0, 1}},
    FollowView{{1}, {}}, FollowView{{1}, 12.0},
    FixedView{},         PathView{{{0.0, 0.0, 20.0, 50.0}, {3.0, 10.0, 5.0, 12.0}}}};

SceneSession Open(const SceneEntry& entry, const ViewChoice& view)
{
    SceneLook look;
    look.view = view;
    look.layers[DrawLayer::Contacts] = true;
    SceneSource source;
    source.entry = &entry;
    source.title = entry.name;
    Result<SceneSession> session = SceneSession::Open(std::move(source), look);
    EXPECT_TRUE(session) << session.GetError().Text();
    return std::move(*session);
}

class StateOfSession : public testing::TestWithParam<SceneCase>
{};

TEST_P(StateOfSession, ContinuesWithEqualPicturesForEveryCamera)
{
    for (const ViewChoice& view : kViews)
    {
        SceneSession saved = Open(*GetParam(), view);
        SceneSession restored = Open(*GetParam(), view);
        for (const std::int64_t step : {40, 170})
        {
            SCOPED_TRACE(TextOf(view) + " from " + std::to_string(step));
            saved.AdvanceTo(step);
            ASSERT_TRUE(restored.RestoreState(saved.SaveState()));
            EXPECT_EQ(restored.Step(), step);
            EXPECT_EQ(restored.Time(), saved.Time());
            for (std::int64_t later = step; later < step + 60; ++later)
            {
                EXPECT_TRUE(restored.CurrentCamera() == saved.CurrentCamera()) << later;
                saved.AdvanceTo(later + 1);
                restored.AdvanceTo(later + 1);
            }
            EXPECT_TRUE(restored.SaveState() == saved.SaveState());
            FrameContent here;
            FrameContent there;
            saved.Fill(here);
            restored.Fill(there);
            EXPECT_TRUE(here.list == there.list);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, StateOfSession, testing::ValuesIn(EveryScene()), CaseName);

TEST(SceneSessionState, RefusesStateOfOtherSceneOrCamera)
{
    const std::span<const SceneEntry> scenes = AllScenes();
    SceneSession session = Open(scenes[0], FitView{});
    session.AdvanceTo(30);
    const std::vector<std::uint8_t> before = session.SaveState();
    SceneSession follows = Open(scenes[0], FollowView{{3}, {}});
    EXPECT_FALSE(session.RestoreState(follows.SaveState()));
    for (std::size_t size = 0; size < before.size(); size += size < 200 ? 1 : 97)
    {
        EXPECT_FALSE(session.RestoreState(std::span(before).first(size))) << size;
    }
    std::vector<std::uint8_t> endless = before; // says that its camera has 2^56 numbers and more
    endless[15] = 1;
    EXPECT_FALSE(session.RestoreState(endless));
    std::vector<std::uint8_t> nowhere = before; // the last number of its camera is none
    std::fill_n(nowhere.begin() + 16 + 8 * (before[8] - 1), 8, std::uint8_t(255));
    EXPECT_FALSE(session.RestoreState(nowhere));
    EXPECT_TRUE(session.SaveState() == before);
}

TEST(SceneSessionState, HasDifferentOriginForEachSceneAndView)
{
    std::vector<std::string> origins;
    for (const SceneEntry& entry : AllScenes())
    {
        for (const ViewChoice& view : kViews)
        {
            origins.push_back(Open(entry, view).DescribeOrigin());
            EXPECT_EQ(origins.back(), Open(entry, view).DescribeOrigin());
        }
    }
    std::sort(origins.begin(), origins.end());
    EXPECT_EQ(std::adjacent_find(origins.begin(), origins.end()), origins.end());
}

} // namespace
} // namespace boxreel
