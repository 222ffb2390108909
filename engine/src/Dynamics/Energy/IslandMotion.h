// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

class b2Body;

namespace box2d
{

/// The rigid and the relative motion of an island, before a step is written back.
class IslandMotion
{
public:
    /// Takes the island's first body, and velocities and displacements by solver index.
    IslandMotion(const b2Body& first, SolverBody* bodies);

    double Energy() const { return m_all; } ///< kinetic energy [J]
    double Mass() const { return m_mass; }
    /// Removes kinetic energy, at most what there is. For a free island the relative motion is
    /// removed first, which conserves momentum and angular momentum. An island held or touched by a
    /// static body has no momentum to conserve, and a uniform reduction opens no joint.
    void Lose(double energy);

private:
    template <class Function>
    void ForEach(Function&& function) const;
    b2Vec2 PlaceOf(const BodyData& data) const;
    void FindRigidMotion();

    const b2Body& m_first;
    SolverBody* m_bodies;
    double m_mass = 0.0; // [kg]
    double m_all = 0.0;  // [J]
    // Energy of the rigid motion; 0 when the island is held.
    double m_rigid = 0.0; // [J]
    b2Vec2 m_centre;      // relative to the first body's at the start of the step
    b2Vec2 m_velocity;
    float32 m_spin = 0.0f;
};

} // namespace box2d
