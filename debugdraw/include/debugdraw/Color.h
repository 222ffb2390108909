// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// @file
/// Colours and their roles. A theme (Theme.h) has its own colour for each role.
namespace boxreel
{

/// sRGB, not premultiplied.
struct Color
{
    std::uint8_t r = 0;   ///< red, 0 to 255
    std::uint8_t g = 0;   ///< green, 0 to 255
    std::uint8_t b = 0;   ///< blue, 0 to 255
    std::uint8_t a = 255; ///< opacity, 0 to 255
    /// True if all members are equal.
    friend bool operator==(const Color&, const Color&) = default;
};

/// The roles that have their own colour in the debug drawing.
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
    Ink,  ///< labels, and marks with the highest contrast to the background
    None, ///< a user-defined colour, which themes keep
};
/// Number of roles without None.
inline constexpr std::size_t kColorRoles = std::size_t(ColorRole::None);
/// A colour for each role, in the order of the roles.
using Palette = std::array<Color, kColorRoles>;

/// The classic colours of the Box2D debug drawing.
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

/// The colour to draw with. It is either a role, whose classic colour a theme may replace, or a
/// user-defined colour.
struct Paint
{
    Color color;                      ///< as the classic theme draws it
    ColorRole role = ColorRole::None; ///< its meaning

    /// Black.
    constexpr Paint() = default;
    /// A user-defined colour.
    constexpr Paint(Color own) : color(own) {}
    /// A user-defined colour; channels and opacity are 0 to 255.
    constexpr Paint(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255)
        : color{r, g, b, a}
    {}
    /// Any colour with a role.
    constexpr Paint(Color asked, ColorRole standsFor) : color(asked), role(standsFor) {}
    /// The classic colour of this role (not None) at this opacity.
    constexpr Paint(ColorRole standsFor, std::uint8_t opacity = 255)
        : color(kClassicPalette[std::size_t(standsFor)]), role(standsFor)
    {
        color.a = opacity;
    }
    /// True if all members are equal.
    friend bool operator==(const Paint&, const Paint&) = default;
};

/// Lines from names to what they name.
inline constexpr Paint kNameLine(ColorRole::Ink, 128);

} // namespace boxreel
