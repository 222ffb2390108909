// SPDX-License-Identifier: MIT
#include "LabelSpots.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{

namespace
{

using labels::Box;
using labels::Crosses;
using labels::MiddleOf;
using labels::Point;
using labels::Widened;

constexpr double kLetterHeight = 12.0; // height of the glyphs in a line [px]
constexpr double kEdge = 2.0;          // minimum distance of a label from the picture's edge [px]

constexpr double kCenter = 0.5;            // half the size of a body's centre [px]
constexpr double kRounding = 0.5;          // overlap that does not count [px]
constexpr double kApart = 3.0 + kRounding; // minimum distance of labels in a row, so that they do
                                           // not read as one
constexpr double kClear = 3.0; // from a label to glyphs, and to its own body when beside it

// Maximum overlap of a label with another body's shape, if its centre stays free [px]. With less,
// labels of small bodies leave them, and jump in films, because of mere neighbours.
constexpr double kSpill = 5.0;

constexpr double kCorner = 2.0; // corner of a label, which is usually empty [px]

// A shape with a smaller ratio of length to thickness is covered by its label instead of crossing
// it as a line. An example is a small box on its corner.
constexpr double kSlender = 3.0;

// Distances from the position to the nearest edge of the label [px]: for a hinge or a centre of
// mass, a hinge with a motor, a gear, crowds, and beyond the ends of a slender body.
constexpr double kBeyondEnds = 66.0;
constexpr double kDistances[] = {10.5, 17.0, 25.0, 36.0, 50.0, kBeyondEnds};

// A line that passes another body's centre within this distance appears to belong to it [px].
constexpr double kNear = 3.0;

// Beyond this distance, the label of a joint needs a line [px].
constexpr double kFar = 26.0;

using Direction = double[2];

// Directions for a body's label: above and below first, where the line is shortest, then as on
// maps.
constexpr Direction kAroundBody[] = {{0, 1},  {0, -1},  {1, 1}, {1, -1},
                                     {-1, 1}, {-1, -1}, {1, 0}, {-1, 0}};

// Directions for other labels, as on maps: upper right first, straight beside last. Lines are
// likely there, so it is used only if no corner at the next distance is free.
constexpr Direction kAroundSign[] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1},
                                     {1, 0}, {-1, 0}, {0, 1},  {0, -1}};

/// Returns the part of a label at its position that must not overlap other bodies.
Box CoreOf(const Box& box)
{
    const double across = std::min(kSpill, 0.5 * (box.upper.x - box.lower.x));
    return {{box.lower.x + across, box.lower.y + kSpill},
            {box.upper.x - across, box.upper.y - kSpill}};
}

} // namespace

LabelSpots::LabelSpots(const Camera& camera, const DrawList& list)
    : m_camera(camera), m_obstacles(camera, list)
{}

bool LabelSpots::IsInPicture(const Box& box) const
{
    return m_obstacles.IsInPicture(Point{box.lower.x - kEdge, box.lower.y - kEdge}) &&
           m_obstacles.IsInPicture(Point{box.upper.x + kEdge, box.upper.y + kEdge});
}

/// Returns the number of obstacles at this position; none if it is forbidden.
std::optional<int> LabelSpots::CountIn(const Box& box, const LabelWish& wish) const
{
    if (!IsInPicture(box))
    {
        return std::nullopt;
    }
    const Point place = m_obstacles.ToPixels(wish.place);
    const Box core = Crosses(place, place, box) ? CoreOf(box) : box;
    const Box apart{{box.lower.x - kApart, box.lower.y - kRounding},
                    {box.upper.x + kApart, box.upper.y + kRounding}};
    int signs = 0;
    int shapes = 0;
    bool isRefused = false;
    const Box clear = Widened(box, kClear);
    m_obstacles.VisitNear(clear, [&](const LabelThing& thing) {
        const bool isOwn = thing.owner == wish.owner && wish.owner != kNoOwner;
        switch (thing.role)
        {
        case LabelRole::Label:
            isRefused = m_obstacles.Meets(thing, apart);
            break;
        case LabelRole::Center:
            isRefused = !isOwn && m_obstacles.Meets(thing, box);
            break;
        case LabelRole::Sign:
            signs += m_obstacles.Meets(thing, clear) ? 1 : 0;
            break;
        case LabelRole::Shape:
            // Shapes below the label's own body (a region, a vehicle around its wheel) do not
            // identify it.
            signs += isOwn && Strikes(thing, clear) ? 1 : 0;
            shapes +=
                !isOwn && m_obstacles.Meets(thing, core) && !m_obstacles.Contains(thing, place) ? 1
                                                                                                : 0;
            break;
        }
        return !isRefused;
    });
    if (isRefused)
    {
        return std::nullopt;
    }
    // On its own body it stays, independent of other shapes there.
    return signs + (shapes > 0 && FitsIn(box, wish.owner) ? 0 : shapes);
}

/// True if a shape of the label's body crosses the text like a line.
bool LabelSpots::Strikes(const LabelThing& thing, const Box& box) const
{
    const Box& bounds = thing.bounds;
    const bool isLonger = bounds.lower.x < box.lower.x || bounds.lower.y < box.lower.y ||
                          bounds.upper.x > box.upper.x || bounds.upper.y > box.upper.y;
    if (!isLonger || !m_obstacles.Meets(thing, box))
    {
        return false;
    }
    const double thickness = m_obstacles.ThicknessOf(thing);
    const double length =
        std::hypot(bounds.upper.x - bounds.lower.x, bounds.upper.y - bounds.lower.y);
    return thickness < kLetterHeight && length > kSlender * thickness;
}

bool LabelSpots::IsStruck(const Box& box, std::uint32_t owner) const
{
    bool isStruck = false;
    m_obstacles.VisitNear(box, [&](const LabelThing& thing) {
        isStruck = thing.role == LabelRole::Shape && thing.owner == owner && Strikes(thing, box);
        return !isStruck;
    });
    return isStruck;
}

/// True if a line would appear to start at another body, or to lead to another label.
bool LabelSpots::Misleads(Point from, Point to) const
{
    const Box bounds{{std::min(from.x, to.x), std::min(from.y, to.y)},
                     {std::max(from.x, to.x), std::max(from.y, to.y)}};
    bool misleads = false;
    m_obstacles.VisitNear(Widened(bounds, kNear), [&](const LabelThing& thing) {
        const Box around = Widened(thing.bounds, kNear);
        misleads = (thing.role == LabelRole::Label && Crosses(from, to, thing.bounds)) ||
                   (thing.role == LabelRole::Center && !Crosses(from, from, around) &&
                    Crosses(from, to, around));
        return !misleads;
    });
    return misleads;
}

bool LabelSpots::IsOnOwner(Point point, std::uint32_t owner) const
{
    bool isOn = false;
    m_obstacles.VisitNear({point, point}, [&](const LabelThing& thing) {
        isOn = thing.role == LabelRole::Shape && thing.owner == owner &&
               m_obstacles.Contains(thing, point);
        return !isOn;
    });
    return isOn;
}

/// Returns the end of a line from the position to the label; none if the label is clear without it.
std::optional<Point> LabelSpots::TieTo(const Box& box, const LabelWish& wish) const
{
    const Point place = m_obstacles.ToPixels(wish.place);
    const Point end{std::clamp(place.x, box.lower.x, box.upper.x),
                    std::clamp(place.y, box.lower.y, box.upper.y)};
    const double dx = end.x - place.x;
    const double dy = end.y - place.y;
    const bool isPlain = wish.owner != kNoOwner
                             ? end == place || IsOnOwner(MiddleOf(box), wish.owner)
                             : dx * dx + dy * dy < kFar * kFar;
    return isPlain ? std::nullopt : std::optional<Point>(end);
}

Box LabelSpots::BoxAround(Point middle, double width) const
{
    return {{middle.x - 0.5 * width, middle.y - 0.5 * kLetterHeight},
            {middle.x + 0.5 * width, middle.y + 0.5 * kLetterHeight}};
}

/// At the picture's edge it is moved inside.
Box LabelSpots::BoxOnPlace(const LabelWish& wish) const
{
    const auto inside = [](double place, double size, double room) {
        const double maximum = std::max(0.0, 0.5 * (room - size) - kEdge);
        return std::clamp(place, -maximum, maximum);
    };
    const Point place = m_obstacles.ToPixels(wish.place);
    return BoxAround({inside(place.x, wish.width, m_camera.width),
                      inside(place.y, kLetterHeight, m_camera.height)},
                     wish.width);
}

std::optional<Box> LabelSpots::BestBox(const LabelWish& wish) const
{
    const Point place = m_obstacles.ToPixels(wish.place);
    const bool mayFit = MayFitIn(wish);
    std::optional<Box> best;
    std::optional<int> fewest;
    bool fits = false; // the best is inside its body
    const auto consider = [&](const Box& box) {
        const std::optional<int> count = CountIn(box, wish);
        if (!count || (fewest && (*count > *fewest || (*count == *fewest && (fits || !mayFit)))))
        {
            return;
        }
        const bool fitsToo = mayFit && FitsIn(box, wish.owner);
        if (fewest == count && !fitsToo)
        {
            return;
        }
        const std::optional<Point> tie = TieTo(box, wish);
        if (!tie || !Misleads(place, *tie))
        {
            fewest = count;
            best = box;
            fits = fitsToo;
        }
    };
    consider(BoxOnPlace(wish));
    const bool isStruck = wish.owner != kNoOwner && IsStruck(BoxOnPlace(wish), wish.owner);
    double nearer = 0.0; // distance
    for (const double distance : kDistances)
    {
        if (distance == kBeyondEnds && !isStruck)
        {
            break;
        }
        for (const auto& [right, up] : wish.owner != kNoOwner ? kAroundBody : kAroundSign)
        {
            if (fewest == 0 && (fits || !mayFit))
            {
                return best;
            }
            // A corner is closer to the position than a side, so it may be closer.
            const bool isCorner = right != 0.0 && up != 0.0;
            const double straight = wish.owner != kNoOwner ? distance : nearer;
            if (!isCorner && straight == 0.0)
            {
                continue;
            }
            const double away = isCorner ? 0.7 * distance : straight;
            consider(BoxAround({place.x + right * (away + 0.5 * wish.width),
                                place.y + up * (away + 0.5 * kLetterHeight)},
                               wish.width));
        }
        nearer = distance;
    }
    return best;
}

LabelSpot LabelSpots::Take(const Box& box, const LabelWish& wish)
{
    m_obstacles.Add({LabelRole::Label, LabelForm::Box, wish.owner, box, 0, 0});
    const std::optional<Point> tie = TieTo(box, wish);
    if (!tie)
    {
        return {m_obstacles.ToWorld(MiddleOf(box)), std::nullopt};
    }
    m_obstacles.AddLine(m_obstacles.ToPixels(wish.place), *tie, wish.owner);
    return {m_obstacles.ToWorld(MiddleOf(box)), m_obstacles.ToWorld(*tie)};
}

/// True if a label there is on its body, except for its corners.
bool LabelSpots::FitsIn(const Box& box, std::uint32_t owner) const
{
    const Box core = Widened(box, -kCorner);
    return owner != kNoOwner && IsOnOwner(core.lower, owner) && IsOnOwner(core.upper, owner) &&
           IsOnOwner({core.lower.x, core.upper.y}, owner) &&
           IsOnOwner({core.upper.x, core.lower.y}, owner);
}

/// True if a shape of the body at its position may be large enough for it.
bool LabelSpots::MayFitIn(const LabelWish& wish) const
{
    const Point place = m_obstacles.ToPixels(wish.place);
    bool mayFit = false;
    m_obstacles.VisitNear({place, place}, [&](const LabelThing& thing) {
        const Box& bounds = thing.bounds;
        mayFit = wish.owner != kNoOwner && thing.role == LabelRole::Shape &&
                 thing.owner == wish.owner &&
                 bounds.upper.x - bounds.lower.x >= wish.width - 2.0 * kCorner &&
                 bounds.upper.y - bounds.lower.y >= kLetterHeight - 2.0 * kCorner;
        return !mayFit;
    });
    return mayFit;
}

void LabelSpots::AddCenter(const LabelWish& wish)
{
    const Point center = m_obstacles.ToPixels(wish.place);
    m_obstacles.Add({LabelRole::Center, LabelForm::Box, wish.owner,
                     Widened(Box{center, center}, kCenter), 0, 0});
}

std::vector<std::optional<LabelSpot>> LabelSpots::Settle(const std::vector<LabelWish>& wishes)
{
    std::vector<std::optional<LabelSpot>> spots(wishes.size());
    for (const LabelWish& wish : wishes)
    {
        if (wish.owner != kNoOwner)
        {
            AddCenter(wish);
        }
    }
    const auto settle = [&](const auto& boxFor) {
        for (std::size_t i = 0; i < wishes.size(); ++i)
        {
            if (spots[i] || !m_obstacles.IsInPicture(m_obstacles.ToPixels(wishes[i].place)))
            {
                continue;
            }
            if (const std::optional<Box> box = boxFor(wishes[i]))
            {
                spots[i] = Take(*box, wishes[i]);
            }
        }
    };
    const auto onPlace = [&](const LabelWish& wish) {
        const Box box = BoxOnPlace(wish);
        return CountIn(box, wish) == 0 ? std::optional<Box>(box) : std::nullopt;
    };
    settle([&](const LabelWish& wish) {
        return FitsIn(BoxOnPlace(wish), wish.owner) ? onPlace(wish) : std::nullopt;
    });
    settle(onPlace);
    settle([&](const LabelWish& wish) { return BestBox(wish); });
    return spots;
}

} // namespace boxreel
