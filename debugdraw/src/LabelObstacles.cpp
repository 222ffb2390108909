// SPDX-License-Identifier: MIT
#include "LabelObstacles.h"

#include <debugdraw/TextWidth.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{

namespace
{

using labels::Box;
using labels::Point;

constexpr double kSmallestCell = 64.0; // [px]
constexpr double kMaxCells = 64.0;     // per side, for any picture
constexpr double kTouch = 0.5;         // smaller overlaps are ignored [px]

/// Clips the segment from a to b to two bounds; `t0` and `t1` are the parameters of the remaining
/// part.
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

bool Overlap(const Box& a, const Box& b)
{
    return a.lower.x < b.upper.x - kTouch && b.lower.x < a.upper.x - kTouch &&
           a.lower.y < b.upper.y - kTouch && b.lower.y < a.upper.y - kTouch;
}

} // namespace

namespace labels
{

bool Crosses(Point a, Point b, const Box& box)
{
    double t0 = 0.0;
    double t1 = 1.0;
    return Clip(a.x, b.x, box.lower.x, box.upper.x, t0, t1) &&
           Clip(a.y, b.y, box.lower.y, box.upper.y, t0, t1);
}

Point MiddleOf(const Box& box)
{
    return {0.5 * (box.lower.x + box.upper.x), 0.5 * (box.lower.y + box.upper.y)};
}

Box Widened(const Box& box, double by)
{
    return {{box.lower.x - by, box.lower.y - by}, {box.upper.x + by, box.upper.y + by}};
}

} // namespace labels

LabelObstacles::LabelObstacles(const Camera& camera, const DrawList& list)
    : m_camera(camera),
      m_cell(std::max(kSmallestCell, std::max(camera.width, camera.height) / kMaxCells)),
      m_columns(1 + static_cast<int>(camera.width / m_cell)),
      m_rows(1 + static_cast<int>(camera.height / m_cell)),
      m_cells(std::size_t(m_columns) * std::size_t(m_rows))
{
    for (const DrawItem& item : list.items)
    {
        switch (item.layer)
        {
        case DrawLayer::Shapes:
            AddItem(list, item, LabelRole::Shape);
            break;
        case DrawLayer::JointGlyphs:
        case DrawLayer::CentersOfMass:
        case DrawLayer::CenterMarks:
        case DrawLayer::Annotations:
        case DrawLayer::Labels:
            AddItem(list, item, item.kind == DrawKind::Text ? LabelRole::Label : LabelRole::Sign);
            break;
        default:
            break; // lines and arrows that do not make text illegible
        }
    }
}

Point LabelObstacles::ToPixels(Vec2 place) const
{
    return {(double(place.x) - m_camera.centerX) * m_camera.pixelsPerMeter,
            (double(place.y) - m_camera.centerY) * m_camera.pixelsPerMeter};
}

Vec2 LabelObstacles::ToWorld(Point pixels) const
{
    return {float(m_camera.centerX + pixels.x / m_camera.pixelsPerMeter),
            float(m_camera.centerY + pixels.y / m_camera.pixelsPerMeter)};
}

bool LabelObstacles::IsInPicture(Point point) const
{
    return std::abs(point.x) <= 0.5 * m_camera.width && std::abs(point.y) <= 0.5 * m_camera.height;
}

LabelObstacles::Cells LabelObstacles::CellsOf(const Box& box) const
{
    const auto cell = [this](double pixels, int size, int count) {
        const double at = std::clamp(pixels + 0.5 * size, 0.0, double(size));
        return std::min(static_cast<int>(at / m_cell), count - 1);
    };
    return {
        {cell(box.lower.x, m_camera.width, m_columns), cell(box.lower.y, m_camera.height, m_rows)},
        {cell(box.upper.x, m_camera.width, m_columns), cell(box.upper.y, m_camera.height, m_rows)}};
}

void LabelObstacles::AddItem(const DrawList& list, const DrawItem& item, LabelRole role)
{
    if (item.count == 0)
    {
        return;
    }
    const Vec2* const points = list.points.data() + item.first;
    // The second point of these two kinds is a direction.
    const bool isTurned = item.kind == DrawKind::SolidCircle || item.kind == DrawKind::Transform;
    LabelThing thing{role, LabelForm::Box,  item.owner,
                     {},   m_points.size(), isTurned ? 1u : item.count};
    Point lower = ToPixels(points[0]);
    Point upper = lower;
    for (std::size_t i = 0; i < thing.count; ++i)
    {
        const Point p = ToPixels(points[i]);
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    double reach = 0.0;
    switch (item.kind)
    {
    case DrawKind::Polygon:
    case DrawKind::SolidPolygon:
    case DrawKind::Segment:
        thing.form = LabelForm::Lines;
        break;
    case DrawKind::Circle:
    case DrawKind::SolidCircle:
        thing.form = LabelForm::Circle;
        reach = double(item.size) * m_camera.pixelsPerMeter;
        break;
    case DrawKind::Transform:
        reach = double(item.size) * m_camera.pixelsPerMeter;
        break;
    case DrawKind::Point:
        reach = 0.5 * double(item.size);
        break;
    case DrawKind::Text:
        upper.x += TextWidth(list.texts[item.text]);
        lower.y -= kTextHeight;
        break;
    }
    thing.bounds = {{lower.x - reach, lower.y - reach}, {upper.x + reach, upper.y + reach}};
    if (thing.form == LabelForm::Lines)
    {
        for (std::size_t i = 0; i < thing.count; ++i)
        {
            m_points.push_back(ToPixels(points[i]));
        }
    }
    Add(thing);
}

/// Labels are inside the picture, so items outside are ignored.
void LabelObstacles::Add(const LabelThing& thing)
{
    const Box picture{{-0.5 * m_camera.width, -0.5 * m_camera.height},
                      {0.5 * m_camera.width, 0.5 * m_camera.height}};
    // Also rejects NaN.
    if (!(thing.bounds.lower.x <= picture.upper.x && thing.bounds.lower.y <= picture.upper.y &&
          thing.bounds.upper.x >= picture.lower.x && thing.bounds.upper.y >= picture.lower.y))
    {
        return;
    }
    const auto [first, last] = CellsOf(thing.bounds);
    for (int row = first.second; row <= last.second; ++row)
    {
        for (int column = first.first; column <= last.first; ++column)
        {
            m_cells[std::size_t(row * m_columns + column)].push_back(m_things.size());
        }
    }
    m_things.push_back(thing);
    m_things.back().column = first.first;
    m_things.back().row = first.second;
}

void LabelObstacles::AddLine(Point from, Point to, std::uint32_t owner)
{
    const Box bounds{{std::min(from.x, to.x), std::min(from.y, to.y)},
                     {std::max(from.x, to.x), std::max(from.y, to.y)}};
    m_points.push_back(from);
    m_points.push_back(to);
    Add({LabelRole::Sign, LabelForm::Lines, owner, bounds, m_points.size() - 2, 2});
}

bool LabelObstacles::Contains(const LabelThing& thing, Point point) const
{
    const Box& bounds = thing.bounds;
    if (point.x < bounds.lower.x || point.x > bounds.upper.x || point.y < bounds.lower.y ||
        point.y > bounds.upper.y)
    {
        return false;
    }
    if (thing.form == LabelForm::Circle)
    {
        const double dx = point.x - 0.5 * (bounds.lower.x + bounds.upper.x);
        const double dy = point.y - 0.5 * (bounds.lower.y + bounds.upper.y);
        const double radius = 0.5 * (bounds.upper.x - bounds.lower.x);
        return dx * dx + dy * dy <= radius * radius;
    }
    // Ray casting: a point is inside if a ray to the right crosses an odd number of sides.
    bool isInside = thing.form == LabelForm::Box;
    for (std::size_t i = 0; thing.form == LabelForm::Lines && i < thing.count; ++i)
    {
        const Point a = m_points[thing.first + i];
        const Point b = m_points[thing.first + (i + 1) % thing.count];
        const bool straddles = (a.y > point.y) != (b.y > point.y);
        if (straddles && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
        {
            isInside = !isInside;
        }
    }
    return isInside;
}

double LabelObstacles::ThicknessOf(const LabelThing& thing) const
{
    const Point lower = thing.bounds.lower;
    const Point upper = thing.bounds.upper;
    double thickness = std::min(upper.x - lower.x, upper.y - lower.y);
    for (std::size_t i = 0; thing.form == LabelForm::Lines && i < thing.count; ++i)
    {
        // The minimum width of a convex shape is perpendicular to one of its sides.
        const Point a = m_points[thing.first + i];
        const Point b = m_points[thing.first + (i + 1) % thing.count];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        double minimum = 0.0;
        double maximum = 0.0;
        for (std::size_t k = 0; length > 0.0 && k < thing.count; ++k)
        {
            const Point p = m_points[thing.first + k];
            const double away = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
            minimum = std::min(minimum, away);
            maximum = std::max(maximum, away);
        }
        thickness = length > 0.0 ? std::min(thickness, maximum - minimum) : thickness;
    }
    return thickness;
}

bool LabelObstacles::Meets(const LabelThing& thing, const Box& box) const
{
    if (thing.form == LabelForm::Circle)
    {
        const double x = 0.5 * (thing.bounds.lower.x + thing.bounds.upper.x);
        const double y = 0.5 * (thing.bounds.lower.y + thing.bounds.upper.y);
        return Contains(thing, {std::clamp(x, box.lower.x, box.upper.x),
                                std::clamp(y, box.lower.y, box.upper.y)});
    }
    if (thing.form == LabelForm::Box)
    {
        return Overlap(thing.bounds, box);
    }
    for (std::size_t i = 0; i < thing.count; ++i)
    {
        if (labels::Crosses(m_points[thing.first + i],
                            m_points[thing.first + (i + 1) % thing.count], box))
        {
            return true;
        }
    }
    return Contains(thing, MiddleOf(box));
}

} // namespace boxreel
