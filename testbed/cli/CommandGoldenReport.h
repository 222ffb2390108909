// SPDX-License-Identifier: MIT
#pragma once

#include "Commands.h"

#include <base/Result.h>

#include <set>
#include <string>

namespace boxreel
{

/// Writes the page, whole or not at all, and says so in a line. `only`: the names that are in it;
/// empty: all.
Result<void> WriteGoldenReport(const GoldenReportOptions& options,
                               const std::set<std::string>& only);

/// Whether a page may be written there: nothing is replaced but a page like it.
Result<void> CheckGoldenReportPath(const std::filesystem::path& path, bool force);

/// build/golden-output of the checkout around the current folder, or golden-output.
std::filesystem::path DefaultGoldenOutput();

} // namespace boxreel
