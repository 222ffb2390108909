// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

/// A command of the program is a struct of options with three functions beside it: `Declare` its
/// options to the parser, `Check` whether they fit together, `Run` it. CommandLine.h lists all.
namespace boxreel
{

struct Command; // of Declare.h

/// For commands whose options always fit together.
template <class Options>
Result<void> Check(Options& options)
{
    (void)options;
    return {};
}

} // namespace boxreel
