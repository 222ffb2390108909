// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <render/Backend.h>
#include <render/Frame.h>

#include <string>

/// Identifies renderers with the same bits by the hash of a small picture. Used by
/// Renderer::Fingerprint.
namespace boxreel
{

/// Side of the probe picture [px]; one metre of its list is one pixel.
inline constexpr int kProbeSide = 256;

/// Returns the probe picture's list: 64 colours under 64 opacities of other colours, round and
/// slanted edges, and text.
DrawList ProbeList();

/// Renders the probe picture. Errors as in Renderer::Create.
Result<Frame> DrawProbe(Backend backend);

/// Returns the hash of the probe picture as 16 hex digits. Computed once per process and
/// `description` of a renderer with this back end. Thread-safe. Errors as in Renderer::Create.
Result<std::string> ProbeFingerprint(Backend backend, const std::string& description);

} // namespace boxreel
