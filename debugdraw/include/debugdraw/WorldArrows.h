// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

/// @file
/// What moves and what pulls, as arrows in a world. Only reads the world.
namespace boxreel
{

/// From each centre of mass the way that the body would go in so many seconds, 0 or more. Bodies at
/// rest have none, nor have those whose arrow would be shorter than one and a half pixels.
void AddVelocities(const b2World& world, const View& view, double seconds, DrawList& list);

/// From each joint's anchor on its second body the force that the joint exerts on that body, in the
/// mean of the last step, so many metres (0 or more) long for each newton. Torques are not shown.
void AddJointForces(const b2World& world, const View& view, double metersPerNewton, DrawList& list);

/// How long a mean weight is, in mean sizes: joints of a bridge carry ten times the weight of its
/// parts, of which a contact point in a pile carries about one.
inline constexpr double kForceShare = 1.0 / 8.0;
/// The same for arrows of impulses.
inline constexpr double kImpulseShare = 1.0 / 3.0;

/// A scale for arrows of forces that suits a world: the mean weight of the bodies that can move,
/// where there is no gravity their mean mass times 10 m/s^2, is `share` times as long as they are
/// large in the mean. Above 0.
double MetersPerNewtonFor(const b2World& world, double share = kForceShare);

} // namespace boxreel
