// SPDX-License-Identifier: MIT
#include "Containment.h"

#include "Access.h"
#include "ImpactJoints.h"
#include "SolverArrays.h"
#include "World.h"

#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <utility>

namespace box2d
{

namespace
{

/// In the body's frame. Edges and chains have no inside: they go with the centre of mass.
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

/// Where the body at that pose has a point that is `offset` from its centre of mass, seen from
/// another body's centre.
b2Vec2 PointAt(const Pose& pose, const b2Vec2& offset, const Pose& origin)
{
    const b2Vec2 centre(float32(pose.x - origin.x), float32(pose.y - origin.y));
    return offset == b2Vec2_zero ? centre : centre + b2Mul(b2Rot(float32(pose.angle)), offset);
}

} // namespace

Containment::Containment(World& world) : m_world(world), m_starts(world.solver->impactStarts)
{
    m_starts.clear();
}

void Containment::NoteStarts()
{
    for (const b2Body* body : m_world.awakeBodies)
    {
        m_starts.push_back(ImpactStart{&Data(*body), Data(*body).previous});
    }
}

bool Containment::Hold(ImpactJoints& joints)
{
    bool any = false;
    for (b2Contact* contact : m_world.awakeContacts)
    {
        const ContactData& c = Data(*contact);
        // Only of what touches has a listener been asked.
        const bool letThrough = c.IsTouching() && !c.IsEnabled();
        if ((c.flags & kContactObstacle) != 0 && !letThrough && !c.IsSensor())
        {
            any = Hold(c, joints) || any;
        }
    }
    return any;
}

const Pose& Containment::StartOf(const BodyData& body) const
{
    const auto index = std::size_t(body.awakeIndex); // of what is not awake, beyond all
    return index < m_starts.size() && m_starts[index].body == &body ? m_starts[index].pose
                                                                    : body.previous;
}

bool Containment::Hold(const ContactData& c, ImpactJoints& joints)
{
    std::pair<b2Body*, const b2Shape*> moved(c.bodyB, c.fixtureB->GetShape());
    std::pair<b2Body*, const b2Shape*> still(c.bodyA, c.fixtureA->GetShape());
    int32 child = c.childA;
    if (!Data(*moved.first).IsDynamic())
    {
        std::swap(moved, still);
        child = c.childB;
    }
    BodyData& body = Data(*moved.first);
    const BodyData& wall = Data(*still.first);
    if (!body.IsDynamic())
    {
        return false;
    }
    const b2Vec2 offset = CentreOf(*moved.second, body) - body.localCenter;
    const Pose& wallStart = StartOf(wall);
    const b2Rot turned =
        wallStart.angle == wall.pose.angle ? wall.rotation : b2Rot(float32(wallStart.angle));
    const b2Vec2 end = PointAt(body.pose, offset, wall.pose);
    b2RayCastInput way; // in the wall's frame, which moves with it
    way.p1 = b2MulT(turned, PointAt(StartOf(body), offset, wallStart)) + wall.localCenter;
    way.p2 = b2MulT(wall.rotation, end) + wall.localCenter;
    way.maxFraction = 1.0f;
    b2Transform here;
    here.SetIdentity();
    b2RayCastOutput hit;
    if (!still.second->RayCast(&hit, way, here, child))
    {
        return false;
    }
    const b2Vec2 held =
        way.p1 + hit.fraction * (way.p2 - way.p1) + b2_linearSlop * hit.normal - wall.localCenter;
    joints.NoteStarts();
    joints.NoteStopped(body);
    const b2Vec2 shift = b2Mul(wall.rotation, held) - end;
    const b2Vec2 normal = b2Mul(wall.rotation, hit.normal);
    body.pose.x += double(shift.x);
    body.pose.y += double(shift.y);
    const b2Vec2 arm = end + shift;
    const b2Vec2 wallSpeed = wall.linearVelocity + b2Cross(wall.angularVelocity, arm);
    const float32 speed = b2Dot(body.linearVelocity - wallSpeed, normal);
    body.linearVelocity -= b2Min(speed, 0.0f) * normal;
    SynchronizePose(body);
    m_world.UpdateProxies(body, true);
    return true;
}

} // namespace box2d
