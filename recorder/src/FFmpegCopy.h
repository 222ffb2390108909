// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegMuxer.h"
#include "FFmpegPackets.h"
#include "FrameTimes.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <span>
#include <vector>

/// Copies packets from one film to another without decoding.
namespace boxreel
{

/// The packets of `from` that are shown before `before`, shifted by `offset`; times in `tick`s.
struct CopiedPart
{
    std::filesystem::path from;
    AVRational tick{1, 60};
    std::int64_t before = std::numeric_limits<std::int64_t>::max();
    std::int64_t offset = 0;
    std::int64_t lastDuration = 1; ///< duration of its last packet
};

/// Returns when the part's frames are shown, in packet order.
Result<std::vector<std::int64_t>> TimesIn(const CopiedPart& part);

/// Copies the packets. `decodingTimes`: one per packet. Ends early if `isStopped` returns true.
Result<void> CopyPackets(
    const CopiedPart& part, std::span<const std::int64_t> decodingTimes, FFmpegMuxer& muxer,
    const std::function<bool()>& isStopped = [] { return false; });

/// Copies the part as the start of a film that continues with packets of the encoder.
Result<void> CopyBeginning(const CopiedPart& part, FFmpegMuxer& muxer,
                           DecodingTimes& decodingTimes);

/// Returns the number of frames of an interrupted film that are kept: those of all groups but the
/// last, or those before the last keyframe if the film has no groups. 0 if it cannot be read.
std::int64_t CountWholeFrames(const std::filesystem::path& left, const FrameTimes& times,
                              AVRational tick);

/// Writes the film `from` to the MP4 `path` with its index at the front. `delay`: reordering delay
/// of the encoder [frames].
Result<void> WriteWithIndexInFront(const std::filesystem::path& path, bool overwrite,
                                   const std::filesystem::path& from, AVRational tick, int delay);

} // namespace boxreel
