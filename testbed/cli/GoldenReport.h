// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <render/Backend.h>

#include <filesystem>

#include <set>
#include <string>

namespace boxreel
{

/// A page of what golden tests found.
struct GoldenReportOptions
{
    std::vector<std::filesystem::path> folders; ///< that they wrote to; empty: as of verify
    std::filesystem::path output;               ///< empty: report.html in the first of them
    std::filesystem::path against; ///< a program whose steps are shown beside ours; empty: none
    Backend backend = Backend::Auto;
    bool force = false; ///< overwrite a file that is not a report
};

/// Declares `boxreel golden report` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, GoldenReportOptions& options);

/// Writes the page.
Result<int> Run(const GoldenReportOptions& options);

/// Writes the page atomically, and prints a line. `only`: the names on it; empty: all.
Result<void> WriteGoldenReport(const GoldenReportOptions& options,
                               const std::set<std::string>& only);

/// Checks that a page may be written there. Only a report page may be replaced.
Result<void> CheckGoldenReportPath(const std::filesystem::path& path, bool force);

/// build/golden-output of the checkout around the current folder, or golden-output.
std::filesystem::path DefaultGoldenOutput();

} // namespace boxreel
