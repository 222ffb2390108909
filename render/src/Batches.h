// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Gathers what is to be drawn into as few draw calls as painter's order allows. Written by
/// ShapeBuilder, read by Renderer. Knows no GL.
namespace boxreel
{

/// What a batch is drawn with. Boxes and thin lines; discs, rings and thick lines; convex polygons
/// of few and of many corners; letters.
enum class ProgramKind : std::uint8_t
{
    Box,
    Round,
    SmallPolygon,
    Polygon,
    LargePolygon,
    Glyph,
};
inline constexpr std::size_t kProgramKinds = 6;

/// The pixels that something can touch [px], y down, upper bounds excluded.
struct PixelBounds
{
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    bool IsEmpty() const { return x1 <= x0 || y1 <= y0; }
};

/// One draw call: instances of one kind, in painter's order.
struct Batch
{
    ProgramKind kind = ProgramKind::Box;
    std::size_t instances = 0;
    std::vector<float> data; ///< the instances' attributes, one after another
};

class Batches
{
public:
    /// Starts a picture of this size [px]; keeps the memory of the last one.
    void Clear(int width, int height);

    /// Adds an instance that touches only pixels within `bounds` (not empty, inside the picture).
    /// It is drawn after everything added before that shares a tile with it; among strangers the
    /// order is free.
    void Add(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes);

    std::span<const Batch> All() const { return {m_batches.data(), m_used}; }

private:
    std::size_t Place(ProgramKind kind, const PixelBounds& bounds);

    int m_columns = 0;
    std::vector<int> m_latest; // per tile: the last batch that draws into it, -1 for none
    std::vector<Batch> m_batches;
    std::size_t m_used = 0;
    std::array<std::vector<int>, kProgramKinds> m_ofKind; // batches of each kind, ascending
};

} // namespace boxreel
