// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

/// Who draws which figure; FigureTable.cpp gives them their names and says what is to be seen.
namespace figures
{

// Modules.cpp
boxreel::Figure DrawModules();
// Polygons.cpp
boxreel::Figure DrawConvexAndConcave();
boxreel::Figure DrawWinding();
boxreel::Figure DrawPolygonSkin();
boxreel::Figure DrawSkinGap();
// Edges.cpp
boxreel::Figure DrawGhostCollision();
boxreel::Figure DrawGhostVertices();
boxreel::Figure DrawChain();
boxreel::Figure DrawSelfIntersection();
// Pairs.cpp
boxreel::Figure DrawManifolds();
boxreel::Figure DrawDistance();
// Impacts.cpp
boxreel::Figure DrawTunnelling();
boxreel::Figure DrawContinuousCollision();
boxreel::Figure DrawImpactWithinStep();
boxreel::Figure DrawTimeOfImpact();
boxreel::Figure DrawTimeOfImpactTurning();
boxreel::Figure DrawMissedImpact();
// Tree.cpp
boxreel::Figure DrawDynamicTree();
// Queries.cpp
boxreel::Figure DrawRayCast();
boxreel::Figure DrawRegionQuery();
// BodyOrigin.cpp
boxreel::Figure DrawBodyOrigin();
// JointsOfLength.cpp
boxreel::Figure DrawDistanceJoint();
boxreel::Figure DrawRopeJoint();
boxreel::Figure DrawMouseJoint();
// JointsOfMotion.cpp
boxreel::Figure DrawRevoluteJoint();
boxreel::Figure DrawPrismaticJoint();
boxreel::Figure DrawMotorJoint();
// JointsOfTransmission.cpp
boxreel::Figure DrawPulleyJoint();
boxreel::Figure DrawGearJoint();
// JointsOfVehicles.cpp
boxreel::Figure DrawWheelJoint();
boxreel::Figure DrawWeldJoint();
boxreel::Figure DrawFrictionJoint();
// Motion.cpp
boxreel::Figure DrawFallingBox();
boxreel::Figure DrawSlope();
boxreel::Figure DrawBounces();
boxreel::Figure DrawOneWayPlatform();
boxreel::Figure DrawSubSteps();
// Layers.cpp
boxreel::Figure DrawDebugLayers();

} // namespace figures
