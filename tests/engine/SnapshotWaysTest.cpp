// SPDX-License-Identifier: MIT
#include "MixedWorld.h"
#include "SnapshotSupport.h"

#include <stability/RandomWorlds.h>

#include <memory>
#include <tuple>

/// Compares a world that continues from a snapshot with the saved one: all kinds of worlds, at any
/// step, with any number of sub-steps and threads.
namespace
{

using namespace snapshots;

/// Numbers of sub-steps and of threads; the restored world has other threads than the saved one.
class RestoredWorld : public testing::TestWithParam<std::tuple<int, int>>
{
protected:
    int SubSteps() const { return std::get<0>(GetParam()); }
    int Threads() const { return std::get<1>(GetParam()); }

    void Prepare(b2World& world) const
    {
        world.SetSubStepCount(SubSteps());
        world.SetThreadCount(Threads());
    }
};

INSTANTIATE_TEST_SUITE_P(, RestoredWorld,
                         testing::Combine(testing::Values(1, 2, 4), testing::Values(1, 2)),
                         [](const auto& made) {
                             return std::to_string(std::get<0>(made.param)) + "SubSteps" +
                                    std::to_string(std::get<1>(made.param)) + "Threads";
                         });

TEST_P(RestoredWorld, MovesAsTheMixedWorldThatWasSaved)
{
    for (unsigned seed = 0; seed < 3; ++seed)
    {
        SCOPED_TRACE(seed);
        MixedWorld mixed(seed);
        Prepare(mixed.world);
        for (int i = mixed.Below(120); i > 0; --i)
        {
            mixed.world.Step(1.0f / 60.0f, 8, 3);
        }
        b2World restored(b2Vec2(0.0f, 0.0f));
        ExpectRestored(restored, b2SaveSnapshot(mixed.world));
        Steps steps;
        steps.events = seed % 2 == 0;
        ExpectSameWay(mixed.world, restored, steps);
    }
}

/// From the snapshot on mice keep the target that they have.
stability::WorldPlan PlanFor(int number, int subSteps)
{
    stability::WorldPlan plan = stability::PlanWorld(number);
    plan.subSteps = subSteps;
    return plan;
}

TEST_P(RestoredWorld, MovesAsTheRandomWorldThatWasSaved)
{
    std::mt19937 random(7);
    for (int number = 0; number < 8; ++number)
    {
        SCOPED_TRACE(number);
        stability::RandomWorld world(PlanFor(number, SubSteps()));
        world.World().SetThreadCount(Threads());
        const int before = int(random() % 150);
        for (int i = 0; i < before; ++i)
        {
            world.MoveTargets();
            world.Step();
        }
        b2World restored(b2Vec2(0.0f, 0.0f));
        ExpectRestored(restored, b2SaveSnapshot(world.World()));
        Steps steps;
        std::copy_n(world.Plan().steps, 2, steps.lengths);
        steps.first = before;
        steps.events = number % 2 == 0;
        ExpectSameWay(world.World(), restored, steps);
    }
}

/// Makes random user changes to a world from step to step; the same changes to the same world.
class Meddler
{
public:
    explicit Meddler(unsigned seed) : m_seed(seed) {}

    void operator()(b2World& world, int step) const
    {
        std::mt19937 random(m_seed * 1000 + unsigned(step));
        const auto below = [&](int count) { return int(random() % unsigned(count)); };
        b2Body* const body = BodyAt(world, below(world.GetBodyCount()));
        b2Joint* const joint =
            world.GetJointCount() > 0 ? JointAt(world, below(world.GetJointCount())) : nullptr;
        switch (below(20))
        {
        case 0:
            body->SetAwake(below(2) == 0);
            break;
        case 1:
            body->SetActive(below(2) == 0);
            break;
        case 2:
            body->SetType(b2BodyType(below(3)));
            break;
        case 3:
            body->SetTransform(b2Vec2(float32(below(60)) - 30.0f, float32(below(60)) - 30.0f),
                               1.0f);
            break;
        case 4:
            body->ApplyForceToCenter(b2Vec2(30.0f, 50.0f));
            break;
        case 5:
            world.SetSubStepCount(1 + 3 * below(2));
            break;
        case 6:
            world.SetSubStepping(below(3) == 0);
            break;
        case 7:
            world.SetGravity(b2Vec2(float32(below(5)) - 2.0f, -10.0f));
            break;
        case 8:
            body->SetBullet(below(2) == 0);
            break;
        case 9:
            body->SetFixedRotation(below(2) == 0);
            break;
        case 10:
            AddBall(world, b2Vec2(float32(below(60)) - 30.0f, 20.0f));
            break;
        case 11:
            joint ? world.DestroyJoint(joint) : world.DestroyBody(body);
            break;
        case 12:
            if (body->GetFixtureList())
            {
                body->GetFixtureList()->SetSensor(below(2) == 0);
            }
            break;
        case 13:
            body->SetLinearVelocity(b2Vec2(float32(below(200)) - 100.0f, 40.0f));
            break;
        case 14:
            if (joint && joint->GetType() == e_revoluteJoint)
            {
                static_cast<b2RevoluteJoint*>(joint)->EnableMotor(below(2) == 0);
            }
            break;
        default:
            break;
        }
    }

private:
    static void AddBall(b2World& world, const b2Vec2& place)
    {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position = place;
        b2CircleShape ball;
        ball.m_radius = 0.5f;
        b2Body* const body = world.CreateBody(&definition);
        body->CreateFixture(&ball, 1.0f);
        b2RopeJointDef rope;
        rope.bodyA = BodyAt(world, 3);
        rope.bodyB = body;
        rope.maxLength = 30.0f;
        world.CreateJoint(&rope);
    }

    unsigned m_seed;
};

/// The same changes before the snapshot, and the same other ones after it in both worlds.
void ExpectSameWayAfterUserChanges(unsigned seed, int subSteps, int threads)
{
    SCOPED_TRACE(seed);
    MixedWorld mixed(100 + seed);
    mixed.world.SetSubStepCount(subSteps);
    mixed.world.SetThreadCount(threads);
    const Meddler before(seed);
    const int count = 40 + mixed.Below(100);
    for (int i = 0; i < count; ++i)
    {
        before(mixed.world, i);
        mixed.world.Step(1.0f / 60.0f, 8, 3);
    }
    before(mixed.world, 1000); // and between the last step and the snapshot
    before(mixed.world, 1001);
    b2World restored(b2Vec2(0.0f, 0.0f));
    ExpectRestored(restored, b2SaveSnapshot(mixed.world));
    Steps steps;
    steps.count = 120;
    steps.events = seed % 3 == 0;
    ExpectSameWay(mixed.world, restored, steps, Meddler(500 + seed));
}

TEST_P(RestoredWorld, MovesAsTheSavedOneAfterAnyUserChange)
{
    for (unsigned seed = 0; seed < 3; ++seed)
    {
        ExpectSameWayAfterUserChanges(seed, SubSteps(), Threads());
    }
}

/// A body of a rope is put to sleep between the parts of a step.
TEST(RestoredMixedWorld, MovesAsTheSavedOneAfterARareUserChange)
{
    ExpectSameWayAfterUserChanges(231, 2, 1);
}

} // namespace
