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

/// What a program may take that somebody else wrote; one that takes more is ended.
struct ChildBounds
{
    std::size_t output = 0; ///< most that it may write to its standard output [bytes]
    double wall = 0.0;      ///< longest that it may run [s]
};

/// Runs a program to its end and returns what it wrote to its standard output; its standard error
/// is ours. An error when it cannot be started, ends with another code than 0 or leaves its bounds.
Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments, const ChildBounds& bounds);

} // namespace boxreel
