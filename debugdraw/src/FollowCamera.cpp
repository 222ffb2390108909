// SPDX-License-Identifier: MIT
#include <debugdraw/FollowCamera.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace boxreel
{

namespace
{

// Time constant of each low-pass filter [s]. Longer lets a moving body drift from the centre, by
// its speed times twice this; shorter makes each start and stop noticeable.
constexpr double kFollowTime = 0.12;

// Size of the zone in which the view rests, as a fraction of the frame's smaller side. Larger
// leaves a body visibly off-centre, smaller shows its vibration: this allows 2 cm in a frame of
// half a metre.
constexpr double kCalmZone = 0.04;

// Maximum distance of a fast subject from the centre, as a fraction of half the frame.
constexpr double kFarthest = 0.5;

// Margin if the height follows the subject, as a fraction of each side.
constexpr double kMargin = 0.15;
// The frame keeps its height while the fitting one is between these fractions of it. Their quotient
// is below 1/sqrt(2), so that a rolling square does not change the view.
constexpr double kTooLarge = 0.65;
constexpr double kTooSmall = 1.08;

// Differences below this are invisible: the view then rests, and equal frames can be detected.
constexpr double kRestPixels = 0.02;

bool IsUsable(const Rect& box)
{
    return std::isfinite(box.lower.x) && std::isfinite(box.lower.y) && std::isfinite(box.upper.x) &&
           std::isfinite(box.upper.y) && !box.IsEmpty();
}

double Middle(double a, double b)
{
    return 0.5 * (a + b);
}

// Approximates 1 - exp(-x) for x >= 0 by the first terms of exp(x): within 4e-6 at typical steps,
// between 0 and 1 for any.
double FilterFraction(double x)
{
    return 1.0 - 1.0 / (1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0)));
}

} // namespace

void FollowCamera::Smooth::LeadInto(double lower, double upper)
{
    goal = std::clamp(goal, lower, upper);
}

// Clamps the guide too; otherwise it would pull the number back.
void FollowCamera::Smooth::HoldWithin(double lower, double upper)
{
    guide = std::clamp(guide, lower, upper);
    shown = std::clamp(shown, lower, upper);
}

void FollowCamera::Smooth::Advance(double dt, double rest)
{
    const double share = dt > 0.0 ? FilterFraction(dt / kFollowTime) : 0.0;
    guide += share * (goal - guide);
    shown += share * (guide - shown);
    if (std::max(std::abs(goal - guide), std::abs(goal - shown)) < rest)
    {
        guide = goal;
        shown = goal;
    }
}

FollowCamera::FollowCamera(int width, int height, const Rect& subject,
                           std::optional<double> viewHeight)
    : m_view(FitTo(subject, width, height, kMargin)),
      m_resizes(!viewHeight), m_x{m_view.centerX}, m_y{m_view.centerY},
      m_viewHeight{viewHeight.value_or(height / m_view.pixelsPerMeter)}, m_subject(subject)
{
    assert(m_viewHeight.shown > 0.0);
    m_view.pixelsPerMeter = height / m_viewHeight.shown;
}

// Returns the height of the frame in which the subject has its margin.
double FollowCamera::FittingHeight(const Rect& subject) const
{
    return m_view.height / FitTo(subject, m_view.width, m_view.height, kMargin).pixelsPerMeter;
}

// Moves one coordinate of the centre after a subject from `lower` to `upper`.
void FollowCamera::Approach(Smooth& middle, double lower, double upper, double halfView, double dt)
{
    const double calm =
        kCalmZone * PixelSize() * static_cast<double>(std::min(m_view.width, m_view.height));
    const double subject = Middle(lower, upper);
    middle.LeadInto(subject - calm, subject + calm);
    middle.Advance(dt, kRestPixels * PixelSize());
    // A subject that fits stays in the frame; a larger one still has its resting zone.
    const double room = halfView - (upper - subject);
    const double farthest = std::max(calm, std::min(room, kFarthest * halfView));
    middle.HoldWithin(subject - farthest, subject + farthest);
}

// Call after the centre has moved.
void FollowCamera::Resize(const Rect& subject, double dt)
{
    const double fitting = FittingHeight(subject);
    m_viewHeight.LeadInto(fitting / kTooSmall, fitting / kTooLarge);
    m_viewHeight.Advance(dt, kRestPixels * PixelSize());
    const double aspect = static_cast<double>(m_view.width) / m_view.height;
    const double reachX = std::max(subject.upper.x - m_x.shown, m_x.shown - subject.lower.x);
    const double reachY = std::max(subject.upper.y - m_y.shown, m_y.shown - subject.lower.y);
    const double minimum = 2.0 * std::max(reachX / aspect, reachY);
    m_viewHeight.HoldWithin(minimum, std::numeric_limits<double>::infinity());
}

void FollowCamera::Update(const Rect& subject, double dt)
{
    if (IsUsable(subject))
    {
        m_subject = subject;
    }
    if (!IsUsable(m_subject))
    {
        return;
    }
    const double halfHeight = 0.5 * m_viewHeight.shown;
    const double halfWidth = halfHeight * m_view.width / m_view.height;
    Approach(m_x, m_subject.lower.x, m_subject.upper.x, halfWidth, dt);
    Approach(m_y, m_subject.lower.y, m_subject.upper.y, halfHeight, dt);
    if (m_resizes)
    {
        Resize(m_subject, dt);
    }
    m_view.centerX = m_x.shown;
    m_view.centerY = m_y.shown;
    m_view.pixelsPerMeter = m_view.height / m_viewHeight.shown;
}

void FollowCamera::VisitState(const NumberVisitor& visit)
{
    for (Smooth* const number : {&m_x, &m_y, &m_viewHeight})
    {
        visit(number->goal);
        visit(number->guide);
        visit(number->shown);
    }
    for (float* const side :
         {&m_subject.lower.x, &m_subject.lower.y, &m_subject.upper.x, &m_subject.upper.y})
    {
        double wide = *side;
        visit(wide);
        *side = static_cast<float>(wide);
    }
    visit(m_view.centerX);
    visit(m_view.centerY);
    visit(m_view.pixelsPerMeter);
}

} // namespace boxreel
