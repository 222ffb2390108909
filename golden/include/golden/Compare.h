// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <string>
#include <vector>

/// How far two pictures differ, and whether that is too far. Called by the reference store, by
/// tests and by `boxreel diff`. Knows no files and no scenes; the verdict has the same bits for the
/// same pictures on every machine.
namespace boxreel
{

/// Two pictures of the same size are equal when at most `maxPixels` pixels differ by more than
/// `tolerance`, and no window of densityWindow x densityWindow pixels, wherever it lies, holds more
/// than `maxInWindow` of them: scattered specks pass, a cluster does not.
struct CompareSettings
{
    std::string preset = "same-machine"; ///< where the limits came from, printed in the verdict
    /// Of one pixel: OKLab distance (black to white is 1). The default lies below the smallest
    /// distance that a channel off by 4/255 makes anywhere in sRGB (0.00028, red in bright cyan),
    /// so that no such change is overlooked. 0: any bit counts.
    double tolerance = 0.00025;
    std::int64_t maxPixels = 4; ///< this many pixels over the tolerance pass, when scattered
    int densityWindow = 16;     ///< side of the window [px], 1 or more, in which …
    /// … at most this many may be over the tolerance. With 1, a dot that moved by a pixel (one
    /// pixel gone, its neighbour new) is found.
    std::int64_t maxInWindow = 1;

    static CompareSettings Exact();       ///< every bit
    static CompareSettings SameMachine(); ///< the default: single stray pixels pass
    /// The preset of that name, or an Error that lists them and names `option`, the text's origin.
    static Result<CompareSettings> Preset(const std::string& option, const std::string& name);
    static std::vector<std::string> PresetNames();
};

struct Comparison
{
    bool equal = false;
    bool sameSize = true;
    std::int64_t differentPixels = 0; ///< with any bit different, or in one picture only
    std::int64_t overTolerance = 0;
    std::int64_t worstWindow = 0; ///< most pixels over the tolerance in any one window
    double largestDistance = 0.0; ///< OKLab, of the pixels that both pictures have
    int firstX = -1, firstY = -1; ///< the first pixel over the tolerance, row by row; -1: none
    std::string verdict; ///< one line for a person, with the limits and where they came from
    /// The expected picture faded to dark gray, pixels over the tolerance in red inside one thin
    /// white box, pixels that differ within the tolerance in dull blue. Opaque, of the larger size.
    Frame difference;
};

Comparison Compare(const Frame& expected, const Frame& actual,
                   const CompareSettings& settings = {});

/// Expected, actual and difference side by side in one picture, for a person to look at, with thin
/// separators; what is smaller than the largest is padded with their gray.
Frame SideBySide(const Frame& expected, const Frame& actual, const Frame& difference);

} // namespace boxreel
