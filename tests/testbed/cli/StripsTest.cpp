// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <cli/Strips.h>
#include <session/GoldenScenes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Returns a moment as if step 12 of bridge were the first to differ, by body 17.
ReportedMoment Parted(const std::string& name, std::int64_t first = 12, std::int64_t last = 30)
{
    ReportedMoment moment;
    moment.shown.name = name;
    moment.shown.status = "state";
    moment.shown.firstStep = first;
    moment.shown.lastStep = last;
    moment.shown.firstBodies = {17};
    const Result<GoldenRun> run = SimulateGolden(*SelectGolden("bridge"), first);
    moment.shown.firstHash = run->trace.steps.back().world;
    return moment;
}

FilmStrip StripOf(const ReportedMoment& moment, const std::string& against = "")
{
    const auto strips = MakeStrips({moment}, against, Backend::Auto);
    EXPECT_TRUE(strips) << strips.GetError().Text();
    return strips && strips->contains(moment.shown.name) ? strips->at(moment.shown.name)
                                                         : FilmStrip{};
}

TEST(StepsAround, AreDenseAtFirstAndEndAtLast)
{
    EXPECT_THAT(StepsAround(43, 120), ElementsAre(41, 42, 43, 44, 47, 55, 73, 103, 120));
    EXPECT_THAT(StepsAround(1, 2), ElementsAre(0, 1, 2));
    EXPECT_THAT(StepsAround(0, 0), ElementsAre(0));
    EXPECT_THAT(StepsAround(300, 300), ElementsAre(298, 299, 300));
    EXPECT_THAT(StepsAround(121, 300), SizeIs(10));
}

TEST(FilmStrips, ShowStepsAroundFirstDifferenceAndMarkBody)
{
    const FilmStrip strip = StripOf(Parted("bridge/0.5s"));
    EXPECT_EQ(strip.note, "");
    std::vector<std::int64_t> steps;
    for (const FilmStrip::Picture& picture : strip.pictures)
    {
        steps.push_back(picture.step);
        EXPECT_THAT(picture.actual, testing::StartsWith("\x89PNG"));
        EXPECT_THAT(picture.closeUp, testing::StartsWith("\x89PNG"));
        EXPECT_NE(picture.actual, picture.closeUp);
        EXPECT_EQ(picture.expected, "");
        ASSERT_THAT(picture.mark, SizeIs(4));
        EXPECT_LE(picture.mark[0] + picture.mark[2], strip.width);
        EXPECT_LE(picture.mark[1] + picture.mark[3], strip.height);
        EXPECT_LT(picture.mark[2], strip.width / 8) << "a plank, not the bridge";
    }
    EXPECT_THAT(steps, ElementsAre(10, 11, 12, 13, 16, 24, 30));
    EXPECT_NE(strip.pictures.front().actual, strip.pictures.back().actual);
}

TEST(FilmStrips, AreOmittedWhenProgramDiffersFromVerdict)
{
    ReportedMoment moment = Parted("bridge/0.5s");
    moment.shown.firstHash = "00000000";
    const FilmStrip strip = StripOf(moment);
    EXPECT_THAT(strip.pictures, IsEmpty());
    EXPECT_NE(strip.note, "");
}

TEST(FilmStrips, AreOmittedForStepsAfterTheMoment)
{
    ReportedMoment moment = Parted("bridge/0.5s");
    moment.shown.firstStep = moment.shown.lastStep = 4'000'000'000'000'000'000; // years
    EXPECT_THAT(StripOf(moment).pictures, IsEmpty());
    EXPECT_NE(StripOf(moment).note, "");
    moment = Parted("bridge/0.5s", 12, 31); // a step beyond half a second
    EXPECT_THAT(StripOf(moment).pictures, IsEmpty());
    EXPECT_NE(StripOf(moment).note, "");
}

TEST(FilmStrips, UseEarliestMomentOfScene)
{
    const auto strips =
        MakeStrips({Parted("bridge/0.5s"), Parted("bridge/2s", 31, 120)}, "", Backend::Auto);
    ASSERT_TRUE(strips);
    EXPECT_THAT(strips->at("bridge/0.5s").pictures, testing::Not(IsEmpty()));
    EXPECT_THAT(strips->at("bridge/2s").pictures, IsEmpty());
    EXPECT_EQ(strips->at("bridge/2s").earlier, "bridge/0.5s");
    EXPECT_EQ(strips->at("bridge/2s").note, "step 12");
}

TEST(FilmStrips, AreOmittedForUnknownScenes)
{
    EXPECT_THAT(StripOf(Parted("seesaw/1s")).pictures, IsEmpty());
    ReportedMoment film = Parted("bridge/0.5s"); // a film may be called so, too
    film.shown.firstHash = "";
    EXPECT_THAT(*MakeStrips({film}, "", Backend::Auto), IsEmpty());
}

TEST(FilmStrips, ShowPicturesOfOtherProgram)
{
    const auto strips = MakeStrips({Parted("bridge/0.5s")}, "/bin/true", Backend::Auto);
    EXPECT_THAT(strips, Refuses("--against /bin/true"));
}

} // namespace
} // namespace boxreel
