// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

class b2Body;

namespace box2d
{

/// How an island moves as a whole, and what moves within it, while a step has not been written
/// back.
class IslandMotion
{
public:
    /// The island's first body; velocities and ways by solver index.
    IslandMotion(const b2Body& first, SolverBody* bodies);

    double Energy() const { return m_all; } ///< kinetic [J]
    double Mass() const { return m_mass; }
    /// Takes kinetic energy away, no more than there is. Of a free island what moves within is
    /// slowed down first: its momentum and angular momentum stay as they are for as long as that is
    /// enough. What is held or touched by something immovable has none of its own to keep, and
    /// slowing all of it down alike opens no joint.
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
    // As if it were rigid; nothing when it is held.
    double m_rigid = 0.0; // [J]
    b2Vec2 m_centre;      // seen from the first body's at the start of the step
    b2Vec2 m_velocity;
    float32 m_spin = 0.0f;
};

} // namespace box2d
