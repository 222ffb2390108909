// SPDX-License-Identifier: MIT
#include "ExampleList.h"

#include <debugdraw/Faded.h>

#include <gtest/gtest.h>

using namespace boxreel;

namespace
{

DrawList BoxAt(float x, std::uint32_t owner)
{
    DrawList list;
    list.owner = owner;
    const Vec2 corners[4] = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
    list.AddSolidPolygon(corners, 4, {230, 179, 179, 200});
    list.AddSolidCircle({x, 5}, 2.0f, {1, 0}, {230, 179, 179});
    return list;
}

} // namespace

TEST(Append, AddsAListUnchanged)
{
    DrawList example;
    FillExample(example);
    DrawList both = BoxAt(3.0f, 7);
    const DrawList first = both;
    Append(both, example);
    Append(both, first);
    DrawList again;
    Append(again, example);
    EXPECT_EQ(again, example);
    EXPECT_EQ(both.items.size(), example.items.size() + 2 * first.items.size());
    EXPECT_EQ(both.points[both.items.back().first], first.points[first.items.back().first]);
}

TEST(AddFaded, MultipliesOpacityOfFilteredItems)
{
    DrawList both = BoxAt(0.0f, 1);
    Append(both, BoxAt(4.0f, 2));
    DrawList faded;
    AddFaded(faded, both, 0.5, [](const DrawItem& item) { return item.owner == 2; });
    ASSERT_EQ(faded.items.size(), 2u);
    EXPECT_EQ(faded.items[0].owner, 2u);
    EXPECT_EQ(faded.items[0].layer, DrawLayer::Poses);
    EXPECT_EQ(faded.items[0].color, (Color{230, 179, 179, 100}));
    EXPECT_EQ(faded.items[1].color.a, 128);
    EXPECT_EQ(faded.points.size(), 6u);
    EXPECT_EQ(faded.points[0], (Vec2{4, 0}));
}

TEST(AddFaded, OmitsItemsWithoutOpacity)
{
    DrawList frame;
    frame.AddTransform({0, 0}, {1, 0}, 1.0f);
    frame.AddText({0, 0}, "kept", {255, 255, 255});
    DrawList faded;
    AddFaded(faded, frame, 1.0);
    ASSERT_EQ(faded.items.size(), 1u);
    EXPECT_EQ(faded.texts.at(faded.items[0].text), "kept");
}

TEST(StandsStill, ComparesPlacesAndTurnsOfOneOwner)
{
    const DrawList before = BoxAt(0.0f, 1);
    EXPECT_TRUE(StandsStill(before, BoxAt(0.01f, 1), 1, 0.02));
    EXPECT_FALSE(StandsStill(before, BoxAt(0.03f, 1), 1, 0.02));
    EXPECT_FALSE(StandsStill(before, DrawList(), 1, 1.0));
    EXPECT_TRUE(StandsStill(before, BoxAt(9.0f, 1), 2, 0.0)) << "that owner has nothing";
    DrawList turned = before;
    turned.points.back() = {0.99f, 0.14f}; // two metres from the centre this is 0.28 m
    EXPECT_FALSE(StandsStill(before, turned, 1, 0.2));
    EXPECT_TRUE(StandsStill(before, turned, 1, 0.3));
}
