// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

/// Takes the place of the nearest hit.
class NearestHit : public b2RayCastCallback
{
public:
    float32 ReportFixture(b2Fixture*, const b2Vec2& hit, const b2Vec2&, float32 fraction) override
    {
        point = hit;
        return fraction;
    }
    b2Vec2 point;
};

b2Vec2 FirstHit(const b2World& world, const b2Vec2& from, const b2Vec2& to)
{
    NearestHit nearest;
    world.RayCast(&nearest, from, to);
    return nearest.point;
}

/// The number of the side whose normal is nearest to a direction.
int32 SideFacing(const b2PolygonShape& shape, const b2Vec2& direction)
{
    int32 best = 0;
    for (int32 i = 1; i < shape.m_count; ++i)
    {
        best = b2Dot(shape.m_normals[i], direction) > b2Dot(shape.m_normals[best], direction)
                   ? i
                   : best;
    }
    return best;
}

/// The vertices with their numbers, and an arrow along each side.
void AddOrder(Sketch& sketch, const std::vector<b2Vec2>& vertices, const b2Vec2& middle)
{
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        const b2Vec2 from = vertices[i];
        const b2Vec2 to = vertices[(i + 1) % vertices.size()];
        sketch.Arrow(from + 0.3f * (to - from), from + 0.7f * (to - from));
        sketch.Dot(from);
        b2Vec2 out = from - middle;
        out.Normalize();
        sketch.Label(sketch.Shifted(from, 16.0 * out.x, 16.0 * out.y), Side::On, std::to_string(i));
    }
}

} // namespace

Figure DrawConvexAndConcave()
{
    Sketch sketch(640, 290, b2Vec2(0.0f, -0.1f), 60.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 corners[6] = {{-1.7f, -0.9f}, {0.2f, -1.5f}, {1.6f, -0.6f},
                               {1.4f, 0.9f},   {0.0f, 1.6f},  {-1.6f, 0.8f}};
    b2PolygonShape convex;
    convex.Set(corners, 6);
    AddBody(world, b2_dynamicBody, convex, b2Vec2(-2.6f, 0.3f));
    const b2Vec2 dent[6] = {{0.9f, -1.2f}, {4.3f, -1.2f}, {4.2f, 1.6f},
                            {3.0f, 1.3f},  {2.6f, -0.2f}, {1.2f, 1.7f}};
    b2ChainShape concave; // answers the rays below; no world has such a polygon
    concave.CreateLoop(dent, 6);
    Run(world);
    sketch.Draw(world);
    AddBody(world, b2_staticBody, concave, b2Vec2(0.0f, 0.0f));
    // Two convex parts, half a line's width apart, so that their edges do not overlap.
    const float32 half = 0.6f / 60.0f;
    sketch.Fill({dent[0], {2.6f - half, -1.2f}, {2.6f - half, -0.2f}, dent[5]},
                ColorRole::AwakeBody);
    sketch.Fill({{2.6f + half, -1.2f}, dent[1], dent[2], dent[3], {2.6f + half, -0.2f}},
                ColorRole::AwakeBody);
    sketch.Outline({std::begin(dent), std::end(dent)}, kMoving);

    const b2Vec2 a(-3.7f, 0.0f);
    const b2Vec2 b(-1.5f, 0.8f);
    sketch.Bar(a, b, kGood);
    sketch.Dot(a, kGood);
    sketch.Dot(b, kGood);
    const b2Vec2 c(1.5f, 0.7f);
    const b2Vec2 d(3.8f, 0.9f);
    const b2Vec2 out = FirstHit(world, c, d);
    const b2Vec2 in = FirstHit(world, d, c);
    sketch.Bar(c, out, kGood);
    sketch.Bar(out, in, kBad);
    sketch.Bar(in, d, kGood);
    sketch.Dot(c, kGood);
    sketch.Dot(d, kGood);
    sketch.Caption(164.0, 282.0, Side::Above, "convex: a line between two\npoints stays inside");
    sketch.Caption(476.0, 282.0, Side::Above, "concave: this one\nleaves it");
    return sketch.Finished();
}

Figure DrawWinding()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.0f), 60.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 corners[5] = {
        {-1.5f, -1.1f}, {1.3f, -1.3f}, {1.9f, 0.4f}, {0.2f, 1.5f}, {-1.6f, 0.6f}};
    b2PolygonShape shape;
    shape.Set(corners, 5);
    const b2Vec2 left(-2.6f, 0.35f);
    const b2Vec2 right(2.6f, 0.35f);
    AddBody(world, b2_dynamicBody, shape, left);
    AddBody(world, b2_dynamicBody, shape, right);
    Run(world);
    sketch.Draw(world);

    std::vector<b2Vec2> counterClockwise;
    std::vector<b2Vec2> clockwise;
    for (int32 i = 0; i < shape.GetVertexCount(); ++i)
    {
        counterClockwise.push_back(left + shape.GetVertex(i));
        clockwise.push_back(right + shape.GetVertex(shape.GetVertexCount() - 1 - i));
    }
    AddOrder(sketch, counterClockwise, left + shape.m_centroid);
    AddOrder(sketch, clockwise, right + shape.m_centroid);
    sketch.ArcArrow(left + shape.m_centroid, 28.0, 0.0f, Degrees(300.0f), kGood);
    sketch.ArcArrow(right + shape.m_centroid, 28.0, Degrees(180.0f), Degrees(-120.0f), kBad);
    sketch.Caption(164.0, 290.0, Side::Above, "counter-clockwise: kept so");
    sketch.Caption(476.0, 290.0, Side::Above, "clockwise: Set() turns it round");
    const b2Vec2 origin(-0.2f, -1.5f);
    sketch.ArrowAlong(origin, b2Vec2(1.0f, 0.0f), 34.0, kQuiet);
    sketch.ArrowAlong(origin, b2Vec2(0.0f, 1.0f), 34.0, kQuiet);
    sketch.Label(sketch.Shifted(origin, 34.0, 0.0), Side::Right, "x", kQuiet, 3.0);
    sketch.Label(sketch.Shifted(origin, 0.0, 34.0), Side::Above, "y", kQuiet, 2.0);
    return sketch.Finished();
}

Figure DrawPolygonSkin()
{
    Sketch sketch(640, 270, b2Vec2(-0.005f, 0.0f), 3200.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 corners[4] = {
        {-0.045f, -0.026f}, {0.035f, -0.026f}, {0.045f, 0.005f}, {-0.02f, 0.027f}};
    b2PolygonShape shape;
    shape.Set(corners, 4);
    const b2Body* const body = AddBody(world, b2_dynamicBody, shape, b2Vec2(-0.012f, 0.0f));
    Run(world);
    sketch.Draw(world);
    sketch.Outline(SkinOf(shape, body->GetTransform()), kHelp);

    const b2Vec2 end = body->GetWorldPoint(corners[1]);
    sketch.Measure(end, end - b2Vec2(0.0f, shape.m_radius), "m_radius = 1 cm", 36.0);
    sketch.Label(b2Vec2(-0.012f, -0.006f), Side::On, "the polygon:\nm_vertices");
    const b2Vec2 side = 0.5f * (corners[2] + corners[3]) - b2Vec2(0.012f, 0.0f);
    sketch.Note(side + shape.m_radius * shape.m_normals[SideFacing(shape, b2Vec2(0.0f, 1.0f))],
                60.0, 20.0, "its skin", kHelp);
    return sketch.Finished();
}

Figure DrawSkinGap()
{
    constexpr float32 kHalfHeight = 0.018f;
    Sketch sketch(640, 320, b2Vec2(-0.006f, 0.0095f), 2600.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2PolygonShape shape = Box(0.055f, kHalfHeight);
    const b2Body* const lower = AddBody(world, b2_staticBody, shape, b2Vec2(0.0f, -kHalfHeight));
    // Dropped from so high that it comes to rest as deep as the engine lets skins overlap.
    const b2Body* const upper = AddBody(world, b2_dynamicBody, shape, b2Vec2(-0.02f, 0.1f));
    Run(world, 120);
    sketch.Draw(world);
    for (const b2Body* body : {lower, upper})
    {
        sketch.Outline(SkinOf(shape, body->GetTransform()), kHelp);
    }
    const float32 gap = upper->GetPosition().y - kHalfHeight;
    sketch.Measure(b2Vec2(-0.075f, 0.0f), b2Vec2(-0.075f, gap),
                   "gap " + Text(1000.0 * gap, 0) + " mm", 42.0);
    sketch.Line(b2Vec2(-0.075f, 0.0f), b2Vec2(-0.055f, 0.0f), kQuiet);
    const double overlap = 2.0 * b2_polygonRadius - gap;
    sketch.Note(b2Vec2(0.033f, 0.5f * gap), 92.0, 46.0,
                "the skins overlap\nby " + Text(1000.0 * overlap, 0) + " mm", kHelp);
    return sketch.Finished();
}

} // namespace figures
