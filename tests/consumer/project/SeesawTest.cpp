// SPDX-License-Identifier: MIT
#include "Seesaw.h"

#include <golden/GoldenTest.h>

#include <algorithm>
#include <cstdint>

TEST(Seesaw, ThrowsTheSmallBox)
{
    Seesaw seesaw;
    seesaw.Run(60);
    EXPECT_GOLDEN_WORLD(seesaw.world, "seesaw/1s");
    seesaw.Run(30);
    EXPECT_GOLDEN_WORLD(seesaw.world, "seesaw/1.5s");
}

TEST(Seesaw, ComesToRest)
{
    Seesaw seesaw;
    seesaw.Run(600);
    const boxreel::Camera camera{640, 360, 0.0, 4.0, 30.0}; // pixels, centre, pixels a metre
    EXPECT_GOLDEN_WORLD(seesaw.world, "seesaw/10s", {.camera = camera});
}

TEST(Meter, IsHalfFull)
{
    boxreel::Frame meter(100, 20); // any picture: rows from the top, four bytes a pixel
    for (int y = 0; y < meter.height; ++y)
    {
        for (int x = 0; x < meter.width; ++x)
        {
            const std::uint8_t green = x < 50 ? 200 : 40;
            const std::uint8_t pixel[4] = {20, green, 60, 255};
            std::copy_n(pixel, 4, meter.Pixel(x, y));
        }
    }
    EXPECT_GOLDEN(meter, "meter/half", boxreel::CompareSettings::Exact());
}
