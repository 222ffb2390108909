// SPDX-License-Identifier: MIT
#include "../base/ReadBytes.h"
#include "DynamicsScene.h"
#include "MixedWorld.h"
#include "SnapshotSupport.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

/// The bytes of a snapshot: the same for the same world, read in another run of the program, and
/// refused when anything is wrong with them.
namespace
{

using namespace snapshots;

Bytes SomeBytes(unsigned seed = 0)
{
    MixedWorld mixed(seed);
    mixed.world.SetSubStepCount(2);
    for (int i = 0; i < 25; ++i)
    {
        mixed.world.Step(1.0f / 60.0f, 8, 3);
    }
    return b2SaveSnapshot(mixed.world);
}

TEST(SnapshotBytes, AreTheSameTwiceInARow)
{
    MixedWorld mixed(1);
    EXPECT_TRUE(b2SaveSnapshot(mixed.world) == b2SaveSnapshot(mixed.world));
}

TEST(SnapshotBytes, AreTheSameOnceRestored)
{
    for (unsigned seed = 0; seed < 20; ++seed)
    {
        const Bytes bytes = SomeBytes(seed);
        b2World restored(b2Vec2(0.0f, 0.0f));
        ExpectRestored(restored, bytes);
        EXPECT_TRUE(b2SaveSnapshot(restored) == bytes) << seed;
    }
}

/// Expects a complete sentence, and a world that continues unchanged.
void ExpectRefused(std::span<const uint8> bytes, const char* culprit)
{
    MixedWorld mixed(5);
    const Bytes before = b2SaveSnapshot(mixed.world);
    const char* why = b2RestoreSnapshot(mixed.world, bytes);
    ASSERT_NE(why, nullptr);
    EXPECT_NE(std::string(why).find(culprit), std::string::npos) << why;
    EXPECT_EQ(std::string(why).back(), '.');
    EXPECT_TRUE(b2SaveSnapshot(mixed.world) == before);
}

TEST(SnapshotBytes, AreRefusedIfNotASnapshot)
{
    ExpectRefused({}, "not a snapshot");
    ExpectRefused(Bytes(1000, 7), "not a snapshot");
}

TEST(SnapshotBytes, AreRefusedWithAnotherVersion)
{
    Bytes bytes = SomeBytes();
    ++bytes[8];
    ExpectRefused(bytes, "another version");
}

TEST(SnapshotBytes, AreRefusedWithOneTooManyOrTooFew)
{
    Bytes bytes = SomeBytes();
    bytes.push_back(0);
    ExpectRefused(bytes, "not whole");
    bytes.resize(bytes.size() - 2);
    ExpectRefused(bytes, "not whole");
}

TEST(SnapshotBytes, AreRefusedWithAFlippedBit)
{
    Bytes bytes = SomeBytes();
    b2World world(b2Vec2(0.0f, -10.0f));
    for (std::size_t i = 0; i < bytes.size(); i += 1 + i / 64)
    {
        for (const uint8 bit : {uint8(1), uint8(16), uint8(128)})
        {
            bytes[i] ^= bit;
            ASSERT_NE(b2RestoreSnapshot(world, bytes), nullptr) << i;
            bytes[i] ^= bit;
        }
    }
    EXPECT_EQ(world.GetBodyCount(), 0);
    ExpectRefused(std::span(bytes).first(bytes.size() / 2), "not whole");
}

TEST(SnapshotBytes, AreRefusedWhenTruncated)
{
    const Bytes bytes = SomeBytes();
    b2World world(b2Vec2(0.0f, -10.0f));
    for (std::size_t size = 0; size < bytes.size(); ++size)
    {
        ASSERT_NE(b2RestoreSnapshot(world, std::span(bytes).first(size)), nullptr) << size;
    }
}

/// A valid checksum does not make the bytes valid, because anyone can compute it. Here the engine's
/// own is put on wrong bytes. Restoring them must not access invalid memory.
std::uint64_t ChecksumOf(std::span<const uint8> bytes)
{
    std::uint64_t sum = bytes.size();
    for (std::size_t i = 0; i < bytes.size(); i += 8)
    {
        std::uint64_t word = 0;
        for (std::size_t k = 0; k < 8 && i + k < bytes.size(); ++k)
        {
            word |= std::uint64_t(bytes[i + k]) << (8 * k);
        }
        sum = std::rotl((sum ^ word) * 0x9E3779B97F4A7C15u, 29);
    }
    return sum;
}

void PutNumber(Bytes& bytes, std::size_t at, std::uint64_t number)
{
    for (std::size_t k = 0; k < 8; ++k)
    {
        bytes[at + k] = uint8(number >> (8 * k));
    }
}

/// With a length and a checksum that fit.
void Seal(Bytes& bytes)
{
    const std::span<const uint8> content = std::span(bytes).subspan(28);
    PutNumber(bytes, 12, content.size());
    PutNumber(bytes, 20, ChecksumOf(content));
}

TEST(SnapshotBytes, HaveTheChecksumThatTheTestComputes)
{
    Bytes bytes = SomeBytes();
    const Bytes saved = bytes;
    Seal(bytes);
    EXPECT_TRUE(bytes == saved);
}

TEST(SnapshotBytes, DoNotCrashWhenContradictory)
{
    const Bytes saved = SomeBytes();
    std::mt19937 random(11);
    int refused = 0;
    for (int i = 0; i < 1500; ++i)
    {
        Bytes bytes = saved;
        if (i % 3 == 0)
        {
            bytes.resize(28 + random() % (bytes.size() - 28));
        }
        for (std::size_t changes = 1 + random() % 3; changes > 0; --changes)
        {
            const std::size_t at = 28 + random() % std::max<std::size_t>(bytes.size() - 28, 1);
            if (at < bytes.size())
            {
                bytes[at] = random() % 2 == 0 ? uint8(random()) : uint8(255);
            }
        }
        Seal(bytes);
        b2World world(b2Vec2(0.0f, -10.0f));
        refused += b2RestoreSnapshot(world, bytes) != nullptr;
    }
    EXPECT_GT(refused, 500);
}

TEST(SnapshotBytes, AreRefusedInsideACallback)
{
    struct Caller : b2QueryCallback
    {
        bool ReportFixture(b2Fixture* fixture) override
        {
            why = b2RestoreSnapshot(*fixture->GetBody()->GetWorld(), bytes);
            return false;
        }
        Bytes bytes = SomeBytes();
        const char* why = nullptr;
    } caller;
    MixedWorld mixed(2);
    b2AABB everywhere;
    everywhere.lowerBound.Set(-100.0f, -100.0f);
    everywhere.upperBound.Set(100.0f, 100.0f);
    mixed.world.QueryAABB(&caller, everywhere);
    ASSERT_NE(caller.why, nullptr);
    EXPECT_NE(std::string(caller.why).find("callback"), std::string::npos);
}

TEST(SnapshotBytes, KeepListenersThreadsAndFilterOfTheWorld)
{
    struct Nothing : b2ContactFilter
    {
        bool ShouldCollide(b2Fixture*, b2Fixture*) override { return ++asked < 0; }
        int asked = 0;
    } filter;
    dynamics::Scene scene;
    scene.Ground();
    scene.Ball(0.0f, 0.5f);  // lies on the ground
    scene.Ball(5.0f, 20.0f); // comes down there
    scene.Step(3);
    EventLog log;
    b2World world(b2Vec2(0.0f, 0.0f));
    world.SetContactListener(&log);
    world.SetContactFilter(&filter);
    world.SetThreadCount(3);
    ExpectRestored(world, b2SaveSnapshot(scene.world));
    EXPECT_EQ(world.GetThreadCount(), 3);
    EXPECT_EQ(world.GetContactManager().m_contactListener, &log);
    EXPECT_EQ(world.GetContactManager().m_contactFilter, &filter);
    world.Step(dynamics::kStep, 8, 3);
    EXPECT_FALSE(log.events.empty());
    EXPECT_EQ(filter.asked, 0);
    for (int i = 0; i < 200; ++i)
    {
        world.Step(dynamics::kStep, 8, 3);
    }
    EXPECT_GT(filter.asked, 0);
    EXPECT_LT(BodyAt(world, 0)->GetPosition().y, -5.0f);
}

TEST(SnapshotBytes, ContinueTheNumbersOfBodies)
{
    MixedWorld mixed(4);
    b2BodyDef definition;
    mixed.world.DestroyBody(mixed.world.CreateBody(&definition));
    b2World restored(b2Vec2(0.0f, 0.0f));
    ExpectRestored(restored, b2SaveSnapshot(mixed.world));
    const b2Body* one = mixed.world.CreateBody(&definition);
    const b2Body* another = restored.CreateBody(&definition);
    for (; one != nullptr && another != nullptr; one = one->GetNext(), another = another->GetNext())
    {
        EXPECT_EQ(one->GetNumber(), another->GetNumber());
    }
    EXPECT_EQ(one, another);
    EXPECT_EQ(another, nullptr);
}

/// User data as numbers: the places of names in a list.
class Names : public b2SnapshotUserData
{
public:
    std::uint64_t ToNumber(void* userData) override
    {
        return std::uint64_t(static_cast<std::string*>(userData) - m_names);
    }
    void* ToPointer(std::uint64_t number) override { return m_names + number; }

    std::string m_names[3] = {"body", "fixture", "joint"};
};

TEST(SnapshotBytes, StoreUserDataAsTheProgramConvertsIt)
{
    Names names;
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    b2Body* const other = world.CreateBody(&definition);
    definition.userData = &names.m_names[0];
    b2Body* const body = world.CreateBody(&definition);
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    body->CreateFixture(&ball, 1.0f)->SetUserData(&names.m_names[1]);
    b2WeldJointDef weld;
    weld.Initialize(other, body, b2Vec2(0.0f, 0.0f));
    weld.userData = &names.m_names[2];
    world.CreateJoint(&weld);

    Names others;
    b2World restored(b2Vec2(0.0f, 0.0f));
    ASSERT_EQ(b2RestoreSnapshot(restored, b2SaveSnapshot(world, &names), &others), nullptr);
    EXPECT_EQ(BodyAt(restored, 0)->GetUserData(), &others.m_names[0]);
    EXPECT_EQ(BodyAt(restored, 0)->GetFixtureList()->GetUserData(), &others.m_names[1]);
    EXPECT_EQ(BodyAt(restored, 1)->GetUserData(), nullptr);
    EXPECT_EQ(restored.GetJointList()->GetUserData(), &others.m_names[2]);

    ASSERT_EQ(b2RestoreSnapshot(restored, b2SaveSnapshot(world, &names)), nullptr);
    EXPECT_EQ(BodyAt(restored, 0)->GetUserData(), nullptr);
    ASSERT_EQ(b2RestoreSnapshot(restored, b2SaveSnapshot(world), &others), nullptr);
    EXPECT_EQ(restored.GetJointList()->GetUserData(), nullptr);
}

constexpr const char* kFile = "BOXREEL_SNAPSHOT_FILE";

Bytes ReadFile(const std::filesystem::path& name)
{
    const std::string text = ReadBytes(name);
    return Bytes(text.begin(), text.end());
}

void WriteFile(const std::filesystem::path& name, const Bytes& bytes)
{
    std::ofstream file(name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

Bytes GoOnFrom(const Bytes& bytes)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    ExpectRestored(world, bytes);
    for (int i = 0; i < 100; ++i)
    {
        world.Step(1.0f / 60.0f, 8, 3);
    }
    return b2SaveSnapshot(world);
}

/// The other run is the same test, selected by its environment, with other addresses.
TEST(SnapshotBytes, ContinueInAnotherRunOfTheProgram)
{
    if (const char* file = std::getenv(kFile))
    {
        WriteFile(std::string(file) + ".after", GoOnFrom(ReadFile(file)));
        return;
    }
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                         ("snapshot" + std::to_string(std::random_device()()));
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "world").string();
    const Bytes bytes = SomeBytes();
    WriteFile(file, bytes);
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = std::string(kFile) + "='" + file + "' '" + program +
                                "' --gtest_filter='*ContinueInAnotherRun*' >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_TRUE(ReadFile(file + ".after") == GoOnFrom(bytes));
    std::filesystem::remove_all(folder);
}

} // namespace
