// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "FontAtlas.h"
#include "Pictures.h"

#include <filesystem>
#include <thread>

using namespace boxreel;

namespace
{

HudContent Usual()
{
    return {"Vertical Stack",
            {{"time", "2.500 s"},
             {"step", "150"},
             {"bodies", "51 (12 awake)"},
             {"contacts", "104"},
             {"ms per step", "0.083"}}};
}

Overlay Built(int width, int height, const HudContent& content)
{
    Result<Hud> hud = Hud::Create(width, height);
    EXPECT_TRUE(hud);
    return hud->Build(content);
}

Rect Extent(const Overlay& overlay)
{
    Rect extent;
    for (const OverlayVertex& vertex : overlay.vertices)
    {
        extent.Include(vertex.position);
    }
    return extent;
}

Overlay Triangle()
{
    Overlay overlay;
    for (const Vec2 corner : {Vec2{10, 10}, Vec2{50, 10}, Vec2{10, 50}})
    {
        overlay.vertices.push_back({corner, {}, {255, 255, 255, 255}});
    }
    overlay.indices = {0, 1, 2};
    overlay.commands.push_back({0, 3, 0, 0, 64, 64});
    return overlay;
}

} // namespace

TEST(Hud, IsTheSameForTheSameContent)
{
    Result<Hud> hud = Hud::Create(640, 360);
    ASSERT_TRUE(hud);
    const Overlay first = hud->Build(Usual());
    hud->Build({"other", {{"a", "b"}}});
    EXPECT_TRUE(hud->Build(Usual()) == first) << "independent of what was shown before";
    EXPECT_TRUE(Built(640, 360, Usual()) == first) << "in any panel";
    Overlay elsewhere;
    std::thread([&] { elsewhere = Built(640, 360, Usual()); }).join();
    EXPECT_TRUE(elsewhere == first) << "in any thread";
}

TEST(Hud, LiesInTheTopLeftCornerAndNoLargerThanItsContent)
{
    const Rect extent = Extent(Built(1280, 720, Usual()));
    EXPECT_GE(extent.lower.x, 8.0f);
    EXPECT_GE(extent.lower.y, 8.0f);
    EXPECT_LT(extent.upper.x, 300.0f);
    EXPECT_LT(extent.upper.y, 160.0f);
}

TEST(Hud, StaysInsideTheFrame)
{
    HudContent content = Usual();
    content.title =
        "A scene with quite a long name, longer than any frame of this size can show at all";
    content.rows.push_back(
        {"a name that goes on and on and on", "a value that does the same, with umlauts: äöüäöü"});
    for (const auto& [width, height] : {std::pair{320, 240}, {160, 120}, {60, 40}, {8, 8}, {1, 1}})
    {
        const Overlay overlay = Built(width, height, content);
        for (const OverlayCommand& command : overlay.commands)
        {
            EXPECT_LE(command.clipX1, width);
            EXPECT_LE(command.clipY1, height);
            EXPECT_LE(std::size_t(command.firstIndex) + command.indexCount, overlay.indices.size());
        }
        if (width >= 160)
        {
            // Ten pixels of margin, less the one over which the rim fades.
            EXPECT_LE(Extent(overlay).upper.x, float(width) - 8.9f)
                << "long texts are shortened, not cut";
        }
    }
}

TEST(Hud, IsBuiltForEmptyContent)
{
    EXPECT_FALSE(Built(320, 240, {}).IsEmpty());
    EXPECT_FALSE(Built(320, 240, {"title", {}}).IsEmpty());
    EXPECT_FALSE(Built(320, 240, {"", {{"", ""}}}).IsEmpty());
}

TEST(Hud, HasItsCornersOnTheGridOfTheRasteriser)
{
    for (const OverlayVertex& vertex : Built(640, 360, Usual()).vertices)
    {
        ASSERT_EQ(std::fmod(vertex.position.x * 256.0f, 1.0f), 0.0f);
        ASSERT_EQ(std::fmod(vertex.position.y * 256.0f, 1.0f), 0.0f);
    }
}

TEST(Hud, LeavesNoSettingsFileBehind)
{
    std::filesystem::remove("imgui.ini");
    {
        Result<Hud> hud = Hud::Create(320, 240);
        ASSERT_TRUE(hud);
        for (int i = 0; i < 600;
             ++i) // ten seconds of its clock; by default it would save after five
        {
            hud->Build(Usual());
        }
    }
    EXPECT_FALSE(std::filesystem::exists("imgui.ini"));
}

TEST(Hud, RefusesSizesOutOfRange)
{
    const Result<Hud> hud = Hud::Create(0, 240);
    ASSERT_FALSE(hud);
    EXPECT_EQ(hud.GetError().kind, ErrorKind::Unusable);
}

TEST(Hud, DarkensThePictureBelowAndShowsBrightText)
{
    DrawList list;
    AddRectangle(list, -10, -10, 700, 400, kWhite);
    Renderer renderer = MakeRenderer(640, 360);
    const Camera camera = PixelCamera(640, 360);
    const Frame without = DrawWith(renderer, list, camera);
    const Overlay overlay = Built(640, 360, Usual());
    const Frame with = DrawWith(renderer, list, camera, &overlay);
    const Rect extent = Extent(overlay);
    int bright = 0;
    for (int y = 0; y < 360; ++y)
    {
        for (int x = 0; x < 640; ++x)
        {
            const bool inPanel = float(x) >= extent.lower.x - 1 && float(x) <= extent.upper.x &&
                                 float(y) >= extent.lower.y - 1 && float(y) <= extent.upper.y;
            ASSERT_TRUE(inPanel || At(with, x, y) == At(without, x, y)) << x << ", " << y;
            bright += inPanel && At(with, x, y)[1] > 200;
        }
    }
    EXPECT_GT(bright, 300);
    const int middleX = int(extent.upper.x) - 15;
    EXPECT_LT(At(with, middleX, int(extent.upper.y) - 5)[0], At(without, 600, 300)[0] / 2 + 5);
}

TEST(Overlay, IsRefusedWhenACommandNamesIndicesThatItDoesNotHave)
{
    Renderer renderer = MakeRenderer(64, 64);
    Overlay overlay = Triangle();
    overlay.commands[0].firstIndex = 1;
    EXPECT_THAT(renderer.Submit({}, PixelCamera(64, 64), &overlay),
                RefusesWith("overlay", "index 4 of 3"));
    overlay.commands[0].firstIndex = 0xffffffff; // no sum overflows
    EXPECT_THAT(renderer.Submit({}, PixelCamera(64, 64), &overlay),
                RefusesWith("overlay", "index 4294967298 of 3"));
}

TEST(Overlay, IsRefusedWhenAnIndexNamesAVertexThatItDoesNotHave)
{
    Renderer renderer = MakeRenderer(64, 64);
    const Camera camera = PixelCamera(64, 64);
    const Overlay good = Triangle();
    const Frame first = DrawWith(renderer, {}, camera, &good);
    Overlay bad = good;
    bad.indices[1] = 3;
    EXPECT_THAT(renderer.Submit({}, camera, &bad), RefusesWith("overlay", "vertex 3 of 3"));
    EXPECT_TRUE(DrawWith(renderer, {}, camera, &good) == first) << "and nothing has changed";
}

TEST(Overlay, ShowsTheBytesOfTheFontUnderItsPixels)
{
    const FontAtlas& atlas = FontAtlas::Get();
    std::vector<GlyphQuad> quads;
    atlas.Layout("g", quads);
    const GlyphQuad& g = quads.at(0);
    for (const float offset : {0.0f, 0.25f, 0.4f, 0.5f})
    {
        Overlay overlay;
        const auto corner = [&](int x, int y) {
            overlay.vertices.push_back({{5.0f + offset + float(x), 7.0f + float(y)},
                                        {float(g.texelX + x) / float(atlas.Width()),
                                         float(g.texelY + y) / float(atlas.Height())},
                                        kWhite});
        };
        corner(0, 0);
        corner(g.width, 0);
        corner(g.width, g.height);
        corner(0, g.height);
        overlay.indices = {0, 1, 2, 0, 2, 3};
        overlay.commands.push_back({0, 6, 0, 0, 64, 64});
        Theme black;
        black.background = {0, 0, 0, 255};
        Renderer renderer = MakeRenderer(64, 64, black);
        const Frame frame = DrawWith(renderer, {}, PixelCamera(64, 64), &overlay);
        for (int y = 0; y < g.height; ++y)
        {
            for (int x = 0; x < g.width; ++x)
            {
                const std::uint8_t texel =
                    atlas.Coverage()[(g.texelY + y) * atlas.Width() + g.texelX + x];
                ASSERT_EQ(At(frame, 5 + x, 7 + y)[0], texel) << offset << ": " << x << ", " << y;
            }
        }
    }
}

TEST(FontAtlas, HasLettersOfWholePixelsSideBySide)
{
    std::vector<GlyphQuad> quads;
    FontAtlas::Get().Layout("Aé θ→\nx", quads);
    ASSERT_EQ(quads.size(), 5u) << "a blank and a line feed are not drawn";
    for (const GlyphQuad& quad : quads)
    {
        EXPECT_GT(quad.width, 0);
        EXPECT_GT(quad.height, 0);
        EXPECT_GT(quad.texelX, 0);
        EXPECT_LE(quad.texelX + quad.width, FontAtlas::Get().Width());
        EXPECT_LE(quad.texelY + quad.height, FontAtlas::Get().Height());
    }
    EXPECT_LT(quads[0].x, quads[1].x);
    EXPECT_GT(quads[4].y, quads[0].y + 10);
    EXPECT_LT(quads[4].x, 4);
}

// Lines of such letters are 19.5 and 22.5 px apart.
TEST(Label, ShowsTheBytesOfItsFontAtEveryScale)
{
    for (const double scale : {1.0, 1.3, 1.5})
    {
        const FontAtlas& atlas = FontAtlas::Get(scale);
        DrawList list;
        list.AddText({10.0f, 100.0f}, "Ag\nfx", kWhite);
        RendererSettings settings{.width = 120, .height = 120};
        settings.theme.background = {0, 0, 0, 255};
        settings.scale = scale;
        Result<Renderer> renderer = Renderer::Create(settings);
        ASSERT_TRUE(renderer);
        const Frame frame = DrawWith(*renderer, list, PixelCamera(120, 120));
        std::vector<GlyphQuad> quads;
        atlas.Layout("Ag\nfx", quads);
        const int ink = settings.theme.Outline(kWhite).g;
        for (const GlyphQuad& quad : quads)
        {
            for (int i = 0; i < quad.width * quad.height; ++i)
            {
                const int x = i % quad.width;
                const int y = i / quad.width;
                const int texel =
                    atlas.Coverage()[(quad.texelY + y) * atlas.Width() + quad.texelX + x];
                ASSERT_EQ(At(frame, 10 + quad.x + x, 20 + quad.y + y)[1],
                          (2 * texel * ink + 255) / 510)
                    << scale << ": " << x << ", " << y;
            }
        }
    }
}

TEST(FontAtlas, FallsBackToABuiltInFont)
{
    for (const char* const file : {"/no/such/font.ttf", "/dev/null", "/proc/self/exe"})
    {
        const FontAtlas atlas(file);
        std::vector<GlyphQuad> quads;
        atlas.Layout("Hill", quads);
        EXPECT_EQ(quads.size(), 4u) << file;
        EXPECT_GT(atlas.Width() * atlas.Height(), 1000);
    }
}
