// SPDX-License-Identifier: MIT
#pragma once

#include "Shot.h"

namespace boxreel
{

/// Options of a still: its moments, what shows motion in it, and what is written beside it.
void AddMotion(Command& command, ShotOptions& shot);

/// Checks the options for contradictions, also with a panel.
Result<void> CheckMotion(const ShotOptions& options);

} // namespace boxreel
