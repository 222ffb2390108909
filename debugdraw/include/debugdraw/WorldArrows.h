// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

/// @file
/// Velocities and forces of a world as arrows. Only reads the world.
namespace boxreel
{

/// Adds an arrow at each centre of mass: the displacement in `seconds`, >= 0. Bodies at rest, and
/// arrows shorter than one and a half pixels, are skipped.
void AddVelocities(const b2World& world, const View& view, double seconds, DrawList& list);

/// Adds the mean force of each joint in the last step as an arrow, in metres (>= 0) per newton. It
/// is the force on the second body, drawn at its anchor. Torques are not shown.
void AddJointForces(const b2World& world, const View& view, double metersPerNewton, DrawList& list);

/// Length of a mean weight in mean body sizes. Joints of a bridge transmit ten times the weight of
/// its parts, a contact point in a stack about one.
inline constexpr double kForceShare = 1.0 / 8.0;
/// Same as above, for arrows of impulses.
inline constexpr double kImpulseShare = 1.0 / 3.0;

/// Returns a scale for force arrows, > 0. The mean weight of moving bodies is `share` times as long
/// as their mean size; without gravity their mean mass times 10 m/s^2.
double MetersPerNewtonFor(const b2World& world, double share = kForceShare);

} // namespace boxreel
