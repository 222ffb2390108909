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
