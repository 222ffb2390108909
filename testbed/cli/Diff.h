// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include "CompareChoice.h"

#include <filesystem>

namespace boxreel
{

struct DiffOptions
{
    std::filesystem::path expected;
    std::filesystem::path actual;
    std::filesystem::path output; ///< of the difference image; empty: none
    CompareChoice compare;
    bool force = false;
};

/// Declares `boxreel diff` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, DiffOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(DiffOptions& options);

/// Compares the pictures.
Result<int> Run(const DiffOptions& options);

} // namespace boxreel
