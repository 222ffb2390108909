// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// @file
/// How far two pictures differ, and whether that is too far. Called by the reference store, by
/// tests and by `boxreel diff`. Knows no files and no scenes; the verdict has the same bits for the
/// same pictures on every machine.
namespace boxreel
{

/// Two pictures of the same size are equal when at most `maxPixels` pixels, and at most `maxRatio`
/// of those compared, differ by more than is allowed, and no window of densityWindow x
/// densityWindow pixels, wherever it lies, holds more than `maxInWindow` of them: scattered specks
/// pass, a cluster does not. Allowed are `tolerance` and, where the expected picture has an edge,
/// what an edge that lies `edgeShift` elsewhere changes.
struct CompareSettings
{
    std::string preset = "same-machine"; ///< where the limits came from, printed with them
    /// That replaced limits of the preset or leave something out; printed with it, such as
    /// --tolerance.
    std::vector<std::string> options{};
    /// Of one pixel: OKLab distance (black to white is 1). The default lies below the smallest
    /// distance that a channel off by 4/255 makes anywhere in sRGB (0.00028, red in bright cyan),
    /// so that no such change is overlooked. 0: any bit counts.
    double tolerance = 0.00025;
    /// An edge may lie this far from where the expected picture has it [px], 0 to 0.45. From 0.5
    /// on, a line that is gone would be excused as one that moved.
    double edgeShift = 0.0;
    std::int64_t maxPixels = 4; ///< this many pixels over what is allowed pass, when scattered; …
    double maxRatio = 1.0;      ///< … and this share of the pixels that are compared, 0 to 1
    int densityWindow = 16;     ///< side of the window [px], 1 or more, in which …
    /// … at most this many may be over what is allowed. With 1, a dot that moved by a pixel (one
    /// pixel gone, its neighbour new) is found.
    std::int64_t maxInWindow = 1;
    std::vector<PixelBounds> ignored{}; ///< what lies in one of these is not compared
    /// Bodies that a reference store leaves out: of the state, of the draw list, and of the picture
    /// where either list has them. By number. Compare itself knows no bodies.
    std::vector<int> ignoredBodies{};
    /// True: a reference store replaces the limits by those of CrossMachine where a renderer that
    /// gives other bits drew the reference. Only where no limit differs from the default's.
    bool adaptsToRenderer = true;
    bool paintsDifference = true; ///< false: Comparison::difference stays empty, which is faster

    static CompareSettings Exact(); ///< every bit
    /// Single stray pixels pass. The default's limits, whichever renderer drew the reference.
    static CompareSettings SameMachine();
    /// Another GPU, driver or compiler: roundings and edges differ, what is drawn does not.
    /// tolerance 0.01: above what +-2/255 makes in the fills of our themes (0.009 at most, on the
    /// dark ground), below what 4/255 in all channels makes there (0.012 or more; of saturated red
    /// and blue 0.006). edgeShift 0.2: GL lets a driver round vertices to 1/16 px, so two of them
    /// draw an edge up to 1/8 px apart; the rest is for corners where several edges meet. Whole
    /// scenes shifted by 0.1 px pass, by 0.5 px fail. OSMesa and EGL of one Mesa draw the same
    /// bits. maxRatio 0.0005: some 460 specks in 1280x720, one in every second window of 32x32.
    /// maxInWindow 8: a dot of 3x3 pixels that is gone is found; specks of that density are not
    /// that close together.
    static CompareSettings CrossMachine();
    /// The preset of that name, or an Error that lists them and names `option`, the text's origin.
    static Result<CompareSettings> Preset(const std::string& option, const std::string& name);
    /// What Preset takes.
    static std::vector<std::string> PresetNames();
};

/// The value of CompareSettings::maxPixels that sets no limit.
inline constexpr std::int64_t kAnyNumberOfPixels = std::numeric_limits<std::int64_t>::max();

/// "same-machine allows 4 pixels over a distance of 0.00025, 1 in any 16x16": what holds, and where
/// it came from.
std::string DescribeLimits(const CompareSettings& settings);

/// The limits for a picture that another renderer drew: those of CrossMachine where `settings`
/// adapt, else none.
std::optional<CompareSettings> ForOtherRenderer(const CompareSettings& settings);

/// What a comparison has found.
struct Comparison
{
    bool equal = false;               ///< within the limits of the settings
    bool sameSize = true;             ///< in width and height
    std::int64_t differentPixels = 0; ///< with any bit different, or in one picture only
    std::int64_t compared = 0;        ///< all pixels but those …
    std::int64_t ignored = 0;         ///< … in an ignored rectangle
    std::int64_t overTolerance = 0;   ///< by more than is allowed there
    std::int64_t excusedAtEdges = 0;  ///< over the tolerance, but no more than their edge explains
    std::int64_t worstWindow = 0;     ///< most pixels over the tolerance in any one window
    double largestDistance = 0.0;     ///< OKLab, of the pixels that both pictures have
    int firstX = -1; ///< column of the first pixel over the tolerance, row by row [px]; -1: none
    int firstY = -1; ///< row of the first pixel over the tolerance [px]; -1: none
    std::array<int, 2> expectedSize{}; ///< width and height [px]
    std::array<int, 2> actualSize{};   ///< width and height [px]
    CompareSettings limits;            ///< those of the comparison
    /// The expected picture faded to dark gray, pixels over the tolerance in red inside one thin
    /// white box, pixels that differ within the tolerance, or as their edge explains, in dull blue,
    /// ignored ones hatched. Opaque, of the larger size.
    Frame difference;

    /// A comparison that compares nothing does not pass.
    bool IsAllIgnored() const { return compared == 0 && ignored > 0; }
    /// One line for a person, with the limits and where they came from.
    std::string Text() const;
};

/// Compares two pictures, the first of which was approved; never fails: other sizes are a
/// difference.
Comparison Compare(const Frame& expected, const Frame& actual,
                   const CompareSettings& settings = {});

/// Expected, actual and difference side by side in one picture, for a person to look at, with thin
/// separators; what is smaller than the largest is padded with their gray.
Frame SideBySide(const Frame& expected, const Frame& actual, const Frame& difference);

} // namespace boxreel
