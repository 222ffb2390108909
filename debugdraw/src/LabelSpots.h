// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <map>
#include <utility>
#include <vector>

/// Finds room for labels beside the signs that a list has already: on their place where nothing is
/// in the way, else a little aside, as on maps.
namespace boxreel
{

class LabelSpots
{
public:
    /// In the way are the signs of joints and centres of mass, and labels.
    LabelSpots(const Camera& camera, const DrawList& list);

    /// Where the middle of a label goes that belongs to `place` [m], so many pixels wide and high:
    /// the first spot that is free, or, when none is, the one in the way of the fewest things.
    Vec2 Take(Vec2 place, double width, double height);

private:
    /// From corner to corner [px]; of a segment its ends.
    struct Thing
    {
        double x0, y0, x1, y1;
        bool isLine;
    };
    using Cell = std::pair<int, int>;

    void Add(const Thing& thing);
    void AddItem(const DrawList& list, const DrawItem& item);
    int CountIn(const Thing& box) const;

    Camera m_camera;
    std::vector<Thing> m_things;
    std::map<Cell, std::vector<std::size_t>> m_cells; // what may lie in each
};

} // namespace boxreel
