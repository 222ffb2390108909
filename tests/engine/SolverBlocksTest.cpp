// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"
#include "ReferenceContacts.h"

#include <Common/WideInstructions.h>
#include <Dynamics/Solver/ContactBlockSolver.h>
#include <Dynamics/Solver/OverlapSolver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

/// The contact solver gives the same bits however many lanes it uses, and those of the plain one.
namespace
{

using namespace box2d;
using dynamics::Scene;

// Blocks filled by hand from constraints, as PrepareBlock would leave them.

void FillPoint(const ContactPoint& from, PointLanes& to, int lane)
{
    to.normalLeverA[lane] = from.normalLeverA;
    to.normalLeverB[lane] = from.normalLeverB;
    to.tangentLeverA[lane] = from.tangentLeverA;
    to.tangentLeverB[lane] = from.tangentLeverB;
    to.normalImpulse[lane] = from.normalImpulse;
    to.tangentImpulse[lane] = from.tangentImpulse;
}

template <class Constraint>
void FillMasses(const Constraint& c, MassLanes& masses, int lane)
{
    masses.invMassA[lane] = c.invMassA;
    masses.invInertiaA[lane] = c.invInertiaA;
    masses.invMassB[lane] = c.invMassB;
    masses.invInertiaB[lane] = c.invInertiaB;
}

void FillLane(const ContactConstraint& c, ContactBlock& block)
{
    const int lane = block.count++;
    block.bodyA[lane] = c.bodyA;
    block.bodyB[lane] = c.bodyB;
    block.normalX[lane] = c.normal.x;
    block.normalY[lane] = c.normal.y;
    block.friction[lane] = c.friction;
    block.tangentSpeed[lane] = c.tangentSpeed;
    block.driven = block.driven || c.tangentSpeed != 0.0f;
    FillMasses(c, block.masses, lane);
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        FillPoint(c.points[i], block.points[i], lane);
        block.pointMass[i][lane] = c.points[i].tangentMass;
        block.bias[i][lane] = c.points[i].bias;
        block.bounces = block.bounces || c.points[i].bias != 0.0f;
    }
    if (c.pointCount == 1)
    {
        block.pointMass[1][lane] = c.points[0].normalMass;
    }
    block.allCoupled = block.allCoupled && c.coupled;
    block.movesA = uint16(block.movesA | int(Moves(c.invMassA, c.invInertiaA)) << lane);
    block.movesB = uint16(block.movesB | int(Moves(c.invMassB, c.invInertiaB)) << lane);
}

ContactBlock EmptyBlock(int32 pointCount)
{
    ContactBlock block;
    std::memset(static_cast<void*>(&block), 0, sizeof block);
    block.pointCount = pointCount;
    block.allCoupled = pointCount == 2;
    for (int lane = 0; lane < kBlockLanes; ++lane)
    {
        block.masses.invMassA[lane] = block.masses.invInertiaA[lane] = 1.0f;
        block.points[1].normalLeverA[lane] = 1.0f;
    }
    return block;
}

Array<ContactBlock> Pack(const Array<ContactConstraint>& constraints)
{
    Array<ContactBlock> blocks;
    for (const int32 pointCount : {1, 2})
    {
        ContactBlock block = EmptyBlock(pointCount);
        for (const ContactConstraint& c : constraints)
        {
            if (c.pointCount != pointCount)
            {
                continue;
            }
            FillLane(c, block);
            if (block.count == kBlockLanes)
            {
                blocks.push_back(block);
                block = EmptyBlock(pointCount);
            }
        }
        if (block.count > 0)
        {
            blocks.push_back(block);
        }
    }
    return blocks;
}

/// In the order of Pack.
Array<int32> LanesInOrder(const Array<ContactConstraint>& constraints)
{
    Array<int32> order;
    for (const int32 pointCount : {1, 2})
    {
        for (std::size_t i = 0; i < constraints.size(); ++i)
        {
            if (constraints[i].pointCount == pointCount)
            {
                order.push_back(int32(i));
            }
        }
    }
    return order;
}

struct PackedOverlaps
{
    OverlapBlock block;
    MassLanes masses;
};

PackedOverlaps PackOne(const Array<OverlapConstraint>& overlaps, std::size_t first,
                       OverlapKind kind, int32 pointCount, std::size_t& next)
{
    PackedOverlaps packed;
    std::memset(static_cast<void*>(&packed), 0, sizeof packed);
    OverlapBlock& block = packed.block;
    block.kind = kind;
    block.pointCount = pointCount;
    std::fill(block.radius, block.radius + kBlockLanes, -1.0f);
    for (next = first; next < overlaps.size() && block.count < kBlockLanes; ++next)
    {
        const OverlapConstraint& o = overlaps[next];
        if (o.kind != kind || o.pointCount != pointCount)
        {
            continue;
        }
        const int lane = block.count++;
        block.bodyA[lane] = o.bodyA;
        block.bodyB[lane] = o.bodyB;
        block.offsetX[lane] = o.offset.x;
        block.offsetY[lane] = o.offset.y;
        block.normalX[lane] = o.normal.x;
        block.normalY[lane] = o.normal.y;
        block.referenceX[lane] = o.reference.x;
        block.referenceY[lane] = o.reference.y;
        for (int i = 0; i < 2; ++i)
        {
            block.pointX[i][lane] = o.points[i].x;
            block.pointY[i][lane] = o.points[i].y;
        }
        block.radius[lane] = o.radius;
        FillMasses(o, packed.masses, lane);
        block.movesA = uint16(block.movesA | int(Moves(o.invMassA, o.invInertiaA)) << lane);
        block.movesB = uint16(block.movesB | int(Moves(o.invMassB, o.invInertiaB)) << lane);
    }
    return packed;
}

Array<PackedOverlaps> Pack(const Array<OverlapConstraint>& overlaps)
{
    Array<PackedOverlaps> blocks;
    for (const OverlapKind kind : {OverlapKind::Centers, OverlapKind::FaceA, OverlapKind::FaceB})
    {
        for (const int32 pointCount : {1, 2})
        {
            std::size_t next = 0;
            while (next < overlaps.size())
            {
                const PackedOverlaps block = PackOne(overlaps, next, kind, pointCount, next);
                if (block.block.count > 0)
                {
                    blocks.push_back(block);
                }
            }
        }
    }
    return blocks;
}

template <class Block, class Function>
void ForEachBlock(Array<Block>& blocks, int iteration, Function&& function)
{
    ForEach(blocks, DirectionOf(iteration), function);
}

bool Sweep(Array<ContactBlock>& blocks, SolverBody* bodies, int iteration)
{
    bool changed = false;
    ForEachBlock(blocks, iteration,
                 [&](ContactBlock& block) { changed = SolveBlock(block, bodies) || changed; });
    return changed;
}

/// Back to what the processor has when a test is over.
struct WidthGuard
{
    ~WidthGuard() { UseLanes(16); }
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

    /// Returns the change of speed at one lever per impulse at the other.
    static float32 Coupling(const ContactConstraint& c, float32 pA, float32 pB, float32 qA,
                            float32 qB)
    {
        return c.invMassA + c.invMassB + c.invInertiaA * pA * qA + c.invInertiaB * pB * qB;
    }
    static float32 NormalCoupling(const ContactConstraint& c, const ContactPoint& p,
                                  const ContactPoint& q)
    {
        return Coupling(c, p.normalLeverA, p.normalLeverB, q.normalLeverA, q.normalLeverB);
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
        b2Vec2 arms[2];
        for (int32 i = 0; i < c.pointCount; ++i)
        {
            ContactPoint& p = c.points[i];
            const b2Vec2 tangent = b2Cross(c.normal, 1.0f);
            const bool isNear = i == 1 && m_random() % 3 == 0;
            const b2Vec2 armA = isNear ? arms[0] + Vector(1e-3f) : Vector(1.0f);
            const b2Vec2 armB = isNear ? arms[1] + Vector(1e-3f) : Vector(1.0f);
            arms[0] = armA;
            arms[1] = armB;
            p.normalLeverA = b2Cross(armA, c.normal);
            p.normalLeverB = b2Cross(armB, c.normal);
            p.tangentLeverA = b2Cross(armA, tangent);
            p.tangentLeverB = b2Cross(armB, tangent);
            p.normalImpulse = Real(0.0f, 1.0f);
            p.tangentImpulse = Real(-0.5f, 0.5f);
            p.bias = m_random() % 5 == 0 ? Real(0.0f, 3.0f) : 0.0f;
            p.normalMass = 1.0f / NormalCoupling(c, p, p);
            p.tangentMass = 1.0f / Coupling(c, p.tangentLeverA, p.tangentLeverB, p.tangentLeverA,
                                            p.tangentLeverB);
        }
        c.k11 = NormalCoupling(c, c.points[0], c.points[0]);
        c.k22 = NormalCoupling(c, c.points[1], c.points[1]);
        c.k12 = NormalCoupling(c, c.points[0], c.points[1]);
        c.coupled =
            c.pointCount == 2 && c.k11 * c.k11 < kMaxCondition * (c.k11 * c.k22 - c.k12 * c.k12);
        return c;
    }

    std::mt19937 m_random;
};

bool SameBits(const SolverBody& a, const SolverBody& b)
{
    using Bits = std::array<std::byte, sizeof(SolverBody)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

void ExpectSameAsThePlainSolver(unsigned seed)
{
    RandomContacts plain(seed), packed(seed);
    SolverContext context;
    context.bodies = plain.bodies.data();
    Array<ContactBlock> blocks = Pack(packed.contacts);
    WarmStart(plain.contacts, context);
    for (ContactBlock& block : blocks)
    {
        WarmStartBlock(block, packed.bodies.data());
    }
    for (int i = 0; i < 8; ++i)
    {
        SolveContactVelocities(plain.contacts, plain.bodies.data(), DirectionOf(i));
        Sweep(blocks, packed.bodies.data(), i);
    }
    for (std::size_t i = 0; i < plain.bodies.size(); ++i)
    {
        EXPECT_TRUE(SameBits(plain.bodies[i], packed.bodies[i])) << "body " << i;
    }
    const Array<int32> order = LanesInOrder(plain.contacts);
    std::size_t next = 0;
    for (const ContactBlock& block : blocks)
    {
        for (int lane = 0; lane < block.count; ++lane)
        {
            const ContactConstraint& c = plain.contacts[std::size_t(order[next++])];
            for (int32 k = 0; k < c.pointCount; ++k)
            {
                const PointLanes& q = block.points[k];
                EXPECT_EQ(c.points[k].normalImpulse, q.normalImpulse[lane]) << "contact " << next;
                EXPECT_EQ(c.points[k].tangentImpulse, q.tangentImpulse[lane]) << "contact " << next;
            }
        }
    }
    EXPECT_EQ(next, plain.contacts.size());
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

TEST(SolverBlocks, SolveOverlapsBitEqualToPlainSolver)
{
    const WidthGuard guard;
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
        {
            SCOPED_TRACE(seed);
            // Every other is held back by how far a push may go.
            const PushPace pace = {0.2f, seed % 2 == 0 ? 1e-3f : b2_maxLinearCorrection};
            RandomOverlaps plain(seed), packed(seed);
            Array<PackedOverlaps> blocks = Pack(packed.overlaps);
            for (int i = 0; i < 4; ++i)
            {
                const float32 met =
                    SolveOverlaps(plain.overlaps, plain.bodies.data(), pace, DirectionOf(i));
                float32 smallest = 0.0f;
                ForEachBlock(blocks, i, [&](const PackedOverlaps& some) {
                    smallest = b2Min(
                        smallest, SolveBlock(some.block, some.masses, packed.bodies.data(), pace));
                });
                EXPECT_EQ(met, smallest);
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
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
        {
            SCOPED_TRACE(seed);
            ExpectSameAsThePlainSolver(seed);
        }
    }
}

TEST(SolverBlocks, StayUnchangedOnceConverged)
{
    const WidthGuard guard;
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        int settled = 0;
        for (unsigned seed = 1; seed <= 60; ++seed)
        {
            RandomContacts random(seed);
            random.contacts.resize(1);
            Array<ContactBlock> blocks = Pack(random.contacts);
            WarmStartBlock(blocks[0], random.bodies.data());
            int sweeps = 0;
            while (Sweep(blocks, random.bodies.data(), sweeps) && sweeps < 2000)
            {
                ++sweeps;
            }
            EXPECT_GT(sweeps, 1);
            const Array<SolverBody> before = random.bodies;
            settled += sweeps < 2000;
            for (int i = 0; i < 4 && sweeps < 2000; ++i)
            {
                EXPECT_FALSE(Sweep(blocks, random.bodies.data(), i));
                EXPECT_EQ(std::memcmp(before.data(), random.bodies.data(),
                                      before.size() * sizeof before[0]),
                          0);
            }
        }
        EXPECT_GT(settled, 10) << "of 60";
    }
}

/// A pile of boxes, balls and small polygons on a slope and a turning bar, stopped in mid-fall.
class Pile
{
public:
    explicit Pile(unsigned seed)
    {
        std::mt19937 random(seed);
        scene.Ground();
        b2BodyDef def;
        def.type = b2_kinematicBody;
        def.position.Set(2.0f, 1.0f);
        def.angularVelocity = 1.0f;
        b2PolygonShape bar;
        bar.SetAsBox(3.0f, 0.2f, b2Vec2(0.5f, 0.0f), 0.3f);
        scene.world.CreateBody(&def)->CreateFixture(&bar, 0.0f);
        for (int i = 0; i < 80; ++i)
        {
            const float32 x = 0.6f * float32(i % 8) + 0.01f * float32(random() % 20u);
            const float32 y = 2.0f + 0.7f * float32(i / 8);
            b2Body* body = i % 3 == 0 ? scene.Ball(x, y) : scene.Box(x, y);
            body->SetAngularVelocity(float32(random() % 5u) - 2.0f);
            for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
            {
                f->SetRestitution(0.1f * float32(random() % 8u));
            }
        }
        scene.Step(60 + int(seed) * 7);
    }

    Scene scene;
};

/// Compares every contact with the plain solver, lane by lane.
void ExpectLanesAsPrepared(const ContactBlock& block, const OverlapBlock& overlap,
                           const SolverContext& context)
{
    bool allCoupled = block.pointCount == 2;
    for (int lane = 0; lane < block.count; ++lane)
    {
        ContactConstraint c;
        OverlapConstraint o;
        PrepareContact(*block.contact[lane], context, c, o);
        ASSERT_EQ(block.pointCount, c.pointCount);
        ASSERT_EQ(overlap.kind, o.kind);
        EXPECT_EQ(b2Vec2(block.normalX[lane], block.normalY[lane]), c.normal);
        EXPECT_EQ(overlap.radius[lane], o.radius);
        EXPECT_EQ(b2Vec2(overlap.offsetX[lane], overlap.offsetY[lane]), o.offset);
        EXPECT_EQ(b2Vec2(overlap.referenceX[lane], overlap.referenceY[lane]), o.reference);
        EXPECT_EQ(block.masses.invMassA[lane], c.invMassA);
        EXPECT_EQ(block.masses.invInertiaB[lane], c.invInertiaB);
        EXPECT_EQ(block.bodyA[lane], c.bodyA);
        EXPECT_EQ(overlap.bodyB[lane], o.bodyB);
        for (int i = 0; i < c.pointCount; ++i)
        {
            const PointLanes& p = block.points[i];
            EXPECT_EQ(p.normalLeverA[lane], c.points[i].normalLeverA);
            EXPECT_EQ(p.normalLeverB[lane], c.points[i].normalLeverB);
            EXPECT_EQ(p.tangentLeverA[lane], c.points[i].tangentLeverA);
            EXPECT_EQ(p.tangentLeverB[lane], c.points[i].tangentLeverB);
            EXPECT_EQ(NormalMassOf(block, lane, i), c.points[i].normalMass);
            EXPECT_EQ(block.pointMass[i][lane], c.points[i].tangentMass);
            EXPECT_EQ(p.normalImpulse[lane], c.points[i].normalImpulse);
            EXPECT_EQ(p.tangentImpulse[lane], c.points[i].tangentImpulse);
            EXPECT_EQ(block.bias[i][lane], c.points[i].bias);
            EXPECT_TRUE(block.bounces || c.points[i].bias == 0.0f);
            EXPECT_EQ(b2Vec2(overlap.pointX[i][lane], overlap.pointY[i][lane]), o.points[i]);
        }
        if (c.pointCount == 2)
        {
            const auto response = PairResponse<simd::Float1>::Of(block, lane);
            EXPECT_EQ(response.k11.v, c.k11);
            EXPECT_EQ(response.k12.v, c.k12);
            EXPECT_EQ(response.k22.v, c.k22);
            allCoupled = allCoupled && c.coupled;
        }
        else
        {
            EXPECT_EQ(block.pointMass[1][lane], c.points[0].normalMass);
        }
    }
    EXPECT_EQ(block.allCoupled, allCoupled);
}

Array<b2Contact*> TouchingContacts(b2World& world)
{
    Array<b2Contact*> contacts;
    for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext())
    {
        if (contact->IsTouching())
        {
            contacts.push_back(contact);
        }
    }
    return contacts;
}

ContactBlocks BlocksOf(const Array<b2Contact*>& contacts, bool sharesBodies)
{
    ContactBlocks blocks;
    IslandGroups groups;
    groups.Join(200);
    blocks.Reserve(contacts.size(), sharesBodies, groups.Count());
    blocks.Sort(contacts, sharesBodies, groups, 200);
    blocks.Assign(sharesBodies);
    return blocks;
}

TEST(SolverBlocks, ArePreparedBitEqualToPlainSolver)
{
    const WidthGuard guard;
    int kinds[3] = {0, 0, 0};
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        for (unsigned seed = 1; seed <= 6; ++seed)
        {
            Pile pile(seed);
            Array<SolverBody> bodies(200);
            for (const b2Body* b = pile.scene.world.GetBodyList(); b; b = b->GetNext())
            {
                SolverBody& s = bodies[std::size_t(Data(*b).SolverIndex())];
                s.v = b->GetLinearVelocity();
                s.w = b->GetAngularVelocity();
            }
            SolverContext context;
            context.bodies = bodies.data();
            context.stepRatio = 0.75f;
            ContactBlocks blocks = BlocksOf(TouchingContacts(pile.scene.world), false);
            for (int32 i = 0; i < blocks.Count(); ++i)
            {
                PrepareBlock(blocks.Contacts(i), blocks.Overlaps(i), nullptr, context);
                ExpectLanesAsPrepared(blocks.Contacts(i), blocks.Overlaps(i), context);
                ++kinds[int(blocks.Overlaps(i).kind)];
            }
        }
    }
    EXPECT_GT(kinds[0], 0);
    EXPECT_GT(kinds[1], 0);
    EXPECT_GT(kinds[2], 0);
}

TEST(SolverBlocks, HoldEveryContactOnceAndFillUpByKind)
{
    Pile pile(3);
    const Array<b2Contact*> contacts = TouchingContacts(pile.scene.world);
    ContactBlocks blocks = BlocksOf(contacts, false);
    std::vector<const b2Contact*> seen;
    std::size_t full = 0;
    for (int32 i = 0; i < blocks.Count(); ++i)
    {
        const ContactBlock& block = blocks.Contacts(i);
        full += block.count == kBlockLanes;
        for (int lane = 0; lane < block.count; ++lane)
        {
            const b2Manifold& manifold = *block.contact[lane]->GetManifold();
            EXPECT_EQ(block.pointCount, manifold.pointCount);
            EXPECT_EQ(blocks.Overlaps(i).kind == OverlapKind::Centers,
                      manifold.type == b2Manifold::e_circles);
            seen.push_back(block.contact[lane]);
        }
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
    EXPECT_EQ(seen.size(), contacts.size());
    // Three kinds of measurement, one or two points; circles have one.
    EXPECT_LE(std::size_t(blocks.Count()) - full, 5u);
}

TEST(SolverBlocks, HoldOneContactEachWhereBodiesMayBeShared)
{
    Pile pile(4);
    const Array<b2Contact*> contacts = TouchingContacts(pile.scene.world);
    ContactBlocks blocks = BlocksOf(contacts, true);
    EXPECT_EQ(std::size_t(blocks.Count()), contacts.size());
}

TEST(SolverBlocks, LetAWorldMoveTheSameAtEveryWidth)
{
    const WidthGuard guard;
    std::vector<b2Vec2> ends;
    for (const int lanes : {4, 8, 16})
    {
        UseLanes(lanes);
        Scene scene;
        scene.Ground();
        for (int i = 0; i < 60; ++i)
        {
            const float32 x = 0.7f * float32(i % 6) + 0.05f * float32(i);
            i % 3 == 0 ? scene.Ball(x, 1.0f + float32(i / 6)) : scene.Box(x, 1.0f + float32(i / 6));
        }
        scene.Step(300);
        b2Vec2& end = ends.emplace_back(b2Vec2_zero);
        for (const b2Body* body = scene.world.GetBodyList(); body; body = body->GetNext())
        {
            end += body->GetPosition();
        }
    }
    EXPECT_EQ(ends[0], ends[1]);
    EXPECT_EQ(ends[0], ends[2]);
}

} // namespace
