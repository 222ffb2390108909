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
/// Drawings for documents: what a Renderer shows, as SVG or PDF, sharp at any size. Text stays
/// text, each body is a group with a name, and the same figure gives the same bytes. Needs no GL;
/// Cairo and FreeType are loaded when a PDF is asked for, and SVG needs nothing at all.
namespace boxreel
{

/// The most pixels each way of a figure before the scale; of pixels there can be fewer. PDF's
/// numbers (Cairo's, of 24 bits before the point) hold it times the largest scale.
inline constexpr int kLargestFigure = 131072;

/// One view of one list, in a rectangle of the figure. What lies outside is cut off.
struct FigurePanel
{
    DrawList list;  ///< what is drawn
    Camera camera;  ///< its width and height are the panel's [px]
    double x = 0.0; ///< from the figure's left edge to the panel's [px]
    double y = 0.0; ///< from the figure's upper edge to the panel's [px]
    /// What bodies are called in the groups' names, by their number: "body-17-left-wheel", or
    /// "body-17" where it has none.
    std::map<std::uint32_t, std::string> bodyNames;
    /// Begins its groups' names, where it is not empty: "picture-2-body-17". Letters of an XML
    /// name.
    std::string name = {};
};

/// A figure of one or several panels.
struct Figure
{
    int width = 1280;   ///< before the scale, 1 to kLargestFigure [px]; a pixel is 1/96 inch
    int height = 720;   ///< before the scale, 1 to kLargestFigure [px]
    double scale = 1.0; ///< how much larger all of it is: paper, lines, letters; 0.1 to 16
    Theme theme = Theme::Classic();  ///< colours and widths
    std::string title;               ///< for readers of screens and for catalogues; not drawn
    std::vector<FigurePanel> panels; ///< painter's order
};

/// A figure of one panel that fills it.
Figure FigureOf(DrawList list, const Camera& camera, const Theme& theme = Theme::Classic());

/// The figure as SVG: an element a line, lengths in thousandths of a pixel, groups like
/// `<g id="body-17" class="shapes">` for what a body has in a row, in painter's order. A body, or
/// the world, that is drawn again later has a second group, `body-17-2`. What is not finite, or not
/// in the picture, is left out, and circles that reach half a million pixels away. An Error
/// (Unusable) for a size, a scale or a camera that cannot be.
Result<std::string> ToSvg(const Figure& figure);

/// The figure as a PDF of one page. Text can be searched and copied; the groups are sections
/// of its structure, and named destinations. An Error (Absent) when Cairo, FreeType or the font is,
/// (Unusable) as of ToSvg.
Result<std::vector<std::uint8_t>> ToPdf(const Figure& figure);

/// The letters of the figure's texts that a PDF does not show as they are meant: those that its
/// font, DejaVu Sans, has not, which are empty boxes, and those of scripts from the right to the
/// left, which would not be joined or turned. Each once, as they come. In an SVG they are the
/// viewer's. Errors as of ToPdf.
Result<std::vector<std::string>> LettersWithoutPdf(const Figure& figure);

/// Whether PDFs can be written on this machine: asked before long work is done for one. An Error
/// (Absent) names the package that is missing.
Result<void> PreparePdf();

/// What becomes of a file that is there.
struct FigureFileSettings
{
    bool overwrite = false; ///< false: an existing file is an error
};

/// Writes the figure as an SVG file, whole or not at all. An Error as of ToSvg, and when the file
/// is there or cannot be written.
Result<void> WriteSvg(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings = {});
/// Writes the figure as a PDF file, whole or not at all. An Error as of ToPdf, and when the file is
/// there or cannot be written.
Result<void> WritePdf(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings = {});

} // namespace boxreel
