// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"

#include <base/Result.h>

#include <string>
#include <string_view>

namespace boxreel
{

/// What a scene file does not say and gets by the format's defaults, where these are not the
/// engine's and surprise, and what readers of today make of old spellings. For a text that
/// ParseRubeScene has taken; an Error else.
Result<RubeNotes> RubeTraps(std::string_view text, const std::string& source);

} // namespace boxreel
