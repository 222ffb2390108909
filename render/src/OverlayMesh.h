// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>
#include <render/Overlay.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The triangles of an Overlay as Canvas draws them. GL's interpolation depends on the processor.
/// Colour and texture coordinates are therefore planes with integer coefficients, the same at all
/// three vertices, evaluated by the fragment shader.
namespace boxreel
{

// Number of fractional bits of a plane's values. Values need 8 bits for colours and up to 13 for
// texels, and fit in 32 bits with their sign. Intermediate sums may overflow, because they wrap
// around.
inline constexpr int kInkBits = 20;
inline constexpr int kTexelBits = 16;

/// A vertex as the vertex shader reads it. Each plane is v = at + x * alongX + y * alongY at the
/// centre of pixel (x, y).
struct MeshCorner
{
    std::array<float, 2> pixel{};      ///< on the grid of OnGrid [px]
    std::array<std::int32_t, 4> ink{}; ///< premultiplied red, green, blue, and opacity: 0 to 255
    std::array<std::int32_t, 4> inkX{};
    std::array<std::int32_t, 4> inkY{};
    std::array<std::int32_t, 4> texel{}; ///< column and row in the texture; then their increments
                                         ///< in x
    std::array<std::int32_t, 2> texelY{};
};

/// A range of vertices, three per triangle, and their clip rectangle.
struct MeshRun
{
    PixelBounds bounds;
    std::size_t first = 0;
    std::size_t count = 0;
};

struct OverlayMesh
{
    std::vector<MeshCorner> corners;
    std::vector<MeshRun> runs;
};

/// Replaces `mesh` by the visible part of the overlay in the rectangles. `textureWidth`,
/// `textureHeight`: of the font texture.
void BuildMesh(const Overlay& overlay, std::span<const PixelBounds> rectangles, int textureWidth,
               int textureHeight, OverlayMesh& mesh);

} // namespace boxreel
