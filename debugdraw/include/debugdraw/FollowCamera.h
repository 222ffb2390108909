// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <optional>

/// @file
/// Keeps a subject (one body, or the box around several) in the middle of the frame. Called once a
/// step of the simulation, never by frames, so that a film of any frame rate and a still show the
/// same pixels. Knows no bodies; plain arithmetic, so that every machine sees the same view.
namespace boxreel
{

/// The view rests while the subject stays within a small zone around the middle, and then goes
/// after it no farther than to have it in the zone again: a box that twitches moves nothing, and
/// the view never goes beyond where the subject has been. A subject that is too fast for the
/// smoothing drags the view along and so stays in the frame.
class FollowCamera
{
public:
    /// Starts with `subject` [m] in the middle of a picture of at least 1x1 [px]. `viewHeight`: of
    /// the frame, in metres, above 0; without one the height follows the subject's size, with a
    /// margin on every side. A subject that is empty or not finite gives the default view, 50 m
    /// high around (0, 20).
    FollowCamera(int width, int height, const Rect& subject,
                 std::optional<double> viewHeight = std::nullopt);

    /// Once after every simulation step of `dt` seconds, 0 or more. A subject [m] that is empty or
    /// not finite is ignored: the view then settles where it was going.
    void Update(const Rect& subject, double dt);

    /// What it looks at now.
    const Camera& View() const { return m_view; }

    /// All that Update changes. A camera that was made alike, of any subject, goes on from these
    /// numbers as this one does.
    void VisitState(const NumberVisitor& visit);

private:
    /// A number that goes where another one leads, along two low-passes one after the other: a
    /// critically damped spring, which cannot overshoot.
    struct Smooth
    {
        double goal = 0.0;
        double guide = 0.0; ///< follows the goal
        double shown = 0.0; ///< follows the guide, so that it starts softly too
        explicit Smooth(double start) : goal(start), guide(start), shown(start) {}
        void LeadInto(double lower, double upper); ///< moves the goal into it, if it is outside
        void HoldWithin(double lower, double upper);
        void Advance(double dt, double rest);
    };
    void Approach(Smooth& middle, double lower, double upper, double halfView, double dt);
    void Resize(const Rect& subject, double dt);
    double FittingHeight(const Rect& subject) const;
    double PixelSize() const { return m_viewHeight.shown / m_view.height; }

    Camera m_view;
    bool m_resizes;
    Smooth m_x;          // of the middle of the frame [m]
    Smooth m_y;          // [m]
    Smooth m_viewHeight; // [m]
    Rect m_subject;      // the last one that was usable
};

} // namespace boxreel
