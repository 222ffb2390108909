// SPDX-License-Identifier: MIT
#include "Impact.h"
#include "../Solver/Motion.h"
#include "../Solver/OverlapSolver.h"

#include "../Energy/EnergyGuard.h"
#include "../Islands/Sleep.h"
#include "../Solver/Bouncer.h"
#include "../Solver/StepSolver.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "../SubSteps/SubStepMemory.h"
#include "ImpactMemory.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

/// Maximum number of position iterations at an impact. They end at 1.5 slops of overlap, half of
/// the three at which impacts are found, so that the next search does not find the same impact. A
/// single contact needs one or two iterations (0.75 each); up to 32 contacts share an impact. A
/// bound: with 2, 5 and 80 no test fails. With 0, 16 of 80 random worlds gain energy (2 sub-steps).
/// With an end at 1 slop a random world gains 0.6 % of energy. With 3 slops a box that spins into a
/// corner loses 0.08 %.
constexpr int32 kImpactPositionIterations = 20;

/// Newton's restitution at all points at once conserves the energy of frictionless bounces, if it
/// is solved (the LCP of Smith et al., "Reflections on Simultaneous Impact", 2012). For one body
/// between two walls the solver iterates until convergence, at most this often. An iteration in the
/// same direction leaves the square of the cosine of the walls' angle. After n of them a ball on
/// the axis keeps (1 - 2 cos^2n)^2 of its energy. In a wedge of 10 degrees that is 52 % with
/// 64, 99.8 with 256, and all with this many. Measured is the same within 1 %
/// (docs/notes/tuned-constants.md).
constexpr int32 kCornerIterations = 1024;

/// Joints take part in an impact if it turns no body by more than this in the rest of the step
/// [rad]. With 0.5 the hinges of 2 of 144 rooms of elastic ragdolls open by up to 10 cm, with 0.2
/// of 3 by 3 cm, with 1 of none by 1 cm (docs/notes/sub-steps-impacts.md).
constexpr float32 kMaxJoinedTurn = 1.0f;

bool IsWithGround(const ContactData& c)
{
    return !Data(*c.bodyA).IsDynamic() || !Data(*c.bodyB).IsDynamic();
}

bool Bounces(const ContactBlock& c)
{
    return c.bounces &&
           std::any_of(c.bias, c.bias + c.pointCount,
                       [](const float32(&bias)[kBlockLanes]) { return bias[0] > 0.0f; });
}

/// Position correction then moves only these two bodies. Blocks must be prepared again before
/// velocities are solved.
void HoldOthers(OverlapBlock& o, MassLanes& masses, int32 indexA, int32 indexB)
{
    if (o.bodyA[0] != indexA && o.bodyA[0] != indexB)
    {
        masses.invMassA[0] = masses.invInertiaA[0] = 0.0f;
        o.movesA = 0;
    }
    if (o.bodyB[0] != indexA && o.bodyB[0] != indexB)
    {
        masses.invMassB[0] = masses.invInertiaB[0] = 0.0f;
        o.movesB = 0;
    }
}

} // namespace

Impact::Impact(World& world, float32 timeStep, int32 velocityIterations)
    : m_world(world), m_memory(*world.impacts), m_solver(*world.solver),
      m_velocityIterations(velocityIterations), m_context(MakeContext(world, timeStep)),
      m_bodies(m_memory.bodies), m_falling(m_memory.falling), m_contacts(m_memory.contacts),
      m_bounced(m_memory.bounced), m_depths(m_memory.depths)
{
    m_context.warmStarting = false;
}

/// With sub-steps a freely falling body's path is a parabola; only the velocity is known at every
/// time.
b2Vec2 Impact::AccelerationOf(const BodyData& body) const
{
    const SubStepMemory& steps = *m_world.subSteps;
    const bool stepped = m_world.settings.subStepCount > 1 && body.IsDynamic() &&
                         body.awakeIndex != -1 && std::size_t(body.awakeIndex) < steps.modes.size();
    const bool known = stepped && (steps.modes[std::size_t(body.awakeIndex)] == BodyMode::Flies ||
                                   std::ranges::find(m_falling, &body) != m_falling.end());
    return known ? steps.kicks[std::size_t(body.awakeIndex)].acceleration : b2Vec2(0.0f, 0.0f);
}

/// True if a contact of the body has reached its maximum number of impacts in this step. The body
/// then stays at its pose for the rest of the step, because otherwise it would pass through the
/// obstacle. It loses time, but no velocity.
bool Impact::IsSpent(b2Body& body)
{
    for (b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        const ContactData& c = Data(*edge->contact);
        if (c.toiCount >= b2_maxSubSteps && c.IsEnabled() && c.IsTouching() && !c.IsSensor())
        {
            return true;
        }
    }
    return false;
}

/// A heavy body that presses a light one into a wall outweighs it, and a few iterations over all
/// contacts leave it there. So overlaps with bodies that cannot be moved are solved again at the
/// end, alone: the heavy body overlaps then. Used with sub-steps only.
void Impact::PutGroundLast()
{
    auto ground = m_contacts.begin(); // a stable partition without memory of its own
    for (auto it = ground; it != m_contacts.end(); ++it)
    {
        if (!IsWithGround(Data(**it)))
        {
            std::rotate(ground, it, it + 1);
            ++ground;
        }
    }
    const bool mixed = ground != m_contacts.begin();
    m_ground = mixed ? std::size_t(ground - m_contacts.begin()) : m_contacts.size();
}

void Impact::LoadBodies()
{
    m_solver.bodies.resize(m_world.awakeBodies.size() + 1);
    m_context.bodies = m_solver.bodies.data();
    m_solver.bodies[0] = SolverBody();
    for (const b2Body* body : m_bodies)
    {
        const BodyData& data = Data(*body);
        if (data.awakeIndex != -1)
        {
            SolverBody s;
            s.v = data.linearVelocity;
            s.w = data.angularVelocity;
            m_solver.bodies[std::size_t(data.SolverIndex())] = s;
        }
    }
}

/// Contacts of an impact share a body, so each is a block of its own.
void Impact::Prepare()
{
    LoadBodies();
    if (m_memory.impulses.size() < m_contacts.size())
    {
        m_memory.impulses.resize(m_contacts.size());
        m_memory.overlaps.resize(m_contacts.size());
    }
    for (std::size_t i = 0; i < m_contacts.size(); ++i)
    {
        PrepareAlone(*m_contacts[i], m_memory.impulses[i], m_memory.overlaps[i], m_context);
    }
}

std::span<ContactBlock> Impact::Impulses() const
{
    return std::span(m_memory.impulses).first(m_contacts.size());
}

/// Returns the depth of a point of an event's contact below the surfaces [m]; negative above. The
/// skins of polygons and edges are not included.
float32 Impact::DepthOf(std::size_t contact, int32 point) const
{
    const ContactData& c = Data(*m_contacts[contact]);
    float32 skins = 0.0f;
    skins += c.FixtureA()->GetType() == b2Shape::e_circle ? 0.0f : c.radiusA;
    skins += c.FixtureB()->GetType() == b2Shape::e_circle ? 0.0f : c.radiusB;
    return -skins -
           MeasureOverlap(m_memory.overlaps[contact], 0, point, m_context.bodies).separation;
}

void Impact::NoteDepths()
{
    m_depths.clear();
    for (std::size_t i = 0; i < m_contacts.size() && m_world.settings.subStepCount > 1; ++i)
    {
        for (int32 k = 0; k < 2; ++k)
        {
            m_depths.push_back(k < m_memory.impulses[i].pointCount ? DepthOf(i, k) : 0.0f);
        }
    }
}

/// Returns the maximum energy that this adds.
double Impact::CorrectBounces()
{
    double added = 0.0;
    for (std::size_t i = 0; i < m_contacts.size() && !m_depths.empty(); ++i)
    {
        added += CorrectBounce(i);
    }
    return added;
}

/// An impact is found and resolved a little below the surfaces. Freely falling bodies have gained
/// speed since they met, and lose it again. With the depths d before and d' after position
/// correction, and a the relative acceleration:
///   u^2 = v^2 - 2 a d,    v'^2 = e^2 u^2 + 2 a d'.
double Impact::CorrectBounce(std::size_t index)
{
    double added = 0.0;
    ContactBlock& c = m_memory.impulses[index];
    const ContactData& data = Data(*m_contacts[index]);
    const b2Vec2 apart = AccelerationOf(Data(*data.bodyB)) - AccelerationOf(Data(*data.bodyA));
    const float32 a = -b2Dot(apart, b2Vec2(c.normalX[0], c.normalY[0]));
    for (int32 k = 0; k < c.pointCount; ++k)
    {
        float32& bias = c.bias[k][0];
        if (bias > 0.0f && a != 0.0f)
        {
            const float32 e = data.restitution;
            const float32 v = bias / e;
            const float32 met =
                b2Max(v * v - 2.0f * a * m_depths[2 * index + std::size_t(k)], 0.0f);
            const float32 square = b2Max(e * e * met + 2.0f * a * DepthOf(index, k), 0.0f);
            added += 0.5 * double(NormalMassOf(c, 0, k) * b2Max(square - bias * bias, 0.0f));
            bias = b2Sqrt(square);
        }
    }
    return added;
}

/// Advances for the rest of the step. With sub-steps, which allow higher speeds, the path is a
/// parabola.
void Impact::MoveOn(SolverBody& body, const b2Vec2& acceleration, float32 timeLeft) const
{
    if (m_world.settings.subStepCount == 1)
    {
        return MoveByVelocity(body, timeLeft, kMaxMove);
    }
    body.v += 0.5f * timeLeft * acceleration;
    const int32 parts = m_world.settings.subStepCount;
    for (int32 i = 0; i < parts; ++i)
    {
        MoveByVelocity(body, timeLeft / float32(parts), kMaxSmallMove);
    }
    body.v += 0.5f * timeLeft * acceleration;
}

/// An impact is found a little below the surfaces. Deeper overlaps existed before, and other
/// impacts of the step push the body as well.
void Impact::LimitPush(SolverBody& pushed, float32 maxExtent) const
{
    const float32 maximum = kFarthestPush * m_context.timeStep;
    const float32 path = PushOf(SolverBody(), pushed, maxExtent);
    if (m_world.settings.subStepCount > 1 && path > maximum)
    {
        ShortenPush(SolverBody(), pushed, maximum / path);
    }
}

/// From this contact on.
void Impact::PushApart(std::size_t first) const
{
    for (int32 i = 0; i < kImpactPositionIterations; ++i)
    {
        float32 smallest = 0.0f;
        for (std::size_t k = first; k < m_contacts.size(); ++k)
        {
            const std::size_t at =
                DirectionOf(i) == Direction::Forward ? k : m_contacts.size() - 1 - (k - first);
            smallest =
                b2Min(smallest, SolveBlock(m_memory.overlaps[at], m_memory.impulses[at].masses,
                                           m_context.bodies, {b2_toiBaugarte}));
        }
        if (smallest >= -1.5f * b2_linearSlop)
        {
            break;
        }
    }
}

/// Only the two bodies of the impact may be moved.
void Impact::SolvePositions(b2Body& bodyA, b2Body& bodyB)
{
    m_ground = m_contacts.size();
    if (m_world.settings.subStepCount > 1)
    {
        PutGroundLast();
    }
    Prepare();
    NoteDepths();
    const int32 indexA = Data(bodyA).SolverIndex();
    const int32 indexB = Data(bodyB).SolverIndex();
    for (std::size_t i = 0; i < m_contacts.size(); ++i)
    {
        HoldOthers(m_memory.overlaps[i], m_memory.impulses[i].masses, indexA, indexB);
    }
    PushApart(0);
    PushApart(m_ground);
    for (b2Body* body : {&bodyA, &bodyB})
    {
        BodyData& data = Data(*body);
        if (data.IsDynamic())
        {
            SolverBody& s = m_solver.bodies[std::size_t(data.SolverIndex())];
            if (!IsFinite(s))
            {
                continue;
            }
            LimitPush(s, data.maxExtent);
            data.pose.x += double(s.d.x);
            data.pose.y += double(s.d.y);
            data.pose.angle += double(s.angle);
            data.previous = data.pose;
            SynchronizePose(data);
        }
    }
}

/// True if one body bounces between static ones.
bool Impact::IsInCorner() const
{
    return m_contacts.size() > 1 &&
           std::count_if(m_bodies.begin(), m_bodies.end(),
                         [](const b2Body* body) { return Data(*body).IsDynamic(); }) == 1 &&
           std::ranges::any_of(Impulses(), Bounces);
}

void Impact::Sweep()
{
    // In alternating directions every second solution between two walls repeats the last one. With
    // the other direction random world 314 gains 5 % with one step.
    const bool corner = IsInCorner();
    const int32 count =
        corner ? b2Max(m_velocityIterations, kCornerIterations) : m_velocityIterations;
    for (int32 i = 0; i < count; ++i)
    {
        bool changed = false;
        const Direction direction = corner ? Direction::Backward : DirectionOf(i);
        ForEach(Impulses(), direction, [&](ContactBlock& block) {
            changed = SolveBlock(block, m_context.bodies) || changed;
        });
        if (!changed)
        {
            break;
        }
    }
}

template <class Function>
void Impact::ForMoved(Function&& function) const
{
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
    {
        const BodyData& data = Data(*m_bodies[i]);
        if (data.IsDynamic() && data.awakeIndex != -1)
        {
            function(data, m_context.bodies[data.SolverIndex()], i);
        }
    }
}

double Impact::KineticEnergyOfAll() const
{
    double sum = 0.0;
    ForMoved([&](const BodyData& body, const SolverBody& state, std::size_t) {
        sum += KineticEnergy(state, double(body.mass), double(body.inertia));
    });
    return sum;
}

/// True if restitution must not add energy. Kinematic bodies and conveyor belts may add some.
bool Impact::KeepsEnergy() const
{
    const bool driven = std::any_of(m_bodies.begin(), m_bodies.end(), [](const b2Body* body) {
        return IsMovingPlatform(Data(*body));
    });
    return !driven && std::ranges::all_of(Impulses(), [](const ContactBlock& c) {
        return c.tangentSpeed[0] == 0.0f;
    });
}

/// Newton's restitution together with friction can add energy (Kane and Levinson, "Dynamics: Theory
/// and Applications", 1985). Without restitution it never does, and a mixture of both results
/// satisfies all contact constraints. With the fraction s of restitution the energy is
///   T0 + s (T1 - T0 - D) + s^2 D,
/// where D is that of the difference of the velocities. The largest fraction that adds no energy is
/// used.
void Impact::BounceLess(double maximum)
{
    const double bouncedEnergy = KineticEnergyOfAll();
    m_bounced.resize(m_bodies.size());
    ForMoved(
        [this](const BodyData&, const SolverBody& state, std::size_t i) { m_bounced[i] = state; });
    m_memory.bouncedImpulses.assign(Impulses().begin(), Impulses().end());
    Prepare();
    for (ContactBlock& c : Impulses())
    {
        c.bounces = false;
    }
    Sweep();
    const double energy = KineticEnergyOfAll();
    double difference = 0.0;
    ForMoved([&](const BodyData& body, const SolverBody& state, std::size_t i) {
        SolverBody apart;
        apart.v = m_bounced[i].v - state.v;
        apart.w = m_bounced[i].w - state.w;
        difference += KineticEnergy(apart, double(body.mass), double(body.inertia));
    });
    if (!(difference > 0.0))
    {
        return;
    }
    const double half = 0.5 * (bouncedEnergy - energy - difference);
    const double square = half * half - difference * b2Min(energy - maximum, 0.0);
    const auto share = float32((std::sqrt(square) - half) / difference);
    ForMoved([&](const BodyData&, SolverBody& state, std::size_t i) {
        state.v += share * (m_bounced[i].v - state.v);
        state.w += share * (m_bounced[i].w - state.w);
    });
    for (std::size_t i = 0; i < m_contacts.size(); ++i)
    {
        for (int32 k = 0; k < m_memory.impulses[i].pointCount; ++k)
        {
            PointLanes& p = m_memory.impulses[i].points[k];
            const PointLanes& bounced = m_memory.bouncedImpulses[i].points[k];
            p.normalImpulse[0] += share * (bounced.normalImpulse[0] - p.normalImpulse[0]);
            p.tangentImpulse[0] += share * (bounced.tangentImpulse[0] - p.tangentImpulse[0]);
            if (!m_memory.totals.empty())
            {
                m_memory.totals[i].normal[k][0] *= share;
                m_memory.totals[i].tangent[k][0] *= share;
            }
        }
    }
}

/// Adds the change of its velocity to the path and the velocity that it had without the impact. A
/// path in sub-steps follows joints better than a straight one.
void Impact::MoveJoined(std::size_t index, float32 timeLeft)
{
    b2Body& body = *m_bodies[index];
    BodyData& data = Data(body);
    const ImpactBackup& before = m_memory.before[index];
    const SolverBody& s = m_solver.bodies[std::size_t(data.SolverIndex())];
    const b2Vec2 v = s.v - data.linearVelocity;
    const float32 w = s.w - data.angularVelocity;
    data.pose = before.pose;
    data.linearVelocity = before.v;
    data.angularVelocity = before.w;
    if (IsFinite(s) && data.IsDynamic())
    {
        data.linearVelocity += v;
        data.angularVelocity += w;
        const float32 moved = IsSpent(body) ? 0.0f : timeLeft;
        data.pose.x += double(moved * v.x);
        data.pose.y += double(moved * v.y);
        data.pose.angle += double(moved * w);
    }
    SynchronizePose(data);
}

void Impact::MoveOn(std::size_t index, float32 time)
{
    b2Body& body = *m_bodies[index];
    BodyData& data = Data(body);
    if (data.mobility == Mobility::Static || data.awakeIndex == -1)
    {
        return;
    }
    if (index >= m_memory.firstJoined)
    {
        return MoveJoined(index, (1.0f - time) * m_context.timeStep);
    }
    const ImpactBackup& before = m_memory.before[index];
    if (!data.IsDynamic() && data.linearVelocity == before.v && data.angularVelocity == before.w)
    {
        // Restored exactly: the rest of an interrupted step may have another length, and the sum of
        // its parts rounds differently.
        data.pose = before.pose;
        SynchronizePose(data);
        return;
    }
    SolverBody& s = m_solver.bodies[std::size_t(data.SolverIndex())];
    const bool wasStopped = data.sweepStart == time;
    if (!data.IsDynamic() || !IsSpent(body))
    {
        MoveOn(s, wasStopped ? AccelerationOf(data) : b2Vec2(0.0f, 0.0f),
               (1.0f - time) * m_context.timeStep);
    }
    if (!IsFinite(s))
    {
        s = SolverBody(); // stop instead of becoming non-finite
    }
    data.linearVelocity = s.v;
    data.angularVelocity = s.w;
    data.pose.x += double(s.d.x);
    data.pose.y += double(s.d.y);
    data.pose.angle += double(s.angle);
    SynchronizePose(data);
}

/// Returns how the body would have ended the step.
EnergyGuard::Path Impact::PathOf(std::size_t index, float32 time) const
{
    const BodyData& data = Data(*m_bodies[index]);
    const b2Vec2 left = (1.0f - time) * m_context.timeStep * AccelerationOf(data);
    const bool wasStopped = data.sweepStart == time;
    return {m_memory.before[index].pose, data.linearVelocity + (wasStopped ? left : b2Vec2_zero),
            data.angularVelocity};
}

/// Returns the restitution that gives a contact its bounce speed at its present speed.
float32 Impact::RestitutionOf(std::size_t index) const
{
    const ContactBlock& c = m_memory.impulses[index];
    float32 wanted = 0.0f;
    float32 coming = 0.0f;
    for (int32 k = 0; k < c.pointCount; ++k)
    {
        wanted = b2Max(wanted, c.bias[k][0]);
        coming = b2Max(coming, -NormalSpeedOf(c, 0, k, m_context.bodies));
    }
    return c.bounces && coming > 0.0f ? wanted / coming : Data(*m_contacts[index]).restitution;
}

/// True if joints take part in the contact's bounce: all that they connect is part of the impact.
bool Impact::IsJointed(std::size_t index)
{
    JointedBounce& jointed = m_world.subSteps->jointedBounce;
    return m_bodies.size() > m_memory.firstJoined && jointed.Find(Data(*m_contacts[index])) &&
           std::ranges::all_of(jointed.Bodies(), [this](b2Body* body) {
               return std::ranges::find(m_bodies, body) != m_bodies.end();
           });
}

/// With sub-steps joints take part in bounces. Then one contact bounces at a time, and Sweep brings
/// the others to rest. Not where a body would turn far in the rest of the step: it would move on
/// straight, and open its joints.
void Impact::BounceWithJoints(float32 timeLeft)
{
    m_memory.restitutions.clear();
    m_memory.totals.clear();
    bool any = false;
    for (std::size_t i = 0; i < m_contacts.size() && m_bodies.size() > m_memory.firstJoined; ++i)
    {
        m_memory.restitutions.push_back(RestitutionOf(i));
        any = any || (Bounces(m_memory.impulses[i]) && IsJointed(i));
    }
    if (!any)
    {
        return;
    }
    m_memory.totals.assign(m_contacts.size(), BlockTotals());
    for (int32 iteration = 0; iteration < kMaxBounces && any; ++iteration)
    {
        any = false;
        for (std::size_t i = 0; i < m_contacts.size(); ++i)
        {
            any = Bounce(i) || any;
        }
    }
    bool far = false;
    ForMoved([&](const BodyData& body, const SolverBody& state, std::size_t) {
        far = far || timeLeft * b2Abs(state.w - body.angularVelocity) > kMaxJoinedTurn;
    });
    if (far)
    {
        LoadBodies();
        m_memory.totals.clear();
        return;
    }
    for (ContactBlock& block : Impulses())
    {
        block.bounces = false;
        std::fill_n(&block.bias[0][0], 2 * kBlockLanes, 0.0f);
    }
}

/// False if the contact approaches too slowly.
bool Impact::Bounce(std::size_t index)
{
    ContactBlock& block = m_memory.impulses[index];
    if (Data(*m_contacts[index]).restitution == 0.0f || !IsBouncing(block, 0, m_context))
    {
        return false;
    }
    BlockTotals& totals = m_memory.totals[index];
    const float32 e = m_memory.restitutions[index];
    m_memory.restitutions[index] = Data(*m_contacts[index]).restitution;
    JointedBounce& jointed = m_world.subSteps->jointedBounce;
    return (IsJointed(index) &&
            jointed.Bounce(block, m_memory.overlaps[index], totals, 0, e, m_context)) ||
           Bouncer(block, totals, 0, m_context).Bounce(e);
}

/// Returns the impulses of a contact, for a listener.
b2ContactImpulse Impact::ImpulsesOf(std::size_t index) const
{
    b2ContactImpulse impulse = ImpulseOf(m_memory.impulses[index], 0);
    for (int32 k = 0; k < impulse.count && index < m_memory.totals.size(); ++k)
    {
        impulse.normalImpulses[k] += m_memory.totals[index].normal[k][0];
        impulse.tangentImpulses[k] += m_memory.totals[index].tangent[k][0];
    }
    return impulse;
}

// Impulses are not stored: the contact is solved for the remaining time only.
void Impact::SolveVelocities(float32 time)
{
    Prepare();
    const double before = KineticEnergyOfAll();
    const double maximum = (1.0 + kEnergyRounding) * (before + CorrectBounces());
    BounceWithJoints((1.0f - time) * m_context.timeStep);
    Sweep();
    if (KineticEnergyOfAll() > maximum && KeepsEnergy())
    {
        BounceLess(maximum);
    }
    const bool accounts = m_world.energyGuard->HasAccounts() && KeepsEnergy();
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
    {
        BodyData& data = Data(*m_bodies[i]);
        const EnergyGuard::Path path = PathOf(i, time);
        MoveOn(i, time);
        if (accounts)
        {
            m_world.energyGuard->NoteImpact(data, path);
        }
    }
    for (std::size_t i = 0; i < m_contacts.size(); ++i)
    {
        if (m_world.listener != nullptr) // it may remove itself
        {
            const b2ContactImpulse impulse = ImpulsesOf(i);
            m_world.listener->PostSolve(m_contacts[i], &impulse);
        }
    }
}

} // namespace box2d
