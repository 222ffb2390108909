// SPDX-License-Identifier: MIT
#pragma once

#include "CommandTree.h"
#include "Commands.h"

#include <string>
#include <variant>
#include <vector>

/// What the user typed, understood and checked as far as that goes without opening anything. Only
/// CommandLine*.cpp know the library that parses.
namespace boxreel
{

/// `--help`, `--version`, `man`: text to print instead of doing anything.
struct TextRequest
{
    std::string text;
};

using Request = std::variant<TextRequest, ListOptions, RecordOptions, MergeOptions, ShotOptions,
                             DiffOptions, GoldenOptions, GoldenReportOptions, GoldenStateOptions,
                             PlayOptions, CheckOptions, ExportOptions, DoctorOptions, UiOptions>;

/// `arguments`: without the program's name. An Error (Unusable) is one sentence with the remedy.
Result<Request> ParseCommandLine(const std::vector<std::string>& arguments);

/// What ParseCommandLine understands.
CommandText DescribeProgram();

} // namespace boxreel
