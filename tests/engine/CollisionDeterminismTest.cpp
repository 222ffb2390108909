// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Collision/b2TimeOfImpact.h>
#include <Collision/MassProperties.h>

#include <gtest/gtest.h>

#include <bit>

/// One hash of many results for each part. It detects another compiler, optimisation level or
/// machine with different results. An intended change of the results changes the numbers here.
namespace
{
class Hash
{
public:
    void Add(std::uint64_t value) { m_value = (m_value ^ value) * 1099511628211u; }
    void Add(float value) { Add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value))); }
    void Add(const b2Vec2& v)
    {
        Add(v.x);
        Add(v.y);
    }
    void Add(const b2Manifold& m)
    {
        Add(static_cast<std::uint64_t>(m.pointCount));
        if (m.pointCount > 0)
        {
            Add(static_cast<std::uint64_t>(m.type));
            Add(m.localNormal);
            Add(m.localPoint);
        }
        for (int32 i = 0; i < m.pointCount; ++i)
        {
            Add(m.points[i].localPoint);
            Add(static_cast<std::uint64_t>(m.points[i].id.key));
        }
    }
    std::uint64_t Value() const { return m_value; }

private:
    std::uint64_t m_value = 14695981039346656037u;
};
} // namespace

TEST(Collision, GivesTheSameManifoldsToTheBit)
{
    Random random(81);
    Hash hash;
    for (int i = 0; i < 20000; ++i)
    {
        const b2PolygonShape a = random.Polygon(1.0f);
        const b2PolygonShape b = random.Polygon(1.0f);
        b2CircleShape circle;
        circle.m_radius = random.Real(0.1f, 1.0f);
        b2EdgeShape edge;
        edge.m_vertex1 = random.Point(1.0f);
        edge.m_vertex2 = random.Point(1.0f);
        edge.m_vertex0 = random.Point(2.0f);
        edge.m_vertex3 = random.Point(2.0f);
        edge.m_hasVertex0 = i % 2 == 0;
        edge.m_hasVertex3 = i % 3 == 0;
        const b2Transform xfA = random.Transform(1.0f);
        const b2Transform xfB = random.Transform(1.0f);
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &a, xfA, &b, xfB);
        hash.Add(manifold);
        b2CollidePolygonAndCircle(&manifold, &a, xfA, &circle, xfB);
        hash.Add(manifold);
        b2CollideEdgeAndPolygon(&manifold, &edge, xfA, &b, xfB);
        hash.Add(manifold);
        b2CollideEdgeAndCircle(&manifold, &edge, xfA, &circle, xfB);
        hash.Add(manifold);
    }
    EXPECT_EQ(hash.Value(), 654408181072957852u);
}

TEST(Collision, GivesTheSameDistancesImpactsAndMassesToTheBit)
{
    Random random(82);
    Hash hash;
    for (int i = 0; i < 3000; ++i)
    {
        const std::unique_ptr<b2Shape> a = random.Shape(1.0f);
        const std::unique_ptr<b2Shape> b = random.Shape(1.0f);
        b2DistanceInput input;
        input.proxyA.Set(a.get(), 0);
        input.proxyB.Set(b.get(), 0);
        input.transformA = random.Transform(2.0f);
        input.transformB = random.Transform(2.0f);
        b2SimplexCache cache;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        hash.Add(output.distance);
        hash.Add(output.pointA);
        hash.Add(output.pointB);

        b2TOIInput impact;
        impact.proxyA = input.proxyA;
        impact.proxyB = input.proxyB;
        impact.sweepA.c = random.Point(2.0f);
        impact.sweepA.a = random.Real(-1.0f, 1.0f);
        impact.sweepB.c0 = random.Point(3.0f);
        impact.sweepB.c = random.Point(3.0f);
        b2TOIOutput time;
        b2TimeOfImpact(&time, &impact);
        hash.Add(static_cast<std::uint64_t>(time.state));
        hash.Add(time.t);

        const box2d::MassProperties mass = box2d::ComputeMassProperties(*a, 1.5f);
        hash.Add(std::bit_cast<std::uint64_t>(mass.mass));
        hash.Add(std::bit_cast<std::uint64_t>(mass.centerX));
        hash.Add(std::bit_cast<std::uint64_t>(mass.centralInertia));
    }
    EXPECT_EQ(hash.Value(), 17329439337926011232u);
}

TEST(Collision, VisitsATreeInTheSameOrder)
{
    Random random(83);
    Hash hash;
    b2DynamicTree tree;
    for (int32 i = 0; i < 5000; ++i)
    {
        b2AABB box;
        box.lowerBound = random.Point(50.0f);
        box.upperBound = box.lowerBound + b2Abs(random.Point(2.0f));
        if (i % 3 == 2)
        {
            tree.SetProxyAABB(0, box);
        }
        tree.CreateProxyExact(box, i);
        const auto visit = [&](int32 proxyId) {
            hash.Add(static_cast<std::uint64_t>(proxyId));
            return true;
        };
        tree.ForEachOverlap(box, visit);
    }
    tree.RebuildBottomUp();
    hash.Add(tree.GetAreaRatio());
    EXPECT_EQ(hash.Value(), 3685673961665218393u);
}
