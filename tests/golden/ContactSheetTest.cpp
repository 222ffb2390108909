// SPDX-License-Identifier: MIT
// Films as contact sheets, and as golden tests.
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "Environment.h"
#include "TestPictures.h"

#include <golden/ContactSheet.h>
#include <golden/GoldenTest.h>
#include <golden/ReferenceStore.h>
#include <recorder/VideoWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>

#include <optional>
#include <string>
#include <tuple>

using namespace boxreel;
using namespace boxreel::test;
using testing::ElementsAre;

namespace
{

/// Lossless, 64x32; each second has a gray of its own, 40 more than the one before, and one pixel
/// column that is white.
std::filesystem::path Film(const TemporaryFolder& folder, const std::string& name, int fps,
                           double seconds, int seed = 0)
{
    const std::filesystem::path path = folder / name;
    VideoSettings settings;
    settings.framesPerSecond = Rational{fps, 1};
    settings.width = 64;
    settings.height = 32;
    settings.quality = Quality::Lossless;
    Result<VideoWriter> writer = VideoWriter::Open(path, settings);
    EXPECT_TRUE(writer);
    for (int i = 0; i < int(seconds * fps); ++i)
    {
        const int second = i / fps;
        const auto gray = std::uint8_t(40 * second + (second >= 2 ? seed : 0));
        Frame frame = Filled(64, 32, {gray, gray, gray, 255});
        FillRect(frame, 10, 0, 11, 32, {255, 255, 255, 255});
        EXPECT_TRUE(writer->Append(frame));
    }
    EXPECT_TRUE(writer->Close());
    return path;
}

ContactSheet SheetOf(const std::filesystem::path& film, const ContactSheetSettings& settings)
{
    Result<ContactSheet> sheet = ContactSheetOf(film, settings);
    EXPECT_TRUE(sheet) << sheet.GetError().Text();
    return sheet ? *std::move(sheet) : ContactSheet{};
}

/// Returns the grays at the right end of each picture.
std::vector<int> Grays(const ContactSheet& sheet)
{
    std::vector<int> grays;
    for (std::size_t i = 0; i < sheet.layout.pictures; ++i)
    {
        const PixelBounds place = sheet.layout.Place(i);
        grays.push_back(sheet.frame.Pixel(place.x1 - 1, place.y1 - 1)[0]);
    }
    return grays;
}

TEST(ContactSheet, HasAPictureForEachIntervalOfSteps)
{
    const TemporaryFolder folder;
    const std::filesystem::path film = Film(folder, "film.mkv", 60, 4.0);
    const ContactSheet seconds = SheetOf(film, {.every = 60});
    EXPECT_EQ(seconds.layout.Step(3), 180);
    EXPECT_THAT(Grays(seconds), ElementsAre(0, 40, 80, 120));
    EXPECT_EQ(seconds.frame.width, 4 * 64 + 3 * 2);
    EXPECT_EQ(seconds.frame.height, 32);
    const ContactSheet more = SheetOf(film, {.every = 50, .columns = 3});
    EXPECT_THAT(Grays(more), ElementsAre(0, 0, 40, 80, 120));
    EXPECT_EQ(more.frame.width, 3 * 64 + 2 * 2);
    EXPECT_EQ(more.frame.height, 2 * 32 + 2);
    EXPECT_EQ(more.frame.Pixel(64, 0)[0], 128) << "gray between them";
    EXPECT_EQ(more.frame.Pixel(190, 60)[0], 128) << "and where the last row ends";
}

TEST(ContactSheet, IsTheSameForEveryRateOfFrames)
{
    const TemporaryFolder folder;
    const ContactSheetSettings each{.every = 30};
    const ContactSheet sheet = SheetOf(Film(folder, "60.mkv", 60, 3.0), each);
    EXPECT_EQ(SheetOf(Film(folder, "30.mkv", 30, 3.0), each).frame, sheet.frame);
    EXPECT_EQ(SheetOf(Film(folder, "4.mkv", 4, 3.0), each).frame, sheet.frame);
    EXPECT_EQ(SheetOf(Film(folder, "20.gif", 20, 3.0), each).frame, sheet.frame);
    EXPECT_EQ(SheetOf(folder / "60.mkv", {.stepsPerSecond = 240.0, .every = 120}).frame,
              sheet.frame)
        << "other steps, the same moments";
}

TEST(ContactSheet, ShrinksToTheMeanOfWhatAPixelCovers)
{
    const TemporaryFolder folder;
    const ContactSheet sheet =
        SheetOf(Film(folder, "film.mkv", 10, 1.0), {.every = 60, .width = 24});
    EXPECT_EQ(sheet.layout.width, 24);
    EXPECT_EQ(sheet.layout.height, 12);
    // Column 10 of 64 covers 3.75 to 4.125 of 24: a quarter and an eighth of a pixel.
    EXPECT_THAT((std::vector<int>{sheet.frame.Pixel(2, 5)[0], sheet.frame.Pixel(3, 5)[0],
                                  sheet.frame.Pixel(4, 5)[0], sheet.frame.Pixel(5, 5)[0]}),
                ElementsAre(0, 64, 32, 0));
}

TEST(ContactSheet, IsRefusedForInvalidFilmOrSettings)
{
    const TemporaryFolder folder;
    const std::filesystem::path film = Film(folder, "film.mkv", 60, 5.0);
    const std::filesystem::path nothing = folder / "nothing.mkv";
    EXPECT_THAT(ContactSheetOf(nothing), Refuses(nothing.string()));
    EXPECT_THAT(ContactSheetOf(film, {.every = 0}), Refuses(film.string()));
    EXPECT_THAT(ContactSheetOf(film, {.stepsPerSecond = 0.0}), Refuses(film.string()));
    EXPECT_THAT(ContactSheetOf(film, {.columns = 0}), Refuses(film.string()));
    EXPECT_THAT(ContactSheetOf(film, {.every = 1}), RefusesWith(film.string(), "256"));
}

TEST(ContactSheet, FailsGoldenTestWhenFilmChanged)
{
    const TemporaryFolder folder;
    GoldenEnvironment environment;
    environment.references.Set((folder / "approved").c_str());
    environment.output.Set((folder / "output").c_str());
    const std::string film = Film(folder, "film.mkv", 30, 4.0).string();
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_FILM(film, "film/grays"),
                            "BOXREEL_GOLDEN_ACCEPT=missing");
    environment.accept.Set("missing");
    EXPECT_GOLDEN_FILM(film, "film/grays");
    environment.accept.Set(nullptr);
    EXPECT_GOLDEN_FILM(film, "film/grays");
    const std::string other = Film(folder, "other.mkv", 30, 4.0, 4).string();
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_FILM(other, "film/grays"), "film/grays: ");
    EXPECT_TRUE(std::filesystem::exists(folder / "output/film/grays.side-by-side.png"));
    EXPECT_GOLDEN_FILM(other, "film/grays", {}, {.tolerance = 0.1});
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_FILM("nothing.mkv", "film/grays"), "nothing.mkv");
}

TEST(ContactSheet, DiffersInFirstStepPicturesAndMoments)
{
    const TemporaryFolder folder;
    const ReferenceStore store(folder / "approved", folder / "output");
    const std::filesystem::path film = Film(folder, "film.mkv", 30, 4.0);
    ASSERT_TRUE(store.Accept(CandidateOf(SheetOf(film, {}), "grays")));
    const auto compare = [&](const std::filesystem::path& path,
                             const ContactSheetSettings& settings = {}) {
        const GoldenVerdict verdict = *store.Judge(CandidateOf(SheetOf(path, settings), "grays"));
        EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
        return verdict.film.value_or(FilmComparison{});
    };
    EXPECT_EQ(compare(Film(folder, "other.mkv", 30, 4.0, 4)).firstStep, 120);
    for (const auto& [seconds, pictures, firstStep] : {std::tuple(2.5, 5u, 150), {1.5, 3u, 90}})
    {
        const FilmComparison shorter =
            compare(Film(folder, std::to_string(pictures) + ".mkv", 30, seconds));
        EXPECT_EQ(shorter.actual.pictures, pictures);
        EXPECT_EQ(shorter.expected.pictures, 8u);
        EXPECT_EQ(shorter.firstStep, firstStep);
    }
    const FilmComparison smaller = compare(film, {.width = 32});
    EXPECT_EQ(smaller.actual.width, 32);
    EXPECT_EQ(smaller.expected.width, 64);
    EXPECT_EQ(smaller.firstStep, std::nullopt);
    EXPECT_FALSE(smaller.HasOtherMoments());
    for (const ContactSheetSettings& settings :
         {ContactSheetSettings{.every = 60}, {.stepsPerSecond = 120.0, .every = 60}})
    {
        const FilmComparison others = compare(film, settings);
        EXPECT_TRUE(others.HasOtherMoments());
        EXPECT_EQ(others.actual.every, 60);
        EXPECT_EQ(others.expected.every, 30);
        EXPECT_EQ(others.actual.stepsPerSecond, settings.stepsPerSecond);
    }
}

TEST(ContactSheet, FailsGoldenTestWhenReferenceIsDamaged)
{
    const TemporaryFolder folder;
    GoldenEnvironment environment;
    environment.references.Set((folder / "approved").c_str());
    environment.output.Set((folder / "output").c_str());
    const std::string film = Film(folder, "film.mkv", 30, 2.0).string();
    environment.accept.Set("missing");
    EXPECT_GOLDEN_FILM(film, "torn");
    environment.accept.Set(nullptr);
    std::filesystem::remove(folder / "approved/frames/torn.png");
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_FILM(film, "torn"), "frames/torn.png");
    environment.accept.Set("missing");
    EXPECT_GOLDEN_FILM(film, "grays");
    environment.accept.Set(nullptr);
    EXPECT_GOLDEN_FILM(film, "grays");
    for (const char* const text :
         {"", "every 30 steps, 60 a second\n",
          "every 30 steps, 60 a second\n4 pictures of 64x33, 4 in a row\n",
          "every 30 steps, 60 a second\n5 pictures of 64x32, 4 in a row\n",
          "every 30 steps, 60 a second\n4 pictures of 64x32, 4 in a row\nand more\n",
          "every 30 steps, 60 a second\n0 pictures of 64x32, 0 in a row\n",
          "every 30 steps, 60 a second\n4 pictures of -64x99999, 999 in a row\n"})
    {
        std::ofstream(folder / "approved/sheet/grays.txt") << text;
        EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_FILM(film, "grays"), (folder / "approved").string());
    }
}

} // namespace
