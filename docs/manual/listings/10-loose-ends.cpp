// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <map>
#include <memory>

namespace
{

// [actor]
struct Actor
{
    b2Body* body = nullptr;
    int health = 3;
};
// [/actor]

TEST(LooseEndsListing, FindsTheActorOfABodyAndTheBodyOfAnActor)
{
    manual::Stage stage;
    b2World& world = stage.world;
    // [user-data]
    auto actor = std::make_unique<Actor>();
    b2BodyDef def;
    def.userData = actor.get();
    actor->body = world.CreateBody(&def);

    // ... and back, from a body that the engine reports:
    b2Body* hit = actor->body;
    --static_cast<Actor*>(hit->GetUserData())->health;
    // [/user-data]
    EXPECT_EQ(actor->health, 2);
}

// [material]
struct Material
{
    const char* sound = "wood";
    bool burns = true;
};
// [/material]

TEST(LooseEndsListing, GivesFixturesAMaterial)
{
    manual::Stage stage;
    b2Body* body = stage.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2CircleShape shape;
    shape.m_radius = 0.5f;
    // [fixture-data]
    static Material wood; // one for all fixtures of wood; it outlives them
    b2FixtureDef def;
    def.shape = &shape;
    def.userData = &wood;
    b2Fixture* fixture = body->CreateFixture(&def);
    // [/fixture-data]
    EXPECT_TRUE(static_cast<Material*>(fixture->GetUserData())->burns);
}

// [cleaner]
/// Frees the materials of fixtures that go with their body.
class Cleaner : public b2DestructionListener
{
public:
    void SayGoodbye(b2Fixture* fixture) override { Free(fixture); }
    void SayGoodbye(b2Joint*) override {}
    static void Free(b2Fixture* fixture)
    {
        delete static_cast<Material*>(fixture->GetUserData());
        fixture->SetUserData(nullptr); // so that nothing frees it twice
    }
};
// [/cleaner]

int HowManyHaveAMaterial(b2World& world)
{
    int count = 0;
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext())
    {
        for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
        {
            count += f->GetUserData() != nullptr;
        }
    }
    return count;
}

TEST(LooseEndsListing, FreesWhatFixturesOwn)
{
    Cleaner cleaner;
    manual::Stage stage;
    b2World& world = stage.world;
    world.SetDestructionListener(&cleaner);
    b2Body* body = stage.Ball(0.0f, 0.0f);
    b2Body* other = stage.Ball(5.0f, 0.0f);
    b2Body* third = stage.Ball(9.0f, 0.0f);
    for (b2Body* owner : {body, other, third})
    {
        owner->GetFixtureList()->SetUserData(new Material);
    }
    b2Fixture* fixture = body->GetFixtureList();
    // [free]
    Cleaner::Free(fixture); // no listener is called for this one
    body->DestroyFixture(fixture);
    // [/free]
    EXPECT_EQ(HowManyHaveAMaterial(world), 2);
    world.DestroyBody(other);
    EXPECT_EQ(HowManyHaveAMaterial(world), 1);
    // [free-all]
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) // before the world goes
    {
        for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
        {
            Cleaner::Free(f);
        }
    }
    // [/free-all]
    EXPECT_EQ(HowManyHaveAMaterial(world), 0);
}

// [goodbye]
/// Forgets the joint that drags a body when the body goes away under it.
class Dragging : public b2DestructionListener
{
public:
    b2MouseJoint* joint = nullptr;

private:
    void SayGoodbye(b2Joint* gone) override
    {
        if (gone == joint)
        {
            joint = nullptr;
        }
    }
    void SayGoodbye(b2Fixture*) override {}
};
// [/goodbye]

TEST(LooseEndsListing, HearsWhatGoesWithABody)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* ground = stage.Ground();
    b2Body* body = stage.Box(0.0f, 1.0f);
    Dragging dragging;
    // [set-goodbye]
    world.SetDestructionListener(&dragging); // has to live as long as the world
    // [/set-goodbye]
    b2MouseJointDef def;
    def.bodyA = ground;
    def.bodyB = body;
    def.target = body->GetPosition();
    def.maxForce = 100.0f;
    dragging.joint = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
    world.DestroyBody(body);
    EXPECT_EQ(dragging.joint, nullptr);
    world.SetDestructionListener(nullptr);
}

// [handle]
/// Bodies by their numbers, which are never used again: asking for one that is gone gives null.
class Bodies
{
public:
    int32 Add(b2Body* body)
    {
        m_bodies[body->GetNumber()] = body;
        return body->GetNumber();
    }
    b2Body* Find(int32 number) const
    {
        const auto found = m_bodies.find(number);
        return found == m_bodies.end() ? nullptr : found->second;
    }
    void Destroy(int32 number)
    {
        if (b2Body* body = Find(number))
        {
            m_bodies.erase(number);
            body->GetWorld()->DestroyBody(body);
        }
    }

private:
    std::map<int32, b2Body*> m_bodies;
};
// [/handle]

TEST(LooseEndsListing, HandsOutNumbersInsteadOfPointers)
{
    manual::Stage stage;
    Bodies bodies;
    const int32 box = bodies.Add(stage.Box(0.0f, 1.0f));
    bodies.Destroy(box);
    bodies.Destroy(box);
    EXPECT_EQ(bodies.Find(box), nullptr);
    const int32 ball = bodies.Add(stage.Ball(0.0f, 1.0f));
    EXPECT_NE(ball, box);
    EXPECT_NE(bodies.Find(ball), nullptr);
}

// [pixels]
/// Between a world in metres with y up and a picture in pixels with y down.
struct Screen
{
    float32 pixelsPerMeter = 50.0f;
    b2Vec2 middle = b2Vec2(640.0f, 360.0f); ///< where the world's origin is [px]

    b2Vec2 ToPixels(const b2Vec2& p) const
    {
        return {middle.x + pixelsPerMeter * p.x, middle.y - pixelsPerMeter * p.y};
    }
    b2Vec2 ToMeters(const b2Vec2& p) const
    {
        return {(p.x - middle.x) / pixelsPerMeter, (middle.y - p.y) / pixelsPerMeter};
    }
};
// [/pixels]

TEST(LooseEndsListing, GoesFromMetresToPixelsAndBack)
{
    const Screen screen;
    EXPECT_EQ(screen.ToPixels(b2Vec2(1.0f, 2.0f)), b2Vec2(690.0f, 260.0f));
    EXPECT_EQ(screen.ToMeters(b2Vec2(690.0f, 260.0f)), b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(screen.ToMeters(b2Vec2(640.0f, 285.0f)).y, 1.5f) << "75 pixels above the middle";
}

} // namespace
