// SPDX-License-Identifier: MIT
#include "Containment.h"

#include "../Contacts/Boxes.h"
#include "../Contacts/Sweeps.h"
#include "../Energy/EnergyGuard.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "../SubSteps/SubStepMemory.h"
#include "ImpactJoints.h"
#include "ImpactMemory.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <utility>

namespace box2d
{

namespace
{

/// Rounds over the contacts of a body that is moved back. Few need more than two; between walls
/// that are nearer to each other than the body is wide there is no end. No test fails with 2 or 64.
constexpr int32 kMaxRounds = 8;

/// A body goes back to the place of a crossing if that is at most this far, as a fraction of its
/// extent. Farther, it is moved back only along the normal of a static wall. With 0.25 a shape of
/// random world 279 is 1.07 m out (8 sub-steps), with 1 world 414 loses a body (one step, 12 s).
constexpr float32 kMaxBack = 0.5f;

/// Returns the centre in the body's frame. Edges and chains have no inside and use the centre of
/// mass.
b2Vec2 CentreOf(const b2Shape& shape, const BodyData& body)
{
    if (shape.GetType() == b2Shape::e_circle)
    {
        return static_cast<const b2CircleShape&>(shape).m_p;
    }
    if (shape.GetType() == b2Shape::e_polygon)
    {
        return static_cast<const b2PolygonShape&>(shape).m_centroid;
    }
    return body.localCenter;
}

/// Returns a point of the body at that pose, `offset` from its centre of mass, relative to another
/// body's centre.
b2Vec2 PointAt(const Pose& pose, const b2Vec2& offset, const Pose& origin)
{
    const b2Vec2 centre(float32(pose.x - origin.x), float32(pose.y - origin.y));
    return offset == b2Vec2_zero ? centre : centre + b2Mul(b2Rot(float32(pose.angle)), offset);
}

/// True if the path crosses a child of the wall that stops it. Unlike for rays of the program, the
/// side matters for chains too.
bool Stops(const b2Shape& wall, int32 child, const b2RayCastInput& path, b2RayCastOutput& hit)
{
    b2Transform here;
    here.SetIdentity();
    if (wall.GetType() != b2Shape::e_chain)
    {
        return wall.RayCast(&hit, path, here, child);
    }
    b2EdgeShape edge;
    static_cast<const b2ChainShape&>(wall).GetChildEdge(&edge, child);
    return edge.RayCast(&hit, path, here, 0);
}

/// True if a contact may have to hold a body.
bool IsConcerned(const ContactData& c)
{
    const bool letThrough =
        c.IsTouching() && !c.IsEnabled(); // listeners see touching contacts only
    return (c.flags & kContactObstacle) != 0 && !letThrough && !c.IsSensor();
}

} // namespace

Containment::Containment(World& world)
    : m_world(world), m_starts(world.impacts->starts), m_turns(world.impacts->turns)
{
    m_starts.clear();
    m_turns.clear();
}

void Containment::NoteStarts()
{
    for (const b2Body* body : m_world.awakeBodies)
    {
        m_starts.push_back(ImpactStart{&Data(*body), Data(*body).previous});
    }
}

void Containment::NoteTurn(const BodyData& body)
{
    ImpactStart* start = NotedStart(body);
    if (body.IsDynamic() && start != nullptr)
    {
        m_turns.push_back(ImpactTurn{body.previous, body.sweepStart, start->lastTurn});
        start->lastTurn = int32(m_turns.size()) - 1;
    }
}

bool Containment::Hold(ImpactJoints& joints)
{
    bool any = false;
    for (std::size_t i = 0; i < m_world.awakeContacts.size(); ++i)
    {
        if (m_world.awakeObstacles[i] != 0)
        {
            const ContactData& c = Data(*m_world.awakeContacts[i]);
            any = (IsConcerned(c) && Hold(c, joints)) || any;
        }
    }
    return any;
}

/// Null for bodies that have woken since.
ImpactStart* Containment::NotedStart(const BodyData& body) const
{
    const auto index = std::size_t(body.awakeIndex); // out of range for bodies that are not awake
    return index < m_starts.size() && m_starts[index].body == &body ? &m_starts[index] : nullptr;
}

const Pose& Containment::StartOf(const BodyData& body) const
{
    const ImpactStart* start = NotedStart(body);
    return start != nullptr ? start->pose : body.previous;
}

/// True if the centre of the moving part enters or passes through the static one between two times.
bool Containment::Crosses(const Part& moved, const Part& still, const Moment& from,
                          const Moment& to, Crossing& crossing)
{
    const BodyData& body = Data(*moved.body);
    const BodyData& wall = Data(*still.body);
    const auto rotationAt = [&wall](const Pose& pose) {
        return pose.angle == wall.pose.angle ? wall.rotation : b2Rot(float32(pose.angle));
    };
    const b2Vec2 offset = CentreOf(*moved.shape, body) - body.localCenter;
    b2RayCastInput path; // in the wall's moving frame
    path.p1 =
        b2MulT(rotationAt(from.still), PointAt(from.moved, offset, from.still)) + wall.localCenter;
    path.p2 = b2MulT(rotationAt(to.still), PointAt(to.moved, offset, to.still)) + wall.localCenter;
    path.maxFraction = 1.0f;
    b2RayCastOutput hit;
    if (!Stops(*still.shape, still.child, path, hit))
    {
        return false;
    }
    crossing.place = path.p1 + hit.fraction * (path.p2 - path.p1) + b2_linearSlop * hit.normal -
                     wall.localCenter;
    crossing.normal = hit.normal;
    return true;
}

/// Finds the first crossing of the step.
bool Containment::FindCrossing(const Part& moved, const Part& still, Crossing& crossing) const
{
    const BodyData& body = Data(*moved.body);
    const BodyData& wall = Data(*still.body);
    const ImpactStart* start = NotedStart(body);
    int32 turn = start != nullptr ? start->lastTurn : -1;
    Moment to{body.pose, wall.pose};
    bool any = false;
    for (; turn != -1; turn = m_turns[std::size_t(turn)].before)
    {
        const ImpactTurn& last = m_turns[std::size_t(turn)];
        const Moment from{last.pose, PoseAt(wall, last.time)};
        if (Crosses(moved, still, from, to, crossing))
        {
            crossing.turn = turn;
            any = true;
        }
        to = from;
    }
    if (Crosses(moved, still, {StartOf(body), StartOf(wall)}, to, crossing))
    {
        crossing.turn = -1;
        any = true;
    }
    return any;
}

/// The same for all walls around a body that is moved back. Moving back one of its shapes may move
/// a shape beyond a wall that was checked before.
bool Containment::Hold(const ContactData& c, ImpactJoints& joints)
{
    if (!HoldOne(c, joints))
    {
        return false;
    }
    const b2Body& body = Data(*c.bodyB).IsDynamic() ? *c.bodyB : *c.bodyA;
    bool any = true;
    for (int32 round = 0; any && round < kMaxRounds; ++round)
    {
        any = false;
        for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next)
        {
            const ContactData& other = Data(*edge->contact);
            any = (IsConcerned(other) && HoldOne(other, joints)) || any;
        }
    }
    return true;
}

bool Containment::HoldOne(const ContactData& c, ImpactJoints& joints)
{
    Part moved{c.bodyB, c.FixtureB()->GetShape(), c.ChildB()};
    Part still{c.bodyA, c.FixtureA()->GetShape(), c.ChildA()};
    if (!Data(*moved.body).IsDynamic())
    {
        std::swap(moved, still);
    }
    BodyData& body = Data(*moved.body);
    const BodyData& wall = Data(*still.body);
    Crossing crossing;
    if (!body.IsDynamic() || !FindCrossing(moved, still, crossing))
    {
        return false;
    }
    if (ImpactStart* start = NotedStart(body))
    {
        start->lastTurn = crossing.turn; // its path ends here
    }
    joints.NoteStarts();
    joints.NoteStopped(body);
    const b2Vec2 offset = CentreOf(*moved.shape, body) - body.localCenter;
    const b2Vec2 end = PointAt(body.pose, offset, wall.pose);
    const b2Vec2 held = b2Mul(wall.rotation, crossing.place);
    const b2Vec2 normal = b2Mul(wall.rotation, crossing.normal);
    // Back to the place of the crossing it could be so far that others of its shapes come through
    // another wall. Then it stays where it is along a wall that stands still.
    const float32 depth = b2Dot(held - end, normal);
    const bool far =
        b2Distance(held, end) > kMaxBack * body.maxExtent && wall.mobility == Mobility::Static;
    const b2Vec2 shift = far && depth > 0.0f ? depth * normal : held - end;
    body.pose.x += double(shift.x);
    body.pose.y += double(shift.y);
    const b2Vec2 arm = end + shift;
    const b2Vec2 wallSpeed = wall.linearVelocity + b2Cross(wall.angularVelocity, arm);
    const float32 speed = b2Dot(body.linearVelocity - wallSpeed, normal);
    body.linearVelocity -= b2Min(speed, 0.0f) * normal;
    SynchronizePose(body);
    UpdateProxies(m_world.proxies, body, true);
    return true;
}

} // namespace box2d
