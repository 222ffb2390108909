// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <debugdraw/DrawCollector.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace
{

std::string svg; // what the listing writes

void Write(const char* format, double a, double b, double c, double d)
{
    char text[200];
    std::snprintf(text, sizeof text, format, a, b, c, d);
    svg += text;
}

// [draw]
/// Shapes as elements of an SVG, in metres.
class SvgDraw : public b2Draw
{
public:
    void DrawPolygon(const b2Vec2* points, int32 count, const b2Color&) override
    {
        for (int32 i = 0; i < count; ++i)
        {
            Line(points[i], points[(i + 1) % count]);
        }
    }
    void DrawSolidPolygon(const b2Vec2* points, int32 count, const b2Color& color) override
    {
        DrawPolygon(points, count, color);
    }
    void DrawCircle(const b2Vec2& center, float32 radius, const b2Color&) override
    {
        Write("<circle cx='%.3g' cy='%.3g' r='%.3g'/>\n", center.x, -center.y, radius, 0.0);
    }
    void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                         const b2Color& color) override
    {
        DrawCircle(center, radius, color);
        Line(center, center + radius * axis); // so that one sees it turn
    }
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color&) override { Line(p1, p2); }
    void DrawTransform(const b2Transform& xf) override
    {
        Line(xf.p, xf.p + 0.4f * xf.q.GetXAxis());
        Line(xf.p, xf.p + 0.4f * xf.q.GetYAxis());
    }

private:
    void Line(const b2Vec2& a, const b2Vec2& b)
    {
        Write("<line x1='%.3g' y1='%.3g' x2='%.3g' y2='%.3g'/>\n", a.x, -a.y, b.x, -b.y);
    }
};
// [/draw]

int Count(const std::string& text, const std::string& what)
{
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    {
        ++count;
    }
    return count;
}

TEST(DebugDrawingListing, DrawsAWorld)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Box(0.0f, 1.0f);
    stage.Ball(3.0f, 1.0f);
    svg.clear();
    // [use]
    SvgDraw draw;
    draw.SetFlags(b2Draw::e_shapeBit | b2Draw::e_jointBit);
    world.SetDebugDraw(&draw); // has to live as long as it is registered
    world.DrawDebugData();     // calls back, once
    // [/use]
    EXPECT_EQ(Count(svg, "<line"), 5);
    EXPECT_EQ(Count(svg, "<circle"), 1);
    EXPECT_THAT(svg, testing::HasSubstr("<circle cx='3' cy='-1' r='0.5'/>"));

    svg.clear();
    // [view]
    draw.SetView(b2Vec2(2.0f, 0.0f), b2Vec2(12.0f, 6.0f)); // lower left and upper right corner [m]
    world.DrawDebugData();
    // [/view]
    EXPECT_EQ(Count(svg, "<line"), 1) << "the ball alone";
    world.SetDebugDraw(nullptr);
}

TEST(DebugDrawingListing, CollectsAWorld)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Box(0.0f, 1.0f);
    stage.Ball(3.0f, 1.0f);
    // [collect]
    boxreel::DrawList list = boxreel::DrawListOf(world, b2Draw::e_shapeBit);
    const auto ofFirstBody = [](const boxreel::DrawItem& item) { return item.owner == 0; };
    // [/collect]
    EXPECT_EQ(list.items.size(), 2u);
    EXPECT_EQ(std::count_if(list.items.begin(), list.items.end(), ofFirstBody), 1);
}

} // namespace
