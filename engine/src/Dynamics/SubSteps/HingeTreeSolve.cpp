// SPDX-License-Identifier: MIT
#include "Closing.h"
#include "HingeTree.h"

#include <algorithm>

/// The direct solution for all hinges of a HingeTree, and its uses.
namespace box2d
{

namespace
{

/// Rotational inertia that a body gets in a tree that is open or that a step would tear. It is a
/// fraction of its subtree's mass at the hinge. With 0.003 a ball of 1e5:1 opens its chain by five
/// times its length, with 0.03 it gains energy (docs/notes/sub-steps-chains.md).
constexpr double kStiffening = 0.01;
/// Maximum squared rotation of a swing in a drift [rad^2]. A leapfrog is stable below 4 (Hairer,
/// Lubich and Wanner, "Geometric Numerical Integration", 2006, I.5). All tests pass with 1 to 2.8;
/// with 1000 a ball of 1e5:1 opens its chain (docs/notes/tuned-constants.md).
constexpr double kMaxSwing = 1.8;
/// The cosine's next term, angle^4 / 24, is below half an ulp up to 0.029 rad. This is a third of
/// that; larger corrections are rare [rad].
constexpr float32 kSmallAngle = 0.01f;
/// The next drift closes this sufficiently [m]: half of the 10 um that tests allow. With 1e-4
/// hinges stay open by 17 um; with 0 each drift takes another solution
/// (docs/notes/tuned-constants.md).
constexpr float32 kClosed = 5e-6f;

/// Returns how far a hinge is closed at once: a large correction rotates bodies so that their
/// levers become invalid.
float32 Correction(float32 open, float32 before)
{
    return b2Clamp(open - (1.0f - kClosedShare) * RemainingError(before), -b2_maxLinearCorrection,
                   b2_maxLinearCorrection);
}

/// Returns the rotation by an angle whose fourth power is negligible.
b2Rot SmallRot(float32 angle)
{
    if (b2Abs(angle) > kSmallAngle)
    {
        return b2Rot(angle);
    }
    b2Rot q;
    q.s = angle - angle * angle * angle / 6.0f;
    q.c = 1.0f - 0.5f * angle * angle;
    return q;
}

} // namespace

/// Computes the arms at the current poses, and returns the gap of the hinge.
b2Vec2 HingeTree::Measure(const Link& link, b2Vec2& arm, b2Vec2& aboveArm)
{
    const SolverBody& body = *link.state;
    const SolverBody& above = *link.aboveState;
    arm = b2Mul(body.q, link.arm);
    aboveArm = b2Mul(above.q, link.aboveArm);
    return link.offset + body.d - above.d + arm - aboveArm;
}

void HingeTree::TakeLevers()
{
    for (Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            link.open = TakeLevers(link);
        }
    }
}

b2Vec2 HingeTree::TakeLevers(Link& link)
{
    b2Vec2 arm, aboveArm;
    const b2Vec2 open = Measure(link, arm, aboveArm);
    link.lever = {double(arm.y), -double(arm.x)};
    link.aboveLever = {double(aboveArm.y), -double(aboveArm.x)};
    return open;
}

/// Sets the inertias that Factor adds up. Under tension, light bodies swing back too fast for the
/// drifts. They get so much inertia that they do not: geometric stiffness on the diagonal (Tournier
/// et al., "Stable Constrained Dynamics", 2015). It is exact here, because the restoring torque of
/// a body depends on its own rotation only. Bodies that swing slowly keep their inertia.
void HingeTree::TakeInertias()
{
    const double square = double(m_drift) * double(m_drift) / kMaxSwing;
    for (Link& link : m_links)
    {
        const double turning = std::max(link.turning, square * link.stiffness);
        link.inertia = {link.mass, 0.0, link.mass, 0.0, 0.0, turning};
        link.load = link.mass;
    }
}

/// Call from the leaves to the root.
void HingeTree::Factor(Link& link)
{
    Link* parent = link.parent != -1 ? &m_links[std::size_t(link.parent)] : nullptr;
    if (m_stiffened)
    {
        const double squaredArm = link.lever.x * link.lever.x + link.lever.y * link.lever.y;
        link.inertia.turning += kStiffening * link.load * squaredArm;
        if (parent != nullptr)
        {
            parent->load += link.load;
        }
    }
    FactorAtHinge(link);
    if (parent != nullptr)
    {
        AddInertia(link, parent->inertia);
    }
}

/// Computes the inertia at the hinge. With v = u + w t,
///   K = M - a a^T / c,   a = M t + (x, y),   c = t.M t + 2 t.(x, y) + turning,
/// because the rotation minimizes the energy, w = -a.u / c. A root without a hinge is factored
/// about its centre of mass in the same way, t = 0.
void HingeTree::FactorAtHinge(Link& link)
{
    const Inertia m = link.inertia;
    const Pair t = link.lever;
    const double ax = m.m11 * t.x + m.m12 * t.y + m.x;
    const double ay = m.m12 * t.x + m.m22 * t.y + m.y;
    const double ease = 1.0 / (m.turning + t.x * (m.x + ax) + t.y * (m.y + ay));
    const Pair turn{ax * ease, ay * ease};
    link.ease = ease;
    link.turn = turn;
    link.k11 = m.m11 - ax * turn.x;
    link.k12 = m.m12 - ax * turn.y;
    link.k22 = m.m22 - ay * turn.y;
}

/// Adds the link's inertia to that of its parent. K has the lever t about the parent's centre of
/// mass.
void HingeTree::AddInertia(const Link& link, Inertia& parent)
{
    const Pair t = link.aboveLever;
    const double x = link.k11 * t.x + link.k12 * t.y;
    const double y = link.k12 * t.x + link.k22 * t.y;
    parent.m11 += link.k11;
    parent.m12 += link.k12;
    parent.m22 += link.k22;
    parent.x -= x;
    parent.y -= y;
    parent.turning += t.x * x + t.y * y;
}

/// Works from the leaves to the root. With the impulse g and the moment z from the subtree, an
/// impulse f at a hinge gives
///   K u = f + g - a (z + t.g) / c.
/// With `factors` the links are factored on the way: a processor does both side by side.
template <bool factors, class Want>
void HingeTree::Gather(Want&& want)
{
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        Link& link = m_links[i];
        if constexpr (factors)
        {
            Factor(link);
        }
        link.givenTurn += link.lever.x * link.given.x + link.lever.y * link.given.y;
        link.given.x -= link.turn.x * link.givenTurn;
        link.given.y -= link.turn.y * link.givenTurn;
        if (link.joint != nullptr)
        {
            want(link);
        }
        if (link.parent != -1)
        {
            AddGiven(link, m_links[std::size_t(link.parent)]);
        }
    }
}

void HingeTree::AddGiven(const Link& link, Link& parent)
{
    const double x = link.k11 * link.residual.x + link.k12 * link.residual.y - link.given.x;
    const double y = link.k12 * link.residual.x + link.k22 * link.residual.y - link.given.y;
    parent.given.x -= x;
    parent.given.y -= y;
    parent.givenTurn += link.aboveLever.x * x + link.aboveLever.y * y;
}

/// From the root to the leaves: the changes of velocity.
template <class Take>
void HingeTree::Spread(Take&& take)
{
    for (Link& link : m_links)
    {
        FindChange(link, link.parent != -1 ? &m_links[std::size_t(link.parent)] : nullptr);
        link.given = Pair();
        link.givenTurn = 0.0;
        take(link);
    }
}

void HingeTree::ForgetGiven()
{
    for (Link& link : m_links)
    {
        link.given = Pair();
        link.givenTurn = 0.0;
    }
}

void HingeTree::FindChange(Link& link, const Link* parent)
{
    Pair u = link.residual;
    if (parent != nullptr)
    {
        u.x += parent->change.x - parent->changeTurn * link.aboveLever.x;
        u.y += parent->change.y - parent->changeTurn * link.aboveLever.y;
    }
    else if (link.joint == nullptr)
    {
        const double determinant = link.k11 * link.k22 - link.k12 * link.k12;
        u.x = (link.k22 * link.given.x - link.k12 * link.given.y) / determinant;
        u.y = (link.k11 * link.given.y - link.k12 * link.given.x) / determinant;
    }
    const double w = link.ease * link.givenTurn - (link.turn.x * u.x + link.turn.y * u.y);
    link.impulse.x = link.k11 * u.x + link.k12 * u.y - link.given.x;
    link.impulse.y = link.k12 * u.x + link.k22 * u.y - link.given.y;
    link.change.x = u.x + w * link.lever.x;
    link.change.y = u.y + w * link.lever.y;
    link.changeTurn = w;
}

void HingeTree::Stop()
{
    TakeInertias();
    Gather<true>([](Link& link) {
        const SolverBody& a = *link.aboveState;
        const SolverBody& b = *link.state;
        link.residual.x = double(a.v.x) - double(a.w) * link.aboveLever.x - double(b.v.x) +
                          double(b.w) * link.lever.x;
        link.residual.y = double(a.v.y) - double(a.w) * link.aboveLever.y - double(b.v.y) +
                          double(b.w) * link.lever.y;
    });
    Spread([](Link& link) { AddVelocity(link); });
}

void HingeTree::AddVelocity(Link& link)
{
    SolverBody& body = *link.state;
    body.v.x = float32(double(body.v.x) + link.change.x);
    body.v.y = float32(double(body.v.y) + link.change.y);
    body.w = float32(double(body.w) + link.changeTurn);
    link.total.x += link.impulse.x;
    link.total.y += link.impulse.y;
}

void HingeTree::AddPose(Link& link, float32 timeStep)
{
    SolverBody& body = *link.state;
    body.d += timeStep * b2Vec2(float32(link.change.x), float32(link.change.y));
    const float32 turn = timeStep * float32(link.changeTurn);
    body.angle += turn;
    body.q = b2Mul(body.q, SmallRot(turn));
}

/// Sets the change of speed that closes the hinge in the given time. Returns the gap.
float32 HingeTree::WantClosed(Link& link, float32 timeStep)
{
    b2Vec2 arm, aboveArm;
    const b2Vec2 open = Measure(link, arm, aboveArm);
    const float32 x = Correction(open.x, link.open.x);
    const float32 y = Correction(open.y, link.open.y);
    const double perTime = 1.0 / double(timeStep);
    link.residual = {-double(x) * perTime, -double(y) * perTime};
    return b2Max(b2Abs(x), b2Abs(y));
}

void HingeTree::Close(float32 timeStep)
{
    for (Link& link : m_links)
    {
        link.opened = *link.state;
        link.totalBefore = link.total;
    }
    if (CloseByImpulses(timeStep))
    {
        return;
    }
    for (Link& link : m_links)
    {
        *link.state = link.opened;
        link.total = link.totalBefore;
    }
    ClosePoses(timeStep);
}

/// False if the gaps increased: after a large rotation in the drift, the levers from before it are
/// invalid.
bool HingeTree::CloseByImpulses(float32 timeStep)
{
    float32 first = 0.0f;
    for (int32 i = 0; i < kMaxCloses; ++i)
    {
        float32 widest = 0.0f;
        Gather<false>([&](Link& link) { widest = b2Max(widest, WantClosed(link, timeStep)); });
        if (i > 0 && (widest > first || widest < kClosed))
        {
            ForgetGiven();
            return widest <= first;
        }
        first = i == 0 ? widest : first;
        Spread([&](Link& link) {
            AddVelocity(link);
            AddPose(link, timeStep);
        });
        if (widest < kNearlyClosed)
        {
            break;
        }
    }
    return true;
}

/// Closes by poses only, with the levers of each pose. Velocities that do not close the hinges
/// would disturb them for long.
void HingeTree::ClosePoses(float32 timeStep)
{
    for (int32 i = 0; i < kMaxPoseCloses; ++i)
    {
        for (Link& link : m_links)
        {
            if (link.joint != nullptr)
            {
                (void)TakeLevers(link);
            }
        }
        TakeInertias();
        float32 widest = 0.0f;
        Gather<true>([&](Link& link) { widest = b2Max(widest, WantClosed(link, timeStep)); });
        Spread([&](Link& link) { AddPose(link, timeStep); });
        if (widest < kNearlyClosed)
        {
            break;
        }
    }
}

} // namespace box2d
