// SPDX-License-Identifier: MIT
#include "HingeTree.h"

#include "Access.h"
#include "Closing.h"
#include "Joints/JointFrame.h"

#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

bool IsMoved(const BodyData& body)
{
    return body.IsDynamic() && body.awakeIndex != -1;
}

/// A joint at one of its bodies.
struct JointEnd
{
    const BodyData* body;
    b2Joint* joint;
};

bool ByBody(const JointEnd& a, const JointEnd& b)
{
    return a.body->number < b.body->number;
}

constexpr int32 kMostDrifts = 128; ///< in a step
constexpr int32 kMostTries = 4;
constexpr float32 kTorn = 0.05f; ///< a hinge that is so far open [m]
constexpr double kStiffening = 0.01;
constexpr int32 kMostPoseCloses = 12;
/// How far a swing may turn in a drift, squared: by what the last step leaves to expect, and by
/// what came up in the step.
constexpr double kEstimated = 1.8;
constexpr double kFound = 2.8;
/// A body that turns is followed as closely as one that swings this much as fast.
constexpr double kTurns = 3.0;

/// Of what moves and of what the kicks give, within a step.
constexpr double kWonShare = 2e-3;

/// How far a hinge is to be closed at once: what is far open turns the bodies so that their levers
/// no longer say where it goes.
float32 Correction(float32 open, float32 before)
{
    return b2Clamp(open - Left(before), -b2_maxLinearCorrection, b2_maxLinearCorrection);
}

double KineticEnergy(const SolverBody& body, double mass, double turning)
{
    const double x = body.v.x;
    const double y = body.v.y;
    const double w = body.w;
    return 0.5 * (mass * (x * x + y * y) + turning * w * w);
}

int32 CountFor(double mostSquared, double squaredFrequency, float32 timeStep, int32 least)
{
    const double square = squaredFrequency * double(timeStep) * double(timeStep) / mostSquared;
    int32 count = least;
    while (double(count) * double(count) < square && count < kMostDrifts)
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

bool HingeTree::Build(const Array<b2Joint*>& joints)
{
    m_links.clear();
    Array<JointEnd> ends;
    for (b2Joint* joint : joints)
    {
        const BodyData& a = Data(*joint->GetBodyA());
        const BodyData& b = Data(*joint->GetBodyB());
        if (joint->GetType() != e_revoluteJoint || &a == &b)
        {
            return false;
        }
        ends.push_back({&a, joint});
        ends.push_back({&b, joint});
        if (!IsMoved(a) || !IsMoved(b))
        {
            if (!m_links.empty())
            {
                return false; // tied down twice
            }
            AddLink(*joint, IsMoved(a) ? b : a, -1);
        }
    }
    std::stable_sort(ends.begin(), ends.end(), ByBody);
    if (m_links.empty())
    {
        m_links.emplace_back().body = ends.front().body;
    }
    const std::size_t count = joints.size() + (m_links.front().joint == nullptr ? 1 : 0);
    for (std::size_t i = 0; i < m_links.size() && m_links.size() <= count; ++i)
    {
        const Link link = m_links[i];
        const auto [first, last] =
            std::equal_range(ends.begin(), ends.end(), JointEnd{link.body, nullptr}, ByBody);
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

/// Of the body that a joint holds to `above`.
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
        if (joint.IsMotorEnabled() || joint.IsLimitEnabled() || moved)
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

/// A body that hinges pull straight with forces F at arms r turns back and forth with the frequency
/// sqrt(sum F.r / I), and a leapfrog is thrown about by what it sees less than three times in a
/// swing. The count stays the same for all of a step: to change it throws about as well.
void HingeTree::Step(float32 timeStep, int32 smallSteps)
{
    for (Link& link : m_links)
    {
        link.start = *link.state;
    }
    int32 count =
        CountFor(kEstimated, LastStrain(double(timeStep)) / double(timeStep), timeStep, smallSteps);
    Outcome outcome = StepIn(count, timeStep, true);
    for (int32 tries = 0; tries < kMostTries; ++tries)
    {
        int32 needed = CountFor(kFound, outcome.squaredFrequency, timeStep, smallSteps);
        if (outcome.won)
        {
            needed = b2Max(needed, b2Min(2 * count, kMostDrifts));
        }
        if (needed <= count)
        {
            break;
        }
        count = b2Max(needed, CountFor(kEstimated, outcome.squaredFrequency, timeStep, smallSteps));
        GoBack();
        outcome = StepIn(count, timeStep, true);
    }
    if (outcome.won)
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
    LeaveImpulses();
}

void HingeTree::GoBack()
{
    for (Link& link : m_links)
    {
        *link.state = link.start;
    }
}

/// A leapfrog: half a kick, drifts and whole kicks in turn, half a kick. Without impulses the
/// hinges are closed in a way that can only lose energy.
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
            MoveByVelocity(*link.state, time, kMostSmallWay);
        }
        byImpulses ? Close(time) : ClosePoses(time);
        Kick(i < count ? time : 0.5f * time);
        const double given = double(i < count ? time : 0.75f * time);
        const double strain = Strain(given) / given;
        // An impact is not a swing: what counts came up in two drifts on end.
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
        const b2Vec2 way = now.d - link.start.d;
        const double work =
            link.mass * double(b2Dot(link.kick.acceleration, way)) +
            link.turning * double(link.kick.angularAcceleration * (now.angle - link.start.angle));
        const double before = KineticEnergy(link.start, link.mass, link.turning);
        energy.now += KineticEnergy(now, link.mass, link.turning);
        energy.due += before + work;
        energy.moved += before + std::abs(work);
    }
    return energy;
}

/// Slows all down alike, which leaves hinges at rest, and a free tree its momentum.
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

float32 HingeTree::WidestGap() const
{
    float32 widest = 0.0f;
    for (const Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            b2Vec2 arm, aboveArm;
            widest = b2Max(widest, Measure(link, arm, aboveArm).Length());
        }
    }
    return widest;
}

/// And stops the hinges.
void HingeTree::Kick(float32 time)
{
    Prepare();
    for (Link& link : m_links)
    {
        link.kick.Give(*link.state, time);
    }
    Stop();
}

/// The largest sum F.r / I, times the time in which the impulses since they were noted were given.
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

/// The same of the impulses that the last step left in the joints.
double HingeTree::LastStrain(double time)
{
    for (Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            (void)TakeLevers(link);
            const b2Vec2 impulse = link.direction * link.joint->GetReactionForce(1.0f);
            link.total = {double(impulse.x), double(impulse.y)};
            link.noted = Pair();
        }
    }
    return Strain(time);
}

/// The arms at the present poses, and how far the hinge is open.
b2Vec2 HingeTree::Measure(const Link& link, b2Vec2& arm, b2Vec2& aboveArm)
{
    const SolverBody& body = *link.state;
    const SolverBody& above = *link.aboveState;
    arm = b2Mul(body.q, link.arm);
    aboveArm = b2Mul(above.q, link.aboveArm);
    return link.offset + body.d - above.d + arm - aboveArm;
}

void HingeTree::Prepare()
{
    for (Link& link : m_links)
    {
        if (link.joint != nullptr)
        {
            link.open = TakeLevers(link);
        }
    }
    Factor();
}

b2Vec2 HingeTree::TakeLevers(Link& link)
{
    b2Vec2 arm, aboveArm;
    const b2Vec2 open = Measure(link, arm, aboveArm);
    link.lever = {double(arm.y), -double(arm.x)};
    link.aboveLever = {double(aboveArm.y), -double(aboveArm.x)};
    return open;
}

/// From the tips to the root.
void HingeTree::Factor()
{
    for (Link& link : m_links)
    {
        link.inertia = {link.mass, 0.0, link.mass, 0.0, 0.0, link.turning};
        link.load = link.mass;
    }
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        Link& link = m_links[i];
        if (m_stiffened)
        {
            const double square = link.lever.x * link.lever.x + link.lever.y * link.lever.y;
            link.inertia.turning += kStiffening * link.load * square;
            if (link.parent != -1)
            {
                m_links[std::size_t(link.parent)].load += link.load;
            }
        }
        FactorAtHinge(link);
        if (link.parent != -1)
        {
            AddInertia(link, m_links[std::size_t(link.parent)].inertia);
        }
    }
}

/// The inertia at the hinge: with v = u + w t,
///   K = M - a a^T / c,   a = M t + (x, y),   c = t.M t + 2 t.(x, y) + turning,
/// for the body turns so that the energy is least, by w = -a.u / c. A root without a hinge is
/// factored about its centre of mass in the same way, t = 0.
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

/// To what the link hangs from, about whose centre of mass K has the lever t.
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

/// From the tips to the root, what the hinges want and give: an impulse f at a hinge and what is
/// given from below, impulse g and moment z, make
///   K u = f + g - a (z + t.g) / c.
template <class Want>
void HingeTree::Gather(Want&& want)
{
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        Link& link = m_links[i];
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
    const double x = link.k11 * link.lack.x + link.k12 * link.lack.y - link.given.x;
    const double y = link.k12 * link.lack.x + link.k22 * link.lack.y - link.given.y;
    parent.given.x -= x;
    parent.given.y -= y;
    parent.givenTurn += link.aboveLever.x * x + link.aboveLever.y * y;
}

/// And back, the changes of velocity.
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
    Pair u = link.lack;
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
    Gather([](Link& link) {
        const SolverBody& a = *link.aboveState;
        const SolverBody& b = *link.state;
        link.lack.x = double(a.v.x) - double(a.w) * link.aboveLever.x - double(b.v.x) +
                      double(b.w) * link.lever.x;
        link.lack.y = double(a.v.y) - double(a.w) * link.aboveLever.y - double(b.v.y) +
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
    body.q = b2Mul(body.q, b2Rot(turn));
}

/// The change of speed that closes the hinge in the time. Returns how far it is open.
float32 HingeTree::WantClosed(Link& link, float32 timeStep)
{
    b2Vec2 arm, aboveArm;
    const b2Vec2 open = Measure(link, arm, aboveArm);
    const float32 x = Correction(open.x, link.open.x);
    const float32 y = Correction(open.y, link.open.y);
    const double perTime = 1.0 / double(timeStep);
    link.lack = {-double(x) * perTime, -double(y) * perTime};
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

/// False when that has opened them further: turned far in the drift, the bodies' levers of before
/// it point elsewhere.
bool HingeTree::CloseByImpulses(float32 timeStep)
{
    float32 first = 0.0f;
    for (int32 i = 0; i < kMostCloses; ++i)
    {
        float32 widest = 0.0f;
        Gather([&](Link& link) { widest = b2Max(widest, WantClosed(link, timeStep)); });
        if (i > 0 && widest > first)
        {
            ForgetGiven();
            return false;
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

/// By the levers of each pose, without a change of velocity: one that does not really close the
/// hinges would throw them about for long.
void HingeTree::ClosePoses(float32 timeStep)
{
    for (int32 i = 0; i < kMostPoseCloses; ++i)
    {
        for (Link& link : m_links)
        {
            if (link.joint != nullptr)
            {
                (void)TakeLevers(link);
            }
        }
        Factor();
        float32 widest = 0.0f;
        Gather([&](Link& link) { widest = b2Max(widest, WantClosed(link, timeStep)); });
        Spread([&](Link& link) { AddPose(link, timeStep); });
        if (widest < kNearlyClosed)
        {
            break;
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
