// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <debugdraw/WorldArrows.h>

#include <gtest/gtest.h>

using namespace boxreel;

namespace
{

struct WorldArrows : testing::Test
{
    dynamics::Scene scene;
    Camera camera{.width = 200, .height = 200, .centerY = 0.0, .pixelsPerMeter = 10.0};
    DrawList list;
    View Everything() const { return ViewOfEverything(camera); }
};

/// A ball of pi kg that hangs from a rod.
b2Joint* Hang(dynamics::Scene& scene)
{
    b2Body* const ceiling = scene.Body(b2_staticBody, 0.0f, 5.0f);
    b2Body* const ball = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    scene.AddBall(ball, 1.0f);
    b2DistanceJointDef rod;
    rod.Initialize(ceiling, ball, b2Vec2(0.0f, 5.0f), b2Vec2(0.0f, 0.0f));
    return scene.world.CreateJoint(&rod);
}

} // namespace

TEST_F(WorldArrows, ShowDisplacementInGivenSeconds)
{
    scene.Body(b2_staticBody, 9.0f, 9.0f);
    b2Body* const box = scene.Box(1.0f, 2.0f);
    box->SetLinearVelocity(b2Vec2(4.0f, -8.0f));
    AddVelocities(scene.world, Everything(), 0.25, list);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].layer, DrawLayer::Velocities);
    EXPECT_EQ(list.items[0].owner, 1u);
    EXPECT_EQ(list.points[0], (Vec2{1.0f, 2.0f})) << "from the centre of mass";
    EXPECT_EQ(list.points[2], (Vec2{2.0f, 0.0f})) << "to the tip";
    EXPECT_EQ(list.owner, kNoOwner);
}

TEST_F(WorldArrows, AreNotDrawnForBodiesAtRest)
{
    scene.Box(1.0f, 2.0f);
    scene.Box(5.0f, 2.0f)->SetLinearVelocity(b2Vec2(0.1f, 0.0f)); // a pixel at most
    AddVelocities(scene.world, Everything(), 1.0, list);
    EXPECT_TRUE(list.items.empty());
}

TEST_F(WorldArrows, AreKeptIfLegibleOnceEnlarged)
{
    scene.Box(5.0f, 2.0f)->SetLinearVelocity(b2Vec2(0.1f, 0.0f)); // one pixel
    View view = Everything();
    view.zoom = 2.0;
    AddVelocities(scene.world, view, 1.0, list);
    EXPECT_EQ(list.items.size(), 1u) << "all head";
    list.Clear();
    view.zoom = 1.4;
    AddVelocities(scene.world, view, 1.0, list);
    EXPECT_TRUE(list.items.empty());
}

TEST_F(WorldArrows, AreDrawnWhenTheirTipIsVisible)
{
    scene.Box(15.0f, 0.0f)->SetLinearVelocity(b2Vec2(-100.0f, 0.0f));
    AddVelocities(scene.world, ViewOf(camera, 2.0), 0.01, list);
    EXPECT_TRUE(list.items.empty()) << "from 15 m to 14 m, and the picture ends at 10 m";
    AddVelocities(scene.world, ViewOf(camera, 2.0), 0.1, list);
    EXPECT_EQ(list.items.size(), 2u);
}

TEST_F(WorldArrows, ShowWeightHeldByJoint)
{
    const b2Joint* const rod = Hang(scene);
    for (int i = 0; i < 60; ++i)
    {
        scene.world.Step(dynamics::kStep, 8, 3);
    }
    AddJointForces(scene.world, Everything(), 0.1, list);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].layer, DrawLayer::JointForces);
    const double weight = 10.0 * double(rod->GetBodyB()->GetMass());
    EXPECT_NEAR(list.points[2].y - list.points[0].y, 0.1 * weight, 0.05) << "up, on the ball";
    EXPECT_NEAR(list.points[2].x, 0.0f, 1e-4f);
    list.Clear();
    camera.centerX = 100.0;
    AddJointForces(scene.world, ViewOf(camera, 2.0), 0.1, list);
    EXPECT_TRUE(list.items.empty());
}

TEST_F(WorldArrows, HaveForceScaleThatSuitsTheWorld)
{
    EXPECT_GT(MetersPerNewtonFor(scene.world), 0.0) << "an empty one";
    scene.Box(0.0f, 0.0f, 0.5f, 0.5f); // 1 kg
    scene.Box(0.0f, 9.0f, 1.5f, 1.5f); // 9 kg
    scene.AddBox(scene.Body(b2_staticBody, 0.0f, 0.0f), 500.0f, 500.0f);
    // Sizes 1 m and 3 m, and a skin of a centimetre; weights 10 N and 90 N.
    EXPECT_NEAR(MetersPerNewtonFor(scene.world) * 50.0, 2.02 / 8.0, 1e-4);
    scene.world.SetGravity(b2Vec2(0.0f, 0.0f));
    EXPECT_NEAR(MetersPerNewtonFor(scene.world) * 50.0, 2.02 / 8.0, 1e-4);
}

TEST_F(WorldArrows, AreOrderedByBodyAgeAfterSleep)
{
    for (int i = 0; i < 6; ++i)
    {
        scene.Box(float(i), 0.0f);
    }
    std::vector<b2Body*> bodies;
    for (b2Body* body = scene.world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        bodies.push_back(body);
    }
    for (const int sleeper : {5, 1, 3})
    {
        bodies[std::size_t(sleeper)]->SetAwake(false);
    }
    for (b2Body* const body : bodies)
    {
        body->SetLinearVelocity(b2Vec2(0.0f, 3.0f)); // wakes it
    }
    bodies[2]->SetAwake(false);
    AddVelocities(scene.world, Everything(), 1.0, list);
    std::vector<std::uint32_t> owners;
    for (const DrawItem& item : list.items)
    {
        owners.push_back(item.owner);
    }
    EXPECT_EQ(owners, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 4, 4, 5, 5}));
}
