// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

/// Its points, and its normal at each of them.
void AddManifold(Sketch& sketch, const b2Manifold& local, const b2Body& a, const b2Body& b)
{
    b2WorldManifold manifold;
    manifold.Initialize(&local, a.GetTransform(), a.GetFixtureList()->GetShape()->m_radius,
                        b.GetTransform(), b.GetFixtureList()->GetShape()->m_radius);
    for (int32 i = 0; i < local.pointCount; ++i)
    {
        sketch.ArrowAlong(manifold.points[i], manifold.normal, 44.0, kPush);
        sketch.Dot(manifold.points[i], kPush, 8.0);
    }
}

} // namespace

Figure DrawManifolds()
{
    Sketch sketch(640, 260, b2Vec2(0.0f, 0.0f), 60.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2CircleShape disc = Disc(0.75f);
    const b2PolygonShape box = Box(0.9f, 0.6f);
    const b2PolygonShape narrow = Box(0.7f, 0.6f);
    const b2PolygonShape wide = Box(1.15f, 0.6f);
    // They overlap far more than a world lets them, to be seen.
    const b2Body* const discA = AddBody(world, b2_staticBody, disc, b2Vec2(-3.7f, -0.4f));
    const b2Body* const discB = AddBody(world, b2_dynamicBody, disc, b2Vec2(-3.1f, 0.85f));
    const b2Body* const boxA = AddBody(world, b2_staticBody, box, b2Vec2(0.0f, -0.5f));
    const b2Body* const onBox = AddBody(world, b2_dynamicBody, disc, b2Vec2(0.2f, 0.72f));
    const b2Body* const narrowA = AddBody(world, b2_staticBody, narrow, b2Vec2(3.5f, -0.5f));
    // B is wider than A, so that the normals do not lie on its sides.
    const b2Body* const wideB =
        AddBody(world, b2_dynamicBody, wide, b2Vec2(3.5f, 0.6f), Degrees(3.0f));
    sketch.Draw(world);

    b2Manifold manifold;
    b2CollideCircles(&manifold, &disc, discA->GetTransform(), &disc, discB->GetTransform());
    AddManifold(sketch, manifold, *discA, *discB);
    b2CollidePolygonAndCircle(&manifold, &box, boxA->GetTransform(), &disc, onBox->GetTransform());
    AddManifold(sketch, manifold, *boxA, *onBox);
    b2CollidePolygons(&manifold, &narrow, narrowA->GetTransform(), &wide, wideB->GetTransform());
    AddManifold(sketch, manifold, *narrowA, *wideB);
    for (const b2Body* a : {discA, boxA, narrowA})
    {
        sketch.Label(a->GetPosition(), Side::Below, "A", kInk, 6.0);
    }
    for (const b2Body* b : {discB, onBox, wideB})
    {
        sketch.Label(b->GetPosition(), Side::Above, "B", kInk, b == wideB ? 2.0 : 18.0);
    }
    sketch.Caption(116.0, 246.0, Side::Above, "two circles:\none point");
    sketch.Caption(320.0, 246.0, Side::Above, "polygon and circle:\none point");
    sketch.Caption(530.0, 246.0, Side::Above, "two polygons:\ntwo points, one normal");
    return sketch.Finished();
}

Figure DrawDistance()
{
    Sketch sketch(640, 280, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 corners[5] = {
        {-1.0f, -0.9f}, {0.8f, -0.8f}, {1.2f, 0.1f}, {0.2f, 0.9f}, {-1.1f, 0.5f}};
    b2PolygonShape shapeA;
    shapeA.Set(corners, 5);
    const b2PolygonShape shapeB = Box(0.9f, 0.6f);
    const b2Body* const a = AddBody(world, b2_staticBody, shapeA, b2Vec2(-2.0f, -0.1f));
    const b2Body* const b =
        AddBody(world, b2_dynamicBody, shapeB, b2Vec2(2.1f, 0.2f), Degrees(28.0f));
    Run(world);
    sketch.Draw(world);

    b2DistanceInput input;
    input.proxyA.Set(&shapeA, 0);
    input.proxyB.Set(&shapeB, 0);
    input.transformA = a->GetTransform();
    input.transformB = b->GetTransform();
    b2SimplexCache cache;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    sketch.Line(output.pointA, output.pointB, kHelp);
    sketch.Dot(output.pointA, kHelp);
    sketch.Dot(output.pointB, kHelp);
    sketch.Measure(output.pointA, output.pointB, "distance " + Text(output.distance, 2) + " m",
                   -46.0);
    sketch.Label(output.pointA, Side::AboveRight, "pointA", kInk, 20.0);
    sketch.Label(output.pointB, Side::AboveLeft, "pointB", kInk, 10.0);
    return sketch.Finished();
}

} // namespace figures
