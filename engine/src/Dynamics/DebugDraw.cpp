// SPDX-License-Identifier: MIT
#include "Access.h"
#include "World.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Common/b2Draw.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <algorithm>

/// The world as calls of a b2Draw: shapes in the colour of their body's state, joints as lines
/// between anchors, boxes, pairs, centres of mass. Oldest body first, so that what came later lies
/// on top.
namespace box2d
{

namespace
{

const b2Color kInactive(0.5f, 0.5f, 0.3f);
const b2Color kStatic(0.5f, 0.9f, 0.5f);
const b2Color kKinematic(0.5f, 0.5f, 0.9f);
const b2Color kAsleep(0.6f, 0.6f, 0.6f);
const b2Color kAwake(0.9f, 0.7f, 0.7f);
const b2Color kJoint(0.5f, 0.8f, 0.8f);
const b2Color kPair(0.3f, 0.9f, 0.9f);
const b2Color kBox(0.9f, 0.3f, 0.9f);

const b2Color& ColorOf(const BodyData& body)
{
    if (!body.IsActive())
    {
        return kInactive;
    }
    if (body.mobility == Mobility::Static)
    {
        return kStatic;
    }
    if (body.mobility == Mobility::Kinematic)
    {
        return kKinematic;
    }
    return body.IsAwake() ? kAwake : kAsleep;
}

void DrawShape(b2Draw& draw, const b2Shape& shape, const b2Transform& xf, const b2Color& color)
{
    switch (shape.GetType())
    {
    case b2Shape::e_circle: {
        const auto& circle = static_cast<const b2CircleShape&>(shape);
        draw.DrawSolidCircle(b2Mul(xf, circle.m_p), circle.m_radius, xf.q.GetXAxis(), color);
        break;
    }
    case b2Shape::e_polygon: {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        b2Vec2 vertices[b2_maxPolygonVertices];
        for (int32 i = 0; i < polygon.GetVertexCount(); ++i)
        {
            vertices[i] = b2Mul(xf, polygon.GetVertex(i));
        }
        draw.DrawSolidPolygon(vertices, polygon.GetVertexCount(), color);
        break;
    }
    case b2Shape::e_edge: {
        const auto& edge = static_cast<const b2EdgeShape&>(shape);
        draw.DrawSegment(b2Mul(xf, edge.m_vertex1), b2Mul(xf, edge.m_vertex2), color);
        break;
    }
    default: {
        const auto& chain = static_cast<const b2ChainShape&>(shape);
        for (int32 child = 0; child < chain.GetChildCount(); ++child)
        {
            b2EdgeShape edge;
            chain.GetChildEdge(&edge, child);
            draw.DrawSegment(b2Mul(xf, edge.m_vertex1), b2Mul(xf, edge.m_vertex2), color);
        }
        break;
    }
    }
}

// The two anchors, each with a line from its body's origin.
void DrawJoint(b2Draw& draw, const b2Joint& joint)
{
    const b2Vec2 anchorA = joint.GetAnchorA();
    const b2Vec2 anchorB = joint.GetAnchorB();
    if (joint.GetType() == e_distanceJoint)
    {
        draw.DrawSegment(anchorA, anchorB, kJoint);
        return;
    }
    draw.DrawSegment(joint.GetBodyA()->GetPosition(), anchorA, kJoint);
    draw.DrawSegment(anchorA, anchorB, kJoint);
    draw.DrawSegment(joint.GetBodyB()->GetPosition(), anchorB, kJoint);
}

void DrawBoxes(b2Draw& draw, const b2Body& body)
{
    for (const b2Fixture* f = body.GetFixtureList(); f && body.IsActive(); f = f->GetNext())
    {
        for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
        {
            const b2AABB& box = f->GetAABB(child);
            const b2Vec2 corners[4] = {box.lowerBound, b2Vec2(box.upperBound.x, box.lowerBound.y),
                                       box.upperBound, b2Vec2(box.lowerBound.x, box.upperBound.y)};
            draw.DrawPolygon(corners, 4, kBox);
        }
    }
}

template <class Function>
void ForEachBody(b2Draw& draw, const Array<const b2Body*>& bodies, Function&& function)
{
    for (const b2Body* body : bodies)
    {
        draw.BeginBody(Data(*body).number);
        function(*body);
    }
    draw.BeginBody(-1);
}

} // namespace

void World::Draw(b2Draw& draw) const
{
    const Lock lock(*this);
    const uint32 flags = draw.GetFlags();
    Array<const b2Body*> bodies; // oldest first
    for (const b2Body* b = bodyList; b; b = b->GetNext())
    {
        bodies.push_back(b);
    }
    std::reverse(bodies.begin(), bodies.end());

    if (flags & b2Draw::e_shapeBit)
    {
        draw.BeginLayer(b2Draw::e_shapeBit);
        ForEachBody(draw, bodies, [&](const b2Body& body) {
            for (const b2Fixture* f = body.GetFixtureList(); f; f = f->GetNext())
            {
                DrawShape(draw, *f->GetShape(), body.GetTransform(), ColorOf(Data(body)));
            }
        });
    }
    if (flags & b2Draw::e_jointBit)
    {
        draw.BeginLayer(b2Draw::e_jointBit);
        Array<const b2Joint*> joints;
        for (const b2Joint* j = jointList; j; j = j->GetNext())
        {
            joints.push_back(j);
        }
        std::for_each(joints.rbegin(), joints.rend(),
                      [&](const b2Joint* j) { DrawJoint(draw, *j); });
    }
    if (flags & b2Draw::e_pairBit)
    {
        draw.BeginLayer(b2Draw::e_pairBit);
        for (const b2Contact* c = contactList; c; c = c->GetNext())
        {
            draw.DrawSegment(c->GetFixtureA()->GetAABB(c->GetChildIndexA()).GetCenter(),
                             c->GetFixtureB()->GetAABB(c->GetChildIndexB()).GetCenter(), kPair);
        }
    }
    if (flags & b2Draw::e_aabbBit)
    {
        draw.BeginLayer(b2Draw::e_aabbBit);
        ForEachBody(draw, bodies, [&](const b2Body& body) { DrawBoxes(draw, body); });
    }
    if (flags & b2Draw::e_centerOfMassBit)
    {
        draw.BeginLayer(b2Draw::e_centerOfMassBit);
        ForEachBody(draw, bodies, [&](const b2Body& body) {
            draw.DrawTransform(b2Transform(body.GetWorldCenter(), body.GetTransform().q));
        });
    }
}

} // namespace box2d
