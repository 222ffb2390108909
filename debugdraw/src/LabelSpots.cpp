// SPDX-License-Identifier: MIT
#include "LabelSpots.h"

#include <debugdraw/TextWidth.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxreel
{

namespace
{

constexpr double kCell = 64.0; // [px]
constexpr double kTouch = 0.5; // boxes that overlap by less do not [px]

// From the place to the nearest edge of the label [px]: beside a hinge or a centre of mass, beside
// a hinge with a motor, beside a gear.
constexpr double kDistances[] = {9.0, 17.0, 25.0};

// As on maps: above on the right first, and straight beside it last, where lines are likely.
constexpr double kDirections[][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1},
                                     {1, 0}, {-1, 0}, {0, 1},  {0, -1}};

bool IsInTheWay(DrawLayer layer)
{
    return layer == DrawLayer::JointGlyphs || layer == DrawLayer::CentersOfMass ||
           layer == DrawLayer::Labels;
}

/// What of the segment from a to b, from share `t0` to share `t1` of it, lies between two bounds.
bool Clip(double a, double b, double lower, double upper, double& t0, double& t1)
{
    const double way = b - a;
    if (way == 0.0)
    {
        return a >= lower && a <= upper;
    }
    const double in = (lower - a) / way;
    const double out = (upper - a) / way;
    t0 = std::max(t0, std::min(in, out));
    t1 = std::min(t1, std::max(in, out));
    return t0 <= t1;
}

int CellOf(double pixels)
{
    return static_cast<int>(std::floor(pixels / kCell));
}

} // namespace

LabelSpots::LabelSpots(const Camera& camera, const DrawList& list) : m_camera(camera)
{
    for (const DrawItem& item : list.items)
    {
        if (IsInTheWay(item.layer))
        {
            AddItem(list, item);
        }
    }
}

void LabelSpots::AddItem(const DrawList& list, const DrawItem& item)
{
    const double scale = m_camera.pixelsPerMeter;
    const auto x = [&](Vec2 p) { return (double(p.x) - m_camera.centerX) * scale; };
    const auto y = [&](Vec2 p) { return (double(p.y) - m_camera.centerY) * scale; };
    const Vec2* const points = list.points.data() + item.first;
    if (item.kind == DrawKind::Segment)
    {
        Add({x(points[0]), y(points[0]), x(points[1]), y(points[1]), true});
    }
    else if (item.kind == DrawKind::Text)
    {
        const double width = TextWidth(list.texts[item.text]);
        Add({x(points[0]), y(points[0]) - kTextHeight, x(points[0]) + width, y(points[0]), false});
    }
    else
    {
        Rect box;
        for (std::size_t i = 0; i < item.count; ++i)
        {
            // The second point of these two kinds is a direction.
            const bool isPlace =
                i == 0 || (item.kind != DrawKind::SolidCircle && item.kind != DrawKind::Transform);
            box.Include(isPlace ? points[i] : points[0]);
        }
        const double reach =
            item.kind == DrawKind::Point ? 0.5 * double(item.size) : double(item.size) * scale;
        Add({x(box.lower) - reach, y(box.lower) - reach, x(box.upper) + reach, y(box.upper) + reach,
             false});
    }
}

/// As much of it as lies in the picture: what lies outside must not matter, for a list may have it
/// or not, and the picture be the same.
void LabelSpots::Add(const Thing& thing)
{
    const double right = 0.5 * m_camera.width;
    const double up = 0.5 * m_camera.height;
    double t0 = 0.0;
    double t1 = 1.0;
    if (!Clip(thing.x0, thing.x1, -right, right, t0, t1) ||
        !Clip(thing.y0, thing.y1, -up, up, t0, t1))
    {
        return;
    }
    const auto [left, rightmost] =
        std::minmax({thing.x0 + t0 * (thing.x1 - thing.x0), thing.x0 + t1 * (thing.x1 - thing.x0)});
    const auto [low, high] =
        std::minmax({thing.y0 + t0 * (thing.y1 - thing.y0), thing.y0 + t1 * (thing.y1 - thing.y0)});
    for (int i = CellOf(left); i <= CellOf(rightmost); ++i)
    {
        for (int j = CellOf(low); j <= CellOf(high); ++j)
        {
            m_cells[{i, j}].push_back(m_things.size());
        }
    }
    m_things.push_back(thing);
}

/// Things in more than one cell may count more than once: only none, and fewer, matter.
int LabelSpots::CountIn(const Thing& box) const
{
    int count = 0;
    for (int i = CellOf(box.x0); i <= CellOf(box.x1); ++i)
    {
        for (int j = CellOf(box.y0); j <= CellOf(box.y1); ++j)
        {
            const auto cell = m_cells.find({i, j});
            if (cell == m_cells.end())
            {
                continue;
            }
            for (const std::size_t index : cell->second)
            {
                const Thing& t = m_things[index];
                double t0 = 0.0;
                double t1 = 1.0;
                const bool meets = t.isLine ? Clip(t.x0, t.x1, box.x0, box.x1, t0, t1) &&
                                                  Clip(t.y0, t.y1, box.y0, box.y1, t0, t1)
                                            : t.x0 < box.x1 - kTouch && box.x0 < t.x1 - kTouch &&
                                                  t.y0 < box.y1 - kTouch && box.y0 < t.y1 - kTouch;
                count += meets ? 1 : 0;
            }
        }
    }
    return count;
}

Vec2 LabelSpots::Take(Vec2 place, double width, double height)
{
    const double scale = m_camera.pixelsPerMeter;
    const double x = (double(place.x) - m_camera.centerX) * scale;
    const double y = (double(place.y) - m_camera.centerY) * scale;
    const double farthest = 1e6; // [px], where nobody looks and cells would not be whole numbers
    if (!(std::abs(x) < farthest && std::abs(y) < farthest))
    {
        return place;
    }
    const auto boxAt = [&](double dx, double dy) {
        return Thing{x + dx - 0.5 * width, y + dy - 0.5 * height, x + dx + 0.5 * width,
                     y + dy + 0.5 * height, false};
    };
    double bestX = 0.0;
    double bestY = 0.0;
    int fewest = CountIn(boxAt(0.0, 0.0));
    for (const double distance : kDistances)
    {
        for (const auto& [right, up] : kDirections)
        {
            // A corner is nearer to the place than a side: there it may come closer.
            const double away = right != 0.0 && up != 0.0 ? 0.7 * distance : distance;
            const double dx = right * (away + 0.5 * width);
            const double dy = up * (away + 0.5 * height);
            const int count = fewest > 0 ? CountIn(boxAt(dx, dy)) : fewest;
            if (count < fewest)
            {
                fewest = count;
                bestX = dx;
                bestY = dy;
            }
        }
    }
    Add(boxAt(bestX, bestY));
    return {float(place.x + bestX / scale), float(place.y + bestY / scale)};
}

} // namespace boxreel
