// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

#include <string>
#include <vector>

/// @file
/// Lays out several pictures on one sheet (small multiples), such as the moments of a motion. Each
/// can have a title, axes and a scale bar; the sheet can have a caption. All text is outside the
/// pictures, so their pixels are unchanged.
namespace boxreel
{

/// A picture of a sheet.
struct SheetPicture
{
    DrawList list;          ///< content
    Camera camera;          ///< width and height are those of the picture [px]
    std::string title = {}; ///< above the picture, such as "0.5 s"; without any title the line is
                            ///< omitted
};

/// The layout of a sheet.
struct SheetSettings
{
    int columns = 0;   ///< columns, at most the number of pictures; <= 0: automatic, up to three
                       ///< pictures in one row, otherwise about square
    bool axes = false; ///< axes below and left of each picture, in metres
    bool scaleBar = false;    ///< one scale bar below all pictures if they have the same scale,
                              ///< otherwise one below each
    std::string caption = {}; ///< below the sheet, wrapped to its width; may be empty
    Theme theme = Theme::Classic(); ///< colours and widths
    double scale = 1.0;             ///< as in Figure
    std::string title = {};         ///< as in Figure
};

/// Returns a figure with one panel for the text, if there is any, and one for each picture, row by
/// row. A single picture without text fills the figure.
Figure SheetOf(std::vector<SheetPicture> pictures, const SheetSettings& settings = {});

} // namespace boxreel
