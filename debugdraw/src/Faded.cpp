// SPDX-License-Identifier: MIT
#include <debugdraw/Faded.h>

#include <cassert>
#include <cmath>

namespace boxreel
{
namespace
{

/// Copies an item with its points and text.
DrawItem& Copy(DrawList& to, const DrawList& from, const DrawItem& item)
{
    DrawItem copy = item;
    copy.first = static_cast<std::uint32_t>(to.points.size());
    const auto first = from.points.begin() + std::ptrdiff_t(item.first);
    to.points.insert(to.points.end(), first, first + item.count);
    if (item.kind == DrawKind::Text)
    {
        copy.text = static_cast<std::uint32_t>(to.texts.size());
        to.texts.push_back(from.texts[item.text]);
    }
    to.items.push_back(copy);
    return to.items.back();
}

/// Returns the owner's items, in order.
std::vector<const DrawItem*> ItemsOf(const DrawList& list, std::uint32_t owner)
{
    std::vector<const DrawItem*> items;
    for (const DrawItem& item : list.items)
    {
        if (item.owner == owner)
        {
            items.push_back(&item);
        }
    }
    return items;
}

bool IsNear(Vec2 a, Vec2 b, double distance)
{
    return std::abs(double(a.x) - b.x) <= distance && std::abs(double(a.y) - b.y) <= distance;
}

/// Returns a position; an axis, which is a direction, is converted to a point at the item's size
/// from its centre.
Vec2 PlaceOf(const DrawList& list, const DrawItem& item, std::size_t point)
{
    const Vec2* const points = list.points.data() + item.first;
    const bool isAxis =
        point == 1 && (item.kind == DrawKind::SolidCircle || item.kind == DrawKind::Transform);
    return isAxis
               ? Vec2{points[0].x + item.size * points[1].x, points[0].y + item.size * points[1].y}
               : points[point];
}

} // namespace

void Append(DrawList& to, const DrawList& from, const ItemFilter& filter)
{
    assert(&to != &from);
    for (const DrawItem& item : from.items)
    {
        if (!filter || filter(item))
        {
            Copy(to, from, item);
        }
    }
}

void AddFaded(DrawList& to, const DrawList& from, double opacity, const ItemFilter& filter)
{
    assert(&to != &from);
    assert(opacity >= 0.0 && opacity <= 1.0);
    for (const DrawItem& item : from.items)
    {
        if (item.kind == DrawKind::Transform || (filter && !filter(item)))
        {
            continue;
        }
        DrawItem& copy = Copy(to, from, item);
        copy.layer = DrawLayer::Poses;
        copy.color.a = static_cast<std::uint8_t>(std::floor(opacity * item.color.a + 0.5));
    }
}

bool StandsStill(const DrawList& before, const DrawList& after, std::uint32_t owner,
                 double distance)
{
    const std::vector<const DrawItem*> old = ItemsOf(before, owner);
    const std::vector<const DrawItem*> now = ItemsOf(after, owner);
    bool stands = old.size() == now.size();
    for (std::size_t i = 0; stands && i < old.size(); ++i)
    {
        stands = old[i]->kind == now[i]->kind && old[i]->count == now[i]->count;
        for (std::size_t k = 0; stands && k < old[i]->count; ++k)
        {
            stands = IsNear(PlaceOf(before, *old[i], k), PlaceOf(after, *now[i], k), distance);
        }
    }
    return stands;
}

} // namespace boxreel
