// SPDX-License-Identifier: MIT
#include "Parts.h"

#include "Convex.h"
#include "Shaders.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// Parts of up to this many pixels are not cut: a quad costs as much as a few thousand pixels.
constexpr double kSmallPart = 2000.0;

// Number of rows of a small part that are tested together [px].
constexpr int kBand = 4;

// Each cut halves a part, so there are at most 2^kMaxCuts parts.
constexpr int kMaxCuts = 5;

// Larger squares [px] are drawn as two triangles: every GL supports points of this size, and the
// gain decreases.
constexpr int kMaxSquare = 63;

// Discs with a larger radius [px] are drawn as their visible rectangle, because the quad around
// them is not exact. Other shapes have been clipped near the picture.
constexpr float kVastRadius = 16384.0f;

bool IsDrawnAsRectangle(ProgramKind kind, std::span<const float> attributes)
{
    return kind == ProgramKind::Glyph ||
           (kind == ProgramKind::Disc && !(attributes[5] < kVastRadius));
}

Batches::Part PartOf(const PixelBounds& b)
{
    return {float(b.x0), float(b.y0), float(b.x1), float(b.y1)};
}

/// True if a square around the shape is not larger than its quad: discs. Polygons and boxes do not
/// gain from it.
bool IsDrawnAsSquare(const Instance& instance)
{
    const PixelBounds& b = instance.bounds;
    return instance.kind == ProgramKind::Disc && std::max(b.x1 - b.x0, b.y1 - b.y0) <= kMaxSquare;
}

/// Returns the quad of the shaders around a shape, as a polygon. The first attributes of all shapes
/// are centre, axis, and half extents or their source.
Convex QuadAround(ProgramKind kind, std::span<const float> a)
{
    const Point center{a[0], a[1]};
    const Point axis{a[2], a[3]};
    const bool isRound = kind == ProgramKind::Disc || kind == ProgramKind::Capsule;
    const double along = isRound ? double(a[4]) + double(a[5]) : double(a[4]);
    const Point u = (along + kQuadMargin) * axis;
    const Point v = (double(a[5]) + kQuadMargin) * Point{-axis.y, axis.x};
    Convex quad;
    quad.Add(center - u - v);
    quad.Add(center + u - v);
    quad.Add(center + u + v);
    quad.Add(center - u + v);
    return quad;
}

/// Returns the whole pixels around a polygon, within `within`.
PixelBounds PixelsAround(const Convex& polygon, const PixelBounds& within)
{
    Point lower = polygon.corners[0];
    Point upper = lower;
    for (std::size_t i = 1; i < polygon.count; ++i)
    {
        lower = {std::min(lower.x, polygon.corners[i].x), std::min(lower.y, polygon.corners[i].y)};
        upper = {std::max(upper.x, polygon.corners[i].x), std::max(upper.y, polygon.corners[i].y)};
    }
    // The polygon is clipped to `within`, so there is no overflow.
    return Intersection({int(std::floor(lower.x)), int(std::floor(lower.y)),
                         int(std::ceil(upper.x)), int(std::ceil(upper.y))},
                        within);
}

bool AddCut(const Instance& instance, std::span<const float> attributes, const Convex& quad,
            const PixelBounds& within, int cuts, Batches& batches)
{
    const Convex inside =
        Clip(quad, {double(within.x0), double(within.y0)}, {double(within.x1), double(within.y1)});
    const PixelBounds part = inside.count < 3 ? PixelBounds{} : PixelsAround(inside, within);
    if (part.IsEmpty())
    {
        return false;
    }
    const double area = double(part.Area());
    if (area <= kSmallPart || area <= 2.0 * inside.Area() || cuts == 0)
    {
        batches.Add(instance.kind, Form::Quad, part, PartOf(part), attributes);
        return true;
    }
    PixelBounds first = part;
    PixelBounds second = part;
    if (part.x1 - part.x0 >= part.y1 - part.y0)
    {
        first.x1 = second.x0 = (part.x0 + part.x1) / 2;
    }
    else
    {
        first.y1 = second.y0 = (part.y0 + part.y1) / 2;
    }
    const bool drewFirst = AddCut(instance, attributes, quad, first, cuts - 1, batches);
    const bool drewSecond = AddCut(instance, attributes, quad, second, cuts - 1, batches);
    return drewFirst || drewSecond;
}

} // namespace

namespace
{

/// Returns the part of a rectangle within its bounds that an instance can touch; may be empty.
PixelBounds Tightened(const Instance& instance, std::span<const float> attributes,
                      const PixelBounds& part)
{
    const Footprint footprint(instance.kind, instance.bounds, attributes);
    PixelBounds tight{part.x1, part.y1, part.x0, part.y0};
    for (int y = part.y0; y < part.y1; y += kBand)
    {
        const int end = std::min(y + kBand, part.y1);
        const Footprint::Span span = footprint.Between(y, end);
        const int x0 = std::max(span.x0, part.x0);
        const int x1 = std::min(span.x1, part.x1);
        if (x0 < x1)
        {
            tight = {std::min(tight.x0, x0), std::min(tight.y0, y), std::max(tight.x1, x1), end};
        }
    }
    return tight;
}

} // namespace

void AddWhole(const Instances& all, const Instance& instance, Batches& batches)
{
    const std::span<const float> attributes = all.AttributesOf(instance);
    const bool isSquare = IsDrawnAsSquare(instance);
    const bool isRectangle = isSquare || IsDrawnAsRectangle(instance.kind, attributes);
    batches.Add(instance.kind, isSquare ? Form::Square : Form::Quad, instance.bounds,
                isRectangle ? PartOf(instance.bounds) : Batches::Part{}, attributes);
}

bool AddPart(const Instances& all, const Instance& instance, const PixelBounds& rectangle,
             Batches& batches)
{
    PixelBounds part = Intersection(instance.bounds, rectangle);
    if (part.IsEmpty())
    {
        return false;
    }
    if (part == instance.bounds)
    {
        AddWhole(all, instance, batches);
        return true;
    }
    const std::span<const float> attributes = all.AttributesOf(instance);
    if (double(part.Area()) <= kSmallPart)
    {
        part = Tightened(instance, attributes, part);
        if (part.IsEmpty())
        {
            return false;
        }
    }
    if (IsDrawnAsRectangle(instance.kind, attributes) || double(part.Area()) <= kSmallPart)
    {
        batches.Add(instance.kind, Form::Quad, part, PartOf(part), attributes);
        return true;
    }
    return AddCut(instance, attributes, QuadAround(instance.kind, attributes), part, kMaxCuts,
                  batches);
}

} // namespace boxreel
