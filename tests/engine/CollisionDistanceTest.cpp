// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2Distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
constexpr double kRounding = 2.0e-5;

std::vector<Vec> Corners(const b2DistanceProxy& proxy, const b2Transform& xf)
{
    std::vector<Vec> corners;
    for (int32 i = 0; i < proxy.m_count; ++i)
    {
        corners.push_back(Transformed(xf, proxy.m_vertices[i]));
    }
    return corners;
}

double FromPointToSegment(Vec p, Vec a, Vec b)
{
    const Vec e = b - a;
    const double ee = Dot(e, e);
    const double t = ee > 0.0 ? std::clamp(Dot(p - a, e) / ee, 0.0, 1.0) : 0.0;
    return Length(p - (a + t * e));
}

bool IsInside(Vec p, const std::vector<Vec>& polygon)
{
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Vec e = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (Cross(e, p - polygon[i]) < 0.0)
        {
            return false;
        }
    }
    return polygon.size() >= 3;
}

bool Cross4(Vec a, Vec b, Vec c, Vec d)
{
    return Cross(b - a, c - a) * Cross(b - a, d - a) < 0.0 &&
           Cross(d - c, a - c) * Cross(d - c, b - c) < 0.0;
}

// Every corner against every side.
double PlainDistance(const std::vector<Vec>& a, const std::vector<Vec>& b)
{
    if (IsInside(a[0], b) || IsInside(b[0], a))
    {
        return 0.0;
    }
    double minimum = 1.0e30;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const Vec a1 = a[i];
            const Vec a2 = a[(i + 1) % a.size()];
            const Vec b1 = b[j];
            const Vec b2 = b[(j + 1) % b.size()];
            if (Cross4(a1, a2, b1, b2))
            {
                return 0.0;
            }
            minimum =
                std::min({minimum, FromPointToSegment(a1, b1, b2), FromPointToSegment(b1, a1, a2)});
        }
    }
    return minimum;
}

b2DistanceInput MakeInput(const b2Shape& a, const b2Shape& b, Random& random, float reach)
{
    b2DistanceInput input;
    input.proxyA.Set(&a, 0);
    input.proxyB.Set(&b, 0);
    input.transformA = random.Transform(reach);
    input.transformB = random.Transform(reach);
    return input;
}
} // namespace

TEST(Distance, EqualsTheMinimumOverAllCornersAndSides)
{
    Random random(21);
    int apart = 0;
    for (int i = 0; i < 30000; ++i)
    {
        const std::unique_ptr<b2Shape> a = random.Shape(1.0f);
        const std::unique_ptr<b2Shape> b = random.Shape(1.0f);
        const b2DistanceInput input = MakeInput(*a, *b, random, 2.0f);
        b2SimplexCache cache;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        const double expected = PlainDistance(Corners(input.proxyA, input.transformA),
                                              Corners(input.proxyB, input.transformB));
        ASSERT_NEAR(output.distance, expected, kRounding) << i;
        ASSERT_NEAR(b2Distance(output.pointA, output.pointB), expected, kRounding) << i;
        ASSERT_LE(output.iterations, 12) << i;
        apart += expected > 0.0 ? 1 : 0;
    }
    EXPECT_GT(apart, 10000);
    EXPECT_LT(apart, 29000);
}

TEST(Distance, IsTheSameWithAWarmCacheWhileShapesMove)
{
    Random random(22);
    int64_t cold = 0;
    int64_t warm = 0;
    for (int i = 0; i < 1000; ++i)
    {
        const std::unique_ptr<b2Shape> a = random.Shape(1.0f);
        const std::unique_ptr<b2Shape> b = random.Shape(1.0f);
        b2DistanceInput input = MakeInput(*a, *b, random, 2.0f);
        b2SimplexCache kept;
        for (int step = 0; step < 20; ++step)
        {
            input.transformB.p += random.Point(0.02f);
            b2SimplexCache fresh;
            b2DistanceOutput output;
            b2DistanceOutput expected;
            b2Distance(&expected, &fresh, &input);
            b2Distance(&output, &kept, &input);
            ASSERT_NEAR(output.distance, expected.distance, kRounding);
            cold += expected.iterations;
            warm += output.iterations;
        }
    }
    EXPECT_LT(warm, cold);
}

TEST(Distance, IsMeasuredFromTheSkinsWithRadii)
{
    b2CircleShape a;
    a.m_radius = 0.5f;
    b2CircleShape b;
    b.m_radius = 0.25f;
    b2DistanceInput input;
    input.proxyA.Set(&a, 0);
    input.proxyB.Set(&b, 0);
    input.transformB.p.Set(2.0f, 0.0f);
    input.useRadii = true;
    b2SimplexCache cache;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    EXPECT_FLOAT_EQ(output.distance, 1.25f);
    EXPECT_EQ(output.pointA, b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(output.pointB, b2Vec2(1.75f, 0.0f));
    input.transformB.p.Set(0.7f, 0.0f);
    b2Distance(&output, &cache, &input);
    EXPECT_EQ(output.distance, 0.0f);
}

TEST(DistanceProxy, KeepsTheVerticesOfAnEdgeWhenCopied)
{
    b2EdgeShape edge;
    edge.Set(b2Vec2(1.0f, 2.0f), b2Vec2(3.0f, 4.0f));
    auto proxy = std::make_unique<b2DistanceProxy>();
    proxy->Set(&edge, 0);
    const b2DistanceProxy copy = *proxy;
    proxy.reset();
    EXPECT_EQ(copy.GetVertex(1), b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(copy.GetSupportVertex(b2Vec2(-1.0f, 0.0f)), b2Vec2(1.0f, 2.0f));
}

TEST(Distance, IsRightForTheClosingEdgeOfAChain)
{
    const b2Vec2 vs[3] = {{0.0f, 0.0f}, {4.0f, 0.0f}, {0.0f, 3.0f}};
    b2ChainShape loop;
    loop.CreateLoop(vs, 3);
    b2CircleShape point;
    b2DistanceInput input;
    input.proxyA.Set(&loop, 2);
    input.proxyB.Set(&point, 0);
    input.transformB.p.Set(-1.0f, 1.0f);
    b2SimplexCache cache;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    EXPECT_FLOAT_EQ(output.distance, 1.0f);
}

TEST(OverlapTest, AgreesWithTheDistance)
{
    Random random(23);
    int overlaps = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const std::unique_ptr<b2Shape> a = random.Shape(1.0f);
        const std::unique_ptr<b2Shape> b = random.Shape(1.0f);
        const b2DistanceInput input = MakeInput(*a, *b, random, 1.5f);
        const double gap = PlainDistance(Corners(input.proxyA, input.transformA),
                                         Corners(input.proxyB, input.transformB)) -
                           a->m_radius - b->m_radius;
        if (std::fabs(gap) < kRounding)
        {
            continue;
        }
        const bool isOverlap =
            b2TestOverlap(a.get(), 0, b.get(), 0, input.transformA, input.transformB);
        ASSERT_EQ(isOverlap, gap < 0.0) << i;
        overlaps += isOverlap ? 1 : 0;
    }
    EXPECT_GT(overlaps, 1000);
}
