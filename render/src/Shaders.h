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
    int vectors; ///< attributes of four floats an instance
};

/// Room for the corners of a polygon's outline, outside and inside. Pixels pay for all of it, so
/// there are three sizes.
struct CornerSlots
{
    std::size_t outer;
    std::size_t inner;
};
CornerSlots SlotsOf(ProgramKind polygon);

/// A quad an instance, corners from gl_VertexID (a strip of four).
ShaderSource InstancedShader(ProgramKind kind);

/// Plain triangles: position, texture coordinates, colour not premultiplied.
ShaderSource MeshShader();

} // namespace boxreel
