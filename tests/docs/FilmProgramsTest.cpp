// SPDX-License-Identifier: MIT
// The programs of docs/recording.md.
#include "../base/TemporaryFolder.h"
#include "Shown.h"

#include <recorder/VideoReader.h>

#include <gmock/gmock.h>

#include <cstdlib>

using namespace boxreel;

namespace
{

int RunIn(const TemporaryFolder& folder, const char* program)
{
    return std::system(("cd '" + (folder / "").string() + "' && " + program).c_str());
}

std::vector<Frame> Decode(const std::filesystem::path& path)
{
    std::vector<Frame> frames;
    Result<VideoReader> reader = VideoReader::Open(path);
    EXPECT_TRUE(reader);
    Frame frame;
    while (reader && *reader->Next(frame))
    {
        frames.push_back(frame);
    }
    return frames;
}

TEST(FilmPrograms, MakeFilmOfAWorld)
{
    const TemporaryFolder folder;
    ASSERT_EQ(RunIn(folder, BOXREEL_FILM_WORLD), 0);
    const std::vector<Frame> frames = Decode(folder / "ball.mp4");
    ASSERT_EQ(frames.size(), 240u);
    EXPECT_EQ(frames[0].width, 640);
    EXPECT_NE(frames[0], frames[60]) << "it falls";
    EXPECT_THAT(folder.Names(), testing::ElementsAre("ball.mp4"));
}

TEST(FilmPrograms, NameFileThatExists)
{
    const TemporaryFolder folder;
    ASSERT_EQ(RunIn(folder, BOXREEL_FILM_WORLD), 0);
    ASSERT_NE(RunIn(folder, BOXREEL_FILM_WORLD " > said"), 0);
    EXPECT_THAT(ReadBytes(folder / "said"), testing::HasSubstr("ball.mp4"));
}

TEST(FilmPrograms, MakeFilmOfPixels)
{
    const TemporaryFolder folder;
    ASSERT_EQ(RunIn(folder, BOXREEL_FILM_PIXELS), 0);
    const std::vector<Frame> frames = Decode(folder / "rise.webp");
    ASSERT_EQ(frames.size(), 36u);
    EXPECT_EQ(frames[10].Pixel(7, 25)[1], 255);
    EXPECT_EQ(frames[10].Pixel(7, 24)[1], 0);
}

TEST(FilmPrograms, MakePageOfAWorld)
{
    const TemporaryFolder folder;
    ASSERT_EQ(RunIn(folder, BOXREEL_FILM_PAGE), 0);
    EXPECT_THAT(ReadBytes(folder / "ball.html"),
                testing::AllOf(testing::HasSubstr("\"frames\":240"),
                               testing::HasSubstr("<title>A ball</title>"),
                               testing::HasSubstr("\"names\":{\"1\":\"ball\"}")));
    EXPECT_THAT(folder.Names(), testing::ElementsAre("ball.html"));
}

TEST(FilmPrograms, AreShownUnchangedInTheDocumentation)
{
    EXPECT_TRUE(IsShown("film_world.cpp", "recording.md"));
    EXPECT_TRUE(IsShown("film_pixels.cpp", "recording.md"));
    EXPECT_TRUE(IsShown("film_page.cpp", "recording.md"));
}

} // namespace
