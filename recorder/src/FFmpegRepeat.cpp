// SPDX-License-Identifier: MIT
#include "FFmpegRepeat.h"
#include "SettingTexts.h"

#include "Vp9Slot.h"

#include <base/ErrorMacros.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace boxreel
{

namespace
{

/// True if the user's options may make pictures depend on their distance, which repeated ones
/// change; H264Repeat sees the others in the stream.
bool DependsOnDistance(const EncoderPlan& plan)
{
    return std::any_of(plan.codecOptions.begin(), plan.codecOptions.end(), [](const auto& option) {
        const bool isTemporal = option.first == "direct-pred" && option.second != "spatial";
        return isTemporal || option.first == "x264opts";
    });
}

std::span<const std::uint8_t> BytesOf(const AVPacket& packet)
{
    return {packet.data, std::size_t(packet.size)};
}

Result<FFmpegOwner<AVPacket>> PacketOf(std::span<const std::uint8_t> bytes)
{
    FFmpegOwner<AVPacket> packet(FFmpeg().av_packet_alloc());
    if (!packet || FFmpeg().av_new_packet(packet.get(), int(bytes.size())) < 0)
    {
        return Error{ErrorKind::Failed, "film", "not enough memory for a packet",
                     "free some memory"};
    }
    std::copy(bytes.begin(), bytes.end(), packet->data);
    return packet;
}

void SetHeader(std::span<const std::uint8_t> header, AVCodecParameters& parameters)
{
    FFmpeg().av_freep(&parameters.extradata);
    parameters.extradata = static_cast<std::uint8_t*>(
        FFmpeg().av_mallocz(header.size() + AV_INPUT_BUFFER_PADDING_SIZE));
    std::copy(header.begin(), header.end(), parameters.extradata);
    parameters.extradata_size = int(header.size());
}

Error Unreadable()
{
    return Error{ErrorKind::Failed, "film", "the encoder returned a packet that cannot be repeated",
                 ErrorText::AnyOf({"use " + kVariableRate})};
}

} // namespace

std::optional<FFmpegRepeat> FFmpegRepeat::Create(const EncoderPlan& plan,
                                                 AVCodecParameters& parameters)
{
    switch (parameters.codec_id)
    {
    case AV_CODEC_ID_H264: {
        FFmpegRepeat repeat(Kind::H264, 0);
        repeat.m_h264 = H264Repeat::Create(
            {parameters.extradata, std::size_t(std::max(parameters.extradata_size, 0))});
        if (!repeat.m_h264 || DependsOnDistance(plan))
        {
            return std::nullopt;
        }
        SetHeader(repeat.m_h264->Header(), parameters);
        return repeat;
    }
    case AV_CODEC_ID_VP9:
        return FFmpegRepeat(Kind::Vp9, plan.pixelFormat == "yuv420p" ? 0 : 1);
    case AV_CODEC_ID_FFV1:
        return FFmpegRepeat(Kind::Intra, 0);
    default:
        return std::nullopt;
    }
}

/// Reads the packet, so that its frame can be repeated. Returns the packet of the film.
Result<FFmpegOwner<AVPacket>> FFmpegRepeat::Note(FFmpegOwner<AVPacket> packet)
{
    if (m_kind == Kind::Vp9)
    {
        m_slot = Vp9SlotShownBy(BytesOf(*packet));
    }
    else if (m_kind == Kind::Intra)
    {
        m_packet.reset(FFmpeg().av_packet_alloc());
        FFmpeg().av_packet_ref(m_packet.get(), packet.get());
    }
    else
    {
        const std::optional<H264Repeat::Bytes> placed =
            m_h264->Place(BytesOf(*packet), packet->pts);
        if (!placed)
        {
            return Unreadable();
        }
        ASSIGN_OR_RETURN(FFmpegOwner<AVPacket> made, PacketOf(*placed));
        made->pts = packet->pts;
        made->flags = packet->flags;
        return made;
    }
    return packet;
}

Result<FFmpegOwner<AVPacket>> FFmpegRepeat::Make(const Waiting& waiting) const
{
    std::optional<H264Repeat::Bytes> bytes;
    if (m_kind == Kind::H264)
    {
        bytes = m_h264->Repeat(waiting.index, waiting.shown);
    }
    else if (m_kind == Kind::Intra && m_packet)
    {
        bytes.emplace(m_packet->data, m_packet->data + m_packet->size);
    }
    else if (m_slot)
    {
        bytes = H264Repeat::Bytes{Vp9PacketShowing(*m_slot, m_profile)};
    }
    if (!bytes)
    {
        return Unreadable();
    }
    ASSIGN_OR_RETURN(FFmpegOwner<AVPacket> packet, PacketOf(*bytes));
    packet->pts = waiting.index;
    packet->flags = m_kind == Kind::Intra ? AV_PKT_FLAG_KEY : 0;
    return packet;
}

Result<Packets> FFmpegRepeat::Pass(FFmpegOwner<AVPacket> packet)
{
    Packets packets;
    while (!m_waiting.empty() && (!packet || m_waiting.front().index < packet->pts))
    {
        ASSIGN_OR_RETURN(FFmpegOwner<AVPacket> repeated, Make(m_waiting.front()));
        packets.push_back(std::move(repeated));
        m_waiting.pop_front();
    }
    if (packet)
    {
        ASSIGN_OR_RETURN(FFmpegOwner<AVPacket> noted, Note(std::move(packet)));
        packets.push_back(std::move(noted));
    }
    return packets;
}

} // namespace boxreel
