// SPDX-License-Identifier: MIT
#include <debugdraw/WorldBounds.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

constexpr float kSkin = 0.05f; // polygons are boxed with their skin

struct WorldBoundsFixture : testing::Test
{
    b2Body* Add(b2BodyType type, float x, float y, float halfWidth, float halfHeight)
    {
        b2BodyDef definition;
        definition.type = type;
        definition.position.Set(x, y);
        b2Body* body = world.CreateBody(&definition);
        b2PolygonShape box;
        box.SetAsBox(halfWidth, halfHeight);
        body->CreateFixture(&box, 1.0f);
        return body;
    }

    static void ExpectNear(const Rect& rect, float x0, float y0, float x1, float y1)
    {
        EXPECT_NEAR(rect.lower.x, x0, kSkin);
        EXPECT_NEAR(rect.lower.y, y0, kSkin);
        EXPECT_NEAR(rect.upper.x, x1, kSkin);
        EXPECT_NEAR(rect.upper.y, y1, kSkin);
    }

    b2World world{b2Vec2(0.0f, -10.0f)};
};

using WorldBounds = WorldBoundsFixture;

TEST_F(WorldBounds, IncludeMovableBodiesAtStart)
{
    Add(b2_dynamicBody, -3.0f, 2.0f, 1.0f, 1.0f);
    Add(b2_kinematicBody, 5.0f, 8.0f, 1.0f, 0.5f);
    ExpectNear(BoundsAtStart(world), -4.0f, 1.0f, 6.0f, 8.5f);
}

TEST_F(WorldBounds, IncludeWideGroundOnlyNearMovableBodies)
{
    Add(b2_dynamicBody, 0.0f, 5.0f, 2.0f, 4.0f);
    Add(b2_staticBody, 0.0f, 0.0f, 500.0f, 0.5f);
    // The mover is 4 by 8 m: half of 8 around it.
    ExpectNear(BoundsAtStart(world), -6.0f, -0.5f, 6.0f, 9.0f);
}

TEST_F(WorldBounds, IncludeAnchorsInTheAir)
{
    b2Body* ball = Add(b2_dynamicBody, 0.0f, 0.0f, 1.0f, 1.0f);
    b2BodyDef nothing;
    b2DistanceJointDef rope;
    rope.Initialize(world.CreateBody(&nothing), ball, b2Vec2(0.0f, 12.0f), ball->GetPosition());
    world.CreateJoint(&rope);
    ExpectNear(BoundsAtStart(world), -1.0f, -1.0f, 1.0f, 12.0f);
}

TEST_F(WorldBounds, IncludeAllOfAStaticWorld)
{
    Add(b2_staticBody, 0.0f, 0.0f, 500.0f, 0.5f);
    ExpectNear(BoundsAtStart(world), -500.0f, -0.5f, 500.0f, 0.5f);
}

TEST_F(WorldBounds, IncludeWhatIsDrawnBesideTheWorld)
{
    const Rect picture{{-20.0f, -1.0f}, {3.0f, 30.0f}};
    ExpectNear(BoundsAtStart(world, picture), -20.0f, -1.0f, 3.0f, 30.0f);
    Add(b2_dynamicBody, 5.0f, 0.0f, 1.0f, 2.0f);
    Add(b2_staticBody, 0.0f, -90.0f, 500.0f, 0.5f); // far from what moves, and so not shown
    ExpectNear(BoundsAtStart(world, picture), -20.0f, -2.0f, 6.0f, 30.0f);
    ExpectNear(BoundsOfEverything(world, picture), -500.0f, -90.5f, 500.0f, 30.0f);
}

TEST_F(WorldBounds, AreNotEmptyForAnEmptyWorld)
{
    EXPECT_FALSE(BoundsAtStart(world).IsEmpty());
}

TEST_F(WorldBounds, IncludeWideGroundForEverything)
{
    Add(b2_dynamicBody, 0.0f, 5.0f, 2.0f, 4.0f);
    Add(b2_staticBody, 0.0f, 0.0f, 500.0f, 0.5f);
    ExpectNear(BoundsOfEverything(world), -500.0f, -0.5f, 500.0f, 9.0f);
    EXPECT_FALSE(BoundsOfEverything(b2World(b2Vec2(0.0f, 0.0f))).IsEmpty());
}

TEST_F(WorldBounds, TreatChosenBodiesWithoutShapesAsPoints)
{
    const b2Body* box = Add(b2_staticBody, -3.0f, 2.0f, 1.0f, 1.0f);
    Add(b2_dynamicBody, 90.0f, 90.0f, 1.0f, 1.0f);
    b2BodyDef bare;
    bare.position.Set(5.0f, -4.0f);
    const b2Body* point = world.CreateBody(&bare);
    ExpectNear(BoundsOfBodies({box, nullptr, point}), -4.0f, -4.0f, 5.0f, 3.0f);
    EXPECT_TRUE(BoundsOfBodies({nullptr}).IsEmpty());
    EXPECT_EQ(BoundsOfCenters({box, nullptr, point}), (Rect{{-3.0f, -4.0f}, {5.0f, 2.0f}}));
}

TEST_F(WorldBounds, IncludeOnlyAwakeBodiesForMovers)
{
    Add(b2_dynamicBody, 0.0f, 0.0f, 1.0f, 1.0f)->SetAwake(false);
    Add(b2_dynamicBody, 10.0f, 0.0f, 1.0f, 1.0f);
    Add(b2_staticBody, 20.0f, 0.0f, 1.0f, 1.0f);
    const std::vector<Rect> movers = BoundsOfMovers(world);
    ASSERT_EQ(movers.size(), 1u);
    ExpectNear(movers[0], 9.0f, -1.0f, 11.0f, 1.0f);
}

} // namespace
} // namespace boxreel
