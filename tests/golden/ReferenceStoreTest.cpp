// SPDX-License-Identifier: MIT
#include <golden/ReferenceStore.h>

#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "TestPictures.h"

#include <debugdraw/DrawListText.h>
#include <render/Png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

using namespace boxreel;
using namespace boxreel::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::UnorderedElementsAre;

namespace
{

namespace fs = std::filesystem;

class ReferenceStoreTest : public testing::Test
{
protected:
    GoldenVerdict Verify(const GoldenCandidate& candidate, const CompareSettings& settings = {})
    {
        Result<GoldenVerdict> verdict = m_store.Verify(candidate, settings);
        EXPECT_TRUE(verdict) << (verdict ? "" : verdict.GetError().Text());
        return verdict ? *std::move(verdict) : GoldenVerdict{};
    }

    void Accept(const GoldenCandidate& candidate)
    {
        const Result<void> accepted = m_store.Accept(candidate);
        ASSERT_TRUE(accepted) << accepted.GetError().Text();
    }

    // Every file below a folder, by its path from there.
    static std::vector<std::string> Files(const fs::path& folder)
    {
        std::vector<std::string> files;
        std::error_code ignored;
        for (const auto& entry : fs::recursive_directory_iterator(folder, ignored))
        {
            if (!entry.is_directory())
            {
                files.push_back(entry.path().lexically_relative(folder).string());
            }
        }
        return files;
    }

    GoldenCandidate Moved() const
    {
        GoldenCandidate candidate = Candidate("pyramid/3s");
        candidate.list.points[0].x += 0.125f;
        return candidate;
    }

    TemporaryFolder m_folder;
    fs::path m_references = m_folder / "references";
    fs::path m_output = m_folder / "output";
    ReferenceStore m_store{m_references, m_output};
    const GoldenCandidate m_candidate = Candidate("pyramid/3s");
};

DrawList LongList()
{
    DrawList list;
    for (int i = 0; i < 3000; ++i)
    {
        list.AddSegment({0.1f * static_cast<float>(i), 0.3f}, {0.7f, 0.1f * static_cast<float>(i)},
                        kJoint);
    }
    return list;
}

} // namespace

TEST_F(ReferenceStoreTest, AcceptsAtThreeDepthsAndVerifiesTheSame)
{
    Accept(m_candidate);
    EXPECT_THAT(Files(m_references),
                UnorderedElementsAre("state/pyramid/3s.txt", "drawlist/pyramid/3s.txt",
                                     "frames/pyramid/3s.png"));
    EXPECT_EQ(ReadBytes(m_references / "state/pyramid/3s.txt"), "0123456789abcdef\n");
    EXPECT_EQ(ReadBytes(m_references / "drawlist/pyramid/3s.txt"), ToText(m_candidate.list));
    const GoldenVerdict verdict = Verify(m_candidate);
    EXPECT_EQ(verdict.status, GoldenStatus::Same);
    EXPECT_EQ(verdict.name, "pyramid/3s");
    EXPECT_EQ(verdict.pixels.limits.preset, "same-machine");
    EXPECT_THAT(Files(m_output), ElementsAre("pyramid/3s.verdict.json"));
}

TEST_F(ReferenceStoreTest, WritesCandidateAndAcceptCommandIfMissing)
{
    const GoldenVerdict verdict = Verify(m_candidate);
    EXPECT_EQ(verdict.status, GoldenStatus::Missing);
    EXPECT_EQ(verdict.absence, GoldenAbsence::All);
    EXPECT_EQ(verdict.references, m_references.string());
    EXPECT_THAT(verdict.missing, ElementsAre("state/pyramid/3s.txt", "drawlist/pyramid/3s.txt",
                                             "frames/pyramid/3s.png"));
    EXPECT_THAT(verdict.look, ElementsAre((m_output / "pyramid/3s.actual.png").string()));
    EXPECT_EQ(verdict.accept,
              "boxreel golden accept pyramid/3s --references '" + m_references.string() + "'");
    EXPECT_THAT(Files(m_output),
                UnorderedElementsAre("pyramid/3s.actual.png", "pyramid/3s.actual.txt",
                                     "pyramid/3s.verdict.json"));
    const Result<Frame> written = ReadPng(m_output / "pyramid/3s.actual.png");
    ASSERT_TRUE(written);
    EXPECT_EQ(*written, m_candidate.frame);
    EXPECT_FALSE(fs::exists(m_references)) << "nothing approves itself";
}

TEST_F(ReferenceStoreTest, FailsWhenOneDepthHasNoReference)
{
    for (const char* file :
         {"state/pyramid/3s.txt", "drawlist/pyramid/3s.txt", "frames/pyramid/3s.png"})
    {
        Accept(m_candidate);
        fs::remove(m_references / file);
        const GoldenVerdict verdict = Verify(m_candidate);
        EXPECT_EQ(verdict.status, GoldenStatus::Missing);
        EXPECT_EQ(verdict.absence, GoldenAbsence::Part);
        EXPECT_THAT(verdict.missing, ElementsAre(file));
    }
}

TEST_F(ReferenceStoreTest, ComparesOtherPartsWhenOneIsMissing)
{
    Accept(m_candidate);
    fs::remove(m_references / "drawlist/pyramid/3s.txt");
    const GoldenVerdict same = Verify(m_candidate);
    EXPECT_EQ(same.status, GoldenStatus::Missing);
    EXPECT_EQ(same.absence, GoldenAbsence::Part);
    EXPECT_TRUE(same.pixels.equal);
    GoldenCandidate other = Moved();
    other.stateHash = "fedcba9876543210";
    const GoldenVerdict differs = Verify(other);
    EXPECT_EQ(differs.status, GoldenStatus::State) << "nothing that is only missing";
    EXPECT_THAT(differs.missing, ElementsAre("drawlist/pyramid/3s.txt"));
    EXPECT_FALSE(differs.compared.list);
    EXPECT_TRUE(fs::exists(m_output / "pyramid/3s.expected.png"));
}

TEST_F(ReferenceStoreTest, FailsFilmAgainstReferenceOfScene)
{
    Accept(m_candidate);
    GoldenCandidate film;
    film.name = m_candidate.name;
    film.frame = Filled(64, 32, {9, 9, 9, 255});
    film.sheet = SheetLayout{1, 64, 32, 1, 30, 60.0};
    const GoldenVerdict verdict = Verify(film);
    EXPECT_EQ(verdict.status, GoldenStatus::DrawList) << "a film has none";
    EXPECT_THAT(verdict.missing, ElementsAre("sheet/pyramid/3s.txt"));
}

TEST_F(ReferenceStoreTest, ReportsStateFirstWhenTheRestIsEqual)
{
    Accept(m_candidate);
    GoldenCandidate changed = m_candidate;
    changed.stateHash = "0123456789abcdee";
    const GoldenVerdict verdict = Verify(changed);
    EXPECT_EQ(verdict.status, GoldenStatus::State);
    ASSERT_TRUE(verdict.world);
    EXPECT_EQ(verdict.world->actual, "0123456789abcdee");
    EXPECT_EQ(verdict.world->expected, "0123456789abcdef");
    EXPECT_TRUE(verdict.compared.list);
    EXPECT_FALSE(verdict.list);
    EXPECT_TRUE(verdict.pixels.equal);
}

TEST_F(ReferenceStoreTest, ReportsFirstDifferingStepBodyAndDistance)
{
    GoldenCandidate candidate = m_candidate;
    candidate.state = {{{0, 0, 0, 0, 0, 0, 0}, {1, 1, 1.051f, 0, 0, 0, 0}}};
    candidate.trace = {{{41, "00000000", "00"}, {42, "00000001", "01"}, {43, "00000002", "02"}}};
    Accept(candidate);
    EXPECT_EQ(Verify(candidate).status, GoldenStatus::Same);
    GoldenCandidate changed = candidate;
    changed.stateHash = "ffffffffffffffff";
    changed.state.bodies[1].y = 1.02f;
    changed.trace.steps[1] = {42, "00000009", "07"};
    const GoldenVerdict verdict = Verify(changed);
    EXPECT_EQ(verdict.status, GoldenStatus::State);
    ASSERT_TRUE(verdict.world && verdict.world->inTrace && verdict.world->now);
    EXPECT_EQ(verdict.world->inTrace->step, 42);
    EXPECT_THAT(verdict.world->inTrace->bodies, ElementsAre(1));
    EXPECT_EQ(verdict.world->now->different, 1u);
    EXPECT_EQ(verdict.world->now->compared, 2u);
    EXPECT_EQ(verdict.world->now->expected, candidate.state.bodies[1]);
    EXPECT_EQ(verdict.world->now->actual, changed.state.bodies[1]);
    EXPECT_THAT(verdict.Findings(),
                ElementsAre("the worlds differ from step 42 on, body 1 first (state "
                            "ffffffffffffffff instead of 0123456789abcdef; now 1 of 2 bodies "
                            "differs, body 1: 0.031 m lower (y 1.02 instead of 1.051))",
                            "the draw list is the same", HasSubstr("pixels equal")));
    EXPECT_EQ(ReadBytes(m_output / "pyramid/3s.actual.state.txt"),
              "ffffffffffffffff\n0 0 0 0\n1 1 1.02 0\n");
    EXPECT_EQ(ReadBytes(m_output / "pyramid/3s.expected.state.txt"),
              "0123456789abcdef\n0 0 0 0\n1 1 1.051 0\n");
}

TEST_F(ReferenceStoreTest, ReportsTraceThatDiffersAtEqualState)
{
    GoldenCandidate candidate = m_candidate;
    candidate.trace = {{{41, "00000000", "00"}}};
    Accept(candidate);
    candidate.trace.steps[0].world = "00000001";
    const GoldenVerdict verdict = Verify(candidate);
    EXPECT_EQ(verdict.status, GoldenStatus::State);
    ASSERT_TRUE(verdict.world && verdict.world->inTrace);
    EXPECT_EQ(verdict.world->actual, verdict.world->expected);
    EXPECT_EQ(verdict.world->inTrace->step, 41);
    EXPECT_TRUE(verdict.world->inTrace->isFirst);
}

TEST_F(ReferenceStoreTest, ReportsBodiesThatDoNotMatchHashAsDamaged)
{
    GoldenCandidate candidate = m_candidate;
    candidate.state = {{{0, 0, 0, 0, 0, 0, 0}, {1, 1, 1.051f, 0, 0, 0, 0}}};
    Accept(candidate);
    std::ofstream(m_references / "state/pyramid/3s.txt")
        << "0123456789abcdef\n0 0 0 0\n1 1 1.02 0\n";
    const GoldenVerdict verdict = Verify(candidate);
    EXPECT_EQ(verdict.status, GoldenStatus::NotCompared);
    EXPECT_THAT(verdict.problem, IsError(ErrorKind::Unusable, m_references.string()));
    Accept(candidate);
    EXPECT_EQ(Verify(candidate).status, GoldenStatus::Same);
}

TEST_F(ReferenceStoreTest, ReportsCutTraceAsDamaged)
{
    GoldenCandidate candidate = m_candidate;
    candidate.trace = {{{41, "00000000", "00"}, {42, "00000001", "01"}}};
    for (const char* cut : {"", "41 00000000 00\n", "42 00000001 01\n"})
    {
        Accept(candidate);
        std::ofstream(m_references / "trace/pyramid/3s.txt") << cut;
        const GoldenVerdict verdict = Verify(candidate);
        EXPECT_EQ(verdict.status, GoldenStatus::NotCompared) << cut;
        const fs::path trace = m_references / "trace/pyramid/3s.txt";
        EXPECT_THAT(
            verdict.problem,
            IsError(ErrorKind::Unusable, *cut == '\0' ? trace.string() : m_references.string()));
    }
}

TEST_F(ReferenceStoreTest, NamesFileOfDamagedStateOrTrace)
{
    GoldenCandidate candidate = m_candidate;
    candidate.state = {{{0, 0, 0, 0, 0, 0, 0}}};
    candidate.trace = {{{41, "00000000", "00"}}};
    for (const char* file : {"state/pyramid/3s.txt", "trace/pyramid/3s.txt"})
    {
        Accept(candidate);
        std::ofstream(m_references / file, std::ios::app) << "and more\n";
        const GoldenVerdict verdict = Verify(candidate);
        EXPECT_EQ(verdict.status, GoldenStatus::NotCompared);
        EXPECT_THAT(verdict.problem, IsError(ErrorKind::Unusable, (m_references / file).string()));
        EXPECT_THAT(verdict.problem.problem, HasSubstr("\"and more\""));
        EXPECT_TRUE(fs::exists(m_output / "pyramid/3s.actual.png")) << "to be looked at";
    }
}

TEST_F(ReferenceStoreTest, QuotesAcceptCommandForShell)
{
    const ReferenceStore store(m_folder / "it's mine", m_output);
    const GoldenVerdict verdict = *store.Verify(m_candidate);
    EXPECT_EQ(verdict.accept, "boxreel golden accept pyramid/3s --references '" +
                                  (m_folder / "it'\\''s mine").string() + "'");
    EXPECT_THAT(verdict.Text("nod"), testing::EndsWith(", nod."));
}

TEST_F(ReferenceStoreTest, ComparesWithPictureOfSameRenderer)
{
    GoldenCandidate here = m_candidate;
    here.renderer = "OSMesa, llvmpipe (LLVM 15.0.6)";
    GoldenCandidate there = m_candidate;
    there.renderer = "EGL, some GPU";
    FillRect(there.frame, 0, 0, 40, 40, kLight);
    Accept(here);
    EXPECT_EQ(Verify(there).status, GoldenStatus::Pixels);
    ASSERT_TRUE(m_store.Accept(there, AcceptAs::ForThisRenderer));
    EXPECT_TRUE(fs::exists(m_references / "frames/pyramid/3s@egl-some-gpu.png"));
    EXPECT_EQ(Verify(there).status, GoldenStatus::Same);
    EXPECT_EQ(Verify(here).status, GoldenStatus::Same) << "the others' picture stays";
    there.frame = here.frame;
    EXPECT_EQ(Verify(there).status, GoldenStatus::Pixels);
    EXPECT_THAT(m_store.Names(), ElementsAre("pyramid/3s"));
}

TEST_F(ReferenceStoreTest, AcceptsTheComparedPictureOfARendererAgain)
{
    GoldenCandidate here = m_candidate;
    here.renderer = "OSMesa, llvmpipe (LLVM 15.0.6)";
    GoldenCandidate there = m_candidate;
    there.renderer = "EGL, some GPU";
    FillRect(there.frame, 0, 0, 40, 40, kLight);
    Accept(here);
    ASSERT_TRUE(m_store.Accept(there, AcceptAs::ForThisRenderer));
    FillRect(there.frame, 40, 40, 80, 80, kLight);
    Accept(there);
    EXPECT_EQ(Verify(there).status, GoldenStatus::Same) << "its own is renewed";
    EXPECT_EQ(Verify(here).status, GoldenStatus::Same) << "the one for all stays";
}

/// Two pictures of one scene that only another renderer may draw so differently.
struct ReferenceOfARenderer : ReferenceStoreTest
{
    ReferenceOfARenderer()
    {
        drawn.fingerprint = "0123456789abcdef";
        EXPECT_TRUE(m_store.Accept(drawn));
        now.fingerprint = "fedcba9876543210";
    }

    GoldenCandidate drawn = m_candidate;
    GoldenCandidate now = Candidate("pyramid/3s", SmallScene(), {.fillShift = 1});
};

TEST_F(ReferenceOfARenderer, IsComparedAcrossMachinesByAnother)
{
    const GoldenVerdict verdict = Verify(now);
    EXPECT_EQ(verdict.status, GoldenStatus::Same) << verdict.Text();
    EXPECT_EQ(verdict.limits, LimitsChoice::OtherRenderer);
    EXPECT_EQ(verdict.pixels.limits.preset, "cross-machine");
    EXPECT_THAT(ReadBytes(m_output / "pyramid/3s.verdict.json"),
                HasSubstr("\"limitsChoice\": \"other renderer\""));
}

TEST_F(ReferenceOfARenderer, IsComparedStrictlyByTheSame)
{
    now.fingerprint = drawn.fingerprint;
    const GoldenVerdict verdict = Verify(now);
    EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
    EXPECT_EQ(verdict.limits, LimitsChoice::SameRenderer);
    EXPECT_EQ(Verify(drawn).status, GoldenStatus::Same);
}

TEST_F(ReferenceOfARenderer, IsComparedStrictlyWhenEitherIsUnknown)
{
    now.fingerprint = "";
    EXPECT_EQ(Verify(now).limits, LimitsChoice::AsGiven);
    EXPECT_EQ(Verify(now).status, GoldenStatus::Pixels);
    now.fingerprint = drawn.fingerprint;
    drawn.fingerprint = "";
    Accept(drawn);
    EXPECT_EQ(Verify(now).limits, LimitsChoice::AsGiven);
    EXPECT_EQ(Verify(now).status, GoldenStatus::Pixels);
}

TEST_F(ReferenceOfARenderer, IsComparedByThePresetThatIsGiven)
{
    EXPECT_EQ(Verify(now, CompareSettings::SameMachine()).status, GoldenStatus::Pixels);
    EXPECT_EQ(Verify(now, CompareSettings::Exact()).status, GoldenStatus::Pixels);
    EXPECT_EQ(Verify(now, CompareSettings::Exact()).limits, LimitsChoice::AsGiven);
    now.fingerprint = drawn.fingerprint;
    EXPECT_EQ(Verify(now, CompareSettings::CrossMachine()).status, GoldenStatus::Same);
}

TEST_F(ReferenceOfARenderer, IsComparedByASingleLimitThatIsGiven)
{
    CompareSettings settings;
    settings.maxPixels = 5;
    EXPECT_EQ(Verify(now, settings).status, GoldenStatus::Pixels);
    EXPECT_EQ(Verify(now, settings).limits, LimitsChoice::AsGiven);
}

TEST_F(ReferenceOfARenderer, IsComparedWithoutWhatIsIgnored)
{
    FillRect(now.frame, 10, 10, 40, 40, kLight);
    const GoldenVerdict found = Verify(now);
    EXPECT_EQ(found.status, GoldenStatus::Pixels);
    EXPECT_EQ(found.limits, LimitsChoice::OtherRenderer);
    CompareSettings settings;
    settings.ignored = {{10, 10, 40, 40}};
    const GoldenVerdict verdict = Verify(now, settings);
    EXPECT_EQ(verdict.status, GoldenStatus::Same) << verdict.Text();
    EXPECT_EQ(verdict.pixels.ignored, 900);
}

TEST_F(ReferenceStoreTest, RefusesUnknownRendererForThisRenderer)
{
    const Result<void> accepted = m_store.Accept(m_candidate, AcceptAs::ForThisRenderer);
    EXPECT_THAT(accepted, Refuses(m_candidate.name));
    EXPECT_FALSE(fs::exists(m_references));
}

TEST_F(ReferenceStoreTest, JudgesWithoutLeavingAnything)
{
    EXPECT_EQ(m_store.Judge(m_candidate)->status, GoldenStatus::Missing);
    Accept(m_candidate);
    const Result<GoldenVerdict> verdict = m_store.Judge(Moved());
    EXPECT_EQ(verdict->status, GoldenStatus::DrawList);
    EXPECT_FALSE(fs::exists(m_output));
}

TEST_F(ReferenceStoreTest, ReportsStateFirstWhenTheRestDiffers)
{
    Accept(m_candidate);
    DrawList list = WithoutItem(SmallScene(), 4);
    GoldenCandidate changed = Candidate("pyramid/3s", list);
    changed.stateHash = "ffffffffffffffff";
    const GoldenVerdict verdict = Verify(changed);
    EXPECT_EQ(verdict.status, GoldenStatus::State);
    ASSERT_TRUE(verdict.world && verdict.list);
    EXPECT_EQ(verdict.list->line, 5u);
    EXPECT_FALSE(verdict.pixels.equal);
}

TEST_F(ReferenceStoreTest, NamesTheFirstLineOfTheDrawListThatDiffers)
{
    Accept(m_candidate);
    GoldenCandidate changed = Moved();
    const GoldenVerdict verdict = Verify(changed);
    EXPECT_EQ(verdict.status, GoldenStatus::DrawList);
    const auto firstLine = [](const DrawList& list) {
        const std::string text = ToText(list);
        return text.substr(0, text.find('\n'));
    };
    ASSERT_TRUE(verdict.list);
    EXPECT_EQ(verdict.list->line, 1u);
    EXPECT_EQ(verdict.list->actual, firstLine(changed.list));
    EXPECT_EQ(verdict.list->expected, firstLine(m_candidate.list));
    EXPECT_TRUE(verdict.pixels.equal);
    EXPECT_EQ(verdict.Findings().front(),
              "same world, other geometry: the draw list differs (line 1 is \"" +
                  firstLine(changed.list) + "\" instead of \"" + firstLine(m_candidate.list) +
                  "\")");
}

TEST_F(ReferenceStoreTest, NamesALineThatIsMissingOrTooMany)
{
    Accept(m_candidate);
    GoldenCandidate changed = m_candidate;
    changed.list.items.pop_back();
    const std::optional<LineDifference> fewer = Verify(changed).list;
    ASSERT_TRUE(fewer && fewer->expected);
    EXPECT_EQ(fewer->line, 6u);
    EXPECT_FALSE(fewer->actual);
    EXPECT_THAT(*fewer->expected, StartsWith("body 4 labels text"));
    EXPECT_EQ(fewer->actualLines, 5u);
    EXPECT_EQ(fewer->expectedLines, 6u);
    changed = m_candidate;
    changed.list.AddPoint({1.0f, 2.0f}, 3.0f, kJoint);
    const std::optional<LineDifference> more = Verify(changed).list;
    ASSERT_TRUE(more && more->actual);
    EXPECT_EQ(more->line, 7u);
    EXPECT_FALSE(more->expected);
    EXPECT_THAT(*more->actual, StartsWith("body 4 labels point"));
}

TEST_F(ReferenceStoreTest, ReportsPixelsWhenOnlyTheyDiffer)
{
    Accept(m_candidate);
    const GoldenVerdict verdict = Verify(Candidate("pyramid/3s", SmallScene(), {.outline = 2}));
    EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
    EXPECT_FALSE(verdict.pixels.equal);
    EXPECT_FALSE(verdict.list);
    EXPECT_TRUE(verdict.compared.list);
}

TEST_F(ReferenceStoreTest, UsesTheSettingsOfTheCaller)
{
    Accept(m_candidate);
    GoldenCandidate changed = m_candidate;
    changed.frame.rgba[0] = 99;
    EXPECT_EQ(Verify(changed).status, GoldenStatus::Same) << "a single stray pixel";
    EXPECT_EQ(Verify(changed, CompareSettings::Exact()).status, GoldenStatus::Pixels);
}

TEST_F(ReferenceStoreTest, LeavesPicturesListsAndVerdictOfFailure)
{
    Accept(m_candidate);
    const GoldenCandidate changed = Candidate("pyramid/3s", WithoutItem(SmallScene(), 4));
    const GoldenVerdict verdict = Verify(changed);
    EXPECT_THAT(Files(m_output),
                UnorderedElementsAre("pyramid/3s.expected.png", "pyramid/3s.actual.png",
                                     "pyramid/3s.difference.png", "pyramid/3s.side-by-side.png",
                                     "pyramid/3s.expected.txt", "pyramid/3s.actual.txt",
                                     "pyramid/3s.verdict.json"));
    EXPECT_EQ(verdict.look.front(), (m_output / "pyramid/3s.side-by-side.png").string());
    const auto picture = [&](const char* suffix) {
        return ReadPng(m_output / (std::string("pyramid/3s") + suffix));
    };
    EXPECT_EQ(*picture(".expected.png"), m_candidate.frame);
    EXPECT_EQ(*picture(".actual.png"), changed.frame);
    EXPECT_EQ(*picture(".difference.png"), verdict.pixels.difference);
    EXPECT_EQ(*picture(".side-by-side.png"),
              SideBySide(m_candidate.frame, changed.frame, verdict.pixels.difference));
    EXPECT_EQ(ReadBytes(m_output / "pyramid/3s.expected.txt"), ToText(m_candidate.list));
    EXPECT_EQ(ReadBytes(m_output / "pyramid/3s.actual.txt"), ToText(changed.list));
}

TEST_F(ReferenceStoreTest, RemovesFilesOfEarlierFailureWhenPassing)
{
    Accept(m_candidate);
    Verify(Moved());
    WriteBytes(m_output / "pyramid/3s.txt", "of someone else");
    EXPECT_EQ(Verify(m_candidate).status, GoldenStatus::Same);
    EXPECT_THAT(Files(m_output), UnorderedElementsAre("pyramid/3s.txt", "pyramid/3s.verdict.json"));
}

TEST_F(ReferenceStoreTest, RemovesExpectedPictureWithoutReference)
{
    Accept(m_candidate);
    Verify(Moved());
    fs::remove_all(m_references);
    Verify(m_candidate);
    EXPECT_THAT(Files(m_output),
                UnorderedElementsAre("pyramid/3s.actual.png", "pyramid/3s.actual.txt",
                                     "pyramid/3s.verdict.json"));
}

TEST_F(ReferenceStoreTest, ReplacesReferenceOnAccept)
{
    Accept(m_candidate);
    const GoldenCandidate changed = Candidate("pyramid/3s", WithoutItem(SmallScene(), 4));
    Accept(changed);
    EXPECT_EQ(Verify(changed).status, GoldenStatus::Same);
    EXPECT_EQ(Verify(m_candidate).status, GoldenStatus::DrawList);
}

TEST_F(ReferenceStoreTest, ComparesOnlyDepthsOfCandidate)
{
    GoldenCandidate pixelsOnly;
    pixelsOnly.name = "photo";
    pixelsOnly.frame = Filled(20, 20, kAwake);
    Accept(pixelsOnly);
    EXPECT_THAT(Files(m_references), ElementsAre("frames/photo.png"));
    EXPECT_EQ(Verify(pixelsOnly).status, GoldenStatus::Same);
    pixelsOnly.frame = Filled(20, 20, kStatic);
    const GoldenVerdict verdict = Verify(pixelsOnly);
    EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
    EXPECT_FALSE(verdict.compared.list);
    EXPECT_FALSE(verdict.compared.state);

    GoldenCandidate stateOnly;
    stateOnly.name = "state-only";
    stateOnly.stateHash = "0000000000000001";
    Accept(stateOnly);
    EXPECT_EQ(Verify(stateOnly).status, GoldenStatus::Same);
    stateOnly.stateHash = "0000000000000002";
    EXPECT_EQ(Verify(stateOnly).status, GoldenStatus::State);
}

TEST_F(ReferenceStoreTest, FailsASceneThatStoppedDrawing)
{
    Accept(m_candidate);
    GoldenCandidate blank = m_candidate;
    blank.list.Clear();
    EXPECT_EQ(Verify(blank).status, GoldenStatus::DrawList);
    blank = m_candidate;
    blank.frame = Frame();
    const GoldenVerdict verdict = Verify(blank);
    EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
    EXPECT_EQ(verdict.pixels.actualSize, (std::array{0, 0}));
}

TEST_F(ReferenceStoreTest, RemovesDepthsMissingInCandidateOnAccept)
{
    Accept(m_candidate);
    GoldenCandidate pixelsOnly;
    pixelsOnly.name = m_candidate.name;
    pixelsOnly.frame = m_candidate.frame;
    Accept(pixelsOnly);
    EXPECT_THAT(Files(m_references), ElementsAre("frames/pyramid/3s.png"));
}

TEST_F(ReferenceStoreTest, HasNothingToAcceptInAnEmptyCandidate)
{
    GoldenCandidate empty;
    empty.name = "empty";
    EXPECT_FALSE(m_store.Accept(empty));
    EXPECT_EQ(Verify(empty).status, GoldenStatus::Missing);
}

TEST_F(ReferenceStoreTest, PacksALongDrawListAndReadsItBack)
{
    const GoldenCandidate candidate{"long", "", LongList(), Filled(8, 8, kDark)};
    Accept(candidate);
    EXPECT_THAT(Files(m_references),
                UnorderedElementsAre("drawlist/long.txt.gz", "frames/long.png"));
    EXPECT_LT(fs::file_size(m_references / "drawlist/long.txt.gz"),
              ToText(candidate.list).size() / 4);
    EXPECT_EQ(ReadBytes(m_references / "drawlist/long.txt.gz").substr(0, 2), "\x1f\x8b");
    EXPECT_EQ(Verify(candidate).status, GoldenStatus::Same);
    GoldenCandidate changed = candidate;
    changed.list.points[4001].y += 0.5f;
    EXPECT_EQ(Verify(changed).list->line, 2001u);
    EXPECT_EQ(ReadBytes(m_output / "long.expected.txt"), ToText(candidate.list))
        << "unpacked, for a person";
}

TEST_F(ReferenceStoreTest, PacksTheSameListToTheSameBytes)
{
    const GoldenCandidate candidate{"long", "", LongList(), Frame()};
    Accept(candidate);
    const std::string first = ReadBytes(m_references / "drawlist/long.txt.gz");
    Accept(candidate);
    EXPECT_EQ(ReadBytes(m_references / "drawlist/long.txt.gz"), first);
    EXPECT_EQ(first.substr(4, 4), std::string(4, '\0')) << "no time in the header";
}

TEST_F(ReferenceStoreTest, ReplacesAPackedListByAPlainOneAndBack)
{
    const GoldenCandidate longOne{"scene", "", LongList(), Frame()};
    const GoldenCandidate shortOne{"scene", "", SmallScene(), Frame()};
    Accept(longOne);
    Accept(shortOne);
    EXPECT_THAT(Files(m_references), ElementsAre("drawlist/scene.txt"));
    Accept(longOne);
    EXPECT_THAT(Files(m_references), ElementsAre("drawlist/scene.txt.gz"));
    EXPECT_EQ(Verify(longOne).status, GoldenStatus::Same);
}

TEST_F(ReferenceStoreTest, RefusesPlainListBesidePackedOne)
{
    const GoldenCandidate candidate{"scene", "", LongList(), Frame()};
    Accept(candidate);
    WriteBytes(m_references / "drawlist/scene.txt", "something else\n");
    const GoldenVerdict verdict = Verify(candidate);
    EXPECT_EQ(verdict.status, GoldenStatus::NotCompared);
    EXPECT_THAT(verdict.problem,
                IsError(ErrorKind::Unusable, (m_references / "drawlist/scene.txt").string()));
    Accept(candidate);
    EXPECT_EQ(Verify(candidate).status, GoldenStatus::Same) << "one of both is left";
}

TEST_F(ReferenceStoreTest, ListsItsNamesSortedAndOnce)
{
    EXPECT_THAT(m_store.Names(), IsEmpty());
    Accept(Candidate("pyramid/3s"));
    Accept(Candidate("bridge/1s"));
    Accept({"long", "", LongList(), Frame()});
    Accept({"only-state", "0000000000000000", DrawList(), Frame()});
    WriteBytes(m_references / "README.md", "how to");
    WriteBytes(m_references / "frames/pyramid/4s.part.png", "unfinished");
    WriteBytes(m_references / "frames/.hidden.png", "not ours");
    WriteBytes(m_references / "frames/Thumbs.db", "not ours");
    EXPECT_THAT(m_store.Names(), ElementsAre("bridge/1s", "long", "only-state", "pyramid/3s"));
}
