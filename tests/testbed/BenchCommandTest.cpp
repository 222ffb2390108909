// SPDX-License-Identifier: MIT
// `boxreel bench` in a process of its own: what it refuses before anything is run, and what it
// writes.
#include "Subprocess.h"

#include <render/Png.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <thread>

namespace boxreel
{
namespace
{

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two engines in a scene of a curve, as `--json` prints it.
constexpr const char* kEarlierRun = R"({"scenes":[{"scene":"static-200","what":"few",
  "goalTimesFaster":20,"curve":"static","count":200,"comparesSpeeds":false,"engines":[
  {"engine":"boxreel 0.1.0","ours":true,"threads":1,"meanSeconds":1e-5,"medianSeconds":1e-5,
   "p99Seconds":1.2e-5,"cpuSeconds":1e-5,"contacts":200,"memoryKilobytes":700,"finite":true,
   "escaped":0,"awake":0,"meanHeightMetres":2.5,"meanSpeedMetresPerSecond":0,"bits":"00"},
  {"engine":"Box2D 2.4.1","ours":false,"threads":1,"meanSeconds":7e-5,"medianSeconds":7e-5,
   "p99Seconds":8e-5,"cpuSeconds":7e-5,"contacts":200,"memoryKilobytes":600,"finite":true,
   "escaped":0,"awake":0,"meanHeightMetres":2.5,"meanSpeedMetresPerSecond":0,"bits":"11"}]}]})";

class BenchCommand : public testing::Test
{
protected:
    BenchCommand() { std::ofstream(folder / "run.json") << kEarlierRun; }

    Outcome Run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "bench");
        return RunBoxreel(arguments, folder.Path());
    }

    /// One sentence with the culprit, and no file more.
    void ExpectRefusal(const std::vector<std::string>& arguments, const std::string& culprit) const
    {
        const std::vector<std::string> before = folder.Files();
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.code, 1) << outcome.errors;
        EXPECT_THAT(outcome.errors, testing::StartsWith("boxreel: "));
        EXPECT_THAT(outcome.errors, HasSubstr(culprit));
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
            << outcome.errors;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(folder.Files(), before);
    }

    /// Of benchmarks that make films below this folder, with something in them.
    std::ptrdiff_t WorkFolders() const
    {
        const std::vector<std::string> files = folder.Files();
        return std::count_if(files.begin(), files.end(), [this](const std::string& name) {
            return name.starts_with("boxreel-bench-") && !std::filesystem::is_empty(folder / name);
        });
    }

    TemporaryFolder folder;
};

TEST_F(BenchCommand, RefusesAChartThatCouldNotBeWrittenBeforeAnythingIsRun)
{
    std::ofstream(folder / "old.svg") << "old";
    ExpectRefusal({"rain", "--chart", "chart.jpg"}, "'chart.jpg' does not end in .png or .svg");
    ExpectRefusal({"rain", "--chart", "none/chart.png"}, "There is no folder 'none'");
    ExpectRefusal({"rain", "--chart", "old.svg"}, "'old.svg' exists; --force overwrites it");
    ExpectRefusal({"rain", "--chart", "a.png", "--chart", "a.png"}, "'a.png' twice");
    ExpectRefusal({"rain", "--chart", "a.png", "--chart", "./a.png"}, "'./a.png' twice");
    ExpectRefusal({"rain", "--chart", "/proc/a.png"}, "the folder /proc takes no files");
    ExpectRefusal({"rain", "rain"}, "'rain' is named twice");
    EXPECT_EQ(ReadFile(folder / "old.svg"), "old");
}

TEST_F(BenchCommand, RefusesFiguresThatAreNoFigures)
{
    std::ofstream(folder / "other.json") << "{}";
    ExpectRefusal({"--from", "other.json"}, "'other.json'");
    ExpectRefusal({"--from", "absent.json"}, "Cannot read 'absent.json'");
    ExpectRefusal({"--from", "."}, "Cannot read '.'");
    std::ofstream(folder / "empty.json").flush();
    for (const char* kind : {"--accuracy", "--render", "--record"})
    {
        ExpectRefusal({kind, "--from", "empty.json"}, "'empty.json' is empty; name a file that");
        ExpectRefusal({kind, "--from", "run.json", "--chart", "a.txt"},
                      "'a.txt' does not end in .png or .svg");
        ExpectRefusal({kind, "--chart", "b/a.txt"}, "'b/a.txt' does not end in .png or .svg");
    }
    std::string text = kEarlierRun;
    text.replace(text.find("\"cpuSeconds\":1e-5"), 17, "\"cpuSeconds\":-1");
    std::ofstream(folder / "negative.json") << text;
    ExpectRefusal({"--from", "negative.json"}, "'negative.json' has 'cpuSeconds' of -1");
    ExpectRefusal({"--from", "negative.json", "--chart", "a.png"}, "'cpuSeconds' of -1");
}

TEST_F(BenchCommand, RefusesToRunWhatWasRunBefore)
{
    ExpectRefusal({"--json", "--from", "run.json", "--rounds", "5"}, "leave --rounds");
    ExpectRefusal({"--from", "run.json", "--threads", "1,2"}, "leave --rounds and --threads out");
    ExpectRefusal({"--from", "run.json", "--threads", "1"}, "leave --rounds and --threads out");
    ExpectRefusal({"--from", "run.json", "--rounds", "3"}, "leave --rounds");
}

TEST_F(BenchCommand, DrawsAnEarlierRunInBothFormats)
{
    const Outcome outcome = Run({"--from", "run.json", "--chart", "a.png", "--chart", "a.svg"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_THAT(outcome.output, HasSubstr("7.00x"));
    EXPECT_THAT(folder.Files(), ElementsAre("a.png", "a.svg", "run.json"));
    EXPECT_TRUE(ReadPng(folder / "a.png"));
    EXPECT_THAT(ReadFile(folder / "a.svg"), HasSubstr("</svg>"));
}

TEST_F(BenchCommand, DrawsTheCurveInstead)
{
    EXPECT_EQ(Run({"--from", "run.json", "--chart", "bars.svg"}).code, 0);
    EXPECT_EQ(Run({"--from", "run.json", "--curve", "--chart", "curve.svg"}).code, 0);
    EXPECT_NE(ReadFile(folder / "bars.svg"), ReadFile(folder / "curve.svg"));
}

TEST_F(BenchCommand, OverwritesAChartOnlyWhenToldTo)
{
    std::ofstream(folder / "a.svg") << "old";
    EXPECT_EQ(Run({"--from", "run.json", "--chart", "a.svg", "--force"}).code, 0);
    EXPECT_THAT(ReadFile(folder / "a.svg"), HasSubstr("</svg>"));
}

TEST_F(BenchCommand, RunsASceneOnAllEnginesAndPrintsWhatItCanReadAgain)
{
    const Outcome outcome = Run({"asleep-200", "--rounds", "1", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(
        outcome.output,
        ContainsRegex("\"engine\": \"boxreel [^\"]*\",[[:space:]]*\"ours\": true,[[:space:]]*"
                      "\"threads\": 1,[[:space:]]*\"verdict\": \"sound\""));
    std::ofstream(folder / "again.json") << outcome.output;
    EXPECT_EQ(Run({"--from", "again.json", "--json"}).output, outcome.output);
}

TEST_F(BenchCommand, SweepsAnAccuracyCaseOnAllEnginesAndDrawsIt)
{
    const Outcome outcome =
        Run({"--accuracy", "F-slope", "--rounds", "2", "--json", "--chart", "e.svg"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("\"case\": \"F-slope\""));
    EXPECT_THAT(outcome.output, HasSubstr("\"engine\": \"boxreel "));
    EXPECT_THAT(outcome.output, HasSubstr("\"hz\": 480"));
    EXPECT_THAT(folder.Files(), ElementsAre("e-F-slope.svg", "run.json"));
    EXPECT_THAT(ReadFile(folder / "e-F-slope.svg"), HasSubstr("</svg>"));
    std::ofstream(folder / "again.json") << outcome.output;
    const Outcome again = Run({"--accuracy", "--from", "again.json", "--json", "--chart", "f.svg"});
    EXPECT_EQ(again.output, outcome.output);
    EXPECT_EQ(ReadFile(folder / "f-F-slope.svg"), ReadFile(folder / "e-F-slope.svg"));
    EXPECT_THAT(Run({"--accuracy", "F-slope", "--from", "again.json"}).output,
                HasSubstr("iterations"));
    ExpectRefusal({"--accuracy", "A-projectile", "--from", "again.json"}, "'A-projectile'");
    ExpectRefusal({"--from", "again.json"}, "is not what `boxreel bench --json` prints");
}

TEST_F(BenchCommand, RefusesWhatDoesNotGoWithAccuracy)
{
    std::ofstream(folder / "e-F-slope.svg") << "old";
    ExpectRefusal({"--accuracy", "F-slop"}, "Did you mean 'F-slope'?");
    ExpectRefusal({"--accuracy", "--curve"}, "--accuracy goes with");
    ExpectRefusal({"--accuracy", "--threads", "1"}, "--accuracy goes with");
    ExpectRefusal({"--accuracy", "--from", "run.json", "--rounds", "5"}, "leave --rounds");
    ExpectRefusal({"--accuracy", "F-slope", "--chart", "e.svg"}, "'e-F-slope.svg' exists");
    ExpectRefusal({"--accuracy", "--chart", "a.svg", "--chart", "a.svg"}, "'a.svg' twice");
    ExpectRefusal({"--accuracy", "--chart", "/proc/a.svg"}, "the folder /proc takes no files");
    ExpectRefusal({"--accuracy", "--from", "run.json"},
                  "is not what `boxreel bench --accuracy --json` prints");
    ExpectRefusal({"--accuracy", "--from", "absent.json"}, "Cannot read 'absent.json'");
    EXPECT_EQ(Run({"--accuracy", "--list"}).code, 0);
    EXPECT_THAT(Run({"--accuracy", "--list"}).output, HasSubstr("K-far"));
}

TEST_F(BenchCommand, DrawsACaseWithAllRenderersAndChartsItsSize)
{
    const Outcome outcome =
        Run({"--render", "50-720p", "--rounds", "1", "--json", "--chart", "r.svg"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("\"case\": \"50-720p\""));
    EXPECT_THAT(outcome.output,
                ContainsRegex("\"method\": \"boxreel [^\"]*\",[[:space:]]*\"ours\": true,"
                              "[[:space:]]*\"rasterThreads\": \"0\""));
    EXPECT_THAT(outcome.output, HasSubstr("\"rasterThreads\": \"own\""));
    EXPECT_THAT(outcome.output, HasSubstr("\"floor\""));
    EXPECT_THAT(folder.Files(), ElementsAre("r-720p.svg", "run.json"));
    std::ofstream(folder / "again.json") << outcome.output;
    const Outcome again = Run({"--render", "--from", "again.json", "--json", "--chart", "s.svg"});
    EXPECT_EQ(again.output, outcome.output) << again.errors;
    EXPECT_EQ(ReadFile(folder / "s-720p.svg"), ReadFile(folder / "r-720p.svg"));
    EXPECT_THAT(Run({"--render", "50-720p", "--from", "again.json"}).output,
                HasSubstr("clear+read"));
    ExpectRefusal({"--render", "1500-720p", "--from", "again.json"}, "'1500-720p'");
    ExpectRefusal({"--accuracy", "--from", "again.json"}, "--accuracy --json` prints");
}

TEST_F(BenchCommand, RefusesWhatDoesNotGoWithDrawing)
{
    std::ofstream(folder / "r-720p.svg") << "old";
    ExpectRefusal({"--render", "50-72p"}, "Did you mean '50-720p'?");
    ExpectRefusal({"--render", "50-720p", "50-720p"}, "named twice");
    ExpectRefusal({"--render", "--curve"}, "--render goes with");
    ExpectRefusal({"--render", "--threads", "2"}, "--render goes with");
    ExpectRefusal({"--render", "50-720p", "--chart", "r.svg"}, "'r-720p.svg' exists");
    ExpectRefusal({"--render", "--chart", "a.svg", "--chart", "a.svg"}, "'a.svg' twice");
    ExpectRefusal({"--render", "--chart", "a.jpg"}, "does not end in .png or .svg");
    ExpectRefusal({"--render", "--from", "run.json"},
                  "is not what `boxreel bench --render --json` prints");
    ExpectRefusal({"--render", "--from", "absent.json"}, "Cannot read 'absent.json'");
    ExpectRefusal({"--render", "--from", "run.json", "--rounds", "2"}, "leave --rounds");
    EXPECT_THAT(Run({"--render", "--list"}).output, HasSubstr("10000-1080p"));
}

TEST_F(BenchCommand, MakesAFilmInEveryWayAndChartsThem)
{
    const Outcome outcome = Run({"--record", "tumbler", "--rounds", "1", "--frames", "6", "--size",
                                 "320x180", "--json", "--chart", "f.svg"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    for (const char* role : {"boxreel", "start", "encodeOnly", "immediate"})
    {
        EXPECT_THAT(outcome.output,
                    ContainsRegex("\"role\": \"" + std::string(role) +
                                  "\",[^}]*\"verdict\": \"sound\",[[:space:]]*\"wallSeconds\""));
    }
    EXPECT_THAT(outcome.output, HasSubstr("\"stage\": \"converting colours\""));
    EXPECT_THAT(outcome.output, testing::Not(HasSubstr("goalsMet"))) << "it is another film";
    EXPECT_THAT(folder.Files(), ElementsAre("f-speed.svg", "f-stages.svg", "run.json"));
    std::ofstream(folder / "again.json") << outcome.output;
    const Outcome again = Run({"--record", "--from", "again.json", "--json", "--chart", "g.svg"});
    EXPECT_EQ(again.output, outcome.output) << again.errors;
    EXPECT_EQ(ReadFile(folder / "g-stages.svg"), ReadFile(folder / "f-stages.svg"));
    EXPECT_THAT(Run({"--record", "tumbler", "--from", "again.json"}).output,
                HasSubstr("where a frame's time goes"));
    ExpectRefusal({"--record", "pyramid", "--from", "again.json"}, "'pyramid'");
    ExpectRefusal({"--render", "--from", "again.json"}, "--render --json` prints");
}

TEST_F(BenchCommand, MakesPicturesInEveryWayThatThereIs)
{
    const Outcome outcome = Run(
        {"--record", "pictures", "--rounds", "1", "--frames", "3", "--size", "160x90", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, ContainsRegex("\"role\": \"boxreel\",[^}]*\"sound\""));
    EXPECT_THAT(outcome.output, ContainsRegex("\"role\": \"encodeOnly\",[^}]*\"sound\""));
}

TEST_F(BenchCommand, WithoutFfmpegShowsOurFilmsAloneAndSaysSo)
{
    const Variable path("PATH", "/nowhere");
    const Outcome outcome =
        Run({"--record", "tumbler", "--rounds", "1", "--frames", "2", "--size", "64x36"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("ffmpeg does not run here; install Debian's ffmpeg."));
    EXPECT_THAT(outcome.output, HasSubstr("boxreel record"));
    EXPECT_THAT(outcome.output, testing::Not(HasSubstr("raw file")));
}

TEST_F(BenchCommand, SaysBeforeAnythingIsMadeThatThereIsNoRoom)
{
    const Outcome outcome =
        Run({"--record", "tumbler", "--frames", "100000", "--size", "8192x8192"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.errors, HasSubstr("The raw frames of 'tumbler' need 26844.0 GB in "));
}

TEST_F(BenchCommand, StoppedLeavesNoFramesAndFilmsBehind)
{
    const Variable temporary("TMPDIR", folder.Path().c_str());
    const auto stop = [this](int process) {
        for (int i = 0; i < 3000 && WorkFolders() == 0; ++i)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        kill(process, SIGINT);
    };
    const Outcome outcome =
        RunBoxreel({"bench", "--record", "--frames", "60", "--size", "64x36"}, folder.Path(), stop);
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.errors, HasSubstr("boxreel: Stopped before the first case was done."));
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(WorkFolders(), 0);
}

TEST_F(BenchCommand, RefusesWhatDoesNotGoWithRecording)
{
    std::ofstream(folder / "f-speed.svg") << "old";
    ExpectRefusal({"--record", "tumble"}, "Did you mean 'tumbler'?");
    ExpectRefusal({"--record", "tumbler", "tumbler"}, "named twice");
    ExpectRefusal({"--record", "--render"}, "--record goes with");
    ExpectRefusal({"--record", "--chart", "f.svg"}, "'f-speed.svg' exists");
    ExpectRefusal({"--record", "--chart", "a.jpg"}, "does not end in .png or .svg");
    ExpectRefusal({"--record", "--from", "run.json"},
                  "is not what `boxreel bench --record --json` prints");
    ExpectRefusal({"--record", "--from", "absent.json"}, "Cannot read 'absent.json'");
    ExpectRefusal({"--record", "--from", "run.json", "--rounds", "2"}, "leave --rounds");
    EXPECT_THAT(Run({"--record", "--list"}).output, HasSubstr("asleep"));
}

/// What `--golden --json` says of a method and a change, such as "different":true; empty: nothing.
std::string Verdict(const std::string& json, const std::string& method, const std::string& change)
{
    const std::size_t at = json.find("\"method\": \"" + method);
    const std::size_t found =
        at == std::string::npos ? at : json.find("\"change\": \"" + change + "\"", at);
    const std::size_t verdict =
        found == std::string::npos ? found : json.find("\"different\": ", found);
    return verdict == std::string::npos
               ? ""
               : json.substr(verdict + 13, json.find(',', verdict) - verdict - 13);
}

TEST_F(BenchCommand, ComparesPlantedChangesWithNoPeersAtHand)
{
    const Outcome outcome = Run({"--golden", "bridge", "--rounds", "1", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    for (const char* change : {"body", "line", "fill", "label", "outline", "order"})
    {
        EXPECT_EQ(Verdict(outcome.output, "boxreel " BOXREEL_VERSION ", same-machine", change),
                  "true")
            << change;
    }
    for (const char* change : {"equal", "stray"})
    {
        EXPECT_EQ(Verdict(outcome.output, "boxreel " BOXREEL_VERSION ", same-machine", change),
                  "false")
            << change;
    }
    for (const char* change : {"equal", "stray", "shift"})
    {
        EXPECT_EQ(Verdict(outcome.output, "boxreel " BOXREEL_VERSION ", cross-machine", change),
                  "false")
            << change;
    }
    EXPECT_THAT(outcome.output, HasSubstr("odiff is not compared; run `npm install odiff-bin`"));
    EXPECT_THAT(outcome.output, HasSubstr("pixelmatch is not compared; run `npm install"));
    EXPECT_EQ(WorkFolders(), 0);
}

// A program in odiff's place that calls all pictures different, and then one that breaks.
TEST_F(BenchCommand, ComparesWithPeersOfAFolder)
{
    const std::filesystem::path modules = folder / "node_modules";
    std::filesystem::create_directories(modules / "@odiff" / "linux");
    std::filesystem::create_directories(modules / "odiff-bin");
    std::ofstream(modules / "odiff-bin" / "package.json") << "{\"version\": \"9.8.7\"}";
    const std::filesystem::path program = modules / "@odiff" / "linux" / "odiff";
    std::ofstream(program) << "#!/bin/sh\nexit 22\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const Outcome outcome = Run({"--golden", "bridge", "--rounds", "1", "--json", "--peers", "."});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(Verdict(outcome.output, "odiff 9.8.7", "equal"), "true");
    EXPECT_THAT(outcome.output, Not(HasSubstr("odiff is not compared")));

    std::ofstream(program) << "#!/bin/sh\necho broken\nexit 3\n";
    const Outcome table = Run({"--golden", "bridge", "--rounds", "1", "--peers", "."});
    ASSERT_EQ(table.code, 0) << table.errors;
    EXPECT_THAT(table.output, ContainsRegex("odiff 9.8.7 +failed: .*code 3, saying \"broken\""));
    EXPECT_THAT(table.output, ContainsRegex("same-machine +1/1 +1/1 +1/1 +1/1 +1/1 +1/1 +0/1 +0/1 "
                                            "+1/1! +[0-9.]+ +[0-9.]+ +[0-9.]+\n"));
    EXPECT_THAT(table.output, ContainsRegex("cross-machine +0/1! "));
}

TEST_F(BenchCommand, RefusesWhatDoesNotGoWithComparing)
{
    ExpectRefusal({"--golden", "--peers", "."}, "'.' holds no peers; run `npm install");
    ExpectRefusal({"--golden", "brigde"}, "brigde");
    ExpectRefusal({"--golden", "bridge", "bridge"}, "named twice");
    ExpectRefusal({"--golden", "--render"}, "--golden goes with");
    ExpectRefusal({"--golden", "--from", "run.json"}, "--golden goes with");
    ExpectRefusal({"--render", "--peers", "."}, "add --golden");
    EXPECT_THAT(Run({"--golden", "--list"}).output, HasSubstr("outline"));
}

TEST_F(BenchCommand, ListsAllScenes)
{
    const Outcome outcome = Run({"--list"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    for (const char* scene : {"large-pyramid", "static-200000", "asleep-200000", "create-destroy"})
    {
        EXPECT_THAT(outcome.output, HasSubstr(scene));
    }
}

} // namespace
} // namespace boxreel
