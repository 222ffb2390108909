// SPDX-License-Identifier: MIT
#include "BoundedSystem.h"

#include "../State/BodyPose.h"
#include "Disc.h"

#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

/// Solutions to find the rows at their bounds. A bound of the cost, because each factors the
/// system. With 2, a box that walls press leaves with 1.3 m/s when they open
/// (docs/notes/tuned-constants.md).
constexpr int32 kMaxRounds = 8;
/// A solution with a speed above this multiple of the previous maximum is discarded. If constraints
/// contradict each other, speeds have no bound: one body got 134 km/s. Levers need some increase.
/// With 3, a chain of 1000:1 gains energy at a post. With 1000, rows between walls keep moving
/// (docs/notes/tuned-constants.md).
constexpr double kBurst = 30.0;
/// Slower speeds before count as this one [m/s]: from rest any speed would be a burst. From 0.01 to
/// 100 no test fails, and only the gaps of chains at a post change (docs/notes/tuned-constants.md).
constexpr double kMinSpeedBefore = 1.0;
/// Work of rigid rows with a target speed, such as limits, that is still plausible, as a multiple
/// of the marked kinetic energy and of the work of bringing all bodies from kMinSpeedBefore to the
/// target speed. A body of mass m at v that gets the speed s takes m (v + s) s of work; levers need
/// some more. Where a contact and a limit contradict each other, the work was 1e4 times as large.
/// Without kMinSpeedBefore a load at rest on a limit exceeds it, too, because it sinks into the
/// limit by micrometres. From 2.5 to 100 no test fails. Without a bound such a contradiction is not
/// found (BoundedSystem.RejectsALimitThatContradictsAContact).
constexpr double kMaxWork = 10.0;

/// Limits with a smaller relative difference are equal: friction that is off by 1 % is not worth
/// another solution. From 1e-4 to 0.3 no test fails (docs/notes/tuned-constants.md).
constexpr double kSameLimit = 0.01;

/// A difference of speeds may be rounded by this fraction of them: half an ulp for each of a
/// dozen operations, and a margin. From 0 to 1e-4 no test fails.
constexpr double kRounding = 8.0 * double(b2_epsilon);

/// Returns the speed that a row brings its bodies to if nothing else holds them. A soft spring that
/// is far from its rest has a target speed of thousands of metres per second, and never reaches it.
double ReachedSpeed(double response, double softness, double target)
{
    return softness > 0.0 ? std::abs(target) * response / (response + softness) : std::abs(target);
}

/// Returns by how much a row's softness lets it miss its target speed.
double SoftSpeed(const JointRows& rows, const BoundedSystem::Item& item, int32 row)
{
    return double(rows.laws[row].softness) * (item.impulse.at[row] - item.start.at[row]);
}

/// Returns the sum of the magnitudes of the terms of a row's speed [m/s].
double SpeedsOf(const JointRows& rows, int32 row, const SolverContext& context)
{
    double speeds = 0.0;
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& c = rows.columns[side];
        const SolverBody& s = context.bodies[c.body];
        speeds += std::abs(double(c.x[row] * s.v.x)) + std::abs(double(c.y[row] * s.v.y)) +
                  std::abs(double(c.w[row] * s.w));
    }
    return speeds;
}

/// Returns the factor that makes a row's speed that of a point [m/s]: for an angle, how far a
/// body's shapes reach.
double ReachOf(const JointRows& rows, int32 row)
{
    float32 reach = 0.0f;
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& c = rows.columns[side];
        if (c.x[row] != 0.0f || c.y[row] != 0.0f)
        {
            return 1.0;
        }
        reach = b2Max(reach, Moves(c.invMass, c.invInertia) ? c.data->maxExtent : 0.0f);
    }
    return double(reach);
}

} // namespace

double GivenSpeed(const JointRows& rows, int32 row, const SolverContext& context)
{
    double speed = 0.0;
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& c = rows.columns[side];
        const SolverBody& body = context.bodies[c.body];
        if (!Moves(c.invMass, c.invInertia))
        {
            speed += SpeedFrom(c, row, body);
        }
        else if (c.invInertia == 0.0f)
        {
            speed += double(c.w[row]) * double(body.w);
        }
    }
    return speed;
}

float32 BoundedSystem::ErrorOf(const SolverContext& context, const JointRows& rows,
                               const Item& item)
{
    const Vector3 speed = box2d::SpeedOf(context, rows);
    double error = 0.0;
    for (int32 row = 0; row < rows.rows; ++row)
    {
        const double impulse = item.impulse.at[row];
        const double off = speed.at[row] + SoftSpeed(rows, item, row) - item.speeds.at[row];
        const bool mayMove =
            off < 0.0 ? impulse >= item.maximum.at[row] : impulse <= item.minimum.at[row];
        const double rounding = kRounding * SpeedsOf(rows, row, context);
        // In a disc, a force at its limit may be below it in each row.
        const bool slips = rows.disc && row < 2 && (item.active >> row & 1) == 0;
        const double missed = mayMove || slips ? 0.0 : std::abs(off) - rounding;
        error = std::max(error, missed * ReachOf(rows, row));
    }
    return float32(error);
}

void BoundedSystem::Build(const Array<RowSides>& sides, int32 maxUpdates, Elimination& elimination)
{
    m_system.Build(sides, maxUpdates, elimination);
    const auto resize = [](auto& array, std::size_t count) {
        MakeRoom(array, count);
        array.resize(count);
    };
    resize(m_items, sides.size());
    resize(m_given, sides.size());
    resize(m_masses, m_system.Bodies().size());
    for (Solution* solution : {&m_before, &m_marked})
    {
        resize(solution->impulses, sides.size());
        resize(solution->velocities, m_masses.size());
    }
}

void BoundedSystem::Begin(const SolverContext& context)
{
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        m_system.Read(i);
    }
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const JointRows& rows = m_system.Rows(i);
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            m_given[i].at[row] = GivenSpeed(rows, row, context);
        }
    }
    for (std::size_t i = 0; i < m_masses.size(); ++i)
    {
        const BodyData& body = *m_system.Bodies()[i];
        const double invInertia = body.SolverInvInertia();
        m_masses[i] = {body.SolverIndex(), 1.0 / double(body.SolverInvMass()),
                       invInertia > 0.0 ? 1.0 / invInertia : 0.0};
    }
}

void BoundedSystem::Minimize(const SolverContext& context, double tolerance)
{
    m_energy = Energy(context);
    for (int32 round = 0; round < kMaxRounds; ++round)
    {
        if (!Improve(context) && !Release(context, tolerance))
        {
            break;
        }
    }
}

/// Releases rows that should not be at a bound: their speed shows that a smaller impulse suffices.
/// Returns true if there were any.
bool BoundedSystem::Release(const SolverContext& context, double tolerance)
{
    bool any = false;
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        Item& item = m_items[i];
        const JointRows& rows = m_system.Rows(i);
        const Vector3 speed = m_system.SpeedOf(context, i, m_given[i]);
        for (int32 row = 0; row < rows.rows; ++row)
        {
            const double off = speed.at[row] + SoftSpeed(rows, item, row) - item.speeds.at[row];
            const bool wantsMore = off < -tolerance && item.impulse.at[row] < item.maximum.at[row];
            const bool wantsLess = off > tolerance && item.impulse.at[row] > item.minimum.at[row];
            if ((item.active >> row & 1) == 0 && (wantsMore || wantsLess))
            {
                item.active = uint8(item.active | 1 << row);
                any = true;
            }
        }
    }
    return any;
}

bool BoundedSystem::HasOtherLimit(std::size_t index, int32 row, double maximum) const
{
    const Item& item = m_items[index];
    const double before = item.maximum.at[row];
    const bool held = (item.active >> row & 1) != 0;
    return held ? std::abs(item.impulse.at[row]) > maximum
                : std::abs(maximum - before) > kSameLimit * before;
}

void BoundedSystem::Limit(const SolverContext& context, std::size_t index, int32 row,
                          double maximum)
{
    Item& item = m_items[index];
    item.minimum.at[row] = -maximum;
    item.maximum.at[row] = maximum;
    double& impulse = item.impulse.at[row];
    const bool held = (item.active >> row & 1) != 0;
    const double inside =
        held ? std::clamp(impulse, -maximum, maximum) : (impulse < 0.0 ? -maximum : maximum);
    if (inside != impulse)
    {
        Vector3 change{};
        change.at[row] = inside - impulse;
        impulse = inside;
        item.active = uint8(item.active & ~(1u << row));
        m_system.Push(context, index, change);
    }
}

/// Without a force the rows stay at their bounds of zero.
bool BoundedSystem::IsDisc(std::size_t index) const
{
    const JointRows& rows = m_system.Rows(index);
    return rows.disc && rows.laws[0].maximum > 0.0f;
}

/// Returns the impulse that the first two rows need. It is longer than their maximum if they slip.
b2Vec2 BoundedSystem::DiscImpulse(const SolverContext& context, std::size_t index) const
{
    const Item& item = m_items[index];
    const b2Vec2 impulse(float32(item.impulse.at[0]), float32(item.impulse.at[1]));
    if ((item.active & 3) == 3)
    {
        return impulse;
    }
    const JointRows& rows = m_system.Rows(index);
    const Vector3 speed = m_system.SpeedOf(context, index, m_given[index]);
    b2Vec2 residual;
    for (int32 row = 0; row < 2; ++row)
    {
        residual(row) = float32(item.speeds.at[row] - SoftSpeed(rows, item, row) - speed.at[row]);
    }
    return SlippingImpulse(rows, impulse, residual, rows.laws[0].maximum);
}

bool BoundedSystem::HasOtherDisc(const SolverContext& context, std::size_t index) const
{
    if (!IsDisc(index))
    {
        return false;
    }
    const Item& item = m_items[index];
    const float32 maximum = m_system.Rows(index).laws[0].maximum;
    const b2Vec2 needed = DiscImpulse(context, index);
    const bool slipped = item.minimum.at[0] == item.maximum.at[0];
    const b2Vec2 off = ClampLength(needed, maximum) -
                       b2Vec2(float32(item.impulse.at[0]), float32(item.impulse.at[1]));
    return slipped != (needed.Length() > maximum) || off.Length() > float32(kSameLimit) * maximum;
}

void BoundedSystem::LimitDisc(const SolverContext& context, std::size_t index)
{
    if (!IsDisc(index))
    {
        return;
    }
    Item& item = m_items[index];
    const float32 maximum = m_system.Rows(index).laws[0].maximum;
    const b2Vec2 needed = DiscImpulse(context, index);
    const bool slips = needed.Length() > maximum;
    const b2Vec2 held = ClampLength(needed, maximum);
    Vector3 change{};
    for (int32 row = 0; row < 2; ++row)
    {
        const double inside = slips ? double(held(row)) : item.impulse.at[row];
        change.at[row] = inside - item.impulse.at[row];
        item.impulse.at[row] = inside;
        item.minimum.at[row] = slips ? inside : -double(maximum);
        item.maximum.at[row] = slips ? inside : double(maximum);
    }
    item.active = uint8(slips ? item.active & ~3u : item.active | 3u);
    m_system.Push(context, index, change);
}

void BoundedSystem::Mark(const SolverContext& context)
{
    Save(context, m_marked);
    m_marked.energy = Energy(context);
    m_markedFastest = Fastest(context);
    m_markedKinetic = KineticEnergyOfAll(context);
}

void BoundedSystem::KeepIfBetter(const SolverContext& context)
{
    if (!(Energy(context) <= m_marked.energy) || HasBurst(context))
    {
        GoBack(context);
    }
}

void BoundedSystem::GoBack(const SolverContext& context)
{
    Restore(context, m_marked);
}

template <class Motion>
double BoundedSystem::FastestGiven(Motion&& motion) const
{
    double fastest = 0.0;
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const JointRows& rows = m_system.Rows(i);
        for (int32 side = 0; side < rows.bodies; ++side)
        {
            const JointRows::Column& c = rows.columns[side];
            if (!Moves(c.invMass, c.invInertia))
            {
                const SolverBody s = motion(*c.data);
                for (int32 row = 0; row < rows.rows; ++row)
                {
                    fastest = std::max(fastest, std::abs(SpeedFrom(c, row, s)));
                }
            }
        }
    }
    return fastest;
}

/// All are compared with the first one, as if they were parts of it.
double BoundedSystem::FastestDriven(const SolverContext& context) const
{
    const BodyData* first = nullptr;
    double fastest = 0.0;
    const double driven = FastestGiven([&](const BodyData& body) {
        first = first != nullptr ? first : &body;
        const SolverBody& whole = context.bodies[first->SolverIndex()];
        SolverBody s = context.bodies[body.SolverIndex()];
        fastest = std::max(fastest, double(s.v.Length() + whole.v.Length()));
        s.v -= whole.v + b2Cross(whole.w, CenterOffset(*first, body));
        s.w -= whole.w;
        return s;
    });
    return std::max(driven - kRounding * fastest, 0.0);
}

bool BoundedSystem::Separates(const SolverContext& context, std::size_t items,
                              double tolerance) const
{
    for (std::size_t i = 0; i < items; ++i)
    {
        const Item& item = m_items[i];
        const Vector3 speed = SpeedOf(context, m_system.Rows(i));
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            const bool pushes = item.minimum.at[row] == 0.0 && item.maximum.at[row] >= kUnbounded;
            if (pushes && speed.at[row] < item.speeds.at[row] - tolerance)
            {
                return false;
            }
        }
    }
    return true;
}

bool BoundedSystem::HasBurst(const SolverContext& context) const
{
    return Fastest(context) > kBurst * b2Max(m_markedFastest, kMinSpeedBefore) || HasEndlessWork();
}

bool BoundedSystem::HasGained(const SolverContext& context) const
{
    const auto isGiven = [](const Vector3& speeds) {
        return speeds.at[0] != 0.0 || speeds.at[1] != 0.0 || speeds.at[2] != 0.0;
    };
    return !(KineticEnergyOfAll(context) <= (1.0 + kEnergyRounding) * m_markedKinetic) &&
           std::ranges::none_of(m_given, isGiven);
}

/// The work of springs, motors and friction is bounded, that of platforms is not counted here.
bool BoundedSystem::HasEndlessWork() const
{
    double work = 0.0;
    double fastest = 0.0;
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const Item& item = m_items[i];
        const JointRows& rows = m_system.Rows(i);
        for (int32 row = 0; row < rows.rows; ++row)
        {
            const double impulse = item.impulse.at[row];
            const double bound = impulse > 0.0 ? item.maximum.at[row] : -item.minimum.at[row];
            if (rows.laws[row].softness == 0.0f && bound >= kUnbounded)
            {
                work += impulse * item.speeds.at[row];
                fastest = impulse != 0.0 ? b2Max(fastest, std::abs(item.speeds.at[row])) : fastest;
            }
        }
    }
    double mass = 0.0; // and inertias, for target speeds are those of lines or of angles
    for (const Mass& body : m_masses)
    {
        mass += body.mass + body.inertia;
    }
    return work > kMaxWork * (m_markedKinetic + 0.5 * mass * fastest * (fastest + kMinSpeedBefore));
}

/// Returns the maximum speed of all points of the bodies, and of all prescribed speeds and those
/// that rows bring bodies to [m/s].
double BoundedSystem::Fastest(const SolverContext& context) const
{
    double fastest =
        FastestGiven([&](const BodyData& body) { return context.bodies[body.SolverIndex()]; });
    for (const BodyData* body : m_system.Bodies())
    {
        const SolverBody& s = context.bodies[body->SolverIndex()];
        fastest = std::max(fastest, double(s.v.Length() + b2Abs(s.w) * body->maxExtent));
    }
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const JointRows& rows = m_system.Rows(i);
        for (int32 row = 0; row < rows.rows; ++row)
        {
            fastest = std::max(fastest, ReachedSpeed(m_system.Response(i).at[row],
                                                     double(rows.laws[row].softness),
                                                     m_items[i].speeds.at[row]));
        }
    }
    return fastest;
}

/// False if no bound was reached: this is the solution.
bool BoundedSystem::Improve(const SolverContext& context)
{
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        m_system.SetActive(i, m_items[i].active);
        const Vector3 speed = m_system.SpeedOf(context, i, m_given[i]);
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            m_system.Residual(i).at[row] = m_items[i].speeds.at[row] -
                                           SoftSpeed(m_system.Rows(i), m_items[i], row) -
                                           speed.at[row];
        }
    }
    for (int32 i = 0; i < m_system.Components(); ++i)
    {
        m_system.Factor(i);
        m_system.Solve(i);
    }
    Save(context, m_before);
    bool met = Move(context, 1.0);
    double energy = Energy(context);
    if (met && energy > m_energy)
    {
        // Up to the first bound the energy can only decrease.
        Restore(context, m_before);
        (void)Move(context, ShareWithin());
        energy = Energy(context);
        met = true;
    }
    m_energy = energy;
    return met;
}

/// Changes all impulses by a fraction of the solution, within their bounds. Rows that reach one
/// become inactive. Returns true if any did.
bool BoundedSystem::Move(const SolverContext& context, double share)
{
    bool met = false;
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        Vector3 change{};
        if (m_items[i].active != 0)
        {
            met = MoveItem(i, share, change) || met;
            m_system.Push(context, i, change);
        }
    }
    return met;
}

bool BoundedSystem::MoveItem(std::size_t index, double share, Vector3& change)
{
    Item& item = m_items[index];
    const Vector3& found = m_system.Found(index);
    bool met = false;
    for (int32 row = 0; row < JointRows::kMaxRows; ++row)
    {
        if ((item.active >> row & 1) == 0)
        {
            continue;
        }
        const double minimum = item.minimum.at[row];
        const double maximum = item.maximum.at[row];
        const double total = item.impulse.at[row] + share * found.at[row];
        const double inside = std::clamp(total, minimum, maximum);
        change.at[row] = inside - item.impulse.at[row];
        item.impulse.at[row] = inside;
        const double step = found.at[row];
        const bool meets = (step < 0.0 && inside <= minimum) || (step > 0.0 && inside >= maximum);
        if (inside != total || (share < 1.0 && meets))
        {
            item.active = uint8(item.active & ~(1u << row));
            met = true;
        }
    }
    return met;
}

/// Returns the largest fraction of the solution that exceeds no bound.
double BoundedSystem::ShareWithin() const
{
    double share = 1.0;
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const Item& item = m_items[i];
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            const double step = m_system.Found(i).at[row];
            const double impulse = item.impulse.at[row];
            const double inside =
                std::clamp(impulse + step, item.minimum.at[row], item.maximum.at[row]);
            if ((item.active >> row & 1) != 0 && inside != impulse + step)
            {
                share = std::min(share, (inside - impulse) / step);
            }
        }
    }
    return share;
}

double BoundedSystem::KineticEnergyOfAll(const SolverContext& context) const
{
    double sum = 0.0;
    for (const Mass& body : m_masses)
    {
        sum += KineticEnergy(context.bodies[body.body], body.mass, body.inertia);
    }
    return sum;
}

/// Returns the function that the correct impulses minimize: the energy of the bodies minus the work
/// of belts and platforms.
double BoundedSystem::Energy(const SolverContext& context) const
{
    double sum = KineticEnergyOfAll(context);
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        const Item& item = m_items[i];
        const JointRows& rows = m_system.Rows(i);
        for (int32 row = 0; row < rows.rows; ++row)
        {
            const double off = item.impulse.at[row] - item.start.at[row];
            sum += item.impulse.at[row] * (m_given[i].at[row] - item.speeds.at[row]) +
                   0.5 * SoftSpeed(rows, item, row) * off;
        }
    }
    return sum;
}

void BoundedSystem::Save(const SolverContext& context, Solution& solution) const
{
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        solution.impulses[i] = {m_items[i].impulse, m_items[i].active};
    }
    for (std::size_t i = 0; i < m_masses.size(); ++i)
    {
        const SolverBody& body = context.bodies[m_masses[i].body];
        solution.velocities[i] = {body.v, body.w};
    }
}

void BoundedSystem::Restore(const SolverContext& context, const Solution& solution)
{
    for (std::size_t i = 0; i < m_items.size(); ++i)
    {
        m_items[i].impulse = solution.impulses[i].impulse;
        m_items[i].active = solution.impulses[i].active;
    }
    for (std::size_t i = 0; i < m_masses.size(); ++i)
    {
        SolverBody& body = context.bodies[m_masses[i].body];
        body.v = solution.velocities[i].v;
        body.w = solution.velocities[i].w;
    }
}

} // namespace box2d
