// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <filesystem>
#include <vector>

namespace boxreel
{

/// Parts of a film become the whole.
struct MergeOptions
{
    std::vector<std::filesystem::path> parts;
    std::filesystem::path output;
    bool force = false;
    bool partial = false; ///< a piece of the film will do
};

/// Declares `boxreel merge` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, MergeOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(MergeOptions& options);

/// Joins the parts without encoding them again.
Result<int> Run(const MergeOptions& options);

} // namespace boxreel
