// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <cstdint>
#include <session/GoldenScenes.h>

#include <filesystem>
#include <string>

namespace boxreel
{

/// A scene's state at a step as text, or each step's hashes up to it.
struct GoldenStateOptions
{
    std::string scene;
    std::int64_t step = 300;
    bool trace = false;
};

/// Declares `boxreel golden state` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, GoldenStateOptions& options);

/// Checks that a scene was named.
Result<void> Check(GoldenStateOptions& options);

/// Prints the state.
Result<int> Run(const GoldenStateOptions& options);

/// Returns the absolute path of the program, not searched along PATH. Error (Unusable): no file.
Result<std::filesystem::path> FindOtherProgram(const std::filesystem::path& program);

/// Runs another build and compares the states of a scene with those of this program. Returns a
/// sentence with the first step that differs, the bodies, and by how much they differ there. Empty
/// if all steps are the same. `program`: the result of FindOtherProgram.
Result<std::string> CompareWith(const std::filesystem::path& program,
                                const GoldenSelection& selection);

} // namespace boxreel
