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

// Of each of the two low-passes [s]. Longer lets a running body drift from the middle, by its speed
// times twice this; shorter makes the viewer notice each start and stop.
constexpr double kFollowTime = 0.12;

// How far from the middle the subject may go before the view moves, as a share of the frame's
// smaller side. Larger leaves a body visibly beside the middle, smaller lets its shaking through:
// this holds 2 cm in a frame of half a metre.
constexpr double kCalmZone = 0.04;

// How far from the middle a fast subject may get, as a share of half the frame.
constexpr double kFarthest = 0.5;

// Where the height follows the subject: left free on every side, as a share of that side.
constexpr double kMargin = 0.15;
// The frame keeps its height while the one that would fit lies between these shares of it. Their
// quotient is below 1/sqrt(2), for a square that rolls must not make the view breathe.
constexpr double kTooLarge = 0.65;
constexpr double kTooSmall = 1.08;

// A difference that no pixel shows: the view then comes to rest, and equal frames can be
// recognised.
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

// 1 - exp(-x) for x >= 0 from the first terms of the series of exp(x): within 4e-6 at the usual
// steps, between 0 and 1 for any.
double ShareOfWay(double x)
{
    return 1.0 - 1.0 / (1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0)));
}

} // namespace

void FollowCamera::Smooth::LeadInto(double lower, double upper)
{
    goal = std::clamp(goal, lower, upper);
}

// The guide too: the number would be drawn back otherwise.
void FollowCamera::Smooth::HoldWithin(double lower, double upper)
{
    guide = std::clamp(guide, lower, upper);
    shown = std::clamp(shown, lower, upper);
}

void FollowCamera::Smooth::Advance(double dt, double rest)
{
    const double share = dt > 0.0 ? ShareOfWay(dt / kFollowTime) : 0.0;
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

// The height of the frame in which the subject has its margin.
double FollowCamera::FittingHeight(const Rect& subject) const
{
    return m_view.height / FitTo(subject, m_view.width, m_view.height, kMargin).pixelsPerMeter;
}

// One coordinate of the middle goes after a subject from `lower` to `upper`.
void FollowCamera::Approach(Smooth& middle, double lower, double upper, double halfView, double dt)
{
    const double calm =
        kCalmZone * PixelSize() * static_cast<double>(std::min(m_view.width, m_view.height));
    const double subject = Middle(lower, upper);
    middle.LeadInto(subject - calm, subject + calm);
    middle.Advance(dt, kRestPixels * PixelSize());
    // What fits into the frame stays in it; what does not still has its calm zone.
    const double room = halfView - (upper - subject);
    const double farthest = std::max(calm, std::min(room, kFarthest * halfView));
    middle.HoldWithin(subject - farthest, subject + farthest);
}

// After the middle has moved.
void FollowCamera::Resize(const Rect& subject, double dt)
{
    const double fitting = FittingHeight(subject);
    m_viewHeight.LeadInto(fitting / kTooSmall, fitting / kTooLarge);
    m_viewHeight.Advance(dt, kRestPixels * PixelSize());
    const double aspect = static_cast<double>(m_view.width) / m_view.height;
    const double reachX = std::max(subject.upper.x - m_x.shown, m_x.shown - subject.lower.x);
    const double reachY = std::max(subject.upper.y - m_y.shown, m_y.shown - subject.lower.y);
    const double least = 2.0 * std::max(reachX / aspect, reachY);
    m_viewHeight.HoldWithin(least, std::numeric_limits<double>::infinity());
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
