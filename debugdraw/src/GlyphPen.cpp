// SPDX-License-Identifier: MIT
#include <debugdraw/GlyphPen.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{

namespace
{

constexpr double kHead = 7.0;          // length of an arc's arrow head [px]
constexpr double kHeadHalfWidth = 3.5; // [px]
constexpr int kTurns = 8;              // number of half turns of a spring
constexpr double kLead = 0.15;         // straight part at each end of a spring, as a fraction of
                                       // its length
constexpr std::size_t kMaxDashes = 400;

GlyphPen::Point operator+(GlyphPen::Point a, GlyphPen::Point b)
{
    return {a.x + b.x, a.y + b.y};
}

GlyphPen::Point operator-(GlyphPen::Point a, GlyphPen::Point b)
{
    return {a.x - b.x, a.y - b.y};
}

GlyphPen::Point operator*(double s, GlyphPen::Point a)
{
    return {s * a.x, s * a.y};
}

GlyphPen::Point LeftOf(GlyphPen::Point direction)
{
    return {-direction.y, direction.x};
}

double LengthOf(GlyphPen::Point p)
{
    return std::sqrt(p.x * p.x + p.y * p.y);
}

} // namespace

GlyphPen::GlyphPen(DrawList& list, const Camera& camera, Vec2 origin, Vec2 xAxis,
                   const Paint& paint)
    : m_list(list), m_metersPerPixel(1.0 / camera.pixelsPerMeter), m_origin(origin), m_paint(paint)
{
    const Point axis{xAxis.x, xAxis.y};
    const double length = LengthOf(axis);
    m_axis = length > 0.0 ? (1.0 / length) * axis : Point{1.0, 0.0};
}

GlyphPen::Point GlyphPen::Direction(int step)
{
    // sin of 0, 15, … 90 degrees
    static constexpr double kSine[] = {
        0.0, 0.25881904510252074, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890683,
        1.0};
    const int turn = ((step % kFullTurn) + kFullTurn) % kFullTurn;
    const auto sine = [](int at) {
        at %= kFullTurn;
        const int half = at % 12;
        const double size = kSine[half <= 6 ? half : 12 - half];
        return at < 12 ? size : -size;
    };
    return {sine(turn + 6), sine(turn)};
}

Vec2 GlyphPen::At(Point p) const
{
    const Point way = m_metersPerPixel * (p.x * m_axis + p.y * LeftOf(m_axis));
    return {float(m_origin.x + way.x), float(m_origin.y + way.y)};
}

GlyphPen::Point GlyphPen::Of(Vec2 world) const
{
    const Point way{(double(world.x) - m_origin.x) / m_metersPerPixel,
                    (double(world.y) - m_origin.y) / m_metersPerPixel};
    return {way.x * m_axis.x + way.y * m_axis.y, way.y * m_axis.x - way.x * m_axis.y};
}

void GlyphPen::Line(Point from, Point to)
{
    m_list.AddSegment(At(from), At(to), m_paint);
}

void GlyphPen::Lines(std::initializer_list<Point> points)
{
    for (const Point* next = points.begin(); next + 1 < points.end(); ++next)
    {
        Line(next[0], next[1]);
    }
}

void GlyphPen::Dashes(Point from, Point to)
{
    const double length = LengthOf(to - from);
    // An odd number, so that both ends are drawn; very long lines have longer dashes.
    const double wanted = std::min(0.5 * length / kDash, double(kMaxDashes));
    const auto pairs = std::isfinite(wanted) ? static_cast<std::size_t>(wanted) : 0;
    const std::size_t count = 2 * pairs + 1;
    for (std::size_t i = 0; i < count; i += 2)
    {
        Line(from + (double(i) / double(count)) * (to - from),
             from + (double(i + 1) / double(count)) * (to - from));
    }
}

void GlyphPen::Circle(Point center, double radius)
{
    m_list.AddCircle(At(center), float(radius * m_metersPerPixel), m_paint);
}

void GlyphPen::Dot(Point center, double diameter)
{
    m_list.AddPoint(At(center), float(diameter), m_paint);
}

void GlyphPen::Box(Point center, double halfWidth, double halfHeight)
{
    const Vec2 corners[4] = {
        At(center + Point{-halfWidth, -halfHeight}), At(center + Point{halfWidth, -halfHeight}),
        At(center + Point{halfWidth, halfHeight}), At(center + Point{-halfWidth, halfHeight})};
    m_list.AddSolidPolygon(corners, 4, m_paint);
}

void GlyphPen::Triangle(Point a, Point b, Point c)
{
    const Vec2 corners[3] = {At(a), At(b), At(c)};
    m_list.AddSolidPolygon(corners, 3, m_paint);
}

void GlyphPen::Quarter(double radius, int quarter)
{
    Vec2 corners[8];
    corners[0] = At({0.0, 0.0});
    for (int i = 0; i <= 6; ++i)
    {
        corners[i + 1] = At(radius * Direction(6 * quarter + i));
    }
    m_list.AddSolidPolygon(corners, 8, m_paint);
}

void GlyphPen::ArcArrow(double radius, int from, int to, bool clockwise)
{
    for (int step = from; step < to; ++step)
    {
        Line(radius * Direction(step), radius * Direction(step + 1));
    }
    const Point out = Direction(clockwise ? from : to);
    const Point along = (clockwise ? -1.0 : 1.0) * LeftOf(out);
    const Point base = radius * out;
    const Point left = base + kHeadHalfWidth * LeftOf(along);
    const Point right = base - kHeadHalfWidth * LeftOf(along);
    Triangle(base + kHead * along, left, right);
}

void GlyphPen::Zigzag(Point from, Point to, double halfWidth)
{
    const Point way = to - from;
    const double length = LengthOf(way);
    if (!(length > 0.0))
    {
        return;
    }
    const Point across = (halfWidth / length) * LeftOf(way);
    Point last = from;
    const auto goTo = [&](Point next) {
        Line(last, next);
        last = next;
    };
    goTo(from + kLead * way);
    for (int i = 0; i < kTurns; ++i)
    {
        const double share = kLead + (1.0 - 2.0 * kLead) * (i + 0.5) / kTurns;
        goTo(from + share * way + (i % 2 == 0 ? 1.0 : -1.0) * across);
    }
    goTo(to - kLead * way);
    goTo(to);
}

} // namespace boxreel
