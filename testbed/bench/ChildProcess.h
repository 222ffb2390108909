// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace boxreel
{

/// Runs a program to its end and returns what it wrote to its standard output; its standard error
/// is ours. An error when it cannot be started or ends with another code than 0.
Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments);

} // namespace boxreel
