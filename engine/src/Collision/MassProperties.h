// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// Mass data as a body needs it: about the centre of mass and in double precision. b2MassData holds
/// the inertia about the frame's origin, from which the central one cannot be had back when the
/// shape lies far from it.
namespace box2d
{
struct MassProperties
{
    double mass = 0.0; ///< [kg]
    double centerX = 0.0;
    double centerY = 0.0;
    double centralInertia = 0.0; ///< about the centre of mass [kg m^2]
};

/// All zero but the centre for edges and chains.
MassProperties ComputeMassProperties(const b2Shape& shape, float32 density);

/// The same as the manual's structure: the inertia about the frame's origin.
b2MassData ToMassData(const MassProperties& properties);
} // namespace box2d
