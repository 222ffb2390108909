// SPDX-License-Identifier: MIT
#pragma once

#include "CommandTree.h"

#include <string>

namespace boxreel
{

/// Returns the output of `boxreel COMMAND --help`.
std::string HelpOf(const CommandText& command);

} // namespace boxreel
