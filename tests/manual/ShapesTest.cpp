// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

/// The Collision module's chapter as far as it speaks of shapes, section by section.
namespace
{

using dynamics::Scene;

/// Returns the maximum rise of a box that slides along the x axis over two edges. They meet at 0
/// and are on the axis. Each edge has ghost vertices if requested.
float32 HighestOverTheSeam(bool withGhosts)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (int i = -10; i < 10; ++i)
    {
        b2EdgeShape edge;
        edge.Set(b2Vec2(float32(i), 0.0f), b2Vec2(float32(i + 1), 0.0f));
        edge.m_hasVertex0 = withGhosts;
        edge.m_hasVertex3 = withGhosts;
        edge.m_vertex0.Set(float32(i - 1), 0.0f);
        edge.m_vertex3.Set(float32(i + 2), 0.0f);
        Scene::Add(ground, edge, 0.0f, 0.0f);
    }
    b2Body* box = scene.Body(b2_dynamicBody, -8.5f, 0.52f);
    Scene::AddBox(box, 0.5f, 0.5f, 0.0f);
    scene.Step(20);
    box->SetLinearVelocity(b2Vec2(5.0f, 0.0f));
    float32 highest = 0.0f;
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        highest = b2Max(highest, box->GetPosition().y);
    }
    EXPECT_TRUE(!withGhosts || box->GetPosition().x > 1.0f);
    return highest;
}

TEST(Shapes, ImplementTheFourFunctionsOfTheBaseClass)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 2.0f);
    const b2Shape& shape = box;
    b2Transform transform;
    EXPECT_TRUE(shape.TestPoint(transform, b2Vec2(0.9f, 1.9f)));

    b2RayCastInput input;
    input.p1.Set(-3.0f, 0.0f);
    input.p2.Set(3.0f, 0.0f);
    b2RayCastOutput output;
    ASSERT_TRUE(shape.RayCast(&output, input, transform, 0));
    EXPECT_NEAR(output.fraction, 1.0f / 3.0f, 1e-6f);

    b2AABB aabb;
    shape.ComputeAABB(&aabb, transform, 0);
    EXPECT_NEAR(aabb.upperBound.y, 2.0f + box.m_radius, 1e-6f);

    b2MassData mass;
    shape.ComputeMass(&mass, 3.0f);
    EXPECT_FLOAT_EQ(mass.mass, 24.0f);
}

TEST(Shapes, HaveATypeAndARadius)
{
    EXPECT_EQ(b2CircleShape().GetType(), b2Shape::e_circle);
    EXPECT_EQ(b2PolygonShape().GetType(), b2Shape::e_polygon);
    EXPECT_EQ(b2EdgeShape().GetType(), b2Shape::e_edge);
    EXPECT_EQ(b2ChainShape().GetType(), b2Shape::e_chain);
    EXPECT_EQ(b2PolygonShape().m_radius, b2_polygonRadius);
}

TEST(Shapes, MoveWithTheBodyTheyAreAttachedTo)
{
    Scene scene;
    b2Body* body = scene.Body(b2_staticBody, 10.0f, 0.0f);
    b2CircleShape circle;
    circle.m_p.Set(2.0f, 3.0f);
    circle.m_radius = 0.5f;
    EXPECT_TRUE(circle.TestPoint(b2Transform(), b2Vec2(2.0f, 3.0f)));
    b2Fixture* fixture = body->CreateFixture(&circle, 0.0f);
    EXPECT_FALSE(fixture->TestPoint(b2Vec2(2.0f, 3.0f)));
    EXPECT_TRUE(fixture->TestPoint(b2Vec2(12.0f, 3.0f)));
    body->SetTransform(b2Vec2(20.0f, 0.0f), 0.5f * b2_pi);
    EXPECT_TRUE(fixture->TestPoint(b2Vec2(17.0f, 2.0f)));
}

TEST(Polygon, IsATriangleInTheListing)
{
    // Counter-clockwise.
    b2Vec2 vertices[3];
    vertices[0].Set(0.0f, 0.0f);
    vertices[1].Set(1.0f, 0.0f);
    vertices[2].Set(0.0f, 1.0f);
    int32 count = 3;
    b2PolygonShape polygon;
    polygon.Set(vertices, count);

    ASSERT_EQ(polygon.GetVertexCount(), 3);
    EXPECT_TRUE(polygon.Validate());
    EXPECT_TRUE(polygon.TestPoint(b2Transform(), b2Vec2(0.25f, 0.25f)));
    EXPECT_FALSE(polygon.TestPoint(b2Transform(), b2Vec2(0.75f, 0.75f)));
}

TEST(Polygon, IsStoredCounterClockwiseInAnyOrder)
{
    const b2Vec2 clockwise[4] = {{0.0f, 0.0f}, {0.0f, 1.0f}, {2.0f, 1.0f}, {2.0f, 0.0f}};
    b2PolygonShape polygon;
    polygon.Set(clockwise, 4);
    ASSERT_EQ(polygon.GetVertexCount(), 4);
    for (int32 i = 0; i < 4; ++i)
    {
        const b2Vec2 side = polygon.GetVertex((i + 1) % 4) - polygon.GetVertex(i);
        EXPECT_GT(b2Cross(side, polygon.m_centroid - polygon.GetVertex(i)), 0.0f);
        EXPECT_NEAR(b2Dot(side, polygon.m_normals[i]), 0.0f, 1e-6f);
        EXPECT_LT(b2Dot(polygon.m_normals[i], polygon.m_centroid - polygon.GetVertex(i)), 0.0f);
    }
}

TEST(Polygon, IsTheConvexHullWeldedWithinTheSlop)
{
    const b2Vec2 points[7] = {{0.0f, 0.0f},   {1.0f, 0.0f}, {0.5f, 0.5f}, {1.0f, 1.0f},
                              {1.0f, 0.999f}, {0.0f, 1.0f}, {0.2f, 0.3f}};
    b2PolygonShape polygon;
    polygon.Set(points, 7);
    EXPECT_EQ(polygon.GetVertexCount(), 4);
}

TEST(Polygon, TakesUpToTheMaximumOfVertices)
{
    b2Vec2 points[b2_maxPolygonVertices];
    for (int32 i = 0; i < b2_maxPolygonVertices; ++i)
    {
        points[i] = b2Rot(0.25f * b2_pi * float32(i)).GetXAxis();
    }
    b2PolygonShape polygon;
    polygon.Set(points, b2_maxPolygonVertices);
    EXPECT_EQ(polygon.GetVertexCount(), b2_maxPolygonVertices);
}

TEST(Polygon, IsABoxOfHalfWidthsACentreAndAnAngle)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 2.0f);
    EXPECT_TRUE(box.TestPoint(b2Transform(), b2Vec2(-0.99f, 1.99f)));
    EXPECT_FALSE(box.TestPoint(b2Transform(), b2Vec2(1.01f, 0.0f)));
    box.SetAsBox(1.0f, 2.0f, b2Vec2(5.0f, 0.0f), 0.5f * b2_pi);
    EXPECT_TRUE(box.TestPoint(b2Transform(), b2Vec2(6.99f, 0.99f)));
    EXPECT_FALSE(box.TestPoint(b2Transform(), b2Vec2(5.0f, 1.01f)));
}

TEST(Polygon, KeepsStackedBoxesApartByItsSkin)
{
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(120);
    EXPECT_GT(box->GetPosition().y, 0.5f);
    EXPECT_LE(box->GetPosition().y, 0.5f + 2.0f * b2_polygonRadius);
}

TEST(EdgeShapes, CollideWithCirclesAndPolygonsButNotWithEachOther)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2EdgeShape edge;
    edge.Set(b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
    ground->CreateFixture(&edge, 0.0f);
    b2Body* box = scene.Box(-5.0f, 1.0f);
    b2Body* ball = scene.Ball(0.0f, 1.0f);
    b2Body* other = scene.Body(b2_dynamicBody, 5.0f, 1.0f);
    edge.Set(b2Vec2(-1.0f, 0.5f), b2Vec2(1.0f, -0.5f));
    other->CreateFixture(&edge, 1.0f);
    scene.Step(120);
    EXPECT_GT(box->GetPosition().y, 0.45f);
    EXPECT_GT(ball->GetPosition().y, 0.45f);
    EXPECT_LT(other->GetPosition().y, -5.0f);
}

TEST(EdgeShapes, KeepTheirGhostVerticesInTheListing)
{
    // The middle one of three edges.
    b2Vec2 v0(1.7f, 0.0f);
    b2Vec2 v1(1.0f, 0.25f);
    b2Vec2 v2(0.0f, 0.0f);
    b2Vec2 v3(-1.7f, 0.4f);
    b2EdgeShape edge;
    edge.Set(v1, v2);
    EXPECT_FALSE(edge.m_hasVertex0 || edge.m_hasVertex3);
    edge.m_hasVertex0 = true;
    edge.m_hasVertex3 = true;
    edge.m_vertex0 = v0;
    edge.m_vertex3 = v3;

    Scene scene;
    b2Fixture* fixture = scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&edge, 0.0f);
    const auto* copy = static_cast<const b2EdgeShape*>(fixture->GetShape());
    EXPECT_TRUE(copy->m_hasVertex0 && copy->m_hasVertex3);
    EXPECT_EQ(copy->m_vertex0, v0);
    EXPECT_EQ(copy->m_vertex3, v3);
}

TEST(EdgeShapes, LetABoxSlideOverSeamsWithGhostVertices)
{
    const float32 rest = 0.5f + 2.0f * b2_polygonRadius;
    EXPECT_LT(HighestOverTheSeam(true), rest + b2_linearSlop);
}

/// The chain of the listing.
void MakeListing(b2ChainShape& chain, b2Vec2 (&vs)[4])
{
    // Open at both ends.
    vs[0].Set(1.7f, 0.0f);
    vs[1].Set(1.0f, 0.25f);
    vs[2].Set(0.0f, 0.0f);
    vs[3].Set(-1.7f, 0.4f);
    chain.CreateChain(vs, 4);
}

TEST(ChainShapes, AreThreeConnectedEdgesInTheListing)
{
    b2Vec2 vs[4];
    b2ChainShape chain;
    MakeListing(chain, vs);
    ASSERT_EQ(chain.GetChildCount(), 3);

    int visited = 0;
    // The children of a chain are its edges.
    for (int32 i = 0; i < chain.GetChildCount(); ++i)
    {
        b2EdgeShape edge;
        chain.GetChildEdge(&edge, i);
        EXPECT_EQ(edge.m_vertex1, vs[i]);
        EXPECT_EQ(edge.m_vertex2, vs[i + 1]);
        EXPECT_EQ(edge.m_hasVertex0, i > 0);
        EXPECT_EQ(edge.m_hasVertex3, i < 2);
        EXPECT_TRUE(i == 0 || edge.m_vertex0 == vs[i - 1]);
        EXPECT_TRUE(i == 2 || edge.m_vertex3 == vs[i + 2]);
        ++visited;
    }
    EXPECT_EQ(visited, 3);
}

TEST(ChainShapes, ConnectWithOtherChainsByGhostVertices)
{
    b2Vec2 vs[4];
    b2ChainShape chain;
    MakeListing(chain, vs);
    // The continuations of the neighbouring chains.
    chain.SetPrevVertex(b2Vec2(3.0f, 1.0f));
    chain.SetNextVertex(b2Vec2(-2.0f, 0.0f));

    b2EdgeShape edge;
    chain.GetChildEdge(&edge, 0);
    EXPECT_TRUE(edge.m_hasVertex0);
    EXPECT_EQ(edge.m_vertex0, b2Vec2(3.0f, 1.0f));
    chain.GetChildEdge(&edge, 2);
    EXPECT_TRUE(edge.m_hasVertex3);
    EXPECT_EQ(edge.m_vertex3, b2Vec2(-2.0f, 0.0f));
}

TEST(ChainShapes, CollideFromBothSides)
{
    Scene scene(b2Vec2_zero);
    b2ChainShape chain;
    const b2Vec2 vs[3] = {{-5.0f, 0.0f}, {0.0f, 0.0f}, {5.0f, 0.0f}};
    chain.CreateChain(vs, 3);
    scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&chain, 0.0f);
    b2Body* above = scene.Box(-2.0f, 2.0f);
    b2Body* below = scene.Box(2.0f, -2.0f);
    above->SetLinearVelocity(b2Vec2(0.0f, -3.0f));
    below->SetLinearVelocity(b2Vec2(0.0f, 3.0f));
    scene.Step(120);
    EXPECT_GT(above->GetPosition().y, 0.45f);
    EXPECT_LT(below->GetPosition().y, -0.45f);
}

TEST(ChainShapes, LetABoxSlideWithoutGhostCollisions)
{
    Scene scene;
    b2Vec2 vs[21];
    for (int i = 0; i <= 20; ++i)
    {
        vs[i].Set(float32(i - 10), 0.0f);
    }
    b2ChainShape chain;
    chain.CreateChain(vs, 21);
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), chain, 0.0f, 0.0f);
    b2Body* box = scene.Body(b2_dynamicBody, -8.5f, 0.5f + dynamics::kRestingGap);
    Scene::AddBox(box, 0.5f, 0.5f, 0.0f);
    scene.Step(20);
    box->SetLinearVelocity(b2Vec2(5.0f, 0.0f));
    scene.Step(120);
    EXPECT_NEAR(box->GetLinearVelocity().x, 5.0f, 1e-3f);
    EXPECT_NEAR(box->GetAngle(), 0.0f, 1e-3f);
}

TEST(ChainShapes, HaveABoxInTheTreeForEachEdge)
{
    Scene scene;
    b2Vec2 vs[4];
    b2ChainShape chain;
    MakeListing(chain, vs);
    b2Fixture* fixture = scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&chain, 0.0f);
    EXPECT_EQ(scene.world.GetProxyCount(), 3);
    for (int32 i = 0; i < 3; ++i)
    {
        b2AABB edge;
        chain.ComputeAABB(&edge, b2Transform(), i);
        EXPECT_TRUE(fixture->GetAABB(i).Contains(edge));
    }
}

} // namespace
