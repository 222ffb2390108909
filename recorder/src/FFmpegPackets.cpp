// SPDX-License-Identifier: MIT
#include "FFmpegPackets.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>
#include <utility>

namespace boxreel
{

Result<FFmpegPackets> FFmpegPackets::Open(const std::filesystem::path& path, AVRational tick)
{
    FFmpegPackets packets;
    packets.m_tick = tick;
    AVDictionary* options = nullptr;
    FFmpeg().av_dict_set(&options, "protocol_whitelist", "file", 0);
    AVFormatContext* input = nullptr;
    int status =
        FFmpeg().avformat_open_input(&input, ("file:" + path.string()).c_str(), nullptr, &options);
    FFmpeg().av_dict_free(&options);
    if (status >= 0)
    {
        packets.m_input.reset(input);
        status = FFmpeg().avformat_find_stream_info(input, nullptr);
    }
    if (status >= 0)
    {
        status = FFmpeg().av_find_best_stream(input, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    }
    if (status < 0)
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "is not a film, or is damaged or truncated (" + FFmpegText(status) + ")",
                     "record it again"};
    }
    packets.m_stream = input->streams[status];
    return packets;
}

FFmpegOwner<AVPacket> FFmpegPackets::Next()
{
    FFmpegOwner<AVPacket> packet(FFmpeg().av_packet_alloc());
    while (FFmpeg().av_read_frame(m_input.get(), packet.get()) >= 0)
    {
        const bool isOurs = packet->stream_index == m_stream->index;
        const bool isWhole = (packet->flags & AV_PKT_FLAG_CORRUPT) == 0;
        if (isOurs && isWhole && packet->pts != AV_NOPTS_VALUE)
        {
            FFmpeg().av_packet_rescale_ts(packet.get(), m_stream->time_base, m_tick);
            return packet;
        }
        FFmpeg().av_packet_unref(packet.get());
        if (isOurs)
        {
            return nullptr; // frames after a damaged packet cannot be decoded either
        }
    }
    return nullptr;
}

std::int64_t DecodingTimes::Next()
{
    assert(!m_shown.empty() && "a packet's frame has been shown");
    if (m_packets < m_delay)
    {
        return m_shown.front() - (m_delay - m_packets++);
    }
    ++m_packets;
    const std::int64_t time = m_shown.front();
    m_shown.pop_front();
    return time;
}

std::vector<std::int64_t> LatestDecodingTimes(const std::vector<std::int64_t>& shown, int delay)
{
    std::vector<std::int64_t> times = shown;
    std::sort(times.begin(), times.end());
    std::int64_t latest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t j = shown.size(); j-- > 0;)
    {
        latest = std::min(latest - 1, shown[j]); // before the frame of any later packet is shown
        times[j] = std::min(times[j] - delay, latest);
    }
    return times;
}

std::int64_t LastDuration(const std::vector<std::int64_t>& shown,
                          const std::vector<std::int64_t>& decoded, int delay)
{
    const std::int64_t end = shown.empty() ? 0 : *std::max_element(shown.begin(), shown.end()) + 1;
    return decoded.empty() ? 1 : end - delay - decoded.back();
}

int DelayOf(const std::vector<std::int64_t>& shown)
{
    std::vector<std::int64_t> sorted = shown;
    std::sort(sorted.begin(), sorted.end());
    std::ptrdiff_t delay = 0;
    for (std::size_t j = 0; j < shown.size(); ++j)
    {
        const auto place = std::lower_bound(sorted.begin(), sorted.end(), shown[j]);
        delay = std::max(delay, std::ptrdiff_t(j) - (place - sorted.begin()));
    }
    return int(delay);
}

} // namespace boxreel
