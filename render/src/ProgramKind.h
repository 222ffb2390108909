// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace boxreel
{

/// The shader program of a batch. Every pixel pays for all features of its program, so there are
/// many small programs.
enum class ProgramKind : std::uint8_t
{
    Ground,       ///< overwrites what is below it
    Box,          ///< interior wider than a pixel
    ThinBox,      ///< any or no interior, including lines
    Disc,         ///< including rings
    Capsule,      ///< thick lines
    SmallPolygon, ///< by the number of corners (SlotsOf)
    Hexagon,
    Polygon,
    LargePolygon,
    ManyCorners, ///< a polygon with more corners than those
    Glyph,
};
inline constexpr std::size_t kProgramKinds = 11;

/// The GL primitive of an instance.
enum class Form : std::uint8_t
{
    Quad,  ///< two triangles
    Square ///< an axis-aligned point: half the work, and no pixel twice along a diagonal
};
inline constexpr std::size_t kForms = 2;

} // namespace boxreel
