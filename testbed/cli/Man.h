// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

namespace boxreel
{

struct ManOptions
{};

/// Declares `boxreel man` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, ManOptions& options);

/// Prints the manual page in roff.
Result<int> Run(const ManOptions& options);

} // namespace boxreel
