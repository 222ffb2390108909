// SPDX-License-Identifier: MIT
#include <Common/WideInstructions.h>
#include <Dynamics/Solver/Motion.h>
#include <Dynamics/Solver/OverlapSolver.h>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <random>

/// Kicks and drifts of many bodies give the bits of one body after the other.
namespace
{

using namespace box2d;

constexpr float32 kStep = 1.0f / 240.0f;

/// Back to what the processor has when a test is over.
struct WidthGuard
{
    ~WidthGuard() { UseLanes(16); }
};

/// Bodies of all speeds: at rest, slow, turning by more than a small angle, beyond each limit, and
/// broken ones.
class RandomBodies
{
public:
    RandomBodies(unsigned seed, int32 count) : m_random(seed)
    {
        for (int32 i = 0; i < count; ++i)
        {
            SolverBody body;
            const float32 fast = m_random() % 7 == 0 ? 1e6f : 5.0f;
            body.v = b2Vec2(Real(fast), Real(fast));
            body.w = m_random() % 5 == 0 ? Real(1e5f) : Real(20.0f);
            body.w = m_random() % 6 == 0 ? -0.0f : body.w;
            body.angle = Real(1.0f);
            body.d = b2Vec2(Real(0.1f), Real(0.1f));
            body.q = b2Rot(body.angle);
            if (m_random() % 6 == 0)
            {
                body.q = b2Rot(-0.0f);
            }
            body.v.x = m_random() % 50 == 0 ? std::numeric_limits<float32>::infinity() : body.v.x;
            body.v.y = m_random() % 50 == 0 ? std::numeric_limits<float32>::quiet_NaN() : body.v.y;
            bodies.push_back(body);
            BodyKick kick;
            kick.acceleration = b2Vec2(Real(10.0f), Real(1e12f));
            kick.angularAcceleration = Real(30.0f);
            kick.linearDamping = m_random() % 2 == 0 ? 0.0f : b2Abs(Real(5.0f));
            kick.angularDamping = m_random() % 2 == 0 ? 0.0f : b2Abs(Real(500.0f));
            kick.maxExtent = b2Abs(Real(3.0f));
            kicks.push_back(kick);
        }
    }

    Array<SolverBody> bodies;
    Array<BodyKick> kicks;

private:
    float32 Real(float32 reach) { return reach * (float32(m_random() % 20001u) / 10000.0f - 1.0f); }

    std::mt19937 m_random;
};

/// A step discards what is not finite, and the bits of NaN depend on the processor.
bool HaveSameBits(const SolverBody& a, const SolverBody& b)
{
    if (!IsFinite(a) && !IsFinite(b))
    {
        return true;
    }
    using Bits = std::array<std::byte, sizeof(SolverBody)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// Compares the two for bodies in rows of every length, at every width.
template <class One, class Many>
void ExpectSameBits(One&& one, Many&& many)
{
    const WidthGuard guard;
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        for (int32 count = 0; count <= 40; ++count)
        {
            RandomBodies plain(unsigned(count), count), rows(unsigned(count), count);
            for (std::size_t i = 0; i < plain.bodies.size(); ++i)
            {
                one(plain.bodies[i], plain.kicks[i]);
            }
            many(rows.bodies.data(), rows.kicks.data(), count);
            for (std::size_t i = 0; i < plain.bodies.size(); ++i)
            {
                EXPECT_TRUE(HaveSameBits(plain.bodies[i], rows.bodies[i]))
                    << i << " of " << count << ", " << lanes << " lanes";
            }
        }
    }
}

TEST(Motion, MovesManyBodiesLikeOne)
{
    for (const MaxMove& maximum : {kMaxMove, kMaxSmallMove})
    {
        ExpectSameBits(
            [&](SolverBody& body, const BodyKick&) { MoveByVelocity(body, kStep, maximum); },
            [&](SolverBody* bodies, const BodyKick*, int32 count) {
                MoveByVelocity(bodies, count, kStep, maximum);
            });
    }
}

TEST(Motion, KicksManyBodiesLikeOne)
{
    ExpectSameBits([](SolverBody& body, const BodyKick& kick) { kick.Give(body, kStep); },
                   [](SolverBody* bodies, const BodyKick* kicks, int32 count) {
                       GiveKicks(bodies, kicks, count, kStep);
                   });
}

TEST(Motion, FindsTheFarthestPush)
{
    const WidthGuard guard;
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        for (int32 count = 0; count <= 40; ++count)
        {
            const RandomBodies before(1, count);
            RandomBodies after(2, count);
            float32 farthest = 0.0f;
            for (std::size_t i = 0; i < std::size_t(count); ++i)
            {
                if (i % 9 == 8) // ignored, wherever it stands
                {
                    after.bodies[i].d.x = std::numeric_limits<float32>::quiet_NaN();
                    continue;
                }
                farthest = b2Max(
                    farthest, PushOf(before.bodies[i], after.bodies[i], before.kicks[i].maxExtent));
            }
            EXPECT_EQ(
                FarthestPush(before.bodies.data(), after.bodies.data(), before.kicks.data(), count),
                farthest)
                << count;
        }
    }
}

} // namespace
