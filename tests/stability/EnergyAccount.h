// SPDX-License-Identifier: MIT
#pragma once

#include "RandomWorlds.h"

#include <vector>

/// What the energy of a random world may be at most. The world's own is
///   kinetic + potential, above the lowest corner of the container, so that no part is negative
///   + what springs store, k x^2 / 2, with the k that the frequency means at the present pose
///   + for mice, the same up to their greatest force F, and F times the way beyond: such a pull
///     never does more work than this potential loses, for the clamp onto what it may do is
///     monotone.
/// What comes in is
///   + of a motor its greatest force times its speed times the time: it pushes forward only what is
///     slower than that
///   + of a motor joint its greatest force times the speed of its points against each other, but
///   not
///     more than the speed with which it wants to take back its error: with that speed it would do
///     no work at all. The same of its torque.
///   + what changes at once: the potential of a mouse when its target moves
///   + of a spring x^2 / 2 times the change of k, for its k follows the mass that it moves, and
///   that
///     changes with the pose.
/// All else (contacts with restitution up to 1, friction, damping, limits, ropes, gears, the
/// start of rigid joints, the ends of sleeping) can only take away.
namespace stability
{

class EnergyAccount
{
public:
    explicit EnergyAccount(RandomWorld& world);

    void BeforeTargets();
    void AfterTargets();
    void BeforeStep();
    void AfterStep();

    double Kinetic() const;
    double Potential() const;
    double Stored() const;
    double Total() const { return Kinetic() + Potential() + Stored(); }
    double Start() const { return m_start; }
    double PutIn() const { return m_putIn; } ///< since the start
    double Allowed() const { return m_start + m_putIn; }
    /// Above what is allowed, as a share of it.
    double Excess() const { return (Total() - Allowed()) / b2Max(Allowed(), 1e-3); }
    double Excess(double total) const { return (total - Allowed()) / b2Max(Allowed(), 1e-3); }

private:
    struct Spring
    {
        double stiffness = 0.0; ///< [N/m] or [N m]
        double error = 0.0;     ///< [m] or [rad]
    };
    Spring SpringOf(std::size_t joint) const;
    double StoredIn(std::size_t joint) const;
    double MotorPower(std::size_t joint) const;
    /// What a motor joint may do in the step, as it looks at one of its ends [W].
    double PullPower(std::size_t joint, float32 step) const;

    RandomWorld& m_world;
    std::vector<Spring> m_springs; // before the step
    std::vector<double> m_pulls;   // likewise
    float32 m_step = 0.0f;         // [s]
    double m_start = 0.0;
    double m_putIn = 0.0;
    double m_storedBefore = 0.0;
};

} // namespace stability
