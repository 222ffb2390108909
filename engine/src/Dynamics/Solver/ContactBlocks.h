// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

/// Contacts of one colour, eight at a time, so that one instruction serves several. A block is
/// prepared and solved by 8, by twice 4 or by 8 times one lane with the same bits, and so does the
/// plain solver of ContactSolver.cpp, which solves impacts and stays as the reference.
namespace box2d
{

struct SnapshotAccess;

inline constexpr int kBlockLanes = 8;

/// See ContactPoint.
struct PointLanes
{
    float32 normalLeverA[kBlockLanes], normalLeverB[kBlockLanes];
    float32 tangentLeverA[kBlockLanes], tangentLeverB[kBlockLanes];
    float32 normalImpulse[kBlockLanes], tangentImpulse[kBlockLanes];
    float32 normalMass[kBlockLanes], tangentMass[kBlockLanes];
    float32 bias[kBlockLanes];
};

/// See ContactConstraint. All lanes have the same number of points. Lanes that are not used hold
/// impulses of zero between bodies 0, which are never stored.
struct alignas(kCacheLine) ContactBlock
{
    int32 bodyA[kBlockLanes], bodyB[kBlockLanes];
    float32 normalX[kBlockLanes], normalY[kBlockLanes];
    float32 friction[kBlockLanes], tangentSpeed[kBlockLanes];
    float32 invMassA[kBlockLanes], invInertiaA[kBlockLanes];
    float32 invMassB[kBlockLanes], invInertiaB[kBlockLanes];
    PointLanes points[2];
    float32 k11[kBlockLanes], k12[kBlockLanes], k22[kBlockLanes];
    float32 coupled[kBlockLanes]; ///< 1 or 0
    b2Contact* contact[kBlockLanes];
    int32 count; ///< used lanes
    int32 pointCount;
    bool allCoupled;
    uint8 movesA, movesB; ///< a bit for each lane whose body can be pushed or turned
};

/// See OverlapConstraint. All lanes measure the same way, and are those of the ContactBlock of the
/// same index. Lanes that are not used are far apart.
struct alignas(kCacheLine) OverlapBlock
{
    int32 bodyA[kBlockLanes], bodyB[kBlockLanes];
    float32 offsetX[kBlockLanes], offsetY[kBlockLanes];
    float32 normalX[kBlockLanes], normalY[kBlockLanes];
    float32 referenceX[kBlockLanes], referenceY[kBlockLanes];
    float32 pointX[2][kBlockLanes], pointY[2][kBlockLanes];
    float32 radius[kBlockLanes];
    float32 invMassA[kBlockLanes], invInertiaA[kBlockLanes];
    float32 invMassB[kBlockLanes], invInertiaB[kBlockLanes];
    int32 count; ///< used lanes
    int32 pointCount;
    OverlapKind kind;
    uint8 movesA, movesB; ///< as in ContactBlock
};

/// What only sub-steps keep of a block: the impulses of the whole step, and those that the last
/// kick began with.
struct BlockTotals
{
    float32 normal[2][kBlockLanes], tangent[2][kBlockLanes];
    float32 firstNormal[2][kBlockLanes], firstTangent[2][kBlockLanes];
};

/// What a block is computed from, gathered from bodies and contacts. In the case of circles A
/// stands for the face.
struct alignas(kCacheLine) ContactLanes
{
    float32 sineFace[kBlockLanes], cosineFace[kBlockLanes];
    float32 sineOther[kBlockLanes], cosineOther[kBlockLanes];
    float32 normalX[kBlockLanes], normalY[kBlockLanes]; ///< of the face, in its body's axes
    /// From its body's centre of mass to the face, and from the other's to the points, each in
    /// axes of its own body.
    float32 referenceX[kBlockLanes], referenceY[kBlockLanes];
    float32 pointX[2][kBlockLanes], pointY[2][kBlockLanes];
    float32 radiusFace[kBlockLanes], radiusOther[kBlockLanes];
    float32 restitution[kBlockLanes];
    float32 normalImpulse[2][kBlockLanes], tangentImpulse[2][kBlockLanes];
};

/// The blocks of one colour. What is in which block stays while the colour's contacts do.
class ContactBlocks
{
public:
    /// Puts the contacts of a colour in the order of their bodies, `bodyCount` in all, so that
    /// neighbours in memory are solved by one thread; in their own order when they may share
    /// bodies, for then they must be solved in it.
    void Sort(const Array<b2Contact*>& contacts, bool sharesBodies, std::size_t bodyCount);
    /// Makes room for as many.
    void Reserve(std::size_t contactCount, bool sharesBodies);
    /// Gives each of the sorted contacts that has to be solved a lane in a block of its form; one
    /// block each when they may share bodies. The blocks still have to be prepared. Allocates
    /// nothing.
    void Assign(bool sharesBodies);

    int32 Count() const { return m_count; }
    ContactBlock& Contacts(int32 index) { return m_contacts[std::size_t(index)]; }
    OverlapBlock& Overlaps(int32 index) { return m_overlaps[std::size_t(index)]; }
    /// After ClearTotals.
    BlockTotals& Totals(int32 index) { return m_totals[std::size_t(index)]; }
    void ClearTotals();

private:
    friend struct SnapshotAccess;
    int32 Add(OverlapKind kind, int32 pointCount);

    Array<b2Contact*> m_sorted; // the contacts of the colour
    Array<uint8> m_buckets;     // of each
    Array<ContactBlock> m_contacts;
    Array<OverlapBlock> m_overlaps;
    Array<BlockTotals> m_totals;
    int32 m_count = 0;
};

// The following are for the widest instructions that this processor has.

/// Fills both sides of a block, line by line what PrepareContact does.
void PrepareBlock(ContactBlock& block, OverlapBlock& overlap, const SolverContext& context);
void WarmStartBlock(ContactBlock& block, SolverBody* bodies);
/// One iteration. False when no impulse changed: when none of all contacts does, no other iteration
/// over them would change one.
bool SolveBlock(ContactBlock& block, SolverBody* bodies);
/// One iteration of moving apart; see SolveOverlaps.
float32 SolveBlock(const OverlapBlock& block, SolverBody* bodies, PushPace pace);
/// Puts the impulses into the manifolds.
void StoreImpulses(const ContactBlock& block);

/// One lane of a block, as the plain solver has it.
OverlapConstraint OverlapOf(const OverlapBlock& block, int lane);
/// Two points of a lane that are nearly one, pushed apart one after the other.
float32 SolveNearlyOnePoint(const OverlapBlock& block, int lane, SolverBody* bodies, PushPace pace);

} // namespace box2d
