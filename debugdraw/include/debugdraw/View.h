// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <optional>

/// @file
/// Tests if items are visible, so that collectors of a DrawList skip the others. A test may accept
/// an item that the renderer then skips, but never rejects a visible one.
namespace boxreel
{

/// The visible area of a camera.
struct View
{
    Camera camera;            ///< defines the pixels of arrows, glyphs and text
    std::optional<Rect> area; ///< visible area with a margin [m]; none: everything
    /// A viewer may enlarge the items by this factor, at least 1. Arrows that are legible at that
    /// size are collected. Above 1, what depends on the viewer's view is left to it:
    /// - Names are at what they name and not where there is room beside it. Their DrawItem::size is
    ///   1, or 2 where they have a place only while a shape of their owner is near the picture.
    /// - Springs have both forms. The size of their lines is the length from which the spring is a
    ///   zigzag [px], or below 0 in the form of shorter ones.
    /// - Dashed lines are polygons of two points, whose size is the length of a dash [px].
    double zoom = 1.0;

    /// True if something inside the box [m], or up to `reachPixels` beside it, may be visible.
    bool Shows(const Rect& box, double reachPixels = 0.0) const;
    /// Same as above, for a line from a to b [m].
    bool Shows(Vec2 a, Vec2 b, double reachPixels = 0.0) const;
    /// Same as above, for a point [m].
    bool Shows(Vec2 point, double reachPixels = 0.0) const;
};

/// Returns the visible area of a camera with a margin [px], the thickness of lines.
View ViewOf(const Camera& camera, double marginPixels);

/// Returns a view without a limit.
View ViewOfEverything(const Camera& camera);

} // namespace boxreel
