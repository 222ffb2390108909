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

TEST(RayCastScene, TheClosestIsNeverFartherAndAllAreSometimesMany)
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

TEST(RayCastScene, TheRaysStopOnAKey)
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

TEST(TimeOfImpactScene, TheSweepsThatHitTouchAtThatTime)
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

} // namespace
} // namespace boxreel
