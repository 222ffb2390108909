// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/ContactBlocks.h>

#include <gtest/gtest.h>

#include <cstring>
#include <random>

/// The contact solver gives the same bits however many lanes it uses, and those of the plain one.
namespace
{

using namespace box2d;
using dynamics::Scene;

/// Back to what the processor has when a test is over.
struct WidthGuard
{
    ~WidthGuard() { UseWideInstructions(true); }
};

class RandomContacts
{
public:
    explicit RandomContacts(unsigned seed) : m_random(seed)
    {
        bodies.resize(161); // 0 never moves
        for (std::size_t i = 1; i < bodies.size(); ++i)
        {
            bodies[i].v = Vector(5.0f);
            bodies[i].w = Real(-5.0f, 5.0f);
            bodies[i].angle = Real(-1.0f, 1.0f);
        }
        for (int32 i = 0; i < 80; ++i)
        {
            contacts.push_back(Contact(2 * i + 1, i % 7 == 0 ? 0 : 2 * i + 2));
        }
    }

    Array<SolverBody> bodies;
    Array<ContactConstraint> contacts; ///< of one colour

private:
    float32 Real(float32 low, float32 high)
    {
        return low + (high - low) * float32(m_random() % 10001u) / 10000.0f;
    }
    b2Vec2 Vector(float32 reach)
    {
        const float32 x = Real(-reach, reach);
        return b2Vec2(x, Real(-reach, reach));
    }

    /// How an impulse along `axis` at one point changes the speed along it at the other.
    static float32 Coupling(const ContactConstraint& c, const ContactPoint& p,
                            const ContactPoint& q, const b2Vec2& axis)
    {
        return c.invMassA + c.invMassB +
               c.invInertiaA * b2Cross(p.armA, axis) * b2Cross(q.armA, axis) +
               c.invInertiaB * b2Cross(p.armB, axis) * b2Cross(q.armB, axis);
    }

    /// One point, two that are nearly one, or a pair, with numbers of the sizes that occur.
    ContactConstraint Contact(int32 a, int32 b)
    {
        ContactConstraint c;
        std::memset(static_cast<void*>(&c), 0, sizeof c);
        c.normal = b2Rot(Real(-3.0f, 3.0f)).GetXAxis();
        c.friction = Real(0.0f, 1.0f);
        c.tangentSpeed = m_random() % 4 == 0 ? Real(-2.0f, 2.0f) : 0.0f;
        c.invMassA = Real(0.1f, 2.0f);
        c.invInertiaA = Real(0.1f, 6.0f);
        c.invMassB = b == 0 ? 0.0f : Real(0.1f, 2.0f);
        c.invInertiaB = b == 0 ? 0.0f : Real(0.1f, 6.0f);
        c.bodyA = a;
        c.bodyB = b;
        c.pointCount = 1 + int32(m_random() % 2);
        for (int32 i = 0; i < c.pointCount; ++i)
        {
            ContactPoint& p = c.points[i];
            p.armA = Vector(1.0f);
            p.armB = Vector(1.0f);
            p.normalImpulse = Real(0.0f, 1.0f);
            p.tangentImpulse = Real(-0.5f, 0.5f);
            p.bias = m_random() % 5 == 0 ? Real(0.0f, 3.0f) : 0.0f;
            p.normalMass = 1.0f / Coupling(c, p, p, c.normal);
            p.tangentMass = 1.0f / Coupling(c, p, p, b2Cross(c.normal, 1.0f));
        }
        c.k11 = Coupling(c, c.points[0], c.points[0], c.normal);
        c.k22 = Coupling(c, c.points[1], c.points[1], c.normal);
        c.k12 = Coupling(c, c.points[0], c.points[1], c.normal);
        c.coupled = c.pointCount == 2 && m_random() % 3 > 0;
        return c;
    }

    std::mt19937 m_random;
};

bool SameBits(const SolverBody& a, const SolverBody& b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void ExpectSameAsThePlainSolver(unsigned seed)
{
    RandomContacts plain(seed), packed(seed);
    SolverContext context;
    context.bodies = plain.bodies.data();
    Array<ContactBlock> blocks;
    PackBlocks(packed.contacts, 0, packed.contacts.size(), false, blocks);
    WarmStart(plain.contacts, context);
    WarmStartBlocks(blocks, packed.bodies.data());
    for (int i = 0; i < 8; ++i)
    {
        SolveContactVelocities(plain.contacts, plain.bodies.data(), DirectionOf(i));
        SolveBlocks(blocks, packed.bodies.data(), DirectionOf(i));
    }
    UnpackImpulses(blocks, packed.contacts);
    for (std::size_t i = 0; i < plain.bodies.size(); ++i)
    {
        EXPECT_TRUE(SameBits(plain.bodies[i], packed.bodies[i])) << "body " << i;
    }
    for (std::size_t i = 0; i < plain.contacts.size(); ++i)
    {
        for (int32 k = 0; k < plain.contacts[i].pointCount; ++k)
        {
            const ContactPoint& p = plain.contacts[i].points[k];
            const ContactPoint& q = packed.contacts[i].points[k];
            EXPECT_EQ(p.normalImpulse, q.normalImpulse) << "contact " << i;
            EXPECT_EQ(p.tangentImpulse, q.tangentImpulse) << "contact " << i;
        }
    }
}

/// Overlaps of one colour, of every kind; the last body turns but cannot be turned, and many share
/// it.
class RandomOverlaps
{
public:
    explicit RandomOverlaps(unsigned seed) : m_random(seed)
    {
        bodies.resize(162);
        for (std::size_t i = 1; i < bodies.size(); ++i)
        {
            bodies[i].d = Vector(0.1f);
            bodies[i].angle = Real(-0.3f, 0.3f);
            bodies[i].q = b2Rot(bodies[i].angle);
        }
        for (int32 i = 0; i < 80; ++i)
        {
            overlaps.push_back(Overlap(2 * i + 1, i % 3 == 0 ? 161 : 2 * i + 2));
        }
    }

    Array<SolverBody> bodies;
    Array<OverlapConstraint> overlaps;

private:
    float32 Real(float32 low, float32 high)
    {
        return low + (high - low) * float32(m_random() % 10001u) / 10000.0f;
    }
    b2Vec2 Vector(float32 reach)
    {
        const float32 x = Real(-reach, reach);
        return b2Vec2(x, Real(-reach, reach));
    }

    OverlapConstraint Overlap(int32 a, int32 b)
    {
        OverlapConstraint o;
        std::memset(static_cast<void*>(&o), 0, sizeof o);
        o.kind = static_cast<OverlapKind>(m_random() % 3);
        o.pointCount = o.kind == OverlapKind::Centers ? 1 : 1 + int32(m_random() % 2);
        o.offset = Vector(1.0f);
        o.normal = b2Rot(Real(-3.0f, 3.0f)).GetXAxis();
        o.reference = Vector(0.5f);
        o.points[0] = Vector(0.5f);
        // Some pairs are nearly one point.
        o.points[1] = m_random() % 4 == 0 ? o.points[0] + Vector(1e-3f) : Vector(0.5f);
        o.radius = 0.02f;
        o.invMassA = Real(0.1f, 2.0f);
        o.invInertiaA = m_random() % 5 == 0 ? 0.0f : Real(0.1f, 6.0f);
        o.invMassB = b == 161 ? 0.0f : Real(0.1f, 2.0f);
        o.invInertiaB = b == 161 ? 0.0f : Real(0.1f, 6.0f);
        o.bodyA = a;
        o.bodyB = b;
        return o;
    }

    std::mt19937 m_random;
};

TEST(SolverBlocks, PushOverlapsApartWithTheBitsOfThePlainSolverAtEveryWidth)
{
    const WidthGuard guard;
    for (const bool wide : {false, true})
    {
        UseWideInstructions(wide);
        for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
        {
            SCOPED_TRACE(seed);
            RandomOverlaps plain(seed), packed(seed);
            Array<OverlapBlock> blocks;
            PackBlocks(packed.overlaps, 0, packed.overlaps.size(), false, blocks);
            for (int i = 0; i < 4; ++i)
            {
                const float32 met =
                    SolveOverlaps(plain.overlaps, plain.bodies.data(), 0.2f, DirectionOf(i));
                EXPECT_EQ(met, SolveBlocks(blocks, packed.bodies.data(), 0.2f, DirectionOf(i)));
            }
            for (std::size_t i = 0; i < plain.bodies.size(); ++i)
            {
                EXPECT_TRUE(SameBits(plain.bodies[i], packed.bodies[i])) << "body " << i;
            }
        }
    }
}

TEST(SolverBlocks, GiveTheBitsOfThePlainSolverAtEveryWidth)
{
    const WidthGuard guard;
    for (const bool wide : {false, true})
    {
        UseWideInstructions(wide);
        for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
        {
            SCOPED_TRACE(seed);
            ExpectSameAsThePlainSolver(seed);
        }
    }
}

TEST(SolverBlocks, ThatAreLeftUnchangedByASweepAreLeftUnchangedByAllLaterOnes)
{
    const WidthGuard guard;
    for (const bool wide : {false, true})
    {
        UseWideInstructions(wide);
        int settled = 0;
        for (unsigned seed = 1; seed <= 60; ++seed)
        {
            RandomContacts random(seed);
            random.contacts.resize(1);
            Array<ContactBlock> blocks;
            PackBlocks(random.contacts, 0, random.contacts.size(), false, blocks);
            WarmStartBlocks(blocks, random.bodies.data());
            int sweeps = 0;
            while (SolveBlocks(blocks, random.bodies.data(), DirectionOf(sweeps)) && sweeps < 2000)
            {
                ++sweeps;
            }
            EXPECT_GT(sweeps, 1);
            const Array<SolverBody> before = random.bodies;
            settled += sweeps < 2000;
            for (int i = 0; i < 4 && sweeps < 2000; ++i)
            {
                EXPECT_FALSE(SolveBlocks(blocks, random.bodies.data(), DirectionOf(i)));
                EXPECT_EQ(std::memcmp(before.data(), random.bodies.data(),
                                      before.size() * sizeof before[0]),
                          0);
            }
        }
        EXPECT_GT(settled, 10) << "of 60";
    }
}

TEST(SolverBlocks, HoldEveryContactOnceAndEightOfOneKind)
{
    RandomContacts random(3);
    Array<ContactBlock> blocks;
    PackBlocks(random.contacts, 0, random.contacts.size(), false, blocks);
    std::vector<int> seen(random.contacts.size(), 0);
    int full = 0;
    for (const ContactBlock& block : blocks)
    {
        full += block.count == kBlockLanes;
        for (int lane = 0; lane < block.count; ++lane)
        {
            const ContactConstraint& c = random.contacts[std::size_t(block.constraint[lane])];
            EXPECT_EQ(c.pointCount == 1, block.kind == BlockKind::One);
            EXPECT_EQ(c.coupled, block.kind == BlockKind::Pair);
            ++seen[std::size_t(block.constraint[lane])];
        }
    }
    EXPECT_EQ(seen, std::vector<int>(random.contacts.size(), 1));
    EXPECT_GE(full, int(random.contacts.size()) / kBlockLanes - kBlockKinds);
    EXPECT_LE(blocks.size(), random.contacts.size() / kBlockLanes + kBlockKinds);
}

TEST(SolverBlocks, HoldOneContactEachWhereBodiesMayBeShared)
{
    RandomContacts random(4);
    Array<ContactBlock> blocks;
    PackBlocks(random.contacts, 0, random.contacts.size(), true, blocks);
    EXPECT_EQ(blocks.size(), random.contacts.size());
}

TEST(SolverBlocks, LetAWorldMoveTheSameAtEveryWidth)
{
    const WidthGuard guard;
    b2Vec2 ends[2];
    for (const bool wide : {false, true})
    {
        UseWideInstructions(wide);
        Scene scene;
        scene.Ground();
        for (int i = 0; i < 60; ++i)
        {
            const float32 x = 0.7f * float32(i % 6) + 0.05f * float32(i);
            i % 3 == 0 ? scene.Ball(x, 1.0f + float32(i / 6)) : scene.Box(x, 1.0f + float32(i / 6));
        }
        scene.Step(300);
        ends[wide] = b2Vec2_zero;
        for (const b2Body* body = scene.world.GetBodyList(); body; body = body->GetNext())
        {
            ends[wide] += body->GetPosition();
        }
    }
    EXPECT_EQ(ends[0], ends[1]);
}

} // namespace
