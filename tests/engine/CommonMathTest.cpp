// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
constexpr float kRounding = 1.0e-5f;

void ExpectNear(const b2Vec2& a, const b2Vec2& b, float tolerance = kRounding)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

b2Vec3 RandomVec3(Random& random)
{
    return {random.Real(-2.0f, 2.0f), random.Real(-2.0f, 2.0f), random.Real(-2.0f, 2.0f)};
}
} // namespace

TEST(Vec2, IsZeroUntilItIsSet)
{
    EXPECT_EQ(b2Vec2(), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(b2Transform().q.c, 1.0f);
}

TEST(Vec2, ReturnsItsLengthFromNormalizeAndKeepsTinyVectors)
{
    b2Vec2 v(3.0f, 4.0f);
    EXPECT_FLOAT_EQ(v.Normalize(), 5.0f);
    ExpectNear(v, b2Vec2(0.6f, 0.8f));
    b2Vec2 tiny(1.0e-9f, 0.0f);
    EXPECT_EQ(tiny.Normalize(), 0.0f);
    EXPECT_EQ(tiny, b2Vec2(1.0e-9f, 0.0f));
}

TEST(Vec2, HasConsistentCrossProducts)
{
    const b2Vec2 a(1.0f, 2.0f);
    const b2Vec2 b(-3.0f, 5.0f);
    EXPECT_EQ(b2Cross(a, b), 11.0f);
    EXPECT_EQ(b2Dot(a.Skew(), b), b2Cross(a, b));
    EXPECT_EQ(b2Cross(2.0f, a), b2Vec2(-4.0f, 2.0f));
    EXPECT_EQ(b2Cross(a, 2.0f), b2Vec2(4.0f, -2.0f));
}

TEST(Vec2, ReturnsItsComponentsByNumber)
{
    b2Vec2 v(1.0f, 2.0f);
    v(1) = 7.0f;
    EXPECT_EQ(v(0), 1.0f);
    EXPECT_EQ(v.y, 7.0f);
}

TEST(Valid, RejectsNanAndInfinity)
{
    EXPECT_TRUE(b2IsValid(1.0f));
    EXPECT_FALSE(b2IsValid(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(b2IsValid(-std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(b2Vec2(0.0f, std::numeric_limits<float>::infinity()).IsValid());
}

TEST(Mat22, SolvesAndInverts)
{
    const b2Mat22 A(2.0f, 1.0f, -1.0f, 3.0f);
    const b2Vec2 b(4.0f, 5.0f);
    ExpectNear(b2Mul(A, A.Solve(b)), b);
    ExpectNear(b2Mul(A.GetInverse(), b2Mul(A, b)), b);
    ExpectNear(b2MulT(A, b), b2Mul(b2Mat22(2.0f, -1.0f, 1.0f, 3.0f), b));
    EXPECT_EQ(b2Mat22(1.0f, 2.0f, 2.0f, 4.0f).Solve(b), b2Vec2_zero);
}

TEST(Mat33, SolvesRandomSystems)
{
    Random random(1);
    for (int i = 0; i < 1000; ++i)
    {
        const b2Mat33 A(RandomVec3(random), RandomVec3(random), RandomVec3(random));
        if (std::fabs(b2Dot(A.ex, b2Cross(A.ey, A.ez))) < 0.5f)
        {
            continue;
        }
        const b2Vec3 b = RandomVec3(random);
        const b2Vec3 r = b2Mul(A, A.Solve33(b)) - b;
        EXPECT_LT(b2Dot(r, r), 1.0e-8f);
        const float det22 = A.ex.x * A.ey.y - A.ey.x * A.ex.y;
        if (std::fabs(det22) > 0.5f)
        {
            const b2Vec2 b2(b.x, b.y);
            ExpectNear(b2Mul22(A, A.Solve22(b2)), b2, 1.0e-4f);
            b2Mat33 inverse;
            A.GetInverse22(&inverse);
            ExpectNear(b2Mul22(inverse, b2Mul22(A, b2)), b2, 1.0e-4f);
        }
    }
}

TEST(Mat33, InvertsSymmetricMatrices)
{
    const b2Mat33 A({4.0f, 1.0f, -2.0f}, {1.0f, 3.0f, 0.5f}, {-2.0f, 0.5f, 5.0f});
    b2Mat33 inverse;
    A.GetSymInverse33(&inverse);
    const b2Vec3 v(1.0f, 2.0f, 3.0f);
    const b2Vec3 r = b2Mul(inverse, b2Mul(A, v)) - v;
    EXPECT_LT(b2Dot(r, r), 1.0e-10f);
    EXPECT_EQ(inverse.ex.y, inverse.ey.x);
    EXPECT_EQ(inverse.ex.z, inverse.ez.x);
    EXPECT_EQ(inverse.ey.z, inverse.ez.y);
}

TEST(Transform, ComposesAndInverts)
{
    Random random(2);
    for (int i = 0; i < 1000; ++i)
    {
        const b2Transform A = random.Transform(10.0f);
        const b2Transform B = random.Transform(10.0f);
        const b2Vec2 v = random.Point(5.0f);
        ExpectNear(b2Mul(b2Mul(A, B), v), b2Mul(A, b2Mul(B, v)), 1.0e-4f);
        ExpectNear(b2MulT(A, b2Mul(A, v)), v, 1.0e-4f);
        ExpectNear(b2Mul(b2MulT(A, B), v), b2MulT(A, b2Mul(B, v)), 1.0e-4f);
        ExpectNear(b2Mul(b2MulT(A.q, B.q), v), b2MulT(A.q, b2Mul(B.q, v)), 1.0e-4f);
    }
}

TEST(Sweep, MovesTheCentreOnALineAndTurnsEvenly)
{
    b2Sweep sweep;
    sweep.localCenter.Set(1.0f, 0.0f);
    sweep.c0.Set(0.0f, 0.0f);
    sweep.c.Set(4.0f, 2.0f);
    sweep.a0 = 0.0f;
    sweep.a = b2_pi;
    b2Transform xf;
    sweep.GetTransform(&xf, 0.5f);
    EXPECT_NEAR(xf.q.GetAngle(), 0.5f * b2_pi, kRounding);
    ExpectNear(b2Mul(xf, sweep.localCenter), b2Vec2(2.0f, 1.0f));
}

TEST(Sweep, MovesItsStartAlongThePathWhenAdvanced)
{
    b2Sweep sweep;
    sweep.c.Set(4.0f, 2.0f);
    sweep.a = 1.0f;
    sweep.Advance(0.25f);
    ExpectNear(sweep.c0, b2Vec2(1.0f, 0.5f));
    EXPECT_FLOAT_EQ(sweep.a0, 0.25f);
    EXPECT_FLOAT_EQ(sweep.alpha0, 0.25f);
    sweep.Advance(0.625f);
    ExpectNear(sweep.c0, b2Vec2(2.5f, 1.25f));
}

TEST(Sweep, RemovesWholeTurnsFromBothAnglesWhenNormalized)
{
    b2Sweep sweep;
    sweep.a0 = 13.0f;
    sweep.a = 13.5f;
    sweep.Normalize();
    EXPECT_NEAR(sweep.a0, 13.0f - 4.0f * b2_pi, kRounding);
    EXPECT_NEAR(sweep.a - sweep.a0, 0.5f, kRounding);
}

TEST(Numbers, AreClampedSwappedAndRoundedUpToPowersOfTwo)
{
    EXPECT_EQ(b2Clamp(5, 0, 3), 3);
    EXPECT_EQ(b2Clamp(-1.0f, 0.0f, 3.0f), 0.0f);
    int a = 1;
    int b = 2;
    b2Swap(a, b);
    EXPECT_EQ(a, 2);
    EXPECT_EQ(b2NextPowerOfTwo(0), 1u);
    EXPECT_EQ(b2NextPowerOfTwo(4), 8u);
    EXPECT_EQ(b2NextPowerOfTwo(7), 8u);
    EXPECT_TRUE(b2IsPowerOfTwo(64));
    EXPECT_FALSE(b2IsPowerOfTwo(0));
    EXPECT_FALSE(b2IsPowerOfTwo(12));
}
