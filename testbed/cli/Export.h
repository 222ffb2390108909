// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <options/Values.h>
#include <session/SceneSession.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace boxreel
{

/// A scene becomes a scene file.
struct ExportOptions
{
    std::string scene; ///< a name or a file
    std::filesystem::path output;
    SceneLook look;                   ///< seed and rate
    std::optional<Duration> at;       ///< simulated time …
    std::optional<std::int64_t> step; ///< … or number of steps; neither: 0
    bool force = false;
};

/// Declares `boxreel export` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, ExportOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(ExportOptions& options);

/// Writes the scene file.
Result<int> Run(const ExportOptions& options);

} // namespace boxreel
