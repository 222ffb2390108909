// SPDX-License-Identifier: MIT
#include "SceneLabels.h"

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

constexpr float kHalfALabel = 0.1f; // ten pixels, at a hundred a metre

TEST(SceneLabels, EachBodyCarriesItsNumberAtItsCentreOfMass)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    ball.m_p.Set(0.5f, 0.0f);
    for (const float x : {-3.0f, 7.0f})
    {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position.Set(x, 2.0f);
        world.CreateBody(&definition)->CreateFixture(&ball, 1.0f);
    }
    DrawList list;
    AddBodyNumbers(world, 100.0, list);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_THAT(list.texts, testing::UnorderedElementsAre("0", "1"));
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

TEST(SceneLabels, ANumberStaysWithItsBodyWhenOthersGo)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    const b2BodyDef definition;
    b2Body* bodies[4];
    for (b2Body*& body : bodies)
    {
        body = world.CreateBody(&definition);
    }
    EXPECT_THAT(FindBodies(world, {3, 0, 4}),
                testing::ElementsAre(bodies[3], bodies[0], testing::IsNull()));
    world.DestroyBody(bodies[1]);
    EXPECT_THAT(FindBodies(world, {2, 1, 3, 2}),
                testing::ElementsAre(bodies[2], testing::IsNull(), bodies[3], bodies[2]));
    EXPECT_THAT(FindBodies(world, {}), testing::IsEmpty());
}

} // namespace
} // namespace boxreel
