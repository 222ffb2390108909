// SPDX-License-Identifier: MIT
#pragma once

#include "../testbed/cli/Subprocess.h"

#include <string>

/// Pages as a reader has them: in Chromium, without a window.
namespace boxreel
{

/// The command of Chromium; empty when there is none.
std::string Chromium();

/// What a page has become at its end, with a script behind it. Files are made in the folder.
Outcome LoadInChromium(const std::string& browser, const std::string& page,
                       const std::string& script, const TemporaryFolder& folder);

/// What the script has left between the lines BEGIN and END of an element.
std::string ResultsOf(const Outcome& outcome);

} // namespace boxreel
