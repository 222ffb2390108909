// SPDX-License-Identifier: MIT
// The real program: exit codes, messages, and the files in the folder afterwards.
#include "Refusals.h"

#include <cli/OutputPath.h>
#include <render/Png.h>
#include <scenes/Scene.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Command : public testing::Test
{
protected:
    Outcome Run(const std::vector<std::string>& arguments) const
    {
        return RunBoxreel(arguments, folder.Path());
    }

    /// Runs what cannot work: the code, one line that names the culprit, nothing left behind.
    void ExpectRefusal(const std::vector<std::string>& arguments, int code,
                       const std::string& culprit) const
    {
        const std::vector<std::string> before = folder.Names();
        const Outcome outcome = Run(arguments);
        const std::string line = testing::PrintToString(arguments);
        SCOPED_TRACE(line);
        ExpectRefused(outcome, culprit, code);
        EXPECT_EQ(outcome.output, "") << line;
        EXPECT_EQ(folder.Names(), before) << line;
    }

    std::string Write(const std::string& name, const std::string& content) const
    {
        std::ofstream(folder / name, std::ios::binary) << content;
        return name;
    }

    std::string Picture(const std::string& name, int width, int height, std::uint8_t gray) const
    {
        Frame frame(width, height);
        std::fill(frame.rgba.begin(), frame.rgba.end(), gray);
        for (std::size_t i = 3; i < frame.rgba.size(); i += 4)
        {
            frame.rgba[i] = 255;
        }
        EXPECT_TRUE(WritePng(folder / name, frame));
        return name;
    }

    TemporaryFolder folder;
};

TEST_F(Command, NamesOptionOfEmptyFileName)
{
    const struct
    {
        std::vector<std::string> arguments;
        std::string culprit;
    } cases[] = {
        {{"merge", "", "-o", "x.mp4"}, "\"\""},
        {{"merge", "a.mp4", "", "-o", "x.mp4"}, "\"\""},
        {{"merge", "a.mp4", "-o", ""}, "-o"},
        {{"record", "", "-o", "x.gif"}, "\"\""},
        {{"record", "bridge", "-o", ""}, "-o"},
        {{"shot", "", "--at", "0s", "-o", "x.png"}, "\"\""},
        {{"shot", "bridge", "--at", "0s", "-o", ""}, "-o"},
        {{"diff", "", "b.png"}, "\"\""},
        {{"diff", "a.png", ""}, "\"\""},
        {{"diff", "a.png", "b.png", "-o", ""}, "-o"},
        {{"play", ""}, "\"\""},
        {{"check", ""}, "\"\""},
        {{"export", "bridge", "-o", ""}, "-o"},
        {{"golden", "verify", "--references", ""}, "--references"},
        {{"golden", "verify", "--output", ""}, "--output"},
        {{"golden", "accept", "--references", ""}, "--references"},
        {{"golden", "report", "-o", ""}, "-o"},
    };
    for (const auto& c : cases)
    {
        ExpectRefusal(c.arguments, 1, c.culprit);
    }
}

TEST_F(Command, PrintsOneNamePerLineForListNames)
{
    const Outcome outcome = Run({"list", "--names"});
    std::string expected;
    for (const SceneEntry& entry : AllScenes())
    {
        expected += std::string(entry.name) + "\n";
    }
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, expected);
    EXPECT_EQ(outcome.errors, "");
}

TEST_F(Command, ListsCategoryNameAndSummaryOfScenes)
{
    const Outcome outcome = Run({"list"});
    EXPECT_EQ(outcome.code, 0);
    for (const SceneEntry& entry : AllScenes())
    {
        EXPECT_THAT(outcome.output, HasSubstr(entry.name));
        EXPECT_THAT(outcome.output, HasSubstr(entry.category));
        EXPECT_THAT(outcome.output, HasSubstr(entry.summary));
    }
    EXPECT_THAT(outcome.output, testing::Not(HasSubstr("\x1b")));
}

TEST_F(Command, PrintsHelpAndVersionToStandardOutput)
{
    for (const char* option : {"--help", "--version"})
    {
        const Outcome outcome = Run({option});
        EXPECT_EQ(outcome.code, 0);
        EXPECT_THAT(outcome.output, HasSubstr("boxreel"));
        EXPECT_EQ(outcome.errors, "");
    }
}

TEST_F(Command, WritesShotOfGivenSize)
{
    const Outcome outcome =
        Run({"shot", "pyramid", "--step", "30", "-o", "a.png", "--size", "321x153", "--hud"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output + outcome.errors, "");
    EXPECT_THAT(folder.Names(), ElementsAre("a.png"));
    const Result<Frame> frame = ReadPng(folder / "a.png");
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->width, 321);
    EXPECT_EQ(frame->height, 153);
}

TEST_F(Command, WritesEqualShotsForTimeAndStep)
{
    for (const char* at : {"500ms", "0.5s", "0.5"})
    {
        EXPECT_EQ(
            Run({"shot", "bridge", "--at", at, "-o", "time.png", "--size", "160x90", "--force"})
                .code,
            0);
        EXPECT_EQ(
            Run({"shot", "bridge", "--step", "30", "-o", "step.png", "--size", "160x90", "--force"})
                .code,
            0);
        EXPECT_EQ(ReadBytes(folder / "time.png"), ReadBytes(folder / "step.png"));
    }
}

TEST_F(Command, WritesShotsOfAnySize)
{
    const std::pair<const char*, std::pair<int, int>> sizes[] = {
        {"1x1", {1, 1}}, {"33x17", {33, 17}}, {"8192x3", {8192, 3}}, {"3x8191", {3, 8191}}};
    for (const auto& [size, expected] : sizes)
    {
        const Outcome outcome = Run({"shot", "bridge", "--step", "1", "-o", "odd.png", "--size",
                                     size, "--camera", "follow:3:5", "--force"});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        const Result<Frame> frame = ReadPng(folder / "odd.png");
        ASSERT_TRUE(frame);
        EXPECT_EQ(std::pair(frame->width, frame->height), expected);
    }
}

TEST_F(Command, RefusesCamerasOnMissingBodies)
{
    for (const char* camera : {"follow:3,9999", "fit:9999", "follow:9999:10"})
    {
        ExpectRefusal({"shot", "bridge", "--step", "1", "-o", "a.png", "--camera", camera}, 1,
                      "--camera 9999");
        ExpectRefusal({"record", "bridge", "-o", "a.mp4", "--camera", camera}, 1, "--camera 9999");
    }
    ExpectRefusal({"record", "bridge", "-o", "a.mp4", "--camera", "path:2s=0,0,5;1s=0,0,5"}, 1,
                  "--camera path:2s=0,0,5;1s=0,0,5");
}

TEST_F(Command, ChangesPictureByLookOptions)
{
    const std::vector<std::string> plain{"shot",   "bridge",  "--step", "20",
                                         "--size", "320x180", "-o"};
    const auto shot = [&](const std::string& name, const std::vector<std::string>& extra) {
        std::vector<std::string> arguments = plain;
        arguments.push_back(name);
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        EXPECT_EQ(Run(arguments).code, 0) << testing::PrintToString(arguments);
        return ReadBytes(folder / name);
    };
    const std::string picture = shot("plain.png", {});
    EXPECT_EQ(picture, shot("again.png", {}));
    EXPECT_NE(picture, shot("hud.png", {"--hud"}));
    EXPECT_NE(picture, shot("camera.png", {"--camera", "0,0,30"}));
    EXPECT_NE(picture, shot("bodies.png", {"--camera", "fit:3,5"}));
    EXPECT_EQ(picture, shot("fit.png", {"--camera", "fit"}));
    EXPECT_NE(picture, shot("draw.png", {"--draw", "shapes,joints,aabbs"}));
    EXPECT_NE(picture, shot("labels.png", {"--labels"}));
    EXPECT_EQ(shot("labels2.png", {"--labels"}),
              shot("names.png", {"--draw", "shapes,joints,names"}))
        << "a scene without names has numbers";
    const std::string forces = shot("forces.png", {"--draw", "shapes,forces"});
    EXPECT_NE(forces, shot("long.png", {"--draw", "shapes,forces", "--force-scale", "1"}));
    const std::string velocities = shot("velocities.png", {"--draw", "shapes,velocities"});
    EXPECT_EQ(velocities,
              shot("usual.png", {"--draw", "shapes,velocities", "--velocity-scale", "0.2"}));
    EXPECT_NE(velocities,
              shot("slow.png", {"--draw", "shapes,velocities", "--velocity-scale", "0.1"}));
    EXPECT_NE(picture, shot("hz.png", {"--hz", "30"}));
}

TEST_F(Command, RefusesUnknownExtensions)
{
    ExpectRefusal({"record", "pyramid", "-o", "a.mp5"}, 1, "a.mp5");
    ExpectRefusal({"shot", "pyramid", "--at", "1s", "-o", "a.pgn"}, 1, "a.pgn");
    ExpectRefusal({"shot", "pyramid", "--at", "1s", "-o", "a.bmp"}, 1, "a.bmp");
}

TEST_F(Command, UsesColoursOnlyOnTerminals)
{
    const auto onTerminal = [this](const std::string& line) {
        const std::string command = std::string(line).append(1, ' ');
        return RunTool({"script", "-qec", command, "/dev/null"}, folder.Path()).output;
    };
    const std::string program = std::string("'") + BOXREEL_PROGRAM + "' ";
    const std::string plain = "env -u NO_COLOR TERM=xterm ";
    EXPECT_THAT(onTerminal(plain + program + "list"), HasSubstr("\x1b[1mCATEGORY"));
    EXPECT_THAT(onTerminal(plain + "NO_COLOR= " + program + "list"), HasSubstr("\x1b[1m"));
    EXPECT_THAT(onTerminal(plain + program + "lsit"), HasSubstr("\x1b[31mboxreel:\x1b[0m "));
    for (const char* refused : {"env TERM=xterm NO_COLOR=1 ", "env -u NO_COLOR TERM=dumb "})
    {
        for (const char* command : {"list", "lsit"})
        {
            const std::string output = onTerminal(refused + program + command);
            EXPECT_THAT(output, testing::AnyOf(HasSubstr("CATEGORY"), HasSubstr("boxreel: ")));
            EXPECT_THAT(output, testing::Not(HasSubstr("\x1b"))) << refused;
        }
    }
    EXPECT_THAT(Run({"lsit"}).errors, testing::Not(HasSubstr("\x1b"))) << "no terminal";
}

TEST_F(Command, RefusesUnknownScenes)
{
    ExpectRefusal({"shot", "pyrmid", "--at", "1s", "-o", "a.png"}, 1, "'pyrmid'");
    ExpectRefusal({"record", "brigde", "-o", "a.mp4"}, 1, "'brigde'");
    ExpectRefusal({"golden", "verify", "xylophone", "--references", "."}, 1, "'xylophone'");
}

TEST_F(Command, RefusesInvalidSceneFiles)
{
    ExpectRefusal({"shot", "missing.json", "--at", "1s", "-o", "a.png"}, 1, "missing.json");
    Write("truncated.json", R"({"body":[{"name":"a","type":2,"fixture":[{"circle":)");
    ExpectRefusal({"shot", "truncated.json", "--at", "1s", "-o", "a.png"}, 1, "truncated.json");
    Write("foreign.json", "\x89PNG\r\n");
    ExpectRefusal({"record", "foreign.json", "-o", "a.mp4"}, 1, "foreign.json:1:1");
    Write("empty.json", "");
    ExpectRefusal({"record", "empty.json", "-o", "a.mp4"}, 1, "empty.json");
    std::filesystem::create_directory(folder / "folder.json");
    ExpectRefusal({"record", "folder.json", "-o", "a.mp4"}, 1, "folder.json");
}

TEST_F(Command, RefusesUnwritableOutputsBeforeSimulation)
{
    // A simulation of this length would outlast the test's time limit.
    const std::vector<std::string> longFilm{"--frames", "10000000", "-o"};
    const auto record = [&](const std::string& output) {
        std::vector<std::string> arguments{"record", "pyramid"};
        arguments.insert(arguments.end(), longFilm.begin(), longFilm.end());
        arguments.push_back(output);
        return arguments;
    };
    std::filesystem::create_directory(folder / "folder.mp4");
    Write("there.mp4", "a film");
    Write("there.png", "a picture");
    ExpectRefusal(record("film.xyz"), 1, "film.xyz");
    ExpectRefusal(record("film"), 1, "film");
    ExpectRefusal(record("folder.mp4"), 1, "folder.mp4");
    ExpectRefusal(record("there.mp4"), 1, "there.mp4");
    ExpectRefusal({"shot", "pyramid", "--step", "1000000000", "-o", "there.png"}, 1, "there.png");
    ExpectRefusal({"shot", "pyramid", "--step", "1000000000", "-o", "picture.jpg"}, 1,
                  "picture.jpg");
    ExpectRefusal({"shot", "pyramid", "--step", "1000000000", "-o", "."}, 1, ".");
    ExpectRefusal({"shot", "pyramid", "--step", "1000000000", "-o", "none/a.png"}, 1, "none/a.png");
    EXPECT_EQ(ReadBytes(folder / "there.mp4"), "a film");
    EXPECT_EQ(ReadBytes(folder / "there.png"), "a picture");
}

TEST_F(Command, RecordsArrowsThatAreLegibleOncePageIsZoomed)
{
    // After a step, velocities are shorter than films draw them.
    ASSERT_EQ(
        Run({"record", "pyramid", "-o", "film.html", "--frames", "2", "--draw", "velocities"}).code,
        0);
    EXPECT_THAT(ReadBytes(folder / "film.html"),
                HasSubstr("\"label\":\"Velocities\",\"isThere\":true"));
}

TEST_F(Command, ListsEveryExtensionOfRecord)
{
    const std::string help = Run({"record", "--help"}).output;
    for (const char* const name : {"film.avi", "film"})
    {
        const std::string refused = Run({"record", "pyramid", "-o", name}).errors;
        for (const std::string& end : RecordExtensions())
        {
            EXPECT_THAT(refused, HasSubstr(end));
            EXPECT_THAT(help, HasSubstr(end));
        }
    }
    EXPECT_THAT(Run({"record", "pyramid", "-o", "film.htm"}).errors, HasSubstr("'.html'"));
}

TEST_F(Command, ReportsMissingFileEquallyInEveryCommand)
{
    const std::pair<std::vector<std::string>, std::string> cases[] = {
        {{"shot", "none.json", "--step", "1", "-o", "a.png"}, "none.json"},
        {{"check", "none.json"}, "none.json"},
        {{"play", "none.play"}, "none.play"},
        {{"diff", "none.png", "none.png"}, "none.png"},
        {{"merge", "none.mkv", "-o", "a.mkv"}, "none.mkv"}};
    const std::string first = Run(cases[0].first).errors;
    for (const auto& [arguments, name] : cases)
    {
        const Outcome outcome = Run(arguments);
        ExpectRefused(outcome, name);
        const std::size_t end = std::string("boxreel: ").size() + name.size();
        EXPECT_EQ(outcome.errors.substr(end), first.substr(first.find(": does")));
    }
}

TEST_F(Command, ReportsMissingFolderEquallyForPicturesAndFilms)
{
    const Outcome picture = Run({"shot", "pyramid", "--step", "1", "-o", "none/a.png"});
    const Outcome film = Run({"record", "pyramid", "--frames", "2", "-o", "none/a.mp4"});
    ExpectRefused(picture, "none/a.png");
    ExpectRefused(film, "none/a.mp4");
    EXPECT_EQ(picture.errors.substr(picture.errors.find(": cannot")),
              film.errors.substr(film.errors.find(": cannot")));
}

TEST_F(Command, NamesMissingFolder)
{
    const Outcome outcome =
        Run({"record", "pyramid", "--frames", "10000000", "-o", "none/film.mp4"});
    EXPECT_THAT(outcome.code, testing::AnyOf(1, 4)) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("none"));
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(Command, RefusesOddSizesOfFormatsWithEvenSizes)
{
    ExpectRefusal({"record", "pyramid", "--frames", "2", "--size", "321x180", "-o", "a.mp4"}, 1,
                  "--size 321x180");
}

TEST_F(Command, RefusesMistypedOptionsAndValues)
{
    ExpectRefusal({"recrod"}, 1, "'recrod'");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--secnds", "3"}, 1, "--secnds");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--size", "0x720"}, 1, "--size 0x720");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--seconds", "nan"}, 1, "--seconds nan");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--seconds", ""}, 1, "--seconds ''");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--seconds", "1000000", "--fps", "1000"}, 1,
                  "film");
}

TEST_F(Command, ReturnsZeroOneOrTwoFromDiff)
{
    Picture("a.png", 64, 48, 100);
    Picture("same.png", 64, 48, 100);
    Picture("other.png", 64, 48, 140);
    Picture("small.png", 32, 48, 100);
    EXPECT_EQ(Run({"diff", "a.png", "same.png"}).code, 0);
    EXPECT_EQ(Run({"diff", "a.png", "other.png"}).code, 2);
    const Outcome sizes = Run({"diff", "a.png", "small.png"});
    EXPECT_EQ(sizes.code, 2);
    EXPECT_THAT(sizes.output, testing::AllOf(HasSubstr("64x48"), HasSubstr("32x48")));
    Write("foreign.png", "not a picture");
    ExpectRefusal({"diff", "a.png", "foreign.png"}, 1, "foreign.png");
    ExpectRefusal({"diff", "a.png", "missing.png"}, 1, "missing.png");
    ExpectRefusal({"diff", "a.png", "other.png", "--preset", "sloppy"}, 1, "--preset sloppy");
}

TEST_F(Command, RefusesToOverwriteInputsOfDiff)
{
    Picture("a.png", 64, 48, 100);
    Picture("other.png", 64, 48, 140);
    const std::string before = ReadBytes(folder / "a.png");
    for (const char* output : {"a.png", "./other.png"})
    {
        ExpectRefusal({"diff", "a.png", "other.png", "-o", output, "--force"}, 1,
                      std::string("-o ") + output);
    }
    EXPECT_EQ(ReadBytes(folder / "a.png"), before);
}

TEST_F(Command, WritesDifferencePicture)
{
    Picture("a.png", 64, 48, 100);
    Picture("other.png", 64, 48, 140);
    EXPECT_EQ(Run({"diff", "a.png", "other.png", "-o", "diff.png"}).code, 2);
    const Result<Frame> difference = ReadPng(folder / "diff.png");
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->width, 64);
    ExpectRefusal({"diff", "a.png", "other.png", "-o", "diff.png"}, 1, "diff.png");
}

TEST_F(Command, FailsWhenStandardOutputIsFull)
{
    if (!std::filesystem::exists("/dev/full"))
    {
        GTEST_SKIP() << "no /dev/full on this machine";
    }
    const std::string line = std::string("'") + BOXREEL_PROGRAM + "' list > /dev/full 2> " +
                             (folder / "errors").string();
    const int status = std::system(line.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 4);
    EXPECT_THAT(ReadBytes(folder / "errors"), HasSubstr("standard output"));
}

} // namespace
} // namespace boxreel
