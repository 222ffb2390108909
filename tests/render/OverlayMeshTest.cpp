// SPDX-License-Identifier: MIT
#include "OverlayMesh.h"

#include "Pictures.h"

using namespace boxreel;

namespace
{

constexpr int kTextureWidth = 512;
constexpr int kTextureHeight = 256;
constexpr PixelBounds kPicture{0, 0, 8192, 8192};

OverlayMesh MeshOf(const Overlay& overlay, std::vector<PixelBounds> rectangles = {kPicture})
{
    OverlayMesh mesh;
    BuildMesh(overlay, rectangles, kTextureWidth, kTextureHeight, mesh);
    return mesh;
}

Overlay Triangle(std::array<OverlayVertex, 3> corners)
{
    Overlay overlay;
    overlay.vertices.assign(corners.begin(), corners.end());
    overlay.indices = {0, 1, 2};
    overlay.commands.push_back({0, 3, 0, 0, 8192, 8192});
    return overlay;
}

/// The computation of the shader, in the arithmetic of a register of 32 bits.
int Evaluate(std::int32_t at, std::int32_t alongX, std::int32_t alongY, int x, int y, int bits)
{
    const std::uint32_t sum = std::uint32_t(at) + std::uint32_t(alongX) * std::uint32_t(x) +
                              std::uint32_t(alongY) * std::uint32_t(y);
    return std::int32_t(sum) >> bits;
}

int Ink(const MeshCorner& c, std::size_t channel, int x, int y)
{
    return Evaluate(c.ink[channel], c.inkX[channel], c.inkY[channel], x, y, kInkBits);
}

int Texel(const MeshCorner& c, std::size_t axis, int x, int y)
{
    return Evaluate(c.texel[axis], c.texel[2 + axis], c.texelY[axis], x, y, kTexelBits);
}

} // namespace

TEST(OverlayMesh, HasOneColourForTriangleOfOneColour)
{
    const Color color{200, 100, 50, 77};
    const OverlayMesh mesh = MeshOf(
        Triangle({{{{1.3f, 2.7f}, {}, color}, {{90.1f, 3}, {}, color}, {{5, 70}, {}, color}}}));
    ASSERT_EQ(mesh.corners.size(), 3u);
    for (const auto& [x, y] : {std::pair{2, 3}, {40, 10}, {8191, 8191}})
    {
        EXPECT_EQ(Ink(mesh.corners[0], 0, x, y), 60); // 200 * 77 / 255 = 60.4
        EXPECT_EQ(Ink(mesh.corners[0], 1, x, y), 30); // 30.2
        EXPECT_EQ(Ink(mesh.corners[0], 2, x, y), 15); // 15.1
        EXPECT_EQ(Ink(mesh.corners[0], 3, x, y), 77);
    }
}

TEST(OverlayMesh, FindsEachTexelOfALetterAtAnyPlace)
{
    for (const float offset : {0.0f, 0.25f, 0.4f, 0.5f})
    {
        for (const int at : {0, 517, 8170})
        {
            // 11 x 14 texels from (300, 200).
            const Vec2 low{float(at) + offset, float(at)};
            const Vec2 high{low.x + 11.0f, low.y + 14.0f};
            const Vec2 uv{300.0f / kTextureWidth, 200.0f / kTextureHeight};
            const Vec2 uvEnd{311.0f / kTextureWidth, 214.0f / kTextureHeight};
            const OverlayMesh mesh = MeshOf(Triangle({{{low, uv, kWhite},
                                                       {{high.x, low.y}, {uvEnd.x, uv.y}, kWhite},
                                                       {high, uvEnd, kWhite}}}));
            for (int x = 0; x < 11; ++x)
            {
                ASSERT_EQ(Texel(mesh.corners.at(0), 0, at + x, at), 300 + x) << offset << ' ' << at;
            }
            for (int y = 0; y < 14; ++y)
            {
                ASSERT_EQ(Texel(mesh.corners.at(0), 1, at, at + y), 200 + y) << offset << ' ' << at;
            }
        }
    }
}

TEST(OverlayMesh, InterpolatesColoursLinearly)
{
    std::mt19937 random(5);
    const auto below = [&](unsigned end) { return float(random() % (end * 256u)) / 256.0f; };
    for (int round = 0; round < 2000; ++round)
    {
        std::array<OverlayVertex, 3> v;
        const float extent = round % 2 == 0 ? 8.0f : 3000.0f;
        const Vec2 from{below(5000), below(5000)};
        for (OverlayVertex& corner : v)
        {
            corner.position = {from.x + below(unsigned(extent)), from.y + below(unsigned(extent))};
            corner.color = {255, 255, 255, std::uint8_t(random() % 256u)};
        }
        const auto cross = [&](Vec2 a, Vec2 b, double x, double y) {
            return (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
        };
        const double area = cross(v[0].position, v[1].position, v[2].position.x, v[2].position.y);
        if (std::abs(area) < 1.0)
        {
            continue;
        }
        const OverlayMesh mesh = MeshOf(Triangle(v));
        for (int k = 0; k < 20; ++k)
        {
            const int x = int(from.x + below(unsigned(extent)));
            const int y = int(from.y + below(unsigned(extent)));
            double alpha = 0.0;
            double minimum = 1.0;
            for (std::size_t i = 0; i < 3; ++i)
            {
                const double share =
                    cross(v[(i + 1) % 3].position, v[(i + 2) % 3].position, x + 0.5, y + 0.5) /
                    area;
                alpha += share * v[i].color.a;
                minimum = std::min(minimum, share);
            }
            if (minimum >= 0.0) // inside
            {
                ASSERT_NEAR(Ink(mesh.corners.at(0), 3, x, y), alpha, 0.51) << round;
                ASSERT_NEAR(Ink(mesh.corners.at(0), 0, x, y), alpha, 0.51) << "premultiplied";
            }
        }
    }
}

TEST(OverlayMesh, LeavesOutWhatCannotBeSeen)
{
    const auto at = [](Vec2 a, Vec2 b, Vec2 c) {
        return MeshOf(Triangle({{{a, {}, kWhite}, {b, {}, kWhite}, {c, {}, kWhite}}}),
                      {{0, 0, 20, 20}, {40, 0, 60, 20}});
    };
    EXPECT_EQ(at({2, 2}, {9, 2}, {2, 9}).corners.size(), 3u);
    EXPECT_EQ(at({2, 2}, {50, 2}, {2, 9}).corners.size(), 6u) << "in both rectangles";
    EXPECT_EQ(at({2, 2}, {50, 2}, {2, 9}).runs.size(), 2u);
    EXPECT_TRUE(at({25, 2}, {35, 2}, {30, 9}).runs.empty()) << "between them";
    EXPECT_TRUE(at({2, 2}, {9, 9}, {5, 5}).runs.empty()) << "no inside";
    EXPECT_TRUE(at({2, 2}, {INFINITY, 9}, {5, 5}).runs.empty());
    EXPECT_TRUE(at({2, 2}, {NAN, 9}, {5, 5}).runs.empty());
    EXPECT_EQ(at({-1e30f, -1e30f}, {1e30f, -1e30f}, {0, 1e30f}).corners.size(), 6u);
}

TEST(OverlayMesh, IsLimitedByTheRectanglesAndTheCommands)
{
    Overlay overlay =
        Triangle({{{{0, 0}, {}, kWhite}, {{90, 0}, {}, kWhite}, {{0, 90}, {}, kWhite}}});
    overlay.commands = {{0, 3, 10, 12, 30, 40}, {0, 3, 0, 0, 0, 0}};
    const OverlayMesh mesh = MeshOf(overlay, {{20, 0, 64, 20}, {0, 30, 64, 64}});
    ASSERT_EQ(mesh.runs.size(), 2u);
    EXPECT_EQ(mesh.runs[0].bounds, (PixelBounds{20, 12, 30, 20}));
    EXPECT_EQ(mesh.runs[1].bounds, (PixelBounds{10, 30, 30, 40}));
    EXPECT_EQ(mesh.runs[1].first, 3u);
    EXPECT_EQ(mesh.runs[1].count, 3u);
}
