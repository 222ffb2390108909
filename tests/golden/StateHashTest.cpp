// SPDX-License-Identifier: MIT
#include <golden/StateHash.h>

#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace boxreel;

namespace
{

b2Body* AddBody(b2World& world, b2Vec2 position, float angle = 0.0f,
                b2Vec2 velocity = b2Vec2(0.0f, 0.0f), float spin = 0.0f)
{
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = position;
    definition.angle = angle;
    definition.linearVelocity = velocity;
    definition.angularVelocity = spin;
    return world.CreateBody(&definition);
}

// FNV-1a over the bytes of the values, written down the plain way.
std::uint64_t HashOf(const std::vector<float>& values)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const float value : values)
    {
        unsigned char bytes[4];
        std::memcpy(bytes, &value, 4);
        for (const unsigned char byte : bytes)
        {
            hash = (hash ^ byte) * 1099511628211u;
        }
    }
    return hash;
}

std::uint64_t HashOfOne(b2Vec2 position, float angle = 0.0f, b2Vec2 velocity = b2Vec2(0.0f, 0.0f),
                        float spin = 0.0f)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBody(world, position, angle, velocity, spin);
    return StateHash(world);
}

float NextUp(float value)
{
    return std::nextafter(value, std::numeric_limits<float>::infinity());
}

} // namespace

TEST(StateHash, TakesEveryBodyInOrderOfCreation)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    EXPECT_EQ(StateHash(world), HashOf({}));
    AddBody(world, b2Vec2(1.0f, 2.0f), 0.5f, b2Vec2(3.0f, 4.0f), 5.0f);
    AddBody(world, b2Vec2(6.0f, 7.0f), 0.25f, b2Vec2(8.0f, 9.0f), 10.0f);
    EXPECT_EQ(StateHash(world), HashOf({1, 2, 0.5f, 3, 4, 5, 6, 7, 0.25f, 8, 9, 10}));
}

TEST(StateHash, ChangesWithTheLastBitOfEachQuantity)
{
    const b2Vec2 p(1.0f, 2.0f), v(3.0f, 4.0f);
    const std::uint64_t hash = HashOfOne(p, 0.5f, v, 5.0f);
    EXPECT_EQ(hash, HashOfOne(p, 0.5f, v, 5.0f));
    EXPECT_NE(hash, HashOfOne(b2Vec2(NextUp(p.x), p.y), 0.5f, v, 5.0f));
    EXPECT_NE(hash, HashOfOne(b2Vec2(p.x, NextUp(p.y)), 0.5f, v, 5.0f));
    EXPECT_NE(hash, HashOfOne(p, NextUp(0.5f), v, 5.0f));
    EXPECT_NE(hash, HashOfOne(p, 0.5f, b2Vec2(NextUp(v.x), v.y), 5.0f));
    EXPECT_NE(hash, HashOfOne(p, 0.5f, b2Vec2(v.x, NextUp(v.y)), 5.0f));
    EXPECT_NE(hash, HashOfOne(p, 0.5f, v, NextUp(5.0f)));
}

TEST(StateHash, TreatsMinusZeroAsZero)
{
    const b2Vec2 minus(-0.0f, -0.0f);
    EXPECT_EQ(HashOfOne(minus, -0.0f, minus, -0.0f), HashOfOne(b2Vec2(0.0f, 0.0f)));
}

TEST(StateHash, IsEqualForEqualMotionAndChangesWithEachStep)
{
    b2World a(b2Vec2(0.0f, -10.0f)), b(b2Vec2(0.0f, -10.0f));
    AddBody(a, b2Vec2(0.0f, 5.0f), 0.1f);
    AddBody(b, b2Vec2(0.0f, 5.0f), 0.1f);
    for (int step = 0; step < 10; ++step)
    {
        const std::uint64_t before = StateHash(a);
        a.Step(1.0f / 60.0f, 8, 3);
        b.Step(1.0f / 60.0f, 8, 3);
        EXPECT_EQ(StateHash(a), StateHash(b));
        EXPECT_NE(StateHash(a), before);
    }
}

TEST(StateHashText, HasSixteenLowerCaseHexDigitsWithLeadingZeros)
{
    bool sawLeadingZero = false;
    for (int i = 0; i < 200; ++i)
    {
        b2World world(b2Vec2(0.0f, -10.0f));
        AddBody(world, b2Vec2(static_cast<float>(i), 0.0f));
        const std::string text = StateHashText(world);
        ASSERT_EQ(text.size(), 16u);
        EXPECT_EQ(text.find_first_not_of("0123456789abcdef"), std::string::npos);
        EXPECT_EQ(std::stoull(text, nullptr, 16), StateHash(world));
        sawLeadingZero = sawLeadingZero || text[0] == '0';
    }
    EXPECT_TRUE(sawLeadingZero);
}

TEST(ReadWorldState, KeepsNumbersOfBodiesWithGaps)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    AddBody(world, b2Vec2(1, 2), 0.5f, b2Vec2(3, 4), 5);
    b2Body* const gone = AddBody(world, b2Vec2(0, 0));
    AddBody(world, b2Vec2(7, 8));
    world.DestroyBody(gone);
    const std::vector<BodyState> expected = {{0, 1, 2, 0.5f, 3, 4, 5}, {2, 7, 8, 0, 0, 0, 0}};
    EXPECT_EQ(ReadWorldState(world).bodies, expected);
}

TEST(ReadTraceStep, WritesDigitPerBodyAndDotIfRemoved)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body* bodies[3];
    for (b2Body*& body : bodies)
    {
        body = AddBody(world, b2Vec2(1, 2));
    }
    const TraceStep all = ReadTraceStep(world, 7);
    EXPECT_EQ(all.step, 7);
    ASSERT_EQ(all.bodies.size(), 3u);
    EXPECT_EQ(all.bodies, std::string(3, all.bodies[0])) << "bodies alike have the same digit";
    world.DestroyBody(bodies[1]);
    const TraceStep fewer = ReadTraceStep(world, 8);
    EXPECT_EQ(fewer.bodies[1], '.');
    EXPECT_NE(fewer.world, all.world);
}

TEST(ReadTraceStep, ChangesDigitInFifteenOfSixteenMoves)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body* const body = AddBody(world, b2Vec2(1, 2));
    int different = 0;
    constexpr int kTrials = 400;
    for (int i = 0; i < kTrials; ++i)
    {
        const TraceStep before = ReadTraceStep(world, i);
        body->SetTransform(b2Vec2(NextUp(body->GetPosition().x), 2), 0);
        const TraceStep after = ReadTraceStep(world, i);
        EXPECT_NE(before.world, after.world);
        different += before.bodies != after.bodies;
    }
    EXPECT_NEAR(different, kTrials * 15 / 16, kTrials / 16);
}

TEST(ReadTraceStep, FindsMovedBodyAmongMany)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    std::vector<b2Body*> bodies;
    for (int i = 0; i < 1000; ++i)
    {
        bodies.push_back(AddBody(world, b2Vec2(float(i), 2)));
    }
    int found = 0;
    for (const int moved : {0, 31, 32, 555, 999})
    {
        const StateTrace before{{ReadTraceStep(world, 1)}};
        bodies[std::size_t(moved)]->SetTransform(b2Vec2(-1, 0.5f), 0);
        const auto difference = FirstDifference(before, {{ReadTraceStep(world, 1)}});
        ASSERT_TRUE(difference);
        if (!difference->bodies.empty()) // by chance a row or a column has the same digit
        {
            EXPECT_EQ(difference->bodies, std::vector<int>{moved});
            ++found;
        }
    }
    EXPECT_GE(found, 4);
}
