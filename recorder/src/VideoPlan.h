// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <string>
#include <utility>
#include <vector>

/// The encoder options for each format, codec and quality: one table, without libav itself.
namespace boxreel
{

using Options = std::vector<std::pair<std::string, std::string>>;

/// Names are libav's own.
struct EncoderPlan
{
    std::string muxer;
    std::string encoder;
    std::string pixelFormat;
    Options codecOptions; ///< the user's come last and take precedence
    Options muxerOptions;
    bool needsGroups = false;    ///< frames depend on others, with loss
    bool isConstantRate = false; ///< every frame is needed, including identical ones
};

/// An Error (Unusable) when the format does not support the codec, or the codec does not support
/// the quality or chroma. For formats that libav writes.
Result<EncoderPlan> PlanFor(VideoFormat format, const VideoSettings& settings);

} // namespace boxreel
