// SPDX-License-Identifier: MIT
// `boxreel golden report`: the real program, as a shell runs it.
#include "Refusals.h"

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
using testing::HasSubstr;
using testing::Not;

class GoldenReport : public testing::Test
{
protected:
    Outcome Run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "golden");
        return RunBoxreel(arguments, folder.Path());
    }

    /// Plants a difference in a step of the reference, and in the moment's state, draw list and
    /// picture.
    void PlantADifference() const
    {
        ASSERT_EQ(Run({"accept", "bridge/0.5s", "--references", "r"}).code, 0);
        const Outcome planted =
            RunTool({"sh", "-c",
                     "sed -E -i '12s/^12 ......../12 00000000/; 12s/^(12 00000000 .{17})./\\1./' "
                     "r/trace/bridge/0.5s.txt; sed -i '1s/.*/0123456789abcdef/; 19s/ / 0/' "
                     "r/state/bridge/0.5s.txt"},
                    folder.Path());
        ASSERT_EQ(planted.code, 0) << planted.errors;
    }
    Outcome Verify(const std::string& output, std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(),
                    {"verify", "bridge/0.5s", "--references", "r", "--output", output});
        return Run(more);
    }

    void ExpectRefusal(const std::vector<std::string>& arguments, const std::string& culprit) const
    {
        ExpectRefused(Run(arguments), culprit);
    }

    TemporaryFolder folder;
};

TEST_F(GoldenReport, ShowsFailuresWithFilmStrips)
{
    PlantADifference();
    const Outcome verified = Verify("o");
    ASSERT_EQ(verified.code, 2);
    EXPECT_THAT(verified.output,
                HasSubstr("see 'o'; `boxreel golden report 'o'` makes a page of them"));
    const Outcome outcome = Run({"report", "o"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                testing::MatchesRegex("1 moment: 1 not as approved; the report is 'o/report.html' "
                                      "\\([0-9.]+ [kM]B\\)\n"));
    const std::string page = ReadBytes(folder / "o/report.html");
    EXPECT_THAT(page,
                AllOf(HasSubstr("id=\"bridge/0.5s\""), HasSubstr("\"firstStep\":12"),
                      HasSubstr("\"step\":10,\"actual\":\"data:image/png"),
                      Not(HasSubstr("\"expected\":\"data:")), Not(HasSubstr("\"actualPage\":"))));
    EXPECT_EQ(Run({"report", "o"}).code, 0) << "a report is replaced by a report";
    EXPECT_EQ(ReadBytes(folder / "o/report.html"), page) << "the same folder makes the same page";

    const Outcome both = Run({"report", "o", "--against", BOXREEL_PROGRAM, "-o", "both.html"});
    EXPECT_EQ(both.code, 0) << both.errors;
    const std::string pair = ReadBytes(folder / "both.html");
    EXPECT_THAT(pair, HasSubstr("\"expected\":\"data:image/png"));
    EXPECT_THAT(pair, AllOf(HasSubstr("\"actualPage\":"), HasSubstr("\"expectedPage\":")));
    // The same program draws the same, of all and close to the body.
    for (const char* const names : {"expected actual", "expectedCloseUp closeUp"})
    {
        const Outcome cut = RunTool(
            {"sh", "-c",
             std::string("for name in ") + names +
                 "; do sed -n "
                 "'s/.*\"step\":11,[^}]*\"'$name'\":\"data:image.png;base64,\\([^\"]*\\).*/\\1/p' "
                 "both.html | base64 -d > $name.png; set -- $@ $name.png; done; '" BOXREEL_PROGRAM
                 "' diff --preset exact $@"},
            folder.Path());
        EXPECT_EQ(cut.code, 0) << names << cut.output << cut.errors;
    }
}

TEST_F(GoldenReport, ShowsPicturesOfProgramWithoutPages)
{
    PlantADifference();
    ASSERT_EQ(Verify("o").code, 2);
    std::ofstream(folder / "older")
        << "#!/bin/sh\n[ \"$1\" != record ] || exit 1\nexec '" << BOXREEL_PROGRAM << "' \"$@\"\n";
    fs::permissions(folder / "older", fs::perms::owner_all);
    const Outcome outcome = Run({"report", "o", "--against", "./older"});
    EXPECT_EQ(outcome.code, 1) << "the pages that were asked for are not there";
    EXPECT_THAT(outcome.errors, HasSubstr("--against ./older"));
    EXPECT_THAT(outcome.output, HasSubstr("o/report.html"));
    EXPECT_THAT(ReadBytes(folder / "o/report.html"),
                AllOf(HasSubstr("\"expected\":\"data:image/png"), Not(HasSubstr("Page\":"))));
}

TEST_F(GoldenReport, HasOnlyMomentsOfVerify)
{
    PlantADifference();
    ASSERT_EQ(Run({"verify", "car/2s", "--references", "r", "--output", "o"}).code, 2);
    const Outcome outcome = Verify("o", {"--report", "page.html"});
    EXPECT_EQ(outcome.code, 2) << "as without a report";
    EXPECT_THAT(outcome.output, HasSubstr("1 not as approved; the report is 'page.html'"));
    EXPECT_THAT(ReadBytes(folder / "page.html"),
                AllOf(HasSubstr("bridge/0.5s"), Not(HasSubstr("car/2s"))));
    ExpectRefusal({"verify", "bridge", "--report", "x.html", "--against", "y"}, "--report");
    ExpectRefusal({"verify", "bridge", "--references", "r", "--report", "none/x.html"},
                  "none/x.html");
}

TEST_F(GoldenReport, MergesShards)
{
    PlantADifference();
    ASSERT_EQ(Verify("shard-0").code, 2);
    ASSERT_EQ(Run({"accept", "bridge/0.5s", "car/2s", "--references", "r"}).code, 0);
    ASSERT_EQ(Verify("shard-1").code, 0);
    ASSERT_EQ(Run({"verify", "car/2s", "--references", "r", "--output", "shard-1"}).code, 0);
    const Outcome outcome = Run({"report", "shard-1", "shard-0", "-o", "all.html"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("2 moments: 1 not as approved"));
    EXPECT_THAT(ReadBytes(folder / "all.html"),
                HasSubstr("This is of shard-0; shard-1 says <b>as approved</b>"));
}

TEST_F(GoldenReport, ReportsThatAllMatch)
{
    ASSERT_EQ(Run({"accept", "bridge/0.5s", "--references", "r"}).code, 0);
    ASSERT_EQ(Verify("o").code, 0);
    EXPECT_THAT(Run({"report", "o"}).output, HasSubstr("1 moment: all as approved; the report is"));
}

TEST_F(GoldenReport, WritesReportAtomically)
{
    ExpectRefusal({"report", "none"}, "none");
    ExpectRefusal({"report"}, "golden-output");
    fs::create_directories(folder / "o");
    ExpectRefusal({"report", "o"}, "o");
    std::ofstream(folder / "o/a.verdict.json")
        << R"({"verdict": 2, "name": "a", "status": "same", "findings": []})";
    std::ofstream(folder / "mine.html") << "mine";
    ExpectRefusal({"report", "o", "-o", "mine.html"}, "mine.html");
    ExpectRefusal({"report", "o", "-o", "o"}, "o");
    ExpectRefusal({"report", "o", "-o", "none/a.html"}, "none/a.html");
    EXPECT_EQ(ReadBytes(folder / "mine.html"), "mine");
    EXPECT_EQ(Run({"report", "o", "-o", "mine.html", "--force"}).code, 0);
    EXPECT_EQ(folder.Names().size(), 2u) << "nothing unfinished is left";
}

TEST_F(GoldenReport, ReportsUnreadableVerdict)
{
    fs::create_directories(folder / "o/c");
    std::ofstream(folder / "o/a.verdict.json")
        << R"({"verdict": 2, "name": "a", "status": "same", "findings": []})";
    std::ofstream(folder / "o/c/b.verdict.json") << "damaged";
    const Outcome outcome = Run({"report", "o"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.output, HasSubstr("2 moments: 1 not as approved"));
    EXPECT_THAT(ReadBytes(folder / "o/report.html"),
                AllOf(HasSubstr("id=\"c/b\""), HasSubstr("o/c/b.verdict.json")));
}

} // namespace
} // namespace boxreel
