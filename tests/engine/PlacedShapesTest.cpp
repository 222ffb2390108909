// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Box2D/Dynamics/b2Snapshot.h>

#include <gtest/gtest.h>

/// With sub-steps, shapes that a program puts into each other's skins stay where they are.
namespace
{

using namespace dynamics;

/// A scene with a ground whose top is at y = 0.
class Placed : public Scene
{
public:
    explicit Placed(int32 subSteps)
    {
        world.SetSubStepCount(subSteps);
        world.SetAllowSleeping(false);
        Ground();
    }
};

TEST(PlacedShapes, StayWhereTheyTouch)
{
    for (const int32 subSteps : {2, 4, 16})
    {
        Placed scene(subSteps);
        const b2Body* lower = scene.Box(0.0f, 0.5f);
        const b2Body* upper = scene.Box(0.2f, 1.5f);
        scene.Step(300);
        EXPECT_NEAR(lower->GetPosition().y, 0.5f, 1e-4f) << subSteps;
        EXPECT_NEAR(upper->GetPosition().y, 1.5f, 1e-4f) << subSteps;
        EXPECT_NEAR(upper->GetPosition().x, 0.2f, 1e-4f) << subSteps;
        EXPECT_LT(DeepestOverlap(scene.world), b2_linearSlop) << subSteps;
    }
}

TEST(PlacedShapes, StayOnAFastPlatform)
{
    for (const int32 subSteps : {2, 4, 8})
    {
        for (const b2Vec2& velocity : {b2Vec2(20.0f, 0.0f), b2Vec2(0.0f, 40.0f),
                                       b2Vec2(-30.0f, 30.0f), b2Vec2(100.0f, 0.0f)})
        {
            Scene scene;
            scene.world.SetSubStepCount(subSteps);
            b2Body* const platform = scene.Body(b2_kinematicBody, 0.0f, -1.0f);
            Scene::AddBox(platform, 4.0f, 1.0f);
            b2Body* const lower = scene.Box(0.0f, 0.5f);
            b2Body* const upper = scene.Box(0.2f, 1.5f);
            for (b2Body* body : {platform, lower, upper})
            {
                body->SetLinearVelocity(velocity);
            }
            scene.Step(120);
            EXPECT_NEAR(lower->GetPosition().x - platform->GetPosition().x, 0.0f, 1e-3f);
            EXPECT_NEAR(lower->GetPosition().y - platform->GetPosition().y, 1.5f, 1e-3f);
            EXPECT_NEAR(upper->GetPosition().x - platform->GetPosition().x, 0.2f, 1e-3f);
            EXPECT_NEAR(upper->GetPosition().y - platform->GetPosition().y, 2.5f, 1e-3f)
                << subSteps << " sub-steps, " << velocity.x << " m/s, " << velocity.y << " m/s";
        }
    }
}

/// Returns the height at which a box comes to rest that is put at `y` with a velocity upwards [m].
float32 RestingHeight(int32 subSteps, float32 y, float32 velocity = 0.0f)
{
    Placed scene(subSteps);
    b2Body* box = scene.Box(0.0f, y);
    box->SetLinearVelocity(b2Vec2(0.0f, velocity));
    scene.Step(300);
    return box->GetPosition().y;
}

TEST(PlacedShapes, ArePushedOutOfTheirSkinsInOneStep)
{
    EXPECT_NEAR(RestingHeight(1, 0.5f), 0.5f + kRestingGap, 0.003f);
}

TEST(PlacedShapes, LeaveOneAnotherButNotTheirSkins)
{
    const float32 height = RestingHeight(4, 0.46f); // 4 cm in the ground
    EXPECT_GT(height, 0.5f - b2_linearSlop);
    EXPECT_LT(height, 0.5f + 0.001f);
}

TEST(PlacedShapes, KeepTheirSkinsIfTheyLand)
{
    EXPECT_NEAR(RestingHeight(4, 0.6f), 0.5f + kRestingGap, 0.003f);
}

/// What lands in the step in which it was put somewhere was not put there.
TEST(PlacedShapes, KeepTheirSkinsIfTheyLandInTheirFirstStep)
{
    EXPECT_NEAR(RestingHeight(4, 0.8f, -60.0f), 0.5f + kRestingGap, 0.003f);
}

TEST(PlacedShapes, GetTheirSkinsBackWhenTheyPart)
{
    Placed scene(4);
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(60);
    ASSERT_NEAR(box->GetPosition().y, 0.5f, 1e-4f);
    box->SetLinearVelocity(b2Vec2(0.0f, 3.0f));
    scene.Step(300);
    EXPECT_NEAR(box->GetPosition().y, 0.5f + kRestingGap, 0.003f);
}

TEST(PlacedShapes, MayBePutAnywhereLater)
{
    Placed scene(4);
    b2Body* box = scene.Box(0.0f, 3.0f);
    scene.Step(10);
    box->SetTransform(b2Vec2(1.0f, 0.5f), 0.0f);
    box->SetLinearVelocity(b2Vec2_zero);
    scene.Step(120);
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 1e-4f);

    b2Body* wall = scene.Body(b2_staticBody, 2.0f, 0.0f);
    Scene::AddBox(wall, 0.5f, 2.0f); // beside the box
    scene.Step(120);
    EXPECT_NEAR(box->GetPosition().x, 1.0f, 1e-4f);
}

TEST(PlacedShapes, MayBePutTogetherWhereTheyTouch)
{
    Placed scene(4);
    b2Body* box = scene.Box(0.0f, 0.5f + kRestingGap);
    scene.Step(60);
    box->SetTransform(b2Vec2(1.0f, 0.5f), 0.0f);
    scene.Step(60);
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 1e-4f);
}

/// On the outline of an edge, a box would catch on the end of the next edge.
TEST(PlacedShapes, SlideOverSeparateEdges)
{
    for (const b2BodyType type : {b2_staticBody, b2_kinematicBody, b2_dynamicBody})
    {
        Scene scene;
        scene.world.SetSubStepCount(4);
        b2Body* ground = scene.Body(type, 0.0f, 0.0f);
        ground->SetGravityScale(0.0f);
        for (int i = -5; i < 35; ++i)
        {
            b2EdgeShape edge;
            edge.Set(b2Vec2(float32(i), 0.0f), b2Vec2(float32(i + 1), 0.0f));
            Scene::Add(ground, edge, 0.0f, 0.0f);
        }
        b2MassData heavy;
        heavy.mass = heavy.I = 1e6f;
        ground->SetMassData(&heavy);
        b2Body* box = scene.Box(0.0f, 0.5f, 0.4f, 0.5f);
        box->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
        scene.Step(180);
        EXPECT_NEAR(box->GetPosition().x, 9.0f, 0.01f) << type;
        EXPECT_NEAR(box->GetAngle(), 0.0f, 0.01f) << type;
    }
}

/// A ground of boxes, each 2 m wide, whose top is at y = 0.
void AddTiles(Scene& scene)
{
    for (int i = 0; i < 20; ++i)
    {
        Scene::AddBox(scene.Body(b2_staticBody, 2.0f * float32(i), -0.5f), 1.0f, 0.5f, 0.0f);
    }
}

TEST(PlacedShapes, SlideOverSeparateBoxes)
{
    for (const float32 start : {0.0f, 0.5f, 0.55f, 1.0f})
    {
        Scene scene;
        scene.world.SetSubStepCount(4);
        AddTiles(scene);
        b2Body* box = scene.Box(start, 0.5f, 0.4f, 0.5f);
        box->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
        scene.Step(180);
        EXPECT_NEAR(box->GetPosition().x, start + 9.0f, 0.05f) << start;
        EXPECT_NEAR(box->GetAngle(), 0.0f, 0.01f) << start;
    }
}

/// It rises before it comes to the end of the first box.
TEST(PlacedShapes, SlideOverSeparateBoxesWhenTheyArePushedLater)
{
    for (const float32 force : {0.05f, 0.2f, 1.0f})
    {
        Scene scene;
        scene.world.SetSubStepCount(4);
        scene.world.SetAllowSleeping(false);
        AddTiles(scene);
        b2Body* box = scene.Box(0.0f, 0.5f, 0.4f, 0.5f);
        scene.Step(30);
        ASSERT_NEAR(box->GetPosition().y, 0.5f, 1e-4f);
        for (int step = 0; step < 1200 && box->GetPosition().x < 0.55f; ++step)
        {
            box->ApplyForceToCenter(b2Vec2(force, 0.0f), true);
            scene.Step();
        }
        EXPECT_GE(box->GetPosition().x, 0.55f) << force;
        EXPECT_NEAR(box->GetPosition().y, 0.5f + kRestingGap, 0.003f) << force;
    }
}

/// Only the skin of a shape gets thinner, not a rounding that the program gave to it.
TEST(PlacedShapes, KeepARoundingOfTheirOwn)
{
    Placed scene(4);
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.55f);
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f);
    shape.m_radius = 0.1f;
    Scene::Add(body, shape, 0.2f, 0.0f);
    scene.Step(300);
    EXPECT_NEAR(body->GetPosition().y, 0.5f + 0.1f - b2_polygonRadius, b2_linearSlop);
}

TEST(PlacedShapes, StayWhereTheyTouchAGroundIfTheyAreRound)
{
    for (const float32 height : {0.5f, 0.501f})
    {
        for (int i = 0; i < 8; ++i)
        {
            Placed scene(4);
            const b2Body* ball = scene.Ball(0.1f * float32(i), height);
            scene.Step(120);
            EXPECT_NEAR(ball->GetPosition().y, height, 1e-4f) << i;
        }
    }
}

TEST(PlacedShapes, HaveNoSkinsIfTheyAreRound)
{
    Placed scene(4);
    const b2Body* lower = scene.Ball(0.0f, 0.5f);
    const b2Body* upper = scene.Ball(0.0f, 1.45f);
    scene.Step(60);
    EXPECT_NEAR(lower->GetPosition().y, 0.5f, b2_linearSlop);
    EXPECT_NEAR(upper->GetPosition().y - lower->GetPosition().y, 1.0f, 2.0f * b2_linearSlop);
}

TEST(PlacedShapes, GoOnFromASnapshotAsTheyWere)
{
    Placed scene(4);
    scene.Box(0.0f, 0.5f);
    scene.Box(0.3f, 1.5f);
    scene.Step(20);
    const std::vector<uint8> bytes = b2SaveSnapshot(scene.world);
    Placed other(1);
    ASSERT_EQ(b2RestoreSnapshot(other.world, bytes.data(), bytes.size()), nullptr);
    scene.Step(60);
    other.Step(60);
    EXPECT_EQ(b2SaveSnapshot(other.world), b2SaveSnapshot(scene.world));
    EXPECT_NEAR(other.world.GetBodyList()->GetPosition().y, 1.5f, 1e-4f);
}

} // namespace
