// SPDX-License-Identifier: MIT
// The parts of a FilmRun, each by itself.
#include "../cli/Subprocess.h"

#include <film/FilmManifest.h>
#include <film/FilmSimulation.h>
#include <film/FilmThumbnail.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

struct RunParts : testing::Test
{
    TemporaryFolder folder;
    RecordOptions options;
    b2World world{b2Vec2(0.0f, -10.0f)};

    RunParts()
    {
        options.scene = "pyramid";
        options.output = folder / "a.mkv";
        options.arguments = {"record", "pyramid"};
        options.length.frames = 200;
        options.film.framesPerSecond = {30, 1};
    }
    FilmPlan Plan() const { return *PlanFilm(options); }
};

using FilmManifestTest = RunParts;

TEST_F(FilmManifestTest, NotesStatesWhereGroupsBegin)
{
    const FilmPlan plan = Plan();
    FilmManifest manifest(options, plan);
    ASSERT_TRUE(manifest.IsKept());
    ASSERT_TRUE(manifest.Note(99, world));
    EXPECT_THAT(folder.Names(), IsEmpty());
    ASSERT_TRUE(manifest.Note(100, world));
    EXPECT_THAT(folder.Names(), ElementsAre("a.part.mkv.json"));
    manifest.Remove();
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(FilmManifestTest, FindsPartOfTheSameFilmOnly)
{
    options.film.resume = true;
    const FilmPlan plan = Plan();
    EXPECT_FALSE(*FilmManifest(options, plan).FindLeft()) << "nothing is there";
    ASSERT_TRUE(FilmManifest(options, plan).Note(0, world));
    EXPECT_TRUE(*FilmManifest(options, plan).FindLeft());
    RecordOptions other = options;
    other.arguments = {"record", "bridge"};
    const Result<bool> refused = FilmManifest(other, plan).FindLeft();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(refused.GetError().culprit, (folder / "a.part.mkv").string());
}

TEST_F(FilmManifestTest, FindsOnlyTheFramesThatWereAsked)
{
    options.film.resume = true;
    options.length.range = *FrameRange::Parse("100-199");
    const FilmPlan plan = Plan();
    ASSERT_TRUE(FilmManifest(options, plan).Note(100, world));
    EXPECT_TRUE(*FilmManifest(options, plan).FindLeft());
    for (const char* const range : {"100-120", "100-198", "100-150,152-199"})
    {
        options.length.range = *FrameRange::Parse(range);
        const FilmPlan other = Plan();
        const Result<bool> refused = FilmManifest(options, other).FindLeft();
        ASSERT_FALSE(refused) << range;
        EXPECT_EQ(refused.GetError().kind, ErrorKind::Unusable);
        EXPECT_EQ(refused.GetError().culprit, (folder / "a.part.mkv").string());
    }
}

TEST_F(FilmManifestTest, RefusesAnotherStateOfTheSameFrame)
{
    options.film.resume = true;
    const FilmPlan plan = Plan();
    ASSERT_TRUE(FilmManifest(options, plan).Note(0, world));
    FilmManifest second(options, plan);
    ASSERT_TRUE(*second.FindLeft());
    b2BodyDef def;
    world.CreateBody(&def);
    const Result<void> noted = second.Note(0, world);
    ASSERT_FALSE(noted);
    EXPECT_EQ(noted.GetError().culprit, (folder / "a.part.mkv").string());
}

using FilmThumbnailTest = RunParts;

TEST_F(FilmThumbnailTest, ShowsTheMiddleUnlessATimeIsGiven)
{
    const FilmPlan plan = Plan();
    const FilmThumbnail thumbnail(options, plan);
    EXPECT_FALSE(thumbnail.IsWanted());
    EXPECT_EQ(thumbnail.Index(), 100);
    options.thumbnail = {folder / "t.png", Duration{1'000'000'000}};
    EXPECT_TRUE(thumbnail.IsWanted());
    EXPECT_EQ(thumbnail.Index(), 30);
    options.thumbnail.at = Duration{100'000'000'000};
    EXPECT_EQ(thumbnail.Index(), 199) << "the last";
}

using FilmSimulationTest = RunParts;

TEST_F(FilmSimulationTest, SimulatesTheStepsThatAFrameShows)
{
    options.length.from = Duration{1'000'000'000};
    Progress progress(ProgressMode::None);
    FilmSimulation simulation(options, nullptr, progress, nullptr);
    ASSERT_TRUE(simulation.Open(*OpenScene(options.scene)));
    simulation.Begin(0);
    EXPECT_TRUE(simulation.AdvanceTo(3));
    EXPECT_EQ(simulation.Session().Step(), 60 + 6);
    simulation.FinishAt(10);
    EXPECT_EQ(simulation.Session().Step(), 60 + 20);
    EXPECT_EQ(simulation.Totals().firstStep, 0);
    EXPECT_EQ(simulation.Totals().steps, 80);
}

} // namespace
} // namespace boxreel
