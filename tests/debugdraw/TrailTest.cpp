// SPDX-License-Identifier: MIT
#include <debugdraw/Trail.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace boxreel;

namespace
{

Camera TenPixelsAMeter()
{
    Camera camera;
    camera.pixelsPerMeter = 10.0;
    return camera;
}

std::vector<Vec2> Arc(int count)
{
    std::vector<Vec2> way;
    for (int i = 0; i < count; ++i)
    {
        const float angle = 2.0f * float(i) / float(count - 1);
        way.push_back({10.0f * std::cos(angle), 10.0f * std::sin(angle)});
    }
    return way;
}

DrawList TrailOf(const std::vector<Vec2>& way, const TrailSettings& settings)
{
    DrawList list;
    list.owner = 5;
    AddTrail(list, TenPixelsAMeter(), way, settings);
    return list;
}

const TrailSettings kOpaque{.oldest = 1.0};

} // namespace

TEST(Trail, GoesThroughThePlacesOfTheBody)
{
    const std::vector<Vec2> way = {{0, 0}, {3, 0}, {3, 4}, {0, 4}};
    const DrawList list = TrailOf(way, kOpaque);
    ASSERT_EQ(list.items.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(list.items[i].kind, DrawKind::Segment);
        EXPECT_EQ(list.items[i].owner, 5u);
        EXPECT_EQ(list.items[i].layer, DrawLayer::Trails);
        EXPECT_EQ(list.points[2 * i], way[i]);
        EXPECT_EQ(list.points[2 * i + 1], way[i + 1]);
    }
    EXPECT_EQ(list.layer, DrawLayer::Shapes) << "what follows is no trail";
}

TEST(Trail, OmitsInvisibleParts)
{
    EXPECT_EQ(TrailOf({{0, 0}, {1, 0}, {2, 0.001f}, {3, 0}}, kOpaque).items.size(), 1u);
    const std::vector<Vec2> arc = Arc(2000);
    const DrawList list = TrailOf(arc, kOpaque);
    EXPECT_LT(list.items.size(), 100u);
    for (const Vec2 p : list.points) // all of them places of the body
    {
        EXPECT_NEAR(std::hypot(p.x, p.y), 10.0, 1e-4);
    }
    EXPECT_EQ(list.points.front(), arc.front());
    EXPECT_EQ(list.points.back(), arc.back());
}

TEST(Trail, IsEmptyForBodyAtRest)
{
    EXPECT_TRUE(TrailOf({}, kOpaque).items.empty());
    EXPECT_TRUE(TrailOf({{1, 1}}, {}).items.empty());
    EXPECT_TRUE(TrailOf({{1, 1}, {1.05f, 1.05f}, {1, 1}}, {}).items.empty());
}

TEST(Trail, FadesTowardsItsBeginning)
{
    const DrawList list = TrailOf(Arc(200), {.color = {77, 230, 230}, .oldest = 0.25});
    ASSERT_GT(list.items.size(), 20u);
    EXPECT_NEAR(list.items.front().color.a, 64, 4);
    EXPECT_NEAR(list.items.back().color.a, 255, 4);
    for (std::size_t i = 1; i < list.items.size(); ++i)
    {
        EXPECT_GE(list.items[i].color.a, list.items[i - 1].color.a);
    }
    // Pieces keep from each other as far as their ends reach: 0.49 px at either.
    const Vec2 end = list.points[1];
    const Vec2 next = list.points[2];
    EXPECT_NEAR(std::hypot(next.x - end.x, next.y - end.y), 0.098, 0.02);
}

TEST(Trail, HasFewItemsAtAnyZoom)
{
    for (const double zoom : {1e6, 1e300, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    {
        Camera camera;
        camera.pixelsPerMeter = zoom;
        DrawList list;
        AddTrail(list, camera, std::vector<Vec2>{{0, 0}, {100, 0}, {100, 100}});
        EXPECT_LE(list.items.size(), 800u) << zoom;
    }
}

TEST(Trail, IsInterruptedWhereAPlaceIsNotFinite)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const DrawList list = TrailOf({{0, 0}, {3, 0}, {nan, 1}, {5, 0}, {9, 0}}, kOpaque);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.points[1], (Vec2{3, 0}));
    EXPECT_EQ(list.points[2], (Vec2{5, 0}));
}

TEST(Trail, HasAnotherColourThanItsNeighbour)
{
    for (std::size_t i = 0; i < 12; ++i)
    {
        EXPECT_NE(TrailColor(i), TrailColor(i + 1));
    }
}
