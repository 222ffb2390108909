// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <limits>

class b2Joint;

/// The energy of a joint's spring, and the maximum work of its motor in a step. Computed from
/// settings and poses, independent of the solver.
namespace box2d
{

struct SolverBody;

/// A spring with the force k x, limited to `most`.
struct SpringState
{
    double stiffness = 0.0; ///< k [N/m] or [N m], of the present pose
    double error = 0.0;     ///< x [m] or [rad]
    double most = std::numeric_limits<double>::infinity(); ///< [N] or [N m]

    double Energy() const { return EnergyAt(error); }
    /// Returns k x^2 / 2, and a linear function beyond `most` / k [J].
    double EnergyAt(double x) const;
};

/// Returns the energy stored between two states, without the effect of changes of k [J]. k is that
/// of an oscillator with a given frequency, so it depends on the effective mass, which changes with
/// the pose. The smaller result of the two values of k is used.
double StoredBetween(const SpringState& before, const SpringState& after);

/// True if iterations may gain energy without bound: for mass ratios above 10:1, beyond the
/// manual's advice, and levers much longer than the body. For a rod or a rope half the length
/// suffices.
bool IsAtRisk(const b2Joint& joint);
/// True if that also depends on the pose.
bool HasChangingLevers(const b2Joint& joint);
/// True if the joint acts on the body further from its centre than `radii` radii of gyration.
bool HasLeverOnA(const b2Joint& joint, float32 radii);
bool HasLeverOnB(const b2Joint& joint, float32 radii);

bool HasSpring(const b2Joint& joint);
/// Returns the state of a joint's spring. `bodies` by solver index, with the displacements since
/// the start of the step; null without displacements.
SpringState SpringOf(const b2Joint& joint, const SolverBody* bodies);

/// True for a joint with a motor of any type.
bool HasMotor(const b2Joint& joint);
/// Returns the maximum work of the motor in a step with sub-steps, from the current state [J]. At
/// its target speed the motor does no more work.
double MostMotorWork(const b2Joint& joint, const SolverBody* bodies, float32 timeStep,
                     int32 subSteps);

} // namespace box2d
