// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
// Grazing hits within this distance are not compared [m].
constexpr double kGrazing = 1.0e-4;

struct Hit
{
    bool isHit = false;
    bool isClear = true; ///< not grazing, not starting or ending on the surface
    double fraction = 2.0;
    Vec normal;
};

// The ray against each side by itself, in double precision.
Hit CastAgainstSides(const std::vector<Vec>& v, bool isClosed, Vec p1, Vec p2)
{
    Hit hit;
    const Vec d = p2 - p1;
    const double length = Length(d);
    const std::size_t sides = isClosed ? v.size() : v.size() - 1;
    bool isInside = isClosed;
    for (std::size_t i = 0; i < sides; ++i)
    {
        const Vec a = v[i];
        const Vec e = v[(i + 1) % v.size()] - a;
        const double heightOfP1 = Cross(e, p1 - a) / Length(e);
        isInside = isInside && heightOfP1 > 0.0;
        // A ray close to an end of a side, or that starts near it, is not clear.
        hit.isClear = hit.isClear && std::fabs(Cross(d, a - p1)) / length > kGrazing &&
                      std::fabs(Cross(d, a + e - p1)) / length > kGrazing &&
                      std::fabs(heightOfP1) > kGrazing &&
                      std::fabs(Cross(e, p2 - a)) / Length(e) > kGrazing;
        const double t = Cross(a - p1, e) / Cross(d, e);
        const double s = Cross(a - p1, d) / Cross(d, e);
        if (t >= 0.0 && t <= 1.0 && s >= 0.0 && s <= 1.0 && t < hit.fraction)
        {
            hit.isHit = true;
            hit.fraction = t;
            hit.normal = Unit({e.y, -e.x});
        }
    }
    hit.isHit = hit.isHit && !isInside;
    return hit;
}

void ExpectSame(const Hit& expected, bool isHit, const b2RayCastOutput& output, double length)
{
    ASSERT_EQ(isHit, expected.isHit);
    if (isHit)
    {
        ASSERT_NEAR(output.fraction * length, expected.fraction * length, 2.0e-4);
        ASSERT_NEAR(output.normal.x, expected.normal.x, 1.0e-4);
        ASSERT_NEAR(output.normal.y, expected.normal.y, 1.0e-4);
    }
}
} // namespace

TEST(RayCast, HitsAPolygonWhereItHitsTheFirstSide)
{
    Random random(11);
    int compared = 0;
    int hits = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const b2PolygonShape polygon = random.Polygon(2.0f);
        const b2Transform xf = random.Transform(5.0f);
        const b2RayCastInput input = {xf.p + random.Point(6.0f), xf.p + random.Point(6.0f), 1.0f};
        std::vector<Vec> v;
        for (int32 k = 0; k < polygon.m_count; ++k)
        {
            v.push_back(Transformed(xf, polygon.m_vertices[k]));
        }
        const Hit expected = CastAgainstSides(v, true, ToVec(input.p1), ToVec(input.p2));
        if (!expected.isClear)
        {
            continue;
        }
        b2RayCastOutput output;
        const bool isHit = polygon.RayCast(&output, input, xf, 0);
        ExpectSame(expected, isHit, output, Length(ToVec(input.p2) - ToVec(input.p1)));
        ++compared;
        hits += isHit ? 1 : 0;
        const bool isInside = polygon.TestPoint(xf, input.p1);
        bool isExpectedInside = true;
        for (std::size_t k = 0; k < v.size(); ++k)
        {
            isExpectedInside = isExpectedInside &&
                               Cross(v[(k + 1) % v.size()] - v[k], ToVec(input.p1) - v[k]) > 0.0;
        }
        ASSERT_EQ(isInside, isExpectedInside);
    }
    EXPECT_GT(compared, 19000);
    EXPECT_GT(hits, 2000);
}

TEST(RayCast, HitsBothSidesOfAnEdgeWithAnOpposingNormal)
{
    Random random(12);
    int hits = 0;
    for (int i = 0; i < 20000; ++i)
    {
        b2EdgeShape edge;
        edge.m_vertex1 = random.Point(3.0f);
        edge.m_vertex2 = random.Point(3.0f);
        const b2Transform xf = random.Transform(3.0f);
        const b2RayCastInput input = {xf.p + random.Point(4.0f), xf.p + random.Point(4.0f), 1.0f};
        Hit expected =
            CastAgainstSides({Transformed(xf, edge.m_vertex1), Transformed(xf, edge.m_vertex2)},
                             false, ToVec(input.p1), ToVec(input.p2));
        if (!expected.isClear || b2Distance(edge.m_vertex1, edge.m_vertex2) < 0.1f)
        {
            continue;
        }
        if (Dot(expected.normal, ToVec(input.p2) - ToVec(input.p1)) > 0.0)
        {
            expected.normal = -1.0 * expected.normal;
        }
        b2RayCastOutput output;
        const bool isHit = edge.RayCast(&output, input, xf, 0);
        ExpectSame(expected, isHit, output, Length(ToVec(input.p2) - ToVec(input.p1)));
        hits += isHit ? 1 : 0;
        ASSERT_FALSE(edge.TestPoint(xf, input.p1));
    }
    EXPECT_GT(hits, 2000);
}

TEST(RayCast, HitsACircleAtTheRootOfTheQuadratic)
{
    Random random(13);
    int hits = 0;
    for (int i = 0; i < 20000; ++i)
    {
        b2CircleShape circle;
        circle.m_p = random.Point(1.0f);
        circle.m_radius = random.Real(0.1f, 2.0f);
        const b2Transform xf = random.Transform(3.0f);
        const b2RayCastInput input = {xf.p + random.Point(5.0f), xf.p + random.Point(5.0f), 1.0f};
        const Vec s = ToVec(input.p1) - Transformed(xf, circle.m_p);
        const Vec d = ToVec(input.p2) - ToVec(input.p1);
        const double r = circle.m_radius;
        const double miss = std::fabs(Cross(s, d)) / Length(d);
        const double t =
            (-Dot(s, d) - std::sqrt(std::max(0.0, r * r * Dot(d, d) - Cross(s, d) * Cross(s, d)))) /
            Dot(d, d);
        const double slack = kGrazing / Length(d);
        if (std::fabs(miss - r) < 1.0e-3 || std::fabs(t) < slack || std::fabs(t - 1.0) < slack)
        {
            continue;
        }
        const Hit expected = {miss < r && t >= 0.0 && t <= 1.0, true, t, Unit(s + t * d)};
        b2RayCastOutput output;
        const bool isHit = circle.RayCast(&output, input, xf, 0);
        ExpectSame(expected, isHit, output, Length(d));
        hits += isHit ? 1 : 0;
        ASSERT_EQ(circle.TestPoint(xf, input.p1), Length(s) <= r);
    }
    EXPECT_GT(hits, 2000);
}

TEST(RayCast, NeverPassesBetweenTheEdgesOfAChain)
{
    Random random(14);
    b2Vec2 vs[50];
    for (int32 i = 0; i < 50; ++i)
    {
        vs[i].Set(0.1f * static_cast<float>(i) - 2.5f, random.Real(-0.1f, 0.1f));
    }
    b2ChainShape chain;
    chain.CreateChain(vs, 50);
    for (int i = 0; i < 20000; ++i)
    {
        const b2Transform xf(random.Point(10.0f), b2Rot(0.0f));
        // Aimed at a vertex, exactly where rounding could miss both edges.
        const b2Vec2 target = b2Mul(xf, vs[random.Integer(1, 48)]);
        const b2Vec2 d(random.Real(-0.05f, 0.05f), -1.0f);
        const b2RayCastInput input = {target - d, target + d, 1.0f};
        bool isHit = false;
        for (int32 k = 0; k < chain.GetChildCount(); ++k)
        {
            b2RayCastOutput output;
            isHit = chain.RayCast(&output, input, xf, k) || isHit;
        }
        ASSERT_TRUE(isHit);
    }
}

TEST(RayCast, HitsABoxOfATreeOnlyFromOutside)
{
    b2AABB box;
    box.lowerBound.Set(-1.0f, -2.0f);
    box.upperBound.Set(1.0f, 2.0f);
    b2RayCastOutput output;
    EXPECT_TRUE(box.RayCast(&output, {{-3.0f, 0.0f}, {1.0f, 0.0f}, 1.0f}));
    EXPECT_FLOAT_EQ(output.fraction, 0.5f);
    EXPECT_EQ(output.normal, b2Vec2(-1.0f, 0.0f));
    EXPECT_TRUE(box.RayCast(&output, {{0.0f, 6.0f}, {0.0f, -2.0f}, 1.0f}));
    EXPECT_EQ(output.normal, b2Vec2(0.0f, 1.0f));
    EXPECT_FALSE(box.RayCast(&output, {{0.0f, 0.0f}, {5.0f, 0.0f}, 1.0f}));
    EXPECT_FALSE(box.RayCast(&output, {{-3.0f, 0.0f}, {1.0f, 0.0f}, 0.4f}));
    EXPECT_FALSE(box.RayCast(&output, {{-3.0f, 3.0f}, {3.0f, 3.0f}, 1.0f}));
}

TEST(Aabb, IncludesTheSkinOfAShape)
{
    Random random(15);
    for (int i = 0; i < 2000; ++i)
    {
        const b2PolygonShape polygon = random.Polygon(1.0f);
        const b2Transform xf = random.Transform(10.0f);
        b2AABB box;
        polygon.ComputeAABB(&box, xf, 0);
        ASSERT_TRUE(box.IsValid());
        float right = -b2_maxFloat;
        for (int32 k = 0; k < polygon.m_count; ++k)
        {
            right = b2Max(right, b2Mul(xf, polygon.m_vertices[k]).x);
        }
        ASSERT_FLOAT_EQ(box.upperBound.x, right + polygon.m_radius);
    }
}

TEST(Aabb, CombinesContainsAndOverlaps)
{
    b2AABB a;
    a.lowerBound.Set(0.0f, 0.0f);
    a.upperBound.Set(2.0f, 1.0f);
    b2AABB b;
    b.lowerBound.Set(2.0f, 1.0f);
    b.upperBound.Set(3.0f, 4.0f);
    EXPECT_TRUE(b2TestOverlap(a, b)); // they touch
    b2AABB both;
    both.Combine(a, b);
    EXPECT_TRUE(both.Contains(a) && both.Contains(b));
    EXPECT_FALSE(a.Contains(both));
    EXPECT_FLOAT_EQ(both.GetPerimeter(), 14.0f);
    b.lowerBound.x = 2.1f;
    EXPECT_FALSE(b2TestOverlap(a, b));
    a.lowerBound.x = 5.0f;
    EXPECT_FALSE(a.IsValid());
}
