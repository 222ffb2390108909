// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <base/Result.h>

#include <string>
#include <string_view>

namespace boxreel
{

/// Reads the text of a R.U.B.E. / b2dJson scene file into plain data. Called by whoever loads or
/// checks scene files. Creates no world, opens no file, and takes any text from anywhere: what is
/// malformed, of the wrong kind, not finite or out of range is an Error that names `source` and the
/// place. What the format allows and the engine cannot build stays in the data, for the builder to
/// name.
Result<RubeScene> ParseRubeScene(std::string_view text, const std::string& source);

/// Whether ParseRubeScene takes this as a mass: within its limits, and not 0.
bool IsReadableMass(const b2MassData& data);

} // namespace boxreel
