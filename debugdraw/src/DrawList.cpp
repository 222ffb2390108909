// SPDX-License-Identifier: MIT
#include <debugdraw/DrawList.h>

#include <algorithm>
#include <cassert>

namespace boxreel
{

void Rect::Include(Vec2 point)
{
    Include(Rect{point, point});
}

void Rect::Include(const Rect& other)
{
    if (other.IsEmpty())
    {
        return;
    }
    if (IsEmpty())
    {
        *this = other;
        return;
    }
    lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y)};
    upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y)};
}

namespace
{

/// True if all turns have the same direction; nearly collinear vertices, within a thousandth of
/// their sides, may turn either way.
bool TurnsOneWay(const Vec2* corners, std::size_t count)
{
    constexpr double kStraight = 1e-3;
    bool left = false;
    bool right = false;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec2 a = corners[i];
        const Vec2 b = corners[(i + 1) % count];
        const Vec2 c = corners[(i + 2) % count];
        const double ux = double(b.x) - a.x;
        const double uy = double(b.y) - a.y;
        const double vx = double(c.x) - b.x;
        const double vy = double(c.y) - b.y;
        const double turn = ux * vy - uy * vx;
        const double straight = kStraight * (ux * ux + uy * uy + vx * vx + vy * vy);
        left = left || turn > straight;
        right = right || turn < -straight;
    }
    return !(left && right);
}

} // namespace

DrawItem& DrawList::Add(DrawKind kind, const Vec2* vertices, std::size_t count, const Paint& paint)
{
    assert(count <= 0xffff && "an item has at most 65535 points");
    DrawItem item;
    item.kind = kind;
    item.layer = layer;
    item.count = static_cast<std::uint16_t>(count);
    item.first = static_cast<std::uint32_t>(points.size());
    item.owner = owner;
    item.color = paint.color;
    item.role = paint.role;
    points.insert(points.end(), vertices, vertices + count);
    items.push_back(item);
    return items.back();
}

void DrawList::AddPolygon(const Vec2* vertices, std::size_t count, const Paint& paint)
{
    Add(DrawKind::Polygon, vertices, count, paint);
}

void DrawList::AddSolidPolygon(const Vec2* vertices, std::size_t count, const Paint& paint)
{
    constexpr std::size_t kMaxCorners = 16; // limit of renderers; pieces would show seams
    const bool fills = count <= kMaxCorners && TurnsOneWay(vertices, count);
    Add(fills ? DrawKind::SolidPolygon : DrawKind::Polygon, vertices, count, paint);
}

void DrawList::AddCircle(Vec2 center, float radius, const Paint& paint)
{
    Add(DrawKind::Circle, &center, 1, paint).size = radius;
}

void DrawList::AddSolidCircle(Vec2 center, float radius, Vec2 axis, const Paint& paint)
{
    const Vec2 both[2] = {center, axis};
    Add(DrawKind::SolidCircle, both, 2, paint).size = radius;
}

void DrawList::AddSegment(Vec2 a, Vec2 b, const Paint& paint)
{
    const Vec2 both[2] = {a, b};
    Add(DrawKind::Segment, both, 2, paint);
}

void DrawList::AddTransform(Vec2 origin, Vec2 xAxis, float axisLength)
{
    const Vec2 both[2] = {origin, xAxis};
    Add(DrawKind::Transform, both, 2, Color{255, 255, 255, 255}).size = axisLength;
}

void DrawList::AddPoint(Vec2 center, float diameterPixels, const Paint& paint)
{
    Add(DrawKind::Point, &center, 1, paint).size = diameterPixels;
}

void DrawList::AddText(Vec2 topLeft, std::string_view text, const Paint& paint)
{
    Add(DrawKind::Text, &topLeft, 1, paint).text = static_cast<std::uint32_t>(texts.size());
    texts.emplace_back(text);
}

void DrawList::Clear()
{
    items.clear();
    points.clear();
    texts.clear();
    layer = DrawLayer::Shapes;
    owner = kNoOwner;
}

ColorRole EngineRole(DrawLayer layer, Color color)
{
    const auto find = [color](ColorRole first, ColorRole last) {
        for (auto role = std::size_t(first); role <= std::size_t(last); ++role)
        {
            if (kClassicPalette[role] == color)
            {
                return ColorRole(role);
            }
        }
        return ColorRole::None;
    };
    switch (layer)
    {
    case DrawLayer::Shapes:
        return find(ColorRole::StaticBody, ColorRole::InactiveBody);
    case DrawLayer::Joints:
        return find(ColorRole::Joint, ColorRole::Joint);
    case DrawLayer::Pairs:
        return find(ColorRole::Pair, ColorRole::Pair);
    case DrawLayer::Aabbs:
        return find(ColorRole::Aabb, ColorRole::Aabb);
    default:
        return ColorRole::None;
    }
}

} // namespace boxreel
