// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Runs another program for a command, such as another build of boxreel.
namespace boxreel
{

/// Limits of time and output for a foreign program; it is ended when it exceeds them.
struct ChildBounds
{
    std::size_t output = 0; ///< maximum of its standard output [bytes]
    double wall = 0.0;      ///< longest that it may run [s]
};

/// Runs a program to its end and returns its standard output. Its standard error is that of this
/// process. An Error if it cannot be started, exits with another code than 0 or exceeds its bounds.
Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments, const ChildBounds& bounds);

} // namespace boxreel
