// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <options/MotionChoice.h>
#include <options/Values.h>
#include <render/Backend.h>
#include <session/SceneSession.h>

#include <filesystem>
#include <string>
#include <vector>

namespace boxreel
{

struct ShotOptions
{
    std::string scene; ///< a name or a file
    std::filesystem::path output;
    SceneLook look;
    std::vector<Duration> at;        ///< simulated times …
    std::vector<std::int64_t> steps; ///< … or numbers of steps; several make a grid of pictures
    MotionLook motion;
    Backend backend = Backend::Auto;
    bool bothThemes = false; ///< a light and a dark picture instead of the look's theme
    bool force = false;
    bool stats = false; ///< say what was drawn; of pixels only
};

/// Declares `boxreel shot` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, ShotOptions& options);

/// Checks that the files can be made; simulates and writes nothing.
Result<void> Prepare(const ShotOptions& options);

/// The files that are made; of a numbered film its pattern.
std::vector<std::filesystem::path> FilesOf(const ShotOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(ShotOptions& options);

/// Writes the pictures.
Result<int> Run(const ShotOptions& options);

} // namespace boxreel
