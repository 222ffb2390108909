// SPDX-License-Identifier: MIT
#pragma once

#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>

#include <Box2D/Box2D.h>

/// Steps without the energy guard, to measure what it takes: the same world is stepped with it and
/// without. Nothing in the engine switches it off, but it leaves alone what the program has moved.
namespace dynamics
{

/// Call it before a step, which the guard then leaves alone. Only the guard reads this mark.
inline void LeaveNextStepUnguarded(b2World& world)
{
    for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_dynamicBody)
        {
            box2d::BodyData& data = box2d::Data(*body);
            data.userMovedAt = data.world->stepNumber;
        }
    }
}

/// Returns the kinetic energy of all bodies that forces move [J].
inline double KineticOf(const b2World& world)
{
    double sum = 0.0;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_dynamicBody)
        {
            const box2d::BodyData& data = box2d::Data(*body);
            const auto spin = double(data.angularVelocity);
            sum += 0.5 * double(data.mass) * double(data.linearVelocity.LengthSquared()) +
                   0.5 * double(data.inertia) * spin * spin;
        }
    }
    return sum;
}

} // namespace dynamics
