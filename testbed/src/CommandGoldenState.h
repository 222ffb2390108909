// SPDX-License-Identifier: MIT
#pragma once

#include "GoldenScenes.h"

#include <debugdraw/Result.h>

#include <filesystem>
#include <string>

namespace boxreel
{

/// Where this program's states of a scene part from those of another build, which is run: a
/// sentence with the first step, the bodies, and by how much they differ there. Empty when all
/// steps are the same.
Result<std::string> CompareWith(const std::filesystem::path& program,
                                const GoldenSelection& selection);

} // namespace boxreel
