// SPDX-License-Identifier: MIT
#pragma once

#include "Shot.h"

namespace boxreel
{

/// Options of a still: its moments, the display of motion, and its annotations.
void AddMotion(Command& command, ShotOptions& shot);

/// Checks the options for contradictions, also with a panel.
Result<void> CheckMotion(const ShotOptions& options);

} // namespace boxreel
