// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"
#include "Convex.h"

#include <string>

/// The GLSL source of every program, and the number of floats per instance of each kind. Renderer
/// compiles them. Pixel coordinates run right and down from the top left corner. GL's first row is
/// the picture's top row, so reading needs no flip.
namespace boxreel
{

struct ShaderSource
{
    std::string vertex;
    std::string fragment;
    int vectors; ///< of four floats per instance
};

/// Number of corners of a polygon's outer and inner outline. Every pixel pays for all of them, so
/// there are five sizes.
struct CornerSlots
{
    std::size_t outer;
    std::size_t inner;
};
CornerSlots SlotsOf(ProgramKind polygon);

/// Margin of the quad around a shape's outline [px]: more than half a pixel's diagonal, so that it
/// contains every touched pixel.
inline constexpr double kQuadMargin = 0.75;

/// Returns a shader that draws one quad of four vertices per instance, or a point, with all data
/// from a texture by gl_VertexID. GL instancing would run each quad separately through Mesa's
/// vertex pipeline.
ShaderSource InstancedShader(ProgramKind kind, Form form);

/// Returns a shader for plain triangles: position, texture coordinates, colour not premultiplied.
ShaderSource MeshShader();

} // namespace boxreel
