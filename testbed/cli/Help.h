// SPDX-License-Identifier: MIT
#pragma once

#include "CommandTree.h"

#include <string>

namespace boxreel
{

/// What `boxreel COMMAND --help` prints.
std::string HelpOf(const CommandText& command);

} // namespace boxreel
