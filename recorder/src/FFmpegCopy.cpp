// SPDX-License-Identifier: MIT
#include "FFmpegCopy.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

#include <algorithm>
#include <array>
#include <vector>

namespace boxreel
{

namespace
{

/// Replaces unit lengths by start codes. Containers store the length before each unit of H.264,
/// encoders a start code of the same size (H.264, annex B). A film must use one kind.
void PutStartCodes(AVPacket& packet)
{
    constexpr std::array<std::uint8_t, 4> kStartCode{0, 0, 0, 1};
    FFmpeg().av_packet_make_writable(&packet);
    std::span<std::uint8_t> rest(packet.data, std::size_t(packet.size));
    while (rest.size() >= kStartCode.size())
    {
        const std::size_t length = std::size_t(rest[0]) << 24 | std::size_t(rest[1]) << 16 |
                                   std::size_t(rest[2]) << 8 | std::size_t(rest[3]);
        std::copy(kStartCode.begin(), kStartCode.end(), rest.begin());
        rest = rest.subspan(std::min(kStartCode.size() + length, rest.size()));
    }
}

bool HasLengths(const AVCodecParameters& codec)
{
    return codec.codec_id == AV_CODEC_ID_H264 && codec.extradata_size > 0 &&
           codec.extradata[0] == 1;
}

} // namespace

Result<std::vector<std::int64_t>> TimesIn(const CopiedPart& part)
{
    ASSIGN_OR_RETURN(FFmpegPackets packets, FFmpegPackets::Open(part.from, part.tick));
    std::vector<std::int64_t> times;
    while (const FFmpegOwner<AVPacket> packet = packets.Next())
    {
        if (packet->pts < part.before)
        {
            times.push_back(packet->pts + part.offset);
        }
    }
    return times;
}

namespace
{

Result<void> Copy(const CopiedPart& part, std::span<const std::int64_t> decodingTimes,
                  bool isUnwrapped, FFmpegMuxer& muxer, const std::function<bool()>& isStopped)
{
    ASSIGN_OR_RETURN(FFmpegPackets packets, FFmpegPackets::Open(part.from, part.tick));
    const bool needsStartCodes = isUnwrapped && HasLengths(packets.Codec());
    std::size_t copied = 0;
    while (const FFmpegOwner<AVPacket> packet = isStopped() ? nullptr : packets.Next())
    {
        if (packet->pts >= part.before || copied >= decodingTimes.size())
        {
            continue;
        }
        if (needsStartCodes)
        {
            PutStartCodes(*packet);
        }
        packet->pts += part.offset;
        packet->dts = decodingTimes[copied++];
        packet->duration = copied == decodingTimes.size() ? part.lastDuration : 1;
        RETURN_IF_ERROR(muxer.Write(*packet));
    }
    return {};
}

} // namespace

Result<void> CopyPackets(const CopiedPart& part, std::span<const std::int64_t> decodingTimes,
                         FFmpegMuxer& muxer, const std::function<bool()>& isStopped)
{
    return Copy(part, decodingTimes, false, muxer, isStopped);
}

Result<void> CopyBeginning(const CopiedPart& part, FFmpegMuxer& muxer, DecodingTimes& decodingTimes)
{
    ASSIGN_OR_RETURN(const std::vector<std::int64_t> shown, TimesIn(part));
    std::vector<std::int64_t> times = shown;
    std::sort(times.begin(), times.end());
    for (const std::int64_t time : times)
    {
        decodingTimes.Show(time);
    }
    for (std::int64_t& time : times)
    {
        time = decodingTimes.Next();
    }
    return Copy(part, times, true, muxer, [] { return false; });
}

std::int64_t CountWholeFrames(const std::filesystem::path& left, const FrameTimes& times,
                              AVRational tick)
{
    Result<FFmpegPackets> packets = FFmpegPackets::Open(left, tick);
    std::int64_t last = 0;
    std::vector<std::int64_t> keys{0}; // frames from which a decoder can start
    while (const FFmpegOwner<AVPacket> packet = packets ? packets->Next() : nullptr)
    {
        last = std::max(last, packet->pts);
        if ((packet->flags & AV_PKT_FLAG_KEY) != 0)
        {
            keys.push_back(times.IndexAt(packet->pts));
        }
    }
    const std::int64_t group = times.GroupOf(times.IndexAt(last));
    const std::int64_t start = std::max<std::int64_t>(0, times.FirstIndexOf(group));
    // A film that was made without groups has another frame there.
    const bool isStart = std::find(keys.begin(), keys.end(), start) != keys.end();
    return times.HasGroups() && isStart ? start : *std::max_element(keys.begin(), keys.end());
}

Result<void> WriteWithIndexInFront(const std::filesystem::path& path, bool overwrite,
                                   const std::filesystem::path& from, AVRational tick, int delay)
{
    // A name that only boxreel uses: the leftover of a killed run is replaced.
    ASSIGN_OR_RETURN(AtomicFile file,
                     AtomicFile::Create(path, {.overwrite = overwrite, .mark = "boxreel-indexed"}));
    ASSIGN_OR_RETURN(FFmpegPackets packets, FFmpegPackets::Open(from, tick));
    FFmpegOutput output(&file);
    const MuxerStream stream{&packets.Codec(), tick, AVRational{tick.den, tick.num}};
    ASSIGN_OR_RETURN(
        FFmpegMuxer muxer,
        FFmpegMuxer::Open(output, "mp4", {{"movflags", "+faststart"}}, stream, path.string()));
    CopiedPart whole{.from = from, .tick = tick};
    ASSIGN_OR_RETURN(const std::vector<std::int64_t> shown, TimesIn(whole));
    const std::vector<std::int64_t> decoded = LatestDecodingTimes(shown, delay);
    whole.lastDuration = LastDuration(shown, decoded, delay);
    RETURN_IF_ERROR(CopyPackets(whole, decoded, muxer));
    RETURN_IF_ERROR(muxer.Finish());
    return file.Commit();
}

} // namespace boxreel
