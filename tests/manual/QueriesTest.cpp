// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>

/// The Collision module's chapter from the unary queries to the broad phase, section by section.
namespace
{

b2PolygonShape Box(float32 hx, float32 hy)
{
    b2PolygonShape box;
    box.SetAsBox(hx, hy);
    return box;
}

b2Transform At(float32 x, float32 y, float32 angle = 0.0f)
{
    b2Transform transform;
    transform.Set(b2Vec2(x, y), angle);
    return transform;
}

TEST(ShapePointTest, TestsAWorldPointInTheListing)
{
    const b2PolygonShape box = Box(6.0f, 3.0f);
    const b2Shape* shape = &box;
    b2Transform transform;
    transform.SetIdentity();
    b2Vec2 point(5.0f, 2.0f);
    bool hit = shape->TestPoint(transform, point);
    EXPECT_TRUE(hit);
    EXPECT_FALSE(shape->TestPoint(At(8.0f, 5.5f), point));
}

TEST(ShapePointTest, IsAlwaysFalseForEdgesAndChainsEvenForLoops)
{
    b2EdgeShape edge;
    edge.Set(b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    EXPECT_FALSE(edge.TestPoint(b2Transform(), b2Vec2_zero));
    const b2Vec2 corners[4] = {{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}};
    b2ChainShape chain;
    chain.CreateLoop(corners, 4);
    EXPECT_FALSE(chain.TestPoint(b2Transform(), b2Vec2_zero));
    EXPECT_FALSE(chain.TestPoint(b2Transform(), corners[0]));
}

TEST(ShapeRayCast, GivesTheFirstHitAndItsNormalInTheListing)
{
    b2CircleShape circle;
    circle.m_p.Set(0.75f, 0.0f);
    circle.m_radius = 0.25f;
    const b2Shape* shape = &circle;

    b2Transform transform;
    transform.SetIdentity();
    b2RayCastInput input;
    input.p1.Set(0.0f, 0.0f);
    input.p2.Set(1.0f, 0.0f);
    input.maxFraction = 1.0f;
    int32 childIndex = 0;
    b2RayCastOutput output;
    bool hit = shape->RayCast(&output, input, transform, childIndex);
    ASSERT_TRUE(hit);
    if (hit)
    {
        b2Vec2 hitPoint = input.p1 + output.fraction * (input.p2 - input.p1);
        EXPECT_NEAR(b2Distance(hitPoint, b2Vec2(0.5f, 0.0f)), 0.0f, 1e-6f);
        EXPECT_NEAR(b2Distance(output.normal, b2Vec2(-1.0f, 0.0f)), 0.0f, 1e-6f);
    }
}

TEST(ShapeRayCast, DoesNotHitWhenItStartsInside)
{
    b2RayCastInput input;
    input.p2.Set(5.0f, 0.0f);
    b2RayCastOutput output;
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    EXPECT_FALSE(circle.RayCast(&output, input, b2Transform(), 0));
    EXPECT_FALSE(Box(1.0f, 1.0f).RayCast(&output, input, b2Transform(), 0));
}

TEST(ShapeRayCast, ChecksASingleEdgeOfAChain)
{
    const b2Vec2 vs[3] = {{0.0f, -1.0f}, {0.0f, 1.0f}, {3.0f, 1.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    b2RayCastInput input;
    input.p1.Set(-1.0f, 0.0f);
    input.p2.Set(1.0f, 0.0f);
    b2RayCastOutput output;
    EXPECT_TRUE(chain.RayCast(&output, input, b2Transform(), 0));
    EXPECT_FALSE(chain.RayCast(&output, input, b2Transform(), 1));
}

TEST(Overlap, IsReportedForTwoShapesAndTheirChildren)
{
    const b2PolygonShape box = Box(1.0f, 1.0f);
    const b2Vec2 vs[3] = {{0.0f, 0.0f}, {5.0f, 0.0f}, {10.0f, 0.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    const b2Shape* shapeA = &box;
    const b2Shape* shapeB = &chain;
    int32 indexA = 0, indexB = 0;
    b2Transform xfA = At(2.0f, 0.5f), xfB = At(0.0f, 0.0f);
    bool overlap = b2TestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    EXPECT_TRUE(overlap);
    EXPECT_FALSE(b2TestOverlap(shapeA, indexA, shapeB, 1, xfA, xfB));
    EXPECT_FALSE(b2TestOverlap(shapeA, indexA, shapeB, indexB, At(2.0f, 1.5f), xfB));
}

TEST(ContactManifolds, HaveOnePointForCirclesAndTwoForPolygons)
{
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    const b2PolygonShape box = Box(1.0f, 1.0f);
    b2Manifold manifold;
    b2CollideCircles(&manifold, &circle, At(0.0f, 0.0f), &circle, At(1.5f, 0.0f));
    EXPECT_EQ(manifold.pointCount, 1);
    b2CollidePolygonAndCircle(&manifold, &box, At(0.0f, 0.0f), &circle, At(1.5f, 0.0f));
    EXPECT_EQ(manifold.pointCount, 1);
    b2CollidePolygons(&manifold, &box, At(0.0f, 0.0f), &box, At(1.9f, 0.0f));
    EXPECT_EQ(manifold.pointCount, 2);
}

TEST(ContactManifolds, GiveWorldPointsInTheListing)
{
    const b2PolygonShape shapeA = Box(1.0f, 1.0f), shapeB = Box(0.5f, 0.5f);
    const b2Transform transformA = At(3.0f, 0.0f), transformB = At(3.0f, 1.45f);
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &shapeA, transformA, &shapeB, transformB);

    b2WorldManifold worldManifold;
    worldManifold.Initialize(&manifold, transformA, shapeA.m_radius, transformB, shapeB.m_radius);
    ASSERT_EQ(manifold.pointCount, 2);
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        b2Vec2 point = worldManifold.points[i];
        EXPECT_NEAR(b2Abs(point.x - 3.0f), 0.5f, 0.02f);
        EXPECT_NEAR(point.y, 0.975f, 1e-4f);
    }
    EXPECT_NEAR(b2Distance(worldManifold.normal, b2Vec2(0.0f, 1.0f)), 0.0f, 1e-6f);
}

TEST(ContactManifolds, HavePointStatesForAddedAndRemovedPoints)
{
    const b2PolygonShape box = Box(1.0f, 1.0f);
    b2Manifold manifold1, manifold2;
    b2CollidePolygons(&manifold1, &box, At(0.0f, 0.0f), &box, At(0.0f, 1.9f));
    b2CollidePolygons(&manifold2, &box, At(0.0f, 0.0f), &box, At(0.0f, 3.0f));
    b2PointState state1[2], state2[2];
    b2GetPointStates(state1, state2, &manifold1, &manifold2);
    bool removed = false;
    if (state1[0] == b2_removeState)
    {
        removed = true;
    }
    EXPECT_TRUE(removed);
    b2GetPointStates(state1, state2, &manifold2, &manifold1);
    EXPECT_EQ(state2[0], b2_addState);
    b2GetPointStates(state1, state2, &manifold1, &manifold1);
    EXPECT_EQ(state1[1], b2_persistState);
    EXPECT_EQ(state2[1], b2_persistState);
}

b2Sweep Straight(const b2Vec2& from, const b2Vec2& to)
{
    b2Sweep sweep;
    sweep.c0 = from;
    sweep.c = to;
    return sweep;
}

TEST(TimeOfImpact, StopsAFastShapeAtAThinWall)
{
    const b2PolygonShape wall = Box(0.01f, 5.0f), box = Box(0.1f, 0.1f);
    b2TOIInput input;
    input.proxyA.Set(&wall, 0);
    input.proxyB.Set(&box, 0);
    input.sweepA = Straight(b2Vec2_zero, b2Vec2_zero);
    input.sweepB = Straight(b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
    input.tMax = 1.0f;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    ASSERT_EQ(output.state, b2TOIOutput::e_touching);
    EXPECT_NEAR(output.t, (10.0f - 0.11f) / 20.0f, 0.002f);
}

TEST(TimeOfImpact, MissesNothingAsAShapeCastWithoutRotation)
{
    b2CircleShape ball;
    ball.m_radius = 0.1f;
    const b2PolygonShape box = Box(0.5f, 0.5f);
    b2TOIInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&ball, 0);
    input.sweepA = Straight(b2Vec2_zero, b2Vec2_zero);
    input.tMax = 1.0f;
    for (int i = -12; i <= 12; ++i)
    {
        const float32 y = 0.05f * float32(i);
        input.sweepB = Straight(b2Vec2(-8.0f, y), b2Vec2(8.0f, y));
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        // Up to the corner the ball's edge meets the side; beyond it the ball's round counts.
        const bool meets = b2Abs(y) < 0.58f;
        const bool misses = b2Abs(y) > 0.62f;
        EXPECT_TRUE(!meets || output.state == b2TOIOutput::e_touching) << y;
        EXPECT_TRUE(!misses || output.state == b2TOIOutput::e_separated) << y;
    }
}

TEST(TimeOfImpact, ReportsATimeWithoutOverlapForAnyRotation)
{
    const b2PolygonShape rod = Box(2.0f, 0.05f), block = Box(0.5f, 0.5f);
    b2TOIInput input;
    input.proxyA.Set(&block, 0);
    input.proxyB.Set(&rod, 0);
    input.tMax = 1.0f;
    for (int i = 1; i < 20; ++i)
    {
        input.sweepB = Straight(b2Vec2(-3.0f, 1.0f), b2Vec2(1.0f, 0.0f));
        input.sweepB.a = 0.3f * float32(i);
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        b2DistanceInput distance;
        distance.proxyA = input.proxyA;
        distance.proxyB = input.proxyB;
        input.sweepB.GetTransform(&distance.transformB, output.t);
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput apart;
        b2Distance(&apart, &cache, &distance);
        EXPECT_TRUE(output.state == b2TOIOutput::e_separated || apart.distance > 0.0f) << i;
    }
}

/// Collects what a tree tells.
struct Found
{
    bool QueryCallback(int32 proxyId)
    {
        proxies.push_back(proxyId);
        return true;
    }
    float32 RayCastCallback(const b2RayCastInput& input, int32 proxyId)
    {
        proxies.push_back(proxyId);
        return input.maxFraction;
    }
    std::vector<int32> proxies;
};

TEST(DynamicTree, FindsBoxesWithUserDataByRegionAndByRay)
{
    b2DynamicTree tree;
    int data[100] = {};
    for (int i = 0; i < 100; ++i)
    {
        b2AABB box;
        box.lowerBound.Set(3.0f * float32(i), 0.0f);
        box.upperBound.Set(3.0f * float32(i) + 1.0f, 1.0f);
        const int32 proxy = tree.CreateProxy(box, &data[i]);
        EXPECT_EQ(tree.GetUserData(proxy), &data[i]);
    }
    // Boxes in a row are the degenerate order; the tree stays near the height of a full one.
    EXPECT_LE(tree.GetHeight(), 10);

    Found region;
    b2AABB aabb;
    aabb.lowerBound.Set(30.0f, 0.0f);
    aabb.upperBound.Set(36.5f, 1.0f);
    tree.Query(&region, aabb);
    EXPECT_EQ(region.proxies.size(), 3u);

    Found ray;
    b2RayCastInput input;
    input.p1.Set(60.5f, 5.0f);
    input.p2.Set(60.5f, -5.0f);
    tree.RayCast(&ray, input);
    ASSERT_EQ(ray.proxies.size(), 1u);
    EXPECT_EQ(tree.GetUserData(ray.proxies[0]), &data[20]);
}

struct Pairs
{
    void AddPair(void*, void*) { ++count; }
    int count = 0;
};

TEST(BroadPhase, ReportsOnlyThePairsWhoseBoxesOverlap)
{
    b2BroadPhase broadPhase;
    for (int i = 0; i < 50; ++i)
    {
        b2AABB box;
        box.lowerBound.Set(3.0f * float32(i / 2), 0.0f);
        box.upperBound.Set(3.0f * float32(i / 2) + 1.0f, 1.0f);
        broadPhase.CreateProxy(box, nullptr);
    }
    Pairs pairs;
    broadPhase.UpdatePairs(&pairs);
    EXPECT_EQ(pairs.count, 25);
}

} // namespace
