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

namespace
{

/// As labels are laid out: letters of 8.3 px, with ink on 12 of 16 px.
Rect BoxOf(const DrawList& list, const DrawItem& text, double pixelsPerMeter)
{
    const Vec2 corner = list.points[text.first];
    const float pixel = float(1.0 / pixelsPerMeter);
    const float right = 8.3f * float(list.texts[text.text].size()) * pixel;
    return {{corner.x, corner.y - 14.0f * pixel}, {corner.x + right, corner.y - 2.0f * pixel}};
}

bool Overlap(const Rect& a, const Rect& b)
{
    return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y &&
           b.lower.y < a.upper.y;
}

} // namespace

TEST_F(WorldBodies, NamesMoveAsideFromSignsAndFromEachOther)
{
    b2CircleShape ball;
    ball.m_radius = 0.2f;
    b2Body* const near = scene.Body(b2_dynamicBody, -2.45f, 2.05f);
    scene.Add(near, ball, 0.2f, 0.0f);
    const View view = ViewOf(camera, 2.0);
    AddCenterMarks(scene.world, view, list);
    const std::size_t marks = list.items.size();
    AddBodyNames(scene.world, view, {{0, "anvil"}, {2, "hammer"}}, list);
    ASSERT_EQ(list.items.size(), marks + 2);
    const Rect first = BoxOf(list, list.items[marks], camera.pixelsPerMeter);
    const Rect second = BoxOf(list, list.items[marks + 1], camera.pixelsPerMeter);
    EXPECT_FALSE(Overlap(first, second));
    for (const Vec2 center : {Vec2{-2.5f, 2.0f}, Vec2{-2.45f, 2.05f}})
    {
        const Rect mark{{center.x - 0.06f, center.y - 0.06f}, {center.x + 0.06f, center.y + 0.06f}};
        EXPECT_FALSE(Overlap(first, mark));
        EXPECT_FALSE(Overlap(second, mark));
    }
    EXPECT_LT(std::abs(first.lower.x - -2.5f), 0.6f) << "but stay near";
}

TEST_F(WorldBodies, WithAViewTheNamesAreThoseOfAPictureOfEverythingInTheSameOrder)
{
    for (int i = 0; i < 40; ++i)
    {
        b2Body* const body = scene.Body(i % 3 == 0 ? b2_staticBody : b2_dynamicBody,
                                        -10.0f + float(i) * 0.4f, 2.0f + float(i % 4));
        b2CircleShape ball;
        ball.m_radius = 0.3f;
        scene.Add(body, ball, 0.2f, 0.0f);
        body->SetAwake(i % 2 == 0);
    }
    for (int pass = 0; pass < 2; ++pass)
    {
        list.Clear();
        DrawList all;
        AddBodyNames(scene.world, ViewOf(camera, 2.0), {}, list);
        AddBodyNames(scene.world, ViewOfEverything(camera), {}, all);
        std::vector<std::uint32_t> seen;
        std::vector<std::uint32_t> expected;
        for (const DrawItem& item : list.items)
        {
            seen.push_back(item.owner);
        }
        for (const DrawItem& item : all.items)
        {
            if (ViewOf(camera, 2.0).Shows(all.points[item.first], 64.0))
            {
                expected.push_back(item.owner);
            }
        }
        EXPECT_EQ(seen, expected);
        EXPECT_GT(seen.size(), 3u);
        scene.world.GetBodyList()->GetNext()->SetActive(false); // in no tree, but drawn
    }
}

TEST_F(WorldBodies, JointsThatHaveANameCarryItBetweenTheirAnchors)
{
    b2Body* const ball = scene.world.GetBodyList()->GetNext();
    b2RevoluteJointDef hinge;
    hinge.Initialize(scene.Body(b2_staticBody, 0.0f, 0.0f), ball, b2Vec2(-2.0f, 2.5f));
    const b2Joint* const named = scene.world.CreateJoint(&hinge);
    scene.world.CreateJoint(&hinge);
    AddJointNames(scene.world, ViewOf(camera, 2.0), {{named, "knee"}}, list);
    ASSERT_EQ(list.items.size(), 1u);
    EXPECT_THAT(list.texts, testing::ElementsAre("knee"));
    EXPECT_EQ(list.items[0].layer, DrawLayer::Labels);
    EXPECT_EQ(list.items[0].owner, kNoOwner);
    EXPECT_NEAR(list.points[0].x, -2.0f - 2.0f * 0.083f, 1e-4f);
    list.Clear();
    camera.centerX = 100.0;
    AddJointNames(scene.world, ViewOf(camera, 2.0), {{named, "knee"}}, list);
    EXPECT_TRUE(list.items.empty());
}
