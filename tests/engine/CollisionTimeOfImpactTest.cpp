// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2TimeOfImpact.h>

#include <gtest/gtest.h>

namespace
{
constexpr float kTolerance = 0.25f * b2_linearSlop;
constexpr float kRounding = 1.0e-4f;

b2Sweep RandomSweep(Random& random, float reach, float way, float turn)
{
    b2Sweep sweep;
    sweep.localCenter = random.Point(0.2f);
    sweep.c0 = random.Point(reach);
    sweep.c = sweep.c0 + random.Point(way);
    sweep.a0 = random.Real(-3.0f, 3.0f);
    sweep.a = sweep.a0 + random.Real(-turn, turn);
    return sweep;
}

float DistanceAt(const b2TOIInput& input, float t)
{
    b2DistanceInput distance;
    distance.proxyA = input.proxyA;
    distance.proxyB = input.proxyB;
    input.sweepA.GetTransform(&distance.transformA, t);
    input.sweepB.GetTransform(&distance.transformB, t);
    b2SimplexCache cache;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &distance);
    return output.distance;
}

float Target(const b2TOIInput& input)
{
    return b2Max(b2_linearSlop,
                 input.proxyA.m_radius + input.proxyB.m_radius - 3.0f * b2_linearSlop);
}

// The first of many instants at which the shapes are closer than the target, refined by bisection;
// tMax if there is none.
float FirstContact(const b2TOIInput& input, int instants)
{
    const float target = Target(input) - kRounding;
    float before = 0.0f;
    for (int i = 0; i <= instants; ++i)
    {
        const float t = input.tMax * static_cast<float>(i) / static_cast<float>(instants);
        if (DistanceAt(input, t) < target)
        {
            float after = t;
            for (int k = 0; k < 20 && i > 0; ++k)
            {
                const float middle = 0.5f * (before + after);
                (DistanceAt(input, middle) < target ? after : before) = middle;
            }
            return after;
        }
        before = t;
    }
    return input.tMax;
}

struct Counts
{
    int touching = 0;
    int separated = 0;
    int overlapped = 0;
    int failed = 0;
};

// Every answer is held against the brute force: never late, and touching only when it is so.
Counts Check(std::uint64_t seed, int pairs, float way, float turn, float size)
{
    Random random(seed);
    Counts counts;
    for (int i = 0; i < pairs; ++i)
    {
        const std::unique_ptr<b2Shape> a = random.Shape(size);
        const std::unique_ptr<b2Shape> b = random.Shape(size);
        b2TOIInput input;
        input.proxyA.Set(a.get(), 0);
        input.proxyB.Set(b.get(), 0);
        input.sweepA = RandomSweep(random, 2.0f, way, turn);
        input.sweepB = RandomSweep(random, 2.0f, way, turn);
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        const float first = FirstContact(input, 400);
        // A late answer would have let the shapes come closer than the target before it.
        EXPECT_LE(output.t, first + 1.0e-3f) << "seed " << seed << " pair " << i;
        switch (output.state)
        {
        case b2TOIOutput::e_touching:
            ++counts.touching;
            EXPECT_LT(DistanceAt(input, output.t), Target(input) + kTolerance + kRounding) << i;
            break;
        case b2TOIOutput::e_separated:
            ++counts.separated;
            EXPECT_EQ(output.t, input.tMax);
            break;
        case b2TOIOutput::e_overlapped:
            ++counts.overlapped;
            EXPECT_LT(DistanceAt(input, 0.0f), kRounding);
            break;
        default:
            ++counts.failed;
            break;
        }
    }
    return counts;
}
} // namespace

TEST(TimeOfImpact, MissesNothingWhenShapesDoNotTurn)
{
    const Counts counts = Check(31, 2000, 4.0f, 0.0f, 0.5f);
    EXPECT_EQ(counts.failed, 0);
    EXPECT_GT(counts.touching, 150);
    EXPECT_GT(counts.separated, 200);
    EXPECT_GT(counts.overlapped, 30);
}

TEST(TimeOfImpact, MissesNothingWhenShapesTurn)
{
    const Counts counts = Check(32, 2000, 4.0f, 1.5f, 0.5f);
    EXPECT_EQ(counts.failed, 0);
    EXPECT_GT(counts.touching, 150);
    EXPECT_GT(counts.separated, 200);
}

TEST(TimeOfImpact, MissesNothingWhenShapesSpinInPlace)
{
    const Counts counts = Check(33, 2000, 0.1f, 3.0f, 1.0f);
    EXPECT_EQ(counts.failed, 0);
    EXPECT_GT(counts.touching, 50);
}

TEST(TimeOfImpact, StopsABulletAtAThinWall)
{
    b2CircleShape bullet;
    bullet.m_radius = 0.1f;
    b2EdgeShape wall;
    wall.Set(b2Vec2(0.0f, -10.0f), b2Vec2(0.0f, 10.0f));
    b2TOIInput input;
    input.proxyA.Set(&wall, 0);
    input.proxyB.Set(&bullet, 0);
    input.sweepB.c0.Set(-2.0f, 0.0f);
    input.sweepB.c.Set(3.0f, 0.5f);
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    EXPECT_EQ(output.state, b2TOIOutput::e_touching);
    const float target = 0.1f + b2_polygonRadius - 3.0f * b2_linearSlop;
    EXPECT_NEAR(output.t, (2.0f - target) / 5.0f, 1.0e-3f);
}

TEST(TimeOfImpact, IsFoundForAThinRodSpinningIntoAnEdge)
{
    b2PolygonShape rod;
    rod.SetAsBox(1.0f, 0.02f);
    b2EdgeShape edge;
    edge.Set(b2Vec2(0.5f, 0.0f), b2Vec2(5.0f, 0.0f));
    b2TOIInput input;
    input.proxyA.Set(&edge, 0);
    input.proxyB.Set(&rod, 0);
    input.sweepB.a0 = -0.7f;
    input.sweepB.a = 0.7f; // at both ends of the sweep the rod is clear of the edge
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    EXPECT_EQ(output.state, b2TOIOutput::e_touching);
    EXPECT_LT(output.t, 0.5f);
}

/// One bar on another, with 3 mm between their skins. Along a fixed axis one end of a side
/// approaches fast, and the search ran out of steps.
TEST(TimeOfImpact, IsFoundForLongBarsTurningTogether)
{
    constexpr float32 kApart = 0.223f; // from centre to centre [m]
    for (const float32 half : {2.0f, 5.0f, 20.0f})
    {
        b2PolygonShape bar;
        bar.SetAsBox(half, 0.1f);
        b2TOIInput input;
        input.proxyA.Set(&bar, 0);
        input.proxyB.Set(&bar, 0);
        input.sweepA.a = input.sweepB.a = 0.3f;
        input.sweepB.c0.Set(0.0f, kApart);
        input.sweepB.c = b2Mul(b2Rot(0.3f), input.sweepB.c0);
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        EXPECT_EQ(output.state, b2TOIOutput::e_separated) << half;
        input.sweepB.c *= 0.92f; // to 5 mm between their cores, the distance of an impact
        b2TimeOfImpact(&output, &input);
        EXPECT_EQ(output.state, b2TOIOutput::e_touching) << half;
    }
}

TEST(TimeOfImpact, IsTheSameFarFromTheOrigin)
{
    Random random(34);
    for (int i = 0; i < 500; ++i)
    {
        const b2PolygonShape a = random.Polygon(0.5f);
        const b2PolygonShape b = random.Polygon(0.5f);
        b2TOIInput input;
        input.proxyA.Set(&a, 0);
        input.proxyB.Set(&b, 0);
        input.sweepA.c.Set(1.0f, 0.5f);
        input.sweepB.c0.Set(3.0f, 0.25f);
        b2TOIOutput near;
        b2TimeOfImpact(&near, &input);
        const b2Vec2 far(65536.0f, -32768.0f); // so that nothing is lost to rounding
        input.sweepA.c0 += far;
        input.sweepA.c += far;
        input.sweepB.c0 += far;
        input.sweepB.c += far;
        b2TOIOutput away;
        b2TimeOfImpact(&away, &input);
        ASSERT_EQ(near.state, away.state);
        ASSERT_EQ(near.t, away.t);
    }
}
