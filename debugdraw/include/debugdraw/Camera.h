// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <functional>

/// @file
/// Converts between metres and pixels. A Camera is the view of one frame; FitCamera moves it over
/// time. World y points up, pixel y down from the top left corner; pixel centres are at .5.
namespace boxreel
{

/// The visible part of the world, without rotation.
struct Camera
{
    int width = 1280;             ///< width of the picture, at least 1 [px]
    int height = 720;             ///< height of the picture, at least 1 [px]
    double centerX = 0.0;         ///< world point in the centre of the frame [m]
    double centerY = 20.0;        ///< its y coordinate [m]
    double pixelsPerMeter = 14.4; ///< > 0; the testbed's default shows 50 m in a height of 720 px

    /// Converts from the world [m] to the picture [px, y down].
    Vec2 ToPixel(Vec2 world) const;
    /// Converts from the picture [px, y down] to the world [m].
    Vec2 ToWorld(Vec2 pixel) const;
    Rect VisibleArea() const; ///< visible part of the world [m]
    /// True if all members are equal.
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// True if the view can be drawn: its numbers are finite and its scale is above zero. Neither the
/// scale nor the centre exceeds 1e15 pixels, beyond which doubles do not resolve pixels.
bool CanBeDrawn(const Camera& camera);

/// Returns the view of `area` [m], in a picture of at least 1x1 [px]. `margin` is a fraction of the
/// frame's smaller side, 0 to 0.45. An area that is empty or not finite gives the default view, 50
/// m high around (0, 20). An area smaller than a metre is enlarged to a metre.
Camera FitTo(const Rect& area, int width, int height, double margin = 0.06);

/// Returns the same view in a picture with `scale` (> 0) times as many pixels per side, rounded, at
/// least 1.
Camera Scaled(const Camera& camera, double scale);

/// Interpolates between two views of the same picture size, `share` 0 to 1: centre and height
/// linearly.
Camera Between(const Camera& from, const Camera& to, double share);

/// Receives each number of a camera's state, to save or to replace it.
using NumberVisitor = std::function<void(double&)>;

/// Keeps moving bodies in view without shaking. The view only grows, smoothly, and ignores a body
/// that has left the neighbourhood (fallen off the world). It depends on simulation steps, not on
/// frames, so that a film and a still show the same pixels.
class FitCamera
{
public:
    /// `scene`: visible area at the start: dynamic bodies and nearby static ones [m]. `width`,
    /// `height`: of the picture, at least 1 [px].
    FitCamera(int width, int height, const Rect& scene);

    /// Call after every simulation step of `dt` seconds, >= 0, with the boxes of moving bodies [m].
    /// Boxes that are empty or not finite are ignored.
    void Update(const std::vector<Rect>& movers, double dt);

    /// Returns the current view.
    const Camera& View() const { return m_view; }

    /// Visits all state that Update changes. A camera with the same construction continues
    /// identically from these numbers.
    void VisitState(const NumberVisitor& visit);

private:
    /// The area of a frame [m]. It has the picture's aspect ratio, so half the height defines its
    /// size, and interpolation between nested areas stays between them.
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
    Box m_neighbourhood; // bodies outside are ignored
    // Nested, each inside the previous one:
    Area m_target; // target of the view; only grows
    Area m_guide;  // follows the target smoothly
    Area m_shown;  // follows the guide, so that it starts smoothly too
    Camera m_view;
};

} // namespace boxreel
