// SPDX-License-Identifier: MIT
#pragma once

#include "ProgramKind.h"

#include <render/Frame.h>

#include <array>
#include <span>

/// The area of an instance within its bounds, to separate diagonal neighbours with overlapping
/// bounds. Used by Batches.
namespace boxreel
{

class Footprint
{
public:
    /// `attributes` as written by ShapeBuilder. For other kinds, or too few attributes, the
    /// footprint is all of `bounds`.
    Footprint(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes);

    struct Span
    {
        int x0 = 0;
        int x1 = 0; ///< excluded; <= x0: empty
    };

    /// Returns a span that contains every pixel the instance touches between the rows y0 and y1
    /// (excluded), within its bounds.
    Span Between(int y0, int y1) const;

private:
    /// All x with |x - (centerX + slope (y - centerY))| <= half [px].
    struct Slab
    {
        double slope = 0.0;
        double half = 0.0;
    };
    void SetBox(std::span<const float> attributes, double along, double across);

    PixelBounds m_bounds;
    double m_centerX = 0.0;
    double m_centerY = 0.0;
    double m_radius = 0.0; // radius of a disc, or 0
    std::array<Slab, 2> m_slabs;
    int m_slabCount = 0;
};

} // namespace boxreel
