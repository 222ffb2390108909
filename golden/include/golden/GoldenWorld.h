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
/// boxreel::goldenworld; the header needs no engine.
namespace boxreel
{

/// How a world is drawn to be compared, and what is known of its way there.
struct GoldenWorldLook
{
    int width = 480;                   ///< of the picture [px], 1 to 8192
    int height = 270;                  ///< of the picture [px], 1 to 8192
    std::optional<Camera> camera = {}; ///< with the size of the picture; none: what can move and
                                       ///< what is near it, as it stands, fills the picture
    std::uint32_t layers = 0x3;        ///< b2Draw's bits; shapes and joints unless said
    StateTrace trace = {}; ///< ReadTraceStep() after each step: a failure then says which
                           ///< step and which body differ first; none: not kept
};

/// An Error when the picture cannot be drawn. The world's debug drawing is borrowed for it and none
/// is registered afterwards.
Result<GoldenCandidate> CandidateOf(b2World& world, const std::string& name,
                                    const GoldenWorldLook& look = {});

} // namespace boxreel
