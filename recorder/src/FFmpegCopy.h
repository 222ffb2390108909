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

/// Packets from one film into another, as they are.
namespace boxreel
{

/// Those packets of `from` that are shown before `before`, `offset` later than there; times in
/// `tick`s.
struct CopiedPart
{
    std::filesystem::path from;
    AVRational tick{1, 60};
    std::int64_t before = std::numeric_limits<std::int64_t>::max();
    std::int64_t offset = 0;
    std::int64_t lastDuration = 1; ///< of its last packet
};

/// When the part's frames are shown, in the order of its packets.
Result<std::vector<std::int64_t>> TimesIn(const CopiedPart& part);

/// `decodingTimes`: of each of its packets. Ends early once `isStopped` says so.
Result<void> CopyPackets(
    const CopiedPart& part, std::span<const std::int64_t> decodingTimes, FFmpegMuxer& muxer,
    const std::function<bool()>& isStopped = [] { return false; });

/// The part as the beginning of a film that goes on with packets as the encoder gives them.
Result<void> CopyBeginning(const CopiedPart& part, FFmpegMuxer& muxer,
                           DecodingTimes& decodingTimes);

/// How many frames of an interrupted film are whole: those of the groups that another one follows.
/// None when it is no film that can be read.
std::int64_t CountWholeFrames(const std::filesystem::path& left, const FrameTimes& times,
                              AVRational tick);

/// Writes the film `from` anew as the MP4 `path`, its index in front. `delay`: how many frames the
/// encoder puts into another order.
Result<void> WriteWithIndexInFront(const std::filesystem::path& path, bool overwrite,
                                   const std::filesystem::path& from, AVRational tick, int delay);

} // namespace boxreel
