// SPDX-License-Identifier: MIT
#include "WorldSeen.h"

#include <algorithm>

namespace boxreel
{

namespace
{

class Finder : public b2QueryCallback
{
public:
    explicit Finder(std::vector<const b2Body*>& found) : m_found(found) {}
    bool ReportFixture(b2Fixture* fixture) override
    {
        m_found.push_back(fixture->GetBody());
        return true;
    }

private:
    std::vector<const b2Body*>& m_found;
};

/// Sorts oldest first and removes duplicates.
void Sort(std::vector<const b2Body*>& bodies)
{
    std::sort(bodies.begin(), bodies.end(),
              [](const b2Body* a, const b2Body* b) { return a->GetNumber() < b->GetNumber(); });
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
}

std::vector<const b2Body*> AllBodies(const b2World& world)
{
    std::vector<const b2Body*> bodies;
    bodies.reserve(std::size_t(world.GetBodyCount()));
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        bodies.push_back(body); // the newest first
    }
    std::reverse(bodies.begin(), bodies.end());
    return bodies;
}

} // namespace

std::vector<const b2Body*> AwakeBodies(const b2World& world)
{
    const b2Body* const* const first = world.GetAwakeBodies();
    std::vector<const b2Body*> bodies(first, first + world.GetAwakeBodyCount());
    Sort(bodies);
    return bodies;
}

std::vector<const b2Body*> BodiesSeenAnywhere(const b2World& world)
{
    if (world.GetInactiveBodyCount() > 0)
    {
        return AllBodies(world); // inactive bodies are in no tree
    }
    std::vector<const b2Body*> bodies = AwakeBodies(world);
    for (const b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        bodies.push_back(joint->GetBodyA());
        bodies.push_back(joint->GetBodyB());
    }
    Sort(bodies);
    return bodies;
}

std::vector<const b2Body*> SeenBodies(const b2World& world, const View& view, double reachPixels)
{
    if (!view.area || world.GetInactiveBodyCount() > 0)
    {
        return AllBodies(world);
    }
    std::vector<const b2Body*> bodies = BodiesSeenAnywhere(world);
    const float reach = static_cast<float>(reachPixels / view.camera.pixelsPerMeter);
    b2AABB area;
    area.lowerBound.Set(view.area->lower.x - reach, view.area->lower.y - reach);
    area.upperBound.Set(view.area->upper.x + reach, view.area->upper.y + reach);
    Finder finder(bodies);
    world.QueryAABB(&finder, area);
    Sort(bodies);
    return bodies;
}

} // namespace boxreel
