// SPDX-License-Identifier: MIT
#include "StepSolver.h"
#include "Corners.h"
#include "Motion.h"
#include "OverlapSolver.h"

#include "../Contacts/Boxes.h"
#include "../Islands/Sleep.h"
#include "../Islands/SleepRule.h"
#include "../Joints/JointKinds.h"
#include "../State/Access.h"

#include "../../Collision/ImpactTarget.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <algorithm>
#include <atomic>
#include <bit>

namespace box2d
{

namespace
{

/// Impulses grow with the step as long as they come from forces that last. Those of hits do not:
/// after a very short step this much of them, and no more, is used for the warm start. With 1 a
/// stack in steps of 1/30 and 1/120 s walks by 1.5 m. With 1000 a chain that was hit in a short
/// step gets 120 m/s (docs/notes/tuned-constants.md).
constexpr float32 kMaxStepRatio = 10.0f;

/// Calls the listener with the impulses of a contact's manifold, and of its bounce in a corner.
void ReportImpulse(b2ContactListener& listener, b2Contact& contact,
                   const Array<CornerImpulse>& bounces)
{
    const b2Manifold& manifold = Data(contact).manifold;
    b2ContactImpulse impulse;
    impulse.count = manifold.pointCount;
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        impulse.normalImpulses[i] = manifold.points[i].normalImpulse;
        impulse.tangentImpulses[i] = manifold.points[i].tangentImpulse;
    }
    const auto bounce = std::ranges::lower_bound(bounces, &contact, {}, &CornerImpulse::contact);
    const bool bounced = bounce != bounces.end() && bounce->contact == &contact;
    for (int32 i = 0; i < manifold.pointCount && bounced; ++i)
    {
        impulse.normalImpulses[i] += bounce->normal[i];
        impulse.tangentImpulses[i] += bounce->tangent[i];
    }
    listener.PostSolve(&contact, &impulse);
}

} // namespace

SolverContext MakeContext(const World& world, float32 timeStep)
{
    SolverContext context;
    context.settings = world.settings;
    context.timeStep = timeStep;
    context.inverseStep = 1.0f / timeStep;
    context.inverseWhole = context.inverseStep;
    context.stepRatio = b2Min(world.inverseStep * timeStep, kMaxStepRatio);
    context.warmStarting = world.settings.warmStarting;
    return context;
}

StepSolver::StepSolver(World& world, float32 timeStep)
    : m_world(world), m_memory(*world.solver), m_threads(world.threads.get()),
      m_context(MakeContext(world, timeStep)), m_profiling(world.profiling)
{}

void StepSolver::SortBodies()
{
    if (m_memory.groups.WantsOrder())
    {
        m_memory.islands.Find(m_world);
        m_memory.islands.SortBodies(m_world);
    }
}

void StepSolver::WakeJointNeighbours()
{
    // Waking adds joints to the list, so it is read again each time.
    for (std::size_t i = 0; i < m_world.graph.Joints().size(); ++i)
    {
        b2Joint* joint = m_world.graph.Joints()[i];
        WakeNeighbours(m_world, *joint->GetBodyA(), *joint->GetBodyB());
        KeepDrivenAwake(*joint);
    }
    // A joint between a platform and a sleeping body is in no list.
    for (std::size_t i = 0; i < m_world.awakeBodies.size(); ++i)
    {
        b2Body* body = m_world.awakeBodies[i];
        b2JointEdge* edge = body->GetType() == b2_kinematicBody ? body->GetJointList() : nullptr;
        for (; edge; edge = edge->next)
        {
            if (edge->joint->IsActive())
            {
                WakeNeighbours(m_world, *body, *edge->other);
            }
        }
    }
    m_world.graph.SortJoints();
}

void StepSolver::IntegrateVelocities()
{
    m_memory.bodies.resize(m_world.awakeBodies.size() + 1);
    m_memory.bodies[0] = SolverBody();
    m_context.bodies = m_memory.bodies.data();
    ForBodies([this](std::size_t i) {
        m_memory.bodies[i + 1] = WithForces(Data(*m_world.awakeBodies[i]));
    });
}

SolverBody StepSolver::WithForces(const BodyData& body) const
{
    const float32 h = m_context.timeStep;
    SolverBody s;
    s.v = body.linearVelocity;
    s.w = body.angularVelocity;
    if (body.IsDynamic())
    {
        s.v += h * (body.gravityScale * m_world.settings.gravity + body.invMass * body.force);
        s.w += h * body.invInertia * body.torque;
        // dv/dt = -c v, one implicit step: stable for any c.
        s.v *= 1.0f / (1.0f + h * body.linearDamping);
        s.w *= 1.0f / (1.0f + h * body.angularDamping);
    }
    s.v = Bounded(s.v);
    s.w = Bounded(s.w);
    return s;
}

void StepSolver::AssignContacts()
{
    constexpr uint32 kOverflowBit = 1u << ConstraintGraph::kOverflow;
    const uint32 used = m_world.graph.UsedColors();
    m_memory.colorCount = 0;
    if ((used & kOverflowBit) != 0)
    {
        m_memory.colors[m_memory.colorCount++] = ConstraintGraph::kOverflow;
    }
    for (uint32 left = used & ~kOverflowBit; left != 0; left &= left - 1)
    {
        m_memory.colors[m_memory.colorCount++] = std::countr_zero(left);
    }
    FindGroups();
    for (int32 i = 0; i < m_memory.colorCount; ++i)
    {
        const int32 color = m_memory.colors[i];
        m_memory.contacts[color].Reserve(m_world.graph.Contacts(color).size(),
                                         color == ConstraintGraph::kOverflow,
                                         m_memory.groups.Count());
    }
    ParallelFor(m_threads, m_memory.colorCount, 1, [this](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            AssignBlocks(m_memory.colors[i]);
        }
    });
}

void StepSolver::BounceInCorners()
{
    m_memory.corners.impulses.clear();
    box2d::BounceInCorners(m_world, m_memory.corners, m_context);
    // By address, to be found for the listener. No result depends on the order.
    std::ranges::sort(m_memory.corners.impulses, {}, &CornerImpulse::contact);
}

bool StepSolver::IsFree() const
{
    return m_memory.colorCount == 0 && m_memory.joints.IsEmpty();
}

void StepSolver::PrepareContacts()
{
    ForEachBlock(Direction::Forward, m_threads, [this](ContactBlocks& blocks, int32 i) {
        const ContactBlock* next = i + 1 < blocks.Count() ? &blocks.Contacts(i + 1) : nullptr;
        PrepareBlock(blocks.Contacts(i), blocks.Overlaps(i), next, m_context);
    });
}

/// A joint may connect groups, and a kinematic body would have to move with all of them. So a world
/// with an awake one of these is one group.
void StepSolver::FindGroups()
{
    const auto bodies = int32(m_world.awakeBodies.size());
    const bool mayDivide = bodies >= 2 * IslandGroups::kBodies && m_memory.colorCount > 0 &&
                           m_world.graph.Joints().empty();
    const std::uint64_t key =
        std::uint64_t(m_world.awakeVersion) + std::uint64_t(m_world.islands.Version());
    if (!mayDivide)
    {
        m_memory.groups.Join(bodies);
    }
    else if (!m_memory.groups.Keep(key))
    {
        FindIslands();
        m_memory.groups.Divide(m_memory.islands, bodies, key);
    }
    m_group.endBody = bodies;
}

void StepSolver::FindIslands()
{
    if (!m_foundIslands)
    {
        m_memory.islands.Find(m_world);
        m_group.endIsland = m_memory.islands.Count();
        m_foundIslands = true;
    }
}

void StepSolver::WarmStart()
{
    ForEachBlock(Direction::Forward, m_threads, [this](ContactBlocks& blocks, int32 i) {
        WarmStartBlock(blocks.Contacts(i), m_context.bodies);
    });
    m_memory.joints.Prepare(m_context, m_threads);
}

/// Assigns blocks again, unless those of the last step are still valid. A listener may change any
/// contact's form at any time.
void StepSolver::AssignBlocks(int32 color)
{
    const bool sharesBodies = color == ConstraintGraph::kOverflow;
    ConstraintGraph& graph = m_world.graph;
    const ConstraintGraph::Change change = graph.ChangeOf(color);
    const IslandGroups& groups = m_memory.groups;
    if (change == ConstraintGraph::Change::Contacts || groups.HasChanged())
    {
        m_memory.contacts[color].Sort(graph.Contacts(color), sharesBodies, groups,
                                      m_world.awakeBodies.size());
    }
    if (change != ConstraintGraph::Change::None || groups.HasChanged() ||
        m_world.listener != nullptr)
    {
        m_memory.contacts[color].Assign(sharesBodies);
    }
    graph.Settle(color);
}

// Blocks of a colour share no bodies. The direction within a colour matters only for the overflow,
// which is one part.

/// False if no impulse changed a speed by more than `unchanged` [m/s].
bool StepSolver::SolveContacts(Direction direction, float32 unchanged)
{
    std::atomic<bool> changed = false;
    ForEachBlock(direction, m_threads, [&](ContactBlocks& blocks, int32 i) {
        const bool some = SolveBlock(blocks.Contacts(i), m_context.bodies, unchanged);
        if (some && !changed.load(std::memory_order_relaxed))
        {
            changed.store(true, std::memory_order_relaxed);
        }
    });
    return changed;
}

/// Returns the minimum separation [m], at most 0.
float32 StepSolver::SolveOverlaps(Direction direction, PushPace pace)
{
    std::atomic<float32> smallest = 0.0f;
    ForEachBlock(direction, m_threads, [&](ContactBlocks& blocks, int32 i) {
        const float32 found =
            SolveBlock(blocks.Overlaps(i), blocks.Contacts(i).masses, m_context.bodies, pace);
        float32 before = smallest.load(std::memory_order_relaxed);
        while (found < before && !smallest.compare_exchange_weak(before, found))
        {}
    });
    return smallest;
}

void StepSolver::SolveVelocities(int32 iterations)
{
    for (int32 i = 0; i < iterations; ++i)
    {
        m_memory.joints.SolveVelocities(m_context, m_threads);
        const bool changed =
            SolveContacts(ColorDirectionOf(i, iterations, m_world.directionReversed));
        // After an iteration that changed nothing, none changes anything. Joints do not report it.
        if (!changed && m_memory.joints.IsEmpty())
        {
            break;
        }
    }
}

void StepSolver::StoreImpulses()
{
    m_memory.joints.StoreImpulses(m_threads);
    ForEachBlock(Direction::Forward, m_threads, [](ContactBlocks& blocks, int32 i) {
        if (i + 1 < blocks.Count())
        {
            ReadAhead(blocks.Contacts(i + 1));
        }
        box2d::StoreImpulses(blocks.Contacts(i));
    });
}

/// In the order of the colours; notes all contacts before any body falls asleep.
void StepSolver::NoteImpulses()
{
    m_memory.reported.clear();
    for (int32 i = 0; i < ConstraintGraph::kColorCount && m_world.listener != nullptr; ++i)
    {
        const int32 color = i == 0 ? ConstraintGraph::kOverflow : i - 1;
        for (b2Contact* contact : m_world.graph.Contacts(color))
        {
            if (contact->IsEnabled() && Data(*contact).manifold.pointCount > 0)
            {
                m_memory.reported.push_back(contact);
            }
        }
    }
}

void StepSolver::ReportImpulses()
{
    for (b2Contact* contact : m_memory.reported)
    {
        if (m_world.listener != nullptr) // it may remove itself
        {
            ReportImpulse(*m_world.listener, *contact, m_memory.corners.impulses);
        }
    }
    m_memory.corners.impulses.clear();
}

/// Call with -1 before pushes and with 1 after them.
void StepSolver::NotePushes(float32 sign)
{
    if (!m_memory.pushed.empty())
    {
        ForBodies([this, sign](std::size_t i) {
            m_memory.pushed[i + 1] += sign * m_memory.bodies[i + 1].d;
        });
    }
}

void StepSolver::SolvePositions(int32 iterations)
{
    for (int32 i = 0; i < iterations; ++i)
    {
        NotePushes(-1.0f);
        const bool apart = SolveOverlaps(DirectionOf(i), {b2_baumgarte}) >= -kImpactOverlap;
        NotePushes(1.0f);
        const bool joined = m_memory.joints.SolvePositions(m_context, m_threads);
        if (apart && joined)
        {
            break;
        }
    }
    if (!m_memory.joints.IsEmpty())
    {
        TurnAsSeen();
    }
}

/// A correction of poses rotates to first order: by the arc tangent of the computed angle. Far out
/// on a lever such angles are large. A body that ends elsewhere than the iterations expected would
/// be rotated again in every following step.
void StepSolver::TurnAsSeen()
{
    // [rad]: an angle and its arc tangent then differ by 0.25^3 / 3 = 0.005 rad, far below the
    // angular slop of 0.035 rad. Without this rule rods of 100:1 open by 17 times their length
    // (docs/notes/tuned-constants.md).
    constexpr float32 kSmallTurn = 0.25f;
    ForBodies([this](std::size_t i) {
        SolverBody& s = m_memory.bodies[i + 1];
        const float32 drift = m_context.timeStep * s.w;
        if (b2Abs(s.angle - drift) > kSmallTurn)
        {
            s.angle = drift + b2MulT(b2Rot(drift), s.q).GetAngle();
        }
    });
}

void StepSolver::IntegratePositions()
{
    ParallelFor(m_threads, m_group.endBody - m_group.firstBody, kBodyGrain,
                [this](int32 begin, int32 end) {
                    MoveByVelocity(&m_memory.bodies[std::size_t(m_group.firstBody + begin) + 1],
                                   end - begin, m_context.timeStep, kMaxMove);
                });
}

void StepSolver::WriteBack()
{
    m_memory.left.resize(m_world.awakeBodies.size());
    ForBodies([this](std::size_t i) {
        m_memory.left[i] = WriteBack(Data(*m_world.awakeBodies[i]), m_memory.bodies[i + 1]);
    });
    const auto left = std::ranges::count_if(m_memory.left, [](uint8 has) { return has != 0; });
    const auto isBullet = [](const b2Body* body) {
        return (Data(*body).flags & kBodyPathBox) != 0;
    };
    const auto bullets =
        m_world.hasBullets ? std::ranges::count_if(m_world.awakeBodies, isBullet) : 0;
    m_world.proxies.BeginMoves(int32(left), int32(bullets));
    for (std::size_t i = 0; i < m_memory.left.size(); ++i)
    {
        if (m_memory.left[i] != 0)
        {
            MoveProxies(m_world.proxies, Data(*m_world.awakeBodies[i]));
        }
    }
    m_world.proxies.EndMoves();
}

/// True if a shape has left its box.
bool StepSolver::WriteBack(BodyData& body, SolverBody& s) const
{
    if (!IsFinite(s))
    {
        s = SolverBody(); // stop instead of becoming non-finite
    }
    body.sleepTime =
        SleepTimeAfter(body, s, {m_context.timeStep, m_world.settings.subStepCount > 1});
    body.linearVelocity = s.v;
    body.angularVelocity = s.w;
    body.flags &= ~std::uint32_t(kBodyBoxMoved);
    body.previous = body.pose;
    body.sweepStart = 0.0f;
    ++body.sweepVersion;
    if (s.d == b2Vec2(0.0f, 0.0f) && s.angle == 0.0f)
    {
        return false;
    }
    const float32 room = body.room;
    body.pose.x += double(s.d.x);
    body.pose.y += double(s.d.y);
    body.pose.angle += double(s.angle);
    s.angle == 0.0f ? SynchronizePlace(body) : SynchronizePose(body);
    // The actual displacement: far from the origin, or after many turns, a pose is coarser than a
    // step.
    const b2Vec2 moved(float32(body.pose.x - body.previous.x),
                       float32(body.pose.y - body.previous.y));
    const float32 turned = b2Abs(float32(body.pose.angle - body.previous.angle));
    const float32 path = moved.Length() + turned * body.maxExtent;
    const bool fast = path > kFastShare * body.minExtent;
    if (path < room && !(fast && (body.flags & kBodyBullet) != 0))
    {
        body.room = room - path; // no shape can have left its box
        return false;
    }
    return RefreshBoxes(body, fast);
}

void StepSolver::LetRest()
{
    if (!m_world.settings.allowSleep)
    {
        return;
    }
    for (std::size_t i = m_world.awakeBodies.size(); i-- > 0;)
    {
        b2Body* body = m_world.awakeBodies[i];
        const BodyData& data = Data(*body);
        m_world.islands.ReportSleepTime(data);
        if (data.mobility == Mobility::Kinematic && data.sleepTime >= b2_timeToSleep)
        {
            PutToSleep(m_world, *body);
        }
    }
    for (const int32 island : m_world.islands.FindSleepy(b2_timeToSleep))
    {
        PutToSleep(m_world, island);
    }
}

} // namespace box2d
