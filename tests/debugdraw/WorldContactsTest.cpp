// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <debugdraw/Theme.h>
#include <debugdraw/WorldContacts.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace boxreel;
using dynamics::kStep;

namespace
{

/// A box of 4 kg comes to rest on the ground.
struct RestingContacts : testing::Test
{
    dynamics::Scene scene;
    b2Body* box = nullptr;
    ContactCollector contacts;
    Camera camera{.width = 200, .height = 200, .centerY = 0.0, .pixelsPerMeter = 20.0};
    ContactLook look;

    explicit RestingContacts(float32 height = 1.01f)
    {
        b2EdgeShape ground;
        ground.Set(b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        scene.Add(scene.Body(b2_staticBody, 0.0f, 0.0f), ground, 0.6f, 0.0f);
        box = scene.Box(0.0f, height, 1.0f, 1.0f);
    }
    void Step(int count = 1)
    {
        for (int i = 0; i < count; ++i)
        {
            contacts.Remember(scene.world);
            scene.world.Step(kStep, 8, 3);
        }
    }
    DrawList Collected()
    {
        DrawList list;
        contacts.Collect(scene.world, ViewOfEverything(camera), look, list);
        EXPECT_EQ(list.owner, kNoOwner);
        return list;
    }
    /// Returns the height of the highest item [m].
    static double HeightOf(const DrawList& list)
    {
        Rect bounds;
        for (const Vec2 point : list.points)
        {
            bounds.Include(point);
        }
        return double(bounds.upper.y);
    }
};

} // namespace

TEST_F(RestingContacts, HavePointsWhereTheBodiesTouch)
{
    Step(60);
    look.points = true;
    const DrawList list = Collected();
    ASSERT_EQ(list.items.size(), 2u);
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.kind, DrawKind::Point);
        EXPECT_EQ(item.layer, DrawLayer::Contacts);
        EXPECT_NEAR(std::abs(list.points[item.first].x), 1.0f, 0.02f);
        EXPECT_NEAR(list.points[item.first].y, 0.0f, 0.02f);
    }
}

TEST_F(RestingContacts, AreNewInOneStepAndOldInTheNext)
{
    look.points = true;
    for (int i = 0; i < 60 && Collected().items.empty(); ++i)
    {
        Step();
    }
    ASSERT_EQ(Collected().items.size(), 2u);
    EXPECT_EQ(Collected().items[0].role, ColorRole::NewContact);
    EXPECT_EQ(Collected().items[0].role, ColorRole::NewContact) << "looking ages nothing";
    const float newSize = Collected().items[0].size;
    Step();
    EXPECT_EQ(Collected().items[0].role, ColorRole::OldContact);
    EXPECT_EQ(Collected().items[1].role, ColorRole::OldContact);
    EXPECT_LT(Collected().items[0].size, newSize);
    box->SetTransform(b2Vec2(0.0f, 5.0f), 0.0f);
    Step();
    EXPECT_TRUE(Collected().items.empty());
    box->SetTransform(b2Vec2(0.0f, 1.0f), 0.0f);
    Step();
    ASSERT_EQ(Collected().items.size(), 2u);
    EXPECT_EQ(Collected().items[0].role, ColorRole::NewContact) << "they were away";
}

TEST_F(RestingContacts, HaveImpulsesThatCarryTheWeight)
{
    Step(120);
    look.impulses = true;
    look.metersPerNewton = 0.1;
    const DrawList list = Collected();
    double sum = 0.0;
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.layer, DrawLayer::ContactImpulses);
        if (item.kind == DrawKind::SolidPolygon)
        {
            sum += double(list.points[item.first].y); // the tip; the tail is at the ground
        }
    }
    EXPECT_NEAR(sum, 0.1 * 4.0 * 10.0, 0.05) << "4 kg at 10 m/s^2";
}

TEST_F(RestingContacts, KeepsArrowsThatAreLegibleOnceEnlarged)
{
    Step(60);
    look.impulses = true;
    look.metersPerNewton = 0.002; // 20 N at each corner: less than a pixel
    EXPECT_TRUE(Collected().items.empty());
    View view = ViewOfEverything(camera);
    view.zoom = 4.0;
    DrawList list;
    contacts.Collect(scene.world, view, look, list);
    EXPECT_EQ(list.items.size(), 2u) << "all head";
}

TEST_F(RestingContacts, HaveArrowsIndependentOfStepLength)
{
    look.impulses = true;
    look.metersPerNewton = 0.1;
    box->SetSleepingAllowed(false); // its impulses would stay those of the last step
    Step(120);
    const double long60 = HeightOf(Collected());
    for (int i = 0; i < 240; ++i)
    {
        scene.world.Step(kStep / 4.0f, 8, 3);
    }
    look.stepsPerSecond = 240.0;
    EXPECT_NEAR(HeightOf(Collected()), long60, 0.03 * long60);
}

TEST_F(RestingContacts, HaveNormalsOfEqualPixelsInEveryView)
{
    Step(60);
    look.normals = true;
    EXPECT_NEAR(HeightOf(Collected()), 12.0 / 20.0, 0.02) << "from the ground upwards";
    camera.pixelsPerMeter = 100.0;
    EXPECT_NEAR(HeightOf(Collected()), 12.0 / 100.0, 0.02);
    EXPECT_EQ(Collected().items[0].layer, DrawLayer::ContactNormals);
    EXPECT_EQ(Collected().items[0].role, ColorRole::ContactNormal);
}

TEST_F(RestingContacts, HaveFrictionAgainstSliding)
{
    Step(60);
    look.friction = true;
    look.metersPerNewton = 0.1;
    EXPECT_TRUE(Collected().items.empty()) << "nothing pulls";
    box->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    Step();
    const DrawList list = Collected();
    ASSERT_FALSE(list.items.empty());
    double sum = 0.0;
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.layer, DrawLayer::ContactFriction);
        EXPECT_EQ(item.role, ColorRole::ContactFriction);
        EXPECT_EQ(item.kind, DrawKind::Segment) << "impulses have filled heads, friction has not";
        sum += double(list.points[item.first + 1].x) - double(list.points[item.first].x);
    }
    EXPECT_LT(sum, -0.5) << "to the left";
}

TEST_F(RestingContacts, AreNotCollectedWhenOffOrFarAway)
{
    Step(60);
    EXPECT_TRUE(Collected().items.empty());
    look = {.points = true, .normals = true, .impulses = true};
    EXPECT_FALSE(Collected().items.empty());
    camera.centerX = 1000.0;
    DrawList list;
    contacts.Collect(scene.world, ViewOf(camera, 8.0), look, list);
    EXPECT_TRUE(list.items.empty());
}
