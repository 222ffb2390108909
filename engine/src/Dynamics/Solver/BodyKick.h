// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

/// The effect of gravity, forces and damping on a body in sub-steps.
namespace box2d
{

/// The factor that damping c leaves of a velocity after a time t, exp(-c t). Also the effective
/// time of an acceleration, (1 - exp(-c t)) / c. It uses the Pade approximant (0, 2) of exp(-z),
/// which is of second order and stable for any z.
struct Decay
{
    Decay(float32 t, float32 c) : left(1.0f), time(t)
    {
        if (c > 0.0f)
        {
            const float32 z = c * t;
            left = 1.0f / (1.0f + z + 0.5f * z * z);
            time = t * (1.0f + 0.5f * z) * left; // (1 - left) / c without cancellation
        }
    }
    float32 left;
    float32 time; ///< [s]
};

/// The values of a body for the whole step, next to each other: those of BodyData are far apart.
/// Acceleration, damping, mass and inertia are 0 unless the body is dynamic.
struct BodyKick
{
    b2Vec2 acceleration;                ///< [m/s^2]
    float32 angularAcceleration = 0.0f; ///< [rad/s^2]
    float32 linearDamping = 0.0f, angularDamping = 0.0f;
    float32 mass = 0.0f, inertia = 0.0f;
    float32 maxExtent = 0.0f; ///< [m]

    BodyKick() = default;
    BodyKick(const BodyData& body, const b2Vec2& gravity) : maxExtent(body.maxExtent)
    {
        if (body.IsDynamic())
        {
            acceleration = body.gravityScale * gravity + body.invMass * body.force;
            angularAcceleration = body.invInertia * body.torque;
            linearDamping = body.linearDamping;
            angularDamping = body.angularDamping;
            mass = body.mass;
            inertia = body.inertia;
        }
    }

    void Give(SolverBody& body, float32 time) const
    {
        const Decay linear(time, linearDamping);
        const Decay angular(time, angularDamping);
        body.v = Bounded(linear.left * body.v + linear.time * acceleration);
        body.w = Bounded(angular.left * body.w + angular.time * angularAcceleration);
    }
};

} // namespace box2d
