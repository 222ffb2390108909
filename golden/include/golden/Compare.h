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
/// Compares two pictures against limits. Called by the reference store, by tests and by `boxreel
/// diff`. Independent of files and scenes; the result is bit-identical on every machine.
namespace boxreel
{

/// The limits of a comparison. Pictures of the same size are equal if three conditions hold. At
/// most `maxPixels` pixels are over tolerance, at most `maxRatio` of those compared, and at most
/// `maxInWindow` in any window of densityWindow x densityWindow pixels. Scattered pixels pass, a
/// cluster does not. A pixel is over tolerance if it differs by more than `tolerance`. At an edge
/// of the expected picture, it must also differ by more than `edgeShift` explains.
struct CompareSettings
{
    std::string preset = "same-machine"; ///< source of the limits, printed with them
    /// Options that replaced limits of the preset or leave something out, such as --tolerance;
    /// printed with the preset.
    std::vector<std::string> options{};
    /// Tolerance of one pixel as an OKLab distance; black to white is 1. The default lies below the
    /// smallest distance of a channel that is off by 4/255 anywhere in sRGB, so no such change is
    /// missed. That is 0.00028, for red in bright cyan. 0: any difference counts.
    double tolerance = 0.00025;
    /// Allowed shift of an edge relative to the expected picture [px], 0 to 0.45. From 0.5 on, a
    /// missing line would pass as a shifted one.
    double edgeShift = 0.0;
    std::int64_t maxPixels = 4; ///< this many scattered pixels over tolerance pass
    double maxRatio = 1.0;      ///< and this fraction of the compared pixels, 0 to 1
    int densityWindow = 16;     ///< side of the window [px], >= 1
    /// Pixels over tolerance allowed in a window. 1 detects a dot that moved by one pixel (two
    /// differences).
    std::int64_t maxInWindow = 1;
    std::vector<PixelBounds> ignored{}; ///< rectangles that are not compared
    /// Numbers of bodies that a reference store removes from the state, the draw list, and the
    /// picture where either list has them. Not used by Compare itself.
    std::vector<int> ignoredBodies{};
    /// True: a reference store uses the limits of CrossMachine if the reference is from a renderer
    /// with other bits. Only if all limits are the defaults.
    bool adaptsToRenderer = true;
    bool paintsDifference = true; ///< false: Comparison::difference stays empty, which is faster

    static CompareSettings Exact(); ///< no tolerance
    /// Single stray pixels pass. The default limits, for every renderer of the reference.
    static CompareSettings SameMachine();
    /// Another GPU, driver or compiler: rounding and edges differ, the content does not.
    /// tolerance 0.01: above the effect of +-2/255 in the fills of our themes (at most 0.009, on
    /// the dark background). Below that of 4/255 in all channels (at least 0.012; 0.006 for
    /// saturated red and blue).
    /// edgeShift 0.2: GL allows drivers to round vertices to 1/16 px, so two of them draw an edge
    /// up to 1/8 px apart. The rest is for corners of several edges. Whole scenes shifted by 0.1 px
    /// pass, by 0.5 px fail. OSMesa and EGL of one Mesa draw the same bits.
    /// maxRatio 0.0005: about 460 pixels in 1280x720, one in every second window of 32x32.
    /// maxInWindow 8: a missing dot of 3x3 pixels is found; scattered pixels of that density are
    /// not that close together.
    static CompareSettings CrossMachine();
    /// Returns the preset of that name. An Error lists the presets and names `option`, the source
    /// of the text.
    static Result<CompareSettings> Preset(const std::string& option, const std::string& name);
    /// Returns the names that Preset accepts.
    static std::vector<std::string> PresetNames();
};

/// Calls `visit` with the name of each limit and its value in all `settings`. Verdicts, messages
/// and the choice of limits read this table.
template <class Visit, class... Settings>
void VisitLimits(Visit&& visit, const Settings&... settings)
{
    visit("tolerance", settings.tolerance...);
    visit("edgeShift", settings.edgeShift...);
    visit("maxPixels", settings.maxPixels...);
    visit("maxRatio", settings.maxRatio...);
    visit("maxInWindow", settings.maxInWindow...);
    visit("window", settings.densityWindow...);
}

/// Returns the names of the limits that differ.
std::vector<std::string> DifferentLimits(const CompareSettings& one, const CompareSettings& other);

/// The value of CompareSettings::maxPixels that sets no limit.
inline constexpr std::int64_t kAnyNumberOfPixels = std::numeric_limits<std::int64_t>::max();

/// Returns the limits and their source: "same-machine allows 4 pixels over a distance of 0.00025, 1
/// in any 16x16".
std::string DescribeLimits(const CompareSettings& settings);

/// Returns the limits for a picture of another renderer: those of CrossMachine if `settings`
/// adapts, otherwise none.
std::optional<CompareSettings> ForOtherRenderer(const CompareSettings& settings);

/// The result of a comparison.
struct Comparison
{
    bool equal = false;               ///< within the limits of the settings
    bool sameSize = true;             ///< in width and height
    std::int64_t differentPixels = 0; ///< with any difference, or in one picture only
    std::int64_t compared = 0;        ///< all except the ignored pixels
    std::int64_t ignored = 0;         ///< in an ignored rectangle
    std::int64_t overTolerance = 0;   ///< by more than is allowed there
    std::int64_t excusedAtEdges = 0;  ///< over the tolerance, but explained by an edge
    std::int64_t worstWindow = 0;     ///< maximum number of pixels over the tolerance in a window
    double largestDistance = 0.0;     ///< OKLab, over the common pixels
    int firstX = -1; ///< column of the first pixel over the tolerance, in row order [px]; -1: none
    int firstY = -1; ///< row of the first pixel over the tolerance [px]; -1: none
    std::array<int, 2> expectedSize{}; ///< width and height [px]
    std::array<int, 2> actualSize{};   ///< width and height [px]
    CompareSettings limits;            ///< those of the comparison
    /// The expected picture faded to dark gray, with the differences on top. Pixels over the
    /// tolerance are red, inside one thin white box. Differences within the tolerance, or explained
    /// by an edge, are dull blue. Ignored pixels are hatched. Opaque, with the larger of the two
    /// sizes.
    Frame difference;

    /// A comparison that compares nothing does not pass.
    bool IsAllIgnored() const { return compared == 0 && ignored > 0; }
    /// One line for a person, with the limits and where they came from.
    std::string Text() const;
};

/// Calls `visit` with the name and value of each number that verdict files contain.
template <class Visit>
void VisitCounts(Visit&& visit, const Comparison& comparison)
{
    visit("compared", comparison.compared);
    visit("different", comparison.differentPixels);
    visit("overTolerance", comparison.overTolerance);
    visit("excusedAtEdges", comparison.excusedAtEdges);
    visit("worstWindow", comparison.worstWindow);
    visit("largestDistance", comparison.largestDistance);
}

/// Compares two pictures, the first of which is the reference. Never fails: different sizes are a
/// difference.
Comparison Compare(const Frame& expected, const Frame& actual,
                   const CompareSettings& settings = {});

/// Returns expected, actual and difference side by side with thin separators; smaller pictures are
/// padded with the separators' gray.
Frame SideBySide(const Frame& expected, const Frame& actual, const Frame& difference);

} // namespace boxreel
