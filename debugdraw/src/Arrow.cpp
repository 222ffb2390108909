// SPDX-License-Identifier: MIT
#include <debugdraw/Arrow.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{

void AddArrow(DrawList& list, const Camera& camera, Vec2 tail, Vec2 tip, const Paint& paint,
              const ArrowHead& head)
{
    const double dx = double(tip.x) - double(tail.x);
    const double dy = double(tip.y) - double(tail.y);
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0.0) || !std::isfinite(length))
    {
        return;
    }
    const double wanted = head.length / camera.pixelsPerMeter; // [m]
    const double along = std::min(wanted, length);
    const double across = head.halfWidth / camera.pixelsPerMeter * (along / wanted);
    const double ux = dx / length;
    const double uy = dy / length;
    const double baseX = tip.x - along * ux;
    const double baseY = tip.y - along * uy;
    const Vec2 base{float(baseX), float(baseY)};
    if (along < length || head.open)
    {
        list.AddSegment(tail, head.open ? tip : base, paint);
    }
    const Vec2 corners[3] = {tip,
                             {float(baseX - across * uy), float(baseY + across * ux)},
                             {float(baseX + across * uy), float(baseY - across * ux)}};
    if (head.open)
    {
        list.AddSegment(corners[1], tip, paint);
        list.AddSegment(corners[2], tip, paint);
        return;
    }
    list.AddSolidPolygon(corners, 3, paint);
}

} // namespace boxreel
