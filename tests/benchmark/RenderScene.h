// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <string>
#include <vector>

/// The pictures for comparing renderers. They are full of mixed shapes, and the same on every
/// machine. Independent of clocks and renderers.
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

/// The shapes that have moved since the previous frame.
enum class Change
{
    None,
    All,
    Together, ///< one in twenty, those around one place
    Apart,    ///< one in twenty, all over the picture
};

/// Boxes at any angle, convex polygons of 3 to 8 corners, circles with an axis, and segments. Each
/// has its own place, so the picture is full and no shape covers another. Otherwise the benchmark
/// would measure the order of shapes instead of their edges. Moved shapes are slightly shifted and
/// rotated.
boxreel::DrawList MakeRenderScene(const RenderCase& one, Change change);

/// Sees the scene whole; 16 pixels a metre.
boxreel::Camera CameraOf(const RenderCase& one);

} // namespace bench
