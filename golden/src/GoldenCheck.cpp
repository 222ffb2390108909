// SPDX-License-Identifier: MIT
#include <golden/GoldenCheck.h>

#include "FailureFiles.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>
#include <render/Renderer.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

/// Returns the value; empty if it is not set.
std::string Environment(const char* name)
{
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

Result<GoldenAccept> AcceptOf(const std::string& word)
{
    if (word.empty())
    {
        return GoldenAccept::None;
    }
    if (word == "missing")
    {
        return GoldenAccept::Missing;
    }
    if (word == "changed")
    {
        return GoldenAccept::Changed;
    }
    if (word == "all")
    {
        return GoldenAccept::All;
    }
    if (word == "this-renderer")
    {
        return GoldenAccept::ThisRenderer;
    }
    return NotOneOf("BOXREEL_GOLDEN_ACCEPT", word, {"missing", "changed", "all", "this-renderer"});
}

bool IsToBeAccepted(const GoldenVerdict& verdict, GoldenAccept accept)
{
    const GoldenStatus status = verdict.status;
    const bool wouldNotHelp = status == GoldenStatus::NotCompared && verdict.accept.empty();
    if (status == GoldenStatus::Same || wouldNotHelp || accept == GoldenAccept::None)
    {
        return false;
    }
    if (accept == GoldenAccept::ThisRenderer)
    {
        return status == GoldenStatus::Pixels;
    }
    return accept == GoldenAccept::All ||
           (status == GoldenStatus::Missing) == (accept == GoldenAccept::Missing);
}

/// Replaces the program's command to accept by that of a test.
std::string RemedyOfTest(const GoldenVerdict& verdict)
{
    const bool isMissing = verdict.status == GoldenStatus::Missing;
    return std::string("run this test once with BOXREEL_GOLDEN_ACCEPT=") +
           (isMissing ? "missing" : "changed") + " in the environment";
}

/// True for digits only, because the value names a folder.
bool IsNumber(const std::string& text)
{
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// CDash overlays the first three of these names (`cmake --help-command ctest_test`, "Image
/// Measurements").
std::string Attachments(const fs::path& output, const std::string& name)
{
    constexpr const char* kPictures[][2] = {{"TestImage", ".actual.png"},
                                            {"ValidImage", ".expected.png"},
                                            {"DifferenceImage2", ".difference.png"},
                                            {"SideBySide", ".side-by-side.png"}};
    std::string lines;
    for (const auto& [measurement, suffix] : kPictures)
    {
        std::error_code error;
        const fs::path path = fs::absolute(output / (name + suffix), error);
        if (!error && fs::is_regular_file(path, error))
        {
            lines += std::string("<CTestMeasurementFile type=\"image/png\" name=\"") + measurement +
                     "\">" + MarkupEscaped(path.string()) + "</CTestMeasurementFile>\n";
        }
    }
    return lines;
}

} // namespace

Result<GoldenCheckSettings> GoldenSettingsFromEnvironment(const fs::path& references)
{
    GoldenCheckSettings settings;
    const std::string folder = Environment("BOXREEL_GOLDEN_REFERENCES");
    settings.references = folder.empty() ? references : fs::path(folder);
    if (settings.references.empty())
    {
        return Error{ErrorKind::Unusable, "BOXREEL_GOLDEN_REFERENCES",
                     "is not set, and no folder of references is given",
                     "set it, or pass REFERENCES DIR to boxreel_add_golden_tests"};
    }
    if (const std::string output = Environment("BOXREEL_GOLDEN_OUTPUT"); !output.empty())
    {
        settings.output = output;
    }
    // Shards run concurrently, and each removes its own earlier failures.
    const std::string shards = Environment("GTEST_TOTAL_SHARDS");
    if (!shards.empty() && shards != "1")
    {
        const std::string index = Environment("GTEST_SHARD_INDEX");
        if (!IsNumber(shards) || !IsNumber(index))
        {
            return Error{ErrorKind::Unusable,
                         AsTyped("GTEST_SHARD_INDEX", index) + ", " +
                             AsTyped("GTEST_TOTAL_SHARDS", shards),
                         "must be whole numbers"};
        }
        settings.output /= "shard-" + index + "-of-" + shards;
    }
    ASSIGN_OR_RETURN(settings.accept, AcceptOf(Environment("BOXREEL_GOLDEN_ACCEPT")));
    // ctest sets one of the first two for its tests, depending on its version and on who started it
    // (`cmake --help-manual cmake-env-variables`).
    for (const char* const sign :
         {"CTEST_INTERACTIVE_DEBUG_MODE", "DASHBOARD_TEST_FROM_CTEST", "CI"})
    {
        settings.attach = settings.attach || !Environment(sign).empty();
    }
    return settings;
}

std::string DefaultFingerprint()
{
    const Result<Renderer> renderer = Renderer::Create({.width = 1, .height = 1});
    const Result<std::string> fingerprint =
        renderer ? renderer->Fingerprint() : Result<std::string>(renderer.GetError());
    return fingerprint ? *fingerprint : "";
}

GoldenOutcome CheckGolden(const GoldenCandidate& candidate, const CompareSettings& compare,
                          const GoldenCheckSettings& settings, std::set<std::string>& accepted)
{
    const ReferenceStore store(settings.references, settings.output);
    const Result<GoldenVerdict> verdict = store.Verify(candidate, compare);
    if (!verdict)
    {
        return {false, verdict.GetError().Text(), ""};
    }
    if (verdict->status == GoldenStatus::Same)
    {
        return {true, verdict->Text(), ""};
    }
    const bool isWanted = IsToBeAccepted(*verdict, settings.accept);
    if (isWanted && accepted.insert(candidate.name).second)
    {
        const AcceptAs as = settings.accept == GoldenAccept::ThisRenderer
                                ? AcceptAs::ForThisRenderer
                                : AcceptAs::TheOneCompared;
        if (const Result<void> stored = store.Accept(candidate, as); !stored)
        {
            return {false, stored.GetError().Text(), ""};
        }
        // So that a report does not list it as a failure. Its pictures are kept for inspection.
        const Result<FailureFiles> files = FailureFiles::At(settings.output, candidate.name);
        const Result<void> noted = files ? files->NoteAccepted() : files.GetError();
        if (!noted)
        {
            return {false, noted.GetError().Text(), ""};
        }
        return {true, verdict->Text(), "accepted  " + verdict->AcceptedText() + "\n"};
    }
    const std::string message =
        isWanted ? verdict->Text(
                       "give each check its own name: this name was accepted before in this run")
                 : verdict->Text(RemedyOfTest(*verdict));
    return {false, message, settings.attach ? Attachments(settings.output, candidate.name) : ""};
}

} // namespace boxreel
