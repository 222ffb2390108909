// SPDX-License-Identifier: MIT
#pragma once

#include <golden/ReferenceStore.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The texts of verdicts. No other file forms sentences of them.
namespace boxreel
{

struct StatusWords
{
    std::optional<GoldenStatus> status; ///< none: accepted in this run
    const char* word;                   ///< in verdict files
    const char* label;                  ///< in reports
    const char* meaning;                ///< in reports
    bool passes;                        ///< true if the moment counts as approved
};

/// Returns the only table of the statuses of verdict files, the worst first.
std::span<const StatusWords> AllStatusWords();

/// Returns the status of this word, or null.
const StatusWords* FindStatus(std::string_view word);

/// Returns the word in verdict files. None: accepted in this run.
const char* StatusWord(std::optional<GoldenStatus> status);

/// Returns "as given", "same renderer" or "other renderer".
const char* LimitsWord(LimitsChoice choice);

} // namespace boxreel
