// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>

/// Box queries and ray casts against a look at every fixture, and the world's other services:
/// moving the origin, the profile, the dump, drawing.
namespace
{

using namespace dynamics;

struct Random
{
    float32 operator()(float32 low, float32 high)
    {
        return low + (high - low) * float32(engine() % 10001u) / 10000.0f;
    }
    std::mt19937 engine{7};
};

void Fill(Scene& scene, Random& random, int count)
{
    for (int i = 0; i < count; ++i)
    {
        b2Body* body = scene.Body(static_cast<b2BodyType>(i % 3), random(-20.0f, 20.0f),
                                  random(-20.0f, 20.0f), random(-3.0f, 3.0f));
        b2CircleShape circle;
        circle.m_radius = random(0.1f, 1.0f);
        circle.m_p.Set(random(-1.0f, 1.0f), random(-1.0f, 1.0f));
        b2PolygonShape box;
        box.SetAsBox(random(0.1f, 1.0f), random(0.1f, 1.0f));
        b2EdgeShape edge;
        edge.Set(b2Vec2(-1.0f, 0.0f), b2Vec2(random(0.0f, 2.0f), random(-1.0f, 1.0f)));
        const b2Vec2 corners[3] = {b2Vec2(-2.0f, 0.5f), b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, 0.5f)};
        b2ChainShape chain;
        chain.CreateChain(corners, 3);
        const b2Shape* shapes[] = {&circle, &box, &edge, &chain};
        body->CreateFixture(shapes[random.engine() % 4], 1.0f);
    }
}

struct Collector : b2QueryCallback
{
    bool ReportFixture(b2Fixture* fixture) override
    {
        ++calls;
        found.insert(fixture);
        return calls < maximum;
    }
    std::set<b2Fixture*> found;
    int calls = 0;
    int maximum = 1 << 30;
};

TEST(DynamicsQueries, FindEveryFixtureWhoseBoxOverlaps)
{
    Random random;
    Scene scene(b2Vec2(0.0f, 0.0f));
    Fill(scene, random, 300);
    for (int i = 0; i < 500; ++i)
    {
        b2AABB box;
        box.lowerBound.Set(random(-22.0f, 20.0f), random(-22.0f, 20.0f));
        box.upperBound = box.lowerBound + b2Vec2(random(0.0f, 5.0f), random(0.0f, 5.0f));
        std::set<b2Fixture*> expected;
        for (b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
        {
            for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
            {
                for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
                {
                    if (b2TestOverlap(box, f->GetAABB(child)))
                    {
                        expected.insert(f);
                    }
                }
            }
        }
        Collector collector;
        scene.world.QueryAABB(&collector, box);
        ASSERT_EQ(collector.found, expected) << i;
        if (i % 100 == 0)
        {
            scene.Step(5);
        }
    }
}

TEST(DynamicsQueries, EndOnRequest)
{
    Random random;
    Scene scene(b2Vec2(0.0f, 0.0f));
    Fill(scene, random, 100);
    b2AABB all;
    all.lowerBound.Set(-100.0f, -100.0f);
    all.upperBound.Set(100.0f, 100.0f);
    for (const int maximum : {1, 2, 50})
    {
        Collector collector;
        collector.maximum = maximum;
        scene.world.QueryAABB(&collector, all);
        EXPECT_EQ(collector.calls, maximum);
    }
}

struct Ray : b2RayCastCallback
{
    float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override
    {
        return report(fixture, point, normal, fraction);
    }
    std::function<float32(b2Fixture*, const b2Vec2&, const b2Vec2&, float32)> report;
};

/// The nearest hit of a ray, by asking every child of every fixture.
float32 NearestHit(b2World& world, const b2Vec2& p1, const b2Vec2& p2, std::set<b2Fixture*>* all)
{
    float32 nearest = 1.0f;
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext())
    {
        for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
        {
            for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
            {
                b2RayCastInput input;
                input.p1 = p1;
                input.p2 = p2;
                input.maxFraction = 1.0f;
                b2RayCastOutput output;
                if (f->RayCast(&output, input, child))
                {
                    nearest = b2Min(nearest, output.fraction);
                    all->insert(f);
                }
            }
        }
    }
    return nearest;
}

TEST(DynamicsRayCasts, ReportTheHitsThatTheCallbackAsksFor)
{
    Random random;
    Scene scene(b2Vec2(0.0f, 0.0f));
    Fill(scene, random, 300);
    int hits = 0;
    for (int i = 0; i < 1000; ++i)
    {
        const b2Vec2 p1(random(-25.0f, 25.0f), random(-25.0f, 25.0f));
        const b2Vec2 p2(random(-25.0f, 25.0f), random(-25.0f, 25.0f));
        std::set<b2Fixture*> expected;
        const float32 nearest = NearestHit(scene.world, p1, p2, &expected);
        hits += expected.empty() ? 0 : 1;

        Ray ray;
        float32 closest = 1.0f;
        ray.report = [&](b2Fixture*, const b2Vec2& point, const b2Vec2& normal, float32 fraction) {
            EXPECT_LE(fraction, closest) << "clipped rays report nothing beyond";
            EXPECT_NEAR(normal.Length(), 1.0f, 1e-5f);
            EXPECT_LT(b2Distance(point, p1 + fraction * (p2 - p1)), 1e-3f);
            closest = fraction;
            return fraction;
        };
        scene.world.RayCast(&ray, p1, p2);
        ASSERT_EQ(closest, nearest) << i;

        for (const float32 goOn : {1.0f, -1.0f})
        {
            std::set<b2Fixture*> found;
            ray.report = [&](b2Fixture* f, const b2Vec2&, const b2Vec2&, float32) {
                found.insert(f);
                return goOn;
            };
            scene.world.RayCast(&ray, p1, p2);
            ASSERT_EQ(found, expected) << i << ": answered " << goOn;
        }

        int calls = 0;
        ray.report = [&](b2Fixture*, const b2Vec2&, const b2Vec2&, float32) {
            ++calls;
            return 0.0f;
        };
        scene.world.RayCast(&ray, p1, p2);
        ASSERT_EQ(calls, expected.empty() ? 0 : 1);
    }
    EXPECT_GT(hits, 200);
}

TEST(DynamicsRayCasts, NeverLengthenAClippedRay)
{
    Random random;
    Scene scene(b2Vec2(0.0f, 0.0f));
    Fill(scene, random, 300);
    for (int i = 0; i < 1000; ++i)
    {
        const b2Vec2 p1(random(-25.0f, 25.0f), random(-25.0f, 25.0f));
        const b2Vec2 p2(random(-25.0f, 25.0f), random(-25.0f, 25.0f));
        Ray ray;
        float32 clipped = 1.0f;
        ray.report = [&](b2Fixture*, const b2Vec2&, const b2Vec2&, float32 fraction) {
            EXPECT_LE(fraction, clipped);
            if (random.engine() % 2 == 0)
            {
                clipped = b2Min(clipped, fraction);
                return fraction;
            }
            return 1.0f; // as if nothing had been hit
        };
        scene.world.RayCast(&ray, p1, p2);
    }
}

TEST(DynamicsRayCasts, HitNothingWithoutLength)
{
    Scene scene;
    scene.Ground();
    scene.Ball(0.0f, 1.0f);
    Ray ray;
    int calls = 0;
    ray.report = [&](b2Fixture*, const b2Vec2&, const b2Vec2&, float32) {
        ++calls;
        return 1.0f;
    };
    for (const float32 y : {-0.5f, 0.0f, 1.0f, 1.5f})
    {
        scene.world.RayCast(&ray, b2Vec2(0.0f, y), b2Vec2(0.0f, y));
    }
    EXPECT_EQ(calls, 0);
}

TEST(DynamicsRayCasts, DoNotHitInactiveBodies)
{
    Scene scene;
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    Ray ray;
    int calls = 0;
    ray.report = [&](b2Fixture*, const b2Vec2&, const b2Vec2&, float32) {
        ++calls;
        return 1.0f;
    };
    scene.world.RayCast(&ray, b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    EXPECT_EQ(calls, 1);
    ball->SetActive(false);
    scene.world.RayCast(&ray, b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    EXPECT_EQ(calls, 1);
}

TEST(DynamicsShiftOrigin, ChangesPlacesButNotTheMotion)
{
    Scene still;
    Scene shifted;
    const b2Vec2 origin(64.0f, -32.0f); // a power of two, so that no place is rounded
    std::vector<b2Body*> bodies[2];
    Scene* scenes[2] = {&still, &shifted};
    for (int i = 0; i < 2; ++i)
    {
        scenes[i]->Ground();
        bodies[i] = Stack(*scenes[i], 0.0f, 4);
        bodies[i].push_back(scenes[i]->Ball(-3.0f, 3.0f, 0.25f));
        bodies[i].back()->SetLinearVelocity(b2Vec2(12.0f, 1.0f));
        b2DistanceJointDef def;
        b2Body* hook = scenes[i]->Body(b2_staticBody, -3.0f, 5.0f);
        def.Initialize(hook, bodies[i].back(), hook->GetPosition(), b2Vec2(-3.0f, 3.0f));
        scenes[i]->world.CreateJoint(&def);
        scenes[i]->Step(20);
    }
    shifted.world.ShiftOrigin(origin);
    EXPECT_EQ(WhyBroken(shifted.world, true), "");
    still.Step(100);
    shifted.Step(100);
    for (std::size_t i = 0; i < bodies[0].size(); ++i)
    {
        const b2Vec2 difference =
            bodies[0][i]->GetPosition() - (bodies[1][i]->GetPosition() + origin);
        EXPECT_LT(difference.Length(), 1e-3f) << i;
        EXPECT_NEAR(bodies[0][i]->GetAngle(), bodies[1][i]->GetAngle(), 1e-3f);
    }
    b2AABB box;
    box.lowerBound = bodies[1][0]->GetPosition() - b2Vec2(0.1f, 0.1f);
    box.upperBound = bodies[1][0]->GetPosition() + b2Vec2(0.1f, 0.1f);
    Collector collector;
    shifted.world.QueryAABB(&collector, box);
    EXPECT_TRUE(collector.found.contains(bodies[1][0]->GetFixtureList()));
}

TEST(DynamicsProfile, AddsUpToTheTimeOfTheStep)
{
    for (const int subSteps : {1, 4})
    {
        Scene scene;
        scene.world.SetSubStepCount(subSteps);
        scene.Ground();
        for (int i = 0; i < 10; ++i)
        {
            Stack(scene, 1.1f * float32(i), 10);
        }
        scene.world.GetProfile(); // measured from here on
        scene.Step(3);
        const b2Profile& profile = scene.world.GetProfile();
        EXPECT_GT(profile.step, 0.0f);
        EXPECT_GT(std::min({profile.solveInit, profile.solveVelocity, profile.solvePosition}), 0.0f)
            << subSteps;
        EXPECT_GE(profile.step, profile.collide + profile.solve + profile.solveTOI - 1e-3f);
        EXPECT_GE(profile.solve,
                  profile.solveInit + profile.solveVelocity + profile.solvePosition - 1e-3f);
    }
}

std::string g_log;

std::string DumpOf(b2World& world)
{
    g_log.clear();
    b2SetLog([](const char* text) { g_log += text; });
    world.Dump();
    b2SetLog(nullptr);
    return g_log;
}

TEST(DynamicsDump, NamesEveryPartOfTheWorld)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 1.0f, -2.5f);
    b2CircleShape circle;
    circle.m_radius = 2.0f;
    circle.m_p.Set(0.1f, 0.0f);
    ground->CreateFixture(&circle, 3.0f);
    const std::string text = DumpOf(scene.world);
    const char* expected = "b2World* m_world = new b2World(b2Vec2(0.00000000e+00f, "
                           "-1.00000000e+01f));\n";
    EXPECT_EQ(text.substr(0, text.find('\n') + 1), expected);
    EXPECT_NE(text.find("  bd.position.Set(1.00000000e+00f, -2.50000000e+00f);\n"),
              std::string::npos);
    EXPECT_NE(text.find("    shape.m_p.Set(1.00000001e-01f, 0.00000000e+00f);\n"),
              std::string::npos)
        << "nine digits give every float back";
}

TEST(DynamicsDump, ListsTheOldestBodyFirst)
{
    Scene scene;
    scene.Box(1.0f, 0.0f);
    scene.Box(2.0f, 0.0f);
    const std::string text = DumpOf(scene.world);
    EXPECT_LT(text.find("bodies[0] ="), text.find("bodies[1] ="));
}

} // namespace
