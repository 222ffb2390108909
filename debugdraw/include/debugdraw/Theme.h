// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Colours and line widths of a picture. A DrawList carries the colours that an engine's debug
/// drawing asked for (the classic palette); a theme says what they become, on a screen and on paper
/// alike. Colours that are not of that palette are the user's own and are kept.
namespace boxreel
{

/// What the debug drawing has a colour of its own for.
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
    Ink, ///< white: labels, and whatever is meant to stand out most from the ground
};
/// How many roles there are.
inline constexpr std::size_t kColorRoles = 16;
/// A colour for each role, in the order of the roles.
using Palette = std::array<Color, kColorRoles>;

/// The colours every user of this debug drawing knows. Friction looks like impulses there; a step
/// of blue, which nobody sees, tells themes which of the two is asked for.
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
    Color background{26, 26, 26, 255}; ///< where nothing is drawn
    Color text{230, 230, 230, 255};    ///< of captions; a label has its own colour, usually Ink
    Color xAxis{255, 64, 64, 255};     ///< of a drawn frame of reference
    Color yAxis{64, 220, 64, 255};     ///< of a drawn frame of reference
    float outlineWidth = 1.25f;        ///< of shapes and segments [px]
    float fillShade = 0.5f; ///< a solid shape is filled with this share of its colour …
    float fillAlpha = 0.5f; ///< … at this opacity

    /// False: every colour is drawn as it was asked for, and `palette` is not looked at.
    bool recolors = false;
    Palette palette = kClassicPalette; ///< by ColorRole: what becomes of the classic colours

    /// What an outline, a line or a letter is drawn in when this colour is asked for; its opacity
    /// is kept. A colour of the user's own that would hardly be seen on the ground (contrast below
    /// about 3:1) is darkened, or on a dark ground lightened, until it is.
    Color Outline(Color asked) const;

    /// What a shape is filled with, before shade and opacity. The user's own colours are kept.
    Color Fill(Color asked) const;

    /// As it has always looked.
    static Theme Classic();
    /// The classic ground with the eight colours of Okabe and Ito ("Color Universal Design", 2008;
    /// white in the place of black) and seven more for lines, arrows and points that lie over them.
    /// People of any colour vision tell all of them apart.
    static Theme OkabeIto();
    /// A white ground, dark outlines, light fills: for paper and for light pages.
    static Theme Print();
    /// For dark pages: the twin of Print.
    static Theme Dark();
};

/// classic, okabe-ito, print, dark.
const std::vector<std::string_view>& ThemeNames();

/// The theme of that name, if there is one.
std::optional<Theme> FindTheme(std::string_view name);

} // namespace boxreel
