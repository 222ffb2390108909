// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "Pictures.h"

#include <limits>
#include <thread>

using namespace boxreel;

namespace
{

const Pixel kGround{26, 26, 26, 255};

} // namespace

TEST(Renderer, PaintsAnAlignedBoxInExactColours)
{
    Theme theme = Theme::Classic();
    theme.outlineWidth = 2.0f;
    DrawList list;
    AddRectangle(list, 10, 10, 30, 20, kAwake); // pixel rows 20 to 29 of 40
    const Frame frame = Picture(list, 40, 40, theme);

    EXPECT_EQ(At(frame, 8, 25), kGround);
    EXPECT_EQ(At(frame, 9, 25), (Pixel{230, 179, 179, 255})) << "the outline lies half outside";
    EXPECT_EQ(At(frame, 10, 25), (Pixel{230, 179, 179, 255})) << "and half inside";
    // Half the colour at half opacity over the ground: 230/4 + 26/2 = 70.5, 179/4 + 13 = 57.75.
    const Pixel inside = At(frame, 11, 25);
    EXPECT_NEAR(inside[0], 70.5, 0.51);
    EXPECT_NEAR(inside[1], 57.75, 0.51);
    EXPECT_EQ(inside[3], 255);
    EXPECT_EQ(At(frame, 28, 25), inside);
    EXPECT_EQ(At(frame, 30, 25), (Pixel{230, 179, 179, 255}));
    EXPECT_EQ(At(frame, 31, 25), kGround);
    EXPECT_EQ(At(frame, 20, 18), kGround) << "world y points up, rows run down";
    EXPECT_EQ(At(frame, 20, 19), (Pixel{230, 179, 179, 255}));
    EXPECT_EQ(At(frame, 20, 30), (Pixel{230, 179, 179, 255}));
    EXPECT_EQ(At(frame, 20, 31), kGround);
}

TEST(Renderer, DrawsInTheColoursOfItsTheme)
{
    Theme theme = Theme::Print();
    theme.outlineWidth = 2.0f;
    DrawList list;
    AddRectangle(list, 10, 10, 30, 20, kAwake);
    AddRectangle(list, 10, 30, 30, 36,
                 {250, 240, 120, 255}); // the user's own, hardly seen on white
    list.AddTransform({34, 10}, {1, 0}, 4);
    const Frame frame = Picture(list, 40, 40, theme);

    EXPECT_EQ(At(frame, 5, 5), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(At(frame, 9, 25), (Pixel{166, 60, 44, 255}));
    const Pixel inside = At(frame, 20, 25); // 0.22 of (166, 60, 44) over white
    EXPECT_NEAR(inside[0], 255 - 0.22 * (255 - 166), 1.0);
    EXPECT_NEAR(inside[1], 255 - 0.22 * (255 - 60), 1.0);
    const Color outline = theme.Outline({250, 240, 120, 255});
    EXPECT_EQ(At(frame, 9, 7), (Pixel{outline.r, outline.g, outline.b, 255}));
    EXPECT_NEAR(At(frame, 20, 7)[2], 255 - 0.22 * (255 - 120), 1.0) << "its fill is kept";
    EXPECT_EQ(At(frame, 36, 29), (Pixel{198, 40, 40, 255}));
}

TEST(Renderer, DividesAPixelBetweenFillAndOutline)
{
    Theme theme = Theme::Classic();
    theme.outlineWidth =
        1.0f; // half of it in pixel 10, a quarter pixel's worth on either side of 10.25
    DrawList list;
    AddRectangle(list, 10.25f, 10, 30, 30, kWhite);
    const Frame frame = Picture(list, 40, 40, theme);
    EXPECT_NEAR(At(frame, 9, 20)[0], 0.25 * 255 + 0.75 * 26, 0.51);
    const double fill = 0.25 * 255 + 0.5 * 26;
    EXPECT_NEAR(At(frame, 10, 20)[0], 0.75 * 255 + 0.25 * fill, 0.51);
    EXPECT_NEAR(At(frame, 11, 20)[0], fill, 0.51);
}

TEST(Renderer, KeepsPaintersOrderAcrossKinds)
{
    const Vec2 triangle[3] = {{5, 5}, {45, 5}, {25, 45}};
    using Add = void (*)(DrawList&, const Vec2*);
    const std::pair<Add, Color> shapes[] = {
        {[](DrawList& list, const Vec2*) {
             AddRectangle(list, 5, 5, 45, 45, {200, 0, 0, 255});
         },
         {200, 0, 0, 255}},
        {[](DrawList& list, const Vec2*) {
             list.AddSolidCircle({25, 25}, 20, {0, 1}, {0, 200, 0, 255});
         },
         {0, 200, 0, 255}},
        {[](DrawList& list, const Vec2* t) {
             list.AddSolidPolygon(t, 3, {0, 0, 200, 255});
         },
         {0, 0, 200, 255}}};
    Theme opaque = Theme::Classic();
    opaque.fillAlpha = 1.0f;
    for (int first = 0; first < 3; ++first)
    {
        for (int second = 0; second < 3; ++second)
        {
            for (int third = 0; third < 3; ++third)
            {
                DrawList list;
                for (const int i : {first, second, third})
                {
                    shapes[i].first(list, triangle);
                }
                const Color top = shapes[third].second;
                EXPECT_EQ(At(Picture(list, 50, 50, opaque), 20, 28),
                          (Pixel{top.r / 2, top.g / 2, top.b / 2, 255}))
                    << first << second << third;
            }
        }
    }
}

TEST(Renderer, LeavesPremultipliedColoursOnAClearGround)
{
    Theme theme = Theme::Classic();
    theme.background = {255, 255, 255, 0};
    DrawList list;
    AddRectangle(list, 10, 10, 30, 30, {200, 100, 40, 255});
    const Frame frame = Picture(list, 40, 40, theme);
    EXPECT_EQ(At(frame, 2, 2), (Pixel{0, 0, 0, 0}));
    const Pixel fill = At(frame, 20, 20);
    EXPECT_NEAR(fill[3], 127.5, 0.51);
    EXPECT_NEAR(fill[0], 50, 0.51);
    EXPECT_NEAR(fill[1], 25, 0.51);
    EXPECT_NEAR(fill[2], 10, 0.51);
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        ASSERT_LE(frame.rgba[i], frame.rgba[i + 3]);
    }
}

TEST(Renderer, DrawsAxesInRedAndGreen)
{
    DrawList list;
    list.AddTransform({20, 20}, {1, 0}, 15);
    const Frame frame = Picture(list, 40, 40);
    const Pixel right = At(frame, 28, 20);
    const Pixel up = At(frame, 20, 12);
    EXPECT_GT(right[0], right[1] + 60);
    EXPECT_GT(up[1], up[0] + 60);
    EXPECT_EQ(At(frame, 12, 20), kGround);
    EXPECT_EQ(At(frame, 20, 28), kGround);
}

TEST(Renderer, GivesTheSameBitsEveryTime)
{
    const DrawList list = Everything();
    const Frame first = Picture(list, 320, 240);
    const Frame second = Picture(list, 320, 240);
    EXPECT_TRUE(first == second);
}

TEST(Renderer, WorksBesideAnotherAndInAnotherThread)
{
    Renderer a = MakeRenderer(320, 240);
    Renderer b = MakeRenderer(160, 120);
    Frame fromA;
    ASSERT_TRUE(a.Submit(Everything(), PixelCamera(320, 240)));
    const Frame fromB =
        DrawWith(b, Everything(2), PixelCamera(160, 120)); // between the other's two halves
    ASSERT_TRUE(a.Read(fromA));
    EXPECT_TRUE(fromA == Picture(Everything(), 320, 240));
    EXPECT_TRUE(fromB == Picture(Everything(2), 160, 120));

    Frame fromThread;
    std::thread([&] { fromThread = Picture(Everything(), 320, 240); }).join();
    EXPECT_TRUE(fromThread == fromA);
}

TEST(Renderer, IsMovable)
{
    Renderer first = MakeRenderer(320, 240);
    ASSERT_TRUE(first.Submit(Everything(), PixelCamera(320, 240)));
    Renderer second = std::move(first);
    Frame frame;
    ASSERT_TRUE(second.Read(frame));
    EXPECT_TRUE(frame == Picture(Everything(), 320, 240));
    second = MakeRenderer(20, 20);
    EXPECT_EQ(DrawWith(second, {}, PixelCamera(20, 20)).width, 20);
}

TEST(Renderer, SkipsWhatLiesOutsideWithoutChangingAPixel)
{
    DrawList inside;
    AddTurnedBox(inside, {20, 20}, 6, 4, 0.4f, kAwake);
    DrawList all = inside;
    for (const Vec2 at : {Vec2{-30, 20}, Vec2{70, 20}, Vec2{20, -30}, Vec2{20, 70}})
    {
        AddTurnedBox(all, at, 6, 4, 0.4f, kStatic);
        all.AddSolidCircle(at, 8, {1, 0}, kStatic);
        AddRegular(all, at, 8, 8, 5, 0, kStatic);
        all.AddPoint(at, 10, kStatic);
        all.AddSegment(at, {at.x * 1.5f - 10, at.y * 1.5f - 10}, kStatic);
        all.AddText({at.x < 0 ? -100.0f : at.x, at.y < 0 ? -1.0f : at.y + 20}, "out", kStatic);
    }
    Renderer renderer = MakeRenderer(40, 40);
    const Frame frame = DrawWith(renderer, all, PixelCamera(40, 40));
    EXPECT_EQ(renderer.Statistics().itemsDrawn, 1u);
    EXPECT_EQ(renderer.Statistics().itemsOutside, all.items.size() - 1);
    EXPECT_TRUE(frame == Picture(inside, 40, 40));
}

TEST(Renderer, DrawsBordersAsInALargerPicture)
{
    // Rows of shapes, each a little farther across a border than the one before.
    Renderer large = MakeRenderer(96, 96);
    Renderer renderer = MakeRenderer(64, 64);
    Camera camera = PixelCamera(64, 64);
    Camera wide = PixelCamera(96, 96);
    wide.centerX = wide.centerY = 32;
    for (int i = 0; i < 48; ++i)
    {
        const float at = -5.0f + 0.21f * float(i);
        DrawList list;
        AddTurnedBox(list, {at, 16}, 3, 2, 0.5f, kWhite);
        list.AddSolidCircle({16, at}, 3, {0, 1}, kWhite);
        AddRegular(list, {64 - at, 16}, 3, 3, 5, 0.3f, kWhite);
        list.AddSegment({48, 64 - at}, {50, 66 - at}, kWhite);
        list.AddPoint({30, 64 - at}, 4, kWhite);
        AddTurnedBox(list, {64 - at, 40}, 0.4f, 0.3f, 0.5f, kWhite);
        list.AddText({at - 3, 60}, "W", kWhite);
        const Frame frame = DrawWith(renderer, list, camera);
        const Frame around = DrawWith(large, list, wide);
        for (int y = 0; y < 64; ++y)
        {
            for (int x = 0; x < 64; ++x)
            {
                // One of 255 for numbers that are rounded elsewhere.
                ASSERT_NEAR(At(frame, x, y)[0], At(around, x + 16, y + 16)[0], 1)
                    << x << ", " << y << ", " << i;
            }
        }
    }
}

TEST(Renderer, DrawsVisiblePartOfHugeShapes)
{
    // Edges through the picture's middle, the rest up to a hundred thousand kilometres away.
    for (const float size : {1e3f, 1e5f, 1e8f})
    {
        DrawList box;
        AddRectangle(box, 20, -size, 20 + 2 * size, size, kWhite);
        DrawList small;
        AddRectangle(small, 20, -100, 120, 100, kWhite);
        EXPECT_TRUE(Picture(box, 40, 40) == Picture(small, 40, 40)) << size;

        DrawList line;
        line.AddSegment({-size, 20}, {size, 20}, kWhite);
        DrawList shortLine;
        shortLine.AddSegment({-50, 20}, {90, 20}, kWhite);
        EXPECT_TRUE(Picture(line, 40, 40) == Picture(shortLine, 40, 40)) << size;
    }
}

TEST(Renderer, SurvivesDegenerateAndEndlessShapes)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float endless = std::numeric_limits<float>::infinity();
    DrawList list;
    const Vec2 point[4] = {{20, 20}, {20, 20}, {20, 20}, {20, 20}};
    const Vec2 flat[3] = {{10, 10}, {20, 20}, {30, 30}};
    list.AddSolidPolygon(point, 4, kWhite);
    list.AddSolidPolygon(flat, 3, kWhite);
    list.AddPolygon(point, 1, kWhite);
    list.AddSegment(point[0], point[0], kWhite);
    list.AddSolidCircle({20, 20}, 0, {0, 0}, kWhite);
    list.AddPoint({20, 20}, 0, kWhite);
    list.AddTransform({20, 20}, {0, 0}, 1);
    list.AddText({20, 20}, "", kWhite);
    list.AddText({20, 20}, "\xff\xfe\n\t", kWhite);
    for (const float bad : {nan, endless, -endless})
    {
        list.AddSegment({bad, 0}, {1, 1}, kWhite);
        list.AddSolidCircle({20, 20}, bad, {1, 0}, kWhite);
        list.AddPoint({20, bad}, 3, kWhite);
        list.AddText({bad, bad}, "x", kWhite);
    }
    const float maximum = std::numeric_limits<float>::max();
    list.AddSegment({-maximum, -maximum}, {maximum, maximum}, kWhite);
    AddRectangle(list, -maximum, -maximum, maximum, maximum, kWhite);
    list.AddCircle({maximum, maximum}, maximum, kWhite);
    const Frame frame = Picture(list, 40, 40);
    // The diagonal through (20, 20) is drawn, and no pixel is what no blending of grey and white
    // can be.
    EXPECT_GT(At(frame, 14, 25)[0], 100);
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        ASSERT_GE(frame.rgba[i], 26);
        ASSERT_EQ(frame.rgba[i + 3], 255);
    }
}

TEST(Renderer, DrawsPicturesOfAnySize)
{
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 7}, {3, 1}, {333, 77}, {641, 359}, {8192, 2}, {2, 8192}})
    {
        DrawList list;
        AddRectangle(list, -10, -10, float(width) + 10, float(height) + 10, kWhite);
        list.AddText({0, float(height)}, "text", kWhite);
        const Frame frame = Picture(list, width, height);
        ASSERT_EQ(frame.width, width);
        ASSERT_EQ(frame.height, height);
        const Pixel last = At(frame, width - 1, height - 1);
        EXPECT_NEAR(last[0], 0.25 * 255 + 13, 0.51) << width << "x" << height;
        EXPECT_EQ(last[3], 255);
    }
}

TEST(Renderer, PlacesShapesExactlyAtTheFarEndOfALargePicture)
{
    DrawList list;
    AddRectangle(list, 8180, 2, 8190, 6, kWhite);
    Theme theme = Theme::Classic();
    theme.outlineWidth = 2.0f;
    const Frame frame = Picture(list, 8192, 8, theme);
    EXPECT_EQ(At(frame, 8178, 4), kGround);
    EXPECT_EQ(At(frame, 8179, 4)[0], 255);
    EXPECT_EQ(At(frame, 8190, 4)[0], 255);
    EXPECT_EQ(At(frame, 8191, 4), kGround);
}

TEST(Renderer, RefusesSizesOutOfRange)
{
    for (const auto& [width, height] :
         {std::pair{0, 10}, {10, 0}, {-5, 10}, {8193, 10}, {10, 100000}})
    {
        RendererSettings settings;
        settings.width = width;
        settings.height = height;
        EXPECT_THAT(Renderer::Create(settings),
                    Refuses("size " + std::to_string(width) + "x" + std::to_string(height)));
    }
}

TEST(Renderer, RefusesACameraThatDoesNotFit)
{
    Renderer renderer = MakeRenderer(40, 30);
    EXPECT_THAT(renderer.Submit({}, PixelCamera(41, 30)), RefusesWith("camera", "41x30"));
    for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    {
        Camera camera = PixelCamera(40, 30);
        camera.pixelsPerMeter = scale;
        EXPECT_FALSE(renderer.Submit({}, camera));
    }
}

TEST(Renderer, RefusesOverflowingViewAndDrawsNextOne)
{
    DrawList list;
    const Vec2 corners[3] = {{-1, -1}, {3, 0}, {0, 2}};
    list.AddSolidPolygon(corners, 3, kWhite);
    list.AddSolidCircle({1, 1}, 2, {1, 0}, kWhite);
    list.AddSegment({0, 0}, {5, 1}, kWhite);
    list.AddTransform({0, 0}, {1, 0}, 1);
    list.AddText({0, 0}, "here", kWhite);
    const float maximum = std::numeric_limits<float>::max();
    list.AddSolidCircle({maximum, -maximum}, maximum, {1, 0}, kWhite);
    list.AddSegment({-maximum, 0}, {maximum, maximum}, kWhite);
    Renderer renderer = MakeRenderer(40, 30);
    Camera camera = PixelCamera(40, 30);
    camera.centerY = 0.0;
    for (const auto& [center, scale] : {std::pair(1e30, 1e290), {1e30, 1.0}, {0.0, 1e16}})
    {
        camera.centerX = center;
        camera.pixelsPerMeter = scale;
        const Result<void> drawn = renderer.Submit(list, camera);
        ASSERT_FALSE(drawn) << center << " " << scale;
        EXPECT_EQ(drawn.GetError().kind, ErrorKind::Unusable);
    }
    for (const auto& [center, scale] : {std::pair(0.0, 1e15), {-1.0, 1e15}, {1e30, 1e-300}})
    {
        camera.centerX = center;
        camera.pixelsPerMeter = scale;
        EXPECT_TRUE(renderer.Submit(list, camera)) << center << " " << scale;
    }
}

TEST(Renderer, ShowsUnchangedFrameWithoutDrawing)
{
    Renderer renderer = MakeRenderer(320, 240);
    DrawList list = Everything();
    const Camera camera = PixelCamera(320, 240);
    const Frame first = DrawWith(renderer, list, camera);
    EXPECT_FALSE(renderer.Statistics().unchanged);
    EXPECT_TRUE(DrawWith(renderer, list, camera) == first);
    EXPECT_TRUE(renderer.Statistics().unchanged);

    list.points[5].x += 3.0f;
    const Frame moved = DrawWith(renderer, list, camera);
    EXPECT_FALSE(renderer.Statistics().unchanged);
    EXPECT_FALSE(moved == first);
    EXPECT_TRUE(moved == Picture(list, 320, 240));

    Camera other = camera;
    other.centerX += 1.0;
    EXPECT_FALSE(DrawWith(renderer, list, other) == moved);
    list.texts.back() = "another";
    EXPECT_TRUE(renderer.Submit(list, other));
    EXPECT_FALSE(renderer.Statistics().unchanged);
}

TEST(Renderer, ClipsAnOverlayToItsRectangles)
{
    // One triangle over everything, of the font's white pixel; shown through a window of 10 x 5
    // pixels.
    Result<Hud> hud = Hud::Create(40, 40);
    ASSERT_TRUE(hud);
    const Vec2 white =
        hud->Build({"t", {}}).vertices.front().uv; // the panel's ground is filled first
    Overlay overlay;
    for (const Vec2 corner : {Vec2{-100, -100}, Vec2{300, -100}, Vec2{-100, 300}})
    {
        overlay.vertices.push_back({corner, white, {10, 200, 30, 255}});
    }
    overlay.indices = {0, 1, 2};
    overlay.commands = {{0, 3, 5, 8, 15, 13}, {0, 3, 20, 20, 20, 30}};
    Renderer renderer = MakeRenderer(40, 40);
    const Frame frame = DrawWith(renderer, {}, PixelCamera(40, 40), &overlay);
    for (int y = 0; y < 40; ++y)
    {
        for (int x = 0; x < 40; ++x)
        {
            const bool shown = x >= 5 && x < 15 && y >= 8 && y < 13;
            ASSERT_EQ(At(frame, x, y), (shown ? Pixel{10, 200, 30, 255} : kGround))
                << x << ", " << y;
        }
    }
}

TEST(Renderer, WritesTextAtItsPlace)
{
    DrawList list;
    list.AddText({20, 40}, "Hill", kWhite); // top left corner at pixel (20, 20)
    const Frame frame = Picture(list, 100, 60);
    int inked = 0;
    for (int y = 0; y < 60; ++y)
    {
        for (int x = 0; x < 100; ++x)
        {
            const bool ink = At(frame, x, y) != kGround;
            inked += ink;
            ASSERT_TRUE(!ink || (x >= 20 && x < 60 && y >= 20 && y < 40)) << x << ", " << y;
        }
    }
    EXPECT_GT(inked, 50);
    EXPECT_LT(inked, 300);
}
