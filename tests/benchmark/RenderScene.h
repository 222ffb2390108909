// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <string>
#include <vector>

/// What is drawn to compare renderers: pictures full of mixed shapes, the same on every machine.
/// Knows neither clocks nor renderers.
namespace bench
{

struct RenderCase
{
    std::string name; ///< count and height: "1500-720p"
    int count = 0;    ///< of shapes
    int width = 0;    ///< [px]
    int height = 0;   ///< [px]
};

const std::vector<RenderCase>& AllRenderCases();

/// Which shapes have moved since the frame before.
enum class Change
{
    None,
    All,
    Together, ///< one in twenty, those around one place
    Apart,    ///< one in twenty, all over the picture
};

/// Boxes of any angle, convex polygons of 3 to 8 corners, circles with an axis, segments; each in a
/// place of its own, so that the picture is full and no shape covers another: what lies over an
/// edge would be measured, not how the edge is drawn. What has moved has gone and turned a little.
boxreel::DrawList MakeRenderScene(const RenderCase& one, Change change);

/// Sees the scene whole; 16 pixels a metre.
boxreel::Camera CameraOf(const RenderCase& one);

} // namespace bench
