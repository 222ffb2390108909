// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Color.h>

#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Colours and line widths of a picture. A DrawList stores the role of each colour, and a theme has
/// a colour for each role. Colours without a role are user-defined and are kept.
namespace boxreel
{

/// Colours and widths of a picture.
struct Theme
{
    Color background{26, 26, 26, 255}; ///< colour of empty areas
    Color text{230, 230, 230, 255};    ///< colour of captions; labels have their own, usually Ink
    Color xAxis{255, 64, 64, 255};     ///< x axis of a frame of reference
    Color yAxis{64, 220, 64, 255};     ///< y axis of a frame of reference
    float outlineWidth = 1.25f;        ///< width of shapes' outlines and segments [px]
    float fillShade = 0.5f;            ///< brightness factor of a solid shape's fill
    float fillAlpha = 0.5f;            ///< opacity of a solid shape's fill

    /// False: every colour is drawn unchanged, and `palette` is not used.
    bool recolors = false;
    Palette palette = kClassicPalette; ///< the colour of each ColorRole

    /// Returns the colour of outlines, lines and letters drawn with `asked`. Keeps the opacity. A
    /// user-defined colour with little contrast to the background (below about 3:1) is darkened, or
    /// on a dark background lightened, until it is visible.
    Color Outline(const Paint& asked) const;

    /// Returns the fill colour of a shape, before shade and opacity. Keeps user-defined colours.
    Color Fill(const Paint& asked) const;

    /// Returns the default theme, with unchanged colours.
    static Theme Classic();
    /// Returns the eight colours of Okabe and Ito ("Color Universal Design", 2008; white instead of
    /// black) on the classic background. Seven more are for lines, arrows and points above them.
    /// All are distinct with any colour vision.
    static Theme OkabeIto();
    /// Returns a theme with a white background, dark outlines and light fills, for paper and light
    /// pages.
    static Theme Print();
    /// Returns the counterpart of Print for dark pages.
    static Theme Dark();
};

/// Returns the names: classic, okabe-ito, print, dark.
const std::vector<std::string_view>& ThemeNames();

/// Returns the theme of that name, if there is one.
std::optional<Theme> FindTheme(std::string_view name);

} // namespace boxreel
