// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <render/Backend.h>
#include <render/Frame.h>

#include <string>

/// Which renderers draw the same bits: each draws one small picture, and its hash says so. Used by
/// Renderer::Fingerprint; never judges.
namespace boxreel
{

/// Side of the probe picture [px]; a metre of its list is a pixel.
inline constexpr int kProbeSide = 256;

/// What the probe picture shows: 64 colours under 64 opacities of other colours, round and slanted
/// edges, and text.
DrawList ProbeList();

/// The probe picture. Errors as of Renderer::Create.
Result<Frame> DrawProbe(Backend backend);

/// The hash of the probe picture as 16 hex digits. Drawn once per process and `description`, which
/// is that of a renderer of this back end; any number of threads may ask at once. Errors as of
/// Renderer::Create.
Result<std::string> ProbeFingerprint(Backend backend, const std::string& description);

} // namespace boxreel
