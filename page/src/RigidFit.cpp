// SPDX-License-Identifier: MIT
#include "RigidFit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxreel
{
namespace
{

PagePoint MeanOf(std::span<const PagePoint> points)
{
    PagePoint mean;
    for (const PagePoint p : points)
    {
        mean.x += p.x;
        mean.y += p.y;
    }
    return {mean.x / double(points.size()), mean.y / double(points.size())};
}

} // namespace

BodyPlace BodyPlaceOf(const RigidForm& form, const RigidPlace& place, double quantum)
{
    const double angle = double(place.angle) * form.angleUnit;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const PagePoint o = *form.origin;
    return {double(place.x) * quantum + c * o.x - s * o.y,
            double(place.y) * quantum + s * o.x + c * o.y, angle};
}

// The rotation R and the translation t that minimise the sum of |R l + t - p|^2 over the points l
// of the form. With both sets about their means:
//   angle = atan2(sum l x p, sum l . p),   t = mean(p) - R mean(l)
std::optional<RigidPlace> FitPlace(const RigidForm& form, std::span<const PagePoint> points,
                                   double quantum, std::int64_t angleGuess, double tolerance)
{
    if (points.size() != form.points.size())
    {
        return std::nullopt;
    }
    const PagePoint mean = MeanOf(points);
    const PagePoint localMean = MeanOf(form.points);
    double cross = 0.0;
    double dot = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const PagePoint l{form.points[i].x - localMean.x, form.points[i].y - localMean.y};
        const PagePoint p{points[i].x - mean.x, points[i].y - mean.y};
        cross += l.x * p.y - l.y * p.x;
        dot += l.x * p.x + l.y * p.y;
    }
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double guess = double(angleGuess) * form.angleUnit;
    const double raw = std::atan2(cross, dot);
    const double angle = raw + kTurn * std::round((guess - raw) / kTurn);

    RigidPlace place;
    place.angle = std::llround(angle / form.angleUnit);
    const double stored = double(place.angle) * form.angleUnit;
    const double c = std::cos(stored);
    const double s = std::sin(stored);
    place.x = std::llround((mean.x - (c * localMean.x - s * localMean.y)) / quantum);
    place.y = std::llround((mean.y - (s * localMean.x + c * localMean.y)) / quantum);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const PagePoint l = form.points[i];
        const double x = double(place.x) * quantum + c * l.x - s * l.y;
        const double y = double(place.y) * quantum + s * l.x + c * l.y;
        if (std::max(std::abs(x - points[i].x), std::abs(y - points[i].y)) > tolerance)
        {
            return std::nullopt;
        }
    }
    return place;
}

} // namespace boxreel
