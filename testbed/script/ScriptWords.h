// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace boxreel
{

/// The words of one line of a script: between blanks; a word in double quotes may have blanks, and
/// may be glued to what stands before it (--caption="two words"); from a # at the start of a word
/// on it is a remark. An Error (Unusable) when a quote is not closed.
Result<std::vector<std::string>> WordsOf(std::string_view line);

/// The words as one line that WordsOf takes apart again.
std::string LineOf(const std::vector<std::string>& words);

} // namespace boxreel
