// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsMisuse.h"
#include "DynamicsScene.h"

#include <Common/WideInstructions.h>
#include <Dynamics/Solver/ContactBlocks.h>

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

/// A world gives the same bits and the same events in the same order for every number of threads.
namespace
{

using namespace dynamics;

/// Balls, boxes and bars fall into a pit with a turning bar, a sensor and some bullets; more than
/// enough of each for every loop to be shared.
class Pit
{
public:
    explicit Pit(int32 threads, int32 subSteps = 1, int columns = 20)
    {
        scene.world.SetThreadCount(threads);
        scene.world.SetSubStepCount(subSteps);
        scene.Ground();
        const float32 half = 0.375f * float32(columns);
        scene.Wall(-half - 1.5f, 0.5f);
        scene.Wall(half + 1.5f, 0.5f);
        b2Body* bar = scene.Body(b2_kinematicBody, 0.0f, 4.0f);
        Scene::AddBox(bar, 4.0f, 0.2f);
        bar->SetAngularVelocity(1.5f);
        b2Body* gate = scene.Body(b2_staticBody, 0.0f, 2.0f);
        Scene::AddBox(gate, 5.0f, 1.0f)->SetSensor(true);
        for (int i = 0; i < 20 * columns; ++i)
        {
            const float32 x = -half + 0.75f * float32(i % columns) + 0.01f * float32(i % 7);
            const float32 y = 6.0f + 0.8f * float32(i / columns);
            b2Body* body = i % 3 == 0   ? scene.Ball(x, y, 0.3f)
                           : i % 3 == 1 ? scene.Box(x, y, 0.3f, 0.25f)
                                        : scene.Box(x, y, 0.35f, 0.1f);
            body->GetFixtureList()->SetRestitution(0.1f * float32(i % 5));
            if (i % 40 == 0)
            {
                body->SetBullet(true);
                body->SetLinearVelocity(b2Vec2(80.0f, -60.0f));
            }
        }
    }

    std::uint64_t Hash() const
    {
        std::uint64_t hash = 14695981039346656037ull; // FNV-1a
        const auto add = [&hash](float32 value) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211ull;
        };
        for (const b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
        {
            add(b->GetPosition().x);
            add(b->GetPosition().y);
            add(b->GetAngle());
            add(b->GetLinearVelocity().x);
            add(b->GetLinearVelocity().y);
            add(b->GetAngularVelocity());
            add(b->IsAwake() ? 1.0f : 0.0f);
        }
        return hash;
    }

    Scene scene;
};

struct WidthGuard
{
    ~WidthGuard() { box2d::UseLanes(16); }
};

/// Compares the bits of every number of threads and width after each 100 of 300 steps.
void ExpectSameBits(int32 subSteps)
{
    const WidthGuard guard;
    std::uint64_t expected[3] = {0, 0, 0};
    for (const int lanes : {16, 8, 4})
    {
        for (const int32 threads : {1, 2, 3, 4, 8})
        {
            box2d::UseLanes(lanes);
            Pit pit(threads, subSteps);
            for (std::uint64_t& hash : expected)
            {
                pit.scene.Step(100);
                hash = hash == 0 ? pit.Hash() : hash;
                EXPECT_EQ(pit.Hash(), hash) << threads << " threads, lanes: " << lanes;
            }
            EXPECT_EQ(WhyBroken(pit.scene.world, true), "");
        }
    }
}

TEST(DynamicsThreads, GiveTheSameBitsInAnyNumberAndWidth)
{
    ExpectSameBits(1);
}

TEST(DynamicsThreads, GiveTheSameBitsInSubSteps)
{
    ExpectSameBits(4);
}

/// Each colour has enough touching contacts for a part per thread.
TEST(DynamicsThreads, GiveTheSameBitsWhereEightShareAColour)
{
    for (const int32 subSteps : {1, 2})
    {
        Pit one(1, subSteps, 120);
        Pit eight(8, subSteps, 120);
        one.scene.Step(90);
        eight.scene.Step(90);
        EXPECT_EQ(eight.Hash(), one.Hash()) << subSteps << " sub-steps";
    }
}

/// Returns the threads of this process; the system lists each as a folder.
int32 RunningThreads()
{
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return int32(std::distance(begin(tasks), end(tasks)));
}

TEST(DynamicsThreads, AreNotCreatedUnlessAskedFor)
{
    if (!std::filesystem::exists("/proc/self/task"))
    {
        GTEST_SKIP() << "this system does not list a process's threads in /proc/self/task";
    }
    std::thread([] {}).join(); // with the first thread a sanitizer starts one of its own
    const int32 before = RunningThreads();
    Scene scene;
    scene.Ground();
    Stack(scene, 0.0f, 200);
    for (const int32 subSteps : {1, 4})
    {
        scene.world.SetSubStepCount(subSteps);
        scene.Step(5);
        EXPECT_EQ(RunningThreads(), before) << subSteps << " sub-steps";
    }
    scene.world.SetThreadCount(3);
    EXPECT_EQ(RunningThreads(), before + 2);
}

TEST(DynamicsThreads, CanBeChangedBetweenSteps)
{
    Pit one(1);
    one.scene.Step(120);
    Pit pit(1);
    for (const int32 threads : {4, 2, 1, 3, 3, 1})
    {
        pit.scene.world.SetThreadCount(threads);
        EXPECT_EQ(pit.scene.world.GetThreadCount(), threads);
        pit.scene.Step(20);
    }
    EXPECT_EQ(pit.Hash(), one.Hash());
}

/// Records every event. It also changes what a listener may change: it disables contacts, makes a
/// fixture a sensor, and puts bodies to sleep.
class Recorder : public b2ContactListener, public b2ContactFilter
{
public:
    explicit Recorder(bool meddles) : m_meddles(meddles) {}

    void BeginContact(b2Contact* contact) override
    {
        Note("begin", contact);
        if (m_meddles && ++m_begun % 50 == 0)
        {
            contact->GetFixtureB()->SetSensor(!contact->GetFixtureB()->IsSensor());
        }
        if (m_meddles && m_begun % 70 == 0)
        {
            contact->GetFixtureA()->GetBody()->SetAwake(false);
        }
    }
    void EndContact(b2Contact* contact) override { Note("end", contact); }
    void PreSolve(b2Contact* contact, const b2Manifold* old) override
    {
        Note("pre", contact);
        Note(old->pointCount);
        Note(contact->GetManifold()->pointCount);
        for (int32 i = 0; i < old->pointCount; ++i)
        {
            Note(std::bit_cast<int32>(old->points[i].normalImpulse));
            Note(std::bit_cast<int32>(old->points[i].localPoint.x));
        }
        b2Body* body = contact->GetFixtureB()->GetBody();
        for (const b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next)
        {
            Note(edge->contact->GetManifold()->pointCount); // as much as anyone can see
        }
        if (m_meddles && ++m_pre % 30 == 0)
        {
            contact->SetEnabled(false);
        }
        if (m_meddles && m_pre % 41 == 0)
        {
            body->SetAwake(false);
        }
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        Note("post", contact);
        for (int32 i = 0; i < impulse->count; ++i)
        {
            Note(std::bit_cast<int32>(impulse->normalImpulses[i]));
        }
    }
    bool ShouldCollide(b2Fixture* a, b2Fixture* b) override
    {
        Note("filter", a->GetBody(), b->GetBody());
        return true;
    }

    std::uint64_t hash = 14695981039346656037ull;
    int count = 0;
    int fromElsewhere = 0;

private:
    void Note(int32 value) { hash = (hash ^ std::uint32_t(value)) * 1099511628211ull; }
    void Note(const char* what, const b2Body* a, const b2Body* b)
    {
        ++count;
        fromElsewhere += std::this_thread::get_id() != m_home;
        Note(int32(what[0]));
        for (const b2Body* body : {a, b})
        {
            Note(std::bit_cast<int32>(body->GetPosition().x));
            Note(std::bit_cast<int32>(body->GetPosition().y));
        }
    }
    void Note(const char* what, b2Contact* contact)
    {
        Note(what, contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody());
    }

    bool m_meddles;
    int m_begun = 0;
    int m_pre = 0;
    std::thread::id m_home = std::this_thread::get_id();
};

TEST(DynamicsThreads, LeaveCallbacksToTheCallerInTheSameOrder)
{
    for (const bool meddles : {false, true})
    {
        std::uint64_t first = 0;
        std::uint64_t ended = 0;
        for (const int32 threads : {1, 2, 4})
        {
            Recorder recorder(meddles);
            Pit pit(threads);
            pit.scene.world.SetContactListener(&recorder);
            pit.scene.world.SetContactFilter(&recorder);
            pit.scene.Step(200);
            EXPECT_GT(recorder.count, 10000);
            EXPECT_EQ(recorder.fromElsewhere, 0);
            first = threads == 1 ? recorder.hash : first;
            ended = threads == 1 ? pit.Hash() : ended;
            EXPECT_EQ(recorder.hash, first) << threads << " threads, meddles: " << meddles;
            EXPECT_EQ(pit.Hash(), ended) << threads << " threads, meddles: " << meddles;
            pit.scene.world.SetContactListener(nullptr); // who sleeps is its doing, for a step
            pit.scene.world.SetContactFilter(nullptr);
            pit.scene.Step(3);
            EXPECT_EQ(WhyBroken(pit.scene.world, true), "");
        }
    }
}

TEST(DynamicsThreads, ServeSeveralWorldsAtOnce)
{
    Pit alone(1);
    alone.scene.Step(60);
    std::uint64_t hashes[2] = {0, 0};
    std::thread helper([&hashes] {
        Pit pit(2);
        pit.scene.Step(60);
        hashes[0] = pit.Hash();
    });
    Pit pit(3);
    pit.scene.Step(60);
    hashes[1] = pit.Hash();
    helper.join();
    EXPECT_EQ(hashes[0], alone.Hash());
    EXPECT_EQ(hashes[1], alone.Hash());
}

TEST(DynamicsThreads, AreRefusedOutsideOneToSixtyFour)
{
    Scene scene;
    EXPECT_EQ(scene.world.GetThreadCount(), 1);
    for (const int32 wrong : {0, -3, 65})
    {
        ExpectMisuse("1 to 64", [&] { scene.world.SetThreadCount(wrong); });
    }
    EXPECT_GE(scene.world.GetThreadCount(), 1);
    EXPECT_LE(scene.world.GetThreadCount(), 64);
}

struct Changer : public b2ContactListener
{
    explicit Changer(b2World& ofWorld) : world(ofWorld) {}
    void BeginContact(b2Contact*) override { world.SetThreadCount(2); }
    b2World& world;
};

TEST(DynamicsThreads, CannotBeChangedFromACallback)
{
    testing::FLAGS_gtest_death_test_style = "fast";
    ExpectMisuse("callback", [] {
        Scene scene;
        Changer changer(scene.world);
        scene.world.SetContactListener(&changer);
        scene.Ground();
        scene.Box(0.0f, 0.5f);
        scene.Step(10);
        EXPECT_EQ(scene.world.GetThreadCount(), 1);
    });
}

} // namespace
