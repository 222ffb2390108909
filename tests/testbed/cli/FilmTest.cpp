// SPDX-License-Identifier: MIT
// Films as the program makes them: decoded and compared with its stills.
#include "../StatsRows.h"
#include "FilmFixture.h"
#include "Refusals.h"

#include <render/Png.h>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Film : public FilmFixture
{
protected:
    Frame Shot(const std::string& scene, int step, const std::vector<std::string>& look) const
    {
        std::vector<std::string> arguments{"shot", scene,      "--step", std::to_string(step),
                                           "-o",   "shot.png", "--force"};
        arguments.insert(arguments.end(), look.begin(), look.end());
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        const Result<Frame> frame = ReadPng(folder / "shot.png");
        EXPECT_TRUE(frame);
        return frame ? *frame : Frame();
    }

    /// Makes a complete part the file of a stopped run, whose manifest has the planned end.
    void LeaveAsStopped(const std::string& film, const std::string& part, const std::string& end,
                        const std::string& planned) const
    {
        std::filesystem::rename(folder / film, folder / part);
        std::string manifest = ReadBytes(folder / (film + ".json"));
        const std::size_t at = manifest.find(end);
        ASSERT_NE(at, std::string::npos);
        std::ofstream(folder / (part + ".json")) << manifest.replace(at, end.size(), planned);
        std::filesystem::remove(folder / (film + ".json"));
    }
};

TEST_F(Film, KeepsFilmWhenCameraTargetIsMissing)
{
    for (const char* const camera : {"follow:3", "fit:3,500"})
    {
        const Outcome outcome =
            Run({"record", "tumbler", "-o", "film.mkv", "--frames", "4", "--size", "64x36",
                 "--progress", "none", "--force", "--camera", camera});
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(Decode("film.mkv").size(), 4u);
        EXPECT_EQ(outcome.errors.find("--camera 500") != std::string::npos,
                  camera != std::string("follow:3"));
    }
}

TEST_F(Film, HasFramesEqualToShotsAtSameTime)
{
    const std::vector<std::string> look{"--size", "320x180", "--hud"};
    std::vector<std::string> record{"record", "newtons-cradle", "-o",      "film.mkv", "--frames",
                                    "40",     "--quality",      "lossless"};
    record.insert(record.end(), look.begin(), look.end());
    const Outcome outcome = Run(record);
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const std::vector<Frame> frames = Decode("film.mkv");
    ASSERT_EQ(frames.size(), 40u);
    EXPECT_EQ(frames[0], Shot("newtons-cradle", 0, look));
    EXPECT_EQ(frames[17], Shot("newtons-cradle", 17, look));
    EXPECT_EQ(frames[39], Shot("newtons-cradle", 39, look));
    EXPECT_NE(frames[17], frames[39]) << "something moves";
}

TEST_F(Film, MovesCameraIndependentlyOfFrameRate)
{
    for (const char* camera :
         {"follow:32:8", "fit:12,13", "path:0s=0,20,50;1s=10,5,12;1500ms=0,20,50"})
    {
        const std::vector<std::string> look{"--size", "160x90", "--camera", camera};
        const auto film = [&](const char* rate, const char* count) {
            std::vector<std::string> record{"record",  "dominos",   "-o",       "film.mkv",
                                            "--force", "--quality", "lossless", "--fps",
                                            rate,      "--frames",  count};
            record.insert(record.end(), look.begin(), look.end());
            const Outcome outcome = Run(record);
            EXPECT_EQ(outcome.code, 0) << outcome.errors;
            return Decode("film.mkv");
        };
        const std::vector<Frame> slow = film("10", "13");
        const std::vector<Frame> fast = film("60", "73");
        ASSERT_EQ(slow.size(), 13u);
        ASSERT_EQ(fast.size(), 73u);
        for (std::size_t i = 0; i < slow.size(); ++i)
        {
            EXPECT_TRUE(slow[i] == fast[6 * i]) << camera << " at " << i << "/10 s";
        }
        EXPECT_TRUE(slow[9] == Shot("dominos", 54, look)) << camera;
    }
}

TEST_F(Film, RepeatsStepsInSlowMotion)
{
    const Outcome outcome = Run({"record", "bridge", "-o", "film.mkv", "--frames", "9", "--quality",
                                 "lossless", "--size", "160x90", "--speed", "0.25"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const std::vector<Frame> frames = Decode("film.mkv");
    ASSERT_EQ(frames.size(), 9u);
    EXPECT_EQ(frames[7], Shot("bridge", 1, {"--size", "160x90"}));
    EXPECT_EQ(frames[8], Shot("bridge", 2, {"--size", "160x90"}));
}

TEST_F(Film, ShowsMomentsBetweenStepsWithInterpolate)
{
    const std::vector<std::string> look{"--size", "160x90", "--camera", "follow:17"};
    const auto film = [&](const char* name, std::vector<std::string> more) {
        std::vector<std::string> record{
            "record", "dominos", "-o", name,        "--frames", "64",           "--fps",
            "120",    "--group", "32", "--quality", "lossless", "--interpolate"};
        record.insert(record.end(), look.begin(), look.end());
        record.insert(record.end(), more.begin(), more.end());
        const Outcome outcome = Run(record);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
    };
    film("whole.mkv", {});
    const std::vector<Frame> frames = Decode("whole.mkv");
    ASSERT_EQ(frames.size(), 64u);
    EXPECT_EQ(frames[40], Shot("dominos", 20, look));
    EXPECT_EQ(frames[42], Shot("dominos", 21, look));
    EXPECT_NE(frames[41], frames[40]);
    EXPECT_NE(frames[41], frames[42]);
    film("a.mkv", {"--frame-range", "0-31"});
    film("b.mkv", {"--frame-range", "32-63"});
    const Outcome merged = Run({"merge", "a.mkv", "b.mkv", "-o", "merged.mkv"});
    ASSERT_EQ(merged.code, 0) << merged.errors;
    EXPECT_EQ(Decode("merged.mkv"), frames);
}

TEST_F(Film, HasEqualBytesInTwoRuns)
{
    for (const char* name : {"a.mkv", "b.mkv"})
    {
        EXPECT_EQ(Run({"record", "dominos", "-o", name, "--frames", "20", "--quality", "lossless",
                       "--size", "320x180"})
                      .code,
                  0);
    }
    EXPECT_EQ(ReadBytes(folder / "a.mkv"), ReadBytes(folder / "b.mkv"));
}

TEST_F(Film, NumbersPictureSequence)
{
    const Outcome outcome =
        Run({"record", "chain", "-o", "f-####.png", "--frames", "3", "--size", "160x90"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(folder.Names().size(), 3u);
}

TEST_F(Film, WritesGivenFramesInEveryFormat)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif"})
    {
        const Outcome outcome = Run({"record", "pyramid", "-o", name, "--seconds", "0.2", "--fps",
                                     "50", "--size", "160x90"});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(Decode(name).size(), 10u) << name;
        EXPECT_THAT(outcome.errors,
                    HasSubstr(std::string(name) + ": 10 frames of 160x90 at 50 fps"));
        EXPECT_EQ(outcome.output, "");
    }
}

TEST_F(Film, IsOverwrittenWithForce)
{
    for (const char* frames : {"5", "7"})
    {
        EXPECT_EQ(Run({"record", "pyramid", "-o", "film.mp4", "--force", "--frames", frames,
                       "--size", "160x90"})
                      .code,
                  0);
    }
    EXPECT_EQ(Decode("film.mp4").size(), 7u);
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}

TEST_F(Film, PrintsProgressAsJsonOrNotAtAll)
{
    const std::vector<std::string> record{"record", "pyramid", "--frames",  "5",
                                          "--size", "160x90",  "--progress"};
    std::vector<std::string> json = record;
    json.insert(json.end(), {"json", "-o", "a.mp4"});
    const std::string errors = Run(json).errors;
    EXPECT_THAT(errors, HasSubstr("{\"event\":\"progress\",\"frames\":5,\"total\":5,"));
    EXPECT_THAT(errors, HasSubstr("{\"event\":\"done\",\"file\":\"a.mp4\",\"frames\":5,"));
    std::vector<std::string> none = record;
    none.insert(none.end(), {"none", "-o", "b.mp4"});
    EXPECT_EQ(Run(none).errors, "");
}

TEST_F(Film, PrintsStatisticsOnlyOnRequest)
{
    // Two frames of film a step: every other frame is the one before once more.
    const Outcome outcome =
        Run({"record", "pyramid", "-o", "a.gif", "--frames", "20", "--fps", "40", "--hz", "20",
             "--camera", "0,10,30", "--size", "160x90", "--progress", "none", "--stats"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, "");
    // Frames: all, drawn as a whole, in part, unchanged.
    EXPECT_THAT(NumbersOf(outcome.errors, "frames"), ElementsAre(20, 1, 9, 10));
    EXPECT_EQ(NumbersOf(outcome.errors, "encoding").size(), 2u) << "CPU and wall";

    const Outcome shot = Run({"shot", "pyramid", "--step", "9", "-o", "a.png", "--stats"});
    EXPECT_THAT(NumbersOf(shot.errors, "frames"), ElementsAre(1, 1, 0, 0));
    EXPECT_THAT(NumbersOf(shot.errors, "pixels"), ElementsAre(100.0));
    const Outcome both =
        Run({"shot", "pyramid", "--step", "9", "-o", "b.png", "--theme", "both", "--stats"});
    EXPECT_THAT(NumbersOf(both.errors, "frames"), ElementsAre(2, 2, 0, 0));
    EXPECT_EQ(both.errors.find("  frames  "), both.errors.rfind("  frames  ")) << "once";
}

/// Ends a long recording by a signal, once it has begun to write.
void StopWhenBegun(int process, int signal, const std::filesystem::path& folder)
{
    for (int i = 0; i < 3000 && std::filesystem::is_empty(folder); ++i)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(process, signal);
}

TEST_F(Film, IsPlayableAndResumableAfterSignal)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    {
        const Outcome outcome = RunBoxreel(
            {"record", "pyramid", "--frames", "10000000", "-o", "film.mkv", "--size", "160x90"},
            folder.Path(), [&](int process) { StopAfterGroups(process, signal); });
        EXPECT_EQ(outcome.code, 75) << outcome.errors;
        EXPECT_THAT(outcome.errors, HasSubstr("--resume"));
        EXPECT_THAT(folder.Names(), ElementsAre("film.part.mkv", "film.part.mkv.json"));
        EXPECT_GE(Decode("film.part.mkv").size(), 100u);
        for (const std::string& name : folder.Names())
        {
            std::filesystem::remove(folder / name);
        }
    }
}

TEST_F(Film, IsPlayableAnimationAfterSignal)
{
    for (const std::string kind : {".gif", ".apng", ".webp"})
    {
        const Outcome outcome = RunBoxreel(
            {"record", "tumbler", "--frames", "1000000", "-o", "film" + kind, "--size", "32x18"},
            folder.Path(), [&](int process) { StopAfterGroups(process, SIGINT); });
        EXPECT_EQ(outcome.code, 75) << outcome.errors;
        EXPECT_GE(Decode("film.part" + kind).size(), 50u) << kind;
        for (const std::string& name : folder.Names())
        {
            std::filesystem::remove(folder / name);
        }
    }
}

TEST_F(Film, EndsAtOnceAndLeavesPartAfterSecondSignal)
{
    const Outcome outcome = RunBoxreel(
        {"record", "pyramid", "--frames", "10000000", "-o", "film.mp4", "--size", "160x90"},
        folder.Path(), [&](int process) {
            // Both signals are pending when it continues, so there is no time between them for the
            // orderly stop.
            StopWhenBegun(process, SIGSTOP, folder.Path());
            kill(process, SIGINT);
            kill(process, SIGTERM);
            kill(process, SIGCONT);
        });
    EXPECT_TRUE(outcome.code == 128 + SIGINT || outcome.code == 128 + SIGTERM) << outcome.code;
    EXPECT_THAT(outcome.errors, Not(HasSubstr("Stopped")));
    EXPECT_THAT(folder.Names(), testing::Contains("film.part.mp4"));
    EXPECT_THAT(folder.Names(), Not(testing::Contains("film.mp4")));
}

TEST_F(Film, HasThumbnailEqualToFrameAtItsTime)
{
    const std::vector<std::string> look{"--size", "160x90", "--camera", "0,5,30"};
    const auto thumbnail = [&](const std::vector<std::string>& when) {
        std::vector<std::string> record{"record",  "tumbler",     "-o",      "film.mkv",
                                        "--force", "--thumbnail", "film.png"};
        record.insert(record.end(), look.begin(), look.end());
        record.insert(record.end(), when.begin(), when.end());
        const Outcome outcome = Run(record);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return *ReadPng(folder / "film.png");
    };
    const auto shot = [&](int step) { return Shot("tumbler", step, look); };
    EXPECT_EQ(thumbnail({"--frames", "10", "--thumbnail-at", "0"}), shot(0));
    EXPECT_EQ(thumbnail({"--frames", "10", "--thumbnail-at", "0.001"}), shot(0));
    EXPECT_EQ(thumbnail({"--frames", "10", "--thumbnail-at", "0.1"}), shot(6));
    EXPECT_EQ(thumbnail({"--frames", "10"}), shot(5));
    EXPECT_EQ(thumbnail({"--until", "time >= 0.15"}), shot(9)) << "it ended before its middle";
}

TEST_F(Film, EqualsUninterruptedFilmWhenResumed)
{
    const std::vector<std::string> record{"record",   "tumbler",  "--frames", "360",
                                          "--size",   "160x90",   "--group",  "100",
                                          "--camera", "follow:3", "-o"};
    std::vector<std::string> whole = record;
    whole.insert(whole.end(), {"whole.mp4", "--thumbnail", "whole.png", "--thumbnail-at", "0.5"});
    ASSERT_EQ(Run(whole).code, 0);
    std::vector<std::string> command = record;
    // Its frame is long filmed when the film is continued.
    command.insert(command.end(), {"film.mp4", "--thumbnail", "film.png", "--thumbnail-at", "0.5"});
    const Outcome killed = RunBoxreel(command, folder.Path(),
                                      [&](int process) { StopAfterGroups(process, SIGKILL, 300); });
    ASSERT_EQ(killed.code, 128 + SIGKILL) << "it was over before it could be killed";
    const Outcome refused = Run(command);
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.errors, HasSubstr("--resume"));
    std::vector<std::string> other{"record", "bridge",   "--frames", "360",
                                   "-o",     "film.mp4", "--resume"};
    EXPECT_THAT(Run(other).errors, HasSubstr("film.part.mp4.json"));
    command.insert(command.end(), {"--resume", "--stats"});
    const Outcome resumed = Run(command);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(resumed.errors, Not(testing::ContainsRegex("frames +360 "))) << "none were there";
    EXPECT_EQ(Decode("film.mp4"), Decode("whole.mp4"));
    EXPECT_EQ(*ReadPng(folder / "film.png"), *ReadPng(folder / "whole.png"));
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4", "film.png", "whole.mp4", "whole.png"));
}

TEST_F(Film, ContinuesAtItsLastKeyframeWithoutGroups)
{
    std::vector<std::string> command{"record", "tumbler", "--frames", "500",    "--size",
                                     "160x90", "-o",      "film.mp4", "--stats"};
    const Outcome killed = RunBoxreel(command, folder.Path(),
                                      [&](int process) { StopAfterGroups(process, SIGINT, 400); });
    ASSERT_EQ(killed.code, 75) << "it was over before it could be stopped";
    command.emplace_back("--resume");
    const Outcome resumed = Run(command);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(resumed.errors, Not(testing::ContainsRegex("frames +500 "))) << "none were there";
    EXPECT_EQ(Decode("film.mp4", Frames::Stored).size(), 500u);
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}

TEST_F(Film, EqualsWholeAnimationWhenResumedOrJoined)
{
    for (const std::string kind : {".gif", ".apng", ".webp"})
    {
        SCOPED_TRACE(kind);
        const auto make = [&](const std::string& name, std::vector<std::string> more) {
            std::vector<std::string> command{"record",  "tumbler", "--frames", "60",       "--size",
                                             "96x54",   "--fps",   "20",       "--loop",   "3",
                                             "--group", "20",      "-o",       name + kind};
            command.insert(command.end(), more.begin(), more.end());
            return Run(command);
        };
        ASSERT_EQ(make("whole", {}).code, 0);
        ASSERT_EQ(make("a", {"--frame-range", "0-19"}).code, 0);
        ASSERT_EQ(make("b", {"--frame-range", "20-59"}).code, 0);
        const Outcome merged = Run({"merge", "a" + kind, "b" + kind, "-o", "film" + kind});
        ASSERT_EQ(merged.code, 0) << merged.errors;
        EXPECT_EQ(Decode("film" + kind), Decode("whole" + kind));
        // The file of a run that was stopped after 40 frames.
        ASSERT_EQ(make("c", {"--frame-range", "0-39"}).code, 0);
        LeaveAsStopped("c" + kind, "left.part" + kind, "\"end\": 40", "\"end\": 60");
        const Outcome resumed = make("left", {"--resume"});
        ASSERT_EQ(resumed.code, 0) << resumed.errors;
        EXPECT_EQ(Decode("left" + kind), Decode("whole" + kind));
    }
}

TEST_F(Film, EqualsWholeFilmWhenJoinedFromParts)
{
    const std::vector<std::string> record{"record", "dominos", "--frames", "250", "--size",
                                          "160x90", "--group", "50",       "-o"};
    const auto make = [&](const char* name, std::vector<std::string> more) {
        std::vector<std::string> command = record;
        command.emplace_back(name);
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = Run(command);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
    };
    make("whole.mkv", {});
    make("a.mkv", {"--frame-range", "0-99"});
    make("b.mkv", {"--frame-range", "100-149"});
    make("c.mkv", {"--frame-range", "150-249"});
    const Outcome merged = Run({"merge", "c.mkv", "a.mkv", "b.mkv", "-o", "film.mkv"});
    ASSERT_EQ(merged.code, 0) << merged.errors;
    EXPECT_EQ(Decode("film.mkv"), Decode("whole.mkv"));
    const Outcome gap = Run({"merge", "a.mkv", "c.mkv", "-o", "gap.mkv"});
    ExpectRefused(gap, "c.mkv");
    EXPECT_THAT(gap.errors, AllOf(HasSubstr("100"), HasSubstr("149")));
    make("within.mkv", {"--frame-range", "100-120"});
    make("rest.mkv", {"--frame-range", "121-149"});
    const Outcome within = Run({"merge", "within.mkv", "rest.mkv", "-o", "gap.mkv"});
    ExpectRefused(within, "rest.mkv");
    EXPECT_THAT(within.errors, AllOf(HasSubstr("121"), HasSubstr("50")));
    std::string manifest = ReadBytes(folder / "b.mkv.json");
    const std::size_t state = manifest.find("\"100\": \"") + 8;
    manifest[state] = manifest[state] == '0' ? '1' : '0';
    std::ofstream(folder / "b.mkv.json") << manifest;
    const Outcome other = Run({"merge", "a.mkv", "b.mkv", "-o", "gap.mkv"});
    ExpectRefused(other, "b.mkv");
    EXPECT_THAT(other.errors, HasSubstr("100"));
    std::filesystem::remove(folder / "b.mkv.json");
    ExpectRefused(Run({"merge", "a.mkv", "b.mkv", "-o", "gap.mkv"}), "b.mkv.json");
}

TEST_F(Film, KeepsOtherFiles)
{
    const auto make = [&](std::vector<std::string> more) {
        std::vector<std::string> command{"record",  "tumbler", "--frames", "20",
                                         "--group", "20",      "--size",   "96x54"};
        command.insert(command.end(), more.begin(), more.end());
        return Run(command);
    };
    for (const char* name : {"v.mp4.json", "v.part.mp4.json"})
    {
        std::ofstream(folder / name) << "mine";
        const Outcome refused = make({"-o", "v.mp4", "--frame-range", "0-19"});
        ExpectRefused(refused, name);
        EXPECT_EQ(ReadBytes(folder / name), "mine");
        EXPECT_THAT(folder.Names(), ElementsAre(name));
        std::filesystem::remove(folder / name);
    }
    const std::vector<std::string> mine{"v.final.mp4", "v.part-indexed.mp4", "v.part-resumed.mp4",
                                        "v.resume.mp4"};
    for (const std::string& name : mine)
    {
        std::ofstream(folder / name) << "mine";
    }
    EXPECT_EQ(make({"-o", "v.mp4", "--frame-range", "0-19"}).code, 0);
    std::filesystem::rename(folder / "v.mp4", folder / "v.part.mp4");
    std::filesystem::rename(folder / "v.mp4.json", folder / "v.part.mp4.json");
    EXPECT_EQ(make({"-o", "v.mp4", "--frame-range", "0-19", "--resume"}).code, 0);
    EXPECT_THAT(folder.Names(),
                ElementsAre(mine[0], "v.mp4", "v.mp4.json", mine[1], mine[2], mine[3]));
    for (const std::string& name : mine)
    {
        EXPECT_EQ(ReadBytes(folder / name), "mine") << name;
    }
}

TEST_F(Film, ReportsMissingBodyOfCondition)
{
    const Outcome outcome = Run({"record", "pyramid", "-o", "a.mkv", "--frames", "2", "--size",
                                 "96x54", "--until", "nosuch.y < 0", "--until", "9999.y < 0",
                                 "--until", "ALL.speed < -1", "--until", "1.y < -1000"});
    EXPECT_EQ(outcome.code, 0);
    for (const char* condition : {"nosuch.y < 0", "9999.y < 0", "ALL.speed < -1"})
    {
        EXPECT_THAT(outcome.errors,
                    HasSubstr(std::string("boxreel: --until '") + condition + "': "));
    }
    EXPECT_THAT(outcome.errors, testing::Not(HasSubstr("'1.y")));
}

TEST_F(Film, BeginsAtFromAndEndsAtCondition)
{
    const std::vector<std::string> look{"--size", "160x90", "--camera", "0,5,30"};
    std::vector<std::string> record{"record", "newtons-cradle", "-o", "film.mkv",  "--from",
                                    "0.5",    "--frames",       "3",  "--quality", "lossless"};
    record.insert(record.end(), look.begin(), look.end());
    ASSERT_EQ(Run(record).code, 0);
    EXPECT_EQ(Decode("film.mkv")[2], Shot("newtons-cradle", 32, look));
    const Outcome until = Run({"record", "pyramid", "-o", "until.mkv", "--until", "time >= 0.5",
                               "--size", "160x90", "--thumbnail", "until.png"});
    EXPECT_EQ(until.code, 0) << until.errors;
    EXPECT_EQ(Decode("until.mkv").size(), 31u);
    EXPECT_TRUE(ReadPng(folder / "until.png"));
    const Outcome never = Run({"record", "pyramid", "-o", "never.mkv", "--until", "0.y > 100",
                               "--frames", "5", "--size", "160x90"});
    EXPECT_EQ(never.code, 0);
    EXPECT_THAT(never.errors, HasSubstr("5 frames"));
}

TEST_F(Film, WritesToPipe)
{
    const Outcome outcome = Run(
        {"record", "pyramid", "-o", "-", "--format", "y4m", "--frames", "3", "--size", "32x18"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::StartsWith("YUV4MPEG2 W32 H18 F60:1"));
    std::ofstream(folder / "film.y4m", std::ios::binary) << outcome.output;
    EXPECT_EQ(Decode("film.y4m").size(), 3u);
    EXPECT_THAT(folder.Names(), ElementsAre("film.y4m"));
}

TEST_F(Film, WritesAv1ToPipe)
{
    const Outcome outcome = Run({"record", "pyramid", "-o", "-", "--format", "mkv", "--codec",
                                 "av1", "--frames", "3", "--size", "32x18"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    std::ofstream(folder / "film.mkv", std::ios::binary) << outcome.output;
    EXPECT_EQ(Decode("film.mkv").size(), 3u);
}

TEST_F(Film, KeepsPartWhenNoBackendWorks)
{
    const std::vector<std::string> command{"record", "pyramid", "--frames", "200",     "--size",
                                           "64x36",  "-o",      "film.mkv", "--resume"};
    ASSERT_EQ(Run(command).code, 0);
    const Outcome part = Run({"record", "pyramid", "--frames", "200", "--size", "64x36", "-o",
                              "a.mkv", "--frame-range", "0-99"});
    ASSERT_EQ(part.code, 0) << part.errors;
    std::filesystem::remove(folder / "film.mkv");
    LeaveAsStopped("a.mkv", "film.part.mkv", "\"end\": 100", "\"end\": 200");
    const TemporaryFolder broken;
    for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libEGL.so.1"})
    {
        std::ofstream(broken / library) << "no library";
    }
    const char* const before = std::getenv("LD_LIBRARY_PATH");
    setenv("LD_LIBRARY_PATH", broken.Path().c_str(), 1);
    const Outcome failed = Run(command);
    before != nullptr ? setenv("LD_LIBRARY_PATH", before, 1) : unsetenv("LD_LIBRARY_PATH");
    EXPECT_EQ(failed.code, 3) << failed.errors;
    EXPECT_THAT(folder.Names(), ElementsAre("film.part.mkv", "film.part.mkv.json"));
}

/// Every line is one that Open Job Description's agents know: "openjd_progress: 0 to 100",
/// "openjd_status: TEXT", "openjd_fail: TEXT".
void ExpectOpenJd(const std::string& output)
{
    std::istringstream lines(output);
    double last = 0.0;
    for (std::string line; std::getline(lines, line);)
    {
        EXPECT_THAT(line, testing::MatchesRegex("openjd_(progress: [0-9.]+|(status|fail): .+)"));
        if (line.starts_with("openjd_progress: "))
        {
            const double progress = std::stod(line.substr(17));
            EXPECT_GE(progress, last);
            EXPECT_LE(progress, 100.0);
            last = progress;
        }
    }
}

TEST_F(Film, PrintsProgressAndFailureForOpenJobDescription)
{
    const Outcome outcome = Run({"record", "pyramid", "-o", "a.mkv", "--frames", "5", "--size",
                                 "160x90", "--progress", "openjd"});
    EXPECT_EQ(outcome.code, 0);
    ExpectOpenJd(outcome.output);
    EXPECT_THAT(outcome.output, testing::StartsWith("openjd_progress: 0.0\nopenjd_status: 0/5 "));
    EXPECT_THAT(outcome.output, HasSubstr("openjd_progress: 100.0\nopenjd_status: 5/5 frames"));
    const Outcome failed = Run({"record", "pyramid", "-o", "a.mkv", "--progress", "openjd"});
    EXPECT_EQ(failed.code, 1);
    ExpectOpenJd(failed.output);
    EXPECT_THAT(failed.output, HasSubstr("openjd_fail: a.mkv: "));
    const Outcome misunderstood =
        Run({"record", "pyramid", "-o", "a.mkv", "--progress=openjd", "--frames", "many"});
    EXPECT_EQ(misunderstood.code, 1);
    EXPECT_THAT(misunderstood.output, HasSubstr("--frames many"));
    const Outcome stopped =
        RunBoxreel({"record", "pyramid", "--frames", "10000000", "-o", "b.mkv", "--size", "160x90",
                    "--progress", "openjd"},
                   folder.Path(), [&](int process) { StopAfterGroups(process, SIGTERM); });
    EXPECT_EQ(stopped.code, 75);
    ExpectOpenJd(stopped.output);
    EXPECT_THAT(stopped.output, HasSubstr("openjd_fail: "));
}

TEST_F(Film, PrintsProgressOfLongSimulation)
{
    const std::vector<std::string> record{"record", "bridge", "-o",     "a.mkv", "--frames", "1",
                                          "--from", "50s",    "--size", "32x18", "--force"};
    const auto run = [&](const char* progress) {
        std::vector<std::string> command = record;
        command.insert(command.end(), {"--progress", progress});
        return Run(command);
    };
    EXPECT_THAT(run("lines").errors,
                HasSubstr("simulating up to the next frame, step 300 of 3000\nsimulating up to the "
                          "next frame, step 600 of 3000\n"));
    EXPECT_THAT(run("json").errors, HasSubstr(R"({"event":"simulating","step":2700,"last":3000})"));
    const std::string openjd = run("openjd").output;
    ExpectOpenJd(openjd);
    EXPECT_THAT(openjd, HasSubstr("openjd_status: simulating up to the next frame, step 3000 of "));
    EXPECT_EQ(run("none").errors, "");
}

TEST_F(Film, FailsWhileAnotherProgramWritesFilm)
{
    std::vector<std::string> record{"record", "pyramid", "--frames", "10000000",
                                    "-o",     "a.mkv",   "--size",   "32x18"};
    RunBoxreel(record, folder.Path(), [&](int process) {
        StopAfterGroups(process, SIGCONT, 100);
        for (const char* const again : {"--resume", "--force"})
        {
            std::vector<std::string> second = record;
            second.emplace_back(again);
            const Outcome outcome = Run(second);
            EXPECT_EQ(outcome.code, 4) << outcome.errors;
            EXPECT_THAT(outcome.errors, HasSubstr("a.part.mkv"));
        }
        kill(process, SIGTERM);
    });
}

TEST_F(Film, KeepsFramesAfterSignalDuringSimulation)
{
    std::vector<std::string> record{"record", "pyramid", "--frames", "20000",    "--hz",    "6000",
                                    "--size", "160x90",  "-o",       "film.mkv", "--group", "100"};
    const Outcome first = RunBoxreel(record, folder.Path(),
                                     [&](int process) { StopAfterGroups(process, SIGTERM, 300); });
    ASSERT_EQ(first.code, 75) << first.errors;
    // The last group counts as whole when another one follows.
    const std::size_t kept = (Decode("film.part.mkv").size() - 1) / 100 * 100;
    ASSERT_GE(kept, 200u);
    record.emplace_back("--resume");
    const auto part = folder / "film.part.mkv";
    const auto before = std::filesystem::last_write_time(part);
    const Outcome outcome = RunBoxreel(record, folder.Path(), [&](int process) {
        std::error_code ignored;
        for (int i = 0; i < 6000 && std::filesystem::last_write_time(part, ignored) == before; ++i)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        kill(process, SIGTERM); // it has what was left, and simulates for a while
    });
    EXPECT_EQ(outcome.code, 75) << outcome.errors;
    EXPECT_GE(Decode("film.part.mkv").size(), kept);
    record.insert(record.end(), {"--backend", "egl-gpu"}); // where there is none it fails
    if (Run(record).code == 3)
    {
        EXPECT_GE(Decode("film.part.mkv").size(), kept - 100);
    }
}

TEST_F(Film, IsFinishedByResumeWhenAllFramesExist)
{
    const auto record = [](const std::string& frames) {
        return std::vector<std::string>{"record", "pyramid", "-o",    "a-####.png", "--frames",
                                        frames,   "--size",  "32x18", "--resume"};
    };
    const Outcome stopped = RunBoxreel(record("9999"), folder.Path(), [&](int process) {
        for (int i = 0; i < 3000 && !std::filesystem::exists(folder / "a-0005.png"); ++i)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        kill(process, SIGTERM);
    });
    ASSERT_EQ(stopped.code, 75) << stopped.errors;
    std::string manifestName;
    int count = 0;
    for (const std::string& name : folder.Names())
    {
        count += name.ends_with(".png") ? 1 : 0;
        manifestName = name.ends_with(".json") ? name : manifestName;
    }
    ASSERT_GT(count, 0);
    std::string manifest = ReadBytes(folder / manifestName);
    for (const std::string before : {"\n  \"", "\"frames\": ", "\"end\": "})
    {
        const std::size_t at = manifest.find(before + "9999");
        ASSERT_NE(at, std::string::npos) << before;
        manifest.replace(at + before.size(), 4, std::to_string(count));
    }
    std::ofstream(folder / manifestName) << manifest;
    const Outcome again = Run(record(std::to_string(count)));
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(folder.Names().size(), std::size_t(count));
}

} // namespace
} // namespace boxreel
