// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The `boxreel` program without its main function, so that tests can link all of it.
namespace boxreel
{

/// Understands the arguments (without the program's name), runs the command, says on standard error
/// what went wrong, and returns the exit code.
int RunProgram(const std::vector<std::string>& arguments);

} // namespace boxreel
