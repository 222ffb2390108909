// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// The verdicts that golden tests and `boxreel golden verify` leave below their output folders
/// (NAME.verdict.json), those of shards merged. Called by `boxreel golden report`; draws nothing
/// and compares nothing.
namespace boxreel
{

/// One file.
struct ReportedVerdict
{
    std::string name;
    std::string status; ///< "same", "missing", "state", "drawlist", "pixels", "error", "accepted"
    std::vector<std::string> findings; ///< what differs
    std::string accept; ///< the command that makes it the reference; empty: look first
    std::string renderer;
    std::string limits;                    ///< in words; empty: nothing was compared
    std::optional<std::int64_t> firstStep; ///< at which the worlds, or a film, part
    std::vector<int> firstBodies;
    std::optional<std::int64_t> lastStep; ///< of the moment itself; none: no step is kept
    std::string firstHash;      ///< what this side's world was there, 8 hex digits; empty: no world
    std::string json;           ///< the whole file, for the page's script; one line, no '<'
    std::string folder;         ///< where it was found, for a person
    std::filesystem::path base; ///< beside it lie base + ".expected.png" and so on
    bool Passed() const { return status == "same"; }
};

/// A name, once, whatever the number of folders that have it.
struct ReportedMoment
{
    ReportedVerdict shown;               ///< what is worst of it
    std::vector<ReportedVerdict> others; ///< of other folders, when they say something else
};

/// Sorted by name. A file that is no verdict becomes one of the status "error". Unusable when a
/// folder is not there or has no verdict.
Result<std::vector<ReportedMoment>>
CollectVerdicts(const std::vector<std::filesystem::path>& folders);

/// Any bytes as JSON's text of them, in quotes, without '<', so that it may stand in a page.
std::string JsonText(const std::string& bytes);

} // namespace boxreel
