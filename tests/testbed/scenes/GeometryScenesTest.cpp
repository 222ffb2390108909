// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <map>
#include <set>

// Scenes that show what the engine's geometry has to say, by the numbers that they describe.
namespace boxreel
{
namespace
{

std::string Said(const Scene& scene, const std::string& name)
{
    for (const auto& [key, value] : scene.Describe())
    {
        if (key == name)
        {
            return value;
        }
    }
    return "";
}

/// Counts what a scene draws beside its bodies.
class Counter : public b2Draw
{
public:
    void DrawPolygon(const b2Vec2*, int32, const b2Color&) override { ++polygons; }
    void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
    void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override { ++dots; }
    void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override { ++segments; }
    void DrawTransform(const b2Transform&) override {}

    int polygons = 0;
    int dots = 0;
    int segments = 0;
};

Counter Drawn(const Scene& scene)
{
    Counter counter;
    scene.Draw(counter);
    return counter;
}

TEST(RayCastScene, FindsClosestAndSometimesSeveralHits)
{
    const auto scene = Make("Ray-Cast");
    int hits = 0;
    int misses = 0;
    int many = 0;
    // A whole turn takes 12.6 s.
    Play(*scene, 12.6f, [&] {
        const std::string closest = Said(*scene, "closest (orange)");
        closest == "none" ? ++misses : ++hits;
        many += std::stoi(Said(*scene, "all (yellow)")) > 1 ? 1 : 0;
        if (closest != "none")
        {
            // Bodies keep 3 m from the middle, less their size, and drift not at all.
            EXPECT_GT(std::stof(closest), 2.0f);
            EXPECT_LT(std::stof(closest), 11.0f);
        }
    });
    EXPECT_GT(hits, 200);
    EXPECT_GT(misses, 20);
    EXPECT_GT(many, 30);
}

TEST(RayCastScene, StopsRaysByKey)
{
    const auto scene = Make("Ray-Cast");
    for (b2Body* body : Movers(*scene))
    {
        body->SetAngularVelocity(0.0f);
    }
    scene->KeyDown('s');
    const auto before = scene->Describe();
    Play(*scene, 3.0f);
    EXPECT_EQ(scene->Describe(), before);
}

TEST(TimeOfImpactScene, ReportsImpactsWithinReachOfBodies)
{
    const auto scene = Make("Time of Impact");
    std::set<std::string> impacts;
    Play(*scene, 15.0f, [&] { impacts.insert(Said(*scene, "impact")); });
    ASSERT_GE(impacts.size(), 4u);
    for (const std::string& impact : impacts)
    {
        if (impact != "none")
        {
            // The block reaches 2 m from the middle, the bar 1.6 m; the sweep is 14 m long.
            EXPECT_GT(std::stof(impact), (7.0f - 3.7f) / 14.0f);
            EXPECT_LT(std::stof(impact), (7.0f + 3.7f) / 14.0f);
        }
    }
}

TEST(DistanceTestScene, ReportsDistanceWithinBoundsOfCentres)
{
    const auto scene = Make("Distance Test");
    const b2Body* drifter = Movers(*scene).front();
    bool touch = false;
    float32 farthest = 0.0f;
    Play(*scene, 20.0f, [&] {
        const float32 distance = std::stof(Said(*scene, "distance"));
        const float32 centers = drifter->GetPosition().Length();
        EXPECT_LT(distance, centers);
        EXPECT_GT(distance, centers - 2.6f - 1.3f); // both reach so far from their origins
        touch = touch || distance == 0.0f;
        farthest = std::max(farthest, distance);
    });
    EXPECT_TRUE(touch);
    EXPECT_GT(farthest, 1.0f);
}

TEST(DistanceTestScene, MovesTriangleByKeys)
{
    const auto scene = Make("Distance Test");
    const b2Vec2 before = Movers(*scene).front()->GetPosition();
    scene->KeyDown('a');
    scene->KeyDown('a');
    scene->KeyDown('w');
    Play(*scene, 1.0f);
    const b2Vec2 moved = Movers(*scene).front()->GetPosition() - before;
    EXPECT_NEAR(moved.x, -0.2f, 1e-4f);
    EXPECT_NEAR(moved.y, 0.1f, 1e-4f);
}

TEST(PolyCollisionScene, DrawsUpToTwoManifoldPoints)
{
    const auto scene = Make("PolyCollision");
    std::map<std::string, int> counts;
    Play(*scene, 15.0f, [&] {
        ++counts[Said(*scene, "points")];
        EXPECT_EQ(std::to_string(Drawn(*scene).dots), Said(*scene, "points"));
    });
    EXPECT_GT(counts["0"], 50);
    EXPECT_GT(counts["2"], 50);
    EXPECT_EQ(counts["0"] + counts["1"] + counts["2"], 900);
}

TEST(ConvexHullScene, HangsNewHullAndDropsEarlierOnes)
{
    const auto scene = Make("Convex Hull");
    Play(*scene, 14.0f);
    const std::vector<b2Body*> hulls = Movers(*scene);
    ASSERT_EQ(hulls.size(), 12u);
    EXPECT_EQ(hulls.back()->GetPosition().y, 10.0f) << "the newest hangs";
    for (std::size_t i = 0; i + 1 < hulls.size(); ++i)
    {
        EXPECT_LT(hulls[i]->GetPosition().y, 8.5f) << i;
    }
    Counter counter;
    EXPECT_EQ(Drawn(*scene).dots, 8);
    const int corners = std::stoi(Said(*scene, "corners"));
    EXPECT_TRUE(3 <= corners && corners <= 8);
}

TEST(DynamicTreeScene, FindsWhatIsInTheBoxAndNotTheRest)
{
    const auto scene = Make("Dynamic Tree");
    float32 maximum = 0.0f;
    float32 minimum = 100.0f;
    Play(*scene, 10.0f, [&] {
        const float32 found = std::stof(Said(*scene, "in the box"));
        maximum = std::max(maximum, found);
        minimum = std::min(minimum, found);
        EXPECT_EQ(Drawn(*scene).polygons,
                  48 + 1 + static_cast<int>(found) + (Said(*scene, "on the ray") == "one" ? 1 : 0));
    });
    // The box is a twentieth of the field: about five of 48, with their margins.
    EXPECT_LT(minimum, 6.0f);
    EXPECT_GT(maximum, 6.0f);
    EXPECT_LT(maximum, 24.0f);
    EXPECT_LE(std::stoi(Said(*scene, "height")), 12);
}

} // namespace
} // namespace boxreel
