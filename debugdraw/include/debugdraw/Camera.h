// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <functional>

/// @file
/// Where a frame looks: metres to pixels and back. A Camera is one frame's view; FitCamera moves it
/// over time. World y points up, pixel y down from the top left corner; pixel centres lie at .5.
namespace boxreel
{

/// Which part of the world is seen, and how large; nothing turns it.
struct Camera
{
    int width = 1280;             ///< of the picture, at least 1 [px]
    int height = 720;             ///< of the picture, at least 1 [px]
    double centerX = 0.0;         ///< world point in the middle of the frame [m]
    double centerY = 20.0;        ///< its height in the world [m]
    double pixelsPerMeter = 14.4; ///< above 0; the testbed's default is 50 m in a height of 720 px

    /// From the world [m] to the picture [px, y down].
    Vec2 ToPixel(Vec2 world) const;
    /// From the picture [px, y down] to the world [m].
    Vec2 ToWorld(Vec2 pixel) const;
    Rect VisibleArea() const; ///< what of the world the picture shows [m]
    /// True if all members are equal.
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Whether pictures can be made of this view: its numbers are finite, its scale is above zero, and
/// neither the scale nor the centre is more than 1e15 pixels, beyond which doubles do not tell one
/// pixel from the next.
bool CanBeDrawn(const Camera& camera);

/// The view of `area` [m], in a picture of at least 1x1 [px], with `margin` (a share of the frame's
/// smaller side, 0 to 0.45) left on every side. An area that is empty or not finite gives the
/// default view, 50 m high around (0, 20); a smaller one than a metre is shown as a metre.
Camera FitTo(const Rect& area, int width, int height, double margin = 0.06);

/// The same view in a picture of `scale` (above 0) times as many pixels each way (rounded, at least
/// 1).
Camera Scaled(const Camera& camera, double scale);

/// `share` of the way from one view of a picture to another of it, 0 to 1: centre and height in
/// proportion.
Camera Between(const Camera& from, const Camera& to, double share);

/// Is handed the numbers that a camera carries from step to step, one after the other: to keep
/// them, or to replace them by what was kept.
using NumberVisitor = std::function<void(double&)>;

/// Keeps what moves in view, without shaking: the view only ever grows, smoothly, and lets go of a
/// body that has left the neighbourhood (fallen off the world). Depends on the steps of the
/// simulation alone, never on the frame rate, so that a film and a still show the same pixels.
class FitCamera
{
public:
    /// `scene`: what should be seen at the start (the moving bodies, and static ones near them)
    /// [m]. `width`, `height`: of the picture, at least 1 [px].
    FitCamera(int width, int height, const Rect& scene);

    /// Once after every simulation step of `dt` seconds, 0 or more, with the boxes [m] of the
    /// bodies that can move. Boxes that are empty or not finite are ignored.
    void Update(const std::vector<Rect>& movers, double dt);

    /// What it looks at now.
    const Camera& View() const { return m_view; }

    /// All that Update changes. A camera that was made alike goes on from these numbers as this one
    /// does.
    void VisitState(const NumberVisitor& visit);

private:
    /// What a frame shows [m]. Always of the picture's shape, so half the height says it all, and a
    /// blend of two that lie one in the other lies between them.
    struct Area
    {
        double x = 0.0; ///< centre
        double y = 0.0;
        double halfHeight = 0.0;
        friend bool operator==(const Area&, const Area&) = default;
    };
    /// A Rect without rounding [m].
    struct Box
    {
        double left, bottom, right, top;
    };
    Box BoxOf(const Area& area) const;
    Box BoxOf(const Rect& rect, double border, const Area& area) const;
    void Widen(Area& area, const Box& box) const;
    void Approach(Area& area, const Area& goal, const Box& box) const;
    void Follow(double dt);
    static bool Holds(const Box& outer, const Box& inner);
    static Area Blend(const Area& from, const Area& to, double share);

    double m_aspect;     // width / height of the picture
    Box m_neighbourhood; // outside of it a body is let go
    // Each lies in the one before:
    Area m_target; // where the view is going; only ever grows
    Area m_guide;  // follows the target smoothly
    Area m_shown;  // follows the guide, so that it starts softly too
    Camera m_view;
};

} // namespace boxreel
