// SPDX-License-Identifier: MIT
// Worlds shown between two steps: b2Interpolation.h.
#include "DynamicsMisuse.h"
#include "DynamicsScene.h"
#include "MixedWorld.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using dynamics::kStep;
using dynamics::Scene;

struct Seen
{
    b2Transform transform;
    b2Vec2 center;
    float32 angle = 0.0f;
};

Seen Look(const b2Body& body)
{
    return {body.GetTransform(), body.GetWorldCenter(), body.GetAngle()};
}

bool operator==(const Seen& a, const Seen& b)
{
    return a.transform.p == b.transform.p && a.transform.q.s == b.transform.q.s &&
           a.transform.q.c == b.transform.q.c && a.center == b.center && a.angle == b.angle;
}

TEST(Interpolation, InterpolatesCentreAndAngleLinearly)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* body = scene.Body(b2_dynamicBody, 10.0f, 20.0f);
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f, b2Vec2(1.0f, 0.0f), 0.0f); // its centre is not its origin
    Scene::Add(body, shape, 0.2f, 0.0f);
    body->SetLinearVelocity(b2Vec2(6.0f, 12.0f));
    body->SetAngularVelocity(3.0f);
    b2PoseRecord before;
    before.Save(scene.world);
    const b2Vec2 start = body->GetWorldCenter();
    scene.world.Step(kStep, 8, 3);
    const b2PosesBetween between(scene.world, before, 0.25);
    EXPECT_NEAR(body->GetWorldCenter().x, start.x + 0.25f * 0.1f, 1e-5f);
    EXPECT_NEAR(body->GetWorldCenter().y, start.y + 0.25f * 0.2f, 1e-5f);
    EXPECT_NEAR(body->GetAngle(), 0.25f * 0.05f, 1e-6f);
    const b2Vec2 byTransform = b2Mul(body->GetTransform(), body->GetLocalCenter());
    EXPECT_NEAR(byTransform.x, body->GetWorldCenter().x, 1e-5f);
    EXPECT_NEAR(byTransform.y, body->GetWorldCenter().y, 1e-5f);
}

TEST(Interpolation, ShowsBothEndsToTheLastBit)
{
    Scene scene;
    b2Body* body = scene.Box(0.3f, 7.1f);
    body->SetAngularVelocity(2.0f);
    scene.world.Step(kStep, 8, 3);
    b2PoseRecord before;
    before.Save(scene.world);
    const Seen first = Look(*body);
    scene.world.Step(kStep, 8, 3);
    const Seen last = Look(*body);
    {
        const b2PosesBetween between(scene.world, before, 0.0);
        EXPECT_EQ(Look(*body), first);
    }
    {
        const b2PosesBetween between(scene.world, before, 1.0);
        EXPECT_EQ(Look(*body), last);
        EXPECT_EQ(between.GetFarthest(), 0.0f);
    }
    EXPECT_EQ(Look(*body), last);
}

/// A world looked at between its steps, whenever `looks`, must go on as one that was not.
std::vector<uint8> After(bool looks, int32 subSteps)
{
    MixedWorld mixed(7u);
    b2World& world = mixed.world;
    world.SetSubStepCount(subSteps);
    b2PoseRecord before;
    for (int step = 0; step < 90; ++step)
    {
        before.Save(world);
        world.Step(kStep, 8, 3);
        if (looks)
        {
            const b2PosesBetween between(world, before, 0.4);
        }
    }
    return b2SaveSnapshot(world);
}

TEST(Interpolation, LeavesTheWorldUnchanged)
{
    for (const int32 subSteps : {1, 4})
    {
        EXPECT_EQ(After(true, subSteps), After(false, subSteps)) << subSteps << " sub-steps";
    }
}

TEST(Interpolation, BoundsHowFarAnyShapeIsDisplaced)
{
    MixedWorld mixed(3u);
    b2World& world = mixed.world;
    b2PoseRecord before;
    float32 farthest = 0.0f;
    for (int step = 0; step < 60; ++step)
    {
        before.Save(world);
        world.Step(kStep, 8, 3);
        std::vector<b2AABB> boxes; // where the shapes are
        const auto forEachBox = [&world](const auto& function) {
            for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
            {
                for (const b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
                {
                    for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
                    {
                        b2AABB box;
                        f->GetShape()->ComputeAABB(&box, b->GetTransform(), child);
                        function(box);
                    }
                }
            }
        };
        forEachBox([&](const b2AABB& box) { boxes.push_back(box); });
        const b2PosesBetween between(world, before, 0.1);
        const float32 grown = between.GetFarthest() + 1e-4f; // the rounding of coordinates
        farthest = b2Max(farthest, between.GetFarthest());
        std::size_t i = 0;
        forEachBox([&](const b2AABB& shown) {
            b2AABB box = boxes[i++];
            box.lowerBound -= b2Vec2(grown, grown);
            box.upperBound += b2Vec2(grown, grown);
            EXPECT_TRUE(box.Contains(shown)) << "step " << step;
        });
    }
    EXPECT_GT(farthest, 0.01f);
}

TEST(Interpolation, InterpolatesSmallButNotLargeUserMoves)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* jumps = scene.Box(0.0f, 0.0f);
    b2Body* glides = scene.Box(0.0f, 5.0f);
    b2Body* fast = scene.Box(0.0f, 10.0f);
    scene.world.SetSubStepCount(4);
    fast->SetLinearVelocity(b2Vec2(300.0f, 0.0f)); // 5 m a step
    b2PoseRecord before;
    before.Save(scene.world);
    jumps->SetTransform(b2Vec2(30.0f, 0.0f), 0.0f);
    glides->SetTransform(b2Vec2(1.0f, 5.0f), 0.0f);
    scene.world.Step(kStep, 8, 3);
    const b2PosesBetween between(scene.world, before, 0.5);
    EXPECT_EQ(jumps->GetPosition().x, 0.0f);
    EXPECT_GE(between.GetFarthest(), 30.0f) << "the broad phase has it there";
    EXPECT_NEAR(glides->GetPosition().x, 0.5f, 1e-5f);
    EXPECT_NEAR(fast->GetPosition().x, 2.5f, 1e-4f);
}

TEST(Interpolation, ShowsNewBodiesAndSkipsDestroyedOnes)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* goes = scene.Box(0.0f, 0.0f);
    b2Body* stays = scene.Box(10.0f, 0.0f);
    stays->SetLinearVelocity(b2Vec2(60.0f, 0.0f)); // 1 m a step
    b2PoseRecord before;
    before.Save(scene.world);
    scene.world.Step(kStep, 8, 3);
    scene.world.DestroyBody(goes);
    b2Body* comes = scene.Box(-10.0f, 3.0f);
    const b2PosesBetween between(scene.world, before, 0.5);
    EXPECT_NEAR(stays->GetPosition().x, 10.5f, 1e-5f);
    EXPECT_EQ(comes->GetPosition(), b2Vec2(-10.0f, 3.0f));
}

TEST(Interpolation, LocksTheWorldWhileItExists)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    b2PoseRecord before;
    before.Save(scene.world);
    scene.world.Step(kStep, 8, 3);
    {
        const b2PosesBetween between(scene.world, before, 0.5);
        EXPECT_TRUE(scene.world.IsLocked());
    }
    EXPECT_FALSE(scene.world.IsLocked());
    body->SetTransform(b2Vec2(1.0f, 1.0f), 0.0f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.0f, 1.0f));
}

TEST(Interpolation, RefusesABadFractionAndNestedUse)
{
    Scene scene;
    scene.Box(0.0f, 0.0f);
    b2PoseRecord before;
    before.Save(scene.world);
    dynamics::ExpectMisuse("needs a fraction from 0 to 1", [&] {
        const b2PosesBetween between(scene.world, before, dynamics::kNaN);
    });
    dynamics::ExpectMisuse("from inside a callback", [&] {
        const b2PosesBetween between(scene.world, before, 0.5);
        const b2PosesBetween within(scene.world, before, 0.5);
    });
    EXPECT_FALSE(scene.world.IsLocked());
}

TEST(Interpolation, NeedsNoBodies)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2PoseRecord before;
    before.Save(world);
    const b2PosesBetween between(world, before, 0.5);
    EXPECT_EQ(between.GetFarthest(), 0.0f);
}

} // namespace
