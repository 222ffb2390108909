// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

// The joint of two frictionless edges on level ground.
const b2Vec2 kJoint(0.0f, 0.0f);

/// A box that slides along them at 1 m/s.
b2Body* AddSlider(b2World& world, float32 x)
{
    const b2PolygonShape shape = Box(0.5f, 0.5f);
    b2Body* const body = AddBody(world, b2_dynamicBody, b2Vec2(x, 0.515f));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    body->CreateFixture(&fixture);
    body->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    return body;
}

void AddSmoothEdge(b2World& world, const b2EdgeShape& edge)
{
    AddGround(world, edge)->GetFixtureList()->SetFriction(0.0f);
}

/// The contact that pushes along the ground, if there is one.
const b2Contact* FindGhost(const b2World& world)
{
    for (const b2Contact* contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext())
    {
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        if (contact->GetManifold()->pointCount > 0 && b2Abs(manifold.normal.x) > 0.5f)
        {
            return contact;
        }
    }
    return nullptr;
}

/// Returns the skin of an edge that goes to the right from here, beyond the area of any detail.
std::vector<b2Vec2> SkinOfEdge(const b2Vec2& from)
{
    constexpr int kStretches = 16;
    const b2Vec2 to = from + b2Vec2(1.0f, 0.0f);
    std::vector<b2Vec2> skin;
    for (int i = 0; i <= kStretches; ++i)
    {
        const b2Rot turn(0.5f * b2_pi + b2_pi * float32(i) / kStretches);
        skin.push_back(from + b2_polygonRadius * turn.GetXAxis());
    }
    skin.push_back(to - b2Vec2(0.0f, b2_polygonRadius));
    skin.push_back(to + b2Vec2(0.0f, b2_polygonRadius));
    return skin;
}

void DrawWithSkins(Sketch& detail, b2World& world, const b2Body& box)
{
    detail.Draw(world);
    const auto& shape = static_cast<const b2PolygonShape&>(*box.GetFixtureList()->GetShape());
    detail.Outline(SkinOf(shape, box.GetTransform()), kHelp);
    detail.Outline(SkinOfEdge(kJoint), kHelp);
}

void AddVertex(Sketch& sketch, const b2Vec2& at, std::string_view name, bool isGhost = false)
{
    if (isGhost)
    {
        sketch.Ring(at, 4.0);
    }
    else
    {
        sketch.Dot(at);
    }
    sketch.Label(at, Side::Below, name, kInk, 9.0);
}

} // namespace

Figure DrawGhostCollision()
{
    Sketch sketch(640, 250, b2Vec2(-0.3f, 0.65f), 100.0);
    Sketch detail(206, 116, b2Vec2(-0.004f, 0.004f), 2600.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    AddSmoothEdge(world, Edge(b2Vec2(-5.0f, 0.0f), b2Vec2(0.0f, 0.0f)));
    AddSmoothEdge(world, Edge(b2Vec2(0.0f, 0.0f), b2Vec2(4.0f, 0.0f)));
    b2Body* const box = AddSlider(world, -3.0f);
    const b2Contact* ghost = nullptr;
    for (int step = 0; step < 300 && ghost == nullptr; ++step)
    {
        if (step == 10 || step == 80)
        {
            sketch.DrawFaint(world, step == 10 ? 0.4 : 0.6);
        }
        detail.List().Clear();
        DrawWithSkins(detail, world, *box);
        Run(world);
        ghost = FindGhost(world);
    }
    sketch.Draw(world);
    if (ghost == nullptr) // this engine has learned to do without: the text needs another world
    {
        sketch.Caption(320.0, 20.0, Side::Below, "no ghost collision", kBad);
        return sketch.Finished();
    }
    b2WorldManifold manifold;
    ghost->GetWorldManifold(&manifold);
    // The box is the contact's second body, or the normal points the other way.
    const b2Vec2 push = ghost->GetFixtureB()->GetBody() == box ? manifold.normal : -manifold.normal;
    detail.ArrowAlong(kJoint, push, 60.0, kBad);
    detail.Label(detail.Shifted(kJoint, 64.0 * push.x, 64.0 * push.y), Side::Below, "normal", kBad);
    detail.Dot(kJoint);
    sketch.Ring(kJoint, 12.0, kQuiet);
    sketch.Line(sketch.Shifted(kJoint, 12.0, 5.0), sketch.Shifted(kJoint, 56.0, 30.0), kQuiet);
    sketch.Inset(detail, 406.0, 44.0);

    Run(world, 10);
    const float32 after = box->GetLinearVelocity().x;
    sketch.Label(b2Vec2(-1.8f, 0.0f), Side::Below, "edge1", kInk, 9.0);
    sketch.Label(kJoint, Side::Below, "internal vertex", kInk, 14.0);
    sketch.Label(b2Vec2(1.6f, 0.0f), Side::Below, "edge2", kInk, 9.0);
    const b2Vec2 start(-3.2f, 1.35f);
    sketch.ArrowAlong(start, b2Vec2(1.0f, 0.0f), 100.0);
    sketch.Label(sketch.Shifted(start, 50.0, 0.0), Side::Above, "1 m/s", kInk, 4.0);
    const b2Vec2 back(-0.3f, 1.35f);
    sketch.ArrowAlong(back, b2Vec2(after, 0.0f), 100.0 * b2Abs(after), kBad);
    sketch.Label(sketch.Shifted(back, 50.0 * after, 0.0), Side::Above,
                 "then " + Text(after, 2) + " m/s", kBad, 4.0);
    return sketch.Finished();
}

Figure DrawGhostVertices()
{
    Sketch sketch(640, 230, b2Vec2(0.0f, 0.6f), 100.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2Vec2 v[4] = {{-2.7f, 0.0f}, {0.0f, 0.0f}, {1.8f, 0.0f}, {2.6f, 0.35f}};
    b2EdgeShape before = Edge(b2Vec2(-5.0f, 0.0f), v[1]);
    before.m_hasVertex3 = true;
    before.m_vertex3 = v[2];
    b2EdgeShape edge = Edge(v[1], v[2]);
    edge.m_hasVertex0 = true;
    edge.m_hasVertex3 = true;
    edge.m_vertex0 = v[0];
    edge.m_vertex3 = v[3];
    AddSmoothEdge(world, before);
    AddSmoothEdge(world, edge);
    const b2Body* const box = AddSlider(world, -3.0f);
    int step = 0;
    for (const double opacity : {0.4, 0.6})
    {
        const int until = opacity < 0.5 ? 60 : 150;
        Run(world, until - step);
        step = until;
        sketch.DrawFaint(world, opacity);
    }
    Run(world, 240 - step);
    sketch.Draw(world);
    sketch.Dashes(v[2], v[3]);
    AddVertex(sketch, v[0], "m_vertex0", true);
    AddVertex(sketch, v[1], "m_vertex1");
    AddVertex(sketch, v[2], "m_vertex2");
    sketch.Label(0.5f * (v[1] + v[2]), Side::Below, "the edge", kInk, 9.0);
    sketch.Ring(v[3], 4.0);
    sketch.Label(v[3], Side::Above, "m_vertex3", kInk, 8.0);
    const b2Vec2 start(-1.9f, 1.25f);
    sketch.ArrowAlong(start, b2Vec2(1.0f, 0.0f), 100.0);
    sketch.Label(sketch.Shifted(start, 50.0, 0.0), Side::Above, "1 m/s", kInk, 4.0);
    const b2Vec2 on(0.5f, 1.25f);
    sketch.ArrowAlong(on, b2Vec2(1.0f, 0.0f), 100.0, kGood);
    sketch.Label(sketch.Shifted(on, 50.0, 0.0), Side::Above,
                 "still " + Text(box->GetLinearVelocity().x, 0) + " m/s", kGood, 4.0);
    return sketch.Finished();
}

Figure DrawChain()
{
    Sketch sketch(640, 280, b2Vec2(0.0f, 0.25f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2Vec2 vertices[6] = {{-2.9f, 1.1f}, {-2.0f, 0.1f}, {-0.7f, -0.5f},
                                {0.6f, -0.6f}, {1.8f, -0.2f}, {2.9f, 0.5f}};
    b2ChainShape chain;
    chain.CreateChain(vertices, 6);
    chain.SetPrevVertex(b2Vec2(-3.5f, 1.35f));
    chain.SetNextVertex(b2Vec2(3.6f, 0.6f));
    AddGround(world, chain);
    const b2Body* const ball = AddBody(world, b2_dynamicBody, Disc(0.25f), b2Vec2(-2.4f, 1.25f));
    std::vector<b2Vec2> way;
    for (int step = 0; step < 90; ++step)
    {
        if (step == 0 || step == 30 || step == 48 || step == 68)
        {
            sketch.DrawFaint(world, 0.4 + 0.003 * step);
        }
        way.push_back(ball->GetPosition());
        Run(world);
    }
    way.push_back(ball->GetPosition());
    sketch.Trail(way);
    sketch.Draw(world);
    for (int32 i = 0; i < 6; ++i)
    {
        sketch.Dot(vertices[i]);
        sketch.Label(vertices[i], i == 0 ? Side::BelowLeft : Side::Below,
                     "vs[" + std::to_string(i) + "]", kInk, 9.0);
    }
    sketch.Dashes(chain.m_prevVertex, vertices[0]);
    sketch.Dashes(vertices[5], chain.m_nextVertex);
    sketch.Ring(chain.m_prevVertex, 4.0);
    sketch.Label(chain.m_prevVertex, Side::Above, "previous", kInk, 8.0);
    AddVertex(sketch, chain.m_nextVertex, "next", true);
    return sketch.Finished();
}

Figure DrawSelfIntersection()
{
    Sketch sketch(640, 260, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 vertices[6] = {{-3.2f, -0.7f}, {-1.2f, -0.9f}, {1.3f, 0.9f},
                                {0.1f, 1.3f},   {-0.3f, -0.8f}, {3.2f, -0.6f}};
    b2ChainShape chain;
    chain.CreateChain(vertices, 6);
    AddGround(world, chain);
    Run(world);
    sketch.Draw(world);
    for (const b2Vec2& vertex : vertices)
    {
        sketch.Dot(vertex);
    }
    // The joint of the second and the fourth edge.
    b2Transform here;
    here.SetIdentity();
    b2RayCastOutput hit;
    chain.RayCast(&hit, {vertices[3], vertices[4], 1.0f}, here, 1);
    const b2Vec2 crossing = vertices[3] + hit.fraction * (vertices[4] - vertices[3]);
    sketch.Ring(crossing, 12.0, kBad);
    sketch.Note(sketch.Shifted(crossing, -12.0, 0.0), -60.0, 20.0,
                "the chain crosses itself:\nnot supported", kBad);
    return sketch.Finished();
}

} // namespace figures
