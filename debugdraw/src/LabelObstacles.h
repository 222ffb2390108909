// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <algorithm>
#include <utility>
#include <vector>

/// A spatial index of the obstacles for labels in a picture. Independent of the placement.
namespace boxreel
{

namespace labels
{

/// [px] from the picture's centre, y up.
struct Point
{
    double x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

struct Box
{
    Point lower, upper;
};

Point MiddleOf(const Box& box);
Box Widened(const Box& box, double by);
inline bool Touch(const Box& a, const Box& b)
{
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y;
}
bool Crosses(Point a, Point b, const Box& box); ///< True if the segment from a to b crosses the
                                                ///< box.

} // namespace labels

enum class LabelRole
{
    Sign,
    Shape,
    Label,  ///< any text
    Center, ///< centre of a body
};

enum class LabelForm
{
    Box,
    Circle, ///< the circle in its bounds
    Lines,  ///< a closed polygon
};

struct LabelThing
{
    LabelRole role = LabelRole::Sign;
    LabelForm form = LabelForm::Box;
    std::uint32_t owner = kNoOwner;
    labels::Box bounds{};
    std::size_t first = 0; ///< Lines: index of the first point
    std::size_t count = 0;
    int column = 0; ///< its first cell, set by LabelObstacles
    int row = 0;
};

class LabelObstacles
{
public:
    LabelObstacles(const Camera& camera, const DrawList& list);

    labels::Point ToPixels(Vec2 place) const;
    Vec2 ToWorld(labels::Point pixels) const;
    bool IsInPicture(labels::Point point) const;

    /// Adds an obstacle; those outside the picture are ignored.
    void Add(const LabelThing& thing);
    void AddLine(labels::Point from, labels::Point to, std::uint32_t owner); ///< part of a glyph

    bool Meets(const LabelThing& thing, const labels::Box& box) const;
    bool Contains(const LabelThing& thing, labels::Point point) const;

    /// Returns the distance of the two closest parallel lines that enclose it [px].
    double ThicknessOf(const LabelThing& thing) const;

    /// Calls `visit` once for each obstacle that may overlap the box, until it returns false.
    template <class Visit>
    void VisitNear(const labels::Box& box, Visit visit) const
    {
        const auto [first, last] = CellsOf(box);
        for (int row = first.second; row <= last.second; ++row)
        {
            for (int column = first.first; column <= last.first; ++column)
            {
                for (const std::size_t index : m_cells[std::size_t(row * m_columns + column)])
                {
                    const LabelThing& thing = m_things[index];
                    if (column == std::max(thing.column, first.first) &&
                        row == std::max(thing.row, first.second) &&
                        labels::Touch(thing.bounds, box) && !visit(thing))
                    {
                        return;
                    }
                }
            }
        }
    }

private:
    using Point = labels::Point;
    using Box = labels::Box;
    using Cells = std::pair<std::pair<int, int>, std::pair<int, int>>; // first and last

    Cells CellsOf(const Box& box) const;
    void AddItem(const DrawList& list, const DrawItem& item, LabelRole role);

    Camera m_camera;
    double m_cell; // [px]
    int m_columns;
    int m_rows;
    std::vector<LabelThing> m_things;
    std::vector<Point> m_points;
    std::vector<std::vector<std::size_t>> m_cells; // obstacles per cell, row by row
};

} // namespace boxreel
