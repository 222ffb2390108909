// SPDX-License-Identifier: MIT
#include <golden/ReferenceStore.h>

#include "FailureFiles.h"
#include "Moment.h"
#include "ReferenceFiles.h"
#include "TextDifference.h"

#include <optional>
#include <utility>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

Error Unusable(const std::string& name, const std::string& why)
{
    return Error{ErrorKind::Unusable, "\"" + name + "\" cannot name a reference: " + why + "."};
}

struct Differences
{
    bool state = false;
    std::optional<LineDifference> list;
    bool pixels = false;
};

std::string Join(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

GoldenStatus StatusOf(const Differences& differences)
{
    if (differences.state)
    {
        return GoldenStatus::State;
    }
    if (differences.list)
    {
        return GoldenStatus::DrawList;
    }
    return differences.pixels ? GoldenStatus::Pixels : GoldenStatus::Same;
}

// What differs first, then what became of the depths below it.
std::string Explain(const Moment& expected, const Moment& actual, const Differences& differences,
                    const Comparison& pixels)
{
    const std::string list = differences.list
                                 ? "the draw list differs (" + Describe(*differences.list) + ")"
                                 : "the draw list is the same";
    const std::string picture = "pixels " + pixels.verdict;
    std::string text;
    switch (StatusOf(differences))
    {
    case GoldenStatus::State:
        text = "the worlds differ (state " + *actual.state + " instead of " + *expected.state + ")";
        text += actual.list ? "; " + list : "";
        break;
    case GoldenStatus::DrawList:
        text = (actual.state ? "same world, other geometry: " : "other geometry: ") + list;
        break;
    case GoldenStatus::Pixels:
        return (actual.list ? "same geometry, other pixels: " : "other pixels: ") + picture;
    default:
        return std::string("same") + (actual.state ? ", state" : "") +
               (actual.list ? ", draw list" : "") + (actual.frame ? ", " + picture : "");
    }
    return text + (actual.frame ? "; " + picture : "");
}

// The failure stays known even when its files cannot be written.
Error With(const GoldenVerdict& verdict, const Error& error)
{
    return Error{error.kind, verdict.message + " " + error.message};
}

Result<GoldenVerdict> ReportMissing(GoldenVerdict verdict, const FailureFiles& files,
                                    const Moment& expected, const Moment& actual,
                                    const fs::path& references)
{
    verdict.status = GoldenStatus::Missing;
    verdict.message = verdict.name + ": there is no reference (" +
                      Join(MissingFiles(verdict.name, expected, actual)) + " missing in " +
                      references.string() + ").";
    if (const Result<void> written = files.Write(Moment{}, actual, Frame{}); !written)
    {
        return With(verdict, written.GetError());
    }
    const bool isSeen = actual.frame && !actual.frame->rgba.empty();
    if (isSeen || actual.list)
    {
        verdict.message += " Look at " + (isSeen ? files.ActualPicture() : files.ActualList()) +
                           "; if it is right,";
    }
    else
    {
        verdict.message += " If it is right,";
    }
    verdict.message += " run `boxreel golden accept " + verdict.name + "`.";
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
        verdict.message +=
            " Look at " + files.SideBySidePicture() +
            " (expected, actual, difference; each lies beside it, as do the draw lists).";
    }
    else if (actual.list)
    {
        verdict.message +=
            " The draw lists are " + files.ExpectedList() + " and " + files.ActualList() + ".";
    }
    return verdict;
}

} // namespace

ReferenceStore::ReferenceStore(std::filesystem::path references, std::filesystem::path output)
    : m_references(std::move(references)), m_output(std::move(output))
{}

Result<GoldenVerdict> ReferenceStore::Verify(const GoldenCandidate& candidate,
                                             const CompareSettings& settings) const
{
    GoldenVerdict verdict;
    verdict.name = candidate.name;
    if (const std::string why = WhyNotUsable(candidate.name); !why.empty())
    {
        return Unusable(candidate.name, why);
    }
    const Result<Moment> expected = ReadReference(m_references, candidate.name);
    if (!expected)
    {
        return expected.GetError();
    }
    const Result<FailureFiles> files = FailureFiles::At(m_output, candidate.name);
    if (!files)
    {
        return files.GetError();
    }
    if (const Result<void> removed = files->Remove(); !removed)
    {
        return removed.GetError();
    }
    const Moment actual = Take(candidate, *expected);
    if (!MissingFiles(candidate.name, *expected, actual).empty())
    {
        return ReportMissing(std::move(verdict), *files, *expected, actual, m_references);
    }

    Differences differences;
    differences.state = actual.state && *actual.state != *expected->state;
    if (actual.list)
    {
        differences.list = FirstDifference(*expected->list, *actual.list);
    }
    if (actual.frame)
    {
        verdict.pixels = Compare(*expected->frame, *actual.frame, settings);
        differences.pixels = !verdict.pixels.equal;
    }
    verdict.status = StatusOf(differences);
    verdict.message =
        candidate.name + ": " + Explain(*expected, actual, differences, verdict.pixels) + ".";
    if (verdict.status == GoldenStatus::Same)
    {
        return verdict;
    }
    return ReportDifferent(std::move(verdict), *files, *expected, actual);
}

Result<void> ReferenceStore::Accept(const GoldenCandidate& candidate) const
{
    if (const std::string why = WhyNotUsable(candidate.name); !why.empty())
    {
        return Unusable(candidate.name, why);
    }
    return Store(m_references, candidate.name, Take(candidate, Moment{}));
}

std::vector<std::string> ReferenceStore::Names() const
{
    return ReferenceNames(m_references);
}

} // namespace boxreel
