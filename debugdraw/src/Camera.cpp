// SPDX-License-Identifier: MIT
#include <debugdraw/Camera.h>

#include <algorithm>
#include <cassert>
#include <cmath>

// Plain double arithmetic (no exp, no pow), so that every machine computes the same view.

namespace boxreel
{

namespace
{

// A picture of less than a metre would show the engine's slop instead of the scene.
constexpr double kSmallestSide = 1.0;

// Fractions of the frame's smaller side. A body closer than the first to the edge makes the view
// grow until it is further away than the second. The difference prevents the view from growing in
// every step.
constexpr double kCalmBorder = 0.03;
constexpr double kRoomyBorder = 0.12;
// Minimum distance between a body and the edge [px]: its outline extends beyond its box.
constexpr double kUrgentPixels = 6.0;

// Size of the neighbourhood in initial views on either side. More would shrink a scene to a dot
// when a body falls off it.
constexpr double kNeighbourViews = 1.0;

// Longer lags behind, shorter makes the camera's motion noticeable [s].
constexpr double kFollowTime = 0.2;

// Differences below this are invisible: the view then rests, and equal frames can be detected.
constexpr double kRestPixels = 0.02;

// Tolerance for coinciding edges, as a fraction of half the view's height.
constexpr double kRounding = 1e-6;

// Limit of a scale or a centre [px]. All points of a list, which are floats, are then so close that
// neither they nor their squares overflow.
constexpr double kMaxPixels = 1e15;

bool IsUsable(const Rect& box)
{
    return std::isfinite(box.lower.x) && std::isfinite(box.lower.y) && std::isfinite(box.upper.x) &&
           std::isfinite(box.upper.y) && !box.IsEmpty();
}

} // namespace

bool CanBeDrawn(const Camera& camera)
{
    const double x = camera.centerX * camera.pixelsPerMeter;
    const double y = camera.centerY * camera.pixelsPerMeter;
    return camera.pixelsPerMeter > 0.0 && camera.pixelsPerMeter <= kMaxPixels &&
           std::abs(x) <= kMaxPixels && std::abs(y) <= kMaxPixels &&
           std::isfinite(camera.centerX) && std::isfinite(camera.centerY);
}

Vec2 Camera::ToPixel(Vec2 world) const
{
    return {static_cast<float>(width * 0.5 + (world.x - centerX) * pixelsPerMeter),
            static_cast<float>(height * 0.5 - (world.y - centerY) * pixelsPerMeter)};
}

Vec2 Camera::ToWorld(Vec2 pixel) const
{
    return {static_cast<float>(centerX + (pixel.x - width * 0.5) / pixelsPerMeter),
            static_cast<float>(centerY - (pixel.y - height * 0.5) / pixelsPerMeter)};
}

Rect Camera::VisibleArea() const
{
    return {ToWorld({0.0f, static_cast<float>(height)}),
            ToWorld({static_cast<float>(width), 0.0f})};
}

Camera Between(const Camera& from, const Camera& to, double share)
{
    assert(from.width == to.width && from.height == to.height);
    const auto mix = [share](double a, double b) { return a == b ? b : a + share * (b - a); };
    Camera between = to;
    between.centerX = mix(from.centerX, to.centerX);
    between.centerY = mix(from.centerY, to.centerY);
    if (from.pixelsPerMeter != to.pixelsPerMeter)
    {
        between.pixelsPerMeter = 1.0 / mix(1.0 / from.pixelsPerMeter, 1.0 / to.pixelsPerMeter);
    }
    return between;
}

Camera Scaled(const Camera& camera, double scale)
{
    assert(scale > 0.0);
    const auto pixels = [scale](int length) {
        return std::max(1, static_cast<int>(std::floor(length * scale + 0.5)));
    };
    Camera scaled = camera;
    scaled.width = pixels(camera.width);
    scaled.height = pixels(camera.height);
    scaled.pixelsPerMeter = camera.pixelsPerMeter * scale;
    return scaled;
}

Camera FitTo(const Rect& area, int width, int height, double margin)
{
    assert(width > 0 && height > 0);
    assert(margin >= 0.0 && margin <= 0.45);
    Camera camera;
    camera.width = width;
    camera.height = height;
    if (!IsUsable(area))
    {
        camera.pixelsPerMeter = height / 50.0;
        return camera;
    }
    const double lowerX = area.lower.x;
    const double lowerY = area.lower.y;
    const double upperX = area.upper.x;
    const double upperY = area.upper.y;
    const double border = 2.0 * margin * std::min(width, height);
    camera.centerX = 0.5 * (lowerX + upperX);
    camera.centerY = 0.5 * (lowerY + upperY);
    camera.pixelsPerMeter = std::min((width - border) / std::max(upperX - lowerX, kSmallestSide),
                                     (height - border) / std::max(upperY - lowerY, kSmallestSide));
    return camera;
}

FitCamera::FitCamera(int width, int height, const Rect& scene)
    : m_aspect(static_cast<double>(width) / height), m_view(FitTo(scene, width, height))
{
    m_shown = {m_view.centerX, m_view.centerY, 0.5 * height / m_view.pixelsPerMeter};
    m_guide = m_shown;
    m_target = m_shown;
    m_neighbourhood =
        BoxOf(Area{m_shown.x, m_shown.y, m_shown.halfHeight * (1.0 + 2.0 * kNeighbourViews)});
    if (IsUsable(scene))
    {
        // A horizontal chain that hangs from one end swings down by its length.
        const double sceneWidth = double(scene.upper.x) - scene.lower.x;
        const double sceneHeight = double(scene.upper.y) - scene.lower.y;
        m_neighbourhood.left = std::min(m_neighbourhood.left, scene.lower.x - sceneHeight);
        m_neighbourhood.right = std::max(m_neighbourhood.right, scene.upper.x + sceneHeight);
        m_neighbourhood.bottom = std::min(m_neighbourhood.bottom, scene.lower.y - sceneWidth);
        m_neighbourhood.top = std::max(m_neighbourhood.top, scene.upper.y + sceneWidth);
    }
}

FitCamera::Box FitCamera::BoxOf(const Area& area) const
{
    const double halfWidth = area.halfHeight * m_aspect;
    return {area.x - halfWidth, area.y - area.halfHeight, area.x + halfWidth,
            area.y + area.halfHeight};
}

// Returns the part of `rect` in the neighbourhood, enlarged by `border` (a fraction of the smaller
// side of `area`).
FitCamera::Box FitCamera::BoxOf(const Rect& rect, double border, const Area& area) const
{
    const double room = border * 2.0 * area.halfHeight * std::min(m_aspect, 1.0);
    return {std::max<double>(rect.lower.x, m_neighbourhood.left) - room,
            std::max<double>(rect.lower.y, m_neighbourhood.bottom) - room,
            std::min<double>(rect.upper.x, m_neighbourhood.right) + room,
            std::min<double>(rect.upper.y, m_neighbourhood.top) + room};
}

bool FitCamera::Holds(const Box& outer, const Box& inner)
{
    return inner.left >= outer.left && inner.right <= outer.right && inner.bottom >= outer.bottom &&
           inner.top <= outer.top;
}

FitCamera::Area FitCamera::Blend(const Area& from, const Area& to, double share)
{
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
            from.halfHeight + share * (to.halfHeight - from.halfHeight)};
}

// Grows to the smallest area with the picture's aspect ratio around both.
void FitCamera::Widen(Area& area, const Box& box) const
{
    const Box old = BoxOf(area);
    const double left = std::min(old.left, box.left);
    const double right = std::max(old.right, box.right);
    const double bottom = std::min(old.bottom, box.bottom);
    const double top = std::max(old.top, box.top);
    area = {0.5 * (left + right), 0.5 * (bottom + top),
            0.5 * std::max(top - bottom, (right - left) / m_aspect)};
}

// Interpolates towards `goal` as far as necessary to contain `box`. Edges move linearly.
void FitCamera::Approach(Area& area, const Area& goal, const Box& box) const
{
    const Box from = BoxOf(area);
    const Box to = BoxOf(goal);
    double share = 0.0;
    const double rounding = kRounding * area.halfHeight;
    const auto reach = [&share, rounding](double lacking, double way) {
        if (lacking > rounding)
        {
            share = lacking < way ? std::max(share, lacking / way) : 1.0;
        }
    };
    reach(from.left - box.left, from.left - to.left);
    reach(box.right - from.right, to.right - from.right);
    reach(from.bottom - box.bottom, from.bottom - to.bottom);
    reach(box.top - from.top, to.top - from.top);
    area = share < 1.0 ? Blend(area, goal, share) : goal;
}

void FitCamera::Follow(double dt)
{
    const double share = dt > 0.0 ? dt / (dt + kFollowTime) : 0.0;
    m_guide = Blend(m_guide, m_target, share);
    m_shown = Blend(m_shown, m_guide, share);

    const double pixel = 2.0 * m_shown.halfHeight / m_view.height;
    const double growth = m_target.halfHeight - m_shown.halfHeight;
    const double wayX = std::abs(m_target.x - m_shown.x) + growth * m_aspect;
    const double wayY = std::abs(m_target.y - m_shown.y) + growth;
    if (std::max(wayX, wayY) < kRestPixels * pixel)
    {
        m_guide = m_target;
        m_shown = m_target;
    }
}

void FitCamera::Update(const std::vector<Rect>& movers, double dt)
{
    const Area before = m_shown;
    Rect inSight; // all movers that are not ignored
    for (const Rect& mover : movers)
    {
        const Box part = BoxOf(mover, 0.0, m_target);
        if (!IsUsable(mover) || part.right < part.left || part.top < part.bottom)
        {
            continue;
        }
        if (!Holds(BoxOf(m_target), BoxOf(mover, kCalmBorder, m_target)))
        {
            Widen(m_target, BoxOf(mover, kRoomyBorder, m_target));
        }
        inSight.Include(mover);
    }
    Follow(dt);
    if (!inSight.IsEmpty())
    {
        const double urgentBorder =
            std::min(kCalmBorder, kUrgentPixels / std::min(m_view.width, m_view.height));
        Approach(m_shown, m_target, BoxOf(inSight, urgentBorder, m_shown));
        Approach(m_guide, m_target, BoxOf(m_shown));
    }
    if (m_shown != before)
    {
        m_view.centerX = m_shown.x;
        m_view.centerY = m_shown.y;
        m_view.pixelsPerMeter = 0.5 * m_view.height / m_shown.halfHeight;
    }
}

void FitCamera::VisitState(const NumberVisitor& visit)
{
    for (Area* const area : {&m_target, &m_guide, &m_shown})
    {
        visit(area->x);
        visit(area->y);
        visit(area->halfHeight);
    }
    visit(m_view.centerX);
    visit(m_view.centerY);
    visit(m_view.pixelsPerMeter);
}

} // namespace boxreel
