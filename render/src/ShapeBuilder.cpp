// SPDX-License-Identifier: MIT
#include "ShapeBuilder.h"

#include "Shaders.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace boxreel
{
namespace
{

// Half a pixel's diagonal: geometry further from a pixel's centre does not affect it.
constexpr double kPixelReach = 0.7072;

// Coordinates further outside the frame than this [px] are clipped before the conversion to float,
// whose rounding would be visible.
constexpr double kGuard = 4096.0;

// Four corners this close to a rectangle [px] are drawn as one; edges move by less than one grey
// level in 255.
constexpr double kBoxTolerance = 0.005;

// For small shapes the approximations of coverage are too inexact. The product of two slabs is too
// large, as is a tangent half plane for a disc. Below these half extents, outline included [px],
// the exact area of a polygon is used.
constexpr double kSmallBox = 2.0;
constexpr double kSmallDisc = 2.1;

// A round line end of half width h covers pi/2 h^2, as a square end that is longer by this factor
// of h.
constexpr double kSquareCap = std::numbers::pi / 4.0;

// Lines thicker than this [px] have exact round ends; in thinner ones the difference is invisible.
constexpr double kThinLine = 3.0;

// Cosine and sine of the corners of a regular 12-gon, scaled to the area of the unit circle (a
// 12-gon of radius R has the area 3 R^2).
constexpr double kTwelveStretch = 1.0233267079464885; // sqrt(pi / 3)
constexpr double kTwelveLong = 0.8660254037844386;    // cos 30 degrees
constexpr std::array<Point, 12> kTwelve{{{1.0, 0.0},
                                         {kTwelveLong, 0.5},
                                         {0.5, kTwelveLong},
                                         {0.0, 1.0},
                                         {-0.5, kTwelveLong},
                                         {-kTwelveLong, 0.5},
                                         {-1.0, 0.0},
                                         {-kTwelveLong, -0.5},
                                         {-0.5, -kTwelveLong},
                                         {0.0, -1.0},
                                         {0.5, -kTwelveLong},
                                         {kTwelveLong, -0.5}}};

bool IsFinite(Point p)
{
    return std::isfinite(p.x) && std::isfinite(p.y);
}

std::array<float, 4> Premultiplied(double r, double g, double b, double a)
{
    const double scale = a / 255.0;
    return {float(r * scale), float(g * scale), float(b * scale), float(a)};
}

std::array<float, 4> Opaque(Color color)
{
    return Premultiplied(color.r, color.g, color.b, color.a / 255.0);
}

Convex TwelveGon(Point center, double radius)
{
    Convex polygon;
    for (const Point corner : kTwelve)
    {
        polygon.Add(center + (radius * kTwelveStretch) * corner);
    }
    return polygon;
}

/// Returns four corners in order as a rectangle, if they form one.
std::optional<OrientedBox> AsBox(const Convex& p)
{
    if (p.count != 4)
    {
        return std::nullopt;
    }
    const Point diagonals = (p.corners[0] + p.corners[2]) - (p.corners[1] + p.corners[3]);
    const Point u = p.corners[1] - p.corners[0];
    const Point v = p.corners[2] - p.corners[1];
    const double length = Length(u);
    if (Length(diagonals) > kBoxTolerance ||
        std::abs(Dot(u, v)) > kBoxTolerance * std::min(length, Length(v)))
    {
        return std::nullopt;
    }
    return OrientedBox{0.25 * (p.corners[0] + p.corners[1] + p.corners[2] + p.corners[3]),
                       (1.0 / length) * u,
                       {0.5 * length, 0.5 * Length(v)}};
}

} // namespace

ShapeBuilder::ShapeBuilder(const Theme& theme, double scale)
    : m_theme(theme), m_scale(scale), m_outlineWidth(scale * theme.outlineWidth)
{}

void ShapeBuilder::Add(const DrawList& list, const DrawItem& item, Instances& instances)
{
    m_instances = &instances;
    AddItem(list, item);
}

bool ShapeBuilder::AddItem(const DrawList& list, const DrawItem& item)
{
    assert(std::size_t(item.first) + item.count <= list.points.size() &&
           "a DrawItem's points lie outside its list");
    const Vec2* const points = list.points.data() + item.first;
    if (item.count == 0 ||
        std::any_of(points, points + item.count,
                    [](Vec2 p) { return !std::isfinite(p.x) || !std::isfinite(p.y); }) ||
        !std::isfinite(item.size))
    {
        return false;
    }
    const double meters = m_camera.pixelsPerMeter;
    const double width = m_outlineWidth;
    const Rgba stroke = Opaque(m_theme.Outline(item.Asked()));
    switch (item.kind)
    {
    case DrawKind::Polygon:
        return AddOutline(points, item.count, stroke);
    case DrawKind::SolidPolygon:
        return AddSolidPolygon(points, item.count, SolidPaint(item));
    case DrawKind::Circle:
        return AddDisc(ToPixel(points[0]), item.size * meters, std::nullopt, width, {stroke, {}});
    case DrawKind::SolidCircle:
        return AddDisc(ToPixel(points[0]), item.size * meters, Point{points[1].x, -points[1].y},
                       width, SolidPaint(item));
    case DrawKind::Segment:
        return AddLine(ToPixel(points[0]), ToPixel(points[1]), width, stroke);
    case DrawKind::Transform:
        return AddTransform(points, item.size);
    case DrawKind::Point:
        // A disc that is only outline.
        return AddDisc(ToPixel(points[0]), 0.25 * m_scale * item.size, std::nullopt,
                       0.5 * m_scale * item.size, {stroke, {}});
    case DrawKind::Text:
        return AddText(points[0], list.texts[item.text], stroke);
    }
    return false;
}

Point ShapeBuilder::ToPixel(Vec2 world) const
{
    return {0.5 * m_camera.width + (world.x - m_camera.centerX) * m_camera.pixelsPerMeter,
            0.5 * m_camera.height - (world.y - m_camera.centerY) * m_camera.pixelsPerMeter};
}

std::optional<PixelBounds> ShapeBuilder::InPicture(Point lower, Point upper) const
{
    // Clamped before the conversion to integers, to avoid overflow.
    const auto limit = [](double value, int maximum) {
        return int(std::clamp(value, 0.0, double(maximum)));
    };
    const PixelBounds bounds{
        limit(std::floor(lower.x), m_camera.width), limit(std::floor(lower.y), m_camera.height),
        limit(std::ceil(upper.x), m_camera.width), limit(std::ceil(upper.y), m_camera.height)};
    return bounds.IsEmpty() ? std::nullopt : std::optional(bounds);
}

ShapeBuilder::Paint ShapeBuilder::SolidPaint(const DrawItem& item) const
{
    const boxreel::Paint asked = item.Asked();
    if (item.layer == DrawLayer::Annotations)
    {
        const Rgba ink = Opaque(m_theme.Outline(asked));
        return {ink, ink};
    }
    const Color fill = m_theme.Fill(asked);
    const double alpha = m_theme.fillAlpha * asked.color.a / 255.0;
    const double shade = m_theme.fillShade;
    return {Opaque(m_theme.Outline(asked)),
            Premultiplied(shade * fill.r, shade * fill.g, shade * fill.b, alpha)};
}

bool ShapeBuilder::AddSolidPolygon(const Vec2* points, std::size_t count, const Paint& paint)
{
    if (count > kMaxCorners - 4)
    {
        return AddOutline(points, count, paint.stroke); // more corners than polygons have
    }
    std::array<Point, kMaxCorners> corners;
    std::transform(points, points + count, corners.begin(), [this](Vec2 p) { return ToPixel(p); });
    Convex polygon = MakeConvex(corners.data(), count);
    if (polygon.count < 3) // degenerate: a line between its two furthest corners
    {
        return AddOutline(points, count, paint.stroke);
    }
    const double width = m_outlineWidth;
    const double guard = kGuard + 2.0 * width;
    const Point lower{-guard, -guard};
    const Point upper{m_camera.width + guard, m_camera.height + guard};
    const bool far = std::any_of(
        polygon.corners.begin(), polygon.corners.begin() + std::ptrdiff_t(polygon.count),
        [&](Point p) { return p.x < lower.x || p.y < lower.y || p.x > upper.x || p.y > upper.y; });
    if (far)
    {
        polygon = Clip(polygon, lower, upper);
        if (polygon.count < 3)
        {
            return false;
        }
    }
    const std::optional<OrientedBox> box = AsBox(polygon);
    if (box && std::max(box->half.x, box->half.y) + 0.5 * width >= kSmallBox)
    {
        return EmitBox(*box, width, paint);
    }
    return EmitPolygon(Grow(polygon, 0.5 * width), Shrink(polygon, 0.5 * width), paint);
}

bool ShapeBuilder::AddOutline(const Vec2* points, std::size_t count, const Rgba& stroke)
{
    bool drawn = false;
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::size_t next = (i + 1) % count;
        if (next == 0 && count == 2)
        {
            break; // the reverse direction is the same line
        }
        drawn |= AddLine(ToPixel(points[i]), ToPixel(points[next]), m_outlineWidth, stroke);
    }
    return drawn;
}

bool ShapeBuilder::AddDisc(Point center, double radius, std::optional<Point> axis,
                           double outlineWidth, const Paint& paint)
{
    radius = std::abs(radius);
    const double half = 0.5 * outlineWidth;
    const double outer = radius + half;
    const double inner = radius - half;
    const Point direction =
        axis && Length(*axis) > 0.0 ? (1.0 / Length(*axis)) * *axis : Point{1.0, 0.0};
    if (outer < kSmallDisc)
    {
        const Convex hole = inner > 0.0 ? TwelveGon(center, inner) : Convex{};
        const bool drawn = outer > 0.0 && EmitPolygon(TwelveGon(center, outer), hole, paint);
        if (drawn && axis && inner > 0.0)
        {
            AddLine(center, center + radius * direction, outlineWidth, paint.stroke);
        }
        return drawn;
    }
    return EmitRound({center, direction, {0.0, 0.0}}, outer, inner, axis ? half : 0.0, paint);
}

bool ShapeBuilder::AddLine(Point a, Point b, double width, const Rgba& color)
{
    const double length = Length(b - a);
    const Point direction = length > 0.0 ? (1.0 / length) * (b - a) : Point{1.0, 0.0};
    const double guard = kGuard + 2.0 * width;
    const auto range =
        ClipSegment(a, b, {-guard, -guard}, {m_camera.width + guard, m_camera.height + guard});
    if (!range)
    {
        return false;
    }
    const Point from = range->first > 0.0 ? a + range->first * (b - a) : a;
    const Point to = range->second < 1.0 ? a + range->second * (b - a) : b;
    const double half = 0.5 * width;
    const OrientedBox spine{0.5 * (from + to), direction, {0.5 * Length(to - from), 0.0}};
    const Paint paint{color, {}};
    if (width > kThinLine)
    {
        return EmitRound(spine, half, -1.0, 0.0, paint);
    }
    return EmitBox(
        {spine.center, direction, {spine.half.x + (kSquareCap - 0.5) * half, 0.5 * half}}, half,
        paint);
}

bool ShapeBuilder::AddTransform(const Vec2* points, double length)
{
    const Point origin = ToPixel(points[0]);
    const double scale = length * m_camera.pixelsPerMeter;
    const Point x{scale * points[1].x, -scale * points[1].y};
    const Point y{x.y, -x.x}; // rotated by 90 degrees to the left, with y down
    const bool drawnX = AddLine(origin, origin + x, m_outlineWidth, Opaque(m_theme.xAxis));
    const bool drawnY = AddLine(origin, origin + y, m_outlineWidth, Opaque(m_theme.yAxis));
    return drawnX || drawnY;
}

bool ShapeBuilder::AddText(Vec2 topLeft, const std::string& text, const Rgba& ink)
{
    const Point corner = ToPixel(topLeft);
    const Point at{std::floor(corner.x + 0.5), std::floor(corner.y + 0.5)};
    if (!IsFinite(at) || std::abs(at.x) > 1e6 || std::abs(at.y) > 1e6) // texts are shorter than
                                                                       // that
    {
        return false;
    }
    FontAtlas::Get(m_scale).Layout(text, m_glyphs);
    bool drawn = false;
    for (const GlyphQuad& glyph : m_glyphs)
    {
        const Point lower = at + Point{double(glyph.x), double(glyph.y)};
        const Point upper = lower + Point{double(glyph.width), double(glyph.height)};
        const auto bounds = InPicture(lower, upper);
        if (bounds)
        {
            const std::array<float, 8> attributes{float(glyph.texelX - lower.x),
                                                  float(glyph.texelY - lower.y),
                                                  0.0f,
                                                  0.0f,
                                                  ink[0],
                                                  ink[1],
                                                  ink[2],
                                                  ink[3]};
            m_instances->Add(ProgramKind::Glyph, *bounds, attributes);
            drawn = true;
        }
    }
    return drawn;
}

bool ShapeBuilder::EmitBox(const OrientedBox& box, double outlineWidth, const Paint& paint)
{
    const double half = 0.5 * outlineWidth;
    const Point u = box.axis;
    const Point outer{box.half.x + half, box.half.y + half};
    const Point inner{box.half.x - half, box.half.y - half};
    const bool hollow = inner.x > 0.0 && inner.y > 0.0;
    const Point reach{std::abs(u.x) * outer.x + std::abs(u.y) * outer.y + 0.5,
                      std::abs(u.y) * outer.x + std::abs(u.x) * outer.y + 0.5};
    const auto bounds = InPicture(box.center - reach, box.center + reach);
    if (!bounds)
    {
        return false;
    }
    const std::array<float, 16> attributes{float(box.center.x),
                                           float(box.center.y),
                                           float(u.x),
                                           float(u.y),
                                           float(outer.x),
                                           float(outer.y),
                                           hollow ? float(inner.x) : 0.0f,
                                           hollow ? float(inner.y) : 0.0f,
                                           paint.stroke[0],
                                           paint.stroke[1],
                                           paint.stroke[2],
                                           paint.stroke[3],
                                           paint.fill[0],
                                           paint.fill[1],
                                           paint.fill[2],
                                           paint.fill[3]};
    const bool isWide = std::min(inner.x, inner.y) >= kPixelReach;
    m_instances->Add(isWide ? ProgramKind::Box : ProgramKind::ThinBox, *bounds, attributes);
    return true;
}

bool ShapeBuilder::EmitRound(const OrientedBox& spine, double outerRadius, double innerRadius,
                             double axisHalf, const Paint& paint)
{
    const Point u = spine.axis;
    const double length = spine.half.x;
    const Point reach{std::abs(u.x) * length + outerRadius + 0.5,
                      std::abs(u.y) * length + outerRadius + 0.5};
    const auto bounds = InPicture(spine.center - reach, spine.center + reach);
    if (!bounds)
    {
        return false;
    }
    const std::array<float, 16> attributes{float(spine.center.x),
                                           float(spine.center.y),
                                           float(u.x),
                                           float(u.y),
                                           float(length),
                                           float(outerRadius),
                                           float(innerRadius > 0.0 ? innerRadius : -2.0),
                                           float(axisHalf),
                                           paint.stroke[0],
                                           paint.stroke[1],
                                           paint.stroke[2],
                                           paint.stroke[3],
                                           paint.fill[0],
                                           paint.fill[1],
                                           paint.fill[2],
                                           paint.fill[3]};
    m_instances->Add(length > 0.0 || innerRadius < 0.0 ? ProgramKind::Capsule : ProgramKind::Disc,
                     *bounds, attributes);
    return true;
}

bool ShapeBuilder::EmitPolygon(const Convex& outer, const Convex& inner, const Paint& paint)
{
    const OrientedBox quad = BoxAround(outer);
    const Point u = quad.axis;
    const Point reach{std::abs(u.x) * quad.half.x + std::abs(u.y) * quad.half.y + 0.5,
                      std::abs(u.y) * quad.half.x + std::abs(u.x) * quad.half.y + 0.5};
    const auto bounds = InPicture(quad.center - reach, quad.center + reach);
    if (!bounds)
    {
        return false;
    }
    // Pixels with a centre this close to the middle are completely filled.
    const double core = InsideDistance(inner, quad.center) - kPixelReach;
    ProgramKind kind = ProgramKind::ManyCorners;
    for (const ProgramKind smaller : {ProgramKind::LargePolygon, ProgramKind::Polygon,
                                      ProgramKind::Hexagon, ProgramKind::SmallPolygon})
    {
        const CornerSlots room = SlotsOf(smaller);
        kind = outer.count <= room.outer && inner.count <= room.inner ? smaller : kind;
    }
    const CornerSlots slots = SlotsOf(kind);

    std::array<float, 16 + 8 * kMaxCorners> attributes;
    std::size_t used = 0;
    const auto put = [&](double value) { attributes[used++] = float(value); };
    for (const double value :
         {quad.center.x, quad.center.y, u.x, u.y, quad.half.x, quad.half.y, core, 0.0})
    {
        put(value);
    }
    std::copy(paint.stroke.begin(), paint.stroke.end(), attributes.begin() + 8);
    std::copy(paint.fill.begin(), paint.fill.end(), attributes.begin() + 12);
    used = 16;
    const auto putCorners = [&](const Convex& polygon, std::size_t room) {
        for (std::size_t i = 0; i < room; ++i)
        {
            // Unused corners repeat the last: an edge of zero length has no area below it.
            const auto cornerAt = [&](std::size_t k) {
                return polygon.count ? polygon.corners[std::min(k, polygon.count - 1)]
                                     : quad.center;
            };
            const Point corner = cornerAt(i);
            put(corner.x);
            put(corner.y);
            if (kind == ProgramKind::ManyCorners) // an edge with its slope
            {
                const Point run = cornerAt(i + 1 < room ? i + 1 : 0) - corner;
                put(run.x == 0.0 ? 0.0 : run.y / run.x);
                put(0.0);
            }
        }
    };
    putCorners(outer, slots.outer);
    putCorners(inner, slots.inner);
    m_instances->Add(kind, *bounds, {attributes.data(), used});
    return true;
}

} // namespace boxreel
