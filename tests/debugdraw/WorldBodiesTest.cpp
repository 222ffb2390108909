// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <debugdraw/WorldBodies.h>

#include <gmock/gmock.h>

using namespace boxreel;

namespace
{

constexpr float kHalfALabel = 0.1f; // ten pixels, at a hundred a metre

struct WorldBodies : testing::Test
{
    WorldBodies()
    {
        b2CircleShape ball;
        ball.m_radius = 1.0f;
        ball.m_p.Set(0.5f, 0.0f);
        for (const float x : {-3.0f, 7.0f})
        {
            scene.Add(scene.Body(b2_dynamicBody, x, 2.0f), ball, 0.2f, 0.0f);
        }
    }
    dynamics::Scene scene;
    Camera camera{
        .width = 200, .height = 200, .centerX = -2.5, .centerY = 2.0, .pixelsPerMeter = 100.0};
    DrawList list;
};

} // namespace

TEST_F(WorldBodies, EachCarriesItsNumberAtItsCentreOfMass)
{
    AddBodyNames(scene.world, ViewOfEverything(camera), {}, list);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_THAT(list.texts, testing::ElementsAre("0", "1"));
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.kind, DrawKind::Text);
        EXPECT_EQ(item.layer, DrawLayer::Labels);
        EXPECT_EQ(list.texts[item.text], std::to_string(item.owner));
        const Vec2 corner = list.points[item.first];
        EXPECT_NEAR(corner.x, item.owner == 0 ? -2.5f : 7.5f, kHalfALabel);
        EXPECT_NEAR(corner.y, 2.0f, kHalfALabel);
    }
    EXPECT_EQ(list.owner, kNoOwner) << "what follows belongs to nobody";
}

TEST_F(WorldBodies, ANameTakesTheNumbersPlaceInTheMiddle)
{
    AddBodyNames(scene.world, ViewOfEverything(camera), {{1, "M\u00fchle"}, {0, ""}}, list);
    EXPECT_THAT(list.texts, testing::ElementsAre("0", "M\u00fchle"));
    EXPECT_NEAR(list.points[list.items[1].first].x, 7.5f - 0.5f * 5.0f * 0.083f, 1e-4f)
        << "five letters, whatever their bytes";
}

TEST_F(WorldBodies, ALongNameIsCutBetweenLetters)
{
    std::string name = "x";
    for (int i = 0; i < 400; ++i)
    {
        name += "\u00fc";
    }
    AddBodyNames(scene.world, ViewOfEverything(camera), {{0, name}}, list);
    EXPECT_EQ(list.texts[0], name.substr(0, 59) + "...");
}

TEST_F(WorldBodies, NamesAndMarksOutsideOfThePictureAreLeftOut)
{
    AddBodyNames(scene.world, ViewOf(camera, 2.0), {}, list);
    EXPECT_THAT(list.texts, testing::ElementsAre("0"));
    list.Clear();
    AddCenterMarks(scene.world, ViewOf(camera, 2.0), list);
    ASSERT_FALSE(list.items.empty());
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.owner, 0u);
        EXPECT_EQ(item.layer, DrawLayer::CentersOfMass);
    }
}

TEST_F(WorldBodies, MarksLieOnCentresOfMassAndTurnWithTheBody)
{
    scene.Body(b2_staticBody, 0.0f, 0.0f); // weighs nothing
    AddCenterMarks(scene.world, ViewOfEverything(camera), list);
    ASSERT_EQ(list.items.size(), 6u);
    EXPECT_EQ(list.items[0].kind, DrawKind::Circle);
    EXPECT_EQ(list.points[0], (Vec2{-2.5f, 2.0f}));
    EXPECT_FLOAT_EQ(list.items[0].size, 0.06f);
    EXPECT_NEAR(list.points[list.items[1].first + 1].x, -2.44f, 1e-5f);
    scene.world.GetBodyList()->GetNext()->GetNext()->SetTransform(b2Vec2(-3.0f, 2.0f), b2_pi);
    list.Clear();
    AddCenterMarks(scene.world, ViewOfEverything(camera), list);
    EXPECT_NEAR(list.points[list.items[1].first + 1].x, -3.56f, 1e-5f);
}
