// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"

#include <base/Result.h>

#include <string>
#include <string_view>

namespace boxreel
{

/// Returns the surprising parts of a scene file. These are omitted values whose default in the
/// format differs from the engine's, and old spellings that today's readers interpret differently.
/// Requires a text that ParseRubeScene has accepted; otherwise returns an Error.
Result<RubeNotes> RubeTraps(std::string_view text, const std::string& source);

} // namespace boxreel
