// SPDX-License-Identifier: MIT
#include "DebugDraw.h"

#include "../Joints/JointKinds.h"
#include "../State/World.h"
#include "SeenShapes.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Common/b2Draw.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/Joints/b2PulleyJoint.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <algorithm>

/// Draws the world by calls of a b2Draw: shapes, joints, boxes, pairs and centres of mass. Shapes
/// have the colour of their body's state, joints are lines between anchors. Oldest body first, so
/// that newer ones are on top. With a view, the trees return the visible shapes; all other items
/// are tested by position.
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

void DrawChild(b2Draw& draw, const b2Shape& shape, int32 child, const b2Transform& xf,
               const b2Color& color)
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
        b2Vec2 vertices[b2_polygonCapacity];
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
        b2EdgeShape edge;
        static_cast<const b2ChainShape&>(shape).GetChildEdge(&edge, child);
        draw.DrawSegment(b2Mul(xf, edge.m_vertex1), b2Mul(xf, edge.m_vertex2), color);
        break;
    }
    }
}

void DrawChild(b2Draw& draw, const b2Fixture& fixture, int32 child)
{
    const b2Body& body = *fixture.GetBody();
    DrawChild(draw, *fixture.GetShape(), child, body.GetTransform(), ColorOf(Data(body)));
}

void DrawBox(b2Draw& draw, const b2Fixture& fixture, int32 child)
{
    if (fixture.GetBody()->IsActive())
    {
        const b2AABB& box = fixture.GetAABB(child);
        const b2Vec2 corners[4] = {box.lowerBound, b2Vec2(box.upperBound.x, box.lowerBound.y),
                                   box.upperBound, b2Vec2(box.lowerBound.x, box.upperBound.y)};
        draw.DrawPolygon(corners, 4, kBox);
    }
}

/// One drawing of a world.
class Drawing
{
public:
    Drawing(const World& world, b2Draw& draw) : m_world(world), m_draw(draw)
    {
        m_view.lowerBound = draw.GetViewLower();
        m_view.upperBound = draw.GetViewUpper();
        if (!draw.HasView())
        {
            ListBodies();
        }
        else if (draw.GetFlags() & (b2Draw::e_shapeBit | b2Draw::e_aabbBit))
        {
            m_seen = FindSeen(world, m_view);
        }
    }

    void DrawShapes()
    {
        ForEachChild([this](const b2Fixture& f, int32 child) { DrawChild(m_draw, f, child); });
    }
    void DrawBoxes()
    {
        ForEachChild([this](const b2Fixture& f, int32 child) { DrawBox(m_draw, f, child); });
    }
    void DrawJoints();
    void DrawPairs();
    void DrawCenters();

private:
    void ListBodies();
    template <class Function>
    void ForEachChild(Function&& function);
    template <class Function>
    void ForEachSeen(Function&& function);
    template <class Function>
    void ForEachOfAll(Function&& function);
    bool IsSeen(const b2Vec2& a, const b2Vec2& b) const;
    void DrawJoint(const b2Joint& joint);
    void DrawLine(const b2Vec2& a, const b2Vec2& b, const b2Color& color);

    const World& m_world;
    b2Draw& m_draw;
    b2AABB m_view;                 // if there is one
    Array<const b2Body*> m_bodies; // oldest first; for centres and without a view only
    Array<SeenChild> m_seen;       // with a view only
};

void Drawing::ListBodies()
{
    for (const b2Body* b = m_world.bodyList; b; b = b->GetNext())
    {
        if (IsSeen(b->GetWorldCenter(), b->GetWorldCenter()))
        {
            m_bodies.push_back(b);
        }
    }
    std::reverse(m_bodies.begin(), m_bodies.end());
}

/// The box around two points.
bool Drawing::IsSeen(const b2Vec2& a, const b2Vec2& b) const
{
    b2AABB box;
    box.lowerBound = b2Min(a, b);
    box.upperBound = b2Max(a, b);
    return !m_draw.HasView() || b2TestOverlap(box, m_view);
}

template <class Function>
void Drawing::ForEachChild(Function&& function)
{
    m_draw.HasView() ? ForEachSeen(function) : ForEachOfAll(function);
    m_draw.BeginBody(-1);
}

template <class Function>
void Drawing::ForEachSeen(Function&& function)
{
    int32 last = -1;
    for (const SeenChild& seen : m_seen)
    {
        if (seen.body != last)
        {
            m_draw.BeginBody(seen.body);
            last = seen.body;
        }
        function(*seen.fixture, seen.child);
    }
}

template <class Function>
void Drawing::ForEachOfAll(Function&& function)
{
    for (const b2Body* body : m_bodies)
    {
        m_draw.BeginBody(Data(*body).number);
        for (const b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
        {
            for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
            {
                function(*f, child);
            }
        }
    }
}

void Drawing::DrawLine(const b2Vec2& a, const b2Vec2& b, const b2Color& color)
{
    if (IsSeen(a, b))
    {
        m_draw.DrawSegment(a, b, color);
    }
}

void Drawing::DrawJoint(const b2Joint& joint)
{
    const b2Vec2 anchorA = joint.GetAnchorA();
    const b2Vec2 anchorB = joint.GetAnchorB();
    const JointLines lines = LinesOf(joint);
    if (lines == JointLines::kOverPulley)
    {
        const auto& pulley = static_cast<const b2PulleyJoint&>(joint);
        DrawLine(anchorA, pulley.GetGroundAnchorA(), kJoint);
        DrawLine(pulley.GetGroundAnchorA(), pulley.GetGroundAnchorB(), kJoint);
        DrawLine(pulley.GetGroundAnchorB(), anchorB, kJoint);
        return;
    }
    if (lines == JointLines::kToOrigins)
    {
        DrawLine(joint.GetBodyA()->GetPosition(), anchorA, kJoint);
    }
    DrawLine(anchorA, anchorB, kJoint);
    if (lines == JointLines::kToOrigins)
    {
        DrawLine(joint.GetBodyB()->GetPosition(), anchorB, kJoint);
    }
}

void Drawing::DrawJoints()
{
    Array<const b2Joint*> joints;
    for (const b2Joint* j = m_world.jointList; j; j = j->GetNext())
    {
        joints.push_back(j);
    }
    std::for_each(joints.rbegin(), joints.rend(), [this](const b2Joint* j) { DrawJoint(*j); });
}

void Drawing::DrawPairs()
{
    for (const b2Contact* c = m_world.contactList; c; c = c->GetNext())
    {
        DrawLine(c->GetFixtureA()->GetAABB(c->GetChildIndexA()).GetCenter(),
                 c->GetFixtureB()->GetAABB(c->GetChildIndexB()).GetCenter(), kPair);
    }
}

void Drawing::DrawCenters()
{
    if (m_draw.HasView())
    {
        ListBodies();
    }
    for (const b2Body* body : m_bodies)
    {
        m_draw.BeginBody(Data(*body).number);
        m_draw.DrawTransform(b2Transform(body->GetWorldCenter(), body->GetTransform().q));
    }
    m_draw.BeginBody(-1);
}

} // namespace

void Draw(const World& world, b2Draw& draw)
{
    constexpr struct
    {
        uint32 flag;
        void (Drawing::*draw)();
    } layers[] = {{b2Draw::e_shapeBit, &Drawing::DrawShapes},
                  {b2Draw::e_jointBit, &Drawing::DrawJoints},
                  {b2Draw::e_pairBit, &Drawing::DrawPairs},
                  {b2Draw::e_aabbBit, &Drawing::DrawBoxes},
                  {b2Draw::e_centerOfMassBit, &Drawing::DrawCenters}};
    const Lock lock(world);
    Drawing drawing(world, draw);
    for (const auto& layer : layers)
    {
        if (draw.GetFlags() & layer.flag)
        {
            draw.BeginLayer(layer.flag);
            (drawing.*layer.draw)();
        }
    }
}

} // namespace box2d
