// SPDX-License-Identifier: MIT
#pragma once

#include <golden/Compare.h>
#include <golden/ReferenceStore.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// What a comparison came to, for programs: NAME.verdict.json in the output folder, whether it
/// passed or not. Written by the reference store, read by `boxreel golden report`. Only writes: so
/// that who links this library needs no parser.
namespace boxreel
{

/// Everything that the file says. What points to nothing is not known.
struct VerdictRecord
{
    std::string_view name;
    std::string_view status;  ///< StatusWord
    std::string_view message; ///< what differs, without what to do about it
    std::string_view accept;  ///< the command that makes it the reference; empty: look first
    const GoldenCandidate* candidate = nullptr;
    const CompareSettings* limits = nullptr;
    const Comparison* pixels = nullptr;
    std::optional<std::int64_t> firstStep{}; ///< at which the worlds, or the film, part
    std::vector<int> firstBodies{};          ///< which part there, as far as it can be told
    LimitsChoice limitsChoice = LimitsChoice::AsGiven;
};

/// "same", "missing", "state", "drawlist", "pixels", or "error" for what could not be compared.
const char* StatusWord(GoldenStatus status);

/// "as given", "same renderer" or "other renderer".
const char* LimitsWord(LimitsChoice choice);

/// As JSON (RFC 8259), a field a line.
std::string ToJson(const VerdictRecord& record);

/// The same verdict, now of something that has become the reference; none when the text is none.
std::optional<std::string> Accepted(std::string_view json);

} // namespace boxreel
