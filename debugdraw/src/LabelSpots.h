// SPDX-License-Identifier: MIT
#pragma once

#include "LabelGround.h"

#include <optional>
#include <vector>

/// Finds room for labels in what a list has already: on their place where nothing is in the way,
/// else beside it, as on maps. Knows no world.
namespace boxreel
{

/// A label that wants to be at a place.
struct LabelWish
{
    Vec2 place;                     ///< [m]
    double width = 0.0;             ///< [px]
    std::uint32_t owner = kNoOwner; ///< the body whose centre the place is, if it is one's
};

struct LabelSpot
{
    Vec2 middle; ///< [m]
    /// Where a thin line from the place ends that says whose label it is [m]; none where that is
    /// plain.
    std::optional<Vec2> tie;
};

class LabelSpots
{
public:
    /// In the way are the signs of joints and centres of mass, annotations, labels, and the shapes
    /// of bodies: for their own labels only those that are longer than the label and thinner than
    /// its letters, which would be struck through.
    LabelSpots(const Camera& camera, const DrawList& list);

    /// A spot for each, wholly in the picture: first those that lie on their own body, then those
    /// that have room on their place, then, in their order, the others: the nearest spot that is
    /// free, or in the way of the fewest things. None where the place is not in the picture, or
    /// where all spots lie on another label or another body's centre: what would be taken for
    /// another's label is worse than none.
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
    LabelGround m_ground;
};

} // namespace boxreel
