// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>
#include <render/Overlay.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The triangles of an Overlay as Canvas draws them. What GL interpolates depends on the processor
/// that it computes with; so colour and place in the font's texture are planes with integer
/// coefficients, the same at all three corners, that the fragment shader evaluates.
namespace boxreel
{

// So many bits of a plane's values are fractions. Values need 8 bits for colours and up to 13 for
// texels and must fit into 32 with their sign; sums may overflow on the way, for they wrap around.
inline constexpr int kInkBits = 20;
inline constexpr int kTexelBits = 16;

/// A corner of a triangle, as the vertex shader reads it. Each plane is v = at + x * alongX + y *
/// alongY at the middle of pixel (x, y).
struct MeshCorner
{
    std::array<float, 2> pixel{};      ///< on the grid of OnGrid [px]
    std::array<std::int32_t, 4> ink{}; ///< red, green, blue times opacity, opacity: 0 to 255
    std::array<std::int32_t, 4> inkX{};
    std::array<std::int32_t, 4> inkY{};
    std::array<std::int32_t, 4> texel{}; ///< column, row of the texture; then how they grow with x
    std::array<std::int32_t, 2> texelY{};
};

/// Some corners, three for each triangle, and the rectangle that they are drawn in.
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

/// Replaces `mesh` by what of the overlay may be seen in the rectangles. `textureWidth`,
/// `textureHeight`: of the font's texture.
void BuildMesh(const Overlay& overlay, std::span<const PixelBounds> rectangles, int textureWidth,
               int textureHeight, OverlayMesh& mesh);

} // namespace boxreel
