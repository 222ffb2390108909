// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

namespace boxreel
{

/// Options of `boxreel doctor`.
struct DoctorOptions
{};

/// Declares `boxreel doctor` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, DoctorOptions& options);

/// Tests what the program needs.
Result<int> Run(const DoctorOptions& options);

} // namespace boxreel
