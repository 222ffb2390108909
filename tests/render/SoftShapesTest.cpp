// SPDX-License-Identifier: MIT
#include "SoftShapes.h"

#include "Pictures.h"

using namespace boxreel;

namespace
{

constexpr Vec2 kUv{0.5f, 0.25f};
constexpr int kSize = 64;

/// The sum of a picture's opacity, in pixels, of white shapes on black.
double AreaOf(Overlay overlay)
{
    Result<Hud> hud = Hud::Create(64, 64); // whose ground has a white texel
    EXPECT_TRUE(hud);
    const Vec2 white = hud->Build({}).vertices.front().uv;
    for (OverlayVertex& vertex : overlay.vertices)
    {
        vertex.uv = white;
    }
    overlay.commands.push_back({0, std::uint32_t(overlay.indices.size()), 0, 0, kSize, kSize});
    Theme black;
    black.background = {0, 0, 0, 255};
    Renderer renderer = MakeRenderer(kSize, kSize, black);
    const Frame frame = DrawWith(renderer, {}, PixelCamera(kSize, kSize), &overlay);
    double sum = 0.0;
    for (int i = 0; i < kSize * kSize; ++i)
    {
        sum += At(frame, i % kSize, i / kSize)[0] / 255.0;
    }
    return sum;
}

std::vector<Vec2> Circle(Vec2 center, float radius, int count)
{
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i)
    {
        const float t = 6.2831853f * float(i) / float(count);
        points.push_back({center.x + radius * std::cos(t), center.y + radius * std::sin(t)});
    }
    return points;
}

} // namespace

TEST(SoftShapes, HaveTheirCornersOnTheGrid)
{
    EXPECT_EQ(OnGrid({100.49999f, -3.0001f}), (Vec2{100.5f, -3.0f}));
    EXPECT_EQ(OnGrid({1.0f / 3.0f, 8191.999f}), (Vec2{85.0f / 256.0f, 8192.0f}));
    Overlay overlay;
    AppendPolygon(Circle({20.3f, 20.7f}, 11.1f, 17), kWhite, kUv, overlay);
    AppendLine(Circle({40.1f, 30.2f}, 9.9f, 13), true, 2.0, kWhite, kUv, overlay);
    EXPECT_EQ(overlay.vertices.size(), 17u * 2 + 13u * 4);
    for (const OverlayVertex& v : overlay.vertices)
    {
        EXPECT_EQ(OnGrid(v.position), v.position);
        EXPECT_EQ(v.uv, kUv);
    }
}

TEST(SoftShapes, CoverTheAreaOfThePolygon)
{
    for (const int corners : {3, 4, 5, 12, 40})
    {
        const std::vector<Vec2> points = Circle({31.4f, 32.2f}, 20.0f, corners);
        Overlay overlay;
        AppendPolygon(points, kWhite, kUv, overlay);
        const double area = 0.5 * corners * 400.0 * std::sin(2.0 * 3.14159265 / corners);
        EXPECT_NEAR(AreaOf(overlay), area, 0.004 * area) << corners;
        Overlay turnedRound;
        AppendPolygon(std::vector<Vec2>(points.rbegin(), points.rend()), kWhite, kUv, turnedRound);
        EXPECT_NEAR(AreaOf(turnedRound), area, 0.004 * area) << "whichever way round";
    }
}

TEST(SoftShapes, CoverTheAreaOfTheLine)
{
    const std::vector<Vec2> points{{10.3f, 12.1f}, {30.9f, 20.7f}, {50.2f, 50.5f}};
    const double length = std::hypot(20.6, 8.6) + std::hypot(19.3, 29.8);
    for (const double width : {1.0, 2.0, 3.7})
    {
        Overlay overlay;
        AppendLine(points, false, width, kWhite, kUv, overlay);
        EXPECT_NEAR(AreaOf(overlay), width * length, 0.02 * width * length) << width;
    }
    Overlay closed;
    AppendLine(Circle({32.0f, 32.0f}, 20.0f, 60), true, 1.0, kWhite, kUv, closed);
    EXPECT_NEAR(AreaOf(closed), 2.0 * 3.14159265 * 20.0, 1.5);
}

TEST(SoftShapes, LeaveARectangleOfWholePixelsCrisp)
{
    const std::vector<Vec2> points{{10, 10}, {30, 10}, {30, 25}, {10, 25}};
    Overlay overlay;
    AppendPolygon(points, kWhite, kUv, overlay);
    EXPECT_EQ(AreaOf(overlay), 20.0 * 15.0);
}

TEST(SoftShapes, DrawNothingOfWhatHasNoInsideOrNoLength)
{
    Overlay overlay;
    AppendPolygon({}, kWhite, kUv, overlay);
    AppendPolygon(std::vector<Vec2>{{1, 1}, {9, 9}}, kWhite, kUv, overlay);
    AppendPolygon(std::vector<Vec2>{{1, 1}, {5, 5}, {9, 9}}, kWhite, kUv, overlay);
    AppendPolygon(std::vector<Vec2>{{1, 1}, {9, 1}, {9, 1.001f}, {1, 1}}, kWhite, kUv, overlay);
    AppendLine({}, false, 1.0, kWhite, kUv, overlay);
    AppendLine(std::vector<Vec2>{{4, 4}, {4, 4.001f}, {4, 4}}, true, 1.0, kWhite, kUv, overlay);
    EXPECT_EQ(overlay, Overlay());
}
