// SPDX-License-Identifier: MIT
#pragma once

#include <cli/CommandLine.h>

#include <sstream>
#include <string>
#include <vector>

/// For tests of the command line.
namespace boxreel
{

/// The request of a command line written as a person would, words apart by spaces.
inline Result<Request> Parse(const std::string& line)
{
    std::istringstream words(line);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;)
    {
        arguments.push_back(word);
    }
    return ParseCommandLine(arguments);
}

} // namespace boxreel
