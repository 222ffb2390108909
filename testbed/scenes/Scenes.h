// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

/// The functions that create the scenes, one per scene, each defined in the file of the scene's
/// name. Only the table of scenes calls them; all others use the table.
namespace boxreel
{

std::unique_ptr<Scene> MakePyramid(const SceneSettings& settings);
std::unique_ptr<Scene> MakeVerticalStack(const SceneSettings& settings);
std::unique_ptr<Scene> MakeBridge(const SceneSettings& settings);
std::unique_ptr<Scene> MakeChain(const SceneSettings& settings);
std::unique_ptr<Scene> MakeDominos(const SceneSettings& settings);
std::unique_ptr<Scene> MakeTumbler(const SceneSettings& settings);
std::unique_ptr<Scene> MakeNewtonsCradle(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCardHouse(const SceneSettings& settings);
std::unique_ptr<Scene> MakeArch(const SceneSettings& settings);
std::unique_ptr<Scene> MakeDoubleDomino(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCircleStack(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRain(const SceneSettings& settings);
std::unique_ptr<Scene> MakeLargePyramid(const SceneSettings& settings);
std::unique_ptr<Scene> MakeManyPyramids(const SceneSettings& settings);
std::unique_ptr<Scene> MakeFarPyramid(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSmash(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSpinner(const SceneSettings& settings);
std::unique_ptr<Scene> MakeHighMassRatio1(const SceneSettings& settings);
std::unique_ptr<Scene> MakeHighMassRatio2(const SceneSettings& settings);
std::unique_ptr<Scene> MakeHighMassRatio3(const SceneSettings& settings);
std::unique_ptr<Scene> MakeHeavy1(const SceneSettings& settings);
std::unique_ptr<Scene> MakeHeavy2(const SceneSettings& settings);
std::unique_ptr<Scene> MakeOverlapRecovery(const SceneSettings& settings);
std::unique_ptr<Scene> MakeChainSlide(const SceneSettings& settings);
std::unique_ptr<Scene> MakeGhostBumps(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSkinnyBox(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCar(const SceneSettings& settings);
std::unique_ptr<Scene> MakeTheoJansensWalker(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRevolute(const SceneSettings& settings);
std::unique_ptr<Scene> MakePrismatic(const SceneSettings& settings);
std::unique_ptr<Scene> MakePulleys(const SceneSettings& settings);
std::unique_ptr<Scene> MakeGears(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSliderCrank(const SceneSettings& settings);
std::unique_ptr<Scene> MakeApplyForce(const SceneSettings& settings);
std::unique_ptr<Scene> MakeMotorJoint(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRopeJoint(const SceneSettings& settings);
std::unique_ptr<Scene> MakeJointGrid(const SceneSettings& settings);
std::unique_ptr<Scene> MakeOneSidedPlatform(const SceneSettings& settings);
std::unique_ptr<Scene> MakeConveyorBelt(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSensorTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRayCast(const SceneSettings& settings);
std::unique_ptr<Scene> MakeVaryingRestitution(const SceneSettings& settings);
std::unique_ptr<Scene> MakeVaryingFriction(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSphereStack(const SceneSettings& settings);
std::unique_ptr<Scene> MakeConfined(const SceneSettings& settings);
std::unique_ptr<Scene> MakeTiles(const SceneSettings& settings);
std::unique_ptr<Scene> MakeBulletTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakeContinuousTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakeTimeOfImpact(const SceneSettings& settings);
std::unique_ptr<Scene> MakeDistanceTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakePolyCollision(const SceneSettings& settings);
std::unique_ptr<Scene> MakeConvexHull(const SceneSettings& settings);
std::unique_ptr<Scene> MakeDynamicTree(const SceneSettings& settings);
std::unique_ptr<Scene> MakeEdgeTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakeEdgeShapes(const SceneSettings& settings);
std::unique_ptr<Scene> MakePolygonShapes(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCompoundShapes(const SceneSettings& settings);
std::unique_ptr<Scene> MakeShapeEditing(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCharacterCollision(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCollisionFiltering(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCollisionProcessing(const SceneSettings& settings);
std::unique_ptr<Scene> MakeAddPairStressTest(const SceneSettings& settings);
std::unique_ptr<Scene> MakeWeb(const SceneSettings& settings);
std::unique_ptr<Scene> MakeBodyTypes(const SceneSettings& settings);
std::unique_ptr<Scene> MakeBreakable(const SceneSettings& settings);
std::unique_ptr<Scene> MakeCantilever(const SceneSettings& settings);
std::unique_ptr<Scene> MakeMobile(const SceneSettings& settings);
std::unique_ptr<Scene> MakeMobileBalanced(const SceneSettings& settings);
std::unique_ptr<Scene> MakeBallAndChain(const SceneSettings& settings);
std::unique_ptr<Scene> MakeWreckingBall(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRopeBending(const SceneSettings& settings);
std::unique_ptr<Scene> MakeScissorLift(const SceneSettings& settings);
std::unique_ptr<Scene> MakeRagdoll(const SceneSettings& settings);
std::unique_ptr<Scene> MakeSkier(const SceneSettings& settings);
std::unique_ptr<Scene> MakePinball(const SceneSettings& settings);
std::unique_ptr<Scene> MakeDumpShell(const SceneSettings& settings);

} // namespace boxreel
