// SPDX-License-Identifier: MIT
#pragma once

#include "CommandTree.h"

#include <CLI/App.hpp>

#include <string>

/// What the parser knows of the commands, as help and as data.
namespace boxreel
{

/// To be called before commands are declared, which inherit the format.
void SetHelpFormat(CLI::App& program);

/// The help of the command that was named, or of the program if none was.
std::string HelpOf(const CLI::App& program);

CommandText DescribeCommands(CLI::App& program);

} // namespace boxreel
