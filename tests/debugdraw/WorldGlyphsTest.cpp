// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <debugdraw/WorldGlyphs.h>

#include <gmock/gmock.h>

#include <cmath>

using namespace boxreel;

namespace
{

Rect BoundsOf(const DrawList& list)
{
    Rect bounds;
    for (const DrawItem& item : list.items)
    {
        for (std::size_t i = 0; i < item.count && item.kind != DrawKind::Text; ++i)
        {
            bounds.Include(list.points[item.first + i]);
        }
    }
    return bounds;
}

struct WorldGlyphs : testing::Test
{
    dynamics::Scene scene;
    Camera camera{.width = 400, .height = 400, .centerY = 0.0, .pixelsPerMeter = 40.0};
    b2Body* a = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* b = scene.Box(3.0f, 0.0f);

    DrawList Glyphs() const
    {
        DrawList list;
        AddJointGlyphs(scene.world, ViewOfEverything(camera), list);
        return list;
    }
    template <class Definition>
    void Join(Definition definition)
    {
        definition.bodyA = a;
        definition.bodyB = b;
        scene.world.CreateJoint(&definition);
    }
};

} // namespace

TEST_F(WorldGlyphs, DrawHingeAsCircleWithDotOfFixedPixelSize)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(a, b, b2Vec2(1.0f, 2.0f));
    Join(hinge);
    for (const double zoom : {40.0, 400.0})
    {
        camera.pixelsPerMeter = zoom;
        const DrawList list = Glyphs();
        ASSERT_EQ(list.items.size(), 2u);
        EXPECT_EQ(list.items[0].kind, DrawKind::Circle);
        EXPECT_FLOAT_EQ(list.items[0].size, float(6.0 / zoom));
        EXPECT_EQ(list.items[1].kind, DrawKind::Point);
        EXPECT_EQ(list.points[0], (Vec2{1.0f, 2.0f}));
        EXPECT_EQ(list.items[0].layer, DrawLayer::JointGlyphs);
        EXPECT_EQ(list.items[0].owner, kNoOwner);
    }
}

TEST_F(WorldGlyphs, ShowDirectionOfMotorByArrow)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(a, b, b2Vec2(0.0f, 0.0f));
    hinge.enableMotor = true;
    hinge.motorSpeed = 1.0f;
    Join(hinge);
    const DrawList left = Glyphs();
    static_cast<b2RevoluteJoint*>(scene.world.GetJointList())->SetMotorSpeed(-1.0f);
    const DrawList right = Glyphs();
    EXPECT_GT(left.items.size(), 10u);
    EXPECT_NE(left, right);
    EXPECT_LT(left.points[left.items.back().first].x, 0.0f);
    EXPECT_LT(left.points[left.items.back().first].y, 0.0f) << "down on the left";
}

TEST_F(WorldGlyphs, DrawRailToItsLimits)
{
    b2PrismaticJointDef slider;
    slider.Initialize(a, b, b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, 1.0f));
    slider.enableLimit = true;
    slider.lowerTranslation = -2.0f;
    slider.upperTranslation = 4.0f;
    Join(slider);
    const Rect bounds = BoundsOf(Glyphs());
    EXPECT_FLOAT_EQ(bounds.lower.y, -2.0f);
    EXPECT_FLOAT_EQ(bounds.upper.y, 4.0f);
}

TEST_F(WorldGlyphs, DrawSpringWhenSoftAndBarWhenStiff)
{
    b2DistanceJointDef distance;
    distance.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(3.0f, 0.0f));
    Join(distance);
    EXPECT_EQ(Glyphs().items.size(), 4u) << "two lines, two pins";
    static_cast<b2DistanceJoint*>(scene.world.GetJointList())->SetFrequency(4.0f);
    EXPECT_EQ(Glyphs().items.size(), 13u) << "a line of eleven pieces, two pins";
    camera.pixelsPerMeter = 1.0;
    EXPECT_EQ(Glyphs().items.size(), 4u) << "no blot";
}

TEST_F(WorldGlyphs, DrawSaggingRopeWithItsLength)
{
    b2RopeJointDef rope;
    rope.localAnchorA.SetZero();
    rope.localAnchorB.SetZero();
    rope.maxLength = 5.0f;
    Join(rope);
    const DrawList slack = Glyphs();
    EXPECT_THAT(slack.texts, testing::ElementsAre("5.0 m"));
    EXPECT_LT(BoundsOf(slack).lower.y, -1.5f);
    EXPECT_GT(BoundsOf(slack).lower.y, -2.5f);
    b->SetTransform(b2Vec2(5.0f, 0.0f), 0.0f);
    const DrawList taut = Glyphs();
    EXPECT_NEAR(BoundsOf(taut).lower.y, 0.0f, 1e-4f);
    b->SetTransform(b2Vec2(0.0f, 0.0f), 0.0f);
    EXPECT_NEAR(BoundsOf(Glyphs()).lower.y, -2.5f, 0.1f) << "both ends in one place";
}

TEST_F(WorldGlyphs, DrawSlackVerticalRopeWithAWidth)
{
    b2RopeJointDef rope;
    rope.localAnchorA.SetZero();
    rope.localAnchorB.SetZero();
    rope.maxLength = 5.0f;
    Join(rope);
    for (const float y : {-3.0f, 3.0f, 0.0f})
    {
        b->SetTransform(b2Vec2(0.0f, y), 0.0f);
        const Rect bounds = BoundsOf(Glyphs());
        EXPECT_GT(bounds.upper.x - bounds.lower.x, 0.8f) << y;
    }
    b->SetTransform(b2Vec2(0.0f, -5.0f), 0.0f);
    const Rect taut = BoundsOf(Glyphs());
    EXPECT_NEAR(taut.upper.x - taut.lower.x, 0.0f, 1e-4f);
}

TEST_F(WorldGlyphs, DrawGearAroundItsHinges)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(a, b, b2Vec2(3.0f, 0.0f));
    hinge.enableMotor = true;
    Join(hinge);
    const double hingeReach = (BoundsOf(Glyphs()).upper.x - 3.0) * camera.pixelsPerMeter;
    b2GearJointDef gear;
    gear.joint1 = scene.world.GetJointList();
    gear.bodyA = b;
    gear.bodyB = scene.Box(0.0f, 3.0f);
    hinge.Initialize(a, gear.bodyB, b2Vec2(0.0f, 3.0f));
    gear.joint2 = scene.world.CreateJoint(&hinge);
    const std::size_t hinges = Glyphs().items.size();
    scene.world.CreateJoint(&gear);
    const DrawList list = Glyphs();
    ASSERT_GT(list.items.size(), hinges);
    EXPECT_EQ(list.items[hinges].kind, DrawKind::Circle);
    EXPECT_GT(list.items[hinges].size * camera.pixelsPerMeter, hingeReach) << "and its motor";
}

TEST_F(WorldGlyphs, DrawADifferentSignForEachKind)
{
    b2RevoluteJointDef revolute;
    revolute.Initialize(a, b, b2Vec2(0.0f, 0.0f));
    b2PrismaticJointDef prismatic;
    prismatic.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    b2DistanceJointDef distance;
    distance.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(3.0f, 0.0f));
    b2PulleyJointDef pulley;
    pulley.Initialize(a, b, b2Vec2(0.0f, 4.0f), b2Vec2(3.0f, 4.0f), b2Vec2(0.0f, 0.0f),
                      b2Vec2(3.0f, 0.0f), 1.0f);
    b2WheelJointDef wheel;
    wheel.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 1.0f));
    b2WeldJointDef weld;
    weld.Initialize(a, b, b2Vec2(0.0f, 0.0f));
    b2RopeJointDef rope;
    rope.maxLength = 3.0f;
    b2FrictionJointDef friction;
    friction.Initialize(a, b, b2Vec2(0.0f, 0.0f));
    b2MouseJointDef mouse;
    mouse.target.Set(3.0f, 0.0f);
    mouse.maxForce = 1.0f;
    b2MotorJointDef motor;
    motor.Initialize(a, b);
    std::vector<DrawList> signs;
    const auto take = [&](const auto& definition) {
        Join(definition);
        signs.push_back(Glyphs());
        EXPECT_FALSE(signs.back().items.empty()) << signs.size();
        scene.world.DestroyJoint(scene.world.GetJointList());
    };
    take(revolute);
    take(prismatic);
    take(distance);
    take(pulley);
    take(wheel);
    take(weld);
    take(rope);
    take(friction);
    take(mouse);
    take(motor);
    Join(revolute);
    b2GearJointDef gear;
    gear.joint1 = scene.world.GetJointList();
    b2Body* const c = scene.Box(0.0f, 3.0f);
    revolute.Initialize(a, c, b2Vec2(0.0f, 3.0f));
    gear.joint2 = scene.world.CreateJoint(&revolute);
    const DrawList hinges = Glyphs();
    gear.bodyA = b;
    gear.bodyB = c;
    scene.world.CreateJoint(&gear);
    EXPECT_GT(Glyphs().items.size(), hinges.items.size() + 16) << "two wheels with eight teeth";
    for (std::size_t i = 0; i < signs.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            EXPECT_NE(signs[i], signs[j]) << i << " and " << j;
        }
    }
}

TEST_F(WorldGlyphs, HaveAnchorsThatKeepTheirSizeWhenEnlarged)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(a, b, b2Vec2(1.0f, 2.0f));
    hinge.enableMotor = true;
    Join(hinge);
    b2DistanceJointDef spring;
    spring.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(3.0f, 0.0f));
    spring.frequencyHz = 2.0f;
    Join(spring);
    Join(b2WeldJointDef());
    Join(b2MotorJointDef()); // with a dashed line, which a viewer draws
    const auto glyphsForViewers = [this] {
        View view = ViewOfEverything(camera);
        view.zoom = 64.0;
        DrawList glyphs;
        AddJointGlyphs(scene.world, view, glyphs);
        return glyphs;
    };
    const DrawList film = glyphsForViewers();
    const std::vector<Vec2> anchors =
        JointGlyphAnchors(scene.world, ViewOfEverything(camera), 64.0);
    ASSERT_EQ(anchors.size(), film.points.size());
    const double zoom = 3.0;
    camera.pixelsPerMeter *= zoom;
    const DrawList enlarged = glyphsForViewers();
    std::size_t compared = 0;
    for (; compared < film.points.size(); ++compared)
    {
        const Vec2 p = film.points[compared];
        const Vec2 w = anchors[compared];
        EXPECT_NEAR(w.x + (p.x - w.x) / zoom, enlarged.points[compared].x, 1e-5) << compared;
        EXPECT_NEAR(w.y + (p.y - w.y) / zoom, enlarged.points[compared].y, 1e-5) << compared;
    }
    EXPECT_GT(compared, 80u);
}

TEST_F(WorldGlyphs, HaveBothFormsOfASpringForViewers)
{
    b2DistanceJointDef spring;
    spring.Initialize(a, b, b2Vec2(0.0f, 0.0f), b2Vec2(3.0f, 0.0f));
    spring.frequencyHz = 2.0f;
    Join(spring);
    std::map<float, int> counts; // of lines, by size
    View view = ViewOfEverything(camera);
    view.zoom = 64.0;
    DrawList list;
    AddJointGlyphs(scene.world, view, list);
    for (const DrawItem& item : list.items)
    {
        counts[item.size] += item.kind == DrawKind::Segment ? 1 : 0;
    }
    EXPECT_EQ(counts[-14.0f], 2) << "while it is short";
    EXPECT_GT(counts[14.0f], 6) << "from then on";
    for (const DrawItem& item : Glyphs().items)
    {
        EXPECT_TRUE(item.kind != DrawKind::Segment || item.size == 0.0f);
    }
}

TEST_F(WorldGlyphs, AreOmittedOutsideThePicture)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(a, b, b2Vec2(1.0f, 2.0f));
    Join(hinge);
    DrawList list;
    camera.centerX = 100.0;
    AddJointGlyphs(scene.world, ViewOf(camera, 2.0), list);
    EXPECT_TRUE(list.items.empty());
    camera.centerX = 6.05; // the picture begins 2 px beside the anchor, within the circle
    AddJointGlyphs(scene.world, ViewOf(camera, 2.0), list);
    EXPECT_FALSE(list.items.empty());
}
