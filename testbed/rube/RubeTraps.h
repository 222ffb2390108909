// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace boxreel
{

/// What a scene file does not say and gets by the format's defaults, where these are not the
/// engine's and surprise, and what readers of today make of spellings of old: one sentence each, in
/// the order of the file, at most a thousand and one that counts the others. For a text that
/// ParseRubeScene has taken; an Error else.
Result<std::vector<std::string>> RubeTraps(std::string_view text, const std::string& source);

} // namespace boxreel
