// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

namespace
{

TEST(WorldListing, MakesAWorldAndSteps)
{
    // [make]
    auto world = std::make_unique<b2World>(b2Vec2(0.0f, -10.0f)); // bodies may sleep unless said
    world->Step(1.0f / 60.0f, 8, 3); // time step [s], velocity and position iterations
    // [/make]
    EXPECT_TRUE(world->GetAllowSleeping());
    EXPECT_EQ(world->GetGravity(), b2Vec2(0.0f, -10.0f));
}

TEST(WorldListing, HasTheSettingsOfTheTable)
{
    const b2World world(b2Vec2_zero);
    const std::string section = manual::SectionText("09-world.md", "## Settings");
    for (const std::string& row : {
             manual::Row("SetAllowSleeping", world.GetAllowSleeping()),
             manual::Row("SetWarmStarting", world.GetWarmStarting()),
             manual::Row("SetContinuousPhysics", world.GetContinuousPhysics()),
             manual::Row("SetSubStepping", world.GetSubStepping()),
             manual::Row("SetAutoClearForces", world.GetAutoClearForces()),
             manual::Row("SetSubStepCount", double(world.GetSubStepCount())),
             manual::Row("SetThreadCount", double(world.GetThreadCount())),
         })
    {
        EXPECT_THAT(section, testing::HasSubstr(row));
    }
}

TEST(WorldListing, FliesExactlyInSubSteps)
{
    manual::Stage stage;
    b2World& world = stage.world;
    b2Body* ball = stage.Ball(0.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(10.0f, 20.0f));
    // [sub-steps]
    world.SetSubStepCount(4); // 1 to 64; 1 is Box2D's scheme, 4 is recommended
    // [/sub-steps]
    stage.Run(2.0f);
    // After 2 s at (10, 20) m/s a parabola is at (20, 20); one step ends 17 cm beside it.
    EXPECT_LT(b2Distance(ball->GetPosition(), b2Vec2(20.0f, 20.0f)), 0.0001f);
    EXPECT_EQ(b2IterationsOfASubStep(8, 4), 2);
    EXPECT_EQ(b2IterationsOfASubStep(3, 4), 1);
}

TEST(WorldListing, KeepsForcesForSeveralSteps)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* body = stage.Box(0.0f, 0.0f);
    world.SetAutoClearForces(false);
    body->ApplyForceToCenter(b2Vec2(60.0f, 0.0f));
    // [clear]
    for (int i = 0; i < 4; ++i)
    {
        world.Step(1.0f / 240.0f, 8, 3); // the same forces in all four
    }
    world.ClearForces();
    // [/clear]
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 1e-5f);
    world.Step(1.0f / 240.0f, 8, 3);
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 1e-5f);
}

struct Actor
{
    bool dead = false;
};

TEST(WorldListing, WalksOverBodiesAndDestroysSome)
{
    manual::Stage stage;
    b2World& world = stage.world;
    Actor actors[6];
    for (int i = 0; i < 6; ++i)
    {
        actors[i].dead = i % 2 == 0;
        stage.Box(2.0f * float32(i), 0.0f)->SetUserData(&actors[i]);
    }
    // [walk]
    for (b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        body->SetAwake(true);
    }
    // [/walk]
    // [reap]
    for (b2Body* body = world.GetBodyList(); body;)
    {
        b2Body* next = body->GetNext(); // before the body is gone
        if (static_cast<Actor*>(body->GetUserData())->dead)
        {
            world.DestroyBody(body);
        }
        body = next;
    }
    // [/reap]
    EXPECT_EQ(world.GetBodyCount(), 3);
}

TEST(WorldListing, LooksAtWhatIsAwake)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Ground();
    for (int i = 0; i < 5; ++i)
    {
        stage.Box(2.0f * float32(i), 0.515f);
    }
    stage.Run(2.0f);
    b2Body* falling = stage.Box(0.0f, 50.0f);
    std::vector<const b2Body*> seen;
    // [awake]
    for (int32 i = 0; i < world.GetAwakeBodyCount(); ++i)
    {
        seen.push_back(world.GetAwakeBodies()[i]); // in no particular order
    }
    // [/awake]
    EXPECT_THAT(seen, testing::ElementsAre(falling));
}

// [region]
/// Collects the bodies whose fixtures really overlap a box; the tree knows only their boxes.
class Region : public b2QueryCallback
{
public:
    explicit Region(const b2AABB& box)
    {
        const b2Vec2 half = box.GetExtents();
        m_shape.SetAsBox(half.x, half.y, box.GetCenter(), 0.0f);
    }
    std::set<b2Body*> bodies;

private:
    bool ReportFixture(b2Fixture* fixture) override
    {
        const b2Shape* shape = fixture->GetShape();
        const b2Transform& place = fixture->GetBody()->GetTransform();
        for (int32 child = 0; child < shape->GetChildCount(); ++child)
        {
            if (b2TestOverlap(shape, child, &m_shape, 0, place, b2Transform()))
            {
                bodies.insert(fixture->GetBody());
                break;
            }
        }
        return true; // false would end the query
    }
    b2PolygonShape m_shape;
};
// [/region]

TEST(WorldListing, FindsWhatIsInARegion)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* inside = stage.Box(0.0f, 0.0f);
    b2Body* corner = stage.Ball(1.4f, 1.4f, 0.5f); // its box reaches in, the ball does not
    // [query]
    b2AABB box;
    box.lowerBound.Set(-1.0f, -1.0f);
    box.upperBound.Set(1.0f, 1.0f);
    Region region(box);
    world.QueryAABB(&region, box);
    // [/query]
    EXPECT_THAT(region.bodies, testing::ElementsAre(inside));
    EXPECT_NE(corner, nullptr);
}

// [nearest]
/// Keeps the nearest hit.
class Nearest : public b2RayCastCallback
{
public:
    b2Fixture* fixture = nullptr; // null: nothing was hit
    b2Vec2 point, normal;         // in the world

private:
    float32 ReportFixture(b2Fixture* hit, const b2Vec2& where, const b2Vec2& across,
                          float32 fraction) override
    {
        if (hit->IsSensor())
        {
            return -1.0f; // as if it were not there
        }
        fixture = hit;
        point = where;
        normal = across;
        return fraction; // the ray ends here from now on: later reports are nearer
    }
};
// [/nearest]

TEST(WorldListing, CastsARay)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    stage.Box(8.0f, 0.0f);
    b2Body* near = stage.Box(4.0f, 0.0f);
    stage.Box(2.0f, 0.0f)->GetFixtureList()->SetSensor(true);
    // [ray]
    Nearest nearest;
    world.RayCast(&nearest, b2Vec2(0.0f, 0.0f), b2Vec2(10.0f, 0.0f));
    // [/ray]
    ASSERT_NE(nearest.fixture, nullptr);
    EXPECT_EQ(nearest.fixture->GetBody(), near);
    EXPECT_NEAR(b2Distance(nearest.point, b2Vec2(3.5f, 0.0f)), 0.0f, 1e-5f);
    EXPECT_EQ(nearest.normal, b2Vec2(-1.0f, 0.0f));
}

struct Counting : public b2RayCastCallback
{
    explicit Counting(float32 what) : answer(what) {}
    float32 ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float32) override
    {
        ++count;
        return answer;
    }
    float32 answer;
    int count = 0;
};

TEST(WorldListing, GoesOnOrEndsAsTheCallbackSays)
{
    manual::Stage stage(b2Vec2_zero);
    for (int i = 1; i < 6; ++i)
    {
        stage.Box(2.0f * float32(i), 0.0f);
    }
    Counting all(1.0f), any(0.0f), ignoring(-1.0f);
    stage.world.RayCast(&all, b2Vec2(0.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    stage.world.RayCast(&any, b2Vec2(0.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    stage.world.RayCast(&ignoring, b2Vec2(0.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    EXPECT_EQ(all.count, 5);
    EXPECT_EQ(any.count, 1);
    EXPECT_EQ(ignoring.count, 5);
}

TEST(WorldListing, ShowsMomentsBetweenSteps)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* ball = stage.Ball(0.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(6.0f, 0.0f));
    float32 drawnAt = 0.0f;
    // [between]
    b2PoseRecord before;
    before.Save(world);
    world.Step(1.0f / 60.0f, 8, 3);
    {
        const b2PosesBetween between(world, before, 0.25); // a quarter of the step's way
        drawnAt = ball->GetPosition().x;                   // what would be drawn here
    } // everything is back in its own place, to the last bit
    // [/between]
    EXPECT_NEAR(drawnAt, 0.025f, 1e-6f);
    EXPECT_NEAR(ball->GetPosition().x, 0.1f, 1e-6f);
}

TEST(WorldListing, SavesAndRestores)
{
    manual::Stage stage;
    b2World& world = stage.world;
    stage.Ground();
    b2Body* box = stage.Box(0.0f, 5.0f);
    box->SetAngularVelocity(2.0f);
    stage.Run(0.5f);
    // [snapshot]
    const std::vector<uint8> saved = b2SaveSnapshot(world);

    b2World other(b2Vec2_zero); // in this run or another one, on this machine or another one
    if (const char* why = b2RestoreSnapshot(other, saved))
    {
        std::fprintf(stderr, "%s\n", why); // one sentence, and the world is as it was
    }
    // [/snapshot]
    ASSERT_EQ(other.GetBodyCount(), 2);
    stage.Run(2.0f);
    for (int i = 0; i < 120; ++i)
    {
        other.Step(1.0f / 60.0f, 8, 3);
    }
    EXPECT_EQ(other.GetBodyList()->GetPosition(), box->GetPosition());
    EXPECT_EQ(other.GetBodyList()->GetAngle(), box->GetAngle());
    EXPECT_EQ(other.GetBodyList()->GetNumber(), box->GetNumber());

    std::vector<uint8> damaged = saved;
    damaged[damaged.size() / 2] ^= 1;
    EXPECT_NE(b2RestoreSnapshot(other, damaged), nullptr);
}

TEST(WorldListing, MovesItsOrigin)
{
    manual::Stage stage;
    b2Body* box = stage.Box(1000.0f, 20.0f);
    // [shift]
    stage.world.ShiftOrigin(b2Vec2(1000.0f, 0.0f)); // what was there is at (0, 0) now
    // [/shift]
    EXPECT_EQ(box->GetPosition(), b2Vec2(0.0f, 20.0f));
}

} // namespace
