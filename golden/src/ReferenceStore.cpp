// SPDX-License-Identifier: MIT
#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Words.h>
#include <golden/ReferenceStore.h>

#include "FailureFiles.h"
#include "IgnoredBodies.h"
#include "Moment.h"
#include "ReferenceFiles.h"
#include "TextDifference.h"
#include "VerdictText.h"

#include <optional>
#include <sstream>
#include <utility>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

/// A film's contact sheet for a comparison.
struct SheetView
{
    const Frame& frame;
    const SheetLayout& layout; ///< completely on the frame
};

bool HaveSameSize(const SheetLayout& a, const SheetLayout& b)
{
    return a.width == b.width && a.height == b.height;
}

bool LiesOn(const Frame& frame, const SheetLayout& layout)
{
    const PixelBounds row =
        layout.Place(std::min(layout.pictures, std::size_t(layout.columns)) - 1);
    return row.x1 <= frame.width && layout.Place(layout.pictures - 1).y1 <= frame.height;
}

/// Returns the step of the first picture that differs, or that only one film has. None if all have
/// different sizes, or only the sheet as a whole differs.
std::optional<std::int64_t> FirstPicture(const SheetView& expected, const SheetView& actual,
                                         CompareSettings settings)
{
    if (!HaveSameSize(expected.layout, actual.layout))
    {
        return std::nullopt;
    }
    settings.paintsDifference = false;
    const std::size_t count = std::min(expected.layout.pictures, actual.layout.pictures);
    for (std::size_t i = 0; i < count; ++i)
    {
        if (!Compare(CutOut(expected.frame, expected.layout.Place(i)),
                     CutOut(actual.frame, actual.layout.Place(i)), settings)
                 .equal)
        {
            return expected.layout.Step(i);
        }
    }
    return expected.layout.pictures == actual.layout.pictures
               ? std::nullopt
               : std::optional(expected.layout.Step(count));
}

std::string FirstLine(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

GoldenStatus StatusOf(const GoldenVerdict& verdict)
{
    const bool hasOtherMoments = verdict.film && verdict.film->HasOtherMoments();
    const bool hasOtherPixels = verdict.compared.frame && !verdict.pixels.equal;
    return verdict.world                       ? GoldenStatus::State
           : verdict.list                      ? GoldenStatus::DrawList
           : hasOtherPixels || hasOtherMoments ? GoldenStatus::Pixels
                                               : GoldenStatus::Same;
}

// Keeps the failure when its files cannot be written.
Error With(const GoldenVerdict& verdict, const Error& error)
{
    return Error{error.kind, verdict.name,
                 JoinedBy("; ", verdict.Findings()) + "; " + error.culprit + ": " + error.problem,
                 error.remedy};
}

bool IsNothingKept(const Moment& expected)
{
    return !expected.state && !expected.trace && !expected.list && !expected.frame &&
           !expected.sheet;
}

/// Returns the depths of the actual moment that the reference has too.
Moment Comparable(const Moment& expected, Moment actual)
{
    if (!expected.state)
    {
        actual.state.reset();
        actual.bodies = {};
    }
    if (!expected.trace)
    {
        actual.trace.reset();
    }
    if (!expected.list)
    {
        actual.list.reset();
    }
    if (!expected.frame)
    {
        actual.frame.reset();
    }
    if (!expected.sheet || !expected.frame) // the layout applies to the picture
    {
        actual.sheet.reset();
    }
    return actual;
}

/// With which the command makes this sheet of a film.
std::string OptionsFor(const SheetLayout& sheet)
{
    const ContactSheetSettings usual;
    std::ostringstream options;
    options << " --film FILE";
    if (sheet.every != usual.every)
    {
        options << " --every " << sheet.every;
    }
    if (sheet.stepsPerSecond != usual.stepsPerSecond)
    {
        options << " --hz " << sheet.stepsPerSecond;
    }
    return options.str();
}

/// Returns the option for the references; the command's default is that of the current checkout.
std::string OptionFor(const fs::path& references)
{
    const bool isDefault =
        references.filename() == "references" && references.parent_path().filename() == "golden";
    return isDefault ? "" : " --references " + ShellQuoted(references.string());
}

/// Reports a candidate without a reference.
Result<GoldenVerdict> ReportAlone(GoldenVerdict verdict, const FailureFiles& files,
                                  const Moment& actual)
{
    if (const Result<void> written = files.Write(Moment{}, actual, Frame{}); !written)
    {
        return With(verdict, written.GetError());
    }
    if (actual.frame && !actual.frame->rgba.empty())
    {
        verdict.look = {files.ActualPicture()};
    }
    else if (actual.list)
    {
        verdict.look = {files.ActualList()};
    }
    return verdict;
}

Result<GoldenVerdict> ReportDifferent(GoldenVerdict verdict, const FailureFiles& files,
                                      const Moment& expected, const Moment& actual)
{
    if (const Result<void> written = files.Write(expected, actual, verdict.pixels.difference);
        !written)
    {
        return With(verdict, written.GetError());
    }
    if (actual.frame)
    {
        verdict.look.push_back(files.SideBySidePicture());
    }
    if (actual.list)
    {
        verdict.look.push_back(files.ExpectedList());
        verdict.look.push_back(files.ActualList());
    }
    return verdict;
}

struct Judged
{
    GoldenVerdict verdict{};
    Moment expected{}, actual{};
    CompareSettings limits; // those that held, with what was left out
};

/// "bodies 3, 17"
std::string Bodies(const std::vector<int>& numbers)
{
    std::string text;
    for (const int number : numbers)
    {
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    }
    return PluralOf(numbers.size(), "body") + " " + text;
}

/// Empty when each body can be left out.
std::string WhyNotLeftOut(const std::vector<int>& bodies, const GoldenCandidate& candidate,
                          const Moment& expected)
{
    if (!candidate.frame.rgba.empty() && !candidate.camera)
    {
        return "the picture has no camera";
    }
    int last = -1;
    for (const WorldState* const state : {&candidate.state, &expected.bodies})
    {
        last = state->bodies.empty() ? last : std::max(last, state->bodies.back().number);
    }
    const int largest = *std::max_element(bodies.begin(), bodies.end());
    return largest <= last ? ""
           : last < 0      ? "the reference has no states of bodies"
                           : "there is no body " + std::to_string(largest) + ", the last is " +
                            std::to_string(last);
}

/// Returns why the depths of the reference are inconsistent; empty if they are not. A merge may
/// change the lines of bodies but not the hash, or the trace may have other steps. The reported
/// differences would then be wrong.
std::string WhyNotWhole(const Moment& expected, const Moment& actual)
{
    if (!actual.state || *actual.state != *expected.state)
    {
        return "";
    }
    const bool areKept = !expected.bodies.bodies.empty() && !actual.bodies.bodies.empty();
    if (areKept && ToText(expected.bodies) != ToText(actual.bodies))
    {
        return "the bodies of its state do not match its hash";
    }
    const std::optional<TraceDifference> inTrace =
        actual.trace ? FirstDifference(*expected.trace, *actual.trace) : std::nullopt;
    return inTrace && inTrace->isOfOne ? "the steps of its trace do not match its state" : "";
}

std::optional<WorldDifference> CompareWorlds(const Moment& expected, const Moment& actual)
{
    if (!actual.state)
    {
        return std::nullopt;
    }
    WorldDifference world{*expected.state, *actual.state, {}, {}};
    if (actual.trace)
    {
        world.inTrace = FirstDifference(*expected.trace, *actual.trace);
    }
    if (world.expected == world.actual)
    {
        return world.inTrace ? std::optional(world) : std::nullopt;
    }
    if (!expected.bodies.bodies.empty() && !actual.bodies.bodies.empty())
    {
        world.now = DifferenceOf(expected.bodies, actual.bodies);
    }
    return world;
}

/// Fills in what differs, of two moments that have the same depths.
void CompareMoments(const Moment& expected, const Moment& actual, const CompareSettings& settings,
                    GoldenVerdict& verdict)
{
    verdict.compared = {actual.state.has_value(), actual.list.has_value(),
                        actual.frame.has_value()};
    verdict.world = CompareWorlds(expected, actual);
    if (actual.list)
    {
        verdict.list = FirstDifference(*expected.list, *actual.list);
    }
    if (actual.frame)
    {
        verdict.pixels = Compare(*expected.frame, *actual.frame, settings);
    }
}

/// Compares the films of two sheets whose pictures have been compared.
FilmComparison CompareFilms(const Moment& expected, const Moment& actual,
                            const SheetLayout& expectedSheet, const SheetLayout& actualSheet,
                            const CompareSettings& settings, bool differ)
{
    FilmComparison film{FirstLine(*expected.sheet), FirstLine(*actual.sheet), expectedSheet,
                        actualSheet, std::nullopt};
    if (differ && !film.HasOtherMoments())
    {
        film.firstStep =
            FirstPicture({*expected.frame, expectedSheet}, {*actual.frame, actualSheet}, settings);
    }
    return film;
}

/// Returns the command that accepts the candidate.
std::string CommandToAccept(const GoldenCandidate& candidate, const fs::path& references)
{
    return "boxreel golden accept " + candidate.name +
           (candidate.sheet ? OptionsFor(*candidate.sheet) : "") + OptionFor(references);
}

/// Reports a damaged reference; the candidate may replace it.
Judged ReportDamaged(Judged judged, const GoldenCandidate& candidate, const fs::path& references,
                     const Error& why)
{
    judged.expected = Moment{};
    judged.actual = Take(candidate, judged.expected);
    judged.verdict.status = GoldenStatus::NotCompared;
    judged.verdict.problem = why;
    judged.verdict.accept = CommandToAccept(candidate, references);
    return judged;
}

/// Removes the bodies from both moments and, by the limits, from their pictures. Returns the reason
/// if that is impossible, otherwise an empty string.
std::string WhyNotIgnorable(const std::vector<int>& bodies, const GoldenCandidate& candidate,
                            Moment& expected, Moment& actual, CompareSettings& limits)
{
    if (std::string why = WhyNotLeftOut(bodies, candidate, expected); !why.empty())
    {
        return why;
    }
    if (candidate.camera)
    {
        const std::vector<PixelBounds> regions =
            RegionsOf(bodies, expected, actual, *candidate.camera);
        limits.ignored.insert(limits.ignored.end(), regions.begin(), regions.end());
    }
    LeaveOut(bodies, expected, actual);
    return expected.bodies.bodies.empty() && actual.bodies.bodies.empty()
               ? "then none is left to compare"
               : "";
}

/// Selects the limits by the renderers of both pictures.
LimitsChoice ChooseLimits(const Moment& expected, const Moment& actual, CompareSettings& limits)
{
    const std::optional<CompareSettings> others = ForOtherRenderer(limits);
    if (!others || expected.fingerprint.empty() || actual.fingerprint.empty())
    {
        return LimitsChoice::AsGiven;
    }
    if (expected.fingerprint == actual.fingerprint)
    {
        return LimitsChoice::SameRenderer;
    }
    limits = *others;
    return LimitsChoice::OtherRenderer;
}

Result<Judged> JudgeMoment(const fs::path& references, const GoldenCandidate& candidate,
                           const CompareSettings& settings)
{
    RETURN_IF_ERROR(CheckReferenceName(candidate.name));
    Judged judged{.limits = settings};
    GoldenVerdict& verdict = judged.verdict;
    verdict.name = candidate.name;
    Result<Moment> expected = ReadReference(references, candidate.name, candidate.renderer);
    if (!expected)
    {
        return ReportDamaged(std::move(judged), candidate, references, expected.GetError());
    }
    judged.expected = *std::move(expected);
    judged.actual = Take(candidate, judged.expected);
    verdict.limits = ChooseLimits(judged.expected, judged.actual, judged.limits);
    verdict.references = references.string();
    verdict.missing = MissingFiles(candidate.name, judged.expected, judged.actual);
    if (IsNothingKept(judged.expected))
    {
        verdict.status = GoldenStatus::Missing;
        verdict.absence = GoldenAbsence::All;
        verdict.accept = CommandToAccept(candidate, references);
        return judged;
    }
    const Moment actual = Comparable(judged.expected, judged.actual);
    if (const std::string why = WhyNotWhole(judged.expected, actual); !why.empty())
    {
        return ReportDamaged(std::move(judged), candidate, references,
                             {ErrorKind::Unusable, references.string(), why, "restore it"});
    }
    const std::optional<SheetLayout> sheet =
        actual.sheet ? LayoutOf(*judged.expected.sheet) : std::nullopt;
    if (actual.sheet && (!sheet || !LiesOn(*judged.expected.frame, *sheet)))
    {
        return ReportDamaged(std::move(judged), candidate, references,
                             {ErrorKind::Unusable, references.string(),
                              "the text of its sheet does not match its picture", "restore it"});
    }
    Moment less[2]; // the files of a failure still contain the ignored bodies
    const Moment* before = &judged.expected;
    const Moment* now = &actual;
    if (!settings.ignoredBodies.empty())
    {
        less[0] = judged.expected;
        less[1] = actual;
        if (const std::string why =
                WhyNotIgnorable(settings.ignoredBodies, candidate, less[0], less[1], judged.limits);
            !why.empty())
        {
            verdict.status = GoldenStatus::NotCompared;
            verdict.problem = {ErrorKind::Unusable, Bodies(settings.ignoredBodies),
                               "cannot be ignored: " + why};
            return judged;
        }
        before = &less[0];
        now = &less[1];
    }
    CompareMoments(*before, *now, judged.limits, verdict);
    if (sheet)
    {
        verdict.film = CompareFilms(*before, *now, *sheet, *candidate.sheet, judged.limits,
                                    !verdict.pixels.equal);
    }
    verdict.status = StatusOf(verdict);
    if (verdict.status == GoldenStatus::Same && !verdict.missing.empty())
    {
        verdict.status = GoldenStatus::Missing;
        verdict.absence = GoldenAbsence::Part;
        verdict.accept = CommandToAccept(candidate, references);
    }
    return judged;
}

} // namespace

Result<void> CheckReferenceName(const std::string& name)
{
    const std::string why = WhyNotUsable(name);
    return why.empty() ? Result<void>()
                       : Error{ErrorKind::Unusable, Quoted(name), why, "choose another name"};
}

GoldenCandidate CandidateOf(ContactSheet sheet, std::string name)
{
    GoldenCandidate candidate;
    candidate.name = std::move(name);
    candidate.frame = std::move(sheet.frame);
    candidate.sheet = sheet.layout;
    return candidate;
}

ReferenceStore::ReferenceStore(std::filesystem::path references, std::filesystem::path output)
    : m_references(std::move(references)), m_output(std::move(output))
{}

Result<GoldenVerdict> ReferenceStore::Judge(const GoldenCandidate& candidate,
                                            const CompareSettings& settings) const
{
    CompareSettings unpainted = settings;
    unpainted.paintsDifference = false;
    Result<Judged> judged = JudgeMoment(m_references, candidate, unpainted);
    return judged ? Result<GoldenVerdict>(std::move(judged->verdict))
                  : Result<GoldenVerdict>(judged.GetError());
}

Result<GoldenVerdict> ReferenceStore::Verify(const GoldenCandidate& candidate,
                                             const CompareSettings& settings) const
{
    const std::string& name = candidate.name;
    RETURN_IF_ERROR(CheckReferenceName(name));
    ASSIGN_OR_RETURN(const FailureFiles files, FailureFiles::At(m_output, name));
    RETURN_IF_ERROR(files.Remove());
    ASSIGN_OR_RETURN(Judged judged, JudgeMoment(m_references, candidate, settings));
    GoldenVerdict& verdict = judged.verdict;
    const Result<void> written = files.WriteVerdict({verdict, candidate, judged.limits});
    if (verdict.status == GoldenStatus::Same)
    {
        // An equal candidate passes even if its verdict cannot be written, such as in a read-only
        // folder.
        verdict.warning = written ? std::nullopt : std::optional(written.GetError());
        return std::move(verdict);
    }
    if (!written)
    {
        return With(verdict, written.GetError());
    }
    if (!verdict.accept.empty())
    {
        return ReportAlone(std::move(verdict), files, judged.actual);
    }
    return verdict.status == GoldenStatus::NotCompared
               ? std::move(verdict)
               : ReportDifferent(std::move(verdict), files, judged.expected, judged.actual);
}

Result<void> ReferenceStore::Accept(const GoldenCandidate& candidate, AcceptAs as) const
{
    RETURN_IF_ERROR(CheckReferenceName(candidate.name));
    if (as == AcceptAs::ForThisRenderer && candidate.renderer.empty())
    {
        return Error{ErrorKind::Unusable, candidate.name, "its renderer is unknown",
                     "accept it for all renderers"};
    }
    const bool isOfOne =
        as == AcceptAs::ForThisRenderer || HasOwnPicture(candidate.name, candidate.renderer);
    return Store(m_references, candidate.name, Take(candidate, Moment{}),
                 isOfOne ? candidate.renderer : "");
}

bool ReferenceStore::HasOwnPicture(const std::string& name, const std::string& renderer) const
{
    return boxreel::HasOwnPicture(m_references, name, renderer);
}

std::vector<std::string> ReferenceStore::Names() const
{
    return ReferenceNames(m_references);
}

} // namespace boxreel
