// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <string>

/// How far two pictures differ, and whether that is too far.
namespace boxreel
{

struct CompareSettings
{
    std::string preset = "same-machine"; ///< where the limits came from, printed in the verdict
    double tolerance = 0.004; ///< of one pixel: OKLab distance (black to white is 1)
    std::int64_t maxPixels = 4;  ///< this many pixels over the tolerance pass, when scattered
    int densityWindow = 16;      ///< side of the window [px] in which …
    std::int64_t maxInWindow = 2; ///< … at most this many may be over the tolerance

    static CompareSettings Exact();       ///< every bit
    static CompareSettings SameMachine(); ///< the default: single stray pixels pass
    /// The preset of that name, or an Error that lists them.
    static Result<CompareSettings> Preset(const std::string& name);
};

struct Comparison
{
    bool equal = false;
    bool sameSize = true;
    std::int64_t differentPixels = 0; ///< with any bit different
    std::int64_t overTolerance = 0;
    std::int64_t worstWindow = 0; ///< most pixels over the tolerance in any one window
    double largestDistance = 0.0; ///< OKLab
    int firstX = -1, firstY = -1; ///< the first pixel over the tolerance
    std::string verdict;          ///< one line for a person, with the limits and where they came from
    Frame difference;             ///< the expected picture faded, differences in strong colour
};

Comparison Compare(const Frame& expected, const Frame& actual, const CompareSettings& settings = {});

/// Expected, actual and difference side by side in one picture, for a person to look at.
Frame SideBySide(const Frame& expected, const Frame& actual, const Frame& difference);

} // namespace boxreel
