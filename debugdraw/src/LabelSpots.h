// SPDX-License-Identifier: MIT
#pragma once

#include "LabelObstacles.h"

#include <optional>
#include <vector>

/// Places labels in a list: at their position if it is free, otherwise beside it, as on maps.
/// Independent of worlds.
namespace boxreel
{

/// A label and its preferred position.
struct LabelWish
{
    Vec2 place;                     ///< [m]
    double width = 0.0;             ///< [px]
    std::uint32_t owner = kNoOwner; ///< the body whose centre the position is, if any
};

struct LabelSpot
{
    Vec2 middle; ///< [m]
    /// End of a thin line from the position to the label [m]; none if the label is clear without
    /// it.
    std::optional<Vec2> tie;
};

class LabelSpots
{
public:
    /// Obstacles are glyphs, annotations, labels, and the shapes of bodies. Shapes of the label's
    /// own body count only if they cross the text: longer than the label and thinner than its
    /// letters.
    LabelSpots(const Camera& camera, const DrawList& list);

    /// Returns a spot for each label, completely inside the picture. Labels on their own body are
    /// placed first, then those that are free at their position, then the others in order. Each of
    /// these gets the nearest spot with the fewest obstacles. None if the position is outside the
    /// picture, or if every spot covers another label or another body's centre, because such a
    /// label would mislead.
    std::vector<std::optional<LabelSpot>> Settle(const std::vector<LabelWish>& wishes);

private:
    using Point = labels::Point;
    using Box = labels::Box;
    bool IsInPicture(const Box& box) const;
    std::optional<int> CountIn(const Box& box, const LabelWish& wish) const;
    bool Misleads(Point from, Point to) const;
    std::optional<Point> TieTo(const Box& box, const LabelWish& wish) const;
    bool Strikes(const LabelThing& thing, const Box& box) const;
    bool IsStruck(const Box& box, std::uint32_t owner) const;
    bool IsOnOwner(Point point, std::uint32_t owner) const;
    Box BoxAround(Point middle, double width) const;
    Box BoxOnPlace(const LabelWish& wish) const;
    std::optional<Box> BestBox(const LabelWish& wish) const;
    bool FitsIn(const Box& box, std::uint32_t owner) const;
    bool MayFitIn(const LabelWish& wish) const;
    void AddCenter(const LabelWish& wish);
    LabelSpot Take(const Box& box, const LabelWish& wish);

    Camera m_camera;
    LabelObstacles m_obstacles;
};

} // namespace boxreel
