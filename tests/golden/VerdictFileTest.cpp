// SPDX-License-Identifier: MIT
// The files that a reference store writes for `boxreel golden report` (tests/golden/report).
#include "../base/TemporaryFolder.h"
#include "TestPictures.h"

#include <debugdraw/Camera.h>
#include <gmock/gmock.h>
#include <golden/GoldenCheck.h>
#include <golden/ReferenceStore.h>
#include <golden/Verdicts.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

using namespace boxreel;
using namespace boxreel::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace
{

namespace fs = std::filesystem;

class VerdictFile : public testing::Test
{
protected:
    std::string Verified(const GoldenCandidate& shown, const CompareSettings& settings = {}) const
    {
        (void)store.Verify(shown, settings);
        const std::string text = ReadBytes(output / (shown.name + ".verdict.json"));
        // Without the line breaks in lists.
        return std::regex_replace(text, std::regex("([\\[,])\\n +|\\n +(?=\\])"), "$1");
    }

    TemporaryFolder folder;
    fs::path references = folder / "references";
    fs::path output = folder / "output";
    ReferenceStore store{references, output};
    GoldenCandidate candidate = Candidate("pyramid/3s");
};

TEST_F(VerdictFile, StoresStatusAndLimitsOfPass)
{
    ASSERT_TRUE(store.Accept(candidate));
    candidate.renderer = "some \"GL\"\n";
    candidate.camera = Camera{320, 180, 1.5, 2.0, 16.0};
    CompareSettings settings = CompareSettings::CrossMachine();
    settings.ignored = {{10, 20, 40, 60}};
    settings.maxInWindow = 9;
    const std::string json = Verified(candidate, settings);
    EXPECT_THAT(json,
                AllOf(HasSubstr("\"name\": \"pyramid/3s\""), HasSubstr("\"status\": \"same\""),
                      HasSubstr("\"preset\": \"cross-machine\""), HasSubstr("\"tolerance\": 0.01"),
                      HasSubstr("\"maxPixels\": null"), HasSubstr("\"maxInWindow\": 9"),
                      HasSubstr("\"limits\": " + JsonText(DescribeLimits(settings))),
                      HasSubstr("\"ignored\": [[10,20,30,40]]")));
    EXPECT_THAT(json, AllOf(HasSubstr("\"renderer\": \"some \\\"GL\\\"\\n\""),
                            HasSubstr("\"view\": [320,180,1.5,2.0,16.0]"),
                            HasSubstr("\"overTolerance\": 0")));
}

TEST_F(VerdictFile, ReplacesVerdictOfEarlierComparison)
{
    ASSERT_TRUE(store.Accept(candidate));
    GoldenCandidate moved = candidate;
    moved.list.points[0].x += 0.125f;
    EXPECT_THAT(Verified(moved), HasSubstr("\"status\": \"drawlist\""));
    EXPECT_THAT(Verified(candidate), HasSubstr("\"status\": \"same\""));
    fs::remove_all(references);
    const std::string json = Verified(candidate);
    EXPECT_THAT(json,
                AllOf(HasSubstr("\"status\": \"missing\""),
                      HasSubstr("\"accept\": \"boxreel golden accept pyramid/3s --references '" +
                                references.string() + "'\"")));
}

TEST_F(VerdictFile, NamesStepAndBodiesThatDifferFirst)
{
    candidate.trace.steps = {{1, "11111111", "ab"}, {2, "22222222", "cd"}, {3, "33333333", "ef"}};
    ASSERT_TRUE(store.Accept(candidate));
    EXPECT_THAT(Verified(candidate), AllOf(HasSubstr("\"since\": 1"), HasSubstr("\"step\": 3"),
                                           Not(HasSubstr("firstStep"))));
    candidate.trace.steps[1] = {2, "2222222f", "cf"};
    EXPECT_THAT(Verified(candidate),
                AllOf(HasSubstr("\"status\": \"state\""), HasSubstr("\"firstStep\": 2"),
                      HasSubstr("\"firstBodies\": [1]"), HasSubstr("\"firstHash\": \"2222222f\"")));
}

TEST_F(VerdictFile, StoresErrorWhenReferenceIsDamaged)
{
    ASSERT_TRUE(store.Accept(candidate));
    ASSERT_THAT(Verified(candidate), HasSubstr("\"status\": \"same\""));
    std::ofstream(references / "frames/pyramid/3s.png") << "damaged";
    EXPECT_THAT(Verified(candidate), AllOf(HasSubstr("\"status\": \"error\""), HasSubstr("3s.png"),
                                           HasSubstr("\"accept\": \"boxreel golden accept pyra")))
        << "it does not pass any more";
}

TEST_F(VerdictFile, IsSkippedWhenOutputIsNotWritable)
{
    ASSERT_TRUE(store.Accept(candidate));
    std::ofstream(output) << "a file where the folder should be";
    const Result<GoldenVerdict> verdict = store.Verify(candidate);
    ASSERT_TRUE(verdict) << verdict.GetError().Text();
    EXPECT_EQ(verdict->status, GoldenStatus::Same);
}

TEST_F(VerdictFile, StoresThatFailureWasAccepted)
{
    std::set<std::string> accepted;
    ASSERT_TRUE(
        CheckGolden(candidate, {}, {references, output, GoldenAccept::Missing}, accepted).passed);
    EXPECT_THAT(ReadBytes(output / "pyramid/3s.verdict.json"),
                AllOf(HasSubstr("\"accepted\": true"), HasSubstr("\"status\": \"missing\"")));
    EXPECT_TRUE(fs::exists(output / "pyramid/3s.actual.png")) << "to be looked at";
    EXPECT_THAT(Verified(candidate), Not(HasSubstr("accepted"))) << "the next time it just passes";
}

} // namespace
