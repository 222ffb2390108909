// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <vector>

namespace
{

b2Transform At(float32 x, float32 y)
{
    return b2Transform(b2Vec2(x, y), b2Rot());
}

TEST(CollisionListing, MakesACircle)
{
    // [circle]
    b2CircleShape circle;
    circle.m_p.Set(2.0f, 3.0f); // the centre, in the body's frame
    circle.m_radius = 0.5f;
    // [/circle]
    EXPECT_TRUE(circle.TestPoint(b2Transform(), b2Vec2(2.0f, 3.4f)));
    EXPECT_FALSE(circle.TestPoint(b2Transform(), b2Vec2(2.0f, 3.6f)));
}

TEST(CollisionListing, MakesPolygonsAndSaysWhatIsNone)
{
    // [polygon]
    const b2Vec2 corners[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    b2PolygonShape triangle;
    triangle.Set(corners, 3);

    b2PolygonShape box;
    box.SetAsBox(1.0f, 0.5f);                                             // 2 m x 1 m
    box.SetAsBox(1.0f, 0.5f, b2Vec2(3.0f, 0.0f), 30.0f * b2_pi / 180.0f); // turned, off the origin
    // [/polygon]
    EXPECT_EQ(triangle.GetVertexCount(), 3);
    EXPECT_TRUE(box.TestPoint(b2Transform(), b2Vec2(3.8f, 0.45f)));

    const b2Vec2 points[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}};
    bool refused = false;
    testing::internal::CaptureStderr();
    // [why-not]
    if (const char* why = b2PolygonShape::WhyNotConvex(points, 3))
    {
        std::fprintf(stderr, "%s\n", why); // "The polygon's points lie on one line or closer ..."
        refused = true;
    }
    // [/why-not]
    EXPECT_TRUE(refused);
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                testing::StartsWith("The polygon's points lie on one line or closer "));
    EXPECT_EQ(b2PolygonShape::WhyNotConvex(corners, 3), nullptr);
}

TEST(CollisionListing, KeepsASkinBetweenBoxes)
{
    manual::Stage stage;
    stage.Ground();
    const b2Body* box = stage.Box(0.0f, 1.0f);
    stage.Run(3.0f);
    const float32 gap = box->GetPosition().y - 0.5f;
    EXPECT_NEAR(gap, 2.0f * b2_polygonRadius - b2_linearSlop, 0.0005f) << "15 mm";
}

TEST(CollisionListing, MakesEdgesWithNeighbours)
{
    // [edge]
    b2EdgeShape edge;
    edge.Set(b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, 0.0f));
    edge.m_vertex0.Set(-2.0f, 0.0f); // the far end of the edge before
    edge.m_vertex3.Set(4.0f, 0.5f);  // and of the edge after
    edge.m_hasVertex0 = true;
    edge.m_hasVertex3 = true;
    // [/edge]
    EXPECT_EQ(edge.m_vertex2, b2Vec2(2.0f, 0.0f));
    EXPECT_EQ(edge.GetChildCount(), 1);
}

TEST(CollisionListing, MakesChainsAndLoops)
{
    // [chain]
    const b2Vec2 hills[] = {{-4.0f, 1.0f}, {-2.0f, 0.0f}, {0.0f, 0.0f}, {2.0f, 0.5f}, {4.0f, 0.5f}};
    b2ChainShape chain;
    chain.CreateChain(hills, 5);
    chain.SetPrevVertex(b2Vec2(-6.0f, 2.0f)); // where another chain comes in
    chain.SetNextVertex(b2Vec2(6.0f, 1.0f));  // and where one goes on

    const b2Vec2 yard[] = {{-9.0f, -9.0f}, {9.0f, -9.0f}, {9.0f, 9.0f}, {-9.0f, 9.0f}};
    b2ChainShape loop;
    loop.CreateLoop(yard, 4); // the last vertex is joined to the first: do not repeat it
    // [/chain]
    EXPECT_EQ(chain.GetChildCount(), 4);
    EXPECT_EQ(loop.GetChildCount(), 4);

    float32 length = 0.0f;
    // [children]
    for (int32 i = 0; i < chain.GetChildCount(); ++i)
    {
        b2EdgeShape edge;
        chain.GetChildEdge(&edge, i); // with its neighbours
        length += b2Distance(edge.m_vertex1, edge.m_vertex2);
    }
    // [/children]
    EXPECT_NEAR(length, 2.236f + 2.0f + 2.062f + 2.0f, 0.001f);
}

TEST(CollisionListing, TestsAPoint)
{
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    const b2Shape* shape = &circle;
    // [point]
    const b2Transform place(b2Vec2(5.0f, 2.0f), b2Rot(0.0f));
    const bool inside = shape->TestPoint(place, b2Vec2(5.3f, 2.0f));
    // [/point]
    EXPECT_TRUE(inside);
    EXPECT_FALSE(shape->TestPoint(b2Transform(), b2Vec2(5.3f, 2.0f)));
}

TEST(CollisionListing, CastsARay)
{
    b2PolygonShape wall;
    wall.SetAsBox(0.5f, 2.0f);
    const b2Shape* shape = &wall;
    const b2Transform place = At(4.0f, 0.0f);
    b2Vec2 where;
    // [ray]
    b2RayCastInput ray;
    ray.p1.Set(0.0f, 0.0f);
    ray.p2.Set(10.0f, 0.0f);
    ray.maxFraction = 1.0f; // as far as p2; 2 would go on for as much again
    b2RayCastOutput hit;
    if (shape->RayCast(&hit, ray, place, 0)) // child 0: of a chain, one edge at a time
    {
        where = ray.p1 + hit.fraction * (ray.p2 - ray.p1); // hit.normal points back at the ray
    }
    // [/ray]
    EXPECT_NEAR(b2Distance(where, b2Vec2(3.5f, 0.0f)), 0.0f, 1e-5f);
    EXPECT_EQ(hit.normal, b2Vec2(-1.0f, 0.0f));
}

TEST(CollisionListing, TestsTwoShapesForOverlap)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    // [overlap]
    const bool touching = b2TestOverlap(&box, 0, &ball, 0, At(0.0f, 0.0f), At(1.4f, 0.0f));
    // [/overlap]
    EXPECT_TRUE(touching);
    EXPECT_FALSE(b2TestOverlap(&box, 0, &ball, 0, At(0.0f, 0.0f), At(1.6f, 0.0f)));
}

TEST(CollisionListing, ComputesAManifold)
{
    std::vector<b2Vec2> points;
    // [manifold]
    b2PolygonShape floor, box;
    floor.SetAsBox(5.0f, 0.5f);
    box.SetAsBox(0.5f, 0.5f);
    const b2Transform floorAt = At(0.0f, 0.0f), boxAt = At(1.0f, 0.99f);

    b2Manifold manifold; // in the frames of the two shapes
    b2CollidePolygons(&manifold, &floor, floorAt, &box, boxAt);

    b2WorldManifold world;
    world.Initialize(&manifold, floorAt, floor.m_radius, boxAt, box.m_radius);
    for (int32 i = 0; i < manifold.pointCount; ++i) // the count stays with the manifold
    {
        points.push_back(world.points[i]);
    }
    // [/manifold]
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(world.normal, b2Vec2(0.0f, 1.0f));
    EXPECT_NEAR(world.separations[0], -0.01f - 2.0f * b2_polygonRadius, 1e-5f);

    b2Manifold later;
    b2CollidePolygons(&later, &floor, floorAt, &box, At(5.48f, 0.99f));
    int32 begun = 0, ended = 0;
    // [states]
    b2PointState before[b2_maxManifoldPoints], after[b2_maxManifoldPoints];
    b2GetPointStates(before, after, &manifold, &later);
    for (int32 i = 0; i < later.pointCount; ++i)
    {
        begun += after[i] == b2_addState;
    }
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        ended += before[i] == b2_removeState;
    }
    // [/states]
    EXPECT_EQ(begun, 1) << "one corner has left the floor";
    EXPECT_EQ(ended, 1);
}

TEST(CollisionListing, MeasuresTheDistance)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    // [distance]
    b2DistanceInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&ball, 0);
    input.transformA = At(0.0f, 0.0f);
    input.transformB = At(4.0f, 0.0f);
    input.useRadii = true; // false: between the cores, without circles' radii and skins

    b2SimplexCache cache; // keep it: the next call for this pair starts where this one ended
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    // [/distance]
    EXPECT_NEAR(output.distance, 4.0f - 1.0f - 0.5f - b2_polygonRadius, 1e-5f);
    input.useRadii = false;
    b2Distance(&output, &cache, &input);
    EXPECT_NEAR(output.distance, 3.0f, 1e-5f);

    EXPECT_EQ(b2DistanceProxy().m_count, 0);
    EXPECT_EQ(input.proxyA.GetVertexCount(), 4);
    EXPECT_EQ(input.proxyA.m_radius, b2_polygonRadius);
    EXPECT_EQ(input.proxyB.GetVertexCount(), 1);
    EXPECT_EQ(input.proxyB.m_radius, 0.5f);
    EXPECT_EQ(input.proxyA.GetSupportVertex(b2Vec2(1.0f, 1.0f)), b2Vec2(1.0f, 1.0f));
}

TEST(CollisionListing, FindsTheTimeOfImpact)
{
    b2PolygonShape wall, box;
    wall.SetAsBox(0.01f, 5.0f);
    box.SetAsBox(0.1f, 0.1f);
    // [toi]
    b2TOIInput input;
    input.proxyA.Set(&wall, 0);
    input.proxyB.Set(&box, 0);
    input.sweepB.c0.Set(-10.0f, 0.0f); // from here ...
    input.sweepB.c.Set(10.0f, 0.0f);   // ... to there; angles a0 and a stay 0

    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    const bool meets = output.state == b2TOIOutput::e_touching; // at output.t, about 0.49
    // [/toi]
    EXPECT_TRUE(meets);
    EXPECT_NEAR(output.t, 0.4945f, 0.001f);

    // [sweep]
    b2Sweep sweep;
    sweep.c0.Set(-10.0f, 0.0f);
    sweep.c.Set(10.0f, 0.0f);
    input.sweepB = sweep;
    b2TimeOfImpact(&output, &input);

    b2Transform atImpact;
    sweep.GetTransform(&atImpact, output.t); // a transform at the time of impact
    sweep.Advance(output.t);                 // what is left: from the impact to the end
    // [/sweep]
    EXPECT_NEAR(atImpact.p.x, -0.125f, 0.02f) << "half of the wall, half of the box, skins";
    EXPECT_NEAR(b2Distance(sweep.c0, atImpact.p), 0.0f, 1e-4f);
    EXPECT_EQ(sweep.alpha0, output.t);
    EXPECT_EQ(sweep.c, b2Vec2(10.0f, 0.0f));

    // A rod that is clear of the post at both ends of a turn, and not in between.
    b2PolygonShape post, rod;
    post.SetAsBox(0.2f, 0.2f);
    rod.SetAsBox(0.1f, 1.6f);
    input.proxyA.Set(&post, 0);
    input.proxyB.Set(&rod, 0);
    input.sweepB.c0.Set(1.3f, 0.0f);
    input.sweepB.c = input.sweepB.c0;
    input.sweepB.a0 = 40.0f * b2_pi / 180.0f;
    input.sweepB.a = 140.0f * b2_pi / 180.0f;
    b2TimeOfImpact(&output, &input);
    EXPECT_EQ(output.state, b2TOIOutput::e_touching);
}

// [tree]
/// Collects the numbers of the proxies that a query finds.
struct Found
{
    bool QueryCallback(int32 proxy)
    {
        proxies.push_back(proxy);
        return true; // false would end the query
    }
    std::vector<int32> proxies;
};
// [/tree]

// [tree-ray]
/// Keeps the nearest thing that a ray hits; the tree knows only its box.
struct NearestLamp
{
    float32 RayCastCallback(const b2RayCastInput& input, int32 proxy)
    {
        b2RayCastOutput hit;
        if (!tree.GetFatAABB(proxy).RayCast(&hit, input))
        {
            return -1.0f; // no hit: the ray stays as it is
        }
        nearest = proxy;
        return hit.fraction; // the ray ends here from now on
    }
    const b2DynamicTree& tree;
    int32 nearest = b2_nullNode; ///< none
};
// [/tree-ray]

b2AABB BoxFrom(float32 x, float32 y, float32 size)
{
    b2AABB box;
    box.lowerBound.Set(x, y);
    box.upperBound.Set(x + size, y + size);
    return box;
}

TEST(CollisionListing, AsksATree)
{
    int lamps[100] = {};
    // [query]
    b2DynamicTree tree;
    for (int i = 0; i < 100; ++i)
    {
        tree.CreateProxy(BoxFrom(3.0f * float32(i), 0.0f, 1.0f), &lamps[i]);
    }
    Found found;
    tree.Query(&found, BoxFrom(30.0f, 0.0f, 5.0f));
    // [/query]
    ASSERT_EQ(found.proxies.size(), 2u);
    for (const int32 proxy : found.proxies)
    {
        const auto index = static_cast<int*>(tree.GetUserData(proxy)) - lamps;
        EXPECT_TRUE(index == 10 || index == 11) << index;
    }
    // [cast]
    b2RayCastInput ray;
    ray.p1.Set(-5.0f, 0.5f);
    ray.p2.Set(50.0f, 0.5f);
    ray.maxFraction = 1.0f;
    NearestLamp lamp{tree};
    tree.RayCast(&lamp, ray);
    // [/cast]
    ASSERT_NE(lamp.nearest, b2_nullNode);
    EXPECT_EQ(tree.GetUserData(lamp.nearest), &lamps[0]);
}

TEST(CollisionListing, BouncesWithinAStep)
{
    manual::Stage stage(b2Vec2_zero);
    EXPECT_TRUE(stage.world.GetContinuousPhysics());
    EXPECT_FALSE(stage.world.GetSubStepping());
    stage.Ground();
    b2Body* ball = stage.Ball(0.0f, 1.0f, 0.1f);
    ball->GetFixtureList()->SetRestitution(0.8f);
    ball->SetLinearVelocity(b2Vec2(0.0f, -90.0f));
    stage.Run(1.0f / 60.0f);
    EXPECT_GT(ball->GetPosition().y, 0.3f) << "on its way up";
    EXPECT_NEAR(ball->GetLinearVelocity().y, 72.0f, 1.0f);
}

} // namespace
