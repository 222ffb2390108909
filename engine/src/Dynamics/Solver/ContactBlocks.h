// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"
#include "IslandGroups.h"
#include "OverlapSolver.h"

struct b2ContactImpulse;

/// Contacts of one colour in blocks of sixteen lanes, for SIMD. A block is prepared and solved with
/// 16, 8, 4 lanes or one at a time, with the same bits. The same solver without lanes is in
/// tests/engine/ReferenceContacts.cpp. The method is that of sequential impulses (Catto, "Iterative
/// Dynamics with Temporal Coherence", GDC 2005): accumulated, clamped impulses on velocities, then
/// nonlinear projection of positions.
namespace box2d
{

struct SnapshotAccess;

/// Lanes of a block: the floats of an AVX-512 register, the widest one in use. AVX2 solves a block
/// in two parts. Times of blocks of 8 and 16 are compared in docs/notes/solver-lanes.md.
inline constexpr int kBlockLanes = 16;
/// Lanes of a part of a block: the floats of an AVX2 register. Direct solutions sum up the rows of
/// contacts part by part, so another number would change their bits.
inline constexpr int kPartLanes = 8;

struct MassLanes
{
    float32 invMassA[kBlockLanes], invInertiaA[kBlockLanes];
    float32 invMassB[kBlockLanes], invInertiaB[kBlockLanes];
};

/// The levers are the moments about the centres of mass of a unit impulse at the point [m]: arm x
/// direction. The tangent is the normal rotated clockwise.
struct PointLanes
{
    float32 normalLeverA[kBlockLanes], normalLeverB[kBlockLanes];
    float32 tangentLeverA[kBlockLanes], tangentLeverB[kBlockLanes];
    float32 normalImpulse[kBlockLanes], tangentImpulse[kBlockLanes];
};

/// The velocity constraints of touching contacts. All lanes have the same number of points. Passes
/// over many blocks wait for memory, so the members of one block are few. What follows from others
/// is computed again, and what few contacts have comes last. Unused lanes contain two points
/// without impulses on body 0, and are never stored; those of a single contact contain anything.
struct alignas(kCacheLine) ContactBlock
{
    int32 bodyA[kBlockLanes], bodyB[kBlockLanes];
    float32 normalX[kBlockLanes], normalY[kBlockLanes];
    MassLanes masses;
    PointLanes points[2];
    /// Effective masses of both tangents; those of the tangent and the normal of a single point.
    float32 pointMass[2][kBlockLanes];
    float32 friction[kBlockLanes];
    int32 count; ///< used lanes
    int32 pointCount;
    bool allCoupled;       ///< all lanes have two points that are solved together
    bool driven;           ///< a tangentSpeed is not zero
    bool bounces;          ///< a bias is not zero; if false, they are ignored
    bool fresh;            ///< a contact has not been solved with sub-steps yet
    uint16 movesA, movesB; ///< bit mask of lanes whose body can move or rotate

    alignas(kCacheLine) b2Contact* contact[kBlockLanes];
    float32 tangentSpeed[kBlockLanes];
    float32 bias[2][kBlockLanes]; ///< target separation speed from restitution [m/s]
};

/// Returns the effective mass of a point's normal [kg].
inline float32 NormalMassOf(const ContactBlock& block, int lane, int point)
{
    const MassLanes& m = block.masses;
    const PointLanes& p = block.points[point];
    return InverseOrZero(m.invMassA[lane] + m.invMassB[lane] +
                         m.invInertiaA[lane] * p.normalLeverA[lane] * p.normalLeverA[lane] +
                         m.invInertiaB[lane] * p.normalLeverB[lane] * p.normalLeverB[lane]);
}

/// The position constraints of touching contacts, in world axes at the start of the step. All lanes
/// measure in the same way and match the ContactBlock of the same index, which has the masses.
/// Unused lanes are far apart.
struct alignas(kCacheLine) OverlapBlock
{
    int32 bodyA[kBlockLanes], bodyB[kBlockLanes];
    float32 offsetX[kBlockLanes], offsetY[kBlockLanes]; ///< from centre of mass A to B [m]
    float32 normalX[kBlockLanes], normalY[kBlockLanes]; ///< of the face, outward
    /// From its centre of mass to the face, or A's centre point.
    float32 referenceX[kBlockLanes], referenceY[kBlockLanes];
    float32 pointX[2][kBlockLanes], pointY[2][kBlockLanes]; ///< from the other body's centre
    float32 radius[kBlockLanes];                            ///< sum of the two skins [m]
    int32 count;                                            ///< used lanes
    int32 pointCount;
    OverlapKind kind;
    uint16 movesA, movesB; ///< as in ContactBlock
};

/// Data of a block for sub-steps only: the impulses of the whole step, and those at the start of
/// the last kick.
struct BlockTotals
{
    float32 normal[2][kBlockLanes], tangent[2][kBlockLanes];
    float32 firstNormal[2][kBlockLanes], firstTangent[2][kBlockLanes];
};

/// The input of a block, gathered from bodies and contacts. For circles A takes the role of the
/// face.
struct alignas(kCacheLine) ContactLanes
{
    float32 sineFace[kBlockLanes], cosineFace[kBlockLanes];
    float32 sineOther[kBlockLanes], cosineOther[kBlockLanes];
    float32 normalX[kBlockLanes], normalY[kBlockLanes]; ///< of the face, in its body's frame
    /// From its body's centre of mass to the face, and from the other's to the points, each in its
    /// own body's frame.
    float32 referenceX[kBlockLanes], referenceY[kBlockLanes];
    float32 pointX[2][kBlockLanes], pointY[2][kBlockLanes];
    float32 radiusFace[kBlockLanes], radiusOther[kBlockLanes];
    float32 restitution[kBlockLanes];
    float32 normalImpulse[2][kBlockLanes], tangentImpulse[2][kBlockLanes];
    float32 share[kBlockLanes]; ///< of these impulses that is warm-started
};

/// Blocks from `begin` to before `end`.
struct BlockRange
{
    int32 begin, end;
};

/// The blocks of one colour. The assignment lasts as long as the colour's contacts.
class ContactBlocks
{
public:
    /// Sorts the contacts of a colour by the groups of their bodies and by their bodies. There are
    /// `bodyCount` bodies. One thread then solves neighbours in memory. Contacts that may share
    /// bodies keep their order within a group, which is that of solving.
    void Sort(const Array<b2Contact*>& contacts, bool sharesBodies, const IslandGroups& groups,
              std::size_t bodyCount);
    /// Reserves memory for this number of contacts.
    void Reserve(std::size_t contactCount, bool sharesBodies, int32 groups);
    /// Assigns each sorted contact that must be solved to a lane in a block of its form; one block
    /// each if they may share bodies. Blocks must be prepared afterwards. Allocates no memory.
    void Assign(bool sharesBodies);

    int32 Count() const { return m_count; }
    /// Returns the first block of a group and the end of its blocks.
    BlockRange Of(const IslandGroup& group) const;
    /// Calls the function with the index and lane of each contact, part by part in the order in
    /// which Assign began them.
    template <class Function>
    void ForLanes(Function&& function) const
    {
        for (const Part& part : m_parts)
        {
            const int32 end = b2Min(Contacts(part.block).count, part.lane + kPartLanes);
            for (int32 lane = part.lane; lane < end; ++lane)
            {
                function(part.block, lane);
            }
        }
    }
    ContactBlock& Contacts(int32 index) { return m_contacts[std::size_t(index)]; }
    const ContactBlock& Contacts(int32 index) const { return m_contacts[std::size_t(index)]; }
    OverlapBlock& Overlaps(int32 index) { return m_overlaps[std::size_t(index)]; }
    const OverlapBlock& Overlaps(int32 index) const { return m_overlaps[std::size_t(index)]; }
    /// Valid after ClearTotals.
    BlockTotals& Totals(int32 index) { return m_totals[std::size_t(index)]; }
    void ClearTotals();

private:
    friend struct SnapshotAccess;
    struct Part
    {
        int32 block, lane; // the first
    };
    int32 Add(OverlapKind kind, int32 pointCount);

    Array<b2Contact*> m_sorted; // contacts of the colour
    Array<uint8> m_buckets;     // per contact
    Array<int32> m_groupEnds;   // of the sorted contacts of each group
    Array<int32> m_blockEnds;   // of the blocks of each group
    Array<Part> m_parts;
    Array<ContactBlock> m_contacts;
    Array<OverlapBlock> m_overlaps;
    Array<BlockTotals> m_totals;
    int32 m_count = 0;
};

// The following use the widest instructions of this processor.

/// Prefetches the contacts of a block.
void ReadAhead(const ContactBlock& block);
/// Fills both sides of a block from the current poses. Velocities come from the bodies' solver
/// entries (for restitution). Prefetches the contacts of the `next` block, if there is one.
void PrepareBlock(ContactBlock& block, OverlapBlock& overlap, const ContactBlock* next,
                  const SolverContext& context);
/// Fills both sides of a block with this contact alone, which may share bodies with other blocks.
void PrepareAlone(b2Contact& contact, ContactBlock& block, OverlapBlock& overlap,
                  const SolverContext& context);
void WarmStartBlock(ContactBlock& block, SolverBody* bodies);
/// Starts a kick of sub-steps, `share` times as long as the last one: scales the last impulses and
/// applies them. With `addsLast`, those of the last kick are added to the totals before.
void KickBlock(ContactBlock& block, BlockTotals& totals, SolverBody* bodies, float32 share,
               bool addsLast);
/// Adds the impulses of the last kick to the totals of the step.
void AddToTotals(const ContactBlock& block, BlockTotals& totals);
/// Reduces friction that exceeds its limit, because normal impulses have become smaller since it
/// was solved.
void LimitFriction(ContactBlock& block, SolverBody* bodies);
/// What does not count as an error, see FindErrors.
struct ErrorBounds
{
    float32 sticks;   ///< a contact sticks below this fraction of its friction limit
    float32 rounding; ///< maximum error that counts as rounding [m/s]
};
/// Raises `off` to the error of each contact's speeds [m/s], beyond the rounding of its impulse and
/// of its bodies' speeds. A normal error is an approach, or any speed of a point that pushes;
/// tangential errors count while it sticks.
void FindErrors(const ContactBlock& block, const SolverBody* bodies, const ErrorBounds& bounds,
                float32 (&off)[kBlockLanes]);
/// One iteration. False if no impulse changed a speed by more than `unchanged` [m/s]. With 0: if
/// that is so for all contacts, no other iteration over them would change an impulse.
bool SolveBlock(ContactBlock& block, SolverBody* bodies, float32 unchanged = 0.0f);
/// One position iteration: moves overlapping bodies apart. Returns the smallest separation that was
/// met [m].
float32 SolveBlock(const OverlapBlock& block, const MassLanes& masses, SolverBody* bodies,
                   PushPace pace);
/// Stores the impulses in the manifolds.
void StoreImpulses(const ContactBlock& block);

/// Returns the impulses of a lane for a listener.
b2ContactImpulse ImpulseOf(const ContactBlock& block, int lane);

} // namespace box2d
