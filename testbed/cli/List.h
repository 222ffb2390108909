// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

namespace boxreel
{

struct ListOptions
{
    bool namesOnly = false;
};

/// Declares `boxreel list` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, ListOptions& options);

/// Prints the scenes.
Result<int> Run(const ListOptions& options);

} // namespace boxreel
