// SPDX-License-Identifier: MIT
#include "JointSystem.h"

#include "../State/Access.h"
#include "../State/ConstraintGraph.h"

#include <algorithm>
#include <span>

namespace box2d
{

namespace
{

/// Maximum cost of a system, in updates per body: a tree has one, a ladder two. A bound of the
/// cost; from 4 to 1000 no test fails (docs/notes/tuned-constants.md). With 2 a mesh is
/// iterated over and opens by 0.6 mm instead of less than 0.01, a redundant loop by 3 mm.
constexpr int32 kMaxUpdates = 16;
/// Maximum solutions to determine the active set; one is usual. With 3 a limit in a whipped chain
/// is exceeded by 4.3 cm, with 48 no test changes (docs/notes/tuned-constants.md).
constexpr int32 kMaxTries = 12;
/// After this many further solutions no row goes back to its wanted speed. Otherwise the active set
/// may cycle, and the last one could contain rows far above their limit, by a factor of fifty in a
/// random world. With 100 world 299 gains 107 % of energy (docs/notes/tuned-constants.md).
constexpr int32 kSettlingTry = 6;
/// A part is torn if a joint is open by more than this [m], [rad]: twice what contacts allow. With
/// 0.1 m rods under a ball of 1000:1 open by 14 % of the chain's length instead of 1.4. With 0.001
/// m they open by 0.8 %, and nothing else was compared (docs/notes/tuned-constants.md).
constexpr float32 kTorn = 2.0f * b2_linearSlop;
/// The share of its heaviest body's mass that each body of a torn part has at least, at its full
/// radius. With 0.003 rods of 1000:1 stretch more, with 0.03 some gain energy
/// (docs/notes/sub-steps-chains.md).
constexpr double kTornShare = 0.01;

} // namespace

void JointSystem::Update(const ConstraintGraph& graph, std::uint32_t awakeVersion)
{
    const bool sameList = m_version == graph.JointVersion();
    if (sameList && (m_awakeVersion == awakeVersion || HasSameSides()))
    {
        m_awakeVersion = awakeVersion;
        return;
    }
    m_awakeVersion = awakeVersion;
    m_version = graph.JointVersion();
    m_joints = graph.Joints();
    m_sides.clear();
    for (b2Joint* joint : m_joints)
    {
        m_sides.push_back(SidesOf(*joint));
    }
    m_system.Build(m_sides, kMaxUpdates, m_elimination);
    m_parts.assign(std::size_t(m_system.Components()), Part());
    BuildTrees();
    m_hasBounded.assign(m_joints.size(), 0);
    if (!sameList)
    {
        m_states.assign(m_joints.size(), RowStates());
    }
    if (m_restoredVersion == m_version && m_restored.size() == m_joints.size())
    {
        m_states.swap(m_restored);
    }
    m_restoredVersion = -1;
    m_totals.resize(m_joints.size());
    m_kicks.resize(m_joints.size());
    m_speeds.resize(m_joints.size());
    m_poses.resize(m_system.Bodies().size());
    m_left.assign(m_joints.size(), Impulses());
    m_opened.resize(m_system.Bodies().size());
}

/// False if a body of the joints woke or was put to sleep alone, which leaves the list as it was.
bool JointSystem::HasSameSides() const
{
    return std::ranges::equal(m_joints, m_sides, [](b2Joint* joint, const RowSides& sides) {
        return SidesOf(*joint) == sides;
    });
}

void JointSystem::BuildTrees()
{
    m_treeOf.assign(m_parts.size(), -1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
    {
        if (m_system.HasLoops(int32(i)))
        {
            continue;
        }
        m_partJoints.clear();
        m_system.ForItems(int32(i),
                          [&](std::size_t item) { m_partJoints.push_back(m_joints[item]); });
        m_trees.resize(b2Max(m_trees.size(), count + 1));
        if (m_trees[count].Build(m_partJoints))
        {
            m_treeOf[i] = int32(count++);
        }
    }
}

/// True if iterations may not be enough: masses or levers differ by more than the manual advises.
bool JointSystem::IsAtRisk(int32 part) const
{
    bool any = false;
    m_system.ForItems(part,
                      [&](std::size_t item) { any = any || box2d::IsAtRisk(*m_joints[item]); });
    return any;
}

void JointSystem::BeginParts(const SolverContext& context, float32 share, float32 lastInverseStep,
                             const BodyKick* kicks)
{
    m_solutions.assign(m_joints.size(), Solution::Rows);
    for (const int32 joint : m_system.Iterative())
    {
        m_solutions[std::size_t(joint)] = Solution::Iterated;
    }
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        BeginPart(i, context, kicks);
    }
    m_rowed.clear();
    m_iteratedJoints.clear();
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        if (m_solutions[i] == Solution::Rows)
        {
            m_rowed.push_back(i);
            m_totals[i] = Totals();
            TakeImpulses(i);
        }
        else if (m_solutions[i] == Solution::Iterated)
        {
            m_iteratedJoints.push_back(m_joints[i]);
        }
    }
    m_iterated.Update(m_iteratedJoints, m_version);
    if (!m_iterated.IsEmpty())
    {
        SolverContext subStep = context;
        subStep.timeStep = 1.0f / context.inverseStep;
        subStep.stepRatio = share;
        m_iterated.Begin(subStep, m_threads);
    }
    m_lastInverseStep = lastInverseStep;
    m_share = share;
    m_begins = !m_joints.empty(); // threads of groups, which have no joints, only read it
}

/// Components in contact with others use their number of drifts.
void JointSystem::BeginPart(int32 index, const SolverContext& context, const BodyKick* kicks)
{
    Part& part = m_parts[std::size_t(index)];
    m_system.ForBodies(index, [&](const BodyData& body, std::size_t) {
        part.touched = part.touched || body.colorMask != 0;
    });
    const int32 tree = m_treeOf[std::size_t(index)];
    if (tree != -1 && !part.touched && m_trees[std::size_t(tree)].Begin(context, kicks))
    {
        part.tree = &m_trees[std::size_t(tree)];
        part.iterated = false;
    }
    if (!part.IsByRows())
    {
        const Solution solution = part.iterated ? Solution::Iterated : Solution::Tree;
        m_system.ForItems(index, [&](std::size_t joint) { m_solutions[joint] = solution; });
    }
}

/// Joints with one row set only its impulse; the others may be those of an earlier joint.
void JointSystem::TakeImpulses(std::size_t joint)
{
    JointRows& rows = m_system.Rows(joint);
    rows.SetImpulse(Impulses{}.at);
    JointAccess::GetRowImpulses(*m_joints[joint], rows.impulse);
    for (float32& impulse : rows.impulse)
    {
        impulse = b2IsValid(impulse) ? impulse : 0.0f;
    }
}

void JointSystem::StepTrees(float32 timeStep, int32 subSteps, float32 lastStep)
{
    for (const Part& part : m_parts)
    {
        if (part.tree != nullptr)
        {
            part.tree->Step(timeStep, subSteps, lastStep);
        }
    }
}

void JointSystem::End()
{
    AddTotals();
    for (const std::size_t i : m_rowed)
    {
        JointAccess::SetRowImpulses(*m_joints[i], m_totals[i].within, m_totals[i].beyond);
    }
    if (!m_iterated.IsEmpty())
    {
        m_iterated.End(m_threads);
    }
}

void JointSystem::Prepare(const SolverContext& context)
{
    for (const std::size_t i : m_rowed)
    {
        JointRows& rows = m_system.Rows(i);
        Impulses kept;
        std::copy_n(rows.impulse, JointRows::kMaxRows, kept.at);
        rows.Clear();
        JointAccess::FillRows(*m_joints[i], context, rows);
        std::copy_n(kept.at, rows.rows, rows.impulse);
        m_hasBounded[i] = rows.boundedRows > 0;
        if (rows.boundedRows > 0)
        {
            Validate(rows, m_states[i]);
        }
    }
    for (std::size_t i = 0; i < m_parts.size(); ++i)
    {
        Part& part = m_parts[i];
        part.hasBounded = part.driven = part.lines = part.factored = false;
        m_system.ForItems(int32(i), [&](std::size_t item) {
            part.hasBounded = part.hasBounded || m_hasBounded[item] != 0;
            part.driven = part.driven || m_system.Rows(item).IsDriven();
            part.lines = part.lines || m_system.Rows(item).length > 0.0f;
        });
        if (part.IsByRows())
        {
            HoldTorn(int32(i));
        }
    }
    if (m_begins)
    {
        m_begins = false;
        TakeFrequencies();
    }
}

/// From the last step's impulses, which are then those of the first kick.
void JointSystem::TakeFrequencies()
{
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        Part& part = m_parts[std::size_t(i)];
        part.squaredFrequency =
            part.IsByRows() ? double(m_lastInverseStep) * m_system.SquaredFrequency(i) : 0.0;
    }
    for (const std::size_t i : m_rowed)
    {
        for (float32& impulse : m_system.Rows(i).impulse)
        {
            impulse *= m_share;
        }
    }
}

/// Light bodies under a heavy load may turn too fast for a drift. Their joints then open, and stay
/// open as long as they turn so. While they are open, each has a share of the load's mass, which
/// slows the turning. A part in contact that has motors or limits keeps its own masses, because
/// contacts solve both with them.
void JointSystem::HoldTorn(int32 part)
{
    float32 widest = 0.0f;
    m_system.ForItems(
        part, [&](std::size_t joint) { widest = b2Max(widest, m_system.Rows(joint).WidestGap()); });
    Part& p = m_parts[std::size_t(part)];
    p.torn = widest > kTorn && !(p.touched && p.hasBounded);
    if (!p.torn)
    {
        LetGo(part);
        return;
    }
    double mass = 0.0;
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t) {
        mass = b2Max(mass, kTornShare / double(body.SolverInvMass()));
    });
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
        const double reach = double(body.maxExtent);
        const double turning = mass * reach * reach * double(body.SolverInvInertia());
        m_system.SetAddedMass(place, b2Max(mass - 1.0 / double(body.SolverInvMass()), 0.0),
                              turning > 1.0 ? (turning - 1.0) / double(body.SolverInvInertia())
                                            : 0.0);
    });
    m_system.ForItems(part, [&](std::size_t joint) { m_system.TakeAddedMass(joint); });
}

void JointSystem::WarmStart(const SolverContext& context, float32 share)
{
    for (const std::size_t i : m_rowed)
    {
        Start(context, i, share);
    }
    if (!m_iterated.IsEmpty()) // not called by the threads of groups, which have no joints
    {
        m_iterated.Kick(context, share, m_threads);
    }
}

void JointSystem::Start(const SolverContext& context, std::size_t joint, float32 share)
{
    JointRows& rows = m_system.Rows(joint);
    Vector3 impulse{};
    bool any = false;
    for (int32 k = 0; k < rows.rows; ++k)
    {
        const float32 initial = WarmStartImpulse(joint, k, share);
        rows.impulse[k] = 0.0f;
        impulse.at[k] = double(initial);
        any = any || initial != 0.0f;
    }
    if (any)
    {
        Push(context, rows, impulse);
    }
}

void JointSystem::Factor(int32 part, double compliance)
{
    m_system.Read(part, compliance);
    m_system.Factor(part);
}

void JointSystem::SolvePart(int32 part, const SolverContext& context)
{
    Part& p = m_parts[std::size_t(part)];
    for (int32 tries = 0; tries < kMaxTries; ++tries)
    {
        if (!p.factored)
        {
            m_system.ForItems(part, [&](std::size_t joint) { SetActive(joint); });
            Factor(part, ComplianceOf(part));
            p.factored = true;
        }
        m_system.ForItems(part, [&](std::size_t joint) { WantSpeeds(joint, context); });
        m_system.Solve(part);
        m_system.Apply(part, context);
        bool changed = false;
        // The last active set is solved as well; otherwise rigid rows would keep a residual.
        if (p.hasBounded && tries + 1 < kMaxTries)
        {
            // All with the same factorization.
            m_system.ForItems(part, [&](std::size_t joint) {
                m_speeds[joint] = SpeedOf(context, m_system.Rows(joint));
            });
            m_system.ForItems(part, [&](std::size_t joint) {
                changed = (m_hasBounded[joint] != 0 &&
                           Reconsider(joint, context, tries >= kSettlingTry)) ||
                          changed;
            });
        }
        p.factored = !changed;
        if (!changed)
        {
            break;
        }
    }
}

void JointSystem::SolveVelocities(const SolverContext& context, bool first)
{
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        const Part& part = m_parts[std::size_t(i)];
        if (part.IsByRows() && (first || part.touched))
        {
            SolvePart(i, context);
        }
    }
    m_iterated.SolveVelocities(context, m_threads);
}

/// Returns the rows with the bodies' own masses.
JointRows JointSystem::OwnRows(std::size_t joint) const
{
    JointRows rows = m_system.Rows(joint);
    for (JointRows::Column& column : std::span(rows.columns, std::size_t(rows.bodies)))
    {
        column.invMass = column.data->SolverInvMass();
        column.invInertia = column.data->SolverInvInertia();
    }
    return rows;
}

void JointSystem::FillItem(std::size_t joint, JointRows& rows, BoundedSystem::Item& item) const
{
    rows = OwnRows(joint);
    item = BoundedSystem::Item();
    for (int32 i = 0; i < rows.rows; ++i)
    {
        const RowState state = i < rows.Rigid() ? RowState::Holds : m_states[joint].of[i];
        const JointRows::Law& law = rows.laws[i];
        const bool bounded = i >= rows.Rigid() && law.maximum < b2_maxFloat;
        item.impulse.at[i] = double(rows.impulse[i]);
        item.speeds.at[i] = i < rows.Rigid() ? 0.0 : WantedSpeed(rows, state, i, 0.0);
        item.minimum.at[i] = bounded && state != RowState::Fastest ? -double(law.maximum)
                                                                   : -BoundedSystem::kUnbounded;
        item.maximum.at[i] =
            bounded && state != RowState::Slowest ? double(law.maximum) : BoundedSystem::kUnbounded;
        const bool held = state != RowState::AtMax && state != RowState::AtMin;
        item.active = uint8(item.active | int(held) << i);
    }
}

float32 JointSystem::ErrorOf(std::size_t joint, const SolverContext& context) const
{
    JointRows rows;
    BoundedSystem::Item item;
    FillItem(joint, rows, item);
    return BoundedSystem::ErrorOf(context, rows, item);
}

void JointSystem::FillDisplacements(std::size_t joint, JointRows& rows,
                                    BoundedSystem::Item& item) const
{
    rows = OwnRows(joint);
    item = BoundedSystem::Item();
    for (int32 i = 0; i < rows.rows; ++i)
    {
        const bool rigid = i < rows.Rigid();
        const RowState state = m_states[joint].of[i];
        item.minimum.at[i] = rigid || state == RowState::Fastest ? -BoundedSystem::kUnbounded : 0.0;
        item.maximum.at[i] = rigid || state == RowState::Slowest ? BoundedSystem::kUnbounded : 0.0;
        item.active = uint8(item.active | int(item.minimum.at[i] < item.maximum.at[i]) << i);
    }
}

void JointSystem::TakeItem(std::size_t joint, const BoundedSystem::Item& item)
{
    JointRows& rows = m_system.Rows(joint);
    for (int32 i = 0; i < rows.rows; ++i)
    {
        rows.impulse[i] = float32(item.impulse.at[i]);
    }
}

} // namespace box2d
