// SPDX-License-Identifier: MIT
#include <debugdraw/Trail.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace boxreel
{
namespace
{

// A point closer than this [px] to the line between its neighbours has no visible effect.
constexpr double kTolerance = 0.15;

// Length of the pieces of a fading line [px]: shorter than a visible step in brightness, longer
// than their ends.
constexpr double kPiece = 6.0;

// Between two points; if they are further apart than a picture is wide, most of it is outside.
constexpr double kMaxPieces = 400.0;

// Extent of a line with the theme's width beyond its end [px]. Transparent pieces are shortened by
// this, because overlapping ends would be visible as dots.
constexpr double kEnd = 0.49;

// A path that stays within this [px] is skipped: bodies at rest still tremble.
constexpr double kMinExtent = 2.0;

// Number of points simplified together, so that the time is linear in the length of the path.
constexpr std::size_t kTogether = 512;

bool IsFinite(Vec2 p)
{
    return std::isfinite(p.x) && std::isfinite(p.y);
}

double Distance(Vec2 a, Vec2 b)
{
    const double x = double(b.x) - a.x;
    const double y = double(b.y) - a.y;
    return std::sqrt(x * x + y * y);
}

/// Returns the distance of `p` from the segment between `a` and `b`.
double DistanceFromLine(Vec2 p, Vec2 a, Vec2 b)
{
    const double x = double(b.x) - a.x;
    const double y = double(b.y) - a.y;
    const double square = x * x + y * y;
    const double along =
        square > 0.0 ? ((double(p.x) - a.x) * x + (double(p.y) - a.y) * y) / square : 0.0;
    const double share = std::clamp(along, 0.0, 1.0);
    const double dx = a.x + share * x - p.x;
    const double dy = a.y + share * y - p.y;
    return std::sqrt(dx * dx + dy * dy);
}

/// The algorithm of Ramer (1972) and of Douglas and Peucker (1973), with an explicit stack. Returns
/// the points needed so that no other is further than `tolerance` [m] from the line.
std::vector<std::size_t> Needed(std::span<const Vec2> way, double tolerance)
{
    std::vector<bool> keep(way.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, way.size() - 1}};
    while (!open.empty())
    {
        const auto [first, last] = open.back();
        open.pop_back();
        double farthest = tolerance;
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i)
        {
            const double distance = DistanceFromLine(way[i], way[first], way[last]);
            if (distance > farthest)
            {
                farthest = distance;
                at = i;
            }
        }
        if (at != first)
        {
            keep[at] = true;
            open.emplace_back(first, at);
            open.emplace_back(at, last);
        }
    }
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < way.size(); ++i)
    {
        if (keep[i])
        {
            needed.push_back(i);
        }
    }
    return needed;
}

Vec2 Between(Vec2 a, Vec2 b, double share)
{
    return {static_cast<float>(a.x + share * (double(b.x) - a.x)),
            static_cast<float>(a.y + share * (double(b.y) - a.y))};
}

/// A part of a trail, and its age: 0 at the start of the whole path, 1 at its end.
struct Piece
{
    Vec2 from, to;
    double age0, age1;
};

bool IsWay(std::span<const Vec2> way, double pixel)
{
    Rect bounds;
    for (const Vec2 place : way)
    {
        if (IsFinite(place))
        {
            bounds.Include(place);
        }
    }
    return !bounds.IsEmpty() && Distance(bounds.lower, bounds.upper) > kMinExtent * pixel;
}

void AddPiece(DrawList& list, double pixel, const Piece& piece, const TrailSettings& settings)
{
    const double length = Distance(piece.from, piece.to);
    if (settings.oldest >= 1.0)
    {
        list.AddSegment(piece.from, piece.to, settings.color);
        return;
    }
    const int count = static_cast<int>(std::clamp(length / (kPiece * pixel), 1.0, kMaxPieces));
    const double shorter = std::min(kEnd * pixel / std::max(length, pixel), 0.45 / count);
    for (int i = 0; i < count; ++i)
    {
        const double start = double(i) / count;
        const double end = double(i + 1) / count;
        const double age = piece.age0 + 0.5 * (start + end) * (piece.age1 - piece.age0);
        const double opacity = settings.oldest + age * (1.0 - settings.oldest);
        Paint paint = settings.color;
        paint.color.a = static_cast<std::uint8_t>(std::floor(opacity * paint.color.a + 0.5));
        list.AddSegment(Between(piece.from, piece.to, start + shorter),
                        Between(piece.from, piece.to, end - shorter), paint);
    }
}

} // namespace

void AddTrail(DrawList& list, const Camera& camera, std::span<const Vec2> way,
              const TrailSettings& settings)
{
    const double pixel = 1.0 / camera.pixelsPerMeter;
    if (!IsWay(way, pixel))
    {
        return;
    }
    const DrawLayer before = list.layer;
    list.layer = DrawLayer::Trails;
    const double whole = way.size() > 1 ? double(way.size() - 1) : 1.0;
    for (std::size_t start = 0; start + 1 < way.size();)
    {
        std::size_t end = start; // the last point of this part
        while (end + 1 < way.size() && end < start + kTogether && IsFinite(way[end + 1]))
        {
            ++end;
        }
        if (end == start || !IsFinite(way[start]))
        {
            ++start;
            continue;
        }
        const std::span<const Vec2> part = way.subspan(start, end - start + 1);
        const std::vector<std::size_t> needed = Needed(part, kTolerance * pixel);
        for (std::size_t i = 0; i + 1 < needed.size(); ++i)
        {
            const std::size_t a = needed[i];
            const std::size_t b = needed[i + 1];
            if (Distance(part[a], part[b]) > kTolerance * pixel)
            {
                AddPiece(list, pixel,
                         {part[a], part[b], double(start + a) / whole, double(start + b) / whole},
                         settings);
            }
        }
        start = end;
    }
    list.layer = before;
}

Paint TrailColor(std::size_t n)
{
    constexpr std::array<ColorRole, 5> kRoles{ColorRole::Pair, ColorRole::ContactImpulse,
                                              ColorRole::Aabb, ColorRole::NewContact,
                                              ColorRole::ContactNormal};
    return kRoles[n % kRoles.size()];
}

} // namespace boxreel
