// SPDX-License-Identifier: MIT
#include "SeenShapes.h"

#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <functional>

namespace box2d
{

namespace
{

/// Order to find the children of a fixture; it depends on addresses and does not leave this file.
bool IsBefore(const SeenChild& a, const SeenChild& b)
{
    if (a.body != b.body)
    {
        return a.body < b.body;
    }
    if (a.fixture != b.fixture)
    {
        return std::less<const b2Fixture*>()(a.fixture, b.fixture);
    }
    return a.child < b.child;
}

/// Sorts the visible children of one body, from `begin` to `end`, into the order of the body's
/// fixtures.
void OrderAsListed(Array<SeenChild>& seen, std::size_t begin, std::size_t end,
                   Array<SeenChild>& scratch)
{
    if (seen[begin].fixture == seen[end - 1].fixture)
    {
        return;
    }
    const auto first = seen.begin() + std::ptrdiff_t(begin);
    const auto last = seen.begin() + std::ptrdiff_t(end);
    scratch.clear();
    const b2Fixture* fixture = seen[begin].fixture->GetBody()->GetFixtureList();
    for (; fixture && scratch.size() < end - begin; fixture = fixture->GetNext())
    {
        auto child =
            std::lower_bound(first, last, SeenChild{seen[begin].body, fixture, 0}, IsBefore);
        for (; child != last && child->fixture == fixture; ++child)
        {
            scratch.push_back(*child);
        }
    }
    std::copy(scratch.begin(), scratch.end(), first);
}

/// Inactive bodies are in no tree.
void AddInactive(const b2Body& body, const b2AABB& view, Array<SeenChild>& seen)
{
    for (const b2Fixture* f = body.GetFixtureList(); f; f = f->GetNext())
    {
        for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
        {
            b2AABB box;
            f->GetShape()->ComputeAABB(&box, body.GetTransform(), child);
            if (b2TestOverlap(box, view))
            {
                seen.push_back({Data(body).number, f, child});
            }
        }
    }
}

} // namespace

Array<SeenChild> FindSeen(const World& world, const b2AABB& view)
{
    Array<SeenChild> seen;
    world.proxies.Query(view, [&](b2FixtureProxy* proxy) {
        seen.push_back(
            {Data(*proxy->fixture->GetBody()).number, proxy->fixture, proxy->childIndex});
        return true;
    });
    for (const b2Body* b = world.inactiveCount > 0 ? world.bodyList : nullptr; b; b = b->GetNext())
    {
        if (!b->IsActive())
        {
            AddInactive(*b, view, seen);
        }
    }
    std::sort(seen.begin(), seen.end(), IsBefore);
    Array<SeenChild> scratch;
    for (std::size_t begin = 0, end = 0; begin < seen.size(); begin = end)
    {
        while (end < seen.size() && seen[end].body == seen[begin].body)
        {
            ++end;
        }
        OrderAsListed(seen, begin, end, scratch);
    }
    return seen;
}

} // namespace box2d
