// SPDX-License-Identifier: MIT
#include <box2d/box2d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

/// What docs/accuracy.md says of Box2D 2.4 and no case of the benchmark measures: the worlds of
/// ManualLimitsTest.cpp in that library. Each number is printed, and near the one of the page.
namespace
{

constexpr float kStep = 1.0f / 60.0f;

void Tell(const std::string& name, double value, const char* unit, double least, double most)
{
    std::printf("verdict | %-44s | %11.4g %-5s | of Box2D 2.4\n", name.c_str(), value, unit);
    EXPECT_GE(value, least) << name;
    EXPECT_LE(value, most) << name;
}

b2Body* Box(b2World& world, b2BodyType type, float x, float y, float halfWidth, float halfHeight)
{
    b2BodyDef def;
    def.type = type;
    def.position.Set(x, y);
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight);
    b2Body* body = world.CreateBody(&def);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1.0f;
    fixture.friction = 0.2f;
    body->CreateFixture(&fixture);
    return body;
}

void Step(b2World& world, float step = kStep)
{
    world.Step(step, 8, 3);
}

TEST(ManualLimits, AShelfOfWeldedBoardsSags)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef post;
    b2Body* last = world.CreateBody(&post);
    for (int i = 0; i < 10; ++i)
    {
        b2Body* board = Box(world, b2_dynamicBody, float(i) + 0.5f, 0.0f, 0.5f, 0.05f);
        b2WeldJointDef weld;
        weld.Initialize(last, board, b2Vec2(float(i), 0.0f));
        world.CreateJoint(&weld);
        last = board;
    }
    double sag = 0.0;
    for (int i = 0; i < 20 * 60; ++i)
    {
        Step(world);
        sag = std::max(sag, -double(last->GetPosition().y));
    }
    Tell("shelf of ten welded boards sags", sag, "m", 6.7, 6.9);
}

TEST(ManualLimits, DampingDependsOnTheStep)
{
    struct Rate
    {
        int hz;
        double off; ///< [%]
    };
    for (const Rate& rate : {Rate{30, 46.0}, Rate{60, 22.0}, Rate{240, 5.0}})
    {
        b2World world(b2Vec2(0.0f, 0.0f));
        b2Body* box = Box(world, b2_dynamicBody, 0.0f, 0.0f, 0.5f, 0.5f);
        box->SetLinearDamping(5.0f);
        box->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        for (int i = 0; i < rate.hz; ++i)
        {
            Step(world, 1.0f / float(rate.hz));
        }
        const double truth = 10.0 * std::exp(-5.0);
        Tell("damping of 5 /s at " + std::to_string(rate.hz) + " Hz, speed off",
             100.0 * std::abs(double(box->GetLinearVelocity().x) / truth - 1.0), "%",
             rate.off - 0.5, rate.off + 0.5);
    }
}

TEST(ManualLimits, AStackFallsAtTenTimesTheGravity)
{
    b2World world(b2Vec2(0.0f, -100.0f));
    world.SetAllowSleeping(false);
    Box(world, b2_staticBody, 0.0f, -50.0f, 1000.0f, 50.0f);
    b2Body* top = nullptr;
    for (int i = 0; i < 10; ++i)
    {
        top = Box(world, b2_dynamicBody, 0.0f, 0.515f + 1.015f * float(i), 0.5f, 0.5f);
    }
    const double start = double(top->GetPosition().y);
    for (int i = 0; i < 20 * 60; ++i)
    {
        Step(world);
    }
    Tell("ten boxes at 100 m/s^2, the top one sinks by", start - double(top->GetPosition().y), "m",
         8.5, 9.5);
}

TEST(ManualLimits, ABoxRestsAboveAnEdge)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    world.CreateBody(&def)->CreateFixture(&edge, 0.0f);
    const b2Body* box = Box(world, b2_dynamicBody, 0.0f, 0.6f, 0.5f, 0.5f);
    for (int i = 0; i < 5 * 60; ++i)
    {
        Step(world);
    }
    Tell("a box rests above an edge by", 1000.0 * (double(box->GetPosition().y) - 0.5), "mm", 14.5,
         15.5);
}

/// Two rods of 1 m x 0.1 m, hinged end to end, fly into a wall as they stand, turned by twenty
/// angles and from ten places of a step: by how far the hinge opens at most, and for how many
/// steps.
TEST(ManualLimits, AHingeOpensWhenAWallStopsOneOfItsBodies)
{
    struct Hits
    {
        float speed;  ///< [m/s]
        double opens; ///< [m]
        int steps;
    };
    for (const Hits& hits : {Hits{20.0f, 0.315, 6}, Hits{100.0f, 1.0, 12}})
    {
        double widest = 0.0;
        int longest = 0;
        for (int i = 0; i < 200; ++i)
        {
            b2World world(b2Vec2(0.0f, 0.0f));
            Box(world, b2_staticBody, 5.5f, 0.0f, 0.5f, 20.0f);
            const float angle = 0.15f * float(i / 10);
            const b2Vec2 way(std::cos(angle), std::sin(angle));
            const b2Vec2 start(-0.1f * float(i % 10) * hits.speed * kStep, 0.0f);
            b2Body* rods[2];
            for (int k = 0; k < 2; ++k)
            {
                const b2Vec2 place = start - float(k) * way;
                rods[k] = Box(world, b2_dynamicBody, place.x, place.y, 0.5f, 0.05f);
                rods[k]->SetTransform(place, angle);
                rods[k]->SetLinearVelocity(b2Vec2(hits.speed, 0.0f));
            }
            b2RevoluteJointDef def;
            def.Initialize(rods[0], rods[1], start - 0.5f * way);
            const b2Joint* hinge = world.CreateJoint(&def);
            int steps = 0;
            for (int step = 0; step < 60; ++step)
            {
                Step(world);
                const double gap = double((hinge->GetAnchorA() - hinge->GetAnchorB()).Length());
                widest = std::max(widest, gap);
                steps += gap > double(b2_linearSlop);
            }
            longest = std::max(longest, steps);
        }
        const std::string name =
            "two rods into a wall at " + std::to_string(int(hits.speed)) + " m/s, hinge opens";
        Tell(name, widest, "m", 0.9 * hits.opens, 1.1 * hits.opens);
        Tell(name + " for", longest, "steps", hits.steps, hits.steps);
    }
}

} // namespace
