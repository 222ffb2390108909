// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <options/Values.h>
#include <recorder/FrameClock.h>
#include <render/Backend.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace boxreel
{

/// A scene in a window.
struct UiOptions
{
    std::string scene;             ///< a name or a file; empty: the last one
    std::optional<PixelSize> size; ///< of the window; none: as it was
    std::string theme;             ///< its name; empty: as it was
    std::uint32_t seed = 1;
    std::optional<Rational> stepsPerSecond;
    std::filesystem::path into;      ///< a folder for what buttons write; empty: the current one
    bool isPaused = false;           ///< to begin with
    bool fresh = false;              ///< as if it were the first time; nothing is kept
    Backend backend = Backend::Auto; ///< of films and figures
};

/// Declares `boxreel ui` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, UiOptions& options);

/// Opens the window.
Result<int> Run(const UiOptions& options);

} // namespace boxreel
