// SPDX-License-Identifier: MIT
#include "Queries.h"

#include "../Contacts/Boxes.h"
#include "../State/BodyPose.h"
#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

namespace box2d
{

namespace
{

/// Casts a ray through one tree and tests the shapes of the boxes it hits.
struct RayVisitor
{
    const b2DynamicTree* tree;
    b2RayCastCallback* callback;
    float32 maxFraction; // remaining fraction of the ray, over all trees

    float32 RayCastCallback(const b2RayCastInput& input, int32 node)
    {
        const auto* proxy = static_cast<const b2FixtureProxy*>(tree->GetUserData(node));
        b2RayCastOutput output;
        if (!proxy->fixture->RayCast(&output, input, proxy->childIndex))
        {
            return input.maxFraction;
        }
        const b2Vec2 point = (1.0f - output.fraction) * input.p1 + output.fraction * input.p2;
        const float32 answer =
            callback->ReportFixture(proxy->fixture, point, output.normal, output.fraction);
        if (answer >= 0.0f)
        {
            maxFraction = b2Min(maxFraction, answer); // clipping is permanent
        }
        return maxFraction;
    }
};

} // namespace

void Query(const World& world, b2QueryCallback& callback, const b2AABB& box)
{
    const Lock lock(world);
    world.proxies.Query(
        box, [&](b2FixtureProxy* proxy) { return callback.ReportFixture(proxy->fixture); });
}

void RayCast(const World& world, b2RayCastCallback& callback, const b2Vec2& point1,
             const b2Vec2& point2)
{
    const Lock lock(world);
    float32 maxFraction = 1.0f;
    for (const Mobility mobility : {Mobility::Static, Mobility::Kinematic, Mobility::Dynamic})
    {
        b2RayCastInput input;
        input.p1 = point1;
        input.p2 = point2;
        input.maxFraction = maxFraction;
        RayVisitor visitor{&world.proxies.TreeOf(mobility), &callback, maxFraction};
        visitor.tree->RayCast(&visitor, input);
        maxFraction = visitor.maxFraction;
        if (maxFraction == 0.0f)
        {
            return;
        }
    }
}

void ShiftOrigin(World& world, const b2Vec2& newOrigin)
{
    for (b2Body* b = world.bodyList; b; b = b->GetNext())
    {
        BodyData& body = Data(*b);
        for (Pose* pose : {&body.pose, &body.previous})
        {
            pose->x -= double(newOrigin.x);
            pose->y -= double(newOrigin.y);
        }
        SynchronizePose(body);
        ForProxies(body, [&newOrigin](b2FixtureProxy& proxy) {
            proxy.aabb.lowerBound -= newOrigin;
            proxy.aabb.upperBound -= newOrigin;
        });
    }
    for (b2Joint* joint = world.jointList; joint; joint = joint->GetNext())
    {
        joint->ShiftOrigin(newOrigin);
    }
    world.proxies.ShiftOrigin(newOrigin);
    // Boxes are in single precision: where the shift was rounded, a shape may be outside of its
    // box.
    for (b2Body* b = world.bodyList; b; b = b->GetNext())
    {
        UpdateProxies(world.proxies, Data(*b), false);
    }
}

} // namespace box2d
