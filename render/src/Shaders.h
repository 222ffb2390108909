// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"
#include "Convex.h"

#include <string>

/// The GLSL of every program, and how many floats an instance of each kind has. Texts only:
/// Renderer compiles them. Pixel coordinates run right and down from the top left corner; drawn so
/// that GL's first row is the picture's top row, which needs no flip when it is read.
namespace boxreel
{

struct ShaderSource
{
    std::string vertex;
    std::string fragment;
    int vectors; ///< of four floats an instance
};

/// Room for the corners of a polygon's outline, outside and inside. Pixels pay for all of it, so
/// there are four sizes.
struct CornerSlots
{
    std::size_t outer;
    std::size_t inner;
};
CornerSlots SlotsOf(ProgramKind polygon);

/// How far beyond a shape's outline the quad around it reaches [px]: more than a pixel's half
/// diagonal, so that it holds every pixel that the shape touches.
inline constexpr double kQuadMargin = 0.75;

/// A quad an instance, four vertices each, or a point: everything is read from a texture by
/// gl_VertexID. Drawn as instances of GL's, each quad would go through Mesa's vertex pipeline by
/// itself.
ShaderSource InstancedShader(ProgramKind kind, Form form);

/// Plain triangles: position, texture coordinates, colour not premultiplied.
ShaderSource MeshShader();

} // namespace boxreel
