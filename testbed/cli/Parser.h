// SPDX-License-Identifier: MIT
#pragma once

#include "Declare.h"

#include <string>
#include <vector>

/// Reads the command line into the options that commands declare. The only place that knows CLI11.
namespace boxreel
{

/// The words of the command line.
struct ParsedLine
{
    enum class Kind
    {
        Run,
        Help,
        Version,
    };
    Kind kind = Kind::Run;
    const Command* command = nullptr; ///< the innermost that was given
};

/// Calls the readers of the options that were given, in the order of their declaration, then
/// `finish` of the command. Sets `wasGiven` of both. Returns the first error.
/// `arguments`: without the program's name; at least one.
Result<ParsedLine> Parse(Command& program, const std::vector<std::string>& arguments);

} // namespace boxreel
