// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

/// Where a frame looks: metres to pixels and back. A Camera is one frame's view; FitCamera moves it
/// over time. World y points up, pixel y down from the top left corner; pixel centres lie at .5.
namespace boxreel
{

struct Camera
{
    int width = 1280; ///< [px]
    int height = 720; ///< [px]
    double centerX = 0.0;         ///< world point in the middle of the frame [m]
    double centerY = 20.0;        ///< [m]
    double pixelsPerMeter = 14.4; ///< the testbed's default: 50 m in a height of 720 px

    Vec2 ToPixel(Vec2 world) const;
    Vec2 ToWorld(Vec2 pixel) const;
    Rect VisibleArea() const; ///< [m]
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// The view of `area` with `margin` (a share of the frame's smaller side) left on every side.
Camera FitTo(const Rect& area, int width, int height, double margin = 0.06);

/// Keeps what moves in view, without shaking: the view only ever grows, smoothly, and lets go of a
/// body that has left the neighbourhood (fallen off the world). Depends on the steps of the
/// simulation alone, never on the frame rate, so that a film and a still show the same pixels.
class FitCamera
{
public:
    /// `scene`: what should be seen at the start (the moving bodies, and static ones near them).
    FitCamera(int width, int height, const Rect& scene);

    /// Once after every simulation step of `dt` seconds, with the boxes of the bodies that can move.
    void Update(const std::vector<Rect>& movers, double dt);

    const Camera& View() const { return m_view; }

private:
    int m_width;
    int m_height;
    Rect m_home;   // view at the start [m]; farther than a few of it away, a body is let go
    Rect m_target; // what should be seen by now [m]
    Rect m_shown;  // what is seen now, follows m_target smoothly [m]
    Camera m_view;
};

} // namespace boxreel
