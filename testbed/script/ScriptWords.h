// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace boxreel
{

/// Returns the words of one line of a script, separated by blanks. Double quotes keep blanks, also
/// inside a word (--caption="two words"). A # at the start of a word begins a comment. Error
/// (Unusable) if a quote is not closed.
Result<std::vector<std::string>> WordsOf(std::string_view line);

/// The words as one line that WordsOf takes apart again.
std::string LineOf(const std::vector<std::string>& words);

} // namespace boxreel
