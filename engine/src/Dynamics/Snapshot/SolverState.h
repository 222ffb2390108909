// SPDX-License-Identifier: MIT
#pragma once

#include "References.h"
#include "SnapshotAccess.h"

#include "../Energy/EnergyGuard.h"
#include "../Solver/SolverMemory.h"
#include "../State/World.h"
#include "../SubSteps/SubStepMemory.h"

/// The solver's memory that affects the next step. Most of it is filled again in each step. The
/// parts made when joints or contacts are added or removed follow from the lists, except:
/// - contacts stay in their blocks in an order that places of bodies had in the past;
/// - joints keep the states of their bounded rows, and the stiffness that the last step's forces
///   caused;
/// - the joints at risk of gaining energy were found when the list was made, with the settings of
///   that time;
/// - between the parts of a step of b2World::SetSubStepping the step is not complete.
namespace box2d
{

/// Contacts by their place in the colour. A colour that has changed is sorted again anyway.
template <class Archive>
void SnapshotAccess::Visit(Archive& archive, ContactBlocks& blocks, const World& world, int32 color)
{
    // Blocks are given out and prepared again.
    auto& [sorted, buckets, groupEnds, blockEnds, parts, contactBlocks, overlapBlocks, totals,
           blockCount] = blocks;
    const ConstraintGraph& graph = world.graph;
    if (graph.ChangeOf(color) == ConstraintGraph::Change::Contacts)
    {
        return;
    }
    const Array<b2Contact*>& contacts = graph.Contacts(color);
    sorted.resize(contacts.size());
    for (b2Contact*& contact : sorted)
    {
        int32 place = Archive::kReads ? 0 : Data(*contact).colorIndex;
        archive.Within(place, 0, int32(contacts.size()) - 1);
        contact = contacts[std::size_t(place)];
    }
    if (Archive::kReads)
    {
        groupEnds.assign(1, int32(contacts.size())); // as of one group, or it is sorted again
    }
}

/// Contacts of several groups are sorted again, from what the snapshot contains.
template <class Archive>
void SnapshotAccess::Visit(Archive& archive, IslandGroups& groups)
{
    auto& [ends, ofBody, lastOf, sizes, key, changed, wantsOrder] = groups;
    bool divided = groups.Count() > 1;
    archive(divided, wantsOrder);
    if (Archive::kReads)
    {
        ends.assign(divided ? 2 : 1, {-1, -1});
        key = IslandGroups::kNoKey;
    }
}

template <class Archive>
void VisitReferences(Archive& archive, Array<const b2Joint*>& joints)
{
    auto count = int32(joints.size());
    archive.Count(count, sizeof(int32));
    joints.resize(std::size_t(count));
    for (const b2Joint*& joint : joints)
    {
        auto* known = const_cast<b2Joint*>(joint);
        archive(known);
        joint = known;
    }
}

template <class Archive>
void SnapshotAccess::Visit(Archive& archive, EnergyGuard& guard, const World& world)
{
    // Springs and motors, and what goes with them, are listed again in each step. In a step that
    // has been broken off the springs have been charged.
    auto& [risky, sliding, version, accountOf, accounts, springs, motors, gravity, minFall,
           timeStep, subSteps] = guard;
    bool followed = version == world.graph.JointVersion();
    archive(followed);
    if (followed)
    {
        VisitReferences(archive, risky);
        VisitReferences(archive, sliding);
        version = world.graph.JointVersion();
    }
    auto count = int32(accounts.size());
    archive.Count(count, 6 * sizeof(double));
    accounts.resize(std::size_t(count));
    for (auto& account : accounts)
    {
        auto& [island, owed, gained, gainedByVelocity, past, scale, share] = account;
        archive(island, owed, gained, gainedByVelocity, past, scale, share);
    }
    if (count > 0)
    {
        archive(accountOf, gravity);
    }
}

template <class Archive>
void SnapshotAccess::Visit(Archive& archive, JointSystem& system, const World& world)
{
    // The joints that are iterated are chosen again in each step, and their sides found. A step
    // sets what its first kick reads.
    auto& [joints, sides, rowSystem, parts, trees, treeOf, solutions, rowed, iteratedJoints,
           iterated, threads, hasBounded, states, totals, kicks, poses, carriers, opened, left,
           noted, notedGaps, speeds, now, elimination, partJoints, begins, lastInverseStep, share,
           version, awakeVersion, restored, restoredVersion] = system;
    const int32 present = world.graph.JointVersion();
    bool followed = version == present || restoredVersion == present;
    archive(followed);
    if (!followed)
    {
        return;
    }
    // The list is used when the next step has woken all bodies that must wake.
    auto& kept = version == present ? states : restored;
    restoredVersion = Archive::kReads ? present : restoredVersion;
    kept.resize(world.graph.Joints().size());
    for (JointSystem::RowStates& joint : kept)
    {
        for (JointSystem::RowState& state : joint.of)
        {
            archive.Within(state, JointSystem::RowState::Holds, JointSystem::RowState::Fastest);
        }
    }
}

template <class Archive>
void VisitSolver(Archive& archive, World& world)
{
    SubStepMemory& subSteps = *world.subSteps;
    for (int32 color = 0; color < ConstraintGraph::kColorCount; ++color)
    {
        SnapshotAccess::Visit(archive, world.solver->contacts[color], world, color);
    }
    SnapshotAccess::Visit(archive, world.solver->groups);
    SnapshotAccess::Visit(archive, *world.energyGuard, world);
    SnapshotAccess::Visit(archive, subSteps.joints, world);
    // Accelerations of freely falling bodies with sub-steps, for the remaining impacts.
    auto count = int32(subSteps.modes.size());
    archive.Count(count, sizeof(int32));
    subSteps.modes.resize(std::size_t(count));
    subSteps.kicks.resize(std::size_t(count));
    for (std::size_t i = 0; i < subSteps.modes.size(); ++i)
    {
        archive.Within(subSteps.modes[i], BodyMode::Together, BodyMode::InTree);
        archive(subSteps.kicks[i].acceleration);
    }
}

} // namespace box2d
