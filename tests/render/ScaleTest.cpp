// SPDX-License-Identifier: MIT
#include "Pictures.h"

#include <random>

// A picture at scale 8, averaged down, is the reference for scale 1. Every length in pixels is
// eight times as large, and each pixel becomes 64.
using namespace boxreel;

namespace
{

constexpr int kScale = 8;
constexpr int kWidth = 320;
constexpr int kHeight = 240;

Frame DrawScaled(const DrawList& list, double scale, const Theme& theme = Theme::Classic())
{
    const Camera camera = Scaled(PixelCamera(kWidth, kHeight), scale);
    RendererSettings settings;
    settings.width = camera.width;
    settings.height = camera.height;
    settings.theme = theme;
    settings.scale = scale;
    Result<Renderer> renderer = Renderer::Create(settings);
    EXPECT_TRUE(renderer) << renderer.GetError().Text();
    return DrawWith(*renderer, list, camera);
}

struct ScaleError
{
    double rms = 0.0; ///< over red, green and blue of the pixels whose 64 are not all alike, of 255
    double maximum = 0.0;
    std::size_t edgePixels = 0;
};

ScaleError CompareScales(const DrawList& list, const char* what)
{
    const Frame small = DrawScaled(list, 1.0);
    const Frame large = DrawScaled(list, kScale);
    ScaleError error;
    double squares = 0.0;
    for (int y = 0; y < kHeight; ++y)
    {
        for (int x = 0; x < kWidth; ++x)
        {
            std::array<double, 3> mean{};
            bool edge = false;
            const std::uint8_t* const first = large.Pixel(kScale * x, kScale * y);
            for (int k = 0; k < kScale * kScale; ++k)
            {
                const std::uint8_t* const p =
                    large.Pixel(kScale * x + k % kScale, kScale * y + k / kScale);
                edge = edge || !std::equal(p, p + 3, first);
                for (std::size_t c = 0; c < 3; ++c)
                {
                    mean[c] += p[c] / double(kScale * kScale);
                }
            }
            error.edgePixels += edge;
            for (std::size_t c = 0; c < 3; ++c)
            {
                const double difference = std::abs(small.Pixel(x, y)[c] - mean[c]);
                error.maximum = std::max(error.maximum, difference);
                squares += edge ? difference * difference : 0.0;
            }
        }
    }
    error.rms = std::sqrt(squares / double(3 * error.edgePixels));
    EXPECT_GT(error.edgePixels, 500u) << what;
    std::printf("%-24s rms %.2f, most %.1f of 255, on %zu edge pixels\n", what, error.rms,
                error.maximum, error.edgePixels);
    return error;
}

/// Every kind of shape, none over another.
DrawList Shapes(bool withAxes)
{
    std::mt19937 random(11);
    const auto between = [&](float a, float b) {
        return a + (b - a) * float(random() % 10000u) / 10000.0f;
    };
    DrawList list;
    for (int i = 0; i < 48; ++i)
    {
        const Vec2 at{20.0f + 40.0f * float(i % 8) + between(-1, 1),
                      20.0f + 40.0f * float(i / 8) + between(-1, 1)};
        const float angle = between(0, 6);
        const Vec2 axis{std::cos(angle), std::sin(angle)};
        switch (i % 6)
        {
        case 0:
            AddTurnedBox(list, at, between(3, 12), between(3, 12), angle, kAwake);
            break;
        case 1:
            list.AddSolidCircle(at, between(3, 15), axis, kKinematic);
            break;
        case 2:
            AddRegular(list, at, between(4, 16), between(4, 16), 3 + i % 5, angle, kStatic);
            break;
        case 3:
            list.AddCircle(at, between(3, 15), kAwake);
            break;
        case 4:
            list.AddPoint(at, between(2, 9), kWhite);
            break;
        default:
            withAxes ? list.AddTransform(at, axis, between(8, 16))
                     : list.AddSolidCircle(at, between(3, 15), axis, kWhite);
        }
    }
    return list;
}

DrawList Labels(const char* text)
{
    DrawList list;
    for (int i = 0; i < 8; ++i)
    {
        list.AddText({10.0f, 230.0f - 28.0f * float(i)}, text, kWhite);
    }
    return list;
}

} // namespace

TEST(Scale, AveragesFromEightDownToOne)
{
    const ScaleError shapes = CompareScales(Shapes(false), "shapes");
    EXPECT_LE(shapes.rms, 1.1);
    EXPECT_LE(shapes.maximum, 20.0);
    const ScaleError axes = CompareScales(Shapes(true), "shapes and axes");
    EXPECT_LE(axes.rms, 1.3) << "lines end squarely at scale 1, and round when they are thick";
}

// Where two outlines cover the same part of a pixel, drawing one over the other covers more of it
// than it should. Their parts count as independent (Porter and Duff, "Compositing Digital Images",
// 1984).
TEST(Scale, DrawsAbuttingOutlinesHeavierAtOne)
{
    DrawList list;
    for (int i = 0; i < 100; ++i)
    {
        const float x = 20.0f + 28.3f * float(i % 10);
        const float y = 12.0f + 21.7f * float(i / 10);
        AddRectangle(list, x, y, x + 28.3f, y + 21.7f, kAwake);
    }
    const ScaleError error = CompareScales(list, "abutting boxes");
    EXPECT_LE(error.rms, 20.0);
    EXPECT_LE(error.maximum, 60.0);
}

// At scale 1 letters are drawn for whole pixels and stand on them, at scale 8 eight times finer.
TEST(Scale, ShiftsTextOnlyByPixelRounding)
{
    DrawList list;
    list.AddText({20.0f, 200.0f}, "W", kWhite);
    const Frame small = DrawScaled(list, 1.0);
    const Frame large = DrawScaled(list, kScale);
    const auto inkOf = [](const Frame& frame) {
        double ink = 0.0;
        double x = 0.0;
        double y = 0.0;
        for (int i = 0; i < frame.width * frame.height; ++i)
        {
            const double here = frame.rgba[std::size_t(i) * 4] - 26.0;
            ink += here;
            x += here * (i % frame.width + 0.5);
            y += here * (i / frame.width + 0.5);
        }
        return std::array{ink, x / ink, y / ink};
    };
    const auto [inkOne, xOne, yOne] = inkOf(small);
    const auto [inkEight, xEight, yEight] = inkOf(large);
    EXPECT_NEAR(inkEight / (kScale * kScale) / inkOne, 1.0, 0.05) << "as bold";
    EXPECT_NEAR(xEight / kScale, xOne, 0.5);
    EXPECT_NEAR(yEight / kScale, yOne, 0.5);

    // The font's rasteriser takes curves as lines that are up to 0.35 px off, at either scale.
    EXPECT_LE(CompareScales(Labels("HAVE XYZ, FLEW VIA WYK LINE"), "straight letters").rms, 3.0);
    EXPECT_LE(CompareScales(Labels("Body 1234567890 at rest"), "text").rms, 20.0);
}

TEST(Scale, MultipliesOutlinesPointsAndLetters)
{
    DrawList list;
    AddRectangle(list, 40, 40, 280, 200, kAwake);
    list.AddPoint({160, 120}, 8.0f, kWhite);
    const Frame large = DrawScaled(list, 4.0);
    // The left edge at 160, an outline of 5 px: 157.5 to 162.5.
    EXPECT_EQ(At(large, 156, 480), (Pixel{26, 26, 26, 255}));
    EXPECT_EQ(At(large, 158, 480), (Pixel{230, 179, 179, 255}));
    EXPECT_EQ(At(large, 161, 480), (Pixel{230, 179, 179, 255}));
    EXPECT_NE(At(large, 163, 480), (Pixel{230, 179, 179, 255}));
    // The point is 32 px wide.
    EXPECT_EQ(At(large, 640 + 14, 480), (Pixel{255, 255, 255, 255}));
    EXPECT_NE(At(large, 640 + 17, 480), (Pixel{255, 255, 255, 255}));
}

TEST(Scale, IsRefusedOutOfRange)
{
    for (const double scale : {0.0, -1.0, 0.09, 16.1, std::nan("")})
    {
        const Result<Renderer> renderer =
            Renderer::Create({.width = 8, .height = 8, .scale = scale});
        ASSERT_FALSE(renderer) << scale;
        EXPECT_EQ(renderer.GetError().kind, ErrorKind::Unusable);
        EXPECT_FALSE(Hud::Create(320, 240, scale)) << scale;
    }
}

TEST(Scale, EnlargesPanels)
{
    const HudContent content{"Title", {{"time", "1.500 s"}, {"bodies", "12"}}};
    Result<Hud> small = Hud::Create(320, 240);
    Result<Hud> large = Hud::Create(640, 480, 2.0);
    ASSERT_TRUE(small && large);
    const auto corner = [](const Overlay& overlay) {
        Vec2 farthest;
        for (const OverlayVertex& vertex : overlay.vertices)
        {
            farthest = {std::max(farthest.x, vertex.position.x),
                        std::max(farthest.y, vertex.position.y)};
        }
        return farthest;
    };
    const Vec2 once = corner(small->Build(content));
    const Vec2 twice = corner(large->Build(content));
    EXPECT_NEAR(twice.x, 2.0f * once.x, 2.0f);
    EXPECT_NEAR(twice.y, 2.0f * once.y, 2.0f);
}

TEST(Scale, KeepsTheViewOfACamera)
{
    Camera camera = PixelCamera(321, 7);
    camera.pixelsPerMeter = 3.0;
    EXPECT_EQ(Scaled(camera, 1.0), camera);
    const Camera twice = Scaled(camera, 2.0);
    EXPECT_EQ(twice.width, 642);
    EXPECT_EQ(twice.VisibleArea(), camera.VisibleArea());
    EXPECT_EQ(Scaled(camera, 0.1).width, 32) << "32.1 is rounded";
    EXPECT_EQ(Scaled(camera, 0.05).height, 1) << "never nothing";
}
