// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

#include <algorithm>
#include <vector>

using namespace boxreel;

namespace figures
{
namespace
{

struct Hit
{
    b2Vec2 point;
    b2Vec2 normal;
    float32 fraction;
};

class AllHits : public b2RayCastCallback
{
public:
    float32 ReportFixture(b2Fixture*, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override
    {
        hits.push_back({point, normal, fraction});
        return 1.0f; // goes on
    }
    std::vector<Hit> hits;
};

class AllFixtures : public b2QueryCallback
{
public:
    bool ReportFixture(b2Fixture* fixture) override
    {
        found.push_back(fixture);
        return true;
    }
    std::vector<b2Fixture*> found;
};

std::vector<b2Vec2> CornersOf(const b2AABB& box)
{
    return {box.lowerBound,
            {box.upperBound.x, box.lowerBound.y},
            box.upperBound,
            {box.lowerBound.x, box.upperBound.y}};
}

b2PolygonShape Triangle()
{
    const b2Vec2 corners[3] = {{-0.5f, -0.4f}, {0.5f, -0.4f}, {0.0f, 0.6f}};
    b2PolygonShape shape;
    shape.Set(corners, 3);
    return shape;
}

} // namespace

Figure DrawRayCast()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    AddBody(world, b2_dynamicBody, Box(0.45f, 0.3f), b2Vec2(-1.2f, -0.15f), Degrees(20.0f));
    AddBody(world, b2_dynamicBody, Disc(0.45f), b2Vec2(0.6f, 0.2f));
    AddBody(world, b2_dynamicBody, Triangle(), b2Vec2(2.2f, 0.6f), Degrees(-15.0f));
    AddBody(world, b2_dynamicBody, Box(0.5f, 0.3f), b2Vec2(-2.4f, 1.1f), Degrees(-10.0f));
    AddBody(world, b2_dynamicBody, Disc(0.35f), b2Vec2(-0.3f, 1.2f));
    AddBody(world, b2_dynamicBody, Box(0.4f, 0.4f), b2Vec2(1.6f, -0.95f), Degrees(30.0f));
    AddBody(world, b2_dynamicBody, Triangle(), b2Vec2(-0.3f, -1.2f));
    Run(world);
    sketch.Draw(world);

    const b2Vec2 from(-3.4f, -0.7f);
    const b2Vec2 to(3.5f, 0.9f);
    AllHits all;
    world.RayCast(&all, from, to);
    std::ranges::sort(all.hits, {}, &Hit::fraction); // no two are equal
    const Hit& first = all.hits.front();
    sketch.Arrow(first.point, to, kQuiet);
    sketch.Line(from, first.point, kHelp);
    sketch.Dot(from, kHelp);
    for (const Hit& hit : all.hits)
    {
        const Paint color = &hit == &first ? kGood : kQuiet;
        sketch.ArrowAlong(hit.point, hit.normal, 40.0, color);
        sketch.Dot(hit.point, color);
    }
    sketch.Label(from, Side::Below, "point1", kInk, 8.0);
    sketch.Label(to, Side::Above, "point2", kInk, 8.0);
    const b2Vec2 tip = sketch.Shifted(first.point, 40.0 * first.normal.x, 40.0 * first.normal.y);
    sketch.Label(tip, Side::Below, "normal", kGood, 6.0);
    sketch.Label(first.point, Side::Below, "nearest:\nfraction " + Text(first.fraction, 2), kGood,
                 44.0);
    return sketch.Finished();
}

Figure DrawRegionQuery()
{
    Sketch sketch(640, 310, b2Vec2(0.0f, -0.25f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    AddBody(world, b2_dynamicBody, Box(0.4f, 0.4f), b2Vec2(-0.6f, -0.2f), Degrees(15.0f));
    AddBody(world, b2_dynamicBody, Disc(0.4f), b2Vec2(0.8f, 0.3f));
    AddBody(world, b2_dynamicBody, Box(0.09f, 0.8f), b2Vec2(-1.85f, -1.2f), Degrees(45.0f));
    AddBody(world, b2_dynamicBody, Triangle(), b2Vec2(2.0f, -1.0f));
    AddBody(world, b2_dynamicBody, Disc(0.35f), b2Vec2(3.1f, 0.9f));
    AddBody(world, b2_dynamicBody, Box(0.5f, 0.25f), b2Vec2(0.2f, -1.5f), Degrees(-10.0f));
    AddBody(world, b2_dynamicBody, Disc(0.3f), b2Vec2(-2.8f, 0.8f));

    b2AABB region;
    region.lowerBound.Set(-1.6f, -0.9f);
    region.upperBound.Set(1.6f, 1.1f);
    AllFixtures all;
    world.QueryAABB(&all, region);
    Run(world);
    sketch.Draw(world);
    b2PolygonShape shape;
    shape.SetAsBox(1.6f, 1.0f, region.GetCenter(), 0.0f);
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const b2Fixture* const fixture = body->GetFixtureList();
        const bool isFound = std::ranges::find(all.found, fixture) != all.found.end();
        const bool isInside =
            b2TestOverlap(fixture->GetShape(), 0, &shape, 0, body->GetTransform(), b2Transform());
        sketch.Outline(CornersOf(fixture->GetAABB(0)), !isFound ? kQuiet : isInside ? kGood : kBad);
    }
    const std::vector<b2Vec2> corners = CornersOf(region);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        sketch.Dashes(corners[i], corners[(i + 1) % corners.size()], kInk);
    }
    sketch.Label(b2Vec2(0.0f, 1.1f), Side::Above, "the region");
    sketch.Label(b2Vec2(-1.35f, 0.75f), Side::Right, "reported:\nshapes overlap", kGood, 0.0);
    sketch.Label(b2Vec2(-2.55f, -1.2f), Side::Left, "reported too:\nonly its box\noverlaps", kBad);
    sketch.Label(b2Vec2(2.62f, -1.0f), Side::Right, "reported too:\nonly its box\noverlaps", kBad);
    sketch.Label(b2Vec2(3.1f, 0.5f), Side::Below, "not reported", kQuiet);
    return sketch.Finished();
}

} // namespace figures
