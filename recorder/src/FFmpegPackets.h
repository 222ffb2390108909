// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <vector>

/// Packets of films that exist, and the times packets need. Used to finish, continue and join films
/// without coding anything again.
namespace boxreel
{

using Packets = std::vector<FFmpegOwner<AVPacket>>;

/// A film's packets, front to back, their times in ticks of the film's own unit from its beginning.
class FFmpegPackets
{
public:
    /// `tick`: the unit of times asked for [s]. An Error (Unusable) when it is no film.
    static Result<FFmpegPackets> Open(const std::filesystem::path& path, AVRational tick);
    FFmpegPackets(FFmpegPackets&&) noexcept = default;

    const AVCodecParameters& Codec() const { return *m_stream->codecpar; }
    AVRational FramesPerSecond() const { return m_stream->avg_frame_rate; }

    /// The next packet, its times rounded to ticks; none after the last that is whole.
    FFmpegOwner<AVPacket> Next();

private:
    struct InputDelete
    {
        void operator()(AVFormatContext* context) const { FFmpeg().avformat_close_input(&context); }
    };
    FFmpegPackets() = default;

    std::unique_ptr<AVFormatContext, InputDelete> m_input;
    AVStream* m_stream = nullptr; // the input's
    AVRational m_tick{1, 60};
};

/// When a decoder needs each packet. Encoders that put frames in another order than they are shown
/// say so by frames that lie regularly; ours may be held for long, so it is counted here: the j-th
/// packet is needed when the frame is shown that lies `delay` places before the j-th.
class DecodingTimes
{
public:
    explicit DecodingTimes(int delay) : m_delay(delay) {}

    /// A frame's time; they come in the order in which they are shown.
    void Show(std::int64_t time) { m_shown.push_back(time); }

    /// The next packet's decoding time. Its frame must have been shown.
    std::int64_t Next();

private:
    int m_delay;
    std::int64_t m_packets = 0;
    std::deque<std::int64_t> m_shown; // from the one that the next packet needs
};

/// The same for packets that are all known, given when each is shown, in the order of the packets:
/// as late as can be, but `delay` ticks before the j-th frame is shown.
std::vector<std::int64_t> LatestDecodingTimes(const std::vector<std::int64_t>& shown, int delay);

/// How long the last of these packets lasts [ticks], where a film's length is what all of them
/// last, each until the next is decoded: an MP4. One tick, unless a packet comes last whose frame
/// is shown before others that are held.
std::int64_t LastDuration(const std::vector<std::int64_t>& shown,
                          const std::vector<std::int64_t>& decoded, int delay);

/// How many places a packet of such a film comes before its frame, at most.
int DelayOf(const std::vector<std::int64_t>& shown);

} // namespace boxreel
