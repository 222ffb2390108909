// SPDX-License-Identifier: MIT
#pragma once

#include <golden/Compare.h>
#include <golden/ReferenceStore.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// What a comparison came to, for programs: NAME.verdict.json in the output folder, whether it
/// passed or not. Written by the reference store, read by `boxreel golden report`.
namespace boxreel
{

/// Everything that the file says.
struct VerdictRecord
{
    const GoldenVerdict& verdict;
    const GoldenCandidate& candidate;
    const CompareSettings& limits;
};

/// As JSON (RFC 8259), a field a line.
std::string ToJson(const VerdictRecord& record);

/// The same verdict, now of something that has become the reference; none when the text is none.
std::optional<std::string> Accepted(std::string_view json);

} // namespace boxreel
