// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <string>
#include <utility>
#include <vector>

/// How libav is asked for each format, codec and quality: one table, without libav itself.
namespace boxreel
{

using Options = std::vector<std::pair<std::string, std::string>>;

/// The names are libav's own.
struct EncoderPlan
{
    std::string muxer;
    std::string encoder;
    std::string pixelFormat;
    Options codecOptions; ///< the user's last, so that they win
    Options muxerOptions;
    bool needsGroups = false;    ///< frames are coded by what differs from others, inexactly
    bool isConstantRate = false; ///< every frame must be there, also one that shows the same
};

/// An Error (Unusable) when the format has no such codec, or the codec no such quality or chroma.
/// For formats that libav writes.
Result<EncoderPlan> PlanFor(VideoFormat format, const VideoSettings& settings);

} // namespace boxreel
