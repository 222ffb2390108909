// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Reads the verdicts that golden tests and `boxreel golden verify` write to their output folders
/// (NAME.verdict.json), and merges those of shards. Called by `boxreel golden report`; does not
/// draw or compare.
namespace boxreel
{

/// One verdict file.
struct ReportedVerdict
{
    std::string name;   ///< of the moment
    std::string status; ///< word of a verdict file: "pixels", or "accepted" in this run
    std::vector<std::string> findings; ///< differences
    std::string accept;                ///< command that accepts the candidate; empty: inspect first
    std::string renderer;              ///< of the actual picture
    std::string limits;                ///< as text; empty: nothing was compared
    std::optional<std::int64_t> firstStep; ///< first step at which the worlds, or a film, differ
    std::vector<int> firstBodies;          ///< numbers of the bodies that differ there
    std::optional<std::int64_t> lastStep;  ///< step of the moment itself; none: not stored
    std::string firstHash;      ///< hash of the actual world at that step, 8 hex digits; empty: no
                                ///< world
    std::string json;           ///< the whole file, for the page's script; one line, without '<'
    std::string data;           ///< what tells it from another verdict on the same moment
    std::string folder;         ///< folder, for display
    std::filesystem::path base; ///< prefix of the files: base + ".expected.png" and so on
    /// True if the moment is as approved.
    bool Passed() const;
};

/// A moment, merged over all folders.
struct ReportedMoment
{
    ReportedVerdict shown;               ///< the worst verdict
    std::vector<ReportedVerdict> others; ///< different verdicts of other folders
};

/// Reads all verdicts, sorted by name. An invalid file becomes one of the status "error". Unusable
/// when a folder does not exist or has no verdict.
Result<std::vector<ReportedMoment>>
CollectVerdicts(const std::vector<std::filesystem::path>& folders);

/// Returns the bytes as a quoted JSON string without '<', for use in a page.
std::string JsonText(const std::string& bytes);

} // namespace boxreel
