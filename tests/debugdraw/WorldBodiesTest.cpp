// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <debugdraw/DrawCollector.h>
#include <debugdraw/Paper.h>
#include <debugdraw/TextWidth.h>
#include <debugdraw/WorldBodies.h>

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

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

TEST_F(WorldBodies, ShowTheirNumberAtTheirCentreOfMass)
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
    EXPECT_EQ(list.owner, kNoOwner) << "what follows has no owner";
}

TEST_F(WorldBodies, ShowNameInPlaceOfNumber)
{
    AddBodyNames(scene.world, ViewOfEverything(camera), {{1, "M\u00fchle"}, {0, ""}}, list);
    EXPECT_THAT(list.texts, testing::ElementsAre("0", "M\u00fchle"));
    EXPECT_NEAR(list.points[list.items[1].first].x, 7.5 - 0.005 * TextWidth("M\u00fchle"),
                0.02 / camera.pixelsPerMeter)
        << "as wide as its letters, not its bytes";
}

// Renderers and pages round differently, and must begin a text at the same pixel.
TEST_F(WorldBodies, BeginOffTheMiddleOfTwoPixels)
{
    for (const double shift : {0.0, 0.004, -0.004, 0.25, -0.3}) // [px]
    {
        camera.centerY = 2.0 + shift / camera.pixelsPerMeter;
        list.Clear();
        AddBodyNames(scene.world, ViewOfEverything(camera), {}, list);
        const double y = (list.points[list.items[0].first].y - camera.centerY) *
                         camera.pixelsPerMeter; // from the middle of the picture [px]
        EXPECT_GT(std::abs(y + 0.5 - std::round(y + 0.5)), 0.01) << shift;
        EXPECT_NEAR(y, 0.5 * kTextHeight - shift, 0.03) << shift;
    }
}

TEST_F(WorldBodies, StayAtWhatTheyNameForViewers)
{
    View view = ViewOfEverything(camera);
    view.zoom = 64.0;
    AddBodyNames(scene.world, view, {{1, "anvil"}}, list);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[1].size, 1.0f) << "it is awake";
    EXPECT_EQ(list.points[list.items[1].first], (Vec2{7.5f, 2.0f}));
    EXPECT_EQ(list.texts[list.items[1].text], "anvil");
}

TEST_F(WorldBodies, SayToViewersWhichNeedAShapeInView)
{
    scene.Body(b2_staticBody, 1.0f, 1.0f);
    View view = ViewOfEverything(camera);
    view.zoom = 64.0;
    AddBodyNames(scene.world, view, {}, list);
    ASSERT_EQ(list.items.size(), 3u);
    EXPECT_EQ(list.items[0].size, 1.0f);
    EXPECT_EQ(list.items[2].size, 2.0f);
}

TEST_F(WorldBodies, CutLongNamesBetweenLetters)
{
    std::string name = "x";
    for (int i = 0; i < 400; ++i)
    {
        name += "\u00fc";
    }
    camera.width = 1000;
    AddBodyNames(scene.world, ViewOfEverything(camera), {{0, name}}, list);
    EXPECT_EQ(list.texts[0], name.substr(0, 59) + "...");
    list.Clear();
    camera.width = 201;
    AddBodyNames(scene.world, ViewOfEverything(camera), {{0, name}}, list);
    const std::string narrow = list.texts[0];
    EXPECT_EQ(narrow, name.substr(0, narrow.size() - 3) + "...") << "or between edges";
    EXPECT_LE(TextWidth(narrow), 201.0);
    EXPECT_GE(TextWidth(narrow), 180.0);
}

TEST_F(WorldBodies, ShowNamesInOneLine)
{
    const std::string zero(1, '\0');
    const BodyNames names{{0, "tab\tand\r\nline\u2028end\u0085\x7f"}, {1, zero + "\u00bd\u2026"}};
    AddBodyNames(scene.world, ViewOfEverything(camera), names, list);
    EXPECT_THAT(list.texts, testing::ElementsAre("tab and  line end  ", " \u00bd\u2026"));
}

TEST_F(WorldBodies, OmitNamesAndMarksOutsideThePicture)
{
    AddBodyNames(scene.world, ViewOf(camera, 2.0), {}, list);
    EXPECT_THAT(list.texts, testing::ElementsAre("0"));
    list.Clear();
    AddCenterMarks(scene.world, ViewOf(camera, 2.0), list);
    ASSERT_FALSE(list.items.empty());
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.owner, 0u);
        EXPECT_EQ(item.layer, DrawLayer::CenterMarks);
    }
}

TEST_F(WorldBodies, HaveMarksAtCentresThatTurnWithThem)
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

/// Returns the inked area of the letters: 12 of 15 px.
Rect BoxOf(const DrawList& list, const DrawItem& text, double pixelsPerMeter)
{
    const Vec2 corner = list.points[text.first];
    const float pixel = float(1.0 / pixelsPerMeter);
    const float right = float(TextWidth(list.texts[text.text])) * pixel;
    return {{corner.x, corner.y - 13.5f * pixel}, {corner.x + right, corner.y - 1.5f * pixel}};
}

bool Overlap(const Rect& a, const Rect& b)
{
    return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y &&
           b.lower.y < a.upper.y;
}

struct SeenLabel
{
    std::uint32_t owner;
    Rect box;
    bool isTied = false; // by a line from its owner's centre
};

/// The labels of a list, by their owners.
std::map<std::uint32_t, SeenLabel> LabelsOf(const DrawList& list, double pixelsPerMeter)
{
    std::map<std::uint32_t, SeenLabel> labels;
    std::set<std::uint32_t> tied;
    for (const DrawItem& item : list.items)
    {
        if (item.layer == DrawLayer::Labels && item.kind == DrawKind::Segment)
        {
            tied.insert(item.owner);
        }
        else if (item.layer == DrawLayer::Labels)
        {
            labels[item.owner] = {item.owner, BoxOf(list, item, pixelsPerMeter),
                                  tied.contains(item.owner)};
        }
    }
    return labels;
}

bool Holds(const Rect& box, const b2Vec2& point)
{
    return box.lower.x < point.x && point.x < box.upper.x && box.lower.y < point.y &&
           point.y < box.upper.y;
}

/// Expects that each label is readable and nearest to its own body.
void ExpectClear(const b2World& world, const DrawList& list, const Camera& camera)
{
    const std::map<std::uint32_t, SeenLabel> labels = LabelsOf(list, camera.pixelsPerMeter);
    const Rect picture = camera.VisibleArea();
    for (const auto& [owner, label] : labels)
    {
        EXPECT_TRUE(label.box.lower.x >= picture.lower.x && label.box.upper.x <= picture.upper.x &&
                    label.box.lower.y >= picture.lower.y && label.box.upper.y <= picture.upper.y)
            << owner << " is cut";
        for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            const bool isOwn = std::uint32_t(body->GetNumber()) == owner;
            const bool lies = Holds(label.box, body->GetWorldCenter());
            const float moved = float(0.02 / camera.pixelsPerMeter); // off the middle of two pixels
            const Rect around{{label.box.lower.x - moved, label.box.lower.y - moved},
                              {label.box.upper.x + moved, label.box.upper.y + moved}};
            EXPECT_TRUE(isOwn ? Holds(around, body->GetWorldCenter()) || label.isTied ||
                                    body->GetFixtureList()->TestPoint(
                                        b2Vec2(0.5f * (label.box.lower.x + label.box.upper.x),
                                               0.5f * (label.box.lower.y + label.box.upper.y)))
                              : !lies)
                << owner << " and the centre of " << body->GetNumber();
        }
        for (const auto& [other, beside] : labels)
        {
            Rect apart = beside.box;
            apart.lower.x -= float(2.9 / camera.pixelsPerMeter);
            apart.upper.x += float(2.9 / camera.pixelsPerMeter);
            EXPECT_TRUE(owner == other || !Overlap(label.box, apart)) << owner << ", " << other;
        }
    }
}

} // namespace

TEST_F(WorldBodies, MoveNamesAsideFromSignsAndEachOther)
{
    b2CircleShape ball;
    ball.m_radius = 0.2f;
    b2Body* const near = scene.Body(b2_dynamicBody, -2.45f, 2.05f);
    scene.Add(near, ball, 0.2f, 0.0f);
    const View view = ViewOf(camera, 2.0);
    AddCenterMarks(scene.world, view, list);
    AddBodyNames(scene.world, view, {{0, "anvil"}, {2, "hammer"}}, list);
    const std::map<std::uint32_t, SeenLabel> labels = LabelsOf(list, camera.pixelsPerMeter);
    ASSERT_EQ(labels.size(), 2u);
    const Rect first = labels.at(0).box;
    const Rect second = labels.at(2).box;
    EXPECT_FALSE(Overlap(first, second));
    for (const Vec2 center : {Vec2{-2.5f, 2.0f}, Vec2{-2.45f, 2.05f}})
    {
        const Rect mark{{center.x - 0.06f, center.y - 0.06f}, {center.x + 0.06f, center.y + 0.06f}};
        EXPECT_FALSE(Overlap(first, mark));
        EXPECT_FALSE(Overlap(second, mark));
    }
    EXPECT_LT(std::abs(first.lower.x - -2.5f), 0.6f) << "but stay near";
}

namespace
{

struct Labels : testing::Test
{
    b2Body* Box(float x, float y, float halfWidth, float halfHeight)
    {
        b2PolygonShape box;
        box.SetAsBox(halfWidth, halfHeight);
        b2Body* const body = scene.Body(b2_dynamicBody, x, y);
        scene.Add(body, box, 0.2f, 0.0f);
        return body;
    }
    std::map<std::uint32_t, SeenLabel> Named(const BodyNames& names = {})
    {
        list = DrawListOf(scene.world, b2Draw::e_shapeBit);
        for (const DrawItem& item : signs.items)
        {
            list.layer = item.layer;
            list.AddSegment(signs.points[item.first], signs.points[item.first + 1], item.color);
        }
        AddBodyNames(scene.world, ViewOf(camera, 2.0), names, list);
        return LabelsOf(list, camera.pixelsPerMeter);
    }
    dynamics::Scene scene;
    Camera camera{
        .width = 320, .height = 240, .centerX = 0.0, .centerY = 0.0, .pixelsPerMeter = 100.0};
    DrawList signs; // of segments
    DrawList list;
};

} // namespace

TEST_F(Labels, LieOnTheirBodiesOrAreTiedToThem)
{
    for (int i = 0; i < 24; ++i)
    {
        Box(-1.38f + 0.12f * float(i), 0.05f * float(i % 5), 0.06f, 0.03f); // 12 px by 6
    }
    Box(0.0f, 0.33f, 0.1f, 0.1f);
    const auto labels = Named();
    EXPECT_GE(labels.size(), 21u);
    ExpectClear(scene.world, list, camera);
    EXPECT_TRUE(Holds(labels.at(24).box, b2Vec2(0.0f, 0.33f))) << "what fits in its body is in it";
    int away = 0;
    for (const auto& [owner, label] : labels)
    {
        const b2Vec2 center = scene.world.GetBodyList()->GetNumber() == int(owner)
                                  ? b2Vec2(0.0f, 0.33f)
                                  : b2Vec2(-1.38f + 0.12f * float(owner), 0.05f * float(owner % 5));
        const bool stays = Holds(label.box, center);
        EXPECT_NE(stays, label.isTied) << owner;
        away += stays ? 0 : 1;
        for (const b2Body* body = scene.world.GetBodyList(); !stays && body != nullptr;
             body = body->GetNext())
        {
            const b2AABB& box = body->GetFixtureList()->GetAABB(0);
            const float margin = b2_aabbExtension;
            const Rect shape{{box.lowerBound.x + margin, box.lowerBound.y + margin},
                             {box.upperBound.x - margin, box.upperBound.y - margin}};
            EXPECT_FALSE(Overlap(label.box, shape)) << owner << " on " << body->GetNumber();
        }
    }
    EXPECT_GE(away, 5);
}

TEST_F(Labels, AreOmittedInCrowdsRatherThanOverlapping)
{
    for (int i = 0; i < 400; ++i)
    {
        Box(-0.9f + 0.09f * float(i % 20), -0.9f + 0.09f * float(i / 20), 0.04f, 0.04f);
    }
    const auto labels = Named();
    EXPECT_LT(labels.size(), 200u);
    EXPECT_GT(labels.size(), 40u);
    ExpectClear(scene.world, list, camera);
}

TEST_F(Labels, AreAsWideAsTheirLetters)
{
    Box(-0.5f, 0.5f, 0.3f, 0.2f);
    Box(-0.2f, -0.5f, 0.02f, 0.02f);
    Box(0.26f, -0.5f, 0.02f, 0.02f); // 46 px apart, and the names are 50 px wide
    const auto labels = Named({{0, "iiiiiiiiii"}, {1, "WWWW"}, {2, "MMMM"}});
    ASSERT_EQ(labels.size(), 3u);
    EXPECT_NEAR(0.5f * (labels.at(0).box.lower.x + labels.at(0).box.upper.x), -0.5f, 1e-4f);
    EXPECT_FALSE(Overlap(labels.at(1).box, labels.at(2).box));
    EXPECT_NEAR(labels.at(1).box.upper.x - labels.at(1).box.lower.x, 0.01 * TextWidth("WWWW"),
                1e-4);
    ExpectClear(scene.world, list, camera);
}

TEST_F(Labels, LieWhollyInThePicture)
{
    Box(-1.58f, 0.0f, 0.1f, 0.1f);
    Box(1.55f, 1.18f, 0.1f, 0.1f);
    Box(0.0f, -1.19f, 0.1f, 0.1f);
    Box(1.65f, 0.0f, 0.1f, 0.1f); // in the picture with a part that is not its centre
    const auto labels = Named({{0, "a name on the left"}, {1, "up there"}});
    EXPECT_EQ(labels.size(), 3u);
    ExpectClear(scene.world, list, camera);
}

TEST_F(Labels, AvoidAnnotations)
{
    Box(0.0f, 0.0f, 0.03f, 0.03f);
    const Rect alone = Named({{0, "stone"}}).at(0).box;
    EXPECT_TRUE(Holds(alone, b2Vec2(0.0f, 0.0f)));
    Paper(signs, camera).Line({100.0, 120.0}, {220.0, 120.0}, Color{});
    const Rect beside = Named({{0, "stone"}}).at(0).box;
    EXPECT_FALSE(Overlap(beside, Rect{{-0.6f, -0.001f}, {0.6f, 0.001f}}));
}

TEST_F(Labels, IgnoreItemsBelowTheirBody)
{
    Box(0.0f, 0.0f, 0.2f, 0.2f); // a region
    Box(0.1f, 0.13f, 0.05f, 0.05f);
    const auto labels = Named({{1, "leaf"}});
    EXPECT_TRUE(Holds(labels.at(1).box, b2Vec2(0.1f, 0.13f)));
    EXPECT_FALSE(labels.at(1).isTied);
}

TEST_F(Labels, StayOnTheirBodyDespiteOtherItemsOnIt)
{
    Box(0.0f, 0.0f, 0.2f, 0.2f);
    Box(0.3f, 0.0f, 0.297f, 0.03f); // a rod that ends beside the other's centre
    EXPECT_TRUE(Holds(Named({{0, "box"}}).at(0).box, b2Vec2(0.0f, 0.0f)));
}

TEST_F(Labels, NeedNoLineOnTheirBody)
{
    Box(0.0f, 0.0f, 0.8f, 0.8f);
    Paper(signs, camera).Line({150.0, 120.0}, {170.0, 120.0}, Color{});
    const auto labels = Named({{0, "house"}});
    EXPECT_FALSE(Holds(labels.at(0).box, b2Vec2(0.0f, 0.0f)));
    EXPECT_FALSE(labels.at(0).isTied);
}

TEST_F(Labels, AreBesideBodiesThinnerThanTheirLetters)
{
    Box(0.0f, 0.0f, 0.03f, 0.8f);   // a pole
    Box(-1.0f, 0.0f, 0.01f, 0.06f); // whose label hides it
    Box(1.0f, 0.0f, 0.1f, 0.8f);    // as wide as its number
    const auto labels = Named({{0, "pole"}, {1, "bit"}, {2, "2"}});
    EXPECT_FALSE(Overlap(labels.at(0).box, Rect{{-0.05f, -0.8f}, {0.05f, 0.8f}}));
    EXPECT_TRUE(labels.at(0).isTied);
    EXPECT_TRUE(Holds(labels.at(1).box, b2Vec2(-1.0f, 0.0f)));
    EXPECT_TRUE(Holds(labels.at(2).box, b2Vec2(1.0f, 0.0f)));
}

TEST_F(Labels, StayWithinTheirBodyWhenMovedAside)
{
    Box(0.0f, 0.0f, 0.5f, 0.2f); // above the middle a label of 12 px would lie on its edge
    Paper(signs, camera).Line({158.0, 120.0}, {162.0, 120.0}, Color{});
    const Rect box = Named({{0, "box"}}).at(0).box;
    EXPECT_FALSE(Holds(box, b2Vec2(0.0f, 0.0f)));
    EXPECT_GE(box.lower.x, -0.5f);
    EXPECT_LE(box.upper.x, 0.5f);
    EXPECT_GE(box.lower.y, -0.2f);
    EXPECT_LE(box.upper.y, 0.2f);
}

TEST_F(Labels, KeepClearOfSigns)
{
    Box(0.0f, 0.0f, 0.2f, 0.2f);
    Paper(signs, camera).Line({150.0, 112.0}, {170.0, 112.0}, Color{}); // 2 px above the letters
    const Rect box = Named({{0, "0"}}).at(0).box;
    EXPECT_FALSE(Overlap(box, Rect{{-0.12f, 0.055f}, {0.12f, 0.105f}}));
}

TEST_F(WorldBodies, ShowNamesInViewInOrderOfWholeWorld)
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
            if (item.kind == DrawKind::Segment ||
                ViewOf(camera, 2.0).Shows(BoxOf(all, item, camera.pixelsPerMeter)))
            {
                expected.push_back(item.owner);
            }
        }
        EXPECT_EQ(seen, expected);
        EXPECT_GT(seen.size(), 3u);
        scene.world.GetBodyList()->GetNext()->SetActive(false); // in no tree, but drawn
    }
}

TEST_F(WorldBodies, ShowNamesOfJointsBetweenAnchors)
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
    EXPECT_NEAR(list.points[0].x, -2.0 - 0.005 * TextWidth("knee"), 1e-4);
    list.Clear();
    camera.centerX = 100.0;
    AddJointNames(scene.world, ViewOf(camera, 2.0), {{named, "knee"}}, list);
    EXPECT_TRUE(list.items.empty());
}
