// SPDX-License-Identifier: MIT
// `boxreel play`: one file is a test, a film and a figure.
#include "Refusals.h"

#include <recorder/VideoReader.h>
#include <render/Png.h>
#include <scenes/Scene.h>
#include <script/Script.h>
#include <session/SceneSearch.h>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PlayCommand : public testing::Test
{
protected:
    void Write(const std::string& lines) const { std::ofstream(folder / "a.play") << lines; }

    Outcome Play(const std::vector<std::string>& extra = {}) const
    {
        std::vector<std::string> arguments{"play", "a.play"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        return RunBoxreel(arguments, folder.Path());
    }

    TemporaryFolder folder;
};

TEST_F(PlayCommand, PlaysScriptWithFilmShotAndExpectation)
{
    Write("scene car --size 160x90\n"
          "at 1s press d\n"
          "at 0.9s expect chassis.x < -25\n"
          "at 4s expect chassis.x > -5\n"
          "at 4s shot there.png\n"
          "record film.mkv --seconds 4.1 --quality lossless --fps 10\n");
    const Outcome outcome = Play();
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("ok    a.play:3: chassis.x < -25 ("),
                                      HasSubstr("ok    a.play:4: chassis.x > -5 (")));
    const Result<Frame> still = ReadPng(folder / "there.png");
    ASSERT_TRUE(still);
    Result<VideoReader> film = VideoReader::Open(folder / "film.mkv");
    ASSERT_TRUE(film);
    Frame frame;
    for (int i = 0; i <= 40; ++i)
    {
        ASSERT_TRUE(*film->Next(frame)) << i;
    }
    EXPECT_TRUE(frame.rgba == still->rgba) << "at 4 s, in the film and in the picture";
}

TEST_F(PlayCommand, ReportsValueOfFailedExpectation)
{
    Write("scene car\nat 2s expect chassis.x > 500\nat 1s expect bodies > 3\nrecord film.mp4 "
          "--frames 2\n");
    const Outcome outcome = Play();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("FAIL  a.play:2: chassis.x > 500 ("),
                                      HasSubstr("ok    a.play:3: bodies > 3 (")));
    EXPECT_THAT(folder.Names(), Contains("film.mp4")) << "what is to be seen of it is made";
}

TEST_F(PlayCommand, ComparesPicturesWithReferences)
{
    Write("scene dominos\nat 1s golden start/1s --size 160x90\n");
    Outcome outcome = Play();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("FAIL  a.play:2: start/1s: "), HasSubstr("--accept")));
    outcome = Play({"--accept"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, "accepted  start/1s\n");
    outcome = Play();
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, "same  start/1s\n");
    Write("scene dominos\nat 0.5s bomb 0,20 0,-50\nat 1s golden start/1s --size 160x90\n");
    outcome = Play();
    EXPECT_EQ(outcome.code, 2) << "a bomb fell";
    EXPECT_THAT(outcome.output, HasSubstr("FAIL  a.play:3: "));
    EXPECT_EQ(Play({"--for-this-renderer"}).code, 1) << "nothing is accepted then";
    EXPECT_EQ(Play({"--accept", "--for-this-renderer"}).code, 0);
    EXPECT_EQ(Play().code, 0);
    const std::filesystem::directory_iterator pictures(folder / "references/frames/start");
    EXPECT_EQ(std::distance(begin(pictures), end(pictures)), 2) << "one for all, one of its own";
}

TEST_F(PlayCommand, WritesNothingWithCheck)
{
    Write("scene car\nat 1s press d\nat 4s expect chassis.x > -5\nrecord film.mp4\n");
    const Outcome outcome = Play({"--check"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, "a.play: Car, 1 action, 1 expectation, 0 pictures, 1 film\n");
    EXPECT_THAT(folder.Names(), testing::ElementsAre("a.play"));
}

TEST_F(PlayCommand, WritesNoFilmsWithTest)
{
    Write("scene car\nat 1s expect chassis.x > 0\nrecord film.mp4\nat 1s shot a.png\n");
    const Outcome outcome = Play({"--test"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, testing::StartsWith("FAIL  a.play:2: chassis.x > 0 (-2"));
    EXPECT_THAT(folder.Names(), testing::ElementsAre("a.play"));
}

/// Each is what shows off a scene that answers to keys or the mouse.
TEST(Scripts, PassAndCoverScenesWithKeys)
{
    const TemporaryFolder folder;
    std::set<std::string> titles;
    for (const auto& entry : std::filesystem::directory_iterator(BOXREEL_SCRIPTS))
    {
        if (entry.is_directory())
        {
            continue; // of references
        }
        const Outcome outcome =
            RunBoxreel({"play", entry.path().string(), "--test"}, folder.Path());
        EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
        EXPECT_THAT(outcome.output, HasSubstr("ok    "));
        const Result<Script> script = ReadScript(entry.path());
        ASSERT_TRUE(script);
        EXPECT_FALSE(script->actions.empty()) << entry.path();
        titles.insert(SceneKey(script->scene));
    }
    EXPECT_THAT(folder.Names(), IsEmpty());
    for (const SceneEntry& scene : AllScenes())
    {
        if (!scene.create(SceneSettings())->Keys().empty())
        {
            EXPECT_THAT(titles, Contains(SceneKey(scene.name)));
        }
    }
}

TEST_F(PlayCommand, WritesIntoFolderAndOverwritesOnlyByForce)
{
    Write("scene car\nrecord film.mp4 --frames 2 --size 64x64\nat 0s shot a.png\n");
    std::filesystem::create_directory(folder / "films");
    EXPECT_EQ(Play({"--into", "films"}).code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "films" / "film.mp4"));
    EXPECT_TRUE(std::filesystem::exists(folder / "films" / "a.png"));
    std::filesystem::remove(folder / "films" / "film.mp4");
    const Outcome again = Play({"--into", "films"});
    EXPECT_EQ(again.code, 1);
    EXPECT_THAT(again.errors, HasSubstr("a.play:3"));
    EXPECT_FALSE(std::filesystem::exists(folder / "films" / "film.mp4"))
        << "asked before anything is made";
    EXPECT_EQ(Play({"--into", "films", "--force"}).code, 0);
}

TEST_F(PlayCommand, ResumesStoppedFilmIfActionsAreEqual)
{
    const std::string film = "record film.mkv --seconds 30 --size 320x180\n";
    Write("scene tumbler\nat 1s bomb\n" + film);
    std::vector<std::string> arguments{"play", "a.play"};
    const Outcome stopped = RunBoxreel(arguments, folder.Path(), [&](int process) {
        while (!std::filesystem::exists(folder / "film.part.mkv") ||
               std::filesystem::file_size(folder / "film.part.mkv") < 10000)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        kill(process, SIGINT);
    });
    EXPECT_EQ(stopped.code, 75);
    Write("scene tumbler\nat 2s bomb\n" + film);
    const Outcome other = Play({"--resume"});
    EXPECT_EQ(other.code, 1);
    EXPECT_THAT(other.errors, HasSubstr("a.play:3"));
    Write("scene tumbler\nat 1s bomb\n# a comment\n" + film);
    EXPECT_EQ(Play({"--resume"}).code, 0);
}

TEST_F(PlayCommand, SkipsCompleteFilesWithResume)
{
    Write("scene car\nat 0s shot a.png --size 64x64\nrecord a.mp4 --frames 2 --size 64x64\n"
          "record b.mp4 --frames 2 --size 64x64\n");
    std::ofstream(folder / "a.png") << "a picture";
    std::ofstream(folder / "a.mp4") << "a film";
    const Outcome outcome = Play({"--resume"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("a.png"), HasSubstr("a.mp4")));
    EXPECT_EQ(std::filesystem::file_size(folder / "a.mp4"), 6u);
    EXPECT_TRUE(std::filesystem::exists(folder / "b.mp4"));
}

TEST_F(PlayCommand, AcceptsByteOrderMark)
{
    Write("\xEF\xBB\xBFscene car\r\nat 0s expect bodies > 0\r\n");
    EXPECT_EQ(Play().code, 0);
}

TEST_F(PlayCommand, NamesLineAndCulpritOfErrors)
{
    const std::pair<const char*, const char*> cases[] = {
        {"scene nowhere\n", "1: 'nowhere'"},
        {"scene car --siez 3x3\n", "1: --siez"},
        {"scene car\nrecord a.mp4 --fsp 3\n", "2: --fsp"},
        {"scene car\nrecord a.xyz\n", "2: a.xyz"},
        {"scene car\nat 0s shot a.png\nrecord a.xyz\n", "3: a.xyz"},
        {"scene car\nat 0s shot a.png\nrecord b.png\n", "3: b.png"},
        {"scene car\nat 0s shot a.png\nrecord none/a.mp4\n", "3: none/a.mp4"},
        {"scene car\nat 0s shot a.png\nat 1s shot none/b.png\n", "3: none/b.png"},
        {"scene car\nat 0s shot a.png\nrecord a.mp4 --size 63x64\n", "3: --size 63x64"},
        {"scene car\nat 0s shot a.png\nrecord a.mp4\nrecord ./a.mp4\n", "4: ./a.mp4"},
        {"scene car\nat 0s shot a.png --theme both\nat 1s shot a-light.png\n", "3: a-light.png"},
        {"scene car\nat 0s shot f-0001.png\nrecord f-####.png\n", "3: f-####.png"},
        {"scene car\nat 0s shot a.png\nrecord a.mp4 --thumbnail a.png\n", "3: a.png"},
        {"scene car\nrecord -\n", "2: -"},
        {"scene car\nrecord a.mp4 --help\n", "2: --help"},
        {"scene car\nat 1s press x\n", "2: 'x'"},
        {"scene car\nat 1s expect 1.z > 3\n", "2: expect '1.z > 3'"},
        {"scene car\nat 1s expect wheel.x > 3\n", "2: expect 'wheel.x > 3'"},
        {"scene car\nat 1s golden ../out\n", "2: '../out'"},
        {"scene other.json\n", "1: other.json"},
        {"scene car\nat 1s click Solver/Slep\nrecord a.mp4 --seconds 2\n", "2: 'Solver/Slep'"},
        {"scene car\nat 3s click Solver/Slep\nat 1s expect bodies > 3\n", "2: 'Solver/Slep'"},
    };
    for (const auto& [lines, culprit] : cases)
    {
        Write(lines);
        const Outcome outcome = Play();
        ExpectRefused(outcome, std::string("a.play:") + culprit);
        EXPECT_THAT(folder.Names(), testing::ElementsAre("a.play")) << lines;
        if (outcome.code == 1 && std::string(lines).find("expect") == std::string::npos &&
            std::string(lines).find("click") == std::string::npos) // these show under way
        {
            EXPECT_EQ(Play({"--check"}).errors, outcome.errors) << lines;
        }
    }
    EXPECT_EQ(RunBoxreel({"play"}, folder.Path()).code, 1);
    for (const std::string name : {"none.play", ".", "/dev/zero"})
    {
        const Outcome outcome = RunBoxreel({"play", name}, folder.Path());
        ExpectRefused(outcome, name);
        EXPECT_THAT(outcome.errors, HasSubstr(" " + name + ": "));
    }
    EXPECT_EQ(RunBoxreel({"play", "a.play", "--check", "--accept"}, folder.Path()).code, 1);
}

} // namespace
} // namespace boxreel
