// SPDX-License-Identifier: MIT
#include <debugdraw/View.h>

#include <cmath>
#include <limits>

namespace boxreel
{

namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Rounds outwards by more than the conversion to float.
float Below(double value)
{
    return std::nextafter(static_cast<float>(value), -kInfinity);
}

float Above(double value)
{
    return std::nextafter(static_cast<float>(value), kInfinity);
}

} // namespace

bool View::Shows(const Rect& box, double reachPixels) const
{
    if (!area)
    {
        return true;
    }
    const double reach = reachPixels / camera.pixelsPerMeter;
    return box.lower.x - reach <= area->upper.x && area->lower.x <= box.upper.x + reach &&
           box.lower.y - reach <= area->upper.y && area->lower.y <= box.upper.y + reach;
}

bool View::Shows(Vec2 a, Vec2 b, double reachPixels) const
{
    Rect box{a, a};
    box.Include(b);
    return Shows(box, reachPixels);
}

bool View::Shows(Vec2 point, double reachPixels) const
{
    return Shows(Rect{point, point}, reachPixels);
}

View ViewOf(const Camera& camera, double marginPixels)
{
    const double right = (0.5 * camera.width + marginPixels) / camera.pixelsPerMeter;
    const double up = (0.5 * camera.height + marginPixels) / camera.pixelsPerMeter;
    return {camera,
            Rect{{Below(camera.centerX - right), Below(camera.centerY - up)},
                 {Above(camera.centerX + right), Above(camera.centerY + up)}},
            1.0};
}

View ViewOfEverything(const Camera& camera)
{
    return {camera, std::nullopt, 1.0};
}

} // namespace boxreel
