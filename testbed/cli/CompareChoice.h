// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <golden/Compare.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The options for comparing pictures: a preset, and single limits. The limits replace those of the
/// preset, in any order on the command line.
namespace boxreel
{

struct CompareChoice
{
    CompareSettings preset;
    std::optional<double> tolerance;         ///< --tolerance, OKLab distance
    std::optional<double> edgeShift;         ///< --edge-shift [px]
    std::optional<std::int64_t> maxPixels;   ///< --max-pixels
    std::optional<double> maxRatio;          ///< --max-ratio, 0 to 1
    std::optional<std::int64_t> maxInWindow; ///< --max-in-window
    std::optional<int> window;               ///< --window [px]
    std::vector<PixelBounds> ignored;        ///< --ignore
    std::vector<int> ignoredBodies;          ///< --ignore-body
};

/// The limits that hold. Their name says which of them came from options: "same-machine, with
/// --tolerance".
CompareSettings Effective(const CompareChoice& choice);

/// Options of diff and golden verify. `usualPreset`: what the help gives as the default preset.
void AddCompare(Command& command, CompareChoice& choice, const std::string& usualPreset);

/// The option of golden verify that leaves bodies out.
void AddIgnoredBodies(Command& command, CompareChoice& choice);

} // namespace boxreel
