// SPDX-License-Identifier: MIT
#include <debugdraw/WorldBounds.h>

#include <algorithm>

namespace boxreel
{
namespace
{

Vec2 ToVec2(const b2Vec2& v)
{
    return Vec2{v.x, v.y};
}

Rect BoundsOfBody(const b2Body& body)
{
    Rect bounds;
    for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr;
         fixture = fixture->GetNext())
    {
        const b2Shape* shape = fixture->GetShape();
        for (int32 child = 0; child < shape->GetChildCount(); ++child)
        {
            b2AABB box;
            shape->ComputeAABB(&box, body.GetTransform(), child);
            bounds.Include(Rect{ToVec2(box.lowerBound), ToVec2(box.upperBound)});
        }
    }
    return bounds;
}

Rect Intersection(const Rect& a, const Rect& b)
{
    return Rect{{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
                {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
}

/// Enlarges by half its larger side on every side: enough to show the surroundings, without
/// shrinking the scene to a dot above a large ground.
Rect Neighbourhood(const Rect& area)
{
    const float reach =
        0.5f * std::max({area.upper.x - area.lower.x, area.upper.y - area.lower.y, 2.0f});
    return Rect{{area.lower.x - reach, area.lower.y - reach},
                {area.upper.x + reach, area.upper.y + reach}};
}

/// For an empty world.
const Rect kAroundTheOrigin{{-10.0f, -10.0f}, {10.0f, 10.0f}};

Rect BoundsOfWhatCanMove(const b2World& world)
{
    Rect bounds;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() != b2_staticBody)
        {
            bounds.Include(BoundsOfBody(*body));
            bounds.Include(ToVec2(body->GetPosition()));
        }
    }
    for (const b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        bounds.Include(ToVec2(joint->GetAnchorA()));
        bounds.Include(ToVec2(joint->GetAnchorB()));
    }
    return bounds;
}

} // namespace

Rect BoundsAtStart(const b2World& world, const Rect& extra)
{
    Rect bounds = BoundsOfWhatCanMove(world);
    const bool nothingMoves = bounds.IsEmpty();
    const Rect near = Neighbourhood(bounds);
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_staticBody)
        {
            const Rect box = BoundsOfBody(*body);
            bounds.Include(nothingMoves ? box : Intersection(box, near));
        }
    }
    bounds.Include(extra);
    return bounds.IsEmpty() ? kAroundTheOrigin : bounds;
}

Rect BoundsOfEverything(const b2World& world, const Rect& extra)
{
    Rect bounds = BoundsOfWhatCanMove(world);
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        bounds.Include(BoundsOfBody(*body));
    }
    bounds.Include(extra);
    return bounds.IsEmpty() ? kAroundTheOrigin : bounds;
}

Rect BoundsOfBodies(const std::vector<const b2Body*>& bodies)
{
    Rect bounds;
    for (const b2Body* body : bodies)
    {
        if (body != nullptr)
        {
            const Rect box = BoundsOfBody(*body);
            const Vec2 place = ToVec2(body->GetPosition());
            bounds.Include(box.IsEmpty() ? Rect{place, place} : box);
        }
    }
    return bounds;
}

Rect BoundsOfCenters(const std::vector<const b2Body*>& bodies)
{
    Rect bounds;
    for (const b2Body* body : bodies)
    {
        if (body != nullptr)
        {
            bounds.Include(ToVec2(body->GetWorldCenter()));
        }
    }
    return bounds;
}

std::vector<Rect> BoundsOfMovers(const b2World& world)
{
    std::vector<Rect> movers;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() != b2_staticBody && body->IsAwake())
        {
            const Rect box = BoundsOfBody(*body);
            if (!box.IsEmpty())
            {
                movers.push_back(box);
            }
        }
    }
    return movers;
}

} // namespace boxreel
