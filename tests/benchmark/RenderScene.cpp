// SPDX-License-Identifier: MIT
#include "RenderScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace bench
{
namespace
{

using boxreel::Camera;
using boxreel::Color;
using boxreel::DrawList;
using boxreel::Vec2;

constexpr double kPixelsPerMeter = 16.0;
constexpr double kGap = 1.0; ///< between neighbours at least, outlines included [px]
constexpr std::size_t kOneIn = 20;

constexpr Color kColors[] = {
    {230, 179, 179}, {230, 179, 179}, {153, 153, 153}, {128, 230, 128}, {128, 128, 230}};
constexpr Color kLineColor{128, 204, 204};

class Random
{
public:
    explicit Random(unsigned seed) : m_generator(seed) {}
    double Between(double a, double b)
    {
        return a + (b - a) * double(m_generator()) / 4294967296.0;
    }
    std::size_t Below(std::size_t count) { return m_generator() % count; }

private:
    std::mt19937 m_generator; // its numbers are laid down by the standard
};

struct Body
{
    std::size_t kind = 0;    ///< by tenths: 0 to 4 box, 5 and 6 polygon, 7 and 8 circle, 9 segment
    double x = 0.0, y = 0.0; ///< [m]
    double radius = 0.0;     ///< of the circle around it [m]
    double angle = 0.0;      ///< [rad]
    std::vector<double> directions{}; ///< of the corners, from the centre [rad]
    Color color{};
};

std::vector<double> DirectionsOf(std::size_t kind, Random& random)
{
    std::vector<double> directions;
    if (kind < 5)
    {
        // A box of 1:1 to 1:2.5.
        const double half = std::atan(random.Between(0.4, 1.0));
        directions = {-half, half, std::numbers::pi - half, std::numbers::pi + half};
    }
    else if (kind < 7)
    {
        const std::size_t corners = 3 + random.Below(6);
        const double step = 2.0 * std::numbers::pi / double(corners);
        for (std::size_t i = 0; i < corners; ++i)
        {
            directions.push_back(step * (double(i) + random.Between(-0.2, 0.2)));
        }
    }
    return directions;
}

std::vector<Body> MakeBodies(const RenderCase& one)
{
    Random random(1);
    const int columns = int(std::ceil(std::sqrt(double(one.count) * one.width / one.height)));
    const int rows = (one.count + columns - 1) / columns;
    const double width = one.width / kPixelsPerMeter / columns;
    const double height = one.height / kPixelsPerMeter / rows;
    const double outline = 1.25; // px, half of it on either side
    const double room = 0.5 * (std::min(width, height) - (kGap + outline) / kPixelsPerMeter);
    std::vector<Body> bodies;
    for (int i = 0; i < one.count; ++i)
    {
        Body body;
        body.kind = random.Below(10);
        body.radius = room * random.Between(0.8, 1.0);
        const double freedom = room - body.radius;
        body.x = width * (i % columns + 0.5) + random.Between(-freedom, freedom);
        body.y = height * (i / columns + 0.5) + random.Between(-freedom, freedom);
        body.angle = random.Between(0.0, 2.0 * std::numbers::pi);
        body.directions = DirectionsOf(body.kind, random);
        body.color = body.kind == 9 ? kLineColor : kColors[random.Below(std::size(kColors))];
        bodies.push_back(std::move(body));
    }
    return bodies;
}

Vec2 Beside(const Body& body, double direction)
{
    return {float(body.x + body.radius * std::cos(body.angle + direction)),
            float(body.y + body.radius * std::sin(body.angle + direction))};
}

void AppendTo(DrawList& list, const Body& body)
{
    const Vec2 center{float(body.x), float(body.y)};
    if (body.kind < 7)
    {
        std::array<Vec2, 8> corners;
        for (std::size_t i = 0; i < body.directions.size(); ++i)
        {
            corners[i] = Beside(body, body.directions[i]);
        }
        list.AddSolidPolygon(corners.data(), body.directions.size(), body.color);
    }
    else if (body.kind < 9)
    {
        list.AddSolidCircle(center, float(body.radius),
                            {float(std::cos(body.angle)), float(std::sin(body.angle))}, body.color);
    }
    else
    {
        list.AddSegment(Beside(body, 0.0), Beside(body, std::numbers::pi), body.color);
    }
}

/// By their numbers, those that move; ties by number, so that there is one answer.
std::vector<std::size_t> MoversOf(const std::vector<Body>& bodies, const RenderCase& one,
                                  Change change)
{
    std::vector<std::pair<double, std::size_t>> order;
    Random random(2);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const double dx = bodies[i].x - 0.4 * one.width / kPixelsPerMeter;
        const double dy = bodies[i].y - 0.4 * one.height / kPixelsPerMeter;
        const double shuffled = random.Between(0.0, 1.0);
        order.emplace_back(change == Change::Together ? dx * dx + dy * dy : shuffled, i);
    }
    std::sort(order.begin(), order.end());
    const std::size_t count = change == Change::All    ? bodies.size()
                              : change == Change::None ? 0
                                                       : (bodies.size() + kOneIn - 1) / kOneIn;
    std::vector<std::size_t> movers;
    for (std::size_t i = 0; i < count; ++i)
    {
        movers.push_back(order[i].second);
    }
    return movers;
}

RenderCase CaseOf(int count, int width, int height)
{
    return {std::to_string(count) + "-" + std::to_string(height) + "p", count, width, height};
}

} // namespace

const std::vector<RenderCase>& AllRenderCases()
{
    static const std::vector<RenderCase> all = [] {
        std::vector<RenderCase> cases;
        for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{1920, 1080}})
        {
            for (const int count : {50, 1500, 10000})
            {
                cases.push_back(CaseOf(count, width, height));
            }
        }
        return cases;
    }();
    return all;
}

DrawList MakeRenderScene(const RenderCase& one, Change change)
{
    std::vector<Body> bodies = MakeBodies(one);
    for (const std::size_t mover : MoversOf(bodies, one, change))
    {
        bodies[mover].x += 0.7 / kPixelsPerMeter;
        bodies[mover].y -= 0.4 / kPixelsPerMeter;
        bodies[mover].angle += 0.05;
    }
    DrawList list;
    for (const Body& body : bodies)
    {
        AppendTo(list, body);
    }
    return list;
}

Camera CameraOf(const RenderCase& one)
{
    Camera camera;
    camera.width = one.width;
    camera.height = one.height;
    camera.pixelsPerMeter = kPixelsPerMeter;
    camera.centerX = 0.5 * one.width / kPixelsPerMeter;
    camera.centerY = 0.5 * one.height / kPixelsPerMeter;
    return camera;
}

} // namespace bench
