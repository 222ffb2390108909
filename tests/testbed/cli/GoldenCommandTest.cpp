// SPDX-License-Identifier: MIT
// `boxreel golden`: the real program, as a shell runs it.
#include "Refusals.h"

#include <golden/ReferenceStore.h>
#include <render/Png.h>
#include <render/Renderer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class GoldenCommand : public testing::Test
{
protected:
    Outcome Run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "golden");
        return RunBoxreel(arguments, folder.Path());
    }

    /// With the references r and the output o.
    Outcome RunIn(std::vector<std::string> arguments) const
    {
        for (const char* more : {"--references", "r", "--output", "o"})
        {
            arguments.emplace_back(more);
        }
        return Run(std::move(arguments));
    }

    void ExpectRefusal(const std::vector<std::string>& arguments, const std::string& culprit) const
    {
        ExpectRefused(Run(arguments), culprit);
    }

    void Blacken(const std::string& picture) const
    {
        Frame frame;
        frame.width = 480;
        frame.height = 270;
        frame.rgba.assign(480 * 270 * 4, 0);
        ASSERT_TRUE(WritePng(folder / picture, frame, {.overwrite = true}));
    }

    /// A program like ours, except that body 17 is 3 cm lower from step 43 on.
    fs::path OtherProgram() const
    {
        const fs::path script = folder / "other";
        std::ofstream(script) << "#!/bin/sh\n"
                              << "'" << BOXREEL_PROGRAM << "' \"$@\" | awk -v asked=\"$*\" '"
                              << R"(
            asked ~ /trace/ && $1 >= 43 {
                digit = substr($3, 18, 1) == "0" ? "1" : "0"
                print $1, "ffffffff", substr($3, 1, 17) digit substr($3, 19); next }
            asked !~ /trace/ && $1 == 17 { $3 += 0.03 }
            { print })"
                              << "'\n";
        fs::permissions(script, fs::perms::owner_all);
        return script;
    }

    TemporaryFolder folder;
};

TEST_F(GoldenCommand, RequiresReferenceFolder)
{
    ExpectRefusal({"verify"}, "golden/references");
    ExpectRefusal({"verify", "--references", "none"}, "--references none");
    ExpectRefusal({"verify", "pyramid/3s", "--references", "."}, "'pyramid/3s'");
    ExpectRefusal({"verify", "pyrmid/2s", "--references", "."}, "'pyrmid'");
}

TEST_F(GoldenCommand, AcceptsAndVerifiesAndFindsChange)
{
    const std::vector<std::string> verify{"verify", "pyramid"};
    EXPECT_EQ(RunIn({"accept", "pyramid"}).code, 0);
    const Outcome same = RunIn(verify);
    EXPECT_EQ(same.code, 0) << same.output << same.errors;

    Blacken("r/frames/pyramid/2s.png");
    const Outcome changed = RunIn(verify);
    EXPECT_EQ(changed.code, 2);
    EXPECT_THAT(changed.output, HasSubstr("FAIL  pyramid/2s"));
    EXPECT_THAT(changed.output, HasSubstr("same  pyramid/0.5s"));
    EXPECT_TRUE(fs::exists(folder / "o"));

    fs::remove(folder / "r/frames/pyramid/2s.png");
    EXPECT_EQ(RunIn(verify).code, 2) << "a missing reference fails";

    const Outcome moment = RunIn({"accept", "pyramid/2s"});
    EXPECT_THAT(moment.output, HasSubstr("1 moment accepted"));
    EXPECT_EQ(RunIn(verify).code, 0) << "one moment was accepted";
}

TEST_F(GoldenCommand, AcceptsOnlyMissingOrChanged)
{
    ASSERT_EQ(RunIn({"accept", "bridge"}).code, 0);
    Blacken("r/frames/bridge/2s.png");
    for (const char* const depth : {"state", "trace", "drawlist"})
    {
        fs::remove_all(folder / "r" / depth / "bridge/5s.txt");
        fs::remove_all(folder / "r" / depth / "bridge/5s.txt.gz");
    }
    fs::remove(folder / "r/frames/bridge/5s.png");
    fs::remove(folder / "r/state/bridge/2s.txt");
    const Outcome missing = RunIn({"accept", "bridge", "--only", "missing"});
    EXPECT_THAT(missing.output, AllOf(StartsWith("accepted  bridge/5s: "),
                                      HasSubstr("1 moment accepted"), Not(HasSubstr("bridge/2s"))));
    const Outcome changed = RunIn({"accept", "bridge", "--only", "changed"});
    EXPECT_THAT(changed.output,
                AllOf(StartsWith("accepted  bridge/2s: "), HasSubstr("1 moment accepted")));
    EXPECT_THAT(RunIn({"accept", "bridge", "--only", "changed"}).output,
                StartsWith("0 moments accepted"));
    EXPECT_FALSE(fs::exists(folder / "o")) << "accepting leaves nothing to look at";
    EXPECT_EQ(RunIn({"verify", "bridge"}).code, 0);
    ExpectRefusal({"accept", "--only", "mising"}, "--only mising");
}

TEST_F(GoldenCommand, AcceptsPictureForOneRenderer)
{
    ASSERT_EQ(RunIn({"accept", "bridge/2s"}).code, 0);
    EXPECT_THAT(RunIn({"accept", "bridge/2s", "--for-this-renderer", "--only", "missing"}).output,
                AllOf(HasSubstr("accepted  bridge/2s: "), Not(HasSubstr("as they were"))));
    EXPECT_THAT(RunIn({"accept", "bridge/2s", "--for-this-renderer"}).output,
                HasSubstr("1 of them as they were"));
    std::vector<std::string> pictures;
    for (const auto& entry : fs::directory_iterator(folder / "r/frames/bridge"))
    {
        pictures.push_back(entry.path().filename().string());
    }
    EXPECT_THAT(pictures, testing::UnorderedElementsAre(
                              "2s.png", AllOf(StartsWith("2s@"), EndsWith(".png"))));
    const auto renderer = Renderer::Create({}); // the program's: both ask BOXREEL_BACKEND
    ASSERT_TRUE(renderer) << renderer.GetError().Text();
    EXPECT_TRUE(ReferenceStore(folder / "r", folder / "o")
                    .HasOwnPicture("bridge/2s", renderer->Description()));
    Blacken("r/frames/bridge/2s.png");
    EXPECT_EQ(RunIn({"verify", "bridge/2s"}).code, 0) << "compared with its own";
    const std::string own =
        folder / "r/frames/bridge" / *std::max_element(pictures.begin(), pictures.end());
    Blacken(fs::relative(own, folder.Path()));
    EXPECT_EQ(RunIn({"verify", "bridge/2s"}).code, 2);
    EXPECT_EQ(RunIn({"accept", "bridge/2s"}).code, 0);
    EXPECT_EQ(RunIn({"verify", "bridge/2s"}).code, 0) << "its own was accepted";
}

TEST_F(GoldenCommand, ReportsDamagedReferenceAndAcceptsItAgain)
{
    ASSERT_EQ(RunIn({"accept", "bridge"}).code, 0);
    std::ofstream(folder / "r/state/bridge/0.5s.txt") << "<<<<<<< HEAD\n";
    const Outcome damaged = RunIn({"verify", "bridge", "--report", "page.html"});
    EXPECT_EQ(damaged.code, 2) << damaged.errors;
    EXPECT_THAT(damaged.output,
                AllOf(HasSubstr("FAIL  bridge/0.5s: "), HasSubstr("r/state/bridge/0.5s.txt"),
                      HasSubstr("run `boxreel golden accept bridge/0.5s --references 'r'`"),
                      HasSubstr("same  bridge/5s"), HasSubstr("3 moments: 1 not as approved")));
    EXPECT_TRUE(fs::exists(folder / "page.html"));
    const Outcome accepted = RunIn({"accept", "bridge", "--only", "changed"});
    EXPECT_THAT(accepted.output, StartsWith("accepted  bridge/0.5s: "));
    EXPECT_EQ(RunIn({"verify", "bridge"}).code, 0);
}

TEST_F(GoldenCommand, CountsRepeatedMomentsOnce)
{
    const std::string first = RunIn({"accept", "bridge/2s", "bridge", "bridge"}).output;
    EXPECT_THAT(first, HasSubstr("3 moments accepted in 'r'\n"));
    EXPECT_THAT(RunIn({"accept", "bridge", "bridge/2s"}).output,
                HasSubstr("3 moments accepted in 'r', 3 of them as they were"));
}

TEST_F(GoldenCommand, WarnsWhenVerdictCannotBeWritten)
{
    ASSERT_EQ(RunIn({"accept", "bridge"}).code, 0);
    std::ofstream(folder / "o") << "a file where the folder should be";
    const Outcome outcome = RunIn({"verify", "bridge"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.errors, AllOf(StartsWith("boxreel: "), HasSubstr(": o/bridge: ")));
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
}

TEST_F(GoldenCommand, WritesReportsToPlainFilesOnly)
{
    ExpectRefusal({"verify", "bridge", "--references", ".", "--report", "/dev/full"}, "/dev/full");
    ASSERT_EQ(RunTool({"mkfifo", "pipe.html"}, folder.Path()).code, 0);
    ExpectRefusal({"verify", "bridge", "--references", ".", "--report", "pipe.html"}, "pipe.html");
}

TEST_F(GoldenCommand, ReportsFirstDifferingStep)
{
    ASSERT_EQ(RunIn({"accept", "bridge/0.5s"}).code, 0);
    // As if step 12 had been approved with another state of body 17, and the moment with it lower.
    const fs::path trace = folder / "r/trace/bridge/0.5s.txt";
    const fs::path state = folder / "r/state/bridge/0.5s.txt";
    const Outcome planted =
        RunTool({"sh", "-c",
                 "sed -E -i '12s/^12 ......../12 00000000/; 12s/^(12 00000000 .{17})./\\1./' '" +
                     trace.string() +
                     "'; awk 'NR == 1 {print \"0123456789abcdef\"; next} $1 == 17 {$3 += 0.5} "
                     "{print}' '" +
                     state.string() + "' > s; mv s '" + state.string() + "'"},
                folder.Path());
    ASSERT_EQ(planted.code, 0) << planted.errors;
    const Outcome outcome = RunIn({"verify", "bridge/0.5s"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, AllOf(StartsWith("FAIL  bridge/0.5s: "), HasSubstr("step 12"),
                                      HasSubstr("body 17"), HasSubstr("0.5 m")))
        << outcome.errors;
}

TEST_F(GoldenCommand, IgnoresBodies)
{
    ASSERT_EQ(RunIn({"accept", "bridge/0.5s"}).code, 0);
    const fs::path state = folder / "r/state/bridge/0.5s.txt";
    const Outcome planted =
        RunTool({"sh", "-c",
                 "awk '$1 == 17 {$3 += 0.5} NR == 1 {$1 = \"0123456789abcdef\"} {print}' '" +
                     state.string() + "' > s; mv s '" + state.string() + "'"},
                folder.Path());
    ASSERT_EQ(planted.code, 0) << planted.errors;
    EXPECT_EQ(RunIn({"verify", "bridge/0.5s", "--ignore-body", "16"}).code, 2);
    EXPECT_EQ(RunIn({"verify", "bridge/0.5s", "--ignore-body", "3,17"}).code, 0);
    ExpectRefusal({"verify", "bridge", "--ignore-body", "wheel"}, "--ignore-body wheel");
    ExpectRefusal({"verify", "menu", "--film", "menu.mp4", "--ignore-body", "3"}, "--ignore-body");
    ExpectRefusal({"report", "-o", ""}, "-o");
    ASSERT_EQ(RunIn({"accept", "pyramid/0.5s"}).code, 0);
    const Outcome beyond =
        RunIn({"verify", "bridge/0.5s", "pyramid/0.5s", "--ignore-body", "3,17,99"});
    EXPECT_EQ(beyond.code, 2);
    EXPECT_THAT(beyond.output, AllOf(HasSubstr("FAIL  bridge/0.5s: bodies 3, 17, 99: "),
                                     HasSubstr("same  pyramid/0.5s")));
}

TEST_F(GoldenCommand, ComparesFilmsByTheirContactSheets)
{
    const auto record = [&](const char* film, const char* seed, const char* fps) {
        EXPECT_EQ(RunBoxreel({"record", "tumbler", "-o", film, "--seconds", "2", "--size", "160x90",
                              "--quality", "lossless", "--seed", seed, "--fps", fps},
                             folder.Path())
                      .code,
                  0);
    };
    record("a.mkv", "1", "60");
    const Outcome missing =
        Run({"verify", "--film", "a.mkv", "--references", ".", "--output", "o"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.output,
                HasSubstr("run `boxreel golden accept films/a --film FILE --references '.'`"));
    ASSERT_EQ(RunIn({"accept", "--film", "a.mkv"}).code, 0);
    EXPECT_EQ(RunIn({"verify", "--film", "a.mkv"}).code, 0);
    record("b.mkv", "1", "30");
    EXPECT_EQ(RunIn({"verify", "films/a", "--film", "b.mkv"}).code, 0)
        << "other frames, the same steps";
    const Outcome others = RunIn({"verify", "films/a", "--film", "b.mkv", "--every", "15"});
    EXPECT_EQ(others.code, 2);
    EXPECT_THAT(others.output,
                AllOf(StartsWith("FAIL  films/a: "), HasSubstr("15"), HasSubstr("30")));
    EXPECT_THAT(RunIn({"verify", "b", "--film", "b.mkv", "--every", "15", "--hz", "120"}).output,
                HasSubstr("accept b --film FILE --every 15 --hz 120 --references "));
    ASSERT_EQ(RunBoxreel({"record", "tumbler", "-o", "c.mkv", "--seconds", "2", "--size", "160x90",
                          "--quality", "lossless", "--hz", "120", "--speed", "2"},
                         folder.Path())
                  .code,
              0);
    const Outcome faster = RunIn({"verify", "films/a", "--film", "c.mkv"});
    EXPECT_EQ(faster.code, 2);
    EXPECT_THAT(faster.output, AllOf(StartsWith("FAIL  films/a: "), HasSubstr("step 30")));
    ExpectRefusal({"verify", "a", "b", "--film", "a.mkv"}, "'b'");
    ExpectRefusal({"verify", "--every", "3"}, "--every");
    ExpectRefusal({"verify", "--film", "a.mkv", "--against", "x"}, "--against");
}

TEST_F(GoldenCommand, PrintsStateAndTrace)
{
    const Outcome state = Run({"state", "bridge", "--step", "60"});
    EXPECT_EQ(state.code, 0) << state.errors;
    EXPECT_THAT(state.output, testing::MatchesRegex("[0-9a-f]{16}\n0 [^\n]*\n(.|\n)*38 [^\n]*\n"));
    EXPECT_EQ(state.output, Run({"state", "bridge", "--step", "60"}).output);
    const Outcome trace = Run({"state", "bridge", "--trace", "--step", "3"});
    EXPECT_THAT(trace.output,
                testing::MatchesRegex("1 [0-9a-f]{8} [0-9a-f]{39}\n2 [0-9a-f]{8} [0-9a-f]{39}\n3 "
                                      "[0-9a-f]{8} [0-9a-f]{39}\n"));
    ExpectRefusal({"state"}, "golden state");
    ExpectRefusal({"state", "--setp", "3"}, "--setp");
    ExpectRefusal({"state", "bride"}, "'bride'");
    ExpectRefusal({"state", "bridge", "--step", "-1"}, "--step -1");
}

TEST_F(GoldenCommand, FindsFirstDifferenceFromAnotherBuild)
{
    const Outcome same = Run({"verify", "bridge", "car", "--against", BOXREEL_PROGRAM});
    EXPECT_EQ(same.code, 0) << same.errors;
    EXPECT_THAT(same.output, StartsWith("same  bridge\nsame  car\n2 scenes: each step as "));
    const fs::path other = OtherProgram();
    const Outcome differs = Run({"verify", "bridge", "--against", other.string()});
    EXPECT_EQ(differs.code, 2) << differs.errors;
    EXPECT_THAT(differs.output,
                AllOf(HasSubstr("step 43"), HasSubstr("body 17"), HasSubstr("0.03 m")));
    EXPECT_THAT(Run({"verify", "bridge", "--against", "other"}).output, HasSubstr("step 43"))
        << "the file here, not one of this name along PATH";
    EXPECT_EQ(Run({"verify", "bridge/0.5s", "--against", other.string()}).code, 0)
        << "until half a second it is the same";
    ExpectRefusal({"verify", "bridge", "--against", "nothing"}, "--against nothing");
    ExpectRefusal({"verify", "bridge", "--against", "."}, "--against .");
    ExpectRefusal({"verify", "bridge", "--against", "/bin/true"}, "--against /bin/true");
    ExpectRefusal({"verify", "bridge", "--against", "/bin/false"}, "--against /bin/false");
}

TEST_F(GoldenCommand, RefusesComparisonOptionsWithAgainst)
{
    for (const char* option :
         {"--ignore-body=5", "--preset=exact", "--max-pixels=9", "--ignore=0,0,9x9"})
    {
        ExpectRefusal({"verify", "bridge", "--against", BOXREEL_PROGRAM, option}, "--against");
    }
}

TEST_F(GoldenCommand, ReportsOtherStepsOfAnotherBuild)
{
    const fs::path other = folder / "shifted";
    std::ofstream(other) << "#!/bin/sh\n\"" BOXREEL_PROGRAM
                            "\" \"$@\" | sed -E 's/^([0-9]+) /1000\\1 /'\n";
    fs::permissions(other, fs::perms::owner_all);
    const Outcome outcome = Run({"verify", "bridge/0.5s", "--against", other.string()});
    EXPECT_EQ(outcome.code, 2) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("from step 1 on"));
}

TEST_F(GoldenCommand, EndsAnotherProgramWithEndlessOutput)
{
    const fs::path other = folder / "flood";
    std::ofstream(other) << "#!/bin/sh\nexec yes 0123456789\n";
    fs::permissions(other, fs::perms::owner_all);
    const Outcome outcome = Run({"verify", "bridge", "--against", other.string()});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.errors, HasSubstr("--against "));
    if (!BOXREEL_IS_SANITIZED)
    {
        EXPECT_LT(outcome.peakKilobytes, 600'000) << "a few times what it may write";
    }
}

TEST_F(GoldenCommand, ReportsReferencesOfAnotherRenderer)
{
    ASSERT_EQ(RunIn({"accept", "bridge/2s"}).code, 0);
    const Outcome same = RunIn({"verify", "bridge/2s"});
    EXPECT_THAT(same.output, Not(HasSubstr("another renderer")));

    const fs::path picture = folder / "r/frames/bridge/2s.png";
    const std::string keyword = "Renderer fingerprint";
    EXPECT_EQ(ReadPngText(picture, keyword)->size(), 16u);
    const auto bytes = EncodePng(*ReadPng(picture), 3, {{keyword, "0123456789abcdef"}});
    std::ofstream(picture, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes->data()), std::streamsize(bytes->size()));
    const Outcome other = RunIn({"verify", "bridge/2s"});
    EXPECT_EQ(other.code, 0) << other.output;
    EXPECT_THAT(other.output,
                HasSubstr("\n1 reference drawn by another renderer: cross-machine allows"));
    const Outcome given = RunIn({"verify", "bridge/2s", "--preset", "same-machine"});
    EXPECT_THAT(given.output, Not(HasSubstr("another renderer")));
}

TEST_F(GoldenCommand, PrintsLimitsWhenNothingDiffers)
{
    ASSERT_EQ(RunIn({"accept", "bridge/2s"}).code, 0);
    EXPECT_THAT(
        RunIn({"verify", "bridge/2s"}).output,
        HasSubstr("1 moment: all as approved (same-machine allows 4 pixels over a distance"));
    EXPECT_THAT(RunIn({"verify", "bridge/2s", "--max-pixels", "9"}).output,
                HasSubstr("(same-machine, with --max-pixels, allows 9 pixels"));
}

} // namespace
} // namespace boxreel
