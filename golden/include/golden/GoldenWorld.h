// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <golden/ReferenceStore.h>

#include <cstdint>
#include <optional>
#include <string>

class b2World;

/// @file
/// A world as a candidate at all three depths: state, draw list, pixels. Target
/// boxreel::goldenworld; the header itself does not include the engine.
namespace boxreel
{

/// The look of a world in a comparison, and its trace.
struct GoldenWorldLook
{
    int width = 480;                   ///< width of the picture [px], 1 to 8192
    int height = 270;                  ///< height of the picture [px], 1 to 8192
    std::optional<Camera> camera = {}; ///< its size must be that of the picture; none: moving
                                       ///< bodies and their surroundings fill the picture
    std::uint32_t layers = 0x3;        ///< b2Draw's bits; default: shapes and joints
    StateTrace trace = {}; ///< ReadTraceStep() after each step, to report the first step and body
                           ///< that differ; optional
};

/// Returns the candidate; an Error when the picture cannot be drawn. Replaces the world's debug
/// drawing; none is registered afterwards.
Result<GoldenCandidate> CandidateOf(b2World& world, const std::string& name,
                                    const GoldenWorldLook& look = {});

} // namespace boxreel
