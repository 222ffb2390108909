// SPDX-License-Identifier: MIT
#include <debugdraw/DrawListText.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ExampleList.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

using namespace boxreel;

TEST(DrawListText, PrintsOneReadableLineAnItem)
{
    EXPECT_EQ(ToText(ExampleList()),
              "body 3 shapes solid-polygon #e6b3b3 (-0.5, 0) (0.5, 0) (0.5, 1) (-0.5, 1)\n"
              "body 3 shapes solid-circle #e6b3b3 (0.33333334, 2) (0, 1) radius 0.25\n"
              "world joints segment #80cccc (1e-07, 16777216) (0.1, -20)\n"
              "world aabbs polygon #e64de680 (-0.5, 0) (0.5, 0) (0.5, 1)\n"
              "body 0 centers-of-mass transform #ffffff (0, 0.5) (1, 0) axes 0.4\n"
              "world contacts point #4d4df2 (0, 0) pixels 5\n"
              "world contacts circle #000000 (0, 0) radius 1.5\n"
              "world labels text #e6e6e6 (-2, 3) \"a \\\"box\\\"\\x0a\\\\ 5 µm\"\n");
}

TEST(DrawListText, IsEmptyForAnEmptyList)
{
    EXPECT_EQ(ToText(DrawList()), "");
}

TEST(DrawListText, KeepsFloatsExactly)
{
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i)
    {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value))
        {
            continue;
        }
        DrawList a;
        a.AddPoint({value, 0.0f}, 1.0f, {});
        DrawList b;
        b.AddPoint({std::nextafter(value, std::numeric_limits<float>::max()), 0.0f}, 1.0f, {});
        const std::string text = ToText(a);
        EXPECT_NE(text, ToText(b));
        EXPECT_EQ(std::strtof(text.c_str() + text.find('(') + 1, nullptr), value);
    }
}

TEST(DrawListText, DiffersWhereverTheListsDiffer)
{
    const DrawList list = ExampleList();
    const std::string text = ToText(list);
    for (std::size_t i = 0; i < list.items.size(); ++i)
    {
        DrawList other = list;
        other.items[i].color.a ^= 1;
        EXPECT_NE(ToText(other), text) << "alpha of item " << i;
        other = list;
        other.items[i].owner += 5;
        EXPECT_NE(ToText(other), text) << "owner of item " << i;
        other = list;
        other.items[i].layer = DrawLayer::Pairs;
        EXPECT_NE(ToText(other), text) << "layer of item " << i;
    }
    for (std::size_t i = 0; i < list.points.size(); ++i)
    {
        DrawList other = list;
        other.points[i].y += 1000.0f;
        EXPECT_NE(ToText(other), text) << "point " << i;
    }
}
