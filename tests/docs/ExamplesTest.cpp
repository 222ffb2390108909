// SPDX-License-Identifier: MIT
// The programs, files and pictures of the pages of docs/examples.
#include "../base/TemporaryFolder.h"
#include "Shown.h"

#include <recorder/VideoReader.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

using namespace boxreel;

namespace
{

const std::filesystem::path kExamples = BOXREEL_DOCS "/examples";

/// Returns the output of the program; its exit code must be 0.
std::string OutputIn(const TemporaryFolder& folder, const std::string& command)
{
    const std::string line = "cd '" + (folder / "").string() + "' && " + command + " > output 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << ReadBytes(folder / "output");
    return ReadBytes(folder / "output");
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

/// True if a page has a block of that language with exactly this text.
bool HasBlock(const std::string& page, const std::string& language, const std::string& text)
{
    return !text.empty() &&
           ReadBytes(kExamples / page).find("```" + language + "\n" + text + "```\n") !=
               std::string::npos;
}

TEST(Examples, AreShownUnchangedOnTheirPages)
{
    EXPECT_TRUE(IsShown("hello_world.cpp", "examples/hello-world.md"));
    EXPECT_TRUE(IsShown("film_catapult.cpp", "examples/own-film.md"));
    EXPECT_TRUE(IsShown("film_wall.cpp", "examples/own-colours.md"));
    EXPECT_TRUE(IsShown("sweep.cpp", "examples/parameter-sweep.md"));
    EXPECT_TRUE(IsShown("box2d24_film.cpp", "examples/box2d24.md"));
    EXPECT_TRUE(IsShown("porting/before/main.cpp", "examples/port-box2d24.md"));
    EXPECT_TRUE(IsShown("porting/after/main.cpp", "examples/port-box2d24.md"));
    for (const char* const list : {"porting/before/CMakeLists.txt", "porting/after/CMakeLists.txt"})
    {
        EXPECT_TRUE(HasBlock("port-box2d24.md", "cmake", ReadBytes(kExamples / list))) << list;
    }
    EXPECT_TRUE(HasBlock("scene-file.md", "json", ReadBytes(kExamples / "short.json")));
    EXPECT_TRUE(HasBlock("golden-ci.md", "yaml",
                         ReadBytes(kExamples / "golden-ci/.github/workflows/golden.yml")));
}

/// Returns the lines of the README's first block of that language.
std::ptrdiff_t ReadmeLines(const std::string& language)
{
    const std::string page = ReadBytes(BOXREEL_DOCS "/../README.md");
    const std::string fence = "```" + language + "\n";
    const std::size_t at = page.find(fence);
    EXPECT_NE(at, std::string::npos) << language;
    const auto begin = page.begin() + std::ptrdiff_t(std::min(page.size(), at + fence.size()));
    const auto end = page.begin() + std::ptrdiff_t(std::min(page.size(), page.find("```", at + 3)));
    return std::count(begin, end, '\n');
}

TEST(Examples, AreShortInTheReadme)
{
    EXPECT_LE(ReadmeLines("cpp"), 15);
    EXPECT_LE(ReadmeLines("python"), 4);
    EXPECT_LE(ReadmeLines("cmake"), 10);
}

TEST(Examples, PrintWhatThePageOfHelloWorldShows)
{
    const TemporaryFolder folder;
    std::istringstream output(OutputIn(folder, BOXREEL_HELLO_WORLD));
    std::vector<std::string> lines;
    for (std::string line; std::getline(output, line);)
    {
        lines.push_back(line + "\n");
    }
    ASSERT_EQ(lines.size(), 60u);
    const std::string shown =
        lines[0] + lines[1] + lines[2] + "...\n" + lines[57] + lines[58] + lines[59];
    EXPECT_TRUE(HasBlock("hello-world.md", "text", shown)) << shown;
}

TEST(Examples, EndFilmOfCatapultWhenAllRests)
{
    const TemporaryFolder folder;
    OutputIn(folder, BOXREEL_FILM_CATAPULT);
    const std::vector<Frame> frames = Decode(folder / "catapult.mp4");
    ASSERT_GT(frames.size(), 90u) << "it throws for seconds";
    ASSERT_LT(frames.size(), 600u) << "1200 steps are its end when nothing rests";
    EXPECT_EQ(frames[0].width, 480);
    EXPECT_NE(frames[0], frames[60]);
}

TEST(Examples, NameFileThatCatapultCannotWrite)
{
    const TemporaryFolder folder;
    const std::string command = "cd '" + (folder / "").string() + "' && ";
    EXPECT_NE(std::system((command + BOXREEL_FILM_CATAPULT " film.doc 2> said").c_str()), 0);
    EXPECT_THAT(ReadBytes(folder / "said"), testing::HasSubstr("film.doc"));
}

TEST(Examples, KeepFilmOfWallSmallInLightAndDark)
{
    const TemporaryFolder folder;
    OutputIn(folder, BOXREEL_FILM_WALL " light.webp");
    OutputIn(folder, BOXREEL_FILM_WALL " dark.webp dark");
    const std::vector<Frame> light = Decode(folder / "light.webp");
    const std::vector<Frame> dark = Decode(folder / "dark.webp");
    ASSERT_EQ(light.size(), 43u);
    ASSERT_EQ(dark.size(), 43u);
    EXPECT_GT(light[0].Pixel(440, 5)[0], 240) << "white paper";
    EXPECT_LT(dark[0].Pixel(440, 5)[0], 20);
    EXPECT_LT(std::filesystem::file_size(folder / "light.webp"), 950'000u);
    EXPECT_LT(std::filesystem::file_size(folder / "dark.webp"), 950'000u);
}

TEST(Examples, DrawSixPicturesOfSweepInTwoThemes)
{
    const TemporaryFolder folder;
    OutputIn(folder, BOXREEL_SWEEP);
    const std::string svg = ReadBytes(folder / "sweep-light.svg");
    EXPECT_NE(svg, ReadBytes(folder / "sweep-dark.svg"));
    for (const char* const value : {"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"})
    {
        EXPECT_THAT(svg, testing::HasSubstr(std::string(">restitution ") + value + "</text>"));
    }
    EXPECT_THAT(ReadBytes(folder / "sweep.pdf"), testing::StartsWith("%PDF"));
}

TEST(Examples, RefusePngOfSweep)
{
    const TemporaryFolder folder;
    const std::string command = "cd '" + (folder / "").string() + "' && ";
    EXPECT_NE(std::system((command + BOXREEL_SWEEP " sweep.png 2> said").c_str()), 0);
    EXPECT_THAT(ReadBytes(folder / "said"), testing::StartsWith("sweep.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "sweep.png"));
}

TEST(Examples, PrintWhatThePageOfThePortShows)
{
    const TemporaryFolder folder;
    const std::string output = OutputIn(folder, BOXREEL_PORT_AFTER);
    EXPECT_TRUE(HasBlock("port-box2d24.md", "text", output)) << output;
}

#ifdef BOXREEL_BOX2D24_FILM
TEST(Examples, PrintTheSameBeforeAndAfterThePort)
{
    const TemporaryFolder folder;
    EXPECT_EQ(OutputIn(folder, BOXREEL_PORT_BEFORE), OutputIn(folder, BOXREEL_PORT_AFTER));
}

TEST(Examples, FilmAWorldOfBox2D24)
{
    const TemporaryFolder folder;
    OutputIn(folder, BOXREEL_BOX2D24_FILM);
    const std::vector<Frame> frames = Decode(folder / "bridge.mp4");
    ASSERT_EQ(frames.size(), 120u);
    EXPECT_NE(frames[0], frames[60]) << "boxes fall";
    EXPECT_NE(frames[0].Pixel(30, 150)[1], frames[0].Pixel(240, 250)[1]) << "a bank, and nothing";
}
#else
TEST(Examples, FilmAWorldOfBox2D24)
{
    GTEST_SKIP() << "Box2D 2.4 is not installed; apt install libbox2d-dev and configure again";
}
#endif

TEST(Examples, AreAllListedOnTheFirstPage)
{
    const std::string list = ReadBytes(kExamples / "README.md");
    int pages = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kExamples))
    {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".md") && name != "README.md")
        {
            ++pages;
            EXPECT_THAT(list, testing::HasSubstr("](" + name + ")"));
        }
    }
    EXPECT_EQ(pages, 9);
}

TEST(Examples, ShowAndMakeEveryPicture)
{
    std::string pages = ReadBytes(kExamples.parent_path().parent_path() / "README.md");
    for (const auto& entry : std::filesystem::directory_iterator(kExamples))
    {
        if (entry.path().extension() == ".md")
        {
            pages += ReadBytes(entry.path());
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator(kExamples / "pictures"))
    {
        const std::string name = entry.path().filename().string();
        EXPECT_THAT(pages, testing::ContainsRegex("pictures/" + name + "[)\"]"));
        EXPECT_THAT(pages, testing::ContainsRegex("<!-- makes: [a-z/]*" + name + " -->"));
    }
}

} // namespace
