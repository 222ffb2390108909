// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Collision/MassProperties.h>

#include <gtest/gtest.h>

namespace
{
// Area, centroid and central inertia by Green's theorem along the outline, in long double and about
// the origin: a different way than the code's.
struct Exact
{
    long double area = 0.0L;
    long double x = 0.0L;
    long double y = 0.0L;
    long double inertia = 0.0L;
};

Exact Integrate(const b2PolygonShape& polygon)
{
    Exact sum;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        const b2Vec2 p = polygon.m_vertices[i];
        const b2Vec2 q = polygon.m_vertices[(i + 1) % polygon.m_count];
        const long double px = p.x;
        const long double py = p.y;
        const long double qx = q.x;
        const long double qy = q.y;
        const long double cross = px * qy - qx * py;
        sum.area += cross / 2.0L;
        sum.x += (px + qx) * cross / 6.0L;
        sum.y += (py + qy) * cross / 6.0L;
        sum.inertia += (px * px + px * qx + qx * qx + py * py + py * qy + qy * qy) * cross / 12.0L;
    }
    sum.x /= sum.area;
    sum.y /= sum.area;
    sum.inertia -= sum.area * (sum.x * sum.x + sum.y * sum.y);
    return sum;
}
} // namespace

TEST(Mass, IsExactForACircle)
{
    b2CircleShape circle;
    circle.m_p.Set(3.0f, -4.0f);
    circle.m_radius = 2.0f;
    b2MassData data;
    circle.ComputeMass(&data, 0.5f);
    EXPECT_FLOAT_EQ(data.mass, 2.0f * b2_pi);
    EXPECT_EQ(data.center, circle.m_p);
    EXPECT_FLOAT_EQ(data.I, data.mass * (2.0f + 25.0f)); // m r^2 / 2 + m d^2
}

TEST(Mass, IsExactForABoxFarFromTheOrigin)
{
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.25f, b2Vec2(4096.0f, -2048.0f), 0.0f);
    b2MassData data;
    box.ComputeMass(&data, 3.0f);
    EXPECT_FLOAT_EQ(data.mass, 1.5f);
    EXPECT_EQ(data.center, b2Vec2(4096.0f, -2048.0f));
    const box2d::MassProperties exact = box2d::ComputeMassProperties(box, 3.0f);
    EXPECT_DOUBLE_EQ(exact.centralInertia, 1.5 * (1.0 + 0.25) / 12.0);
}

TEST(Mass, EqualsTheIntegralForRandomPolygons)
{
    Random random(6);
    for (int i = 0; i < 5000; ++i)
    {
        b2PolygonShape polygon = random.Polygon(1.0f);
        b2Vec2 far[b2_maxPolygonVertices];
        const b2Vec2 offset = random.Point(i % 2 == 0 ? 1.0f : 1000.0f);
        for (int32 k = 0; k < polygon.m_count; ++k)
        {
            far[k] = polygon.m_vertices[k] + offset;
        }
        const int32 count = polygon.m_count;
        if (b2PolygonShape::WhyNotConvex(far, count) != nullptr)
        {
            continue;
        }
        polygon.Set(far, count);
        const Exact exact = Integrate(polygon);
        const box2d::MassProperties actual = box2d::ComputeMassProperties(polygon, 2.0f);
        const double area = static_cast<double>(exact.area);
        ASSERT_NEAR(actual.mass, 2.0 * area, 1.0e-12 * area);
        ASSERT_NEAR(actual.centerX, static_cast<double>(exact.x), 1.0e-8);
        ASSERT_NEAR(actual.centerY, static_cast<double>(exact.y), 1.0e-8);
        ASSERT_NEAR(actual.centralInertia, 2.0 * static_cast<double>(exact.inertia),
                    1.0e-7 * actual.centralInertia + 1.0e-9);
        ASSERT_NEAR(polygon.m_centroid.x, static_cast<double>(exact.x), 1.0e-4);
    }
}

TEST(Mass, IsZeroForEdges)
{
    b2EdgeShape edge;
    edge.Set(b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, 4.0f));
    b2MassData data;
    edge.ComputeMass(&data, 1.0f);
    EXPECT_EQ(data.mass, 0.0f);
    EXPECT_EQ(data.I, 0.0f);
    EXPECT_EQ(data.center, b2Vec2(1.0f, 2.0f));
}

TEST(Box, HasItsCornersCounterClockwise)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 2.0f, b2Vec2(10.0f, 0.0f), 0.5f * b2_pi);
    EXPECT_TRUE(box.Validate());
    EXPECT_NEAR(box.m_vertices[0].x, 12.0f, 1.0e-5f);
    EXPECT_NEAR(box.m_vertices[0].y, -1.0f, 1.0e-5f);
    EXPECT_NEAR(box.m_normals[0].x, 1.0f, 1.0e-6f);
    EXPECT_EQ(box.m_centroid, b2Vec2(10.0f, 0.0f));
}

TEST(Clone, IsEqualAndIndependent)
{
    b2BlockAllocator allocator;
    const b2Vec2 vs[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 1.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    chain.SetPrevVertex(b2Vec2(-1.0f, 0.0f));
    b2ChainShape* clone = static_cast<b2ChainShape*>(chain.Clone(&allocator));
    chain.Clear();
    ASSERT_EQ(clone->GetChildCount(), 2);
    EXPECT_EQ(clone->m_vertices[2], vs[2]);
    EXPECT_TRUE(clone->m_hasPrevVertex);
    EXPECT_FALSE(clone->m_hasNextVertex);
    clone->~b2ChainShape();
    allocator.Free(clone, sizeof(b2ChainShape));

    Random random(9);
    const b2PolygonShape polygon = random.Polygon(1.0f);
    b2Shape* other = polygon.Clone(&allocator);
    EXPECT_EQ(other->GetType(), b2Shape::e_polygon);
    EXPECT_EQ(static_cast<b2PolygonShape*>(other)->m_vertices[2], polygon.m_vertices[2]);
}

TEST(ChainLoop, ClosesItselfAndHasTheNeighboursOfEachEdge)
{
    const b2Vec2 vs[4] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};
    b2ChainShape loop;
    loop.CreateLoop(vs, 4);
    ASSERT_EQ(loop.GetChildCount(), 4);
    b2EdgeShape edge;
    for (int32 i = 0; i < 4; ++i)
    {
        loop.GetChildEdge(&edge, i);
        EXPECT_EQ(edge.m_vertex0, vs[(i + 3) % 4]);
        EXPECT_EQ(edge.m_vertex1, vs[i]);
        EXPECT_EQ(edge.m_vertex2, vs[(i + 1) % 4]);
        EXPECT_EQ(edge.m_vertex3, vs[(i + 2) % 4]);
        EXPECT_TRUE(edge.m_hasVertex0 && edge.m_hasVertex3);
    }
}

#if BOXREEL_ASSERTS
TEST(ChainDeathTest, NamesWhatIsWrongWithVertices)
{
    const b2Vec2 vs[3] = {{0.0f, 0.0f}, {0.001f, 0.0f}, {2.0f, 0.0f}};
    b2ChainShape chain;
    EXPECT_DEATH(chain.CreateChain(vs, 3), "b2_linearSlop apart");
    EXPECT_DEATH(chain.CreateChain(vs, 1), "at least 2");
}
#else
TEST(Chain, LeavesOutVerticesThatAreTooCloseOrNotFinite)
{
    const float nan = std::nanf("");
    const b2Vec2 vs[5] = {{0.0f, 0.0f}, {0.001f, 0.0f}, {2.0f, 0.0f}, {nan, 1.0f}, {0.0f, 0.001f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    EXPECT_EQ(chain.GetChildCount(), 1);
    chain.Clear();
    chain.CreateLoop(vs, 5);
    EXPECT_EQ(chain.GetChildCount(), 0); // two vertices are left
    chain.CreateChain(vs, 1);
    EXPECT_EQ(chain.GetChildCount(), 0);
    b2EdgeShape edge;
    chain.GetChildEdge(&edge, 0);
    EXPECT_EQ(edge.m_vertex1, b2Vec2_zero);
}
#endif
