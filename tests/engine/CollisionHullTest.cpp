// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
std::vector<b2Vec2> RegularPolygon(int32 count, float radius)
{
    std::vector<b2Vec2> points;
    for (int32 i = 0; i < count; ++i)
    {
        points.push_back(
            radius *
            b2Rot(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(count)).GetXAxis());
    }
    return points;
}

b2PolygonShape MakePolygon(const std::vector<b2Vec2>& points)
{
    b2PolygonShape polygon;
    polygon.Set(points.data(), static_cast<int32>(points.size()));
    return polygon;
}

std::string Why(const std::vector<b2Vec2>& points)
{
    const char* why =
        b2PolygonShape::WhyNotConvex(points.data(), static_cast<int32>(points.size()));
    return why == nullptr ? "" : why;
}
} // namespace

TEST(Hull, IsTheSameForEveryOrderOfThePoints)
{
    std::vector<b2Vec2> points = RegularPolygon(6, 1.0f);
    const b2PolygonShape expected = MakePolygon(points);
    ASSERT_EQ(expected.GetVertexCount(), 6);
    Random random(4);
    for (int round = 0; round < 500; ++round)
    {
        for (int32 i = 5; i > 0; --i)
        {
            std::swap(points[static_cast<std::size_t>(i)],
                      points[static_cast<std::size_t>(random.Integer(0, i))]);
        }
        const b2PolygonShape polygon = MakePolygon(points);
        ASSERT_EQ(polygon.GetVertexCount(), 6);
        for (int32 i = 0; i < 6; ++i)
        {
            ASSERT_EQ(polygon.GetVertex(i), expected.GetVertex(i));
        }
        ASSERT_TRUE(polygon.Validate());
    }
}

TEST(Hull, ContainsAllPointsAndHasOnlyPointsOfTheInput)
{
    Random random(5);
    for (int round = 0; round < 5000; ++round)
    {
        std::vector<b2Vec2> points;
        const int32 count = random.Integer(3, b2_maxPolygonVertices);
        const float size = std::pow(10.0f, random.Real(-1.5f, 2.0f));
        const b2Vec2 origin = random.Point(round % 2 == 0 ? 0.0f : 1000.0f);
        for (int32 i = 0; i < count; ++i)
        {
            points.push_back(origin + random.Point(size));
        }
        if (!Why(points).empty())
        {
            continue;
        }
        const b2PolygonShape polygon = MakePolygon(points);
        ASSERT_TRUE(polygon.Validate());
        for (const b2Vec2& p : points)
        {
            for (int32 i = 0; i < polygon.m_count; ++i)
            {
                // A point that sticks out was welded, or the hull is too flat there.
                const double height =
                    Dot(ToVec(polygon.m_normals[i]), ToVec(p) - ToVec(polygon.m_vertices[i]));
                ASSERT_LE(height, 1.01 * b2_linearSlop);
            }
        }
        for (int32 i = 0; i < polygon.m_count; ++i)
        {
            ASSERT_NE(std::find(points.begin(), points.end(), polygon.m_vertices[i]), points.end());
        }
    }
}

TEST(Hull, LeavesOutDuplicatesCollinearAndInnerPoints)
{
    const b2PolygonShape polygon = MakePolygon({{0.0f, 0.0f},
                                                {1.0f, 0.0f},
                                                {0.5f, 0.0f},
                                                {1.0f, 1.0f},
                                                {1.0f, 1.001f},
                                                {0.0f, 1.0f},
                                                {0.5f, 0.5f},
                                                {0.0f, 0.0f}});
    ASSERT_EQ(polygon.GetVertexCount(), 4);
    EXPECT_EQ(polygon.GetVertex(0), b2Vec2(1.0f, 0.0f));
    EXPECT_EQ(polygon.GetVertex(1), b2Vec2(1.0f, 1.0f));
    EXPECT_EQ(polygon.GetVertex(2), b2Vec2(0.0f, 1.0f));
    EXPECT_EQ(polygon.GetVertex(3), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(polygon.m_normals[0], b2Vec2(1.0f, 0.0f));
}

TEST(Hull, WeldsBelowTheSlopAndNotAboveIt)
{
    const float below = 0.9f * b2_linearSlop;
    const float above = 1.1f * b2_linearSlop;
    EXPECT_EQ(MakePolygon({{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, below}, {0.0f, 1.0f}}).m_count, 3);
    EXPECT_EQ(MakePolygon({{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, above}, {0.0f, 1.0f}}).m_count, 4);
}

TEST(Hull, AcceptsShapesOfACentimetre)
{
    const b2PolygonShape polygon = MakePolygon(RegularPolygon(8, 0.01f));
    EXPECT_EQ(polygon.m_count, 8);
    EXPECT_TRUE(polygon.Validate());
}

TEST(WhyNotConvex, NamesWhatIsWrong)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(Why({{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}}), "");
    EXPECT_NE(Why({{0.0f, 0.0f}, {1.0f, 0.0f}}).find("at least 3"), std::string::npos);
    EXPECT_NE(Why(RegularPolygon(9, 1.0f)).find("at most"), std::string::npos);
    EXPECT_NE(Why({{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}}).find("one line"), std::string::npos);
    EXPECT_NE(Why({{0.0f, 0.0f}, {1.0f, nan}, {2.0f, 0.0f}}).find("finite"), std::string::npos);
    EXPECT_NE(b2PolygonShape::WhyNotConvex(nullptr, 3), nullptr);
}

#if BOXREEL_ASSERTS
TEST(HullDeathTest, NamesWhatIsWrongWithDegeneratePoints)
{
    EXPECT_DEATH(MakePolygon({{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}}), "one line");
    b2PolygonShape polygon;
    EXPECT_DEATH(polygon.SetAsBox(0.0f, 1.0f), "positive");
}
#else
TEST(Hull, IsABoxForDegeneratePoints)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<b2Vec2>> cases = {{},
                                                    {{1.0f, 1.0f}},
                                                    {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}},
                                                    {{nan, nan}, {nan, 0.0f}, {0.0f, nan}},
                                                    RegularPolygon(20, 1.0f)};
    for (const std::vector<b2Vec2>& points : cases)
    {
        const b2PolygonShape polygon = MakePolygon(points);
        EXPECT_EQ(polygon.m_count, 4);
        EXPECT_TRUE(polygon.Validate());
    }
    b2PolygonShape polygon;
    for (const float size : {0.0f, -1.0f, nan, std::numeric_limits<float>::infinity()})
    {
        polygon.SetAsBox(size, 1.0f);
        EXPECT_TRUE(polygon.Validate());
        polygon.SetAsBox(1.0f, size, b2Vec2(nan, 0.0f), nan);
        EXPECT_TRUE(polygon.Validate());
    }
}
#endif
