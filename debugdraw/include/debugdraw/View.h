// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <optional>

/// @file
/// What a picture can show of a world, asked by whoever collects a DrawList, so that what is not
/// seen is not collected. A test errs on one side only: it may let something through that the
/// renderer then leaves out, never the reverse.
namespace boxreel
{

/// What a camera sees.
struct View
{
    Camera camera;            ///< whose pixels arrows, glyphs and letters are measured in
    std::optional<Rect> area; ///< what is seen and a margin around it [m]; none: everything

    /// May something be seen that lies in the box around these points [m], or at most so many
    /// pixels beside it?
    bool Shows(const Rect& box, double reachPixels = 0.0) const;
    /// The same for a line from a to b [m].
    bool Shows(Vec2 a, Vec2 b, double reachPixels = 0.0) const;
    /// The same for a point [m].
    bool Shows(Vec2 point, double reachPixels = 0.0) const;
};

/// What a camera sees, and so many pixels around it: as much as lines are drawn thick.
View ViewOf(const Camera& camera, double marginPixels);

/// Everything, wherever the camera looks.
View ViewOfEverything(const Camera& camera);

} // namespace boxreel
