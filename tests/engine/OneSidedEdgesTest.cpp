// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Box2D/Dynamics/b2Snapshot.h>

#include <gtest/gtest.h>

#include <string>

/// Edges and chains that stop only what comes from their right.
namespace
{

using namespace dynamics;

/// From right to left, so that its right is above.
b2EdgeShape Ledge()
{
    b2EdgeShape edge;
    edge.SetOneSided(b2Vec2(20.0f, 0.0f), b2Vec2(5.0f, 0.0f), b2Vec2(-5.0f, 0.0f),
                     b2Vec2(-20.0f, 0.0f));
    return edge;
}

b2ChainShape LedgeOfThree()
{
    const b2Vec2 vertices[] = {{6.0f, 0.0f}, {1.0f, 0.0f}, {-1.0f, 0.0f}, {-6.0f, 0.0f}};
    b2ChainShape chain;
    chain.CreateChain(vertices, 4, b2Vec2(8.0f, 0.0f), b2Vec2(-8.0f, 0.0f));
    return chain;
}

enum class Flyer
{
    Ball,
    Box,
    Bullet
};

/// Returns the position of a body thrown at a shape from y, after the time it takes to cross 4 m.
float32 Thrown(const b2Shape& shape, Flyer flyer, float32 y, float32 speed)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), shape, 0.2f, 0.0f);
    b2Body* body =
        flyer == Flyer::Ball ? scene.Ball(0.3f, y, 0.2f) : scene.Box(0.3f, y, 0.2f, 0.1f);
    body->SetBullet(flyer == Flyer::Bullet);
    body->SetLinearVelocity(b2Vec2(0.0f, y < 0.0f ? speed : -speed));
    scene.Step(b2Max(int32(4.0f / speed / kStep), 4));
    return body->GetPosition().y;
}

class OneSided : public testing::TestWithParam<Flyer>
{};

TEST_P(OneSided, StopsWhatComesFromTheRight)
{
    for (const float32 speed : {2.0f, 110.0f})
    {
        EXPECT_GT(Thrown(Ledge(), GetParam(), 2.0f, speed), 0.05f) << speed;
        EXPECT_GT(Thrown(LedgeOfThree(), GetParam(), 2.0f, speed), 0.05f) << speed;
    }
}

TEST_P(OneSided, LetsThroughWhatComesFromTheLeft)
{
    for (const float32 speed : {2.0f, 110.0f})
    {
        EXPECT_GT(Thrown(Ledge(), GetParam(), -2.0f, speed), 1.5f) << speed;
        EXPECT_GT(Thrown(LedgeOfThree(), GetParam(), -2.0f, speed), 1.5f) << speed;
    }
}

TEST_P(OneSided, IsUndoneByTwoSides)
{
    b2EdgeShape edge = Ledge();
    edge.SetTwoSided(b2Vec2(5.0f, 0.0f), b2Vec2(-5.0f, 0.0f));
    EXPECT_LT(Thrown(edge, GetParam(), -2.0f, 2.0f), -0.05f);
    b2ChainShape chain = LedgeOfThree();
    chain.Clear();
    const b2Vec2 vertices[] = {{6.0f, 0.0f}, {-6.0f, 0.0f}};
    chain.CreateChain(vertices, 2);
    EXPECT_LT(Thrown(chain, GetParam(), -2.0f, 2.0f), -0.05f);
}

INSTANTIATE_TEST_SUITE_P(Flyers, OneSided, testing::Values(Flyer::Ball, Flyer::Box, Flyer::Bullet));

TEST(OneSidedEdge, HasGhostVertices)
{
    const b2EdgeShape edge = Ledge();
    EXPECT_TRUE(edge.m_oneSided && edge.m_hasVertex0 && edge.m_hasVertex3);
    EXPECT_EQ(edge.m_vertex0, b2Vec2(20.0f, 0.0f));
    EXPECT_EQ(edge.m_vertex3, b2Vec2(-20.0f, 0.0f));
}

TEST(OneSidedEdge, LetsABoxSlideOverConnectedEdges)
{
    Scene scene;
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), LedgeOfThree(), 0.0f, 0.0f);
    b2Body* box = scene.Body(b2_dynamicBody, 3.0f, 0.52f);
    Scene::AddBox(box, 0.5f, 0.5f, 0.0f);
    box->SetLinearVelocity(b2Vec2(-4.0f, 0.0f));
    scene.Step(90); // 6 m, over both joints
    EXPECT_NEAR(box->GetPosition().x, -3.0f, 0.02f);
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 0.03f);
    EXPECT_NEAR(box->GetAngle(), 0.0f, 0.01f);
}

/// The y of the normal where a ray along the y axis meets the shape in its middle; 0 for a miss.
float32 NormalMet(const b2Shape& shape, float32 fromY, int32 child)
{
    b2Transform here;
    here.SetIdentity();
    const b2RayCastInput ray{b2Vec2(0.0f, fromY), b2Vec2(0.0f, -fromY), 1.0f};
    b2RayCastOutput output;
    if (!shape.RayCast(&output, ray, here, child))
    {
        return 0.0f;
    }
    EXPECT_NEAR(output.fraction, 0.5f, 1e-6f);
    return output.normal.y;
}

TEST(OneSidedEdge, IsHitByRaysFromTheRightOnly)
{
    EXPECT_EQ(NormalMet(Ledge(), 1.0f, 0), 1.0f);
    EXPECT_EQ(NormalMet(Ledge(), -1.0f, 0), 0.0f);
    b2EdgeShape child;
    LedgeOfThree().GetChildEdge(&child, 1);
    EXPECT_EQ(NormalMet(child, 1.0f, 0), 1.0f);
    EXPECT_EQ(NormalMet(child, -1.0f, 0), 0.0f);
}

TEST(OneSidedChain, IsHitByRaysFromBothSides)
{
    EXPECT_EQ(NormalMet(LedgeOfThree(), 1.0f, 1), 1.0f);
    EXPECT_EQ(NormalMet(LedgeOfThree(), -1.0f, 1), -1.0f);
}

TEST(OneSidedEdge, IsKeptByCopiesAndSnapshots)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), Ledge(), 0.2f, 0.0f);
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 9.0f), LedgeOfThree(), 0.2f, 0.0f);
    const std::vector<uint8> bytes = b2SaveSnapshot(scene.world);
    b2World again(b2Vec2(0.0f, 0.0f));
    ASSERT_EQ(b2RestoreSnapshot(again, bytes), nullptr);
    for (b2World* world : {&scene.world, &again})
    {
        const b2Body* newest = world->GetBodyList();
        EXPECT_TRUE(
            static_cast<const b2ChainShape*>(newest->GetFixtureList()->GetShape())->m_oneSided);
        EXPECT_TRUE(static_cast<const b2EdgeShape*>(newest->GetNext()->GetFixtureList()->GetShape())
                        ->m_oneSided);
    }
}

std::string s_dump;

TEST(OneSidedEdge, IsDumped)
{
    Scene scene;
    b2Body* body = scene.Body(b2_staticBody, 0.0f, 0.0f);
    s_dump.clear();
    b2SetLog([](const char* text) { s_dump += text; });
    Scene::Add(body, Ledge(), 0.2f, 0.0f)->Dump(0);
    b2SetLog(nullptr);
    EXPECT_NE(s_dump.find("shape.m_oneSided = bool(1);"), std::string::npos);
}

} // namespace
