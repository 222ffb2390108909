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

/// Only half a kick follows the last drift. Impulses that carry weight then act for half of the
/// drift's time, those that turn the links for all of it. This is the mean of both shares.
constexpr float32 kLastShare = 0.75f;

/// Forces of a drift that are this many times those of the last step are a jerk. It tears hinges if
/// the inertia does not follow it. An inertia that follows smaller changes as well feeds the
/// swings that change it. With 1.5 a ball of 1e5:1 gains 240 % of energy; 3 is as good as 2
/// (docs/notes/sub-steps-chains.md).
constexpr double kJerk = 2.0;
/// Relative energy error of a step: more than the truncation error of swings that drifts can
/// follow. With a tenth steps are repeated for that error; with ten times as much chains of 1000:1
/// gain 1.1 % of energy (docs/notes/tuned-constants.md).
constexpr double kGainedShare = 2e-3;
/// A step that lost energy is repeated, and one that gained energy or tore a hinge, with stiffened
/// hinges. It takes this many times as many sub-steps, and no fewer than these. With as many as
/// before, a ball of 1000:1 tears its chain (docs/notes/sub-steps-chains.md).
constexpr int32 kSafeShare = 4;
constexpr int32 kMinSafe = 16;
/// Steps that lose energy are repeated up to this ratio of neighbours' masses. Lighter links swing
/// on if they lose nothing, and tear hinges. With 30:1 a chain loses 16 % instead of 55 % in 20 s
/// (4 sub-steps), with 100:1 68 % instead of 42 % (docs/notes/sub-steps-chains.md).
constexpr float32 kMaxKeptRatio = 40.0f;
/// A larger gap is hard to close [m]: a quarter of the 0.2 m that an iteration closes at most. With
/// 0.0005 steps that hold are repeated, and a chain of 1000:1 gains 0.27 % of energy instead of
/// 0.07. Without a limit no test fails (docs/notes/tuned-constants.md).
constexpr float32 kTorn = 0.05f;
/// Wider gaps at the start count as open: the slop, which contacts allow as well [m]. With 1e-5 a
/// tree at rest counts as open and a chain under a heavy load swings on; with 0.05 no test fails
/// (docs/notes/tuned-constants.md).
constexpr float32 kHardlyOpen = 5e-3f;
/// Prevents a division by zero where a tree has no energy but that of its common motion [J]. Any
/// energy that matters is larger.
constexpr double kMinEnergy = 1e-30;

b2Vec2 ArmOf(const BodyData& body, const b2Vec2& local)
{
    return b2Mul(body.rotation, local - body.localCenter);
}

} // namespace

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
            AddLink(*joint, IsMoved(a) ? b : a, -1);
        }
    }
    const auto bodyOf = [](const JointEnd& end) { return end.body->number; };
    std::sort(m_ends.begin(), m_ends.end(), [&](const JointEnd& a, const JointEnd& b) {
        return bodyOf(a) != bodyOf(b) ? bodyOf(a) < bodyOf(b) : a.order < b.order;
    });
    if (m_links.empty())
    {
        m_links.emplace_back().body = m_ends.front().body;
    }
    const std::size_t count = joints.size() + (m_links.front().joint == nullptr ? 1 : 0);
    for (std::size_t i = 0; i < m_links.size() && m_links.size() <= count; ++i)
    {
        const Link link = m_links[i];
        for (const JointEnd& end : std::ranges::equal_range(m_ends, link.body->number, {}, bodyOf))
        {
            if (end.joint != link.joint)
            {
                AddLink(*end.joint, *link.body, int32(i));
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
    m_maxDamping = 0.0f;
    m_unequal = false;
    for (Link& link : m_links)
    {
        const BodyData& body = *link.body;
        if (body.invMass <= 0.0f || body.invInertia <= 0.0f)
        {
            return false;
        }
        link.state = &context.bodies[body.SolverIndex()];
        link.kick = kicks[body.awakeIndex];
        m_maxDamping =
            b2Max(m_maxDamping, b2Max(link.kick.linearDamping, link.kick.angularDamping));
        link.given = Pair();
        link.givenTurn = 0.0;
        link.mass = 1.0 / double(body.invMass);
        link.turning = 1.0 / double(body.invInertia);
        if (link.joint == nullptr)
        {
            continue;
        }
        const float32 above = link.above->SolverInvMass();
        m_unequal = m_unequal || (above > 0.0f && (above > kMaxKeptRatio * body.invMass ||
                                                   body.invMass > kMaxKeptRatio * above));
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

void HingeTree::Step(float32 timeStep, int32 subSteps, float32 lastStep)
{
    for (Link& link : m_links)
    {
        link.start = *link.state;
    }
    TakeLastStiffness(double(lastStep));
    const bool wereClosed = WidestGap() < kHardlyOpen;
    const int32 safe = b2Max(kSafeShare * subSteps, kMinSafe);
    const auto fails = [&](double gained) {
        return gained > kGainedShare || (wereClosed && WidestGap() > kTorn);
    };
    m_stiffened = !wereClosed;
    double gained = StepIn(subSteps, timeStep);
    // Without this, gains would be taken back and losses kept.
    const double lossless = -kGainedShare - 2.0 * double(m_maxDamping * timeStep);
    if (gained < lossless && wereClosed && !m_unequal && WidestGap() < kTorn)
    {
        GoBack(lastStep);
        gained = StepIn(safe, timeStep);
    }
    if (fails(gained))
    {
        GoBack(lastStep);
        m_stiffened = true;
        if (fails(StepIn(safe, timeStep)))
        {
            TakeGainedEnergy();
        }
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
    TakeLevers();
    Stop();
}

void HingeTree::GoBack(float32 lastStep)
{
    for (Link& link : m_links)
    {
        *link.state = link.start;
    }
    TakeLastStiffness(double(lastStep));
}

/// A leapfrog: half a kick, drifts alternating with whole kicks, half a kick. Returns the energy
/// gained, as a share of the energy moved.
double HingeTree::StepIn(int32 count, float32 timeStep)
{
    m_timeStep = timeStep;
    m_drift = timeStep / float32(count);
    for (Link& link : m_links)
    {
        link.total = Pair();
    }
    Kick(0.5f * m_drift);
    for (int32 i = 1; i <= count; ++i)
    {
        for (Link& link : m_links)
        {
            link.noted = link.total;
            MoveByVelocity(*link.state, m_drift, kMaxSmallMove);
        }
        Close(m_drift);
        Kick(i < count ? m_drift : 0.5f * m_drift);
        FindStiffness(double(i < count ? m_drift : kLastShare * m_drift));
        if (!m_stiffened)
        {
            HoldStiffness();
        }
    }
    const Energy energy = GainedEnergy();
    return energy.moved > 0.0 ? (energy.now - energy.due) / energy.moved : 0.0;
}

HingeTree::Energy HingeTree::GainedEnergy() const
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
        // What the forces of a step would give. Without it, a tree at rest gains by rounding.
        const double kicked =
            0.5 * link.mass * double((m_timeStep * link.kick.acceleration).LengthSquared());
        energy.moved += before + std::abs(work) + kicked;
    }
    return energy;
}

/// Scales all velocities equally, which keeps hinges at rest and the direction of a free tree's
/// momentum.
void HingeTree::TakeGainedEnergy()
{
    const Energy energy = GainedEnergy();
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
        std::sqrt(std::max(energy.due - common, 0.0) / std::max(energy.now - common, kMinEnergy)));
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
    TakeLevers();
    for (Link& link : m_links)
    {
        link.kick.Give(*link.state, time);
    }
    Stop();
}

/// Finds the stiffness from the impulses since they were noted, which acted for this time. Forces F
/// at arms r turn a body back with the torque sum F.r per radian.
void HingeTree::FindStiffness(double time)
{
    for (Link& link : m_links)
    {
        link.stiffness = 0.0;
    }
    for (Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            const double x = (link.total.x - link.noted.x) / time;
            const double y = (link.total.y - link.noted.y) / time;
            link.stiffness += link.lever.x * y - link.lever.y * x;
            if (link.parent != -1)
            {
                m_links[std::size_t(link.parent)].stiffness -=
                    link.aboveLever.x * y - link.aboveLever.y * x;
            }
        }
    }
}

/// Finds the stiffness from the impulses of the last step.
void HingeTree::TakeLastStiffness(double lastStep)
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
    FindStiffness(lastStep);
    for (Link& link : m_links)
    {
        link.lastStiffness = link.stiffness;
    }
}

/// Holds the stiffness of the last step but in a jerk.
void HingeTree::HoldStiffness()
{
    for (Link& link : m_links)
    {
        if (link.stiffness < kJerk * link.lastStiffness)
        {
            link.stiffness = link.lastStiffness;
        }
    }
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
