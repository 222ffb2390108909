// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2Distance.h>
#include <Collision/Manifolds.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
constexpr float kSkins = 2.0f * b2_polygonRadius;

// A contact of one edge, seen from the world.
struct Contact
{
    b2Manifold manifold;
    b2WorldManifold world;
};

std::vector<Contact> Collide(const b2ChainShape& chain, const b2Shape& shape, const b2Transform& xf)
{
    std::vector<Contact> contacts;
    for (int32 i = 0; i < chain.GetChildCount(); ++i)
    {
        b2EdgeShape edge;
        chain.GetChildEdge(&edge, i);
        Contact contact;
        if (shape.GetType() == b2Shape::e_polygon)
        {
            b2CollideEdgeAndPolygon(&contact.manifold, &edge, b2Transform(),
                                    static_cast<const b2PolygonShape*>(&shape), xf);
        }
        else
        {
            b2CollideEdgeAndCircle(&contact.manifold, &edge, b2Transform(),
                                   static_cast<const b2CircleShape*>(&shape), xf);
        }
        if (contact.manifold.pointCount > 0)
        {
            contact.world.Initialize(&contact.manifold, b2Transform(), edge.m_radius, xf,
                                     shape.m_radius);
            contacts.push_back(contact);
        }
    }
    return contacts;
}

b2ChainShape FlatChain(Random& random, bool isReversed)
{
    std::vector<b2Vec2> vs;
    for (float x = -5.0f; x < 15.0f; x += random.Real(0.02f, 1.5f))
    {
        vs.emplace_back(x, 0.0f);
    }
    if (isReversed)
    {
        std::reverse(vs.begin(), vs.end());
    }
    b2ChainShape chain;
    chain.CreateChain(vs.data(), static_cast<int32>(vs.size()));
    return chain;
}

float Lowest(const b2PolygonShape& polygon, const b2Rot& q)
{
    float lowest = b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        lowest = b2Min(lowest, b2Mul(q, polygon.m_vertices[i]).y);
    }
    return lowest;
}

float DistanceToEdge(const b2EdgeShape& edge, const b2Shape& shape, const b2Transform& xf)
{
    b2DistanceInput input;
    input.proxyA.Set(&edge, 0);
    input.proxyB.Set(&shape, 0);
    input.transformB = xf;
    b2SimplexCache cache;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return output.distance;
}
} // namespace

// A flat chain gives only the normal of the ground: for every shape and angle, from either side, on
// edges of either direction.
TEST(EdgeManifold, HasTheNormalOfAFlatChainForPolygons)
{
    Random random(71);
    for (int round = 0; round < 40; ++round)
    {
        const b2ChainShape chain = FlatChain(random, round % 2 == 0);
        const b2PolygonShape box = [&random] {
            b2PolygonShape polygon;
            const float halfWidth = random.Real(0.05f, 1.0f);
            polygon.SetAsBox(halfWidth, random.Real(0.05f, 1.0f));
            return polygon;
        }();
        const b2PolygonShape polygon = round % 4 == 3 ? random.Polygon(0.5f) : box;
        const float side = round % 8 < 4 ? 1.0f : -1.0f;
        for (int i = 0; i < 1000; ++i)
        {
            const float lean = random.Integer(0, 2) == 0 ? 0.0f : random.Real(-0.3f, 0.3f);
            const b2Rot q(lean + (side < 0.0f ? b2_pi : 0.0f));
            const float depth = random.Real(-0.5f * kSkins, 0.03f);
            const b2Vec2 p(0.01f * static_cast<float>(i),
                           side > 0.0f ? -Lowest(polygon, q) - depth
                                       : Lowest(polygon, b2Rot(lean)) + depth);
            const std::vector<Contact> contacts = Collide(chain, polygon, b2Transform(p, q));
            ASSERT_FALSE(contacts.empty()) << round << " " << i;
            float deepest = b2_maxFloat;
            for (const Contact& contact : contacts)
            {
                ASSERT_NEAR(contact.world.normal.x, 0.0f, 1.0e-6f) << round << " " << i;
                ASSERT_NEAR(contact.world.normal.y, side, 1.0e-6f) << round << " " << i;
                for (int32 k = 0; k < contact.manifold.pointCount; ++k)
                {
                    deepest = b2Min(deepest, contact.world.separations[k]);
                }
            }
            ASSERT_NEAR(deepest, -depth - kSkins, 1.0e-4f) << round << " " << i;
        }
    }
}

TEST(EdgeManifold, HasTheNormalOfAFlatChainForCircles)
{
    Random random(72);
    b2CircleShape circle;
    circle.m_radius = 0.3f;
    for (int round = 0; round < 20; ++round)
    {
        const b2ChainShape chain = FlatChain(random, round % 2 == 0);
        const float side = round % 4 < 2 ? 1.0f : -1.0f;
        for (int i = 0; i < 1000; ++i)
        {
            const b2Transform xf(b2Vec2(0.01f * static_cast<float>(i), side * 0.3f), b2Rot());
            const std::vector<Contact> contacts = Collide(chain, circle, xf);
            ASSERT_FALSE(contacts.empty());
            for (const Contact& contact : contacts)
            {
                ASSERT_NEAR(contact.world.normal.x, 0.0f, 1.0e-5f);
                ASSERT_NEAR(contact.world.normal.y, side, 1.0e-5f);
            }
        }
    }
}

// No hole: where the cores of a shape and a chain are so close that their skins overlap, at least
// one edge answers.
TEST(EdgeManifold, HasPointsOfSomeEdgeWhereverSkinsOverlap)
{
    Random random(73);
    int compared = 0;
    for (int i = 0; i < 30000; ++i)
    {
        std::vector<b2Vec2> vs;
        b2Vec2 v(-3.0f, 0.0f);
        float angle = 0.0f;
        while (v.x < 3.0f && vs.size() < 40)
        {
            vs.push_back(v);
            angle = b2Clamp(angle + random.Real(-0.8f, 0.8f), -1.2f, 1.2f);
            v += random.Real(0.2f, 1.0f) * b2Rot(angle).GetXAxis();
        }
        b2ChainShape chain;
        chain.CreateChain(vs.data(), static_cast<int32>(vs.size()));
        const b2PolygonShape polygon = random.Polygon(0.5f);
        b2Transform xf = random.Transform(2.0f);

        // Let it come down on the chain until the cores are half a skin apart.
        xf.p.y = 10.0f;
        for (int step = 0; step < 60; ++step)
        {
            float minimum = b2_maxFloat;
            for (int32 k = 0; k < chain.GetChildCount(); ++k)
            {
                b2EdgeShape edge;
                chain.GetChildEdge(&edge, k);
                minimum = b2Min(minimum, DistanceToEdge(edge, polygon, xf));
            }
            if (minimum < 0.5f * kSkins)
            {
                const std::vector<Contact> contacts = Collide(chain, polygon, xf);
                ASSERT_FALSE(contacts.empty()) << i;
                for (const Contact& contact : contacts)
                {
                    ASSERT_GT(contact.world.normal.y, 0.0f) << i; // it came from above
                }
                ++compared;
                break;
            }
            xf.p.y -= minimum - 0.4f * kSkins;
        }
    }
    EXPECT_GT(compared, 25000);
}

// A corner of the box exactly on a blunt vertex has a face on either side. Each is beyond the
// normal of the other edge, so neither edge may rely on the other for the contact.
TEST(EdgeManifold, PushesUpACornerExactlyOnABluntVertex)
{
    const b2Vec2 vs[3] = {{-5.0f, -0.5f}, {0.0f, 0.0f}, {5.0f, -0.5f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (float x = -0.02f; x < 0.02f; x += 0.0005f)
    {
        for (float depth = -0.01f; depth < 0.05f; depth += 0.0005f)
        {
            const b2Transform xf(b2Vec2(x, 0.5f * b2Sqrt(2.0f) - depth), b2Rot(0.25f * b2_pi));
            const std::vector<Contact> contacts = Collide(chain, box, xf);
            ASSERT_FALSE(contacts.empty()) << x << " " << depth;
            for (const Contact& contact : contacts)
            {
                ASSERT_GT(contact.world.normal.y, 0.9f) << x << " " << depth;
            }
        }
    }
}

TEST(EdgeManifold, PushesABoxAtTheCornerOfAPlatformOnlyUp)
{
    // A square platform as a loop. The box is on its top and overhangs the right side.
    const b2Vec2 vs[4] = {{2.0f, -2.0f}, {2.0f, 0.0f}, {-2.0f, 0.0f}, {-2.0f, -2.0f}};
    b2ChainShape loop;
    loop.CreateLoop(vs, 4);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (float x = 1.0f; x < 2.45f; x += 0.013f)
    {
        for (const float lean : {0.0f, 0.01f, -0.01f, 0.04f, -0.04f})
        {
            const b2Transform xf(b2Vec2(x, 0.5f), b2Rot(lean));
            for (const Contact& contact : Collide(loop, box, xf))
            {
                ASSERT_GT(contact.world.normal.y, 0.99f) << x << " " << lean;
            }
            ASSERT_FALSE(Collide(loop, box, xf).empty()) << x << " " << lean;
        }
    }
}

TEST(EdgeManifold, PushesABoxInACornerFromTheFloorAndTheWall)
{
    const b2Vec2 vs[3] = {{-5.0f, 0.0f}, {0.0f, 0.0f}, {0.0f, 5.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    const std::vector<Contact> contacts =
        Collide(chain, box, b2Transform(b2Vec2(-0.505f, 0.495f), b2Rot()));
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_NEAR(contacts[0].world.normal.y, 1.0f, 1.0e-6f);
    EXPECT_NEAR(contacts[1].world.normal.x, -1.0f, 1.0e-6f);
    EXPECT_EQ(contacts[0].manifold.pointCount, 2);
    EXPECT_EQ(contacts[1].manifold.pointCount, 2);
}

TEST(EdgeManifold, HasMinimalTranslationForASingleEdge)
{
    b2EdgeShape edge;
    edge.Set(b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Manifold manifold;
    // From the end: the box's own side pushes.
    const b2Transform right(b2Vec2(1.49f, 0.1f), b2Rot());
    b2CollideEdgeAndPolygon(&manifold, &edge, b2Transform(), &box, right);
    ASSERT_GT(manifold.pointCount, 0);
    b2WorldManifold world;
    world.Initialize(&manifold, b2Transform(), edge.m_radius, right, box.m_radius);
    EXPECT_NEAR(world.normal.x, 1.0f, 1.0e-6f);
    // From below: the edge has two sides.
    const b2Transform below(b2Vec2(0.0f, -0.49f), b2Rot());
    b2CollideEdgeAndPolygon(&manifold, &edge, b2Transform(), &box, below);
    ASSERT_EQ(manifold.pointCount, 2);
    world.Initialize(&manifold, b2Transform(), edge.m_radius, below, box.m_radius);
    EXPECT_NEAR(world.normal.y, -1.0f, 1.0e-6f);
    EXPECT_NEAR(world.separations[0], -0.01f - kSkins, 1.0e-6f);
}

TEST(EdgeManifold, KeepsItsIdsWhileABoxRests)
{
    Random random(74);
    b2EdgeShape edge;
    edge.Set(b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Manifold first;
    box2d::CollideEdgeAndPolygon(&first, edge, box, b2Transform(b2Vec2(0.0f, 0.5f), b2Rot()));
    ASSERT_EQ(first.pointCount, 2);
    EXPECT_EQ(first.type, b2Manifold::e_faceA);
    for (int i = 0; i < 2000; ++i)
    {
        const b2Transform xf{b2Vec2{random.Real(-5.0f, 5.0f), 0.5f + random.Real(-0.01f, 0.01f)},
                             b2Rot(random.Real(-1.0e-3f, 1.0e-3f))};
        b2Manifold manifold;
        box2d::CollideEdgeAndPolygon(&manifold, edge, box, xf);
        ASSERT_EQ(manifold.pointCount, 2);
        ASSERT_EQ(manifold.type, b2Manifold::e_faceA);
        ASSERT_EQ(manifold.points[0].id.key, first.points[0].id.key);
        ASSERT_EQ(manifold.points[1].id.key, first.points[1].id.key);
    }
}

TEST(EdgeManifold, IsFiniteForAnEdgeWithoutLength)
{
    b2EdgeShape edge;
    edge.Set(b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 0.0f));
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Manifold manifold;
    const b2Transform xf(b2Vec2(0.1f, 0.49f), b2Rot(0.1f));
    box2d::CollideEdgeAndPolygon(&manifold, edge, box, xf);
    ASSERT_GT(manifold.pointCount, 0);
    b2WorldManifold world;
    world.Initialize(&manifold, b2Transform(), edge.m_radius, xf, box.m_radius);
    EXPECT_TRUE(world.normal.IsValid());
    EXPECT_NEAR(world.normal.Length(), 1.0f, 1.0e-5f);
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    box2d::CollideEdgeAndCircle(&manifold, edge, circle, xf);
    EXPECT_EQ(manifold.pointCount, 1);
}

// Tested by itself for the ends: a circle beside a vertex belongs to the neighbour above its edge.
TEST(EdgeManifold, TouchesEdgesNotTheVertexAtAConcaveVertex)
{
    const b2Vec2 vs[3] = {{-5.0f, 2.0f}, {0.0f, 0.0f}, {5.0f, 2.0f}};
    b2ChainShape chain;
    chain.CreateChain(vs, 3);
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    const std::vector<Contact> contacts =
        Collide(chain, circle, b2Transform(b2Vec2(0.0f, 0.53f), b2Rot()));
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_EQ(contacts[0].manifold.type, b2Manifold::e_faceA);
    EXPECT_EQ(contacts[1].manifold.type, b2Manifold::e_faceA);
    EXPECT_NEAR(contacts[0].world.normal.x, -contacts[1].world.normal.x, 1.0e-6f);
}
