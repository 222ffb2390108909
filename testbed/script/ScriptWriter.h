// SPDX-License-Identifier: MIT
#pragma once

#include "Script.h"

#include <string>

namespace boxreel
{

/// The script as text, in the order of its moments: ParseScript gives the same one back, but for
/// file and lines. Numbers are written so that not a bit of them is lost.
std::string WriteScript(const Script& script);

} // namespace boxreel
