// SPDX-License-Identifier: MIT
#pragma once

#include "Convex.h"
#include "FontAtlas.h"
#include "Instances.h"

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>

#include <array>
#include <optional>
#include <vector>

/// Converts the items of a DrawList into shader instances, in pixels. Pure arithmetic in double,
/// converted to float at the end, so that the same list gives the same bits on any machine. Called
/// by Renderer; independent of GL.
///
/// The meaning of the attributes is documented beside the shaders, in Shaders.cpp.
namespace boxreel
{

class ShapeBuilder
{
public:
    /// `scale`: factor of outlines, points and text.
    ShapeBuilder(const Theme& theme, double scale);

    /// Sets the camera of the items that follow. Its size is that of the picture; its numbers are
    /// finite and its scale is positive.
    void SetCamera(const Camera& camera) { m_camera = camera; }

    /// Adds the visible part of the item: nothing if it is outside or not finite.
    void Add(const DrawList& list, const DrawItem& item, Instances& instances);

private:
    /// Premultiplied, 0 to 1.
    using Rgba = std::array<float, 4>;

    struct Paint
    {
        Rgba stroke{};
        Rgba fill{};
    };

    bool AddItem(const DrawList& list, const DrawItem& item);
    Point ToPixel(Vec2 world) const;
    std::optional<PixelBounds> InPicture(Point lower, Point upper) const;
    Paint SolidPaint(const DrawItem& item) const;

    bool AddSolidPolygon(const Vec2* points, std::size_t count, const Paint& paint);
    bool AddOutline(const Vec2* points, std::size_t count, const Rgba& stroke);
    bool AddDisc(Point center, double radius, std::optional<Point> axis, double outlineWidth,
                 const Paint& paint);
    bool AddLine(Point a, Point b, double width, const Rgba& color);
    bool AddTransform(const Vec2* points, double length);
    bool AddText(Vec2 topLeft, const std::string& text, const Rgba& ink);

    bool EmitBox(const OrientedBox& box, double outlineWidth, const Paint& paint);
    bool EmitPolygon(const Convex& outer, const Convex& inner, const Paint& paint);
    bool EmitRound(const OrientedBox& spine, double outerRadius, double innerRadius,
                   double axisHalf, const Paint& paint);

    Camera m_camera;
    Theme m_theme;
    double m_scale;
    double m_outlineWidth;            // [px]
    Instances* m_instances = nullptr; // of the current item
    std::vector<GlyphQuad> m_glyphs;
};

} // namespace boxreel
