// SPDX-License-Identifier: MIT
#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

constexpr float32 kStep = 1.0f / 60.0f;

/// A rope of `count` points along x, half a metre apart, of 1 kg each but for those that are held.
struct RopeParts
{
    explicit RopeParts(int32 count)
    {
        for (int32 i = 0; i < count; ++i)
        {
            vertices.emplace_back(0.5f * float32(i), 0.0f);
            masses.push_back(1.0f);
        }
        masses[0] = 0.0f;
    }

    b2RopeDef Definition() const
    {
        b2RopeDef def;
        def.vertices = vertices.data();
        def.masses = masses.data();
        def.count = static_cast<int32>(vertices.size());
        def.gravity.Set(0.0f, -10.0f);
        return def;
    }

    std::vector<b2Vec2> vertices;
    std::vector<float32> masses;
};

b2Rope Make(const b2RopeDef& def)
{
    b2Rope rope;
    rope.Initialize(&def);
    return rope;
}

void RunFor(b2Rope& rope, float32 seconds, int32 iterations = 10)
{
    for (long i = 0; i < std::lround(seconds / kStep); ++i)
    {
        rope.Step(kStep, iterations);
    }
}

TEST(Rope, StartsAtTheVerticesOfItsDefinition)
{
    const RopeParts parts(5);
    const b2Rope rope = Make(parts.Definition());
    ASSERT_EQ(rope.GetVertexCount(), 5);
    for (int32 i = 0; i < 5; ++i)
    {
        EXPECT_EQ(rope.GetVertices()[i], parts.vertices[i]);
    }
}

TEST(Rope, StaysInPlaceWithoutGravity)
{
    const RopeParts parts(8);
    b2RopeDef def = parts.Definition();
    def.gravity.SetZero();
    b2Rope rope = Make(def);
    RunFor(rope, 2.0f);
    for (int32 i = 0; i < 8; ++i)
    {
        EXPECT_EQ(rope.GetVertices()[i], parts.vertices[i]);
    }
}

TEST(Rope, FallsFreelyWhenNothingHoldsIt)
{
    RopeParts parts(4);
    parts.masses[0] = 1.0f;
    b2RopeDef def = parts.Definition();
    def.damping = 0.0f;
    b2Rope rope = Make(def);
    rope.Step(kStep, 3);
    rope.Step(kStep, 3);
    for (int32 i = 0; i < 4; ++i)
    {
        EXPECT_NEAR(rope.GetVertices()[i].x, parts.vertices[i].x, 1e-6f);
        EXPECT_NEAR(rope.GetVertices()[i].y, -10.0f * kStep * kStep * 3.0f, 1e-6f);
    }
}

TEST(Rope, ComesToHangStraightBelowItsHeldEnd)
{
    const RopeParts parts(9);
    b2RopeDef def = parts.Definition();
    def.damping = 2.0f;
    def.k3 = 0.0f;
    b2Rope rope = Make(def);
    RunFor(rope, 30.0f, 40);
    EXPECT_EQ(rope.GetVertices()[0], b2Vec2(0.0f, 0.0f));
    for (int32 i = 1; i < 9; ++i)
    {
        EXPECT_NEAR(rope.GetVertices()[i].x, 0.0f, 0.01f) << i;
        // The iterations leave a stretch: 0.6 % at the upper end, where the whole weight hangs.
        EXPECT_NEAR(rope.GetVertices()[i].y, -0.5f * float32(i), 0.01f * float32(i)) << i;
    }
}

TEST(Rope, KeepsItsLengthBetterWithMoreIterations)
{
    const RopeParts parts(20);
    float32 last = b2_maxFloat;
    for (const int32 iterations : {2, 8, 32})
    {
        b2Rope rope = Make(parts.Definition());
        RunFor(rope, 3.0f, iterations);
        float32 length = 0.0f;
        for (int32 i = 0; i + 1 < 20; ++i)
        {
            length += b2Distance(rope.GetVertices()[i], rope.GetVertices()[i + 1]);
        }
        const float32 error = std::fabs(length - 9.5f);
        EXPECT_LT(error, last) << iterations;
        last = error;
    }
    EXPECT_LT(last, 0.1f);
}

TEST(Rope, BendsToTheAngleThatIsSet)
{
    RopeParts parts(7);
    parts.masses[1] = 0.0f; // the first segment is held
    b2RopeDef def = parts.Definition();
    def.gravity.SetZero();
    def.damping = 4.0f;
    def.k3 = 0.5f;
    b2Rope rope = Make(def);
    rope.SetAngle(0.2f);
    RunFor(rope, 10.0f);
    for (int32 i = 0; i + 2 < 7; ++i)
    {
        const b2Vec2 d1 = rope.GetVertices()[i + 1] - rope.GetVertices()[i];
        const b2Vec2 d2 = rope.GetVertices()[i + 2] - rope.GetVertices()[i + 1];
        EXPECT_NEAR(std::atan2(b2Cross(d1, d2), b2Dot(d1, d2)), 0.2f, 0.002f) << i;
    }
}

TEST(Rope, SagsLessWhenStiffAgainstBending)
{
    RopeParts parts(7);
    parts.masses[1] = 0.0f;
    float32 depth[2];
    for (int32 i = 0; i < 2; ++i)
    {
        b2RopeDef def = parts.Definition();
        def.damping = 4.0f;
        def.k3 = i == 0 ? 0.0f : 0.9f;
        b2Rope rope = Make(def);
        RunFor(rope, 10.0f);
        depth[i] = -rope.GetVertices()[6].y;
    }
    EXPECT_GT(depth[0], 2.3f);
    EXPECT_LT(depth[1], 1.5f);
}

TEST(Rope, IsTheSameOnEveryRunAndIgnoresAStepOfZero)
{
    const RopeParts parts(12);
    b2Rope first = Make(parts.Definition());
    b2Rope second = Make(parts.Definition());
    RunFor(first, 2.0f);
    for (int32 i = 0; i < 120; ++i)
    {
        second.Step(kStep, 10);
        second.Step(0.0f, 10);
    }
    for (int32 i = 0; i < 12; ++i)
    {
        EXPECT_EQ(first.GetVertices()[i], second.GetVertices()[i]);
    }
}

TEST(Rope, CanBeInitializedAgainAndStaysFiniteWhenFolded)
{
    RopeParts parts(6);
    b2Rope rope = Make(parts.Definition());
    RunFor(rope, 1.0f);
    parts.vertices.assign(6, b2Vec2(1.0f, 1.0f)); // all on one spot
    b2RopeDef def = parts.Definition();
    rope.Initialize(&def);
    RunFor(rope, 1.0f);
    for (int32 i = 0; i < 6; ++i)
    {
        EXPECT_TRUE(rope.GetVertices()[i].IsValid());
    }
}

TEST(Rope, IsDrawnSegmentBySegment)
{
    struct Drawer : b2Draw
    {
        void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
        void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
        void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
        void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override {}
        void DrawSegment(const b2Vec2& p1, const b2Vec2&, const b2Color&) override
        {
            starts.push_back(p1);
        }
        void DrawTransform(const b2Transform&) override {}
        std::vector<b2Vec2> starts;
    };
    const RopeParts parts(4);
    const b2Rope rope = Make(parts.Definition());
    Drawer drawer;
    rope.Draw(&drawer);
    ASSERT_EQ(drawer.starts.size(), 3u);
    EXPECT_EQ(drawer.starts[2], parts.vertices[2]);
}

TEST(Rope, RefusesABadDefinition)
{
    const RopeParts parts(4);
    const float32 nan = std::nanf("");
    std::vector<b2RopeDef> bad(7, parts.Definition());
    bad[0].count = 2;
    bad[1].vertices = nullptr;
    bad[2].masses = nullptr;
    bad[3].gravity.x = nan;
    bad[4].damping = -1.0f;
    bad[5].k2 = 1.5f;
    bad[6].k3 = nan;
    for (const b2RopeDef& def : bad)
    {
#if BOXREEL_ASSERTS
        EXPECT_DEATH(Make(def), "rope's|rope needs");
#else
        b2Rope rope = Make(def);
        rope.Step(kStep, 2);
        EXPECT_EQ(rope.GetVertexCount(), 0);
#endif
    }
}

TEST(Rope, StaysFiniteInStepsOfAnyLengthAndUnderAnyWeight)
{
    for (const float32 gravity : {10.0f, 1e30f, 3e38f})
    {
        for (const float32 step : {1e-40f, 1e-12f, 1e-6f, 1.0f, 1e10f, 1e30f})
        {
            const RopeParts parts(5);
            b2RopeDef def = parts.Definition();
            def.gravity.Set(0.0f, -gravity);
            b2Rope rope = Make(def);
            for (int i = 0; i < 5; ++i)
            {
                rope.Step(step, 3);
            }
            rope.Step(kStep, 3);
            for (int32 i = 0; i < rope.GetVertexCount(); ++i)
            {
                EXPECT_TRUE(rope.GetVertices()[i].IsValid()) << gravity << " " << step;
            }
        }
    }
}

} // namespace
