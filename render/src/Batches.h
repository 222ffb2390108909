// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Gathers what is to be drawn into as few draw calls as painter's order allows. Written by
/// Renderer, read by Canvas. Knows no GL.
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

/// One draw call: instances of one kind, in painter's order.
struct Batch
{
    ProgramKind kind = ProgramKind::Box;
    std::size_t instances = 0;
    std::vector<float> data; ///< the instances' parts and attributes, one after another
};

class Batches
{
public:
    /// Starts a picture of this size [px]; keeps the memory of the last one.
    void Clear(int width, int height);

    /// The first vector of an instance: the rectangle of pixels to draw of it. An empty one means
    /// all of it, by the quad that lies closest around it.
    using Part = std::array<float, 4>;

    /// Adds an instance that touches only pixels within `bounds` (not empty, inside the picture).
    /// It is drawn after everything added before that shares a tile with it; among strangers the
    /// order is free.
    void Add(ProgramKind kind, const PixelBounds& bounds, const Part& part,
             std::span<const float> attributes);

    /// All that was added.
    std::size_t Instances() const { return m_instances; }

    std::span<const Batch> All() const { return {m_batches.data(), m_used}; }

private:
    std::size_t Place(ProgramKind kind, const PixelBounds& bounds);

    int m_columns = 0;
    std::vector<int> m_latest; // per tile: the last batch that draws into it, -1 for none
    std::vector<Batch> m_batches;
    std::size_t m_used = 0;
    std::size_t m_instances = 0;
    std::array<std::vector<int>, kProgramKinds> m_ofKind; // batches of each kind, ascending
};

} // namespace boxreel
