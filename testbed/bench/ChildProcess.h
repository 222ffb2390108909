// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace boxreel
{

/// What a program may take that somebody else wrote; one that takes more is ended.
struct ChildBounds
{
    std::size_t output = 0; ///< most that it may write to its standard output [bytes]
    double wall = 0.0;      ///< longest that it may run [s]
};

/// Runs a program to its end and returns what it wrote to its standard output; its standard error
/// is ours. An error when it cannot be started, ends with another code than 0 or leaves its bounds,
/// if it has any.
Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments,
                             const std::optional<ChildBounds>& bounds = {});

/// What a program needed, with all programs that it started and waited for.
struct ChildRun
{
    std::string output;  ///< standard output and error
    double wall = 0.0;   ///< from the start to the end [s]
    double cpu = 0.0;    ///< [s]
    double memory = 0.0; ///< most that one of them had at once; never less than we have [bytes]
    int code = 0;        ///< it ended with
};

/// The same, measured. A name without a folder is looked for as a shell does. The error's sentence
/// ends with the program's last words. `otherCode`: ending with this one is no error either.
Result<ChildRun> RunMeasured(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments, int otherCode = 0);

} // namespace boxreel
