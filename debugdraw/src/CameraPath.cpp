// SPDX-License-Identifier: MIT
#include <debugdraw/CameraPath.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace boxreel
{

namespace
{

// Heights with a smaller relative difference are panned between: it is invisible, and 1 - ratio
// would lose its digits.
constexpr double kSameHeight = 1e-6;

bool IsFinite(const CameraKey& key)
{
    return std::isfinite(key.time) && std::isfinite(key.centerX) && std::isfinite(key.centerY) &&
           std::isfinite(key.height);
}

// From 0 to 1, with zero slope at both ends.
double Smoothstep(double share)
{
    return share * share * (3.0 - 2.0 * share);
}

// Returns base^exponent for an exponent from 0 to 1, bit by bit: base^(1/2), base^(1/4), … for each
// 1 of the exponent. The C library's pow differs between machines, sqrt does not.
double Power(double base, double exponent)
{
    double power = exponent < 1.0 ? 1.0 : base;
    for (double rest = exponent; rest > 0.0 && rest < 1.0;)
    {
        base = std::sqrt(base);
        rest *= 2.0;
        if (rest >= 1.0)
        {
            power *= base;
            rest -= 1.0;
        }
    }
    return power;
}

CameraKey Between(const CameraKey& a, const CameraKey& b, double share)
{
    const double ratio = b.height / a.height;
    const double zoom = Power(ratio, share);
    // Zooming about a fixed point makes the centre a linear function of the height.
    const double way = std::abs(1.0 - ratio) > kSameHeight ? (1.0 - zoom) / (1.0 - ratio) : share;
    return {0.0, a.centerX + way * (b.centerX - a.centerX),
            a.centerY + way * (b.centerY - a.centerY), a.height * zoom};
}

} // namespace

std::string WhyNotPath(const std::vector<CameraKey>& keys)
{
    if (keys.size() < 2)
    {
        return "a path needs two keys or more";
    }
    for (const CameraKey& key : keys)
    {
        if (!IsFinite(key) || key.height <= 0.0)
        {
            return "all its numbers must be finite, and its heights above 0";
        }
    }
    const auto doesNotGrow = [](const CameraKey& a, const CameraKey& b) {
        return b.time <= a.time;
    };
    const bool grows = std::adjacent_find(keys.begin(), keys.end(), doesNotGrow) == keys.end();
    return grows ? "" : "its times must grow from key to key";
}

CameraPath::CameraPath(int width, int height, std::vector<CameraKey> keys)
    : m_width(width), m_height(height), m_keys(std::move(keys))
{
    assert(WhyNotPath(m_keys).empty());
}

Camera CameraPath::ViewOf(const CameraKey& key) const
{
    Camera camera;
    camera.width = m_width;
    camera.height = m_height;
    camera.centerX = key.centerX;
    camera.centerY = key.centerY;
    camera.pixelsPerMeter = m_height / key.height;
    return camera;
}

Camera CameraPath::At(double time) const
{
    const auto isBefore = [](double t, const CameraKey& key) { return t < key.time; };
    const auto next = std::upper_bound(m_keys.begin(), m_keys.end(), time, isBefore);
    if (next == m_keys.begin())
    {
        return ViewOf(m_keys.front());
    }
    if (next == m_keys.end())
    {
        return ViewOf(m_keys.back());
    }
    const CameraKey& from = next[-1];
    return ViewOf(Between(from, *next, Smoothstep((time - from.time) / (next->time - from.time))));
}

} // namespace boxreel
