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

bool HingeTree::Begin(const SolverContext& context)
{
    for (Link& link : m_links)
    {
        const BodyData& body = *link.body;
        if (body.invMass <= 0.0f || body.invInertia <= 0.0f)
        {
            return false;
        }
        link.state = &context.bodies[body.SolverIndex()];
        link.mass = 1.0 / double(body.invMass);
        link.turning = 1.0 / double(body.invInertia);
        link.total = Pair();
        if (link.joint == nullptr)
        {
            continue;
        }
        const b2RevoluteJoint& joint = *link.joint;
        if (joint.IsMotorEnabled() || joint.IsLimitEnabled())
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

double HingeTree::SquaredFrequency()
{
    for (Link& link : m_links)
    {
        link.givenTurn = 0.0;
    }
    double highest = 0.0;
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        // A force F at an arm r turns the body back by F.r for each radian.
        Link& link = m_links[i];
        if (link.joint != nullptr)
        {
            const b2Vec2 pull = link.direction * link.joint->GetReactionForce(1.0f);
            link.givenTurn += double(b2Dot(pull, link.arm));
            if (link.parent != -1)
            {
                m_links[std::size_t(link.parent)].givenTurn -= double(b2Dot(pull, link.aboveArm));
            }
        }
        highest = std::max(highest, link.givenTurn / link.turning);
        link.givenTurn = 0.0;
    }
    return highest;
}

void HingeTree::NotePoses()
{
    for (Link& link : m_links)
    {
        link.noted = *link.state;
    }
}

void HingeTree::BackToNotedPoses()
{
    for (Link& link : m_links)
    {
        link.state->d = link.noted.d;
        link.state->q = link.noted.q;
        link.state->angle = link.noted.angle;
    }
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
    }
    for (std::size_t i = m_links.size(); i-- > 0;)
    {
        Link& link = m_links[i];
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
        take(link);
    }
    ForgetGiven();
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
    const float32 x = open.x - Left(link.open.x);
    const float32 y = open.y - Left(link.open.y);
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
    for (int32 i = 0; i < kMostCloses; ++i)
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

void HingeTree::End()
{
    for (Link& link : m_links)
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
