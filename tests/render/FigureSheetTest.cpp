// SPDX-License-Identifier: MIT
#include "FontAtlas.h"
#include "Pictures.h"

#include <debugdraw/TextWidth.h>
#include <render/FigureSheet.h>

#include <set>

using namespace boxreel;

using testing::HasSubstr;

TEST(FigureSheet, EqualsItsOnlyPicture)
{
    const Figure figure = SheetOf({{Everything(), PixelCamera(320, 240), ""}});
    EXPECT_EQ(figure.width, 320);
    EXPECT_EQ(FrameOf(figure), Picture(Everything(), 320, 240));
}

TEST(FigureSheet, KeepsEveryPictureUnchanged)
{
    for (const Theme& theme : {Theme::Classic(), Theme::Print()})
    {
        std::vector<SheetPicture> pictures;
        for (unsigned i = 0; i < 5; ++i)
        {
            pictures.push_back({Everything(i), PixelCamera(320, 240), std::to_string(i) + " s"});
        }
        for (const bool axes : {false, true})
        {
            const Figure figure = SheetOf(
                pictures,
                {.axes = axes, .scaleBar = true, .caption = "Five moments.", .theme = theme});
            ASSERT_EQ(figure.panels.size(), 6u) << "one for what lies beside the pictures";
            const Frame frame = FrameOf(figure);
            for (unsigned i = 0; i < 5; ++i)
            {
                const FigurePanel& panel = figure.panels[i + 1];
                EXPECT_EQ(Cut(frame, int(panel.x), int(panel.y), 320, 240),
                          Picture(Everything(i), 320, 240, theme))
                    << i;
            }
        }
    }
}

TEST(FigureSheet, ArrangesPicturesInGivenColumns)
{
    const auto columnsOf = [](std::size_t count, int columns) {
        const Figure figure =
            SheetOf(std::vector<SheetPicture>(count, {DrawList(), PixelCamera(100, 80), "0 s"}),
                    {.columns = columns});
        std::set<double> places;
        for (std::size_t i = 1; i < figure.panels.size(); ++i)
        {
            const FigurePanel& panel = figure.panels[i];
            places.insert(panel.x);
            EXPECT_LE(panel.x + 100, figure.width);
            EXPECT_LE(panel.y + 80, figure.height);
        }
        return places.size();
    };
    EXPECT_EQ(columnsOf(2, 0), 2u);
    EXPECT_EQ(columnsOf(3, 0), 3u);
    EXPECT_EQ(columnsOf(4, 0), 2u);
    EXPECT_EQ(columnsOf(6, 0), 3u);
    EXPECT_EQ(columnsOf(10, 0), 4u);
    EXPECT_EQ(columnsOf(6, 1), 1u);
    EXPECT_EQ(columnsOf(3, 9), 3u) << "no empty columns";
    EXPECT_EQ(SheetOf({}).panels.size(), 1u);
}

TEST(FigureSheet, WrapsCaptionsInABandOfTheirOwn)
{
    const SheetPicture picture{DrawList(), PixelCamera(200, 100), ""};
    const Figure one = SheetOf({picture}, {.caption = "Short."});
    const Figure several =
        SheetOf({picture}, {.caption = "A caption of as many words as need a few lines here, and "
                                       "not one fewer."});
    const DrawList& words = several.panels.front().list;
    ASSERT_GE(words.texts.size(), 3u);
    EXPECT_EQ(several.height, one.height + 20 * (int(words.texts.size()) - 1));
    for (const std::string& line : words.texts)
    {
        EXPECT_LE(TextWidth(line), 200.0);
    }
    for (const DrawItem& item : words.items)
    {
        if (item.kind == DrawKind::Text)
        {
            EXPECT_GT(-words.points[item.first].y, 112.0f) << "below the picture";
        }
    }
}

TEST(FigureSheet, HasOneScaleBarForPicturesOfOneScale)
{
    std::vector<SheetPicture> pictures(4, {DrawList(), PixelCamera(200, 100), "0 s"});
    const auto barsOf = [&pictures] {
        const Figure figure = SheetOf(pictures, {.scaleBar = true});
        const auto& texts = figure.panels.front().list.texts;
        return std::count_if(texts.begin(), texts.end(),
                             [](const std::string& text) { return text.ends_with(" m"); });
    };
    EXPECT_EQ(barsOf(), 1);
    pictures[2].camera.pixelsPerMeter *= 2.0;
    EXPECT_EQ(barsOf(), 4);
}

TEST(FigureSheet, IsTheSameSvgEachTime)
{
    const auto svg = [] {
        return *ToSvg(SheetOf({{Everything(1), PixelCamera(320, 240), "0 s"},
                               {Everything(2), PixelCamera(320, 240), "1 s"}},
                              {.axes = true, .scaleBar = true, .caption = "Two."}));
    };
    EXPECT_EQ(svg(), svg());
    EXPECT_THAT(svg(), HasSubstr("<g id=\"annotations\" class=\"annotations\">"));
    EXPECT_THAT(svg(), HasSubstr(">1 s</text>"));
}

namespace
{

/// Returns the UTF-8 of a letter below 0x10000.
std::string Utf8(char32_t code)
{
    const auto next = [code](int shift) { return char(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80)
    {
        return {char(code)};
    }
    return code < 0x800 ? std::string{char(0xC0 | code >> 6), next(0)}
                        : std::string{char(0xE0 | code >> 12), next(6), next(0)};
}

} // namespace

TEST(TextWidth, EqualsAdvanceOfLettersInTheFont)
{
    // A letter between two bars; the bars' places tell how far the pen went on.
    const auto advance = [](const std::string& letter) {
        std::vector<GlyphQuad> quads;
        FontAtlas::Get().Layout("|" + letter + "|", quads);
        return float(quads.back().x - quads.front().x);
    };
    const float bar = advance("");
    for (char32_t code = 0x21; code < 0x10000; code += code == 0xD7FF ? 0x801 : 1)
    {
        const std::string letter = Utf8(code);
        ASSERT_NEAR(TextWidth(letter), advance(letter) - bar, 0.5001) << letter << ' ' << int(code);
        ASSERT_GE(TextWidth(letter) + 0.001, advance(letter) - bar) << letter << ' ' << int(code);
    }
    const std::string beyond = "\U0001F697";
    EXPECT_EQ(TextWidth(beyond), TextWidth("?"));
    EXPECT_EQ(advance(beyond), advance("?"));
}
