// SPDX-License-Identifier: MIT
#include "OverlayMesh.h"

#include "SoftShapes.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// Vertices are clamped to this distance [px]; the largest picture has 8192.
constexpr float kFarthest = 16384.0f;

// Colours or texture coordinates that change faster than this per pixel occur only in triangles
// thinner than the vertex grid. Smaller coefficients cannot overflow a product.
constexpr double kSteepest = 1048576.0;

// Texture coordinates are rounded to this fraction of a texel, to restore exact texels of glyphs.
constexpr double kTexelSteps = 256.0;

constexpr std::size_t kPlanes = 6; // red, green, blue, opacity, column, row

struct Corner
{
    double x = 0.0; // [px]
    double y = 0.0;
    std::array<double, kPlanes> values{};
};

Corner CornerOf(const OverlayVertex& v, int textureWidth, int textureHeight)
{
    const Vec2 p = OnGrid({std::clamp(v.position.x, -kFarthest, kFarthest),
                           std::clamp(v.position.y, -kFarthest, kFarthest)});
    const auto ink = [&](int channel) { return double(channel * v.color.a) / 255.0; };
    const auto texel = [](float at, int size) {
        const double inside = std::clamp(double(at), 0.0, 1.0);
        return std::floor(inside * size * kTexelSteps + 0.5) / kTexelSteps;
    };
    return {p.x,
            p.y,
            {ink(v.color.r), ink(v.color.g), ink(v.color.b), double(v.color.a),
             texel(v.uv.x, textureWidth), texel(v.uv.y, textureHeight)}};
}

struct Plane
{
    std::int32_t at = 0;
    std::int32_t alongX = 0;
    std::int32_t alongY = 0;
};

/// Returns the lowest 32 bits: sums modulo 2^32 are exact if the result fits.
std::int32_t Wrapped(std::int64_t value)
{
    return std::int32_t(std::uint32_t(std::uint64_t(value)));
}

/// Finds the plane through three values with `bits` fractional bits, plus `offset`. False if it is
/// too steep to be visible.
bool FindPlane(const std::array<Corner, 3>& c, std::size_t which, int bits, double offset,
               Plane& plane)
{
    const double one = double(1 << bits);
    const double x1 = c[1].x - c[0].x;
    const double y1 = c[1].y - c[0].y;
    const double x2 = c[2].x - c[0].x;
    const double y2 = c[2].y - c[0].y;
    const double v1 = c[1].values[which] - c[0].values[which];
    const double v2 = c[2].values[which] - c[0].values[which];
    const double twiceArea = x1 * y2 - x2 * y1;
    const double slopeX = (v1 * y2 - v2 * y1) / twiceArea;
    const double slopeY = (v2 * x1 - v1 * x2) / twiceArea;
    if (!(std::abs(slopeX) <= kSteepest && std::abs(slopeY) <= kSteepest))
    {
        return false;
    }
    const double alongX = std::floor(slopeX * one + 0.5);
    const double alongY = std::floor(slopeY * one + 0.5);
    const double at =
        (c[0].values[which] + offset) * one + alongX * (0.5 - c[0].x) + alongY * (0.5 - c[0].y);
    plane = {Wrapped(std::int64_t(std::floor(at + 0.5))), Wrapped(std::int64_t(alongX)),
             Wrapped(std::int64_t(alongY))};
    return true;
}

/// False for a triangle that is not visible.
bool FindPlanes(const std::array<Corner, 3>& corners, MeshCorner& shared)
{
    for (std::size_t i = 0; i < 4; ++i)
    {
        Plane plane;
        if (!FindPlane(corners, i, kInkBits, 0.5, plane)) // so that floor in the shader rounds
        {
            return false;
        }
        shared.ink[i] = plane.at;
        shared.inkX[i] = plane.alongX;
        shared.inkY[i] = plane.alongY;
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
        Plane plane;
        if (!FindPlane(corners, 4 + i, kTexelBits, 0.0, plane))
        {
            return false;
        }
        shared.texel[i] = plane.at;
        shared.texel[2 + i] = plane.alongX;
        shared.texelY[i] = plane.alongY;
    }
    return true;
}

/// True if it may contain a pixel centre of the rectangle, judged by its bounds.
bool MayTouch(const std::array<Corner, 3>& c, const PixelBounds& rectangle)
{
    const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
    return left < rectangle.x1 && right > rectangle.x0 && top < rectangle.y1 &&
           bottom > rectangle.y0;
}

} // namespace

void BuildMesh(const Overlay& overlay, std::span<const PixelBounds> rectangles, int textureWidth,
               int textureHeight, OverlayMesh& mesh)
{
    mesh.corners.clear();
    mesh.runs.clear();
    const auto isFinite = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
    const auto add = [&](std::size_t firstIndex, const PixelBounds& bounds) {
        std::array<Corner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const OverlayVertex& v = overlay.vertices[overlay.indices[firstIndex + i]];
            if (!isFinite(v.position) || !isFinite(v.uv))
            {
                return;
            }
            corners[i] = CornerOf(v, textureWidth, textureHeight);
        }
        MeshCorner corner;
        if (MayTouch(corners, bounds) && FindPlanes(corners, corner))
        {
            for (const Corner& c : corners)
            {
                corner.pixel = {float(c.x), float(c.y)};
                mesh.corners.push_back(corner);
            }
        }
    };
    for (const PixelBounds& rectangle : rectangles)
    {
        for (const OverlayCommand& command : overlay.commands)
        {
            const PixelBounds bounds = Intersection(
                rectangle, {command.clipX0, command.clipY0, command.clipX1, command.clipY1});
            const std::size_t first = mesh.corners.size();
            for (std::size_t i = 0; !bounds.IsEmpty() && i + 2 < command.indexCount; i += 3)
            {
                add(command.firstIndex + i, bounds);
            }
            if (mesh.corners.size() > first)
            {
                mesh.runs.push_back({bounds, first, mesh.corners.size() - first});
            }
        }
    }
}

} // namespace boxreel
