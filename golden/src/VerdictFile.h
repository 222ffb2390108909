// SPDX-License-Identifier: MIT
#pragma once

#include <golden/Compare.h>
#include <golden/ReferenceStore.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The result of a comparison for programs: NAME.verdict.json in the output folder, for success and
/// failure. Written by the reference store, read by `boxreel golden report`.
namespace boxreel
{

/// The content of the file.
struct VerdictRecord
{
    const GoldenVerdict& verdict;
    const GoldenCandidate& candidate;
    const CompareSettings& limits;
};

/// Returns JSON (RFC 8259), one field per line.
std::string ToJson(const VerdictRecord& record);

/// Returns the verdict with the status of an accepted candidate; none if the text is not a verdict.
std::optional<std::string> Accepted(std::string_view json);

} // namespace boxreel
