// SPDX-License-Identifier: MIT
#include "ContactBlocks.h"
#include "OverlapSolver.h"

#include "../../Common/WideInstructions.h"
#include "../Contacts/ReadAhead.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "BlockKernels.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

namespace box2d
{

#if defined(BOX2D_AVX2)
const BlockKernels& BlockKernelsAvx2(); // ContactBlocksAvx2.cpp
#endif
#if defined(BOX2D_AVX512)
const BlockKernels& BlockKernelsAvx512(); // ContactBlocksAvx512.cpp
#endif

namespace
{

/// A single contact is cheaper in one lane; two are slower one after the other than side by side.
/// The other lanes are then never read.
template <class Block>
bool IsAlone(const Block& block)
{
    return block.count == 1;
}

template <class Block>
const BlockKernels& KernelsOf(const Block& block)
{
    if (IsAlone(block))
    {
        return kBlockKernels<simd::Float1>;
    }
#if defined(BOX2D_AVX512)
    if (LanesInUse() == 16 && block.count > kPartLanes)
    {
        return BlockKernelsAvx512();
    }
#endif
#if defined(BOX2D_AVX2)
    if (LanesInUse() >= 8)
    {
        return BlockKernelsAvx2();
    }
#endif
    return kBlockKernels<simd::Float4>;
}

float32* Numbers(SolverBody* bodies)
{
    return reinterpret_cast<float32*>(bodies);
}

OverlapKind KindOf(const b2Manifold& manifold)
{
    return manifold.type == b2Manifold::e_circles ? OverlapKind::Centers
           : manifold.type == b2Manifold::e_faceB ? OverlapKind::FaceB
                                                  : OverlapKind::FaceA;
}

} // namespace

void ContactBlocks::Reserve(std::size_t contactCount, bool sharesBodies, int32 groups)
{
    // For each form the last block of a group may be partly empty.
    // Centers measures one point, FaceA and FaceB one or two.
    constexpr std::size_t forms = 1 + 2 * b2_maxManifoldPoints;
    const std::size_t maximum =
        sharesBodies
            ? contactCount
            : b2Min(contactCount, contactCount / kBlockLanes + forms * std::size_t(groups));
    if (maximum > m_contacts.size())
    {
        // Reserve, because a growing colour grows step by step.
        const std::size_t reserve = b2Max<std::size_t>(maximum / 8, 2);
        m_contacts.resize(maximum + reserve);
        m_overlaps.resize(maximum + reserve);
        m_parts.reserve((maximum + reserve) * (kBlockLanes / kPartLanes));
        const std::size_t room = contactCount + (reserve + 1) * kBlockLanes;
        m_sorted.reserve(room);
        m_buckets.reserve(room);
    }
    m_groupEnds.reserve(std::size_t(groups));
    m_blockEnds.reserve(std::size_t(groups));
    m_sorted.resize(contactCount);
    m_buckets.resize(contactCount);
}

void ContactBlocks::ClearTotals()
{
    if (m_totals.size() < std::size_t(m_count))
    {
        m_totals.resize(m_contacts.size());
    }
    std::fill_n(m_totals.begin(), m_count, BlockTotals());
}

int32 ContactBlocks::Add(OverlapKind kind, int32 pointCount)
{
    ContactBlock& block = m_contacts[std::size_t(m_count)];
    OverlapBlock& overlap = m_overlaps[std::size_t(m_count)];
    block.count = 0;
    block.pointCount = pointCount;
    overlap.pointCount = pointCount;
    overlap.kind = kind;
    return m_count++;
}

/// By group, and by the larger index of its bodies, approximated by buckets (counting sort). The
/// bodies of a group follow each other, so the key of both is their sum.
void ContactBlocks::Sort(const Array<b2Contact*>& contacts, bool sharesBodies,
                         const IslandGroups& groups, std::size_t bodyCount)
{
    m_groupEnds.assign(std::size_t(groups.Count()), int32(contacts.size()));
    const bool few = contacts.size() <= kPartLanes; // order is irrelevant
    if (groups.Count() == 1 && (sharesBodies || few))
    {
        std::copy(contacts.begin(), contacts.end(), m_sorted.begin());
        return;
    }
    // Contacts of a colour share no dynamic body. Yet with 1 bucket the bits differ. More buckets
    // order bodies more finely. The sum with the groups must fit into the byte of a bucket number.
    // No note compares other values.
    constexpr std::size_t maximum = 64;
    static_assert(maximum + IslandGroups::kMaxCount <= 256);
    const std::size_t buckets = sharesBodies ? 1 : b2Min(maximum, contacts.size() / kPartLanes + 1);
    std::size_t ends[maximum + IslandGroups::kMaxCount] = {};
    std::size_t groupCounts[IslandGroups::kMaxCount] = {};
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        const ContactData& c = Data(*contacts[i]);
        const int32 place = b2Max(Data(*c.bodyA).awakeIndex, Data(*c.bodyB).awakeIndex);
        const auto group = std::size_t(groups.Of(place));
        m_buckets[i] = uint8(std::size_t(place) * buckets / bodyCount + group);
        ++ends[m_buckets[i]];
        ++groupCounts[group];
    }
    std::size_t end = 0;
    for (std::size_t& next : ends)
    {
        const std::size_t begin = end;
        end += next;
        next = begin;
    }
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        m_sorted[ends[m_buckets[i]]++] = contacts[i];
    }
    std::size_t groupEnd = 0;
    for (std::size_t i = 0; i < m_groupEnds.size(); ++i)
    {
        groupEnd += groupCounts[i];
        m_groupEnds[i] = int32(groupEnd);
    }
}

void ContactBlocks::Assign(bool sharesBodies)
{
    m_count = 0;
    m_parts.clear();
    m_blockEnds.clear();
    std::size_t next = 0;
    for (const int32 end : m_groupEnds)
    {
        int32 open[] = {-1, -1, -1, -1,
                        -1, -1, -1}; // by form: three kinds of measurement, one or two points
        for (; next < std::size_t(end); ++next)
        {
            ContactData& c = Data(*m_sorted[next]);
            c.solvedAs = c.Form();
            if (c.solvedAs == 0)
            {
                continue;
            }
            int32& last = open[c.solvedAs];
            if (last == -1 || sharesBodies || Contacts(last).count == kBlockLanes)
            {
                last = Add(KindOf(c.manifold), c.manifold.pointCount);
            }
            ContactBlock& block = Contacts(last);
            if (block.count % kPartLanes == 0)
            {
                m_parts.push_back({last, block.count});
            }
            block.contact[block.count++] = m_sorted[next];
        }
        m_blockEnds.push_back(m_count);
    }
}

BlockRange ContactBlocks::Of(const IslandGroup& group) const
{
    const auto number = std::size_t(group.number);
    return group.number == -1
               ? BlockRange{0, m_count}
               : BlockRange{number > 0 ? m_blockEnds[number - 1] : 0, m_blockEnds[number]};
}

namespace
{

/// Prefetches what is read first of a lane's contact.
void ReadLaneAhead(const ContactBlock& block, int32 lane)
{
    const ContactData& c = Data(*block.contact[lane]);
    Prefetch(&c.bodyA);
    Prefetch(&c.manifold.localPoint);
}

/// Collects the input of a block. Bodies and contacts are read only here.
class Gatherer
{
public:
    Gatherer(ContactBlock& block, OverlapBlock& overlap, ContactLanes& lanes,
             const SolverContext& context)
        : m_block(block), m_overlap(overlap), m_to(lanes), m_context(context)
    {}

    /// Prefetches the contacts of the block to come, if there is one.
    void Gather(const ContactBlock* next)
    {
        m_overlap.count = m_block.count;
        m_block.movesA = m_block.movesB = 0;
        m_block.driven = m_block.fresh = false;
        for (int32 lane = 0; lane < b2Min(m_block.count, kAhead); ++lane)
        {
            ReadBodiesAhead(lane);
        }
        for (int32 lane = 0; lane < m_block.count; ++lane)
        {
            if (lane + kAhead < m_block.count)
            {
                ReadBodiesAhead(lane + kAhead);
            }
            if (next != nullptr && lane < next->count)
            {
                ReadLaneAhead(*next, lane);
            }
            GatherLane(lane, Data(*m_block.contact[lane]));
        }
        // No more than eight lanes are solved if no more than eight are used.
        const int32 end = m_block.count <= kPartLanes ? kPartLanes : kBlockLanes;
        for (int32 lane = m_block.count; lane < end && !IsAlone(m_block); ++lane)
        {
            PadLane(lane);
        }
        m_overlap.movesA = m_block.movesA;
        m_overlap.movesB = m_block.movesB;
    }

private:
    /// Lanes between prefetching bodies and reading them: half a block. It affects the time only.
    /// Prefetching further ahead, in the next blocks, was not faster (docs/notes/solver-lanes.md).
    static constexpr int32 kAhead = 8;

    void ReadBodiesAhead(int32 lane) const
    {
        const ContactData& c = Data(*m_block.contact[lane]);
        Prefetch(&Data(*c.bodyA).pose);
        Prefetch(&Data(*c.bodyB).pose);
    }

    void GatherLane(int lane, const ContactData& c)
    {
        const BodyData& a = Data(*c.bodyA);
        const BodyData& b = Data(*c.bodyB);
        const b2Vec2 offset = CenterOffset(a, b);
        m_overlap.offsetX[lane] = offset.x;
        m_overlap.offsetY[lane] = offset.y;
        m_block.friction[lane] = c.friction;
        const bool driven = (c.flags & kContactDriven) != 0;
        m_block.tangentSpeed[lane] = driven ? c.tangentSpeed : 0.0f;
        m_block.driven = m_block.driven || driven;
        m_block.fresh = m_block.fresh || c.lastShare < 0.0f;
        m_to.share[lane] = m_context.warmStartsLastShare ? b2Max(c.lastShare, 0.0f) : 1.0f;
        m_to.restitution[lane] = c.restitution;
        GatherBodies(lane, a, b);
        const bool faceOnB = m_overlap.kind == OverlapKind::FaceB;
        GatherGeometry(lane, c.manifold, faceOnB ? b : a, faceOnB ? a : b);
        m_to.radiusFace[lane] = faceOnB ? c.radiusB : c.radiusA;
        m_to.radiusOther[lane] = faceOnB ? c.radiusA : c.radiusB;
    }

    void GatherBodies(int lane, const BodyData& a, const BodyData& b)
    {
        m_block.bodyA[lane] = m_overlap.bodyA[lane] = a.SolverIndex();
        m_block.bodyB[lane] = m_overlap.bodyB[lane] = b.SolverIndex();
        const float32 massA = a.SolverInvMass();
        const float32 inertiaA = a.SolverInvInertia();
        const float32 massB = b.SolverInvMass();
        const float32 inertiaB = b.SolverInvInertia();
        m_block.masses.invMassA[lane] = massA;
        m_block.masses.invInertiaA[lane] = inertiaA;
        m_block.masses.invMassB[lane] = massB;
        m_block.masses.invInertiaB[lane] = inertiaB;
        m_block.movesA = uint16(m_block.movesA | int(Moves(massA, inertiaA)) << lane);
        m_block.movesB = uint16(m_block.movesB | int(Moves(massB, inertiaB)) << lane);
    }

    void GatherGeometry(int lane, const b2Manifold& m, const BodyData& face, const BodyData& other)
    {
        m_to.sineFace[lane] = face.rotation.s;
        m_to.cosineFace[lane] = face.rotation.c;
        m_to.sineOther[lane] = other.rotation.s;
        m_to.cosineOther[lane] = other.rotation.c;
        m_to.normalX[lane] = m.localNormal.x;
        m_to.normalY[lane] = m.localNormal.y;
        m_to.referenceX[lane] = m.localPoint.x - face.localCenter.x;
        m_to.referenceY[lane] = m.localPoint.y - face.localCenter.y;
        for (int i = 0; i < m_block.pointCount; ++i)
        {
            const b2ManifoldPoint& p = m.points[i];
            m_to.pointX[i][lane] = p.localPoint.x - other.localCenter.x;
            m_to.pointY[i][lane] = p.localPoint.y - other.localCenter.y;
            m_to.normalImpulse[i][lane] = p.normalImpulse;
            m_to.tangentImpulse[i][lane] = p.tangentImpulse;
        }
    }

    /// Two points of body 0, at rest and far from the other surface. Their distance and masses are
    /// such that they can be solved together.
    void PadLane(int lane)
    {
        m_block.friction[lane] = m_block.tangentSpeed[lane] = 0.0f;
        m_overlap.offsetX[lane] = m_overlap.offsetY[lane] = 0.0f;
        m_block.bodyA[lane] = m_overlap.bodyA[lane] = 0;
        m_block.bodyB[lane] = m_overlap.bodyB[lane] = 0;
        m_block.masses.invMassA[lane] = m_block.masses.invInertiaA[lane] = 1.0f;
        m_block.masses.invMassB[lane] = m_block.masses.invInertiaB[lane] = 0.0f;
        m_to.sineFace[lane] = m_to.sineOther[lane] = 0.0f;
        m_to.cosineFace[lane] = m_to.cosineOther[lane] = 1.0f;
        m_to.normalX[lane] = 0.0f;
        m_to.normalY[lane] = 1.0f;
        m_to.referenceX[lane] = m_to.referenceY[lane] = 0.0f;
        m_to.radiusFace[lane] = m_to.radiusOther[lane] = -1.0f;
        m_to.restitution[lane] = m_to.share[lane] = 0.0f;
        for (int i = 0; i < 2; ++i)
        {
            m_to.pointX[i][lane] = float32(i);
            m_to.pointY[i][lane] = 0.0f;
            m_to.normalImpulse[i][lane] = m_to.tangentImpulse[i][lane] = 0.0f;
        }
    }

    ContactBlock& m_block;
    OverlapBlock& m_overlap;
    ContactLanes& m_to;
    const SolverContext& m_context;
};

} // namespace

void ReadAhead(const ContactBlock& block)
{
    for (int32 lane = 0; lane < block.count; ++lane)
    {
        ReadLaneAhead(block, lane);
    }
}

void PrepareBlock(ContactBlock& block, OverlapBlock& overlap, const ContactBlock* next,
                  const SolverContext& context)
{
    ContactLanes lanes;
    Gatherer(block, overlap, lanes, context).Gather(next);
    KernelsOf(block).prepare(lanes, block, overlap, context);
}

void PrepareAlone(b2Contact& contact, ContactBlock& block, OverlapBlock& overlap,
                  const SolverContext& context)
{
    const b2Manifold& manifold = Data(contact).manifold;
    block.contact[0] = &contact;
    block.count = 1;
    block.pointCount = overlap.pointCount = manifold.pointCount;
    overlap.kind = KindOf(manifold);
    PrepareBlock(block, overlap, nullptr, context);
}

void WarmStartBlock(ContactBlock& block, SolverBody* bodies)
{
    KernelsOf(block).warmStart(block, Numbers(bodies));
}

void KickBlock(ContactBlock& block, BlockTotals& totals, SolverBody* bodies, float32 share,
               bool addsLast)
{
    KernelsOf(block).kick(block, totals, Numbers(bodies), share, addsLast);
}

void AddToTotals(const ContactBlock& block, BlockTotals& totals)
{
    KernelsOf(block).addToTotals(block, totals);
}

void LimitFriction(ContactBlock& block, SolverBody* bodies)
{
    KernelsOf(block).limitFriction(block, Numbers(bodies));
}

void FindErrors(const ContactBlock& block, const SolverBody* bodies, const ErrorBounds& bounds,
                float32 (&off)[kBlockLanes])
{
    KernelsOf(block).findErrors(block, reinterpret_cast<const float32*>(bodies), bounds, off);
}

bool SolveBlock(ContactBlock& block, SolverBody* bodies, float32 unchanged)
{
    return KernelsOf(block).solve(block, Numbers(bodies), unchanged);
}

float32 SolveBlock(const OverlapBlock& block, const MassLanes& masses, SolverBody* bodies,
                   PushPace pace)
{
    return KernelsOf(block).solveOverlaps(block, masses, Numbers(bodies), pace);
}

void StoreImpulses(const ContactBlock& block)
{
    for (int lane = 0; lane < block.count; ++lane)
    {
        b2Manifold& manifold = Data(*block.contact[lane]).manifold;
        for (int32 i = 0; i < block.pointCount; ++i)
        {
            manifold.points[i].normalImpulse = block.points[i].normalImpulse[lane];
            manifold.points[i].tangentImpulse = block.points[i].tangentImpulse[lane];
        }
    }
}

b2ContactImpulse ImpulseOf(const ContactBlock& block, int lane)
{
    b2ContactImpulse impulse;
    impulse.count = block.pointCount;
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        impulse.normalImpulses[i] = block.points[i].normalImpulse[lane];
        impulse.tangentImpulses[i] = block.points[i].tangentImpulse[lane];
    }
    return impulse;
}

} // namespace box2d
