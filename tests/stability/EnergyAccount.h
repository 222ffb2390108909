// SPDX-License-Identifier: MIT
#pragma once

#include "RandomWorlds.h"

#include <vector>

/// The maximum energy of a random world. The world's own energy is
///   kinetic + potential, above the lowest corner of the container, so that no part is negative
///   + the energy of springs, k x^2 / 2, with the k of the frequency at the present pose
///   + for mouse joints, the same up to their maximum force F, and F times the distance beyond it:
///     such a pull never does more work than this potential loses, because the clamp is monotone.
/// Energy is added
///   + by a motor: its maximum force times its speed times the time, because it only pushes bodies
///     that are slower than that
///   + by a motor joint: its maximum force times the relative speed of its points, but at most the
///     speed at which it corrects its error, because at that speed it does no work. The same for
///     its torque.
///   + by instant changes: the potential of a mouse joint when its target moves
///   + by a spring: x^2 / 2 times the change of k. Its k follows the moved mass, which changes with
///     the pose.
/// All other effects can only remove energy: contacts with restitution up to 1, friction, damping,
/// limits, ropes, gears, the start of rigid joints, and the end of sleeping.
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
    /// Energy above the allowed amount, as a fraction of it.
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
    /// Returns the maximum power of a motor joint in the step, seen at one of its ends [W].
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
