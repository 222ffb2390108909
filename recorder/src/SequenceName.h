// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// The names of pictures that make a film: one place for the number.
namespace boxreel
{

/// "frames-####.png" taken apart.
struct SequenceName
{
    std::filesystem::path folder;
    std::string before;
    std::string after;
    int digits = 0;

    /// The path of picture `number`; a number with more digits than # is written out.
    std::filesystem::path PathOf(std::int64_t number) const;
    /// The number in a name of this sequence, as PathOf would write it.
    std::optional<std::int64_t> NumberIn(const std::string& name) const;
};

/// Nothing when the name has no #. The last run of # is the number's place.
std::optional<SequenceName> ParseSequenceName(const std::filesystem::path& path);

} // namespace boxreel
