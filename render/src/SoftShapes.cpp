// SPDX-License-Identifier: MIT
#include "SoftShapes.h"

#include "Convex.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kGridSteps = 256.0; // per pixel
constexpr double kHalfFade = 0.5;    // [px]; coverage changes from 0 to 1 over one pixel

/// Returns the points without duplicates; the last point of a closed line differs from the first.
std::vector<Point> Distinct(std::span<const Vec2> given, bool closed)
{
    std::vector<Point> points;
    const auto isLast = [&](Point p) {
        return !points.empty() && points.back().x == p.x && points.back().y == p.y;
    };
    for (const Vec2 p : given)
    {
        const Vec2 snapped = OnGrid(p);
        if (const Point point{snapped.x, snapped.y}; !isLast(point))
        {
            points.push_back(point);
        }
    }
    while (closed && points.size() > 1 && isLast(points.front()))
    {
        points.pop_back();
    }
    return points;
}

/// Returns the unit normal of a line from a to b, on the left when y points down.
Point Normal(Point a, Point b)
{
    const Point d = b - a;
    const double length = std::sqrt(d.x * d.x + d.y * d.y);
    return {d.y / length, -d.x / length};
}

/// Returns for each point the displacement that moves both its edges along their normals by 1,
/// limited by kMitreLimit.
std::vector<Point> Mitres(const std::vector<Point>& points, bool closed)
{
    const std::size_t count = points.size();
    std::vector<Point> mitres(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const bool hasBefore = closed || i > 0;
        const bool hasAfter = closed || i + 1 < count;
        const std::size_t before = hasBefore ? (i + count - 1) % count : i;
        const std::size_t after = hasAfter ? (i + 1) % count : i;
        const Point a = Normal(points[before], points[hasBefore ? i : after]);
        const Point b = Normal(points[hasAfter ? i : before], points[after]);
        const Point mean = 0.5 * (a + b);
        const double square = Dot(mean, mean);
        mitres[i] = (1.0 / std::max(square, 1.0 / (kMitreLimit * kMitreLimit))) * mean;
    }
    return mitres;
}

class Shape
{
public:
    Shape(Color color, Vec2 uv, Overlay& overlay) : m_color(color), m_uv(uv), m_overlay(overlay) {}

    std::uint32_t Corner(Point p, bool isClear)
    {
        const Color ink{m_color.r, m_color.g, m_color.b, isClear ? std::uint8_t(0) : m_color.a};
        m_overlay.vertices.push_back({OnGrid({float(p.x), float(p.y)}), m_uv, ink});
        return std::uint32_t(m_overlay.vertices.size() - 1);
    }
    void Triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        m_overlay.indices.insert(m_overlay.indices.end(), {a, b, c});
    }
    /// Adds the strip between a, b and c, d, where b follows a and d follows c.
    void Strip(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        Triangle(a, b, d);
        Triangle(a, d, c);
    }

private:
    Color m_color;
    Vec2 m_uv;
    Overlay& m_overlay;
};

} // namespace

Vec2 OnGrid(Vec2 pixel)
{
    const auto snapped = [](float value) {
        return float(std::floor(double(value) * kGridSteps + 0.5) / kGridSteps);
    };
    return {snapped(pixel.x), snapped(pixel.y)};
}

void AppendPolygon(std::span<const Vec2> corners, Color color, Vec2 uv, Overlay& overlay)
{
    std::vector<Point> points = Distinct(corners, true);
    double area = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        area += Cross(points[i], points[(i + 1) % points.size()]);
    }
    if (points.size() < 3 || area == 0.0)
    {
        return;
    }
    if (area < 0.0)
    {
        std::reverse(points.begin(), points.end());
    }
    const std::vector<Point> mitres = Mitres(points, true); // outwards
    Shape shape(color, uv, overlay);
    std::vector<std::uint32_t> inner;
    std::vector<std::uint32_t> outer;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        inner.push_back(shape.Corner(points[i] - kHalfFade * mitres[i], false));
        outer.push_back(shape.Corner(points[i] + kHalfFade * mitres[i], true));
    }
    for (std::size_t i = 2; i < points.size(); ++i)
    {
        shape.Triangle(inner[0], inner[i - 1], inner[i]);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const std::size_t next = (i + 1) % points.size();
        shape.Strip(inner[i], inner[next], outer[i], outer[next]);
    }
}

void AppendLine(std::span<const Vec2> given, bool closed, double width, Color color, Vec2 uv,
                Overlay& overlay)
{
    const std::vector<Point> points = Distinct(given, closed);
    if (points.size() < 2)
    {
        return;
    }
    const std::vector<Point> mitres = Mitres(points, closed && points.size() > 2);
    const double half = 0.5 * std::max(width, 1.0);
    Shape shape(color, uv, overlay);
    std::vector<std::array<std::uint32_t, 4>> sections; // across the line
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Point full = (half - kHalfFade) * mitres[i];
        const Point clear = (half + kHalfFade) * mitres[i];
        sections.push_back(
            {shape.Corner(points[i] - clear, true), shape.Corner(points[i] - full, false),
             shape.Corner(points[i] + full, false), shape.Corner(points[i] + clear, true)});
    }
    const std::size_t pieces = closed && points.size() > 2 ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i)
    {
        const auto& here = sections[i];
        const auto& next = sections[(i + 1) % sections.size()];
        for (std::size_t side = 0; side < 3; ++side)
        {
            shape.Strip(here[side], next[side], here[side + 1], next[side + 1]);
        }
    }
}

} // namespace boxreel
