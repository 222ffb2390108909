// SPDX-License-Identifier: MIT
#pragma once

#include <golden/ReferenceStore.h>

#include <span>
#include <string>
#include <string_view>

/// The words of verdicts. No other file makes sentences of them.
namespace boxreel
{

struct StatusWords
{
    const char* word;    ///< in verdict files
    const char* label;   ///< in reports
    const char* meaning; ///< in reports
    bool passes;         ///< whether the moment counts as approved
};

/// All statuses that a verdict file may have, the worst first.
std::span<const StatusWords> AllStatusWords();

/// Null when no status has this word.
const StatusWords* FindStatus(std::string_view word);

/// The word of verdict files.
const char* StatusWord(GoldenStatus status);

/// "as given", "same renderer" or "other renderer".
const char* LimitsWord(LimitsChoice choice);

/// Of a list.
std::string Join(const std::vector<std::string>& parts, const char* between);

} // namespace boxreel
