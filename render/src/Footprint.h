// SPDX-License-Identifier: MIT
#pragma once

#include "ProgramKind.h"

#include <render/Frame.h>

#include <array>
#include <span>

/// Where in its bounds an instance lies, so that neighbours at a slant, whose bounds overlap but
/// who do not, are told apart. Used by Batches.
namespace boxreel
{

class Footprint
{
public:
    /// `attributes` as ShapeBuilder writes them; of what is no shape, or of too few of them, all of
    /// `bounds` is taken.
    Footprint(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes);

    struct Span
    {
        int x0 = 0;
        int x1 = 0; ///< excluded; not above x0: nothing
    };

    /// Holds every pixel that the instance touches between the rows y0 and y1 (excluded), within
    /// its bounds.
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
    double m_radius = 0.0; // of a disc, or 0
    std::array<Slab, 2> m_slabs;
    int m_slabCount = 0;
};

} // namespace boxreel
