// SPDX-License-Identifier: MIT
#include <golden/GoldenCheck.h>

#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "Environment.h"
#include "TestPictures.h"

#include <gmock/gmock.h>

using namespace boxreel;
using namespace boxreel::test;
using testing::HasSubstr;

namespace
{

namespace fs = std::filesystem;

struct GoldenCheck : testing::Test
{
    GoldenCheck()
    {
        settings.references = folder / "approved";
        settings.output = folder / "output";
    }
    GoldenOutcome Check(const GoldenCandidate& shown)
    {
        return CheckGolden(shown, {}, settings, accepted);
    }
    void Approve(const GoldenCandidate& shown)
    {
        ASSERT_TRUE(ReferenceStore(settings.references, settings.output).Accept(shown));
    }

    TemporaryFolder folder;
    GoldenCheckSettings settings;
    std::set<std::string> accepted;
    GoldenCandidate candidate = Candidate("start");
    GoldenCandidate changed = Candidate("start", WithoutItem(SmallScene(), 2));
};

TEST_F(GoldenCheck, PassesWhenNothingHasChanged)
{
    Approve(candidate);
    const GoldenOutcome outcome = Check(candidate);
    EXPECT_TRUE(outcome.passed) << outcome.message;
    EXPECT_EQ(outcome.output, "");
}

TEST_F(GoldenCheck, NamesVariableThatAcceptsMissingReference)
{
    const GoldenOutcome outcome = Check(candidate);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.message, testing::StartsWith("start: "));
    EXPECT_THAT(outcome.message, HasSubstr("BOXREEL_GOLDEN_ACCEPT=missing"));
    EXPECT_THAT(outcome.message, testing::Not(HasSubstr("boxreel golden accept")))
        << "the program knows nothing of this test";
    EXPECT_FALSE(fs::exists(settings.references)) << "nothing is approved by itself";
}

TEST_F(GoldenCheck, NamesVariableThatAcceptsChangedReference)
{
    Approve(candidate);
    const GoldenOutcome outcome = Check(changed);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.message, testing::StartsWith("start: "));
    EXPECT_THAT(outcome.message, HasSubstr("BOXREEL_GOLDEN_ACCEPT=changed"));
    EXPECT_TRUE(fs::exists(settings.output / "start.side-by-side.png"));
}

TEST_F(GoldenCheck, AcceptsWhatIsMissingOnly)
{
    settings.accept = GoldenAccept::Missing;
    const GoldenOutcome first = Check(candidate);
    EXPECT_TRUE(first.passed) << first.message;
    EXPECT_EQ(first.output, "accepted  start: there was no reference.\n");
    accepted.clear(); // another run
    EXPECT_FALSE(Check(changed).passed) << "a reference that is there is not replaced";
    EXPECT_TRUE(Check(candidate).passed);
}

TEST_F(GoldenCheck, AcceptsWhatHasChangedOnly)
{
    settings.accept = GoldenAccept::Changed;
    EXPECT_FALSE(Check(candidate).passed) << "a reference that is not there is not made";
    Approve(candidate);
    const GoldenOutcome outcome = Check(changed);
    EXPECT_TRUE(outcome.passed) << outcome.message;
    EXPECT_THAT(outcome.output, testing::StartsWith("accepted  start: same world"));
    settings.accept = GoldenAccept::None;
    EXPECT_TRUE(Check(changed).passed);
    EXPECT_FALSE(Check(candidate).passed);
}

TEST_F(GoldenCheck, AcceptsBothWhenAllAreWanted)
{
    settings.accept = GoldenAccept::All;
    EXPECT_TRUE(Check(candidate).passed);
    accepted.clear(); // another run
    EXPECT_TRUE(Check(changed).passed);
    EXPECT_TRUE(Check(changed).passed) << "what has been accepted is the reference now";
}

TEST_F(GoldenCheck, AcceptsPixelsAloneForTheRendererThatDrewThem)
{
    Approve(candidate);
    GoldenCandidate repainted = Candidate("start", SmallScene(), {.outline = 2});
    repainted.renderer = changed.renderer = "Some GL";
    settings.accept = GoldenAccept::ThisRenderer;
    EXPECT_FALSE(Check(changed).passed) << "other geometry is no matter of a renderer";
    const GoldenOutcome outcome = Check(repainted);
    EXPECT_TRUE(outcome.passed) << outcome.message;
    EXPECT_TRUE(fs::exists(settings.references / "frames" / "start@some-gl.png"));
    settings.accept = GoldenAccept::None;
    EXPECT_TRUE(Check(candidate).passed);
    EXPECT_TRUE(Check(repainted).passed);
}

TEST_F(GoldenCheck, AcceptsADamagedReferenceAgain)
{
    Approve(candidate);
    std::ofstream(settings.references / "frames" / "start.png") << "damaged";
    const GoldenOutcome damaged = Check(candidate);
    EXPECT_FALSE(damaged.passed);
    EXPECT_THAT(damaged.message, HasSubstr("BOXREEL_GOLDEN_ACCEPT=changed"));
    settings.accept = GoldenAccept::Changed;
    EXPECT_TRUE(Check(candidate).passed);
    settings.accept = GoldenAccept::None;
    EXPECT_TRUE(Check(candidate).passed);
}

TEST_F(GoldenCheck, AcceptsNothingForUnknownIgnoredBodies)
{
    Approve(candidate);
    CompareSettings settingsOfBodies;
    settingsOfBodies.ignoredBodies = {3};
    settings.accept = GoldenAccept::All;
    const GoldenOutcome outcome = CheckGolden(candidate, settingsOfBodies, settings, accepted);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.message, testing::HasSubstr("body 3: "));
}

TEST_F(GoldenCheck, DoesNotRewriteEqualReference)
{
    Approve(candidate);
    const fs::path picture = settings.references / "frames" / "start.png";
    fs::permissions(picture, fs::perms::owner_read);
    const auto before = fs::last_write_time(picture);
    settings.accept = GoldenAccept::All;
    EXPECT_EQ(Check(candidate).output, "");
    EXPECT_EQ(fs::last_write_time(picture), before);
    EXPECT_EQ(fs::status(picture).permissions(), fs::perms::owner_read) << "not even replaced";
}

TEST_F(GoldenCheck, RefusesSecondCandidateOfSameName)
{
    settings.accept = GoldenAccept::All;
    EXPECT_TRUE(Check(candidate).passed);
    const GoldenOutcome second = Check(changed);
    EXPECT_FALSE(second.passed);
    EXPECT_THAT(second.message, HasSubstr(candidate.name));
    EXPECT_TRUE(Check(candidate).passed) << "the first one is the reference";
}

TEST_F(GoldenCheck, AttachesThePicturesOfAFailureForCTest)
{
    Approve(candidate);
    EXPECT_EQ(Check(changed).output, "") << "not asked for";
    settings.attach = true;
    const std::string base = (settings.output / "start").string();
    const auto line = [&](const std::string& name, const std::string& suffix) {
        return "<CTestMeasurementFile type=\"image/png\" name=\"" + name + "\">" + base + suffix +
               "</CTestMeasurementFile>\n";
    };
    EXPECT_EQ(Check(changed).output, line("TestImage", ".actual.png") +
                                         line("ValidImage", ".expected.png") +
                                         line("DifferenceImage2", ".difference.png") +
                                         line("SideBySide", ".side-by-side.png"));
    EXPECT_EQ(Check(candidate).output, "") << "it has passed";
}

TEST_F(GoldenCheck, NamesPicturesInAnyFolderInXml)
{
    settings.attach = true;
    settings.output /= "a&b<c";
    EXPECT_THAT(Check(candidate).output, HasSubstr("/a&amp;b&lt;c/start.actual.png</CTest"));
}

TEST_F(GoldenCheck, AttachesActualPictureWithoutReference)
{
    settings.attach = true;
    EXPECT_EQ(Check(candidate).output,
              "<CTestMeasurementFile type=\"image/png\" name=\"TestImage\">" +
                  (settings.output / "start.actual.png").string() + "</CTestMeasurementFile>\n");
}

TEST_F(GoldenCheck, FailsForUnusableName)
{
    settings.accept = GoldenAccept::All;
    candidate.name = "../start";
    const GoldenOutcome outcome = Check(candidate);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.message, HasSubstr("'../start'"));
}

TEST(GoldenSettings, AreTheCompiledOnesInEmptyEnvironment)
{
    const GoldenEnvironment environment;
    const auto settings = GoldenSettingsFromEnvironment("compiled");
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->references, "compiled");
    EXPECT_EQ(settings->output, "golden-output");
    EXPECT_EQ(settings->accept, GoldenAccept::None);
    EXPECT_FALSE(settings->attach);
}

TEST(GoldenSettings, AreOverriddenByTheEnvironment)
{
    GoldenEnvironment environment;
    environment.references.Set("elsewhere");
    environment.output.Set("failures");
    environment.accept.Set("changed");
    const auto settings = GoldenSettingsFromEnvironment("compiled");
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->references, "elsewhere");
    EXPECT_EQ(settings->output, "failures");
    EXPECT_EQ(settings->accept, GoldenAccept::Changed);
    environment.accept.Set("missing");
    EXPECT_EQ(GoldenSettingsFromEnvironment("compiled")->accept, GoldenAccept::Missing);
    environment.accept.Set("all");
    EXPECT_EQ(GoldenSettingsFromEnvironment("compiled")->accept, GoldenAccept::All);
    environment.accept.Set("this-renderer");
    EXPECT_EQ(GoldenSettingsFromEnvironment("compiled")->accept, GoldenAccept::ThisRenderer);
}

TEST(GoldenSettings, RefuseUnknownWordToAccept)
{
    GoldenEnvironment environment;
    environment.accept.Set("yes");
    EXPECT_THAT(GoldenSettingsFromEnvironment("compiled"),
                RefusesWith("BOXREEL_GOLDEN_ACCEPT yes", "missing, changed, all, this-renderer"));
}

TEST(GoldenSettings, RequireAFolderOfReferences)
{
    const GoldenEnvironment environment;
    EXPECT_THAT(GoldenSettingsFromEnvironment(""), Refuses("BOXREEL_GOLDEN_REFERENCES"));
}

TEST(GoldenSettings, GiveEachShardItsOwnFolder)
{
    GoldenEnvironment environment;
    environment.shards.Set("2");
    environment.shard.Set("0");
    EXPECT_EQ(GoldenSettingsFromEnvironment("r")->output, "golden-output/shard-0-of-2");
    environment.shard.Set("1");
    EXPECT_EQ(GoldenSettingsFromEnvironment("r")->output, "golden-output/shard-1-of-2");
    environment.shard.Set("../../elsewhere");
    EXPECT_THAT(GoldenSettingsFromEnvironment("r"),
                Refuses("GTEST_SHARD_INDEX ../../elsewhere, GTEST_TOTAL_SHARDS 2"));
    environment.shards.Set("1");
    EXPECT_EQ(GoldenSettingsFromEnvironment("r")->output, "golden-output");
}

TEST(GoldenSettings, AttachPicturesUnderCTestAndInCi)
{
    GoldenEnvironment environment;
    environment.ctest.Set("3.25.1");
    EXPECT_TRUE(GoldenSettingsFromEnvironment("r")->attach);
    environment.ctest.Set(nullptr);
    environment.debug.Set("1");
    EXPECT_TRUE(GoldenSettingsFromEnvironment("r")->attach);
    environment.debug.Set(nullptr);
    EXPECT_FALSE(GoldenSettingsFromEnvironment("r")->attach);
    environment.ci.Set("true");
    EXPECT_TRUE(GoldenSettingsFromEnvironment("r")->attach);
}

} // namespace
