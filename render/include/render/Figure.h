// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// @file
/// Vector graphics for documents: the picture of a Renderer as SVG or PDF. Text stays text, each
/// body is a named group, and the same figure gives the same bytes. Does not need GL. Cairo and
/// FreeType are loaded for PDF; SVG needs no library.
namespace boxreel
{

/// Maximum width and height of a figure before scaling [px]; frames have a smaller limit. Times the
/// maximum scale it fits PDF's numbers (Cairo's have 24 bits before the point).
inline constexpr int kLargestFigure = 131072;

/// One view of one list, in a rectangle of the figure. Content outside is clipped.
struct FigurePanel
{
    DrawList list;  ///< content
    Camera camera;  ///< width and height are those of the panel [px]
    double x = 0.0; ///< left edge of the panel in the figure [px]
    double y = 0.0; ///< upper edge of the panel in the figure [px]
    /// Names of bodies for the names of their groups, by number: "body-17-left-wheel", or "body-17"
    /// without a name.
    std::map<std::uint32_t, std::string> bodyNames;
    /// Prefix of the panel's group names, such as "picture-2-body-17"; may be empty. Letters of an
    /// XML name.
    std::string name = {};
};

/// A figure of one or several panels.
struct Figure
{
    int width = 1280;   ///< before the scale, 1 to kLargestFigure [px]; a pixel is 1/96 inch
    int height = 720;   ///< before the scale, 1 to kLargestFigure [px]
    double scale = 1.0; ///< factor of all lengths: page, lines, letters; 0.1 to 16
    Theme theme = Theme::Classic();  ///< colours and widths
    std::string title;               ///< for screen readers and catalogues; not drawn
    std::vector<FigurePanel> panels; ///< painter's order
};

/// Returns a figure of one panel that fills it.
Figure FigureOf(DrawList list, const Camera& camera, const Theme& theme = Theme::Classic());

/// Returns the figure as SVG: one element per line, lengths in thousandths of a pixel.
/// Consecutive shapes of a body form a group such as `<g id="body-17" class="shapes">`, in
/// painter's order. A body, or the world, that is drawn again later has a second group,
/// `body-17-2`. Skipped are items that are not finite or not in the picture, and circles that reach
/// half a million pixels away. An Error (Unusable) for an invalid size, scale or camera.
Result<std::string> ToSvg(const Figure& figure);

/// Returns the figure as a PDF of one page. Text can be searched and copied. The groups are
/// sections of its structure, and named destinations. An Error (Absent) when Cairo, FreeType or the
/// font is missing; (Unusable) as in ToSvg.
Result<std::vector<std::uint8_t>> ToPdf(const Figure& figure);

/// Returns the characters of the figure's texts that a PDF shows incorrectly, each once, in order.
/// These are characters missing in its font, DejaVu Sans, and those of right-to-left scripts, which
/// are not shaped. An SVG uses the fonts of its viewer. Errors as in ToPdf.
Result<std::vector<std::string>> LettersWithoutPdf(const Figure& figure);

/// Checks that this machine can write PDFs, before long work starts. An Error (Absent) names the
/// missing package.
Result<void> PreparePdf();

/// Handling of existing files.
struct FigureFileSettings
{
    bool overwrite = false; ///< false: an existing file is an Error
};

/// Writes the figure as an SVG file, complete or not at all. An Error as in ToSvg, and when the
/// file exists or cannot be written.
Result<void> WriteSvg(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings = {});
/// Writes the figure as a PDF file, complete or not at all. An Error as in ToPdf, and when the file
/// exists or cannot be written.
Result<void> WritePdf(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings = {});

} // namespace boxreel
