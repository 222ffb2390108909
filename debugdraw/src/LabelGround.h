// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <algorithm>
#include <utility>
#include <vector>

/// What is in the way of labels in a picture, found by place. Knows no labels' wishes.
namespace boxreel
{

namespace labels
{

/// [px] from the picture's middle, y up.
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
bool Crosses(Point a, Point b, const Box& box); ///< the segment from a to b

} // namespace labels

enum class LabelRole
{
    Sign,
    Shape,
    Label,  ///< any text
    Center, ///< of a body
};

enum class LabelForm
{
    Box,
    Circle, ///< within its bounds
    Lines,  ///< from point to point, and back to the first
};

struct LabelThing
{
    LabelRole role = LabelRole::Sign;
    LabelForm form = LabelForm::Box;
    std::uint32_t owner = kNoOwner;
    labels::Box bounds{};
    std::size_t first = 0; ///< Lines: the number of the first point
    std::size_t count = 0;
    int column = 0; ///< of its first cell, which LabelGround finds
    int row = 0;
};

class LabelGround
{
public:
    LabelGround(const Camera& camera, const DrawList& list);

    labels::Point ToPixels(Vec2 place) const;
    Vec2 ToWorld(labels::Point pixels) const;
    bool IsInPicture(labels::Point point) const;

    /// What does not lie in the picture is ignored.
    void Add(const LabelThing& thing);
    void AddLine(labels::Point from, labels::Point to, std::uint32_t owner); ///< a sign

    bool Meets(const LabelThing& thing, const labels::Box& box) const;
    bool Contains(const LabelThing& thing, labels::Point point) const;

    /// How far apart the two parallels are at least between which it lies [px].
    double ThicknessOf(const LabelThing& thing) const;

    /// Calls it for each thing that may meet the box, once, until it says false.
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
    std::vector<std::vector<std::size_t>> m_cells; // what may lie in each, row by row
};

} // namespace boxreel
