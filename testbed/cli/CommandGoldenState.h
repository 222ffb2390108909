// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <session/GoldenScenes.h>

#include <filesystem>
#include <string>

namespace boxreel
{

/// The program as a path that is run as it stands, wherever PATH leads; Unusable when it is none.
Result<std::filesystem::path> FindOtherProgram(const std::filesystem::path& program);

/// Where this program's states of a scene part from those of another build, which is run: a
/// sentence with the first step, the bodies, and by how much they differ there. Empty when all
/// steps are the same. `program`: as FindOtherProgram gives it.
Result<std::string> CompareWith(const std::filesystem::path& program,
                                const GoldenSelection& selection);

} // namespace boxreel
