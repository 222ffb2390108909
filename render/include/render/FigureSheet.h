// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

#include <string>
#include <vector>

/// @file
/// Several pictures on one sheet, small multiples such as the moments of a motion, each with a
/// title, axes and a scale bar, and one caption for all. What is written lies beside the pictures,
/// in bands of their own, so the pictures are what they are alone.
namespace boxreel
{

/// A picture of a sheet.
struct SheetPicture
{
    DrawList list;          ///< what is drawn
    Camera camera;          ///< its width and height are the picture's [px]
    std::string title = {}; ///< above it, such as "0.5 s"; empty: no line for it when all are
};

/// How a sheet is laid out.
struct SheetSettings
{
    int columns = 0;   ///< of pictures, no more than there are; 0 or less: as many as make a sheet
                       ///< about as wide as it is high, up to three in one row
    bool axes = false; ///< below and left of each picture, in metres
    bool scaleBar = false;    ///< below all, when pictures have the same scale, else below each
    std::string caption = {}; ///< below all of it, in lines as wide as the sheet; empty: none
    Theme theme = Theme::Classic(); ///< colours and widths
    double scale = 1.0;             ///< as of a Figure
    std::string title = {};         ///< as of a Figure
};

/// One panel for what lies beside the pictures, when there is any, and one for each picture, in
/// their order, row by row. A picture with nothing beside it fills the figure.
Figure SheetOf(std::vector<SheetPicture> pictures, const SheetSettings& settings = {});

} // namespace boxreel
