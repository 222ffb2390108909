// SPDX-License-Identifier: MIT
#include "FFmpegMuxer.h"

#include <base/ErrorMacros.h>

#include <utility>

namespace boxreel
{

/// Returns the first error of the file, or libav's reason.
Error FFmpegMuxer::WriteError(int status) const
{
    return m_output->FirstError(Error{ErrorKind::Failed, m_film,
                                      "cannot be written: " + FFmpegText(status),
                                      "try another format"});
}

Result<FFmpegMuxer> FFmpegMuxer::Open(FFmpegOutput& output, const std::string& muxer,
                                      const Options& options, const MuxerStream& stream,
                                      const std::string& film)
{
    FFmpegMuxer opened(output);
    opened.m_film = film;
    AVFormatContext* context = nullptr;
    const int status =
        FFmpeg().avformat_alloc_output_context2(&context, nullptr, muxer.c_str(), nullptr);
    if (status < 0)
    {
        return opened.WriteError(status);
    }
    opened.m_context.reset(context);
    context->flags |= AVFMT_FLAG_BITEXACT; // no dates, versions or random numbers
    if (muxer == "apng")
    {
        context->flags |= AVFMT_FLAG_FLUSH_PACKETS; // packets are few; a killed run then loses none
    }
    output.AttachTo(*context);
    opened.m_tick = stream.tick;
    opened.m_stream = FFmpeg().avformat_new_stream(context, nullptr);
    FFmpeg().avcodec_parameters_copy(opened.m_stream->codecpar, stream.codec);
    if (stream.codec->codec_id != AV_CODEC_ID_RAWVIDEO)
    {
        opened.m_stream->codecpar->codec_tag = 0; // each container has its own tag
    }
    opened.m_stream->time_base = stream.tick;
    opened.m_stream->avg_frame_rate = stream.framesPerSecond;
    opened.m_stream->sample_aspect_ratio = stream.codec->sample_aspect_ratio;
    RETURN_IF_ERROR(opened.WriteHeader(options));
    return opened;
}

Result<void> FFmpegMuxer::WriteHeader(const Options& options)
{
    AVDictionary* dictionary = nullptr;
    for (const auto& [name, value] : options)
    {
        FFmpeg().av_dict_set(&dictionary, name.c_str(), value.c_str(), 0);
    }
    const int status = FFmpeg().avformat_write_header(m_context.get(), &dictionary);
    FFmpeg().av_dict_free(&dictionary);
    if (status < 0)
    {
        return WriteError(status);
    }
    m_isTrailerDue = true;
    return {};
}

FFmpegMuxer::~FFmpegMuxer()
{
    if (m_context && m_isTrailerDue)
    {
        // libav's muxer of animated PNGs releases its last packet only here; the file itself is
        // discarded.
        FFmpeg().av_write_trailer(m_context.get());
    }
}

Result<void> FFmpegMuxer::Write(AVPacket& packet)
{
    packet.stream_index = 0;
    FFmpeg().av_packet_rescale_ts(&packet, m_tick, m_stream->time_base);
    const int status = FFmpeg().av_write_frame(m_context.get(), &packet);
    FFmpeg().av_packet_unref(&packet);
    return status < 0 || m_output->HasFailed() ? Result<void>(WriteError(status)) : Result<void>();
}

void FFmpegMuxer::SetFinalDelay(std::int64_t ticks)
{
    const AVRational delay{int(ticks * m_tick.num), m_tick.den};
    FFmpeg().av_opt_set_q(m_context->priv_data, "final_delay", delay, 0);
}

Result<void> FFmpegMuxer::Finish()
{
    m_isTrailerDue = false;
    const int status = FFmpeg().av_write_trailer(m_context.get());
    m_output->Flush();
    return status < 0 || m_output->HasFailed() ? Result<void>(WriteError(status)) : Result<void>();
}

} // namespace boxreel
