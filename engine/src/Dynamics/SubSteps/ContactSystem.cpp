// SPDX-License-Identifier: MIT
#include "ContactSystem.h"
#include "../Solver/OverlapSolver.h"

#include "../Contacts/Skins.h"
#include "../Joints/JointEnergy.h"
#include "../Solver/SolverMemory.h"
#include "ContactItem.h"
#include "Jams.h"
#include "JointSystem.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <utility>

namespace box2d
{

namespace
{

/// Per contact island. A bound of the cost that includes stacks of 50 boxes: with 32 they fall.
/// With 512 no test fails (docs/notes/tuned-constants.md).
constexpr int32 kMaxContacts = 128;
/// Per body of the island, see RowPattern. A bound of the cost; with 4 and 64 no test fails.
constexpr int32 kMaxUpdates = 16;
/// Of determining the friction limits. The stones of a loaded arch slide by up to 19 cm with 2, 15
/// with 3, and 10 to 13 from 4 on (docs/notes/sub-steps-direct-solver.md).
constexpr int32 kMaxRounds = 8;
/// A kinematic body that presses against a static one has no solution: the impulses of least energy
/// grow without bound. Contacts of such an island are softened by this fraction of what their
/// impulses would do to them alone. No impulse then exceeds the one that stops its bodies from the
/// pusher's speed by more than the inverse of the fraction. The same applies where joints and
/// contacts contradict each other.
/// Tuned on boxes between walls and at a door: docs/notes/sub-steps-motors-and-jams.md. With 0.4
/// and 1 no test fails. With 0.025 a door at a wall presses with 118 m/s (8 sub-steps), where the
/// test allows 100.
constexpr float32 kJammedSoftness = 0.1f;
/// Of contacts without weight [m/s]: speeds of 10 m/s are rounded by as much. With 1e-4 a stack of
/// 20 sways by 18 mm instead of 0.2 (docs/notes/tuned-constants.md).
constexpr float32 kMinTolerance = 1e-6f;
/// Rounding of impulses and speeds counts as no error up to this fraction of the speed that weight
/// adds in a kick. Without a bound an impulse of 1e6 Ns hides any error: of random world 34 a body
/// between two sides of another left with 1.7 km/s (16 sub-steps). With 0 islands are solved
/// directly for rounding; with 1 no test fails.
constexpr float32 kMaxRounding = 0.01f;
/// Added to the speed that weight adds in a kick [m/s], for worlds without gravity. At 60 Hz with 4
/// sub-steps that speed is 0.04 m/s. No test fails with 1e-6 or 0.01.
constexpr float32 kMinWeight = 1e-4f;
/// An impact goes on in an island in which a contact is off by more than this multiple of the speed
/// that weight adds in a kick. Loads at rest are off by at most that speed. With 0.3, 1 and 3
/// pile-ups of ragdolls take the same time, with 10 a fifth more.
constexpr float32 kImpact = 1.0f;
/// Displacements that an inactive row may violate its condition by [m]: far below the 0.15 slops
/// between kMaxOverlap and kRestOverlap. With a tenth no test fails. With ten times as much a box
/// that slides over a row of boxes ends 0.54 m short.
constexpr float32 kDisplacementTolerance = 0.01f * b2_linearSlop;
/// Where shapes overlap by more than this [m], there is no room for them. It is the size of the
/// smallest bodies that the manual advises.
constexpr float32 kSqueezed = 0.1f;
/// There is no room for displacements if a point is left by more than this [m]: five times the
/// tolerance of displacements. With ten times as much a row that walls press leaves with 4.3 m/s
/// when they open (docs/notes/tuned-constants.md).
constexpr float32 kNoRoom = 0.05f * b2_linearSlop;

/// With the friction limits of the first `contacts` items, and those of the other items that are
/// bounded as a vector. Both follow from the solution. True if they were found.
template <class Holds>
bool MinimizeWithFriction(BoundedSystem& system, std::size_t contacts, const Holds& holds,
                          const SolverContext& context, double tolerance)
{
    const auto limitDiscs = [&] {
        for (std::size_t i = contacts; i < system.Count(); ++i)
        {
            system.LimitDisc(context, i);
        }
    };
    bool changed = true;
    for (int32 round = 0; round < kMaxRounds && changed; ++round)
    {
        for (std::size_t i = 0; i < contacts; ++i)
        {
            system.Limit(context, i, 2, holds(i));
        }
        limitDiscs();
        system.Minimize(context, tolerance);
        changed = false;
        for (std::size_t i = 0; i < system.Count() && !changed; ++i)
        {
            changed = i < contacts ? system.HasOtherLimit(i, 2, holds(i))
                                   : system.HasOtherDisc(context, i);
        }
    }
    if (changed)
    {
        limitDiscs(); // not solved again: some impulses would then exceed their maximum
    }
    return !changed;
}

/// Converts an overlap to an item. Its rows separate the points by a fraction of the excess over
/// the slop, which is also the minimum distance.
void FillOverlap(const OverlapBlock& o, int32 lane, const ContactData& contact, SolverBody* bodies,
                 PushPace pace, JointRows& rows, BoundedSystem::Item& item)
{
    rows.Clear();
    item = BoundedSystem::Item();
    rows.rows = 3;
    const float32 share = 1.0f / float32(o.pointCount);
    JointRows::Column& a = rows.Of(Data(*contact.bodyA));
    JointRows::Column& b = rows.Of(Data(*contact.bodyB));
    for (int32 i = 0; i < o.pointCount; ++i)
    {
        const Overlap overlap = MeasureOverlap(o, lane, i, bodies);
        a.AddTo(i, -overlap.normal, -b2Cross(overlap.armA, overlap.normal));
        b.AddTo(i, overlap.normal, b2Cross(overlap.armB, overlap.normal));
        const b2Vec2 tangent = share * b2Cross(overlap.normal, 1.0f);
        a.AddTo(2, -tangent, -b2Cross(overlap.armA, tangent));
        b.AddTo(2, tangent, b2Cross(overlap.armB, tangent));
        const float32 out = -pace.rate * (overlap.separation + kRestOverlap);
        item.speeds.at[i] = double(b2Min(out, pace.maximum));
        item.maximum.at[i] = BoundedSystem::kUnbounded;
        item.active = uint8(item.active | int(out > 0.0f) << i);
    }
}

/// Returns the number of a contact's island; -1 without one.
int32 IslandOf(const AwakeIslands& islands, const ContactBlock& block, int32 lane)
{
    const int32 island = islands.Of(block.bodyA[lane]);
    return island != -1 ? island : islands.Of(block.bodyB[lane]);
}

} // namespace

template <class Function>
void ContactSystem::ForContacts(SolverMemory& solver, Function&& function) const
{
    for (int32 i = 0; i < solver.colorCount; ++i)
    {
        const int32 color = solver.colors[i];
        ContactBlocks& blocks = solver.contacts[color];
        blocks.ForLanes([&](int32 index, int32 lane) {
            function(IslandOf(solver.islands, blocks.Contacts(index), lane),
                     Place{color, index, lane});
        });
    }
}

void ContactSystem::Begin(SolverMemory& solver, JointSystem& joints)
{
    if (solver.colorCount == 0)
    {
        m_free.insert(m_free.end(), m_used.begin(), m_used.end());
        m_used.clear();
        return;
    }
    // Neither are islands with joints that are iterated over.
    joints.ForIterated([&](b2Joint* joint) {
        for (const b2Body* body : {joint->GetBodyA(), joint->GetBodyB()})
        {
            const int32 island = solver.islands.Of(Data(*body).SolverIndex());
            if (island != -1)
            {
                m_contacts[std::size_t(island)] = kMaxContacts + 1;
            }
        }
    });
    ChooseContactIslands(solver.islands);
    if (!m_used.empty())
    {
        m_moves.resize(b2Max(m_moves.size(), solver.bodies.size())); // not while groups are solved
        Gather(solver, joints);
    }
}

void ContactSystem::CountContacts(SolverMemory& solver)
{
    m_contacts.assign(std::size_t(solver.islands.Count()), 0);
    ForContacts(solver, [this](int32 island, const Place&) {
        if (island != -1)
        {
            ++m_contacts[std::size_t(island)];
        }
    });
}

bool ContactSystem::IsLarge(int32 island) const
{
    return island != -1 && m_contacts[std::size_t(island)] > kMaxContacts;
}

/// An island keeps its contact system from step to step, so that its pattern and memory can be
/// reused.
void ContactSystem::ChooseContactIslands(const AwakeIslands& islands)
{
    const auto isSmall = [this](int32 number) {
        const int32 contacts = number != -1 ? m_contacts[std::size_t(number)] : 0;
        return contacts > 0 && contacts <= kMaxContacts;
    };
    m_contactIslandOf.assign(m_contacts.size(), -1);
    std::size_t kept = 0;
    for (const int32 index : m_used)
    {
        ContactIsland& island = m_contactIslands[std::size_t(index)];
        const int32 number = islands.NumberOf(island.id);
        if (isSmall(number))
        {
            m_contactIslandOf[std::size_t(number)] = index;
            m_used[kept++] = index;
        }
        else
        {
            m_free.push_back(index);
        }
    }
    m_used.resize(kept);
    for (int32 number = 0; number < islands.Count(); ++number)
    {
        int32& index = m_contactIslandOf[std::size_t(number)];
        if (index == -1 && isSmall(number))
        {
            index = TakeContactIsland();
            m_contactIslands[std::size_t(index)].id = islands.At(number);
            m_used.push_back(index);
        }
    }
    for (const int32 index : m_used)
    {
        ContactIsland& island = m_contactIslands[std::size_t(index)];
        island.contacts.clear();
        island.joints.clear();
        island.followed = false;
    }
}

int32 ContactSystem::TakeContactIsland()
{
    if (m_free.empty())
    {
        m_contactIslands.emplace_back();
        MakeRoom(m_free, m_contactIslands.size()); // for the step in which it is given back
        return int32(m_contactIslands.size()) - 1;
    }
    const int32 index = m_free.back();
    m_free.pop_back();
    return index;
}

void ContactSystem::Gather(SolverMemory& solver, JointSystem& joints)
{
    ForContacts(solver, [this](int32 island, const Place& place) {
        const int32 index = island != -1 ? m_contactIslandOf[std::size_t(island)] : -1;
        if (index != -1)
        {
            m_contactIslands[std::size_t(index)].contacts.push_back(place);
        }
    });
    // A tree that moves independently touches no contact, though an island that was not split yet
    // may contain both.
    joints.ForRowed([&](std::size_t i, const JointRows&) {
        const RowSides& sides = joints.Sides(i);
        for (const BodyData* body : sides.sides)
        {
            const int32 island = body != nullptr ? solver.islands.NumberOf(body->island) : -1;
            const int32 index = island != -1 ? m_contactIslandOf[std::size_t(island)] : -1;
            if (index != -1)
            {
                m_contactIslands[std::size_t(index)].joints.push_back(int32(i));
                break;
            }
        }
    });
}

/// An island that exceeds its memory takes over that of a free one.
void ContactSystem::FindRoom(ContactIsland& island)
{
    for (std::size_t i = 0; i < m_free.size() && m_sides.size() > island.sides.capacity(); ++i)
    {
        ContactIsland& other = m_contactIslands[std::size_t(m_free[i])];
        if (m_sides.size() <= other.sides.capacity())
        {
            std::swap(island.sides, other.sides);
            std::swap(island.system, other.system);
        }
    }
}

/// Builds the system again if it was for other contacts. True if there is one.
bool ContactSystem::Follow(ContactIsland& island, SolverMemory& solver, JointSystem& joints)
{
    if (!island.followed)
    {
        island.followed = true;
        m_sides.clear();
        for (const Place& place : island.contacts)
        {
            const ContactBlock& block = solver.contacts[place.color].Contacts(place.block);
            const ContactData& contact = Data(*block.contact[place.lane]);
            RowSides& s = m_sides.emplace_back();
            s.Add(Data(*contact.bodyA));
            s.Add(Data(*contact.bodyB));
        }
        for (const int32 joint : island.joints)
        {
            m_sides.push_back(joints.Sides(std::size_t(joint)));
        }
        if (m_sides != island.sides)
        {
            FindRoom(island);
            MakeRoom(island.sides, m_sides.size());
            island.sides = m_sides;
            island.system.Build(m_sides, kMaxUpdates, m_elimination);
        }
    }
    return island.system.IsExact();
}

/// Calls the function for the group's selected islands.
template <class Function>
void ContactSystem::ForSelected(const IslandGroup& group, Function&& function)
{
    for (int32 number = group.firstIsland; number < group.endIsland; ++number)
    {
        const int32 index = m_contactIslandOf[std::size_t(number)];
        if (index != -1)
        {
            function(m_contactIslands[std::size_t(index)]);
        }
    }
}

void ContactSystem::FollowAll(SolverMemory& solver, JointSystem& joints)
{
    for (const int32 index : m_used)
    {
        (void)Follow(m_contactIslands[std::size_t(index)], solver, joints);
    }
}

/// Finds the largest error of each selected island.
void ContactSystem::FindResiduals(const SolverMemory& solver, const IslandGroup& group,
                                  const SolverBody* bodies, float32 maxRounding)
{
    ForSelected(group, [](ContactIsland& island) { island.residual = 0.0f; });
    for (int32 i = 0; i < solver.colorCount; ++i)
    {
        const ContactBlocks& blocks = solver.contacts[solver.colors[i]];
        const BlockRange range = blocks.Of(group);
        for (int32 k = range.begin; k < range.end; ++k)
        {
            const ContactBlock& block = blocks.Contacts(k);
            float32 off[kBlockLanes] = {};
            FindErrors(block, bodies, {float32(kSticks), maxRounding}, off);
            for (int32 lane = 0; lane < block.count; ++lane)
            {
                const int32 island = IslandOf(solver.islands, block, lane);
                const int32 index = island != -1 ? m_contactIslandOf[std::size_t(island)] : -1;
                if (index != -1)
                {
                    float32& residual = m_contactIslands[std::size_t(index)].residual;
                    residual = b2Max(residual, off[lane]);
                }
            }
        }
    }
}

/// False if the iterations of the next kicks suffice to end an impact: joints without motors and
/// springs, levers and masses within the manual's advice.
bool ContactSystem::IsAtRisk(const ContactIsland& island, SolverMemory& solver,
                             const JointSystem& joints)
{
    const auto isAtRisk = [&](int32 joint) {
        return joints.Rows(std::size_t(joint)).IsDriven() ||
               box2d::IsAtRisk(joints.At(std::size_t(joint)));
    };
    return island.joints.empty() ||
           std::any_of(island.joints.begin(), island.joints.end(), isAtRisk) ||
           std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Place& place) {
               const ContactBlock& block = solver.contacts[place.color].Contacts(place.block);
               const ContactData& contact = Data(*block.contact[place.lane]);
               return HaveUnequalMasses(Data(*contact.bodyA), Data(*contact.bodyB));
           });
}

void ContactSystem::NoteBalance(const IslandGroup& group)
{
    ForSelected(group, [](ContactIsland& island) { island.inImpact = false; });
}

void ContactSystem::SolveVelocities(SolverMemory& solver, const IslandGroup& group,
                                    JointSystem& joints, const SolverContext& context,
                                    float32 weight)
{
    if (m_used.empty())
    {
        return;
    }
    FindResiduals(solver, group, context.bodies, kMaxRounding * weight);
    const float32 tolerance = kTolerance * weight + kMinTolerance;
    ForSelected(group, [&](ContactIsland& island) {
        const bool inImpact = island.residual > kImpact * (weight + kMinWeight);
        island.inImpact = inImpact && !IsAtRisk(island, solver, joints);
        // The last iteration of contacts leaves no error at a load that rests squarely on a joint's
        // body, but all of it in the joint.
        const auto isOff = [&](int32 joint) {
            return joints.ErrorOf(std::size_t(joint), context) > tolerance;
        };
        const bool solve =
            !island.inImpact &&
            (island.residual > tolerance || std::ranges::any_of(island.joints, isOff)) &&
            Follow(island, solver, joints);
        const bool driven = solve && SolveVelocities(island, solver, joints, context,
                                                     {tolerance, weight + kMinWeight});
        // Impulses of an impact are not passed on: the next kick would apply them again.
        const bool ends = driven && inImpact;
        for (const Place& place : island.contacts)
        {
            ContactBlocks& blocks = solver.contacts[place.color];
            ContactItem item(blocks.Contacts(place.block), place.lane);
            BlockTotals& totals = blocks.Totals(place.block);
            ends ? item.CountImpact(totals) : item.PassOnInProportion(totals);
        }
    });
}

/// True if rounding may let its rows contradict each other: those of joints, of contacts in a ring
/// of bodies or side by side between two of them, and of platforms that move.
bool ContactSystem::MayContradict(const ContactIsland& island, const SolverMemory& solver,
                                  const SolverBody* bodies)
{
    int32 between = 0; // contacts of two bodies that they move
    int32 carried = 0; // those with a platform that moves
    for (const Place& place : island.contacts)
    {
        const ContactBlock& block = solver.contacts[place.color].Contacts(place.block);
        const auto isGiven = [&](uint32 moves, int32 body) {
            const SolverBody& s = bodies[body];
            return (moves >> place.lane & 1) == 0 && (s.v != b2Vec2_zero || s.w != 0.0f);
        };
        between += block.movesA >> place.lane & block.movesB >> place.lane & 1;
        carried += int32(isGiven(block.movesA, block.bodyA[place.lane]) ||
                         isGiven(block.movesB, block.bodyB[place.lane]));
    }
    // In a forest of bodies each contact between two of them joins two trees.
    const int32 inForest = int32(island.system.Bodies().size()) - island.system.Components();
    return !island.joints.empty() || between > inForest || carried > 1;
}

/// True if platforms squeeze it.
bool ContactSystem::SolveVelocities(ContactIsland& island, SolverMemory& solver,
                                    JointSystem& joints, const SolverContext& context,
                                    const Speeds& speeds)
{
    const auto tolerance = double(speeds.tolerance);
    const auto contact = [&](std::size_t i) {
        const Place& place = island.contacts[i];
        return ContactItem(solver.contacts[place.color].Contacts(place.block), place.lane);
    };
    BoundedSystem& system = island.system;
    const std::size_t count = island.contacts.size();
    const float32 softness = MayContradict(island, solver, context.bodies) ? kProximal : 0.0f;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Place& place = island.contacts[i];
        ContactItem item = contact(i);
        item.FillRows(system.Rows(i), solver.contacts[place.color].Overlaps(place.block), context);
        item.Fill(system.At(i), SpeedOf(context, system.Rows(i)), tolerance);
        item.SetSoftness(system.Rows(i), system.At(i), softness, system.At(i).impulse);
    }
    for (std::size_t i = 0; i < island.joints.size(); ++i)
    {
        joints.FillItem(std::size_t(island.joints[i]), system.Rows(count + i),
                        system.At(count + i));
    }
    system.Begin(context);
    const double driven = system.FastestDriven(context);
    const auto holds = [&](std::size_t i) { return contact(i).Holds(system.At(i)); };
    system.Mark(context);
    bool found = MinimizeWithFriction(system, count, holds, context, tolerance);
    const bool jammed = IsJammed(system, count, context, driven, double(speeds.weight)) ||
                        IsWedged(system, count, context, double(speeds.weight));
    if (jammed)
    {
        system.GoBack(context);
        for (std::size_t i = 0; i < count; ++i)
        {
            contact(i).SetSoftness(system.Rows(i), system.At(i), kJammedSoftness, Vector3());
        }
        system.Begin(context);
        system.Mark(context); // soft contacts store energy
        found = MinimizeWithFriction(system, count, holds, context, tolerance);
    }
    // What is squeezed may hold itself by friction with any load. Then limits that were not found
    // would let the loads grow from round to round.
    const auto isSqueezed = [&] {
        return jammed || driven > 0.0 || MinSeparation(island, solver, context.bodies) < -kSqueezed;
    };
    if (!found && isSqueezed())
    {
        system.GoBack(context);
    }
    else
    {
        system.KeepIfBetter(context);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        contact(i).Take(system.At(i));
    }
    for (std::size_t i = 0; i < island.joints.size(); ++i)
    {
        joints.TakeItem(std::size_t(island.joints[i]), system.At(count + i));
    }
    return driven > 0.0;
}

/// Returns the separation of the points of the island that overlap most [m]; 0 if none does.
float32 ContactSystem::MinSeparation(const ContactIsland& island, const SolverMemory& solver,
                                     const SolverBody* bodies)
{
    float32 least = 0.0f;
    for (const Place& place : island.contacts)
    {
        const OverlapBlock& o = solver.contacts[place.color].Overlaps(place.block);
        for (int32 k = 0; k < o.pointCount; ++k)
        {
            least = b2Min(least, MeasureOverlap(o, place.lane, k, bodies).separation);
        }
    }
    return least;
}

void ContactSystem::SolveOverlaps(SolverMemory& solver, const IslandGroup& group,
                                  JointSystem& joints, const SolverContext& context, PushPace pace)
{
    if (m_used.empty())
    {
        return;
    }
    ForSelected(group, [&](ContactIsland& island) {
        if (island.inImpact)
        {
            return;
        }
        if (MinSeparation(island, solver, context.bodies) < -kMaxOverlap &&
            Follow(island, solver, joints))
        {
            SolveOverlaps(island, solver, joints, context, pace);
        }
    });
}

/// The system solves displacements here in place of velocities.
void ContactSystem::SolveOverlaps(ContactIsland& island, SolverMemory& solver, JointSystem& joints,
                                  const SolverContext& context, PushPace pace)
{
    SolverContext displacements = context;
    displacements.bodies = m_moves.data();
    BoundedSystem& system = island.system;
    const std::size_t count = island.contacts.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const Place& place = island.contacts[i];
        ContactBlocks& blocks = solver.contacts[place.color];
        FillOverlap(blocks.Overlaps(place.block), place.lane,
                    Data(*blocks.Contacts(place.block).contact[place.lane]), context.bodies, pace,
                    system.Rows(i), system.At(i));
    }
    for (std::size_t i = 0; i < island.joints.size(); ++i)
    {
        joints.FillDisplacements(std::size_t(island.joints[i]), system.Rows(count + i),
                                 system.At(count + i));
    }
    system.Begin(displacements);
    system.Minimize(displacements, double(kDisplacementTolerance));
    for (std::size_t i = 0; i < count; ++i)
    {
        const Place& place = island.contacts[i];
        BoundedSystem::Item& item = system.At(i);
        const double load = item.impulse.at[0] + item.impulse.at[1];
        item.maximum.at[2] =
            double(solver.contacts[place.color].Contacts(place.block).friction[place.lane]) * load;
        item.minimum.at[2] = -item.maximum.at[2];
        if (load > 0.0)
        {
            item.active |= 4;
        }
    }
    system.Minimize(displacements, double(kDisplacementTolerance));
    // Otherwise there is no room, and what was found is rounding.
    const bool hasRoom = system.Separates(displacements, count, double(kNoRoom));
    for (const BodyData* body : system.Bodies())
    {
        SolverBody& move = m_moves[std::size_t(body->SolverIndex())];
        move = hasRoom ? move : SolverBody();
        SolverBody& s = context.bodies[body->SolverIndex()];
        s.d += move.v;
        if (body->SolverInvInertia() > 0.0f)
        {
            s.Rotate(move.w);
        }
        move = SolverBody();
    }
}

} // namespace box2d
