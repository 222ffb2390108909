// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <golden/ReferenceStore.h>

#include <filesystem>
#include <set>
#include <string>

/// @file
/// What one golden test does, for any framework of tests: compares with the reference, or makes the
/// candidate the reference when the environment asks for it. GoldenTest.h calls it for GoogleTest.
/// Prints nothing; what should be printed is handed back.
namespace boxreel
{

/// Which candidates become references; one that is the same as its reference never does, so that no
/// file changes without need.
enum class GoldenAccept
{
    None,
    Missing,      ///< those without a reference
    Changed,      ///< those that differ from theirs, or whose reference is damaged
    All,          ///< both
    ThisRenderer, ///< those that differ in pixels alone: for the renderer that drew them alone
};

/// What a golden test compares with, and what it may change.
struct GoldenCheckSettings
{
    std::filesystem::path references;               ///< the folder of what was approved
    std::filesystem::path output = "golden-output"; ///< the folder for the pictures of a failure
    GoldenAccept accept = GoldenAccept::None;       ///< what is taken over instead of compared
    bool attach = false; ///< name the pictures of a failure in lines that CTest sends to CDash
};

/// From BOXREEL_GOLDEN_REFERENCES (`references` when that is not set), BOXREEL_GOLDEN_OUTPUT,
/// BOXREEL_GOLDEN_ACCEPT. A shard of GoogleTest has a folder of its own in the output. Pictures are
/// attached under CTest and where CI is set. Unusable when no folder or no such word is given.
Result<GoldenCheckSettings> GoldenSettingsFromEnvironment(const std::filesystem::path& references);

/// Renderer::Fingerprint() of the back end that this process draws with unless it names another one
/// (Backend::Auto), for a picture that does not say who drew it. Empty where no back end works.
std::string DefaultFingerprint();

/// What a golden test says.
struct GoldenOutcome
{
    bool passed = false; ///< whether the test has passed
    std::string message; ///< a sentence or two, with the remedy when it has not passed
    std::string output;  ///< whole lines for standard output, or nothing
};

/// `accepted`: the names that this run has made references, kept by the caller. A second candidate
/// of such a name is compared, never accepted: two tests that share a name would otherwise replace
/// each other's reference in every such run.
GoldenOutcome CheckGolden(const GoldenCandidate& candidate, const CompareSettings& compare,
                          const GoldenCheckSettings& settings, std::set<std::string>& accepted);

} // namespace boxreel
