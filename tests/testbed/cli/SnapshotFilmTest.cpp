// SPDX-License-Identifier: MIT
// Films whose simulation begins with what another run has left.
#include "../StatsRows.h"
#include "FilmFixture.h"
#include "Refusals.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <future>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr const char* kMachine = R"({"gravity":{"x":0,"y":-10},"body":[
    {"name":"wall","type":0},
    {"name":"arm","type":2,"position":{"x":1,"y":5},"fixture":[{"density":1,
     "polygon":{"vertices":{"x":[-1,1,1,-1],"y":[-0.1,-0.1,0.1,0.1]}}}]},
    {"name":"end","type":2,"position":{"x":3,"y":5},"fixture":[{"density":1,
     "polygon":{"vertices":{"x":[-1,1,1,-1],"y":[-0.1,-0.1,0.1,0.1]}}}]}],
  "joint":[
    {"type":"revolute","name":"shoulder","bodyA":0,"bodyB":1,"anchorA":{"x":0,"y":5},
     "anchorB":{"x":-1,"y":0}},
    {"type":"revolute","name":"elbow","bodyA":1,"bodyB":2,"anchorA":{"x":1,"y":0},
     "anchorB":{"x":-1,"y":0}}]})";

class Snapshots : public FilmFixture
{
protected:
    /// Frames of a film of 300, `look` apart; quiet but for --stats.
    std::vector<std::string> Command(const std::string& output, const std::string& range,
                                     const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> command = m_film;
        command.insert(command.end(), {"-o", output, "--frame-range", range, "--progress", "none",
                                       "--stats", "--force"});
        command.insert(command.end(), more.begin(), more.end());
        return command;
    }

    std::string Record(const std::string& output, const std::string& range,
                       const std::vector<std::string>& more = {}) const
    {
        const Outcome outcome = Run(Command(output, range, more));
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return outcome.errors;
    }

    /// Records, and returns how many steps it simulated, and the step of the snapshot that it began
    /// with; from the start, only the first.
    std::vector<double> Steps(const std::string& output, const std::string& range,
                              const std::vector<std::string>& more = {}) const
    {
        return NumbersOf(Record(output, range, more), "steps");
    }

    void ExpectSameAsPlain(const std::string& film) const
    {
        EXPECT_TRUE(Decode(film) == Decode("plain.mkv")) << film << " has other frames";
        EXPECT_EQ(ReadBytes(folder / (film + ".json")), ReadBytes(folder / "plain.mkv.json"));
    }

    std::vector<std::string> Files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "states"))
        {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    std::filesystem::path FileOf(const std::string& step) const
    {
        for (const std::string& name : Files())
        {
            if (name.ends_with("-" + step + ".snapshot"))
            {
                return folder / "states" / name;
            }
        }
        ADD_FAILURE() << "no snapshot of step " << step;
        return {};
    }

    void SetFilm(std::vector<std::string> film)
    {
        m_film = std::move(film);
        m_film.insert(m_film.end(), {"--frames", "300", "--size", "160x90"});
    }

    std::vector<std::string> m_film{"record", "tumbler", "--frames", "300", "--size", "160x90"};
    const std::vector<std::string> kStates{"--snapshots", "states"};
};

TEST_F(Snapshots, GiveFilmsEqualToFilmsFromStart)
{
    std::ofstream(folder / "machine.json") << kMachine;
    const std::vector<std::vector<std::string>> films{
        {"record", "tumbler"},                             // bodies come, by chance
        {"record", "tumbler", "--camera", "follow:3,240"}, // one that is there, and one later
        {"record", "tumbler", "--camera", "follow:150"},   // waits, and then follows
        {"record", "tumbler", "--camera", "fit:150", "--labels"},
        {"record", "bridge", "--camera", "fit:world", "--draw", "shapes,joints,forces,glyphs"},
        {"record", "dominos", "--camera", "fit:12,13", "--speed", "0.5", "--from", "1s"},
        {"record", "dominos", "--camera", "path:0s=0,20,50;3s=10,5,12;6s=0,20,50"},
        {"record", "pyramid", "--draw", "shapes,contacts,impulses", "--hz", "120"},
        {"record", "newtons-cradle", "--velocity-iterations", "4", "--fps", "25"},
        {"record", "machine.json", "--draw", "shapes,joints,names", "--camera", "follow:end"},
        {"record", "vertical-stack", "--from", "20s"}, // asleep
    };
    for (const std::vector<std::string>& film : films)
    {
        SCOPED_TRACE(testing::PrintToString(film));
        SetFilm(film);
        EXPECT_THAT(Steps("plain.mkv", "200-299"), SizeIs(1));
        Record("first.mkv", "0-199", kStates);
        EXPECT_THAT(Steps("film.mkv", "200-299", kStates), SizeIs(2));
        ExpectSameAsPlain("film.mkv");
    }
    EXPECT_THAT(Steps("again.mkv", "200-299", kStates), SizeIs(2));
    ExpectSameAsPlain("again.mkv");
}

TEST_F(Snapshots, SkipStepsSimulatedBefore)
{
    EXPECT_THAT(Steps("first.mkv", "0-199", kStates), ElementsAre(200));
    EXPECT_THAT(Steps("second.mkv", "200-299", kStates), ElementsAre(100, 200));
    EXPECT_THAT(Steps("between.mkv", "150-160", kStates), ElementsAre(61, 100));
    EXPECT_EQ(Run({"merge", "first.mkv", "second.mkv", "-o", "whole.mkv"}).code, 0);
}

TEST_F(Snapshots, AreWrittenAtGivenInterval)
{
    Record("first.mkv", "0-99", {"--snapshots", "states", "--snapshot-every", "7"});
    EXPECT_EQ(Files().size(), 14u);
    EXPECT_THAT(Steps("second.mkv", "100-101", kStates), ElementsAre(4, 98));
}

TEST_F(Snapshots, AreNotUsedForOtherFilms)
{
    Record("first.mkv", "0-199", kStates);
    const std::vector<std::vector<std::string>> others{{"--hz", "120"},
                                                       {"--seed", "7"},
                                                       {"--velocity-iterations", "9"},
                                                       {"--camera", "0,5,30"},
                                                       {"--position-iterations", "4"}};
    for (const std::vector<std::string>& other : others)
    {
        SCOPED_TRACE(testing::PrintToString(other));
        std::vector<std::string> more = kStates;
        more.insert(more.end(), other.begin(), other.end());
        const std::string errors = Record("other.mkv", "200-201", more);
        EXPECT_THAT(NumbersOf(errors, "steps"), SizeIs(1));
        EXPECT_THAT(errors, Not(HasSubstr("boxreel:")));
    }
    SetFilm({"record", "bridge"});
    EXPECT_THAT(Steps("other.mkv", "200-201", kStates), SizeIs(1));
}

TEST_F(Snapshots, AreNotUsedAfterSceneFileChanged)
{
    std::ofstream(folder / "machine.json") << kMachine;
    SetFilm({"record", "machine.json"});
    Record("first.mkv", "0-199", kStates);
    EXPECT_THAT(Steps("film.mkv", "200-201", kStates), ElementsAre(testing::_, 200));
    std::string other = kMachine;
    other.replace(other.find("-10"), 3, "-11");
    std::ofstream(folder / "machine.json") << other;
    EXPECT_THAT(Steps("film.mkv", "200-201", kStates), SizeIs(1));
}

TEST_F(Snapshots, AreReportedAndReplacedWhenDamagedOrForeign)
{
    Record("plain.mkv", "200-299");
    Record("first.mkv", "0-199", kStates);
    const std::filesystem::path path = FileOf("0000000200");
    const std::string whole = ReadBytes(path);
    SetFilm({"record", "tumbler", "--seed", "2"});
    Record("other.mkv", "0-0", {"--snapshots", "others", "--from", "4s"});
    std::string foreign;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "others"))
    {
        if (entry.path().string().ends_with("200.snapshot"))
        {
            foreign = ReadBytes(entry.path());
        }
    }
    SetFilm({"record", "tumbler"});
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    std::string turned = whole; // one bit of the camera
    turned[whole.find('\n', whole.find("\nbytes ") + 1) + 30] ^= 1;
    std::string newer = whole;
    newer.replace(newer.find("snapshot 1"), 10, "snapshot 2");
    const std::pair<std::string, const char*> contents[] = {
        {flipped, "a changed bit"},
        {turned, "a changed bit of the camera"},
        {whole.substr(0, whole.size() - 1), "a byte too few"},
        {whole + "x", "a byte too many"},
        {whole.substr(0, whole.find("\nbytes ") + 10), "cut in its heading"},
        {whole.substr(0, 30), "cut in its version"},
        {newer, "another version"},
        {"\x89PNG\r\n", "a picture"},
        {foreign, "another film"},
        {ReadBytes(FileOf("0000000100")), "another step"},
        {"", "empty"},
    };
    for (const auto& [content, what] : contents)
    {
        SCOPED_TRACE(what);
        std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
        const std::string errors = Record("film.mkv", "200-299", kStates);
        EXPECT_THAT(errors, HasSubstr(path.filename().string() + " "));
        EXPECT_THAT(NumbersOf(errors, "steps"), ElementsAre(200, 100));
        EXPECT_EQ(errors.find("boxreel:"), errors.rfind("boxreel:")) << "one sentence";
        ExpectSameAsPlain("film.mkv");
        EXPECT_TRUE(ReadBytes(path) == whole) << "it is whole again";
    }
}

TEST_F(Snapshots, AreReportedWhenUnwritableAndFilmIsComplete)
{
    Record("plain.mkv", "200-299");
    Record("first.mkv", "0-199", kStates);
    const std::filesystem::path path = FileOf("0000000200");
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    const std::string errors = Record("film.mkv", "200-299", kStates);
    EXPECT_THAT(errors, HasSubstr(path.filename().string() + " "));
    ExpectSameAsPlain("film.mkv");
}

TEST_F(Snapshots, AreValidAfterConcurrentRuns)
{
    Record("plain.mkv", "200-299");
    const auto run = [this](const char* output) {
        return std::async(std::launch::async, [this, output] {
            return Run(
                Command(output, "200-299", {"--snapshots", "states", "--snapshot-every", "1"}));
        });
    };
    std::future<Outcome> a = run("a.mkv");
    std::future<Outcome> b = run("b.mkv");
    for (const Outcome& outcome : {a.get(), b.get()})
    {
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_THAT(outcome.errors, Not(HasSubstr("boxreel:")));
    }
    ExpectSameAsPlain("a.mkv");
    ExpectSameAsPlain("b.mkv");
    EXPECT_EQ(Files().size(), 300u);
    EXPECT_THAT(Files(), testing::Each(AllOf(EndsWith(".snapshot"), Not(HasSubstr(".part-")))));
    EXPECT_THAT(Steps("film.mkv", "200-299", kStates), ElementsAre(testing::_, 200));
    ExpectSameAsPlain("film.mkv");
}

TEST_F(Snapshots, SpeedUpResumedFilm)
{
    const std::vector<std::string> record{"record",   "tumbler",  "--frames", "400",
                                          "--camera", "follow:3", "--size",   "160x90",
                                          "--group",  "100",      "-o"};
    std::vector<std::string> whole = record;
    whole.emplace_back("whole.mkv");
    ASSERT_EQ(Run(whole).code, 0);
    std::vector<std::string> command = record;
    command.insert(command.end(), {"film.mkv", "--snapshots", "states", "--stats"});
    const Outcome killed =
        RunBoxreel(command, folder.Path(), [&](int process) { StopAfterGroups(process, SIGKILL); });
    ASSERT_EQ(killed.code, 128 + SIGKILL) << "it was over before it could be killed";
    command.emplace_back("--resume");
    const Outcome resumed = Run(command);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(NumbersOf(resumed.errors, "steps"), SizeIs(2));
    EXPECT_TRUE(Decode("film.mkv") == Decode("whole.mkv"));
}

TEST_F(Snapshots, RequireWritableFolderBeforeSimulation)
{
    std::ofstream(folder / "file") << "no folder";
    const std::pair<const char*, int> wrong[] = {
        {"file", 1}, {"file/below", 1}, {"not/there", 1}, {"/proc", 4}};
    for (const auto& [name, code] : wrong)
    {
        // A simulation of this length would outlast the test's time limit.
        const Outcome outcome =
            Run({"record", "pyramid", "-o", "a.mkv", "--frames", "10000000", "--snapshots", name});
        ExpectRefused(outcome, std::string("--snapshots ") + name, code);
    }
    EXPECT_THAT(folder.Names(), ElementsAre("file"));
    EXPECT_EQ(Run({"record", "pyramid", "-o", "a.mkv", "--snapshot-every", "5"}).code, 1);
}

} // namespace
} // namespace boxreel
