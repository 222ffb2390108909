// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "../Solver/ContactBlocks.h"

class b2Body;

/// Restitution of a contact whose bodies have joints, with sub-steps. Joints pass the impulse on:
/// it acts on all bodies that are connected, so a jointed pair bounces as one body would. One
/// contact bounces at a time, as without joints (Bouncer). An impulse x at a point whose speed
/// changes from v to -e v does the work x v (1 - e) / 2, negative up to e = 1, and joints do none.
/// Motors and springs do not act, because an impact takes no time.
namespace box2d
{

struct ContactData;

class JointedBounce
{
public:
    /// Finds what joints connect with the contact's bodies. False if these have no joints or too
    /// many, or if a body of theirs sleeps: the contact then bounces without them.
    bool Find(const ContactData& contact);
    const Array<b2Joint*>& Joints() const { return m_joints; }
    /// All bodies of the joints, each once.
    const Array<b2Body*>& Bodies() const { return m_bodies; }
    /// Call after Find, for a contact that IsBouncing. The context's bodies contain those of the
    /// joints. False if it fails, because joints contradict each other; then it changes nothing.
    bool Bounce(ContactBlock& block, const OverlapBlock& overlap, BlockTotals& totals, int32 lane,
                float32 restitution, const SolverContext& context);

private:
    void Follow(b2Body& body);
    void Build(const ContactData& contact);
    void Fill(ContactBlock& block, const OverlapBlock& overlap, int32 lane,
              const SolverContext& context);
    void HoldJoints(const SolverContext& context);
    void Rub(const ContactBlock& block, int32 lane, const SolverContext& context);

    Array<b2Body*> m_bodies;
    Array<b2Joint*> m_joints;
    Array<RowSides> m_sides; // the contact's, then those of the joints
    Array<RowSides> m_built; // those of the current system
    BoundedSystem m_system;
    Elimination m_elimination;
};

} // namespace box2d
