// SPDX-License-Identifier: MIT
#include "Closing.h"
#include "JointSystem.h"

#include "../Direct/Disc.h"
#include "../Joints/JointFrame.h"

#include <algorithm>
#include <cmath>

/// Motors, limits and friction in the JointSystem. Each bounded row is either active, held at a
/// speed, or inactive, with its impulse at a bound. A direct solution shows which rows are in the
/// wrong state; all are changed at once, and the system is solved again.
namespace box2d
{

namespace
{

float32 WantedOf(const JointRows::Law& law)
{
    return b2Clamp(law.wanted, law.slowest, law.fastest);
}

/// Returns the impulse that brings a single row to its target speed.
float32 ResidualImpulse(const JointRows& rows, int32 row, float32 speed)
{
    const JointRows::Law& law = rows.laws[row];
    float32 response = law.softness;
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        response += rows.columns[side].InverseMassOf(row);
    }
    const float32 residual = WantedOf(law) - law.softness * rows.impulse[row] - speed;
    return response > 0.0f ? residual / response : 0.0f;
}

b2Vec2 PairOf(const float32 (&impulse)[JointRows::kMaxRows])
{
    return b2Vec2(impulse[0], impulse[1]);
}

} // namespace

/// A change of a joint's settings since the last kick may have made it impossible.
void JointSystem::Validate(const JointRows& rows, RowStates& states)
{
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        const JointRows::Law& law = rows.laws[i];
        RowState& state = states.of[i];
        const bool unbounded = (state == RowState::Slowest && law.slowest == -b2_maxFloat) ||
                               (state == RowState::Fastest && law.fastest == b2_maxFloat);
        if (unbounded || law.maximum == b2_maxFloat)
        {
            state = RowState::Holds;
        }
        if (state == RowState::Holds && (law.maximum == 0.0f || law.DrivesAbove()))
        {
            state = RowState::AtMax;
        }
        if (state == RowState::Holds && law.DrivesBelow())
        {
            state = RowState::AtMin;
        }
    }
}

/// Returns the warm starting impulse of a row. Directly solved rows start at zero: the result is
/// the same, and contradictory joints do not accumulate impulses.
float32 JointSystem::WarmStartImpulse(std::size_t joint, int32 row, float32 share) const
{
    const JointRows& rows = m_system.Rows(joint);
    const RowStates& states = m_states[joint];
    const bool alone = row >= rows.Rigid() && !(rows.disc && row < 2);
    if (alone && states.of[row] == RowState::AtMax)
    {
        return rows.laws[row].maximum;
    }
    if (alone && states.of[row] == RowState::AtMin)
    {
        return -rows.laws[row].maximum;
    }
    const bool slips = rows.disc && row < 2 && states.of[row] == RowState::AtMax;
    return slips ? share * rows.impulse[row] : 0.0f;
}

/// Removes rows with an impulse at a bound from the system.
void JointSystem::SetActive(std::size_t joint)
{
    const JointRows& rows = m_system.Rows(joint);
    uint8 active = 7;
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        const RowState state = m_states[joint].of[i];
        if (state == RowState::AtMax || state == RowState::AtMin)
        {
            active = uint8(active & ~(1u << i));
        }
    }
    m_system.SetActive(joint, active);
}

/// Closing also holds limits that the kick had no need to push: a body on a circle leaves its
/// tangent in the drift.
bool JointSystem::IsHeld(std::size_t joint, int32 row, const SolverContext& context) const
{
    const RowState state = m_states[joint].of[row];
    return state == RowState::Slowest || state == RowState::Fastest ||
           m_system.Rows(joint).laws[row].IsNear(kNearlyClosed * context.inverseStep);
}

/// For closing, only rigid rows and limits take part. Motors and springs act in the kicks, and
/// would act twice. True if the active rows differ from those of the kick.
bool JointSystem::SetActiveToClose(std::size_t joint, const SolverContext& context)
{
    const JointRows& rows = m_system.Rows(joint);
    uint8 active = uint8((1u << rows.Rigid()) - 1u);
    bool other = false;
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        const RowState state = m_states[joint].of[i];
        const bool was = state != RowState::AtMax && state != RowState::AtMin;
        const bool held = IsHeld(joint, i, context);
        active = uint8(active | unsigned(held) << i);
        other = other || was != held;
    }
    m_system.SetActive(joint, active);
    return other;
}

/// Sets the residuals of the target speeds.
void JointSystem::WantSpeeds(std::size_t joint, const SolverContext& context)
{
    const JointRows& rows = m_system.Rows(joint);
    Vector3 wanted{};
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        wanted.at[i] = WantedSpeed(rows, m_states[joint].of[i], i, double(rows.impulse[i]));
    }
    const Vector3 speed = SpeedOf(context, rows);
    for (int32 k = 0; k < JointRows::kMaxRows; ++k)
    {
        m_system.Residual(joint).at[k] = wanted.at[k] - speed.at[k];
    }
}

double JointSystem::WantedSpeed(const JointRows& rows, RowState state, int32 row, double impulse)
{
    const JointRows::Law& law = rows.laws[row];
    switch (state)
    {
    case RowState::Holds:
        return double(WantedOf(law)) - double(law.softness) * impulse;
    case RowState::Slowest:
        return double(law.slowest);
    case RowState::Fastest:
        return double(law.fastest);
    case RowState::AtMax:
    case RowState::AtMin:
        break;
    }
    // A row at its limit keeps its target speed: contacts may take up its work and make it active.
    return double(WantedOf(law));
}

double JointSystem::MaxWork(std::size_t joint, const SolverContext& before,
                            const SolverContext& after) const
{
    const JointRows& rows = m_system.Rows(joint);
    const Vector3 from = SpeedOf(before, rows);
    const Vector3 to = SpeedOf(after, rows);
    double work = 0.0;
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        const JointRows::Law& law = rows.laws[i];
        const RowState state = m_states[joint].of[i];
        const float32 within = rows.disc && i < 2 ? rows.impulse[i] : law.Within(rows.impulse[i]);
        const float32 bound = state == RowState::Slowest   ? law.slowest
                              : state == RowState::Fastest ? law.fastest
                                                           : 0.0f;
        const double wanted = b2Max(double(within) * double(law.wanted), 0.0) +
                              b2Max(double(rows.impulse[i] - within) * double(bound), 0.0);
        const double done = 0.5 * double(rows.impulse[i]) * (from.at[i] + to.at[i]);
        work += b2Min(wanted, b2Max(done, 0.0));
    }
    return work;
}

/// True if the state of a row changed, so that the system must be solved again.
bool JointSystem::Reconsider(std::size_t joint, const SolverContext& context, bool settles)
{
    const JointRows& rows = m_system.Rows(joint);
    const Vector3& speed = m_speeds[joint];
    bool changed = false;
    int32 row = rows.Rigid();
    if (rows.disc)
    {
        changed = ReconsiderDisc(context, joint, speed, settles);
        row = 2;
    }
    for (; row < rows.rows; ++row)
    {
        changed = Reconsider(context, joint, row, float32(speed.at[row]), settles) || changed;
    }
    return changed;
}

bool JointSystem::Reconsider(const SolverContext& context, std::size_t joint, int32 row,
                             float32 speed, bool settles)
{
    JointRows& rows = m_system.Rows(joint);
    const JointRows::Law& law = rows.laws[row];
    RowState& state = m_states[joint].of[row];
    const float32 impulse = rows.impulse[row];
    RowState next = After(law, state, impulse, speed);
    // The bounds change with every kick.
    float32 bound = next == RowState::AtMax ? law.maximum : -law.maximum;
    if (settles && next == RowState::Holds && state != RowState::Holds)
    {
        next = state;
        bound = b2Clamp(impulse + ResidualImpulse(rows, row, speed), -law.maximum, law.maximum);
    }
    const bool moves = (next == RowState::AtMax || next == RowState::AtMin) && impulse != bound;
    if (moves)
    {
        Vector3 difference{};
        difference.at[row] = double(bound) - double(impulse);
        Push(context, rows, difference);
        rows.impulse[row] = bound;
    }
    const bool changed = moves || next != state;
    state = next;
    return changed;
}

/// Returns the next state from a row's impulse and speed. The impulse is a step function of the
/// speed. At the lowest speed it is above the maximum. From there to the target speed it is the
/// maximum, and above that the minimum. At the highest speed it is below the minimum. If the target
/// is below the lowest speed, the impulse is the minimum at all speeds, and vice versa.
JointSystem::RowState JointSystem::After(const JointRows::Law& law, RowState state, float32 impulse,
                                         float32 speed)
{
    const float32 same = JointRows::kSameSpeed * (1.0f + b2Abs(speed));
    const float32 wanted = WantedOf(law);
    switch (state)
    {
    case RowState::Holds:
        return impulse > law.maximum    ? RowState::AtMax
               : impulse < -law.maximum ? RowState::AtMin
                                        : state;
    case RowState::Slowest:
        return impulse >= law.Within(law.maximum) ? state
               : law.DrivesBelow()                ? RowState::AtMin
                                                  : RowState::AtMax;
    case RowState::Fastest:
        return impulse <= law.Within(-law.maximum) ? state
               : law.DrivesAbove()                 ? RowState::AtMax
                                                   : RowState::AtMin;
    case RowState::AtMax:
    case RowState::AtMin:
        break;
    }
    if (speed < law.slowest - same)
    {
        return RowState::Slowest;
    }
    if (speed > law.fastest + same)
    {
        return RowState::Fastest;
    }
    const bool tooMuch = state == RowState::AtMax && speed > wanted + same;
    const bool tooLittle = state == RowState::AtMin && speed < wanted - same;
    if (law.maximum == 0.0f || !(tooMuch || tooLittle))
    {
        return state;
    }
    return law.DrivesBelow()   ? RowState::AtMin
           : law.DrivesAbove() ? RowState::AtMax
                               : RowState::Holds;
}

/// Returns the displacement of a drift beyond limits, by row, except for the error before it.
Vector3 JointSystem::Beyond(std::size_t joint, const JointRows& now,
                            const SolverContext& context) const
{
    Vector3 beyond{};
    const JointRows& rows = m_system.Rows(joint);
    for (int32 i = rows.Rigid(); i < rows.rows; ++i)
    {
        const double path = double(now.error[i]) - double(RemainingOf(rows, i));
        if (rows.laws[i].IsLimited() && path * double(now.error[i]) > 0.0 &&
            IsHeld(joint, i, context))
        {
            beyond.at[i] = path;
        }
    }
    return beyond;
}

/// Two rows whose impulses are bounded as a vector: while slipping, the vector is opposed to the
/// slip.
bool JointSystem::ReconsiderDisc(const SolverContext& context, std::size_t joint,
                                 const Vector3& speed, bool settles)
{
    RowStates& states = m_states[joint];
    JointRows& rows = m_system.Rows(joint);
    const float32 maximum = rows.laws[0].maximum;
    const b2Vec2 impulse = PairOf(rows.impulse);
    b2Vec2 wanted = impulse;
    if (states.of[0] != RowState::Holds)
    {
        const b2Vec2 residual(
            rows.laws[0].wanted - rows.laws[0].softness * impulse.x - float32(speed.at[0]),
            rows.laws[1].wanted - rows.laws[1].softness * impulse.y - float32(speed.at[1]));
        wanted = SlippingImpulse(rows, impulse, residual, maximum);
    }
    const bool slips = maximum == 0.0f || wanted.LengthSquared() > maximum * maximum ||
                       (settles && states.of[0] == RowState::AtMax);
    const RowState next = slips ? RowState::AtMax : RowState::Holds;
    const bool changed = states.of[0] != next;
    states.of[0] = states.of[1] = next;
    if (!slips)
    {
        return changed;
    }
    const b2Vec2 difference = ClampLength(wanted, maximum) - impulse;
    if (!changed && difference.Length() <= kSameImpulse * maximum)
    {
        return false;
    }
    Push(context, rows, Vector3{{double(difference.x), double(difference.y), 0.0}});
    return true;
}

/// Adds the impulses of the solved kick.
void JointSystem::AddTotals()
{
    for (const std::size_t i : m_rowed)
    {
        AddTotals(i);
    }
}

void JointSystem::AddTotals(std::size_t joint)
{
    const JointRows& rows = m_system.Rows(joint);
    Totals& totals = m_totals[joint];
    for (int32 k = 0; k < rows.rows; ++k)
    {
        const float32 within =
            rows.disc && k < 2 ? rows.impulse[k] : rows.laws[k].Within(rows.impulse[k]);
        totals.within[k] += within;
        totals.beyond[k] += rows.impulse[k] - within;
    }
}

} // namespace box2d
