// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <optional>

/// @file
/// Keeps a subject (one body, or the box around several) in the centre of the frame. Updated once
/// per simulation step, not per frame, so that a film of any frame rate and a still show the same
/// pixels. Independent of bodies. Plain arithmetic, so that every machine computes the same view.
namespace boxreel
{

/// The view rests while the subject is in a small zone around the centre. It then moves only until
/// the subject is in the zone again, so small vibrations have no effect. A subject that is too fast
/// for the smoothing moves the view directly, so that it stays in the frame.
class FollowCamera
{
public:
    /// Starts with `subject` [m] in the centre of a picture of at least 1x1 [px]. `viewHeight`: of
    /// the frame [m], > 0; by default the height follows the subject's size, with a margin. A
    /// subject that is empty or not finite gives the default view, 50 m high around (0, 20).
    FollowCamera(int width, int height, const Rect& subject,
                 std::optional<double> viewHeight = std::nullopt);

    /// Call after every simulation step of `dt` seconds, >= 0. A subject [m] that is empty or not
    /// finite is ignored: the view then settles at its target.
    void Update(const Rect& subject, double dt);

    /// Returns the current view.
    const Camera& View() const { return m_view; }

    /// Visits all state that Update changes. A camera with the same construction, for any subject,
    /// continues identically from these numbers.
    void VisitState(const NumberVisitor& visit);

private:
    /// A number that follows a goal through two low-pass filters in series: a critically damped
    /// spring, which does not overshoot.
    struct Smooth
    {
        double goal = 0.0;
        double guide = 0.0; ///< follows the goal
        double shown = 0.0; ///< follows the guide, so that it starts smoothly too
        explicit Smooth(double start) : goal(start), guide(start), shown(start) {}
        void LeadInto(double lower, double upper); ///< clamps the goal
        void HoldWithin(double lower, double upper);
        void Advance(double dt, double rest);
    };
    void Approach(Smooth& middle, double lower, double upper, double halfView, double dt);
    void Resize(const Rect& subject, double dt);
    double FittingHeight(const Rect& subject) const;
    double PixelSize() const { return m_viewHeight.shown / m_view.height; }

    Camera m_view;
    bool m_resizes;
    Smooth m_x;          // centre of the frame [m]
    Smooth m_y;          // [m]
    Smooth m_viewHeight; // [m]
    Rect m_subject;      // the last valid one
};

} // namespace boxreel
