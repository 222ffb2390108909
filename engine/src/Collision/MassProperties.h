// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// Mass data of a body: about the centre of mass and in double precision. b2MassData has the
/// inertia about the frame's origin. For a shape far from it, the central inertia cannot be
/// computed from that without cancellation.
namespace box2d
{
struct MassProperties
{
    double mass = 0.0; ///< [kg]
    double centerX = 0.0;
    double centerY = 0.0;
    double centralInertia = 0.0; ///< about the centre of mass [kg m^2]
};

/// Returns zero mass and inertia for edges and chains.
MassProperties ComputeMassProperties(const b2Shape& shape, float32 density);

/// Converts to the manual's structure, with the inertia about the frame's origin.
b2MassData ToMassData(const MassProperties& properties);
} // namespace box2d
