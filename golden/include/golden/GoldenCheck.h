// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <golden/ReferenceStore.h>

#include <filesystem>
#include <set>
#include <string>

/// @file
/// A golden test for any test framework: compares with the reference, or accepts the candidate as
/// reference if the environment requests it. GoldenTest.h calls it for GoogleTest. Prints nothing;
/// output is returned.
namespace boxreel
{

/// The candidates to accept. A candidate equal to its reference is never accepted, so that no file
/// changes without need.
enum class GoldenAccept
{
    None,
    Missing,      ///< those without a reference
    Changed,      ///< those that differ, or whose reference is damaged
    All,          ///< both
    ThisRenderer, ///< those that differ only in pixels, for their renderer only
};

/// The folders and mode of golden tests.
struct GoldenCheckSettings
{
    std::filesystem::path references;               ///< folder of the references
    std::filesystem::path output = "golden-output"; ///< the folder for the pictures of a failure
    GoldenAccept accept = GoldenAccept::None;       ///< candidates to accept instead of comparing
    bool attach = false; ///< print the pictures of a failure in lines that CTest sends to CDash
};

/// Reads BOXREEL_GOLDEN_REFERENCES (default `references`), BOXREEL_GOLDEN_OUTPUT and
/// BOXREEL_GOLDEN_ACCEPT. A shard of GoogleTest has its own folder in the output. Pictures are
/// attached under CTest and if CI is set. Unusable without a folder, or for an unknown mode.
Result<GoldenCheckSettings> GoldenSettingsFromEnvironment(const std::filesystem::path& references);

/// Returns Renderer::Fingerprint() of this process's default back end (Backend::Auto), for pictures
/// without a known renderer. Empty if no back end works.
std::string DefaultFingerprint();

/// The result of a golden test.
struct GoldenOutcome
{
    bool passed = false; ///< true if the test passed
    std::string message; ///< one or two sentences, with the remedy if the test failed
    std::string output;  ///< lines for standard output, or empty
};

/// Compares or accepts the candidate. `accepted`: the names accepted in this run, kept by the
/// caller. A second candidate of such a name is compared, never accepted. Otherwise two tests with
/// the same name would replace each other's reference in every run.
GoldenOutcome CheckGolden(const GoldenCandidate& candidate, const CompareSettings& compare,
                          const GoldenCheckSettings& settings, std::set<std::string>& accepted);

} // namespace boxreel
