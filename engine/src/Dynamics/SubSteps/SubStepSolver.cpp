// SPDX-License-Identifier: MIT
#include "SubStepSolver.h"
#include "../Solver/Motion.h"
#include "../Solver/OverlapSolver.h"

#include "../Energy/EnergyGuard.h"
#include "../Solver/Bouncer.h"
#include "../State/Access.h"
#include "../State/ProfileScope.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2TimeStep.h>

#include <span>

/// A step in n sub-steps (Macklin et al., "Small Steps in Physics Simulation", 2019). Contacts are
/// found once. Then velocities and positions alternate, staggered by half a sub-step: the leapfrog
/// scheme (Hairer, Lubich, Wanner, "Geometric Numerical Integration", 2006, I.1.4). Velocity
/// updates are called kicks, position updates drifts. The order is half a kick, drifts alternating
/// with whole kicks, half a kick:
///   v += a h/2;  n times { x += v h;  v += a h, the last time a h/2 }
/// The scheme is of second order, and free flight is exact. Bodies at rest get no velocity, because
/// constraints balance each kick at once. Joints close by impulses along their directions before
/// the drift, which conserves energy (SHAKE: Ryckaert, Ciccotti, Berendsen, 1977; RATTLE: Andersen,
/// 1983).
namespace box2d
{

namespace
{

/// Without a warm start: the manual's number of a whole step. With 1 and 64 no test fails; with 64
/// forty boxes rest after 6.4 s instead of 3.9 (docs/notes/tuned-constants.md).
constexpr int32 kMinColdIterations = 8;
/// Maximum speed at which a contact pushes out an initial overlap [m/s]: 5 cm a frame. A higher
/// speed looks like a jump (Catto, "Solver2D", 2024, has a similar bound). Of card houses with
/// overlaps, at 24 places, 4 fall with it, 11 and 23 with 1 and 0.3
/// (docs/notes/sub-steps-overlaps.md).
constexpr float32 kPushSpeed = 3.0f;

/// From this number of sub-steps, if it is even, overlaps are pushed out after every second one, as
/// far as two pushes would go. With 2 sub-steps that would be one push a step; with 8 two pushes a
/// step throw a box that is pressed against a wall (docs/notes/sub-steps-overlaps.md).
constexpr int32 kManySubSteps = 4;

/// Overlaps up to this are left alone [m]. Less than kMaxOverlap by the rounding of a measurement.
constexpr float32 kUnpushed = 0.998f * ContactSystem::kMaxOverlap;
/// Overlaps are measured again once a body has moved this far [m]. What turns by less is too little
/// for a shorter lever to matter. It only saves time: no verdict changes with 0 or with ten times
/// as much.
constexpr float32 kUnmoved = 0.01f * b2_linearSlop;

/// The iterations of a kick reverse their direction once, as in a whole step. The next kick starts
/// in the direction in which this one ended. A kick of one iteration reverses with every second
/// kick, which is equivalent.
Direction KickDirectionOf(int32 kick, int32 iteration, int32 count, bool turned)
{
    if (count > 1)
    {
        return ColorDirectionOf(iteration, count, turned != (kick % 2 == 1));
    }
    return ((kick + 1) / 2 % 2 == 1) == turned ? Direction::Forward : Direction::Backward;
}

/// True if a contact of the block must bounce. Its bias is ignored then, because Bounce applies it.
bool TakeBias(ContactBlock& block)
{
    const bool any = block.bounces;
    block.bounces = false;
    return any;
}

/// Stores the fraction of each contact's impulses that the end of the step applied: an impact is
/// over. As in a kick's start, it includes half of the last kick's change.
void NoteLastShare(const ContactBlock& block, const BlockTotals& totals)
{
    for (int32 lane = 0; lane < block.count; ++lane)
    {
        float32 last = 0.0f;
        float32 all = 0.0f;
        for (int32 i = 0; i < block.pointCount; ++i)
        {
            last += 0.5f * (block.points[i].normalImpulse[lane] + totals.firstNormal[i][lane]);
            all += totals.normal[i][lane];
        }
        Data(*block.contact[lane]).lastShare = all > 0.0f ? b2Min(last / all, 1.0f) : 0.0f;
    }
}

void TakeTotals(ContactBlock& block, const BlockTotals& totals)
{
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        for (int32 lane = 0; lane < kBlockLanes; ++lane)
        {
            block.points[i].normalImpulse[lane] = totals.normal[i][lane];
            block.points[i].tangentImpulse[lane] = totals.tangent[i][lane];
        }
    }
}

/// Bodies without joints and contacts move through the step at once, with less cost and rounding.
BodyMode ModeOf(const BodyData& body)
{
    if (!body.IsDynamic() || body.colorMask != 0 || body.linearDamping != 0.0f ||
        body.angularDamping != 0.0f)
    {
        return BodyMode::Together;
    }
    return body.jointList == nullptr ? BodyMode::Flies : BodyMode::OnJoints;
}

} // namespace

void SolveInSubSteps(World& world, float32 timeStep, int32 velocityIterations,
                     int32 positionIterations)
{
    const int32 count = world.settings.subStepCount;
    const float32 h = timeStep / float32(count);
    const int32 kickIterations = b2IterationsOfASubStep(velocityIterations, count);
    const int32 pushIterations = b2IterationsOfASubStep(positionIterations, count);
    const int32 pushEvery = count >= kManySubSteps && count % 2 == 0 ? 2 : 1;
    // Overlaps go at the same pace for every number of sub-steps: a faster one adds energy.
    // A push after every second sub-step goes as far as two.
    const float32 each =
        b2_baumgarte * b2Min(1.0f, float32(b2Max(1, positionIterations)) / float32(count));
    const float32 rate = pushEvery == 2 ? each * (2.0f - each) : each;
    SubStepSolver solve(world, timeStep);
    {
        ProfileScope init(world.profiling, world.profile.solveInit);
        solve.SortBodies();
        solve.WakeJointNeighbours();
        solve.Begin(count);
        world.energyGuard->Begin(world, *world.solver, timeStep);
    }
    const bool together = solve.AnyTogether();
    ForGroups(solve, [&](SubStepSolver& group) {
        const auto kick = [&](float32 duration, float32 share) {
            ProfileScope velocity(group.IsProfiling(), world.profile.solveVelocity);
            group.Kick(duration, share, kickIterations);
        };
        if (together)
        {
            kick(0.5f * h, 1.0f);
        }
        for (int32 i = 1; i <= count && together; ++i)
        {
            {
                ProfileScope position(group.IsProfiling(), world.profile.solvePosition);
                group.Drift(h);
                if (i % pushEvery == 0)
                {
                    group.MoveApart(float32(pushEvery) * h, pushIterations, rate);
                }
                group.CloseAfterPushes(pushIterations);
            }
            const bool last = i == count;
            // From half a kick to a whole one, and back.
            kick(last ? 0.5f * h : h, (i == 1 ? 2.0f : 1.0f) * (last ? 0.5f : 1.0f));
        }
        group.StoreImpulses();
    });
    world.directionReversed =
        kickIterations > 1 ? (count % 2 == 0) != world.directionReversed : !world.directionReversed;
    {
        ProfileScope position(world.profiling, world.profile.solvePosition);
        solve.End();
    }
    solve.NoteImpulses();
    world.energyGuard->Balance(world, *world.solver);
    solve.WriteBack();
    solve.LetRest();
    solve.ReportImpulses();
}

SubStepSolver::SubStepSolver(World& world, float32 timeStep)
    : StepSolver(world, timeStep), m_subSteps(*world.subSteps)
{}

void SubStepSolver::Begin(int32 count)
{
    const float32 toHalfKick = 0.5f / float32(count);
    const bool wereSmall = m_world.lastSubSteps > 1;
    const float32 wholeRatio = m_context.stepRatio;
    // From the last half kick to the first.
    m_context.stepRatio *= wereSmall ? float32(m_world.lastSubSteps) / float32(count) : toHalfKick;
    m_context.warmStartsLastShare = wereSmall;
    m_world.lastSubSteps = count;
    m_memory.bodies.resize(m_world.awakeBodies.size() + 1);
    m_memory.bodies[0] = SolverBody();
    m_subSteps.kicks.resize(m_world.awakeBodies.size());
    m_subSteps.modes.resize(m_world.awakeBodies.size());
    m_subSteps.beforePushes.resize(m_memory.bodies.size());
    m_context.bodies = m_memory.bodies.data();
    ForBodies([this](std::size_t i) {
        const BodyData& body = Data(*m_world.awakeBodies[i]);
        SolverBody& s = m_memory.bodies[i + 1];
        s = SolverBody();
        s.v = body.linearVelocity;
        s.w = body.angularVelocity;
        m_subSteps.kicks[i] = BodyKick(body, m_world.settings.gravity);
        m_subSteps.modes[i] = ModeOf(body);
    });
    m_context.middle = 0.5f * m_context.timeStep;
    HoldOverflow();
    AssignContacts();
    PrepareContacts();
    for (int32 i = 0; i < m_memory.colorCount; ++i)
    {
        m_memory.contacts[m_memory.colors[i]].ClearTotals();
    }
    m_subSteps.firstLoads.Find(m_world, m_memory, 0.5f * m_context.timeStep / float32(count));
    Bounce();
    m_context.inverseStep *= float32(count);
    m_subSteps.joints.Update(m_world.graph, m_world.awakeVersion);
    if (m_memory.colorCount > 0 || !m_subSteps.joints.IsEmpty())
    {
        FindIslands();
        m_subSteps.farthestPushes.resize(std::size_t(m_memory.islands.Count()));
        m_subSteps.contacts.CountContacts(m_memory);
    }
    m_subSteps.joints.Begin(
        m_context, m_context.warmStarting ? wholeRatio * toHalfKick : 0.0f, m_world.inverseStep,
        m_subSteps.kicks.data(), m_threads, [this](const BodyData& body) {
            return m_subSteps.contacts.IsLarge(m_memory.islands.Of(body.SolverIndex()));
        });
    if (AnyHeld())
    {
        m_subSteps.warmStartGuard.Begin(m_memory, m_subSteps.joints, m_subSteps.contacts);
    }
    m_subSteps.contacts.Begin(m_memory, m_subSteps.joints);
    if (m_threads != nullptr && m_memory.groups.Count() > 1)
    {
        m_subSteps.contacts.FollowAll(m_memory, m_subSteps.joints);
    }
    m_subSteps.joints.ForTreeBodies([this](const BodyData& body) {
        m_subSteps.modes[std::size_t(body.awakeIndex)] = BodyMode::InTree;
    });
}

/// Applies restitution pair by pair until no contact approaches fast: a row of balls passes the
/// impulse on (sequential impacts; Chatterjee and Ruina, "A New Algebraic Rigid-Body Collision
/// Law", 1998).
void SubStepSolver::Bounce()
{
    bool any = false;
    ForEachBlock(Direction::Forward, nullptr, [&](ContactBlocks& blocks, int32 i) {
        any = TakeBias(blocks.Contacts(i)) || any;
    });
    for (int32 iteration = 0; iteration < kMaxBounces && any; ++iteration)
    {
        any = false;
        ForEachBlock(DirectionOf(iteration), nullptr, [&](ContactBlocks& blocks, int32 i) {
            ContactBlock& block = blocks.Contacts(i);
            for (int32 lane = 0; lane < block.count; ++lane)
            {
                any = (Data(*block.contact[lane]).restitution > 0.0f && Bounce(blocks, i, lane)) ||
                      any;
            }
        });
    }
}

/// False if it approaches too slowly to bounce.
bool SubStepSolver::Bounce(ContactBlocks& blocks, int32 index, int32 lane)
{
    ContactBlock& block = blocks.Contacts(index);
    if (!IsBouncing(block, lane, m_context))
    {
        return false;
    }
    const ContactData& contact = Data(*block.contact[lane]);
    JointedBounce& jointed = m_subSteps.jointedBounce;
    return (jointed.Find(contact) &&
            jointed.Bounce(block, blocks.Overlaps(index), blocks.Totals(index), lane,
                           contact.restitution, m_context)) ||
           Bouncer(block, blocks.Totals(index), lane, m_context).Bounce(contact.restitution);
}

/// True if there are contacts, or joints outside of trees.
bool SubStepSolver::AnyHeld() const
{
    return m_memory.colorCount > 0 || m_subSteps.joints.HasRows();
}

/// True if any body takes the common sub-steps.
bool SubStepSolver::AnyTogether() const
{
    return AnyHeld() || std::ranges::any_of(m_subSteps.modes, IsTogether);
}

template <class Function>
void SubStepSolver::ForTogether(Function&& function)
{
    const auto modes = std::span(m_subSteps.modes);
    const int32 first = m_group.firstBody;
    ParallelFor(m_threads, m_group.endBody - first, kBodyGrain, [&](int32 begin, int32 end) {
        const auto last = modes.begin() + first + end;
        for (auto from = modes.begin() + first + begin; from != last;)
        {
            from = std::find_if(from, last, IsTogether);
            const auto to = std::find_if_not(from, last, IsTogether);
            const auto index = std::size_t(from - modes.begin());
            function(m_memory.bodies.data() + index + 1, m_subSteps.kicks.data() + index,
                     int32(to - from));
            from = to;
        }
    });
}

void SubStepSolver::Kick(float32 duration, float32 share, int32 iterations)
{
    JointSystem& joints = m_subSteps.joints;
    SolverContext kick = m_context;
    kick.timeStep = duration;
    joints.Prepare(kick); // before the kick: springs use these velocities
    ForTogether([&](SolverBody* bodies, const BodyKick* kicks, int32 count) {
        GiveKicks(bodies, kicks, count, duration);
    });
    WarmStartGuard& guard = m_subSteps.warmStartGuard;
    if (AnyHeld())
    {
        guard.Note(m_memory, m_group);
    }
    joints.WarmStart(kick, share);
    ForEachBlock(Direction::Forward, m_threads, [&](ContactBlocks& blocks, int32 i) {
        KickBlock(blocks.Contacts(i), blocks.Totals(i), m_context.bodies, share, m_kick > 0);
    });
    const float32 weight = duration * m_world.settings.gravity.Length();
    const float32 unchanged = ContactSystem::kTolerance * weight;
    bool balanced = Iterate(iterations, unchanged);
    // Balanced contacts only lower the energy.
    if (!(balanced && !joints.HasRows()) && AnyHeld() &&
        guard.HasGained(m_memory, m_group, m_subSteps.kicks.data(), joints))
    {
        guard.Restore(m_memory, m_group);
        joints.StartAgain(kick,
                          [&](const RowSides& sides) { return guard.HasGained(m_memory, sides); });
        balanced = Iterate(b2Max(iterations, kMinColdIterations), unchanged);
    }
    ++m_kick;
    if (balanced)
    {
        m_subSteps.contacts.NoteBalance(m_group);
    }
    else
    {
        // The only iteration solved friction by the normal impulses of the kick before.
        if (iterations == 1)
        {
            ForEachBlock(Direction::Forward, m_threads, [&](ContactBlocks& blocks, int32 i) {
                LimitFriction(blocks.Contacts(i), m_context.bodies);
            });
        }
        m_subSteps.contacts.SolveVelocities(m_memory, m_group, m_subSteps.joints, m_context,
                                            weight);
    }
}

/// `unchanged`: see SolveBlock. True if there are contacts, and the last iteration did not change
/// them.
bool SubStepSolver::Iterate(int32 iterations, float32 unchanged)
{
    JointSystem& joints = m_subSteps.joints;
    for (int32 i = 0; i < iterations; ++i)
    {
        joints.SolveVelocities(m_context, i == 0);
        const bool changed = SolveContacts(
            KickDirectionOf(m_kick, i, iterations, m_world.directionReversed), unchanged);
        if (!changed && joints.IsExact())
        {
            return m_memory.colorCount > 0;
        }
    }
    return false;
}

/// Contacts in the overflow have no colour, so ModeOf does not see them.
void SubStepSolver::HoldOverflow()
{
    for (b2Contact* contact : m_world.graph.Contacts(ConstraintGraph::kOverflow))
    {
        for (const b2Body* body : {Data(*contact).bodyA, Data(*contact).bodyB})
        {
            if (Data(*body).awakeIndex != -1)
            {
                m_subSteps.modes[std::size_t(Data(*body).awakeIndex)] = BodyMode::Together;
            }
        }
    }
}

/// x += v h + a h^2 / 2
void SubStepSolver::Fly(std::size_t index)
{
    SolverBody& s = m_memory.bodies[index + 1];
    const float32 h = m_context.timeStep;
    const b2Vec2 a = m_subSteps.kicks[index].acceleration;
    const float32 alpha = m_subSteps.kicks[index].angularAcceleration;
    const b2Vec2 after = Bounded(s.v + h * a);
    s.v += (0.5f * h) * a;
    s.w += (0.5f * h) * alpha;
    const SolverBody middle = s;
    for (int32 i = 0; i < m_world.settings.subStepCount; ++i)
    {
        MoveByVelocity(s, h / float32(m_world.settings.subStepCount), kMaxSmallMove);
    }
    s.v = s.v == middle.v ? after : Bounded(s.v + (0.5f * h) * a); // it may have been limited
    s.w = Bounded(s.w + (0.5f * h) * alpha);
}

void SubStepSolver::Drift(float32 timeStep)
{
    m_subSteps.joints.NotePoses(m_context);
    ForTogether([&](SolverBody* bodies, const BodyKick*, int32 count) {
        MoveByVelocity(bodies, count, timeStep, kMaxSmallMove);
    });
    m_subSteps.joints.SolvePositions(m_context, timeStep, m_subSteps.kicks.data());
    m_subSteps.joints.NotePoses(m_context);
}

/// True if no overlap can have become deep enough for a push since the last measurement.
bool SubStepSolver::AreStillApart() const
{
    if (m_measured < -kUnpushed)
    {
        return false;
    }
    const std::size_t first = std::size_t(m_group.firstBody);
    const float32 far =
        FarthestPush(m_subSteps.beforePushes.data() + first + 1, m_memory.bodies.data() + first + 1,
                     m_subSteps.kicks.data() + first, m_group.endBody - m_group.firstBody);
    return far <= kUnmoved && m_measured - 2.0f * far >= -kUnpushed;
}

void SubStepSolver::MoveApart(float32 timeStep, int32 iterations, float32 rate)
{
    if (AreStillApart())
    {
        return;
    }
    const int32 first = m_group.firstBody + 1;
    std::copy_n(m_memory.bodies.begin() + first, m_group.endBody - m_group.firstBody,
                m_subSteps.beforePushes.begin() + first);
    // The iterations and the solution after them take equal parts of the push.
    const float32 maximum =
        b2Min(kPushSpeed * timeStep / float32(iterations + 1), b2_maxLinearCorrection);
    float32 deepest = 0.0f;
    float32 found = 0.0f;
    for (int32 i = 0; i < iterations; ++i)
    {
        found = SolveOverlaps(DirectionOf(i), {rate, maximum});
        deepest = b2Min(deepest, found);
        if (found >= -b2_linearSlop)
        {
            break;
        }
    }
    m_measured = deepest;
    if (found < -ContactSystem::kMaxOverlap)
    {
        m_subSteps.contacts.SolveOverlaps(m_memory, m_group, m_subSteps.joints, m_context,
                                          {b2_baumgarte * timeStep / m_context.timeStep, maximum});
    }
    if (deepest < -b2_linearSlop)
    {
        LimitPushes(kFarthestPush * timeStep);
        if (!m_memory.pushed.empty())
        {
            for (int32 i = first; i < first + m_group.endBody - m_group.firstBody; ++i)
            {
                m_memory.pushed[std::size_t(i)] +=
                    m_memory.bodies[std::size_t(i)].d - m_subSteps.beforePushes[std::size_t(i)].d;
            }
        }
    }
}

/// Scales all pushes of an island equally, so that no point of its bodies moves further than
/// `maximum` [m]. Directions are kept, and points that separate still do.
void SubStepSolver::LimitPushes(float32 maximum)
{
    const int32 first = m_group.firstBody;
    const int32 count = m_group.endBody - first;
    if (!(FarthestPush(m_subSteps.beforePushes.data() + first + 1,
                       m_memory.bodies.data() + first + 1, m_subSteps.kicks.data() + first,
                       count) > maximum))
    {
        return;
    }
    std::fill(m_subSteps.farthestPushes.begin() + m_group.firstIsland,
              m_subSteps.farthestPushes.begin() + m_group.endIsland, 0.0f);
    const auto forPushed = [&](auto&& function) {
        for (const b2Body* body :
             std::span(m_world.awakeBodies).subspan(std::size_t(first), std::size_t(count)))
        {
            const int32 i = Data(*body).SolverIndex();
            const int32 island = m_memory.islands.Of(i);
            if (island != -1)
            {
                function(Data(*body), m_subSteps.farthestPushes[std::size_t(island)],
                         m_subSteps.beforePushes[std::size_t(i)], m_memory.bodies[std::size_t(i)]);
            }
        }
    };
    bool any = false;
    forPushed([&](const BodyData& body, float32& far, const SolverBody& before, SolverBody& s) {
        const float32 path = PushOf(before, s, body.maxExtent);
        far = b2Max(far, path);
        any = any || path > maximum;
    });
    if (!any)
    {
        return;
    }
    forPushed([&](const BodyData&, float32 far, const SolverBody& before, SolverBody& s) {
        if (far > maximum)
        {
            ShortenPush(before, s, maximum / far);
        }
    });
}

/// Stores the impulses of the group's contacts.
void SubStepSolver::StoreImpulses()
{
    ForEachBlock(Direction::Forward, m_threads, [&](ContactBlocks& blocks, int32 i) {
        if (i + 1 < blocks.Count())
        {
            ReadAhead(blocks.Contacts(i + 1));
        }
        AddToTotals(blocks.Contacts(i), blocks.Totals(i));
        NoteLastShare(blocks.Contacts(i), blocks.Totals(i));
        TakeTotals(blocks.Contacts(i), blocks.Totals(i));
        box2d::StoreImpulses(blocks.Contacts(i));
    });
}

void SubStepSolver::End()
{
    ForBodies([this](std::size_t i) {
        if (m_subSteps.modes[i] == BodyMode::Flies)
        {
            Fly(i);
        }
    });
    const float32 step = m_context.timeStep;
    const float32 last = m_world.inverseStep > 0.0f ? 1.0f / m_world.inverseStep : step;
    m_subSteps.joints.StepTrees(step, m_world.settings.subStepCount, last);
    m_subSteps.joints.End();
}

} // namespace box2d
