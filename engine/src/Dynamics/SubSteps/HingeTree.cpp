// SPDX-License-Identifier: MIT
#include "HingeTree.h"
#include "../Solver/Motion.h"

#include "../Direct/RowPattern.h"
#include "../Joints/JointFrame.h"
#include "../Joints/RevoluteKind.h"
#include "../State/Access.h"
#include "Closing.h"

#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

constexpr int32 kMaxDrifts = 128; ///< per step
/// Repetitions of a step with more drifts. A bound, because each costs a step: four doublings take
/// 8 drifts to kMaxDrifts. With 1 no test fails, but a chain of 1000:1 at a low post opens by
/// 0.16 m instead of 0.07 (docs/notes/tuned-constants.md).
constexpr int32 kMaxTries = 4;
/// Maximum squared rotation of a swing per drift [rad^2], by the estimate from the last step, and
/// by the actual value. A leapfrog is stable below 4 (Hairer, Lubich and Wanner, "Geometric
/// Numerical Integration", 2006, I.5). Tuned on 20 links with a ball of 1000:1,
/// docs/notes/sub-steps-chains.md.
constexpr double kEstimated = 1.8;
constexpr double kFound = 2.8;
/// A rotating body is followed as closely as one that swings this many times as fast, so it rotates
/// by at most sqrt(1.8) / 3 = 0.45 rad in a drift. A bound, not a tuned number: from 0 to 6 the
/// gaps of chains stay below 0.1 mm. More uses unnecessary drifts (docs/notes/tuned-constants.md).
constexpr double kTurns = 3.0;

/// Relative energy error of a step: more than the truncation error of drifts that resolve all
/// swings.
constexpr double kWonShare = 2e-3;
constexpr float32 kHardlyOpen = 5e-3f; ///< overlap that contacts allow [m]
constexpr float32 kTorn = 0.05f;       ///< a larger gap is hard to close [m]

int32 CountFor(double mostSquared, double squaredFrequency, float32 timeStep, int32 minimum)
{
    const double square = squaredFrequency * double(timeStep) * double(timeStep) / mostSquared;
    int32 count = minimum;
    while (double(count) * double(count) < square && count < kMaxDrifts)
    {
        ++count;
    }
    return count;
}

b2Vec2 ArmOf(const BodyData& body, const b2Vec2& local)
{
    return b2Mul(body.rotation, local - body.localCenter);
}

} // namespace

bool HingeTree::JointEnd::ByBodyAndOrder(const JointEnd& a, const JointEnd& b)
{
    return a.body->number != b.body->number ? a.body->number < b.body->number : a.order < b.order;
}

bool HingeTree::JointEnd::ByBody(const JointEnd& a, const JointEnd& b)
{
    return a.body->number < b.body->number;
}

bool HingeTree::Build(const Array<b2Joint*>& joints)
{
    m_links.clear();
    m_ends.clear();
    for (b2Joint* joint : joints)
    {
        const BodyData& a = Data(*joint->GetBodyA());
        const BodyData& b = Data(*joint->GetBodyB());
        if (joint->GetType() != e_revoluteJoint || &a == &b)
        {
            return false;
        }
        m_ends.push_back({&a, joint, m_ends.size()});
        m_ends.push_back({&b, joint, m_ends.size()});
        if (!IsMoved(a) || !IsMoved(b))
        {
            if (!m_links.empty())
            {
                return false; // attached to the world twice
            }
            AddLink(*joint, IsMoved(a) ? b : a, -1);
        }
    }
    std::sort(m_ends.begin(), m_ends.end(), JointEnd::ByBodyAndOrder);
    if (m_links.empty())
    {
        m_links.emplace_back().body = m_ends.front().body;
    }
    const std::size_t count = joints.size() + (m_links.front().joint == nullptr ? 1 : 0);
    for (std::size_t i = 0; i < m_links.size() && m_links.size() <= count; ++i)
    {
        const Link link = m_links[i];
        const auto [first, last] = std::equal_range(
            m_ends.begin(), m_ends.end(), JointEnd{link.body, nullptr, 0}, JointEnd::ByBody);
        for (auto end = first; end != last; ++end)
        {
            if (end->joint != link.joint)
            {
                AddLink(*end->joint, *link.body, int32(i));
            }
        }
    }
    return m_links.size() == count;
}

/// Adds the body that a joint connects to `above`.
void HingeTree::AddLink(b2Joint& joint, const BodyData& above, int32 parent)
{
    const BodyData& a = Data(*joint.GetBodyA());
    const bool isFirst = &a != &above;
    Link& link = m_links.emplace_back();
    link.body = isFirst ? &a : &Data(*joint.GetBodyB());
    link.above = &above;
    link.joint = static_cast<b2RevoluteJoint*>(&joint);
    link.parent = parent;
    link.direction = isFirst ? -1.0f : 1.0f;
}

bool HingeTree::Begin(const SolverContext& context, const BodyKick* kicks)
{
    for (Link& link : m_links)
    {
        const BodyData& body = *link.body;
        if (body.invMass <= 0.0f || body.invInertia <= 0.0f)
        {
            return false;
        }
        link.state = &context.bodies[body.SolverIndex()];
        link.kick = kicks[body.awakeIndex];
        link.given = Pair();
        link.givenTurn = 0.0;
        link.mass = 1.0 / double(body.invMass);
        link.turning = 1.0 / double(body.invInertia);
        if (link.joint == nullptr)
        {
            continue;
        }
        const b2RevoluteJoint& joint = *link.joint;
        const bool moved = link.parent == -1 && link.above->SolverIndex() != 0;
        if (!JointAccess::Kind<b2RevoluteJoint>::IsFree(joint) || moved)
        {
            return false;
        }
        const bool isFirst = link.direction < 0.0f;
        const b2Vec2& own = isFirst ? joint.GetLocalAnchorA() : joint.GetLocalAnchorB();
        const b2Vec2& other = isFirst ? joint.GetLocalAnchorB() : joint.GetLocalAnchorA();
        link.aboveState = &context.bodies[link.above->SolverIndex()];
        link.arm = ArmOf(body, own);
        link.aboveArm = ArmOf(*link.above, other);
        link.offset = CenterOffset(*link.above, body);
    }
    return true;
}

/// Tension forces F at arms r make a body oscillate with the frequency sqrt(sum F.r / I). A
/// leapfrog needs at least three drifts per oscillation. The number of drifts stays constant in a
/// step, because changing it adds errors as well. If it was too small, or energy was gained, the
/// step is repeated.
void HingeTree::Step(float32 timeStep, int32 subSteps)
{
    for (Link& link : m_links)
    {
        link.start = *link.state;
    }
    const double expected = LastStrain(double(timeStep)) / double(timeStep);
    const bool wereClosed = WidestGap() < kHardlyOpen;
    int32 count = CountFor(kEstimated, expected, timeStep, subSteps);
    Outcome outcome = StepIn(count, timeStep, true);
    for (int32 tries = 0; tries < kMaxTries; ++tries)
    {
        const double found = outcome.squaredFrequency;
        int32 needed = CountFor(kFound, found, timeStep, subSteps);
        needed = outcome.won ? b2Max(needed, b2Min(2 * count, kMaxDrifts)) : needed;
        if (needed <= count)
        {
            break;
        }
        count = b2Max(needed, CountFor(kEstimated, found, timeStep, subSteps));
        GoBack();
        outcome = StepIn(count, timeStep, true);
    }
    if (outcome.won)
    {
        StepSafely(count, timeStep);
    }
    if (wereClosed && WidestGap() > kNearlyClosed)
    {
        CloseWholly(timeStep);
    }
    LeaveImpulses();
}

/// Closes gaps that a fast swing has opened within a step; initial gaps close slowly.
void HingeTree::CloseWholly(float32 timeStep)
{
    for (Link& link : m_links)
    {
        link.open.SetZero();
    }
    ClosePoses(timeStep);
    Prepare();
    Stop();
}

/// For motion that cannot be resolved, such as a heavy ball that suddenly tightens a slack chain:
/// dissipates energy instead of gaining it.
void HingeTree::StepSafely(int32 count, float32 timeStep)
{
    GoBack();
    (void)StepIn(count, timeStep, false);
    if (WidestGap() > kTorn)
    {
        GoBack();
        m_stiffened = true;
        (void)StepIn(count, timeStep, false);
        m_stiffened = false;
    }
    TakeWonEnergy();
}

void HingeTree::GoBack()
{
    for (Link& link : m_links)
    {
        *link.state = link.start;
    }
}

/// A leapfrog: half a kick, drifts alternating with whole kicks, half a kick. Without impulses the
/// hinges are closed in a way that only loses energy.
HingeTree::Outcome HingeTree::StepIn(int32 count, float32 timeStep, bool byImpulses)
{
    const float32 time = timeStep / float32(count);
    for (Link& link : m_links)
    {
        link.total = Pair();
    }
    Kick(0.5f * time);
    Outcome outcome;
    double before = 0.0;
    for (int32 i = 1; i <= count; ++i)
    {
        for (Link& link : m_links)
        {
            link.noted = link.total;
            MoveByVelocity(*link.state, time, kMaxSmallMove);
        }
        byImpulses ? Close(time) : ClosePoses(time);
        Kick(i < count ? time : 0.5f * time);
        const double given = double(i < count ? time : 0.75f * time);
        const double strain = Strain(given) / given;
        // An impact is not a swing: only values of two consecutive drifts count.
        outcome.squaredFrequency = std::max(outcome.squaredFrequency, std::min(strain, before));
        before = strain;
    }
    const Energy energy = WonEnergy();
    outcome.won = energy.now - energy.due > kWonShare * energy.moved;
    return outcome;
}

HingeTree::Energy HingeTree::WonEnergy() const
{
    Energy energy;
    for (const Link& link : m_links)
    {
        const SolverBody& now = *link.state;
        const b2Vec2 path = now.d - link.start.d;
        const double work =
            link.mass * double(b2Dot(link.kick.acceleration, path)) +
            link.turning * double(link.kick.angularAcceleration * (now.angle - link.start.angle));
        const double before = KineticEnergy(link.start, link.mass, link.turning);
        energy.now += KineticEnergy(now, link.mass, link.turning);
        energy.due += before + work;
        energy.moved += before + std::abs(work);
    }
    return energy;
}

/// Scales all velocities equally, which keeps hinges at rest and the direction of a free tree's
/// momentum.
void HingeTree::TakeWonEnergy()
{
    const Energy energy = WonEnergy();
    if (energy.now <= energy.due)
    {
        return;
    }
    double mass = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (const Link& link : m_links)
    {
        mass += link.mass;
        x += link.mass * double(link.state->v.x);
        y += link.mass * double(link.state->v.y);
    }
    const bool free = m_links.front().joint == nullptr;
    const b2Vec2 mean = free ? b2Vec2(float32(x / mass), float32(y / mass)) : b2Vec2(0.0f, 0.0f);
    const double common = 0.5 * mass * double(mean.LengthSquared());
    const auto share = float32(
        std::sqrt(std::max(energy.due - common, 0.0) / std::max(energy.now - common, 1e-30)));
    for (Link& link : m_links)
    {
        link.state->v = mean + b2Min(share, 1.0f) * (link.state->v - mean);
        link.state->w *= b2Min(share, 1.0f);
    }
}

/// Returns the value of the last measurement.
float32 HingeTree::WidestGap() const
{
    float32 widest = 0.0f;
    for (const Link& link : m_links)
    {
        widest = b2Max(widest, link.joint != nullptr ? link.open.Length() : 0.0f);
    }
    return widest;
}

/// Applies a kick and solves the hinges' velocities.
void HingeTree::Kick(float32 time)
{
    Prepare();
    for (Link& link : m_links)
    {
        link.kick.Give(*link.state, time);
    }
    Stop();
}

/// Returns the maximum of sum F.r / I times the duration of the impulses since they were noted.
double HingeTree::Strain(double time)
{
    double highest = 0.0;
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        Link& link = m_links[i];
        if (link.joint != nullptr)
        {
            const Pair f{link.total.x - link.noted.x, link.total.y - link.noted.y};
            link.pull += link.lever.x * f.y - link.lever.y * f.x;
            if (link.parent != -1)
            {
                m_links[std::size_t(link.parent)].pull -=
                    link.aboveLever.x * f.y - link.aboveLever.y * f.x;
            }
        }
        const double w = kTurns * double(link.state->w);
        highest = std::max({highest, link.pull / link.turning, w * w * time});
        link.pull = 0.0;
    }
    return highest;
}

/// Same as above, for the impulses of the last step.
double HingeTree::LastStrain(double time)
{
    for (Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            link.open = TakeLevers(link);
            const b2Vec2 impulse = link.direction * link.joint->GetReactionForce(1.0f);
            link.total = {double(impulse.x), double(impulse.y)};
            link.noted = Pair();
        }
    }
    return Strain(time);
}

void HingeTree::LeaveImpulses() const
{
    for (const Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            const float32 within[3] = {link.direction * float32(link.total.x),
                                       link.direction * float32(link.total.y), 0.0f};
            const float32 beyond[3] = {};
            JointAccess::SetRowImpulses(*link.joint, within, beyond);
        }
    }
}

} // namespace box2d
