// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace boxreel
{

/// What a batch is drawn with. Pixels pay for whatever a program can do, so each does little.
enum class ProgramKind : std::uint8_t
{
    Ground,       ///< wipes out what is below it
    Box,          ///< whose inside is wider than a pixel
    ThinBox,      ///< or not, or that has none: lines too
    Disc,         ///< and rings
    Capsule,      ///< thick lines
    SmallPolygon, ///< by the number of corners (SlotsOf)
    Hexagon,
    Polygon,
    LargePolygon,
    Glyph,
};
inline constexpr std::size_t kProgramKinds = 10;

/// What an instance is to GL.
enum class Form : std::uint8_t
{
    Quad,  ///< two triangles
    Square ///< a point, which lies straight: half the work, and none of it twice along a diagonal
};
inline constexpr std::size_t kForms = 2;

} // namespace boxreel
