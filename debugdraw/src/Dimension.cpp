// SPDX-License-Identifier: MIT
#include "LabelObstacles.h"

#include <debugdraw/Dimension.h>

#include <debugdraw/Arrow.h>
#include <debugdraw/NiceNumbers.h>
#include <debugdraw/Paper.h>
#include <debugdraw/TextWidth.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// All lengths in pixels.
constexpr double kFromPoint = 5.0; // from a measured point to its extension line
constexpr double kBeyond = 5.0;    // extension line beyond the arrows
constexpr double kShortest = 24.0; // two heads and a gap
constexpr double kOutside = 18.0;  // the shaft of an arrow from outside
constexpr double kFromLine = 5.0;  // from the line to the text
constexpr double kFromEdge = 4.0;  // from the text to the picture's edge
constexpr double kStep = 12.0;     // step along the line to try positions
constexpr int kOnText = 100;       // cost of covering a text, in lines

PixelPoint operator+(PixelPoint a, PixelPoint b)
{
    return {a.x + b.x, a.y + b.y};
}

PixelPoint operator*(double factor, PixelPoint p)
{
    return {factor * p.x, factor * p.y};
}

/// The measured line, in pixels.
struct Measured
{
    PixelPoint a, b;
    PixelPoint along; // unit vector from a to b
    double length;
};

/// Returns the text's centre for a line through `middle`, on the side of `normal`, as close to it
/// as its box allows.
PixelPoint TextCenter(PixelPoint middle, PixelPoint normal, double width)
{
    const double reach =
        0.5 * width * std::abs(normal.x) + 0.5 * kTextHeight * std::abs(normal.y) + kFromLine;
    return middle + reach * normal;
}

/// True if a box of this size around `center` is inside the picture.
bool HasRoom(const Camera& view, PixelPoint center, double width, double height)
{
    return center.x - 0.5 * width >= kFromEdge && center.y - 0.5 * height >= kFromEdge &&
           center.x + 0.5 * width <= view.width - kFromEdge &&
           center.y + 0.5 * height <= view.height - kFromEdge;
}

/// Above horizontal lines, left of vertical ones.
PixelPoint PreferredSide(const Measured& measured)
{
    const PixelPoint normal{measured.along.y, -measured.along.x};
    const bool stands = std::abs(normal.x) > std::abs(normal.y);
    const bool turn = stands ? normal.x > 0.0 : normal.y > 0.0;
    return turn ? -1.0 * normal : normal;
}

/// Returns the number of lines and outlines that the text would cover.
int CountUnder(const LabelObstacles& obstacles, const Camera& view, PixelPoint center, double width)
{
    const labels::Point middle{center.x - 0.5 * view.width, 0.5 * view.height - center.y};
    const labels::Box box{{middle.x - 0.5 * width, middle.y - 0.5 * kTextHeight},
                          {middle.x + 0.5 * width, middle.y + 0.5 * kTextHeight}};
    int count = 0;
    obstacles.VisitNear(box, [&](const LabelThing& thing) {
        const bool isWithin = thing.role == LabelRole::Shape &&
                              obstacles.Contains(thing, box.lower) &&
                              obstacles.Contains(thing, box.upper) &&
                              obstacles.Contains(thing, {box.lower.x, box.upper.y}) &&
                              obstacles.Contains(thing, {box.upper.x, box.lower.y});
        const int weight = thing.role == LabelRole::Label ? kOnText : 1;
        count += !isWithin && obstacles.Meets(thing, box) ? weight : 0;
        return true;
    });
    return count;
}

/// Returns the position where the text covers least. Tried first is the middle of a line through
/// `middle` on its own side, then other places along it. The last ones are between the line and the
/// measured points, at distance `offset`.
PixelPoint ClearPlace(const LabelObstacles& obstacles, const Camera& view, const Measured& measured,
                      PixelPoint middle, PixelPoint side, double offset, double width)
{
    const double along =
        width * std::abs(measured.along.x) + kTextHeight * std::abs(measured.along.y);
    const double across = width * std::abs(side.x) + kTextHeight * std::abs(side.y);
    const double room = 0.5 * (measured.length - along) - kFromLine;
    const int steps = room > 0.0 ? static_cast<int>(room / kStep) : 0;
    PixelPoint best = TextCenter(middle, side, width);
    int fewest = CountUnder(obstacles, view, best, width);
    const auto consider = [&](PixelPoint center) {
        const int count = fewest > 0 && HasRoom(view, center, width, kTextHeight)
                              ? CountUnder(obstacles, view, center, width)
                              : fewest;
        best = count < fewest ? center : best;
        fewest = std::min(count, fewest);
    };
    for (const double outside : {1.0, -1.0})
    {
        const bool fits = outside > 0.0 || across + 2.0 * kFromLine <= offset;
        for (int i = 0; fits && i <= steps; ++i)
        {
            consider(TextCenter(middle + i * kStep * measured.along, outside * side, width));
            consider(TextCenter(middle + -i * kStep * measured.along, outside * side, width));
        }
    }
    return best;
}

double Kept(double place, double half, double size)
{
    const double border = half + kFromEdge;
    return size > 2.0 * border ? std::clamp(place, border, size - border) : place;
}

void AddArrows(const Paper& paper, const Measured& measured, PixelPoint from, PixelPoint to,
               const Paint& paint)
{
    if (measured.length >= kShortest)
    {
        // One shaft for both; it ends just inside the second head.
        const PixelPoint neck = to + -0.99 * ArrowHead().length * measured.along;
        paper.Arrow(neck, from, paint);
        paper.Arrow(neck, to, paint);
        return;
    }
    paper.Arrow(from + -kOutside * measured.along, from, paint);
    paper.Arrow(to + kOutside * measured.along, to, paint);
}

} // namespace

void AddDimension(DrawList& list, const Camera& view, Vec2 a, Vec2 b,
                  const DimensionSettings& settings)
{
    const LabelObstacles obstacles(view, list); // without this dimension's own lines
    const Paper paper(list, view);
    const double dx = double(b.x) - a.x;
    const double dy = double(b.y) - a.y;
    const double distance = std::sqrt(dx * dx + dy * dy);
    if (!(distance > 0.0) || !std::isfinite(distance))
    {
        return;
    }
    const Measured measured{paper.ToPixel(a), paper.ToPixel(b),
                            PixelPoint{dx / distance, -dy / distance},
                            distance * view.pixelsPerMeter};
    const std::string text =
        settings.label.empty() ? NumberMeasured(distance) + " m" : settings.label;
    const double width = TextWidth(text);
    const double offset = std::abs(settings.offset);
    const PixelPoint preferred = (settings.offset < 0.0 ? -1.0 : 1.0) * PreferredSide(measured);
    const PixelPoint middle = 0.5 * (measured.a + measured.b);
    const auto place = [&](PixelPoint side) {
        return TextCenter(middle + offset * side, side, width);
    };
    const auto fits = [&](PixelPoint side) {
        return HasRoom(view, place(side), width, kTextHeight) &&
               HasRoom(view, measured.a + offset * side, 0.0, 0.0) &&
               HasRoom(view, measured.b + offset * side, 0.0, 0.0);
    };
    const bool turn = !fits(preferred) && fits(-1.0 * preferred);
    const PixelPoint side = turn ? -1.0 * preferred : preferred;
    const PixelPoint from = measured.a + offset * side;
    const PixelPoint to = measured.b + offset * side;
    const double start = std::min(kFromPoint, 0.5 * offset);
    paper.Line(measured.a + start * side, from + kBeyond * side, settings.color);
    paper.Line(measured.b + start * side, to + kBeyond * side, settings.color);
    AddArrows(paper, measured, from, to, settings.color);
    const PixelPoint center =
        ClearPlace(obstacles, view, measured, middle + offset * side, side, offset, width);
    const bool isSeen =
        middle.x >= 0.0 && middle.y >= 0.0 && middle.x <= view.width && middle.y <= view.height;
    paper.Text(isSeen ? PixelPoint{Kept(center.x, 0.5 * width, view.width),
                                   Kept(center.y, 0.5 * kTextHeight, view.height)}
                      : center,
               text, {0.5, 0.5}, settings.color);
}

} // namespace boxreel
