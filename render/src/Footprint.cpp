// SPDX-License-Identifier: MIT
#include "Footprint.h"

#include "Shaders.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// A direction closer to an axis than this does not improve on the bounds.
constexpr double kSteep = 1e-4;

// For larger discs [px] the bounds are used: squares of such numbers are not exact to a pixel.
constexpr double kVastRadius = 16384.0;

} // namespace

Footprint::Footprint(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes)
    : m_bounds(bounds)
{
    if (kind == ProgramKind::Ground || kind == ProgramKind::Glyph || attributes.size() < 6)
    {
        return;
    }
    m_centerX = attributes[0];
    m_centerY = attributes[1];
    const double first = attributes[4];
    const double second = attributes[5];
    if (kind == ProgramKind::Disc)
    {
        m_radius = second < kVastRadius ? second + kQuadMargin : 0.0;
    }
    else if (kind == ProgramKind::Capsule)
    {
        SetBox(attributes, first + second + kQuadMargin, second + kQuadMargin);
    }
    else
    {
        SetBox(attributes, first + kQuadMargin, second + kQuadMargin);
    }
}

void Footprint::SetBox(std::span<const float> attributes, double along, double across)
{
    const double ux = attributes[2];
    const double uy = attributes[3];
    if (std::abs(ux) > kSteep)
    {
        m_slabs[std::size_t(m_slabCount++)] = {-uy / ux, along / std::abs(ux)};
    }
    if (std::abs(uy) > kSteep)
    {
        m_slabs[std::size_t(m_slabCount++)] = {ux / uy, across / std::abs(uy)};
    }
}

Footprint::Span Footprint::Between(int y0, int y1) const
{
    const double from = std::max(y0, m_bounds.y0) - m_centerY;
    const double to = std::min(y1, m_bounds.y1) - m_centerY;
    double lower = m_bounds.x0;
    double upper = m_bounds.x1;
    for (int i = 0; i < m_slabCount; ++i)
    {
        const Slab& slab = m_slabs[std::size_t(i)];
        const double a = slab.slope * from;
        const double b = slab.slope * to;
        lower = std::max(lower, m_centerX + std::min(a, b) - slab.half);
        upper = std::min(upper, m_centerX + std::max(a, b) + slab.half);
    }
    if (m_radius > 0.0)
    {
        const double beside = std::max({from, -to, 0.0});
        const double half = std::sqrt(std::max(m_radius * m_radius - beside * beside, 0.0));
        lower = std::max(lower, m_centerX - half);
        upper = std::min(upper, m_centerX + half);
    }
    // Both are within the bounds, or the span is empty.
    return lower < upper ? Span{int(lower), int(std::ceil(upper))} : Span{};
}

} // namespace boxreel
