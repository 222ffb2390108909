// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <base/Result.h>

#include <string>
#include <string_view>

namespace boxreel
{

/// Reads the text of a R.U.B.E. / b2dJson scene file into plain data. Creates no world and opens no
/// file. Accepts text from any source. A part that is malformed, of the wrong type, not finite or
/// out of range is an Error that names `source` and the place. Parts that the format allows but the
/// engine cannot build stay in the data, so the builder can name them.
Result<RubeScene> ParseRubeScene(std::string_view text, const std::string& source);

/// True if ParseRubeScene accepts this as a mass: within its limits, and not 0.
bool IsReadableMass(const b2MassData& data);

} // namespace boxreel
