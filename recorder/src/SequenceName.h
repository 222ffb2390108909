// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// File names of picture sequences, with one place for the number.
namespace boxreel
{

/// The parts of "frames-####.png".
struct SequenceName
{
    std::filesystem::path folder;
    std::string before;
    std::string after;
    int digits = 0;

    /// Returns the path of picture `number`; a number with more digits than # is written in full.
    std::filesystem::path PathOf(std::int64_t number) const;
    /// Returns the number in a name of this sequence, in the format of PathOf.
    std::optional<std::int64_t> NumberIn(const std::string& name) const;
};

/// Parses a name; empty without a #. The last run of # is the number's place.
std::optional<SequenceName> ParseSequenceName(const std::filesystem::path& path);

} // namespace boxreel
