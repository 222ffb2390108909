// SPDX-License-Identifier: MIT
#pragma once

#include <golden/ReferenceStore.h>

#include <span>
#include <string>
#include <string_view>

/// The texts of verdicts. No other file forms sentences of them.
namespace boxreel
{

struct StatusWords
{
    const char* word;    ///< in verdict files
    const char* label;   ///< in reports
    const char* meaning; ///< in reports
    bool passes;         ///< true if the moment counts as approved
};

/// Returns all statuses of verdict files, the worst first.
std::span<const StatusWords> AllStatusWords();

/// Returns the status of this word, or null.
const StatusWords* FindStatus(std::string_view word);

/// Returns the word in verdict files.
const char* StatusWord(GoldenStatus status);

/// Returns "as given", "same renderer" or "other renderer".
const char* LimitsWord(LimitsChoice choice);

} // namespace boxreel
