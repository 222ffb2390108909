// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Colours and line widths of a picture. A DrawList has the colours of an engine's debug drawing
/// (the classic palette); a theme maps them, for screen and paper. Colours outside of that palette
/// are the user's own and are kept.
namespace boxreel
{

/// The meaning of a colour in the debug drawing.
enum class ColorRole : std::uint8_t
{
    StaticBody,
    KinematicBody,
    AwakeBody,
    AsleepBody,
    InactiveBody,
    Joint,
    Pair,
    Aabb,
    NewContact,
    OldContact,
    ContactNormal,
    ContactImpulse,
    ContactFriction,
    JointForce,
    Velocity,
    Ink, ///< white: labels, and items with the highest contrast to the background
};
/// Number of roles.
inline constexpr std::size_t kColorRoles = 16;
/// A colour per role, in the order of the roles.
using Palette = std::array<Color, kColorRoles>;

/// The standard colours of the debug drawing. There, friction has the colour of impulses; an
/// invisible difference of one step of blue lets themes separate them.
inline constexpr Palette kClassicPalette{{{128, 230, 128},
                                          {128, 128, 230},
                                          {230, 179, 179},
                                          {153, 153, 153},
                                          {128, 128, 77},
                                          {128, 204, 204},
                                          {77, 230, 230},
                                          {230, 77, 230},
                                          {77, 242, 77},
                                          {77, 77, 242},
                                          {230, 230, 230},
                                          {230, 230, 77},
                                          {230, 230, 78},
                                          {255, 150, 60},
                                          {90, 170, 255},
                                          {255, 255, 255}}};

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
    Palette palette = kClassicPalette; ///< by ColorRole: replacements of the classic colours

    /// Returns the colour for outlines, lines and text; the opacity is kept. A user's own colour
    /// with a low contrast to the background (below about 3:1) is made visible: it is darkened, or
    /// lightened on a dark background.
    Color Outline(Color asked) const;

    /// Returns the colour for a fill, before shade and opacity. The user's own colours are kept.
    Color Fill(Color asked) const;

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
