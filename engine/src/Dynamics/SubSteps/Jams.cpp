// SPDX-License-Identifier: MIT
#include "Jams.h"

#include "../Direct/BoundedSystem.h"

#include <algorithm>

namespace box2d
{

namespace
{

/// Contacts are contradictory above this multiple of the impulse that brings the whole island to
/// the pusher's speed and stops its weight. With 1000 a door presses a box at a wall with 32 m/s
/// instead of 28; with 1 no verdict changes (docs/notes/tuned-constants.md).
constexpr double kMaxLoad = 10.0;
/// A body between two sides of another one holds itself by friction with any impulse. Contacts are
/// softened above this multiple of the impulse that one of the two bodies requires of them. With
/// 100 times what stops the island, a tray that tilts throws its box
/// (docs/notes/sub-steps-motors-and-jams.md).
constexpr double kMaxWedged = 30.0;

double MassOf(const BoundedSystem& system)
{
    double mass = 0.0;
    for (const BodyData* body : system.Bodies())
    {
        mass += 1.0 / double(body->SolverInvMass());
    }
    return mass;
}

/// Returns the larger one of the two normal impulses of a contact [Ns].
double PushOf(const BoundedSystem::Item& contact)
{
    return double(b2Max(contact.impulse.at[0], contact.impulse.at[1]));
}

/// Returns the impulse that an item gives to a body, its moment at the body's extent included [Ns].
double ImpulseOn(const BodyData& body, const JointRows& rows, const BoundedSystem::Item& item)
{
    for (int32 i = 0; i < rows.bodies; ++i)
    {
        const JointRows::Column& column = rows.columns[i];
        if (column.data == &body)
        {
            b2Vec2 impulse = b2Vec2_zero;
            float32 moment = 0.0f;
            for (int32 k = 0; k < rows.rows; ++k)
            {
                const auto j = float32(item.impulse.at[k]);
                impulse += j * b2Vec2(column.x[k], column.y[k]);
                moment += j * column.w[k];
            }
            return double(impulse.Length() + b2Abs(moment) / b2Max(body.maxExtent, b2_linearSlop));
        }
    }
    return 0.0;
}

/// Returns the impulse that a body requires of its contacts with another one [Ns]: to stop against
/// it, for what its velocity has changed by in this step, and for its weight.
double RequiredImpulse(const JointRows::Column& column, const JointRows::Column& other,
                       const SolverContext& context, double weight)
{
    if (column.invMass == 0.0f)
    {
        return BoundedSystem::kUnbounded;
    }
    const BodyData& body = *column.data;
    const SolverBody& s = context.bodies[column.body];
    const SolverBody& o = context.bodies[other.body];
    const auto spin = [](const SolverBody& now, const BodyData& before) {
        return b2Max(b2Abs(now.w), b2Abs(before.angularVelocity)) * before.maxExtent;
    };
    const float32 v = (s.v - o.v).Length() + (s.v - body.linearVelocity).Length() + spin(s, body) +
                      (other.invMass > 0.0f ? spin(o, *other.data) : 0.0f);
    return (double(v) + weight) / double(column.invMass);
}

bool IsPushed(const BodyData& body)
{
    return body.force != b2Vec2_zero || body.torque != 0.0f;
}

} // namespace

bool IsJammed(BoundedSystem& system, std::size_t contacts, const SolverContext& context,
              double driven, double weight)
{
    if (system.HasBurst(context))
    {
        return true;
    }
    const double maximum = kMaxLoad * (driven + weight) * MassOf(system);
    for (std::size_t i = 0; i < contacts && driven > 0.0; ++i)
    {
        if (PushOf(system.At(i)) > maximum)
        {
            return true;
        }
    }
    return false;
}

bool IsWedged(BoundedSystem& system, std::size_t contacts, const SolverContext& context,
              double weight)
{
    for (std::size_t i = 0; i < contacts; ++i)
    {
        const JointRows& rows = system.Rows(i);
        const JointRows::Column& a = rows.columns[0];
        const JointRows::Column& b = rows.columns[1];
        if (IsPushed(*a.data) || IsPushed(*b.data))
        {
            continue; // forces with long levers may require any impulse
        }
        double requiredOfA = RequiredImpulse(a, b, context, weight);
        double requiredOfB = RequiredImpulse(b, a, context, weight);
        const double push = PushOf(system.At(i));
        if (push <= kMaxWedged * std::min(requiredOfA, requiredOfB))
        {
            continue;
        }
        for (std::size_t k = 0; k < system.Count(); ++k)
        {
            const double onA = ImpulseOn(*a.data, system.Rows(k), system.At(k));
            const double onB = ImpulseOn(*b.data, system.Rows(k), system.At(k));
            if (onA > 0.0 && onB > 0.0 && k < contacts)
            {
                continue; // of the pair itself
            }
            requiredOfA += onA;
            requiredOfB += onB;
        }
        if (push > kMaxWedged * std::min(requiredOfA, requiredOfB))
        {
            return true;
        }
    }
    return false;
}

} // namespace box2d
