// SPDX-License-Identifier: MIT
#include <session/SceneLabels.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

TEST(SceneLabels, KeepNumberOfBodyWhenOthersAreDestroyed)
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
