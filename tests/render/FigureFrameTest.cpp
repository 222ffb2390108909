// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "Pictures.h"

#include <render/FigureFrame.h>

#include <limits>

using namespace boxreel;

namespace
{

Figure TwoPanels(const Theme& theme)
{
    Figure figure;
    figure.width = 700;
    figure.height = 260;
    figure.theme = theme;
    figure.panels.push_back({Everything(1), PixelCamera(320, 240), 10.0, 5.0, {}});
    figure.panels.push_back({Everything(2), PixelCamera(320, 240), 350.0, 15.0, {}});
    return figure;
}

} // namespace

TEST(FigureFrame, EqualsTheRenderersPictureForOnePanel)
{
    for (const Theme& theme : {Theme::Classic(), Theme::Print()})
    {
        EXPECT_EQ(FrameOf(FigureOf(Everything(), PixelCamera(320, 240), theme)),
                  Picture(Everything(), 320, 240, theme));
    }
}

TEST(FigureFrame, EqualsTheRenderersPicturesInItsPanels)
{
    const Frame frame = FrameOf(TwoPanels(Theme::Print()));
    ASSERT_EQ(frame.width, 700);
    EXPECT_EQ(Cut(frame, 10, 5, 320, 240), Picture(Everything(1), 320, 240, Theme::Print()));
    EXPECT_EQ(Cut(frame, 350, 15, 320, 240), Picture(Everything(2), 320, 240, Theme::Print()));
    EXPECT_EQ(At(frame, 340, 100), (Pixel{255, 255, 255, 255})) << "the ground between them";
}

TEST(FigureFrame, IsScaledAsAWhole)
{
    Figure figure = TwoPanels(Theme::Classic());
    figure.scale = 2.0;
    const Frame frame = FrameOf(figure);
    EXPECT_EQ(frame.width, 1400);
    EXPECT_EQ(frame.height, 520);
    Renderer renderer = std::move(*Renderer::Create({.width = 640, .height = 480, .scale = 2.0}));
    EXPECT_EQ(Cut(frame, 700, 30, 640, 480),
              DrawWith(renderer, Everything(2), Scaled(PixelCamera(320, 240), 2.0)));
}

TEST(FigureFrame, ShowsWhatLiesBelowAPanel)
{
    DrawList below;
    AddRectangle(below, 20, 20, 80, 80, kAwake);
    DrawList above;
    AddRectangle(above, 50, 50, 100, 100, kStatic);
    DrawList both = below;
    AddRectangle(both, 50, 50, 100, 100, kStatic);
    Figure figure = FigureOf(below, PixelCamera(120, 120), Theme::Print());
    figure.panels.push_back({above, PixelCamera(120, 120), 0.0, 0.0, {}});
    const Frame layered = FrameOf(figure);
    const Frame atOnce = Picture(both, 120, 120, Theme::Print());
    for (std::size_t i = 0; i < layered.rgba.size(); ++i)
    {
        EXPECT_NEAR(layered.rgba[i], atOnce.rgba[i], 2);
    }
    EXPECT_NE(layered, FrameOf(FigureOf(above, PixelCamera(120, 120), Theme::Print())));
}

TEST(FigureFrame, CutsOffWhatLiesOutside)
{
    Figure figure = TwoPanels(Theme::Classic());
    figure.panels[0].x = -100.0;
    figure.panels[1].y = 200.0;
    const Frame frame = FrameOf(figure);
    EXPECT_EQ(Cut(frame, 0, 5, 220, 240), Cut(Picture(Everything(1), 320, 240), 100, 0, 220, 240));
    EXPECT_EQ(Cut(frame, 350, 200, 320, 60), Cut(Picture(Everything(2), 320, 240), 0, 0, 320, 60));
    figure.panels[0].x = 1e300;
    EXPECT_EQ(At(FrameOf(figure), 100, 100), (Pixel{26, 26, 26, 255}));
}

TEST(FigureFrame, RefusesInvalidSizesAndCameras)
{
    Figure figure = TwoPanels(Theme::Classic());
    figure.scale = 12.0;
    EXPECT_THAT(ToFrame(figure), RefusesWith("size 8400x3120", "8192"));
    figure.scale = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(ToFrame(figure));
    figure = TwoPanels(Theme::Classic());
    figure.panels[1].camera.pixelsPerMeter = 0.0;
    EXPECT_THAT(ToFrame(figure), RefusesWith("camera", "pixelsPerMeter"));
    EXPECT_TRUE(PrepareFrames());
}
