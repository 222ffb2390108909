// SPDX-License-Identifier: MIT
#include "../Solver/Motion.h"
#include "../State/Access.h"
#include "../State/ConstraintGraph.h"
#include "Closing.h"
#include "JointSystem.h"

#include <algorithm>
#include <cmath>

/// Closing of joints after a drift, a part of JointSystem.
namespace box2d
{

namespace
{

/// The compliance (see the header) for poses at which closing with the usual one fails. It damps as
/// in Levenberg, "A Method for the Solution of Certain Non-Linear Problems in Least Squares", 1944.
/// With a hundredth of it a bridge without slack does not come to rest, with 100 times a jammed
/// train of gears slips by 1.5 mrad (docs/notes/tuned-constants.md).
constexpr double kDamped = 1e-2;
/// In loops, where joints that hold the same twice share the load. With a hundredth a mesh does not
/// come to rest, with 100 times a jammed train of gears trembles. In a tree more than RowSystem's
/// own would let a heavy load sag.
constexpr double kLoopCompliance = 1e-5;

/// Drifts per sub-step: a bound of the cost. With 4 chains of rods of 1000:1 open by 9 m; with 64
/// no test fails (docs/notes/tuned-constants.md).
constexpr int32 kMaxCycles = 16;
/// Relative gain of kinetic energy by closing in a step without a rotation, and the maximum with
/// one: see HasGained. Of 300 heaps of jointed boxes 4 gain energy with 0.05, 6 with 0.2 and 11
/// with 0.5 (docs/notes/energy-accounts.md). The tests pass with a minimum of 0.01, too, and with a
/// maximum of 0.05 or 5.
constexpr double kMinGain = 0.05;
constexpr double kMaxGain = 0.5;
/// A square: a drift then turns a swing by at most 1 / sqrt(0.75) = 1.15 rad. A leapfrog is stable
/// below 2 rad (see HingeTreeSolve.cpp), and forces within a step exceed their mean. With 0.25 no
/// test fails; with 3 a bridge rests later (docs/notes/tuned-constants.md).
constexpr double kCycleMargin = 0.75;
/// Much larger for the jerk of a rope, a rod, or a limit that stops a heavy body. Tuned on 216
/// chains of ropes and of rods: docs/notes/sub-steps-chains.md.
constexpr double kSnapMargin = 6.0;

/// Returns how far a drift moves a row back by poses only [m], [rad].
float32 ReturnOf(const JointRows& rows, int32 row, float32 timeStep)
{
    const float32 share = kClosedShare * RemainingError(rows.error[row]);
    const float32 path = row < rows.Rigid() ? b2_maxFloat : kFastestReturn * timeStep;
    return b2Clamp(share, -path, path);
}

double KineticEnergyOf(const BodyData& body, const SolverBody& state)
{
    const double invInertia = body.SolverInvInertia();
    return KineticEnergy(state, 1.0 / double(body.SolverInvMass()),
                         invInertia > 0.0 ? 1.0 / invInertia : 0.0);
}

} // namespace

void JointSystem::SolvePositions(const SolverContext& context, float32 timeStep,
                                 const BodyKick* kicks)
{
    for (const std::size_t i : m_rowed)
    {
        NoteKick(i);
    }
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        if (!m_parts[std::size_t(i)].IsByRows())
        {
            continue;
        }
        const int32 cycles = Cycles(i, timeStep);
        cycles > 1 ? DriftInCycles(i, cycles, context, timeStep, kicks)
                   : ClosePart(i, context, timeStep);
    }
    AddTotals();
}

double JointSystem::ComplianceOf(int32 part) const
{
    return m_system.HasLoops(part) ? kLoopCompliance : RowSystem::kCompliance;
}

void JointSystem::NotePoses(const SolverContext& context)
{
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        m_system.ForBodies(i, [&](const BodyData& body, std::size_t place) {
            m_poses[place] = context.bodies[body.SolverIndex()];
        });
    }
}

/// Returns the number of drifts to split a drift into. Tension forces F at arms r make a body
/// oscillate with the frequency sqrt(sum F.r / I), and a leapfrog needs at least three drifts per
/// oscillation. The number stays constant in a step, because changing it adds errors as well. With
/// limits the kick before the drift counts too: a rope that becomes taut stops a long fall in one
/// kick. That kick has at least half the length of the drift, see DriftInCycles.
int32 JointSystem::Cycles(int32 part, float32 timeStep) const
{
    const Part& p = m_parts[std::size_t(part)];
    if (p.touched || p.driven)
    {
        return 1;
    }
    const double now = p.hasBounded ? m_system.SquaredFrequency(part) / (0.5 * double(timeStep))
                                    : p.squaredFrequency;
    const double margin = p.hasBounded || p.lines ? kSnapMargin : kCycleMargin;
    const double square =
        margin * std::max(p.squaredFrequency, now) * double(timeStep) * double(timeStep);
    int32 count = 1;
    while (double(count * count) < square && count < kMaxCycles)
    {
        ++count;
    }
    return count;
}

/// Performs the drift as `count` leapfrog steps, from kick to kick; the velocities before and after
/// are those half a drift later and earlier. A limit pushes during a whole kick. With limits, the
/// first kick therefore continues with the impulses before the drift, and the last is completed by
/// the kick after it.
void JointSystem::DriftInCycles(int32 part, int32 count, const SolverContext& context,
                                float32 timeStep, const BodyKick* kicks)
{
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        SolverBody& s = context.bodies[body.SolverIndex()];
        s.d = m_poses[place].d;
        s.q = m_poses[place].q;
        s.angle = m_poses[place].angle;
    });
    const float32 time = timeStep / float32(count);
    const float32 back = 0.5f * (time - timeStep);
    FindCarriers(part, context);
    SolverContext cycle = context;
    cycle.inverseStep = 1.0f / time;
    KickPart(part, cycle, back, kicks);
    PlaceCarriers(context, timeStep);
    MeetKick(part, cycle);
    for (int32 i = 1; i <= count; ++i)
    {
        m_system.ForBodies(part, [&](const BodyData& body, std::size_t) {
            MoveByVelocity(cycle.bodies[body.SolverIndex()], time, kMaxSmallMove);
        });
        PlaceCarriers(context, float32(count - i) * time);
        ClosePart(part, cycle, time);
        KickPart(part, cycle, i < count ? time : back, kicks);
        if (!m_parts[std::size_t(part)].hasBounded)
        {
            MeetKick(part, cycle);
        }
        else if (i < count)
        {
            ForgetImpulses(part);
            MeetKick(part, cycle);
        }
    }
}

/// Finds the bodies of infinite mass that move the part's joints. They have drifted already.
void JointSystem::FindCarriers(int32 part, const SolverContext& context)
{
    m_carriers.clear();
    m_system.ForItems(part, [&](std::size_t joint) {
        const JointRows& rows = m_system.Rows(joint);
        for (int32 side = 0; side < rows.bodies; ++side)
        {
            const JointRows::Column& c = rows.columns[side];
            const SolverBody& s = context.bodies[c.body];
            const auto isSame = [&](const Carrier& carrier) { return carrier.body == c.body; };
            if (!Moves(c.invMass, c.invInertia) && (s.v != b2Vec2_zero || s.w != 0.0f) &&
                std::none_of(m_carriers.begin(), m_carriers.end(), isSame))
            {
                m_carriers.push_back({c.body, s});
            }
        }
    });
}

/// Puts them where they are this long before the end of the drift [s].
void JointSystem::PlaceCarriers(const SolverContext& context, float32 before)
{
    for (const Carrier& carrier : m_carriers)
    {
        SolverBody& s = context.bodies[carrier.body];
        s = carrier.end;
        if (before > 0.0f)
        {
            s.d -= before * s.v;
            s.angle -= before * s.w;
            s.q.Set(s.angle);
        }
    }
}

/// Applies gravity, forces and damping.
void JointSystem::KickPart(int32 part, const SolverContext& context, float32 time,
                           const BodyKick* kicks)
{
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t) {
        kicks[body.awakeIndex].Give(context.bodies[body.SolverIndex()], time);
    });
}

/// Resets impulses that were added to the totals.
void JointSystem::ForgetImpulses(int32 part)
{
    m_system.ForItems(part, [&](std::size_t joint) {
        AddTotals(joint);
        m_system.Rows(joint).SetImpulse(Impulses{}.at);
    });
}

/// Fills the joint's rows at the current poses, with their current impulses.
const JointRows& JointSystem::FillHere(std::size_t joint, const SolverContext& context, bool torn)
{
    JointRows& rows = m_system.Rows(joint);
    Impulses kept;
    std::copy_n(rows.impulse, JointRows::kMaxRows, kept.at);
    rows.Clear();
    JointAccess::FillRows(*m_joints[joint], context, rows);
    rows.SetImpulse(kept.at);
    if (torn)
    {
        m_system.TakeAddedMass(joint);
    }
    return rows;
}

/// Solves the velocities at the current poses.
void JointSystem::MeetKick(int32 part, const SolverContext& context)
{
    Part& p = m_parts[std::size_t(part)];
    m_system.ForItems(part, [&](std::size_t joint) { (void)FillHere(joint, context, p.torn); });
    p.factored = false;
    SolvePart(part, context);
    if (p.hasBounded)
    {
        m_system.ForItems(part, [&](std::size_t joint) { NoteKick(joint); });
    }
}

void JointSystem::NoteKick(std::size_t joint)
{
    std::copy_n(m_system.Rows(joint).impulse, JointRows::kMaxRows, m_kicks[joint].at);
}

void JointSystem::ClosePart(int32 part, const SolverContext& context, float32 timeStep)
{
    Part& p = m_parts[std::size_t(part)];
    m_system.ForItems(part, [&](std::size_t joint) {
        for (int32 k = 0; k < JointRows::kMaxRows; ++k)
        {
            const JointRows& rows = m_system.Rows(joint);
            m_left[joint].at[k] = RemainingOf(rows, k) - ReturnOf(rows, k, timeStep);
        }
        p.factored = (m_hasBounded[joint] == 0 || !SetActiveToClose(joint, context)) && p.factored;
    });
    if (!p.factored)
    {
        Factor(part, ComplianceOf(part));
        p.factored = true;
    }
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        m_opened[place] = context.bodies[body.SolverIndex()];
    });
    if (Close(part, context, timeStep) && !HasGained(part, context, timeStep))
    {
        return;
    }
    const auto giveBack = [&] {
        m_system.ForItems(
            part, [&](std::size_t joint) { m_system.Rows(joint).SetImpulse(m_kicks[joint].at); });
    };
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        context.bodies[body.SolverIndex()] = m_opened[place];
    });
    giveBack();
    p.damped = true;
    Factor(part, kDamped);
    (void)Close(part, context, timeStep);
    p.damped = false;
    giveBack();
    if (WantClosedPoses(part, context).widest > b2_linearSlop)
    {
        ClosePoses(part, context);
    }
}

/// Closes by poses only, by Newton's method with the rows of each pose, except for m_left.
/// Velocities that do not close the joints would disturb them for long. The best pose is kept.
void JointSystem::ClosePoses(int32 part, const SolverContext& context)
{
    Gaps best = {b2_maxFloat, b2_maxFloat};
    for (int32 i = 0; i < kMaxPoseCloses; ++i)
    {
        const Gaps gaps = WantClosedPoses(part, context);
        if (!gaps.AreCloserThan(best))
        {
            m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
                context.bodies[body.SolverIndex()] = m_opened[place];
            });
            break;
        }
        best = gaps;
        m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
            m_opened[place] = context.bodies[body.SolverIndex()];
        });
        if (gaps.widest < kNearlyClosed || i + 1 == kMaxPoseCloses)
        {
            break;
        }
        Factor(part, ComplianceOf(part));
        m_system.Solve(part);
        m_system.Apply(part, context, 1.0f, false);
    }
    m_parts[std::size_t(part)].factored = false;
}

/// Computes the displacements that close the joints, and the rows at the current poses. Returns the
/// maximum gaps.
JointSystem::Gaps JointSystem::WantClosedPoses(int32 part, const SolverContext& context)
{
    const bool torn = m_parts[std::size_t(part)].torn;
    Gaps gaps;
    m_system.ForItems(part, [&](std::size_t joint) {
        const JointRows& rows = FillHere(joint, context, torn);
        (void)SetActiveToClose(joint, context);
        Vector3& residual = m_system.Residual(joint);
        residual = Vector3{};
        for (int32 k = 0; k < rows.rows; ++k)
        {
            const float32 open = rows.error[k] - m_left[joint].at[k];
            if (k >= rows.Rigid() && open * rows.error[k] <= 0.0f)
            {
                continue; // within the limit
            }
            gaps.widest = b2Max(gaps.widest, b2Abs(open));
            gaps.rigid = k < rows.Rigid() ? b2Max(gaps.rigid, b2Abs(open)) : gaps.rigid;
            residual.at[k] =
                -double(b2Clamp(open, -b2_maxLinearCorrection, b2_maxLinearCorrection));
        }
    });
    return gaps;
}

bool JointSystem::HasMoved(int32 part, const SolverContext& context) const
{
    bool any = false;
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        const SolverBody& s = context.bodies[body.SolverIndex()];
        any = any || !(s.d == m_poses[place].d) || s.angle != m_poses[place].angle;
    });
    return any;
}

void JointSystem::CloseAfterPushes(const SolverContext& context, int32 iterations)
{
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        const Part& part = m_parts[std::size_t(i)];
        if (part.IsByRows() && part.touched && HasMoved(i, context))
        {
            ClosePoses(i, context);
        }
    }
    for (int32 i = 0; i < iterations && !m_iterated.IsEmpty(); ++i)
    {
        (void)m_iterated.SolvePositionsInStep(context, m_threads);
    }
}

void JointSystem::NoteOpen(const ConstraintGraph& graph, std::uint32_t awakeVersion,
                           const SolverContext& context)
{
    Update(graph, awakeVersion);
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        m_left[i] = GapsOf(*m_joints[i], context);
    }
}

JointSystem::Impulses JointSystem::GapsOf(b2Joint& joint, const SolverContext& context)
{
    m_now.Clear();
    JointAccess::FillRows(joint, context, m_now);
    Impulses gaps{};
    for (int32 k = 0; k < m_now.rows; ++k)
    {
        gaps.at[k] = RemainingOf(m_now, k);
    }
    return gaps;
}

/// Impacts wake bodies, and with them joints. Those stay as open as they are now. Both lists are
/// sorted by the joints' numbers.
void JointSystem::FollowOpen(const ConstraintGraph& graph, const SolverContext& context)
{
    if (m_version == graph.JointVersion())
    {
        return; // also where a listener has put a body to sleep since
    }
    m_noted = m_joints;
    m_notedGaps.swap(m_left);
    Update(graph, m_awakeVersion);
    std::size_t before = 0;
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        while (before < m_noted.size() &&
               JointAccess::Number(*m_noted[before]) < JointAccess::Number(*m_joints[i]))
        {
            ++before;
        }
        const bool known = before < m_noted.size() && m_noted[before] == m_joints[i];
        m_left[i] = known ? m_notedGaps[before] : GapsOf(*m_joints[i], context);
    }
}

void JointSystem::LetGo(int32 part)
{
    m_system.ForBodies(
        part, [&](const BodyData&, std::size_t place) { m_system.SetAddedMass(place, 0.0, 0.0); });
}

/// Returns the largest angle by which a body, or a line between two of them, turns in a drift.
double JointSystem::AngleOfDrift(int32 part, const SolverContext& context, float32 timeStep) const
{
    double fastest = 0.0; // [rad/s]
    m_system.ForBodies(part, [&](const BodyData&, std::size_t place) {
        fastest = b2Max(fastest, double(b2Abs(m_opened[place].w)));
    });
    m_system.ForItems(part, [&](std::size_t joint) {
        const JointRows& rows = m_system.Rows(joint);
        double across = 0.0; // speed of the ends across the line
        for (int32 side = 0; rows.length > 0.0f && side < rows.bodies; ++side)
        {
            const JointRows::Column& c = rows.columns[side];
            const b2Vec2& v = context.bodies[c.body].v;
            across += double(b2Cross(b2Vec2(c.x[0], c.y[0]), v));
        }
        fastest = across != 0.0 ? b2Max(fastest, std::abs(across) / double(rows.length)) : fastest;
    });
    return fastest * double(timeStep);
}

/// True if closing added velocities that no drift explains. Closing corrects the difference of a
/// straight and a circular path. Until the next kick, that speeds up what turns by the angle a by
/// the fraction a^2 / 2, which is a^2 of its energy. Besides, kMinGain and slow speeds are allowed,
/// in all drifts of a step together: a straight knee gained 5 % in each of them. The velocities in
/// m_opened are those before.
bool JointSystem::HasGained(int32 part, const SolverContext& context, float32 timeStep) const
{
    const double small = double(kNearlyClosed) / double(context.timeStep);
    const double angle = AngleOfDrift(part, context, timeStep);
    const double share = double(timeStep) / double(context.timeStep);
    const double gain = b2Min(kMinGain * share + angle * angle, kMaxGain);
    double before = 0.0;
    double after = 0.0;
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        const SolverBody& now = context.bodies[body.SolverIndex()];
        before += (1.0 + gain) * KineticEnergyOf(body, m_opened[place]) +
                  0.5 * small * small / double(body.SolverInvMass());
        after += KineticEnergyOf(body, now);
    });
    return after > before;
}

/// False if the joints opened further: near a pose with contradictory rows, the directions from
/// before the drift are invalid. With damping only the poses change, because velocities that do not
/// close the joints would disturb them for long.
bool JointSystem::Close(int32 part, const SolverContext& context, float32 timeStep)
{
    float32 first = 0.0f;
    for (int32 i = 0; i < kMaxCloses; ++i)
    {
        float32 widest = 0.0f;
        m_system.ForItems(part, [&](std::size_t joint) {
            widest = b2Max(widest, WantClosed(joint, context, timeStep));
        });
        if (i > 0 && widest > first)
        {
            return false;
        }
        first = i == 0 ? widest : first;
        m_system.Solve(part);
        m_system.Apply(part, context, timeStep, !m_parts[std::size_t(part)].damped);
        if (widest < kNearlyClosed)
        {
            break;
        }
    }
    return DrawTogether(part, context, timeStep);
}

/// Closes errors from before the drift, and what is beyond limits, by poses only, because
/// velocities would persist. False if the joints opened further.
bool JointSystem::DrawTogether(int32 part, const SolverContext& context, float32 timeStep)
{
    bool any = false;
    float32 first = 0.0f;
    m_system.ForItems(part, [&](std::size_t joint) {
        const JointRows& rows = m_system.Rows(joint);
        for (int32 k = 0; k < JointRows::kMaxRows; ++k)
        {
            const float32 open = ReturnOf(rows, k, timeStep);
            m_system.Residual(joint).at[k] = -double(open) / double(timeStep);
            any = any || open != 0.0f;
        }
        first = b2Max(first, rows.WidestGap());
    });
    if (!any)
    {
        return true;
    }
    m_system.Solve(part);
    m_system.Apply(part, context, timeStep, false);
    float32 widest = 0.0f;
    m_system.ForItems(part, [&](std::size_t joint) {
        m_now.Clear();
        JointAccess::FillRows(*m_joints[joint], context, m_now);
        widest = b2Max(widest, m_now.WidestGap());
    });
    return widest <= b2Max(first, b2_linearSlop);
}

/// Sets the change of speed that closes a joint in the given time, except for its error from before
/// the drift. Returns the gap.
float32 JointSystem::WantClosed(std::size_t joint, const SolverContext& context, float32 timeStep)
{
    JointRows& now = m_now;
    now.Clear();
    JointAccess::FillRows(*m_joints[joint], context, now);
    const float32(&before)[3] = m_system.Rows(joint).error;
    Vector3 error = now.boundedRows > 0 ? Beyond(joint, now, context) : Vector3{};
    for (int32 k = 0; k < now.Rigid(); ++k)
    {
        error.at[k] = double(now.error[k]) - double(RemainingError(before[k]));
    }
    float32 widest = 0.0f;
    for (int32 k = 0; k < JointRows::kMaxRows; ++k)
    {
        m_system.Residual(joint).at[k] = -error.at[k] / double(timeStep);
        widest = b2Max(widest, b2Abs(float32(error.at[k])));
    }
    return widest;
}

} // namespace box2d
