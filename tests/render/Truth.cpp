// SPDX-License-Identifier: MIT
#include "Truth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boxreel
{
namespace
{

struct P
{
    double x, y;
};
P operator-(P a, P b)
{
    return {a.x - b.x, a.y - b.y};
}
double Dot(P a, P b)
{
    return a.x * b.x + a.y * b.y;
}
double Norm(P a)
{
    return std::sqrt(Dot(a, a));
}

double ToSegment(P p, P a, P b)
{
    const P ab = b - a;
    const double length2 = Dot(ab, ab);
    const double t = length2 > 0.0 ? std::clamp(Dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
    return Norm(p - P{a.x + t * ab.x, a.y + t * ab.y});
}

enum class Part
{
    Outside,
    Stroke,
    Fill,
};

/// The shapes that contain a point, and the distance it can move before that may change [px].
struct Place
{
    Part part = Part::Outside;
    double margin = 0.0;
};

Place WithinBand(double distance, double half, Part inside)
{
    return {distance > half    ? Part::Outside
            : distance > -half ? Part::Stroke
                               : inside,
            std::min(std::abs(distance - half), std::abs(distance + half))};
}

struct Shape
{
    DrawItem item;
    std::vector<P> points;  // [px]
    std::vector<P> normals; // of a polygon's edges, outward; edge i begins in corner i
    double radius = 0.0;    // [px]
    double half = 0.0;      // half the outline's width [px]
    P low{}, high{};        // nothing is drawn outside [px]
};

/// Outward unit normals, whichever way round the corners go.
std::vector<P> NormalsOf(const std::vector<P>& corners)
{
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const P a = corners[i];
        const P b = corners[(i + 1) % corners.size()];
        area += a.x * b.y - a.y * b.x;
    }
    const double sign = area > 0.0 ? 1.0 : -1.0;
    std::vector<P> normals;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const P e = corners[(i + 1) % corners.size()] - corners[i];
        normals.push_back({sign * e.y / Norm(e), -sign * e.x / Norm(e)});
    }
    return normals;
}

/// Inside the edges moved out by half a width (sharp corners cut at two half widths), and in by as
/// much.
Place OfPolygon(P p, const Shape& s)
{
    double maximum = -1e300;
    for (std::size_t i = 0; i < s.points.size(); ++i)
    {
        maximum = std::max(maximum, Dot(s.normals[i], p - s.points[i]));
    }
    Place place = WithinBand(maximum, s.half, Part::Fill);
    for (std::size_t i = 0; i < s.points.size(); ++i)
    {
        const P before = s.normals[(i + s.points.size() - 1) % s.points.size()];
        const P sum{before.x + s.normals[i].x, before.y + s.normals[i].y};
        if (Norm(sum) < 1.0)
        {
            const double beyond = Dot(sum, p - s.points[i]) / Norm(sum) - 2.0 * s.half;
            place.part = beyond > 0.0 ? Part::Outside : place.part;
            place.margin = std::min(place.margin, std::abs(beyond));
        }
    }
    return place;
}

Place At(P p, const Shape& s)
{
    switch (s.item.kind)
    {
    case DrawKind::SolidPolygon:
        return OfPolygon(p, s);
    case DrawKind::Segment:
        return WithinBand(ToSegment(p, s.points[0], s.points[1]), s.half, Part::Stroke);
    case DrawKind::Point:
        return WithinBand(Norm(p - s.points[0]), s.radius, Part::Stroke);
    case DrawKind::Circle:
        return WithinBand(Norm(p - s.points[0]) - s.radius, s.half, Part::Outside);
    default:
        break;
    }
    Place place = WithinBand(Norm(p - s.points[0]) - s.radius, s.half, Part::Fill);
    const double toAxis = ToSegment(p, s.points[0], s.points[1]) - s.half;
    place.part = toAxis <= 0.0 ? Part::Stroke : place.part;
    place.margin = std::min(place.margin, std::abs(toAxis));
    return place;
}

Shape Prepare(const DrawList& list, const DrawItem& item, const Camera& camera, const Theme& theme)
{
    Shape s;
    s.item = item;
    s.half = 0.5 * theme.outlineWidth;
    s.radius = item.kind == DrawKind::Point ? 0.5 * item.size : item.size * camera.pixelsPerMeter;
    for (std::size_t i = 0; i < item.count; ++i)
    {
        const Vec2 w = list.points[item.first + i];
        s.points.push_back({0.5 * camera.width + (w.x - camera.centerX) * camera.pixelsPerMeter,
                            0.5 * camera.height - (w.y - camera.centerY) * camera.pixelsPerMeter});
    }
    if (item.kind ==
        DrawKind::SolidCircle) // the second point is a direction: make it the axis line's end
    {
        const Vec2 axis = list.points[item.first + 1];
        s.points[1] = {s.points[0].x + s.radius * axis.x, s.points[0].y - s.radius * axis.y};
    }
    if (item.kind == DrawKind::SolidPolygon)
    {
        s.normals = NormalsOf(s.points);
    }
    s.low = s.high = s.points[0];
    const bool round = item.kind != DrawKind::Polygon && item.kind != DrawKind::SolidPolygon &&
                       item.kind != DrawKind::Segment;
    const double reach = 3.0 * s.half + 1.0 + (round ? s.radius : 0.0);
    for (const P p : s.points)
    {
        s.low = {std::min(s.low.x, p.x - reach), std::min(s.low.y, p.y - reach)};
        s.high = {std::max(s.high.x, p.x + reach), std::max(s.high.y, p.y + reach)};
    }
    return s;
}

using Rgba = std::array<double, 4>;

void Over(Rgba& below, Rgba above)
{
    for (std::size_t c = 0; c < 4; ++c)
    {
        below[c] = above[c] + below[c] * (1.0 - above[3] / 255.0);
    }
}

Rgba Premultiplied(Color c, double share, double alpha)
{
    return {c.r * share * alpha, c.g * share * alpha, c.b * share * alpha, 255.0 * alpha};
}

Rgba ColorAt(P p, const std::vector<const Shape*>& shapes, const Theme& theme)
{
    Rgba color = Premultiplied(theme.background, 1.0, theme.background.a / 255.0);
    for (const Shape* s : shapes)
    {
        const Part part = At(p, *s).part;
        const double alpha = s->item.color.a / 255.0;
        if (part != Part::Outside)
        {
            Over(color, part == Part::Stroke ? Premultiplied(s->item.color, 1.0, alpha)
                                             : Premultiplied(s->item.color, theme.fillShade,
                                                             alpha * theme.fillAlpha));
        }
    }
    return color;
}

/// The shapes that may touch each square of kTile pixels, in painter's order. A pixel checks only
/// those of its square. Otherwise ten thousand shapes would take hours.
class Tiles
{
public:
    Tiles(const std::vector<Shape>& shapes, int width, int height)
        : m_columns((width + kTile - 1) / kTile), m_rows((height + kTile - 1) / kTile),
          m_shapes(std::size_t(m_columns) * std::size_t(m_rows))
    {
        for (const Shape& s : shapes)
        {
            const int right = Clamped(s.high.x, m_columns), bottom = Clamped(s.high.y, m_rows);
            for (int row = Clamped(s.low.y, m_rows); row <= bottom; ++row)
            {
                for (int column = Clamped(s.low.x, m_columns); column <= right; ++column)
                {
                    m_shapes[Index(column, row)].push_back(&s);
                }
            }
        }
    }
    const std::vector<const Shape*>& Around(int x, int y) const
    {
        return m_shapes[Index(x / kTile, y / kTile)];
    }

private:
    static constexpr int kTile = 16; // px

    static int Clamped(double place, int count)
    {
        return int(std::clamp(std::floor(place / kTile), 0.0, double(count - 1)));
    }
    std::size_t Index(int column, int row) const
    {
        return std::size_t(row) * std::size_t(m_columns) + std::size_t(column);
    }

    int m_columns, m_rows;
    std::vector<std::vector<const Shape*>> m_shapes;
};

} // namespace

TruthPicture Supersample(const DrawList& list, const Camera& camera, const Theme& theme, int grid)
{
    TruthPicture truth{camera.width, camera.height, {}, {}};
    const std::size_t size = std::size_t(camera.width) * std::size_t(camera.height);
    truth.rgba.resize(size * 4);
    truth.edge.resize(size);
    std::vector<Shape> shapes;
    for (const DrawItem& item : list.items)
    {
        shapes.push_back(Prepare(list, item, camera, theme));
    }
    const Tiles tiles(shapes, camera.width, camera.height);
    std::vector<const Shape*> near;
    for (std::size_t i = 0; i < size; ++i)
    {
        const int x = int(i) % camera.width, y = int(i) / camera.width;
        const P corner{double(x), double(y)};
        const P middle{corner.x + 0.5, corner.y + 0.5};
        near.clear();
        double margin = 1.0;
        for (const Shape* s : tiles.Around(x, y))
        {
            if (middle.x > s->low.x && middle.x < s->high.x && middle.y > s->low.y &&
                middle.y < s->high.y)
            {
                near.push_back(s);
                margin = std::min(margin, At(middle, *s).margin);
            }
        }
        const int steps = margin > 0.7072 ? 1 : grid; // one point says it all
        Rgba sum{};
        Rgba first{};
        for (int k = 0; k < steps * steps; ++k)
        {
            const P p{corner.x + (k % steps + 0.5) / steps, corner.y + (k / steps + 0.5) / steps};
            const Rgba color = ColorAt(p, near, theme);
            first = k == 0 ? color : first;
            truth.edge[i] = truth.edge[i] || color != first;
            for (std::size_t c = 0; c < 4; ++c)
            {
                sum[c] += color[c];
            }
        }
        for (std::size_t c = 0; c < 4; ++c)
        {
            truth.rgba[i * 4 + c] = sum[c] / (steps * steps);
        }
    }
    return truth;
}

EdgeError Compare(const Frame& frame, const TruthPicture& truth)
{
    EdgeError error;
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.edge.size(); ++i)
    {
        error.edgePixels += truth.edge[i];
        for (std::size_t c = 0; c < 3; ++c)
        {
            const double difference = std::abs(frame.rgba[i * 4 + c] - truth.rgba[i * 4 + c]);
            error.maximum = std::max(error.maximum, difference);
            squares += truth.edge[i] ? difference * difference : 0.0;
        }
    }
    error.rms = error.edgePixels ? std::sqrt(squares / double(3 * error.edgePixels)) : 0.0;
    return error;
}

} // namespace boxreel
