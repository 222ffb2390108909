// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <vector>

/// Reads the packets of existing films, and computes packet times. Used to finish, resume and join
/// films without encoding again.
namespace boxreel
{

using Packets = std::vector<FFmpegOwner<AVPacket>>;

/// The packets of a film in file order. Times are in ticks of the requested unit from the start of
/// the film.
class FFmpegPackets
{
public:
    /// `tick`: the time unit to use [s]. An Error (Unusable) when it is not a film.
    static Result<FFmpegPackets> Open(const std::filesystem::path& path, AVRational tick);
    FFmpegPackets(FFmpegPackets&&) noexcept = default;

    const AVCodecParameters& Codec() const { return *m_stream->codecpar; }
    AVRational FramesPerSecond() const { return m_stream->avg_frame_rate; }

    /// Returns the next packet, with times rounded to ticks; null after the last complete one.
    FFmpegOwner<AVPacket> Next();

private:
    struct InputDelete
    {
        void operator()(AVFormatContext* context) const { FFmpeg().avformat_close_input(&context); }
    };
    FFmpegPackets() = default;

    std::unique_ptr<AVFormatContext, InputDelete> m_input;
    AVStream* m_stream = nullptr; // owned by the input
    AVRational m_tick{1, 60};
};

/// The decoding time of each packet. Encoders that reorder frames assume regular times; our frames
/// may be held for long, so it is computed here. The j-th packet is decoded when the frame is shown
/// that is `delay` places before the j-th.
class DecodingTimes
{
public:
    explicit DecodingTimes(int delay) : m_delay(delay) {}

    /// Adds a frame's time, in display order.
    void Show(std::int64_t time) { m_shown.push_back(time); }

    /// Returns the next packet's decoding time. Its frame must have been added.
    std::int64_t Next();

private:
    int m_delay;
    std::int64_t m_packets = 0;
    std::deque<std::int64_t> m_shown; // from the one that the next packet needs
};

/// As above, for a complete list of display times in packet order. Each time is as late as
/// possible, but `delay` ticks before the j-th frame is shown.
std::vector<std::int64_t> LatestDecodingTimes(const std::vector<std::int64_t>& shown, int delay);

/// Returns the duration of the last packet [ticks], for containers whose length is the sum of all
/// durations (MP4). One tick, unless the last packet's frame is shown before others that are held.
std::int64_t LastDuration(const std::vector<std::int64_t>& shown,
                          const std::vector<std::int64_t>& decoded, int delay);

/// Returns the maximum number of places by which a packet precedes its frame.
int DelayOf(const std::vector<std::int64_t>& shown);

} // namespace boxreel
