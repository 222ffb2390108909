// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Color.h>

#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Colours and line widths of a picture. A DrawList says what each colour stands for; a theme has a
/// colour for each of these roles, on a screen and on paper alike. Colours without a role are the
/// user's own and are kept.
namespace boxreel
{

/// Colours and widths of a picture.
struct Theme
{
    Color background{26, 26, 26, 255}; ///< colour of empty areas
    Color text{230, 230, 230, 255};    ///< of captions; labels have their own colour, usually Ink
    Color xAxis{255, 64, 64, 255};     ///< of a drawn frame of reference
    Color yAxis{64, 220, 64, 255};     ///< of a drawn frame of reference
    float outlineWidth = 1.25f;        ///< of shapes and segments [px]
    float fillShade = 0.5f;            ///< factor of a solid shape's colour
    float fillAlpha = 0.5f;            ///< and opacity of its fill

    /// False: every colour is drawn unchanged, and `palette` is not used.
    bool recolors = false;
    Palette palette = kClassicPalette; ///< the colour of each ColorRole

    /// What an outline, a line or a letter is drawn in when this is asked for; its opacity is kept.
    /// A colour of the user's own that would hardly be seen on the ground (contrast below
    /// about 3:1) is darkened, or on a dark ground lightened, until it is.
    Color Outline(const Paint& asked) const;

    /// What a shape is filled with, before shade and opacity. The user's own colours are kept.
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
