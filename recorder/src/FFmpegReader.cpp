// SPDX-License-Identifier: MIT
#include "FFmpegReader.h"

#include "FFmpegLibrary.h"
#include "FFmpegPackets.h"
#include "FFmpegPicture.h"
#include "GifRate.h"

#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

// Allowed containers; none of them refers to other files or to the network.
constexpr const char* kContainers = "mov,matroska,gif,apng,avi,nut,yuv4mpegpipe,ivf,flv,ogg,mpegts";
constexpr std::int64_t kMaxPixels = 8192 * 8192;

struct InputDelete
{
    void operator()(AVFormatContext* context) const { FFmpeg().avformat_close_input(&context); }
};

std::string NameOr(const char* name)
{
    return name != nullptr ? name : "unknown";
}

/// Returns the duration of a frame in its stream's ticks. The member's name changed with FFmpeg 6.
template <class Frame>
std::int64_t LengthOf(const Frame& frame)
{
    if constexpr (requires { frame.duration; })
    {
        return frame.duration;
    }
    else
    {
        return frame.pkt_duration;
    }
}

/// Returns the duration of each frame of a GIF [1/100 s].
std::vector<std::int64_t> DelaysOf(const std::filesystem::path& path)
{
    std::vector<std::int64_t> delays;
    if (Result<FFmpegPackets> packets = FFmpegPackets::Open(path, {1, 100}))
    {
        while (const FFmpegOwner<AVPacket> packet = packets->Next())
        {
            delays.push_back(std::max<std::int64_t>(packet->duration, 1));
        }
    }
    return delays;
}

class FFmpegReader final : public VideoSource
{
public:
    explicit FFmpegReader(std::filesystem::path path) : m_path(std::move(path)) {}

    Result<void> Open();
    Result<bool> Next(StoredFrame& stored) override;

private:
    Result<void> OpenInput();
    Result<void> OpenDecoder();
    void FillInfo();
    Result<void> Feed();
    Result<bool> End();
    bool HasEnd() const;
    double PlaceEvenly(double seconds, double length);
    Error Damaged(const std::string& why) const;

    std::filesystem::path m_path;
    std::unique_ptr<AVFormatContext, InputDelete> m_input;
    AVStream* m_stream = nullptr; // owned by the input
    FFmpegOwner<AVCodecContext> m_decoder;
    FFmpegOwner<AVPacket> m_packet;
    FFmpegOwner<AVFrame> m_picture;
    PictureToFrame m_converter;
    std::int64_t m_frames = 0;
    double m_end = 0.0;         // end of the last frame [s]
    std::int64_t m_periods = 0; // shown frames of an animated PNG
    bool m_isEven = true;       // every frame lasts a whole number of periods
    bool m_isDraining = false;
};

Error FFmpegReader::Damaged(const std::string& why) const
{
    return Error{ErrorKind::Failed, m_path.string(),
                 "is damaged or truncated after " + std::to_string(m_frames) + " frames (" + why +
                     ")",
                 "record it again"};
}

Result<void> FFmpegReader::Open()
{
    RETURN_IF_ERROR(OpenInput());
    RETURN_IF_ERROR(OpenDecoder());
    FillInfo();
    return {};
}

Result<void> FFmpegReader::OpenInput()
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(m_path, error))
    {
        return std::filesystem::exists(m_path, error)
                   ? Error{ErrorKind::Unusable, m_path.string(), "is not a file", "name a film"}
                   : FileNotFound(m_path);
    }
    AVDictionary* options = nullptr;
    FFmpeg().av_dict_set(&options, "format_whitelist", kContainers, 0);
    FFmpeg().av_dict_set(&options, "protocol_whitelist", "file", 0);
    AVFormatContext* input = nullptr;
    // "file:" prevents a colon in the name from being parsed as a protocol.
    int status = FFmpeg().avformat_open_input(&input, ("file:" + m_path.string()).c_str(), nullptr,
                                              &options);
    FFmpeg().av_dict_free(&options);
    if (status >= 0)
    {
        m_input.reset(input);
        status = FFmpeg().avformat_find_stream_info(input, nullptr);
    }
    if (status >= 0)
    {
        status = FFmpeg().av_find_best_stream(input, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    }
    if (status < 0)
    {
        return Error{ErrorKind::Unusable, m_path.string(),
                     "is not a film, or is damaged or truncated (" + FFmpegText(status) + ")",
                     "name a film, or record it again"};
    }
    m_stream = input->streams[status];
    return {};
}

Result<void> FFmpegReader::OpenDecoder()
{
    const AVCodec* codec = FFmpeg().avcodec_find_decoder(m_stream->codecpar->codec_id);
    if (codec == nullptr)
    {
        return Error{ErrorKind::Absent, m_path.string(),
                     "needs a decoder that this build of libavcodec lacks",
                     "install Debian's libavcodec-extra"};
    }
    m_decoder.reset(FFmpeg().avcodec_alloc_context3(codec));
    FFmpeg().avcodec_parameters_to_context(m_decoder.get(), m_stream->codecpar);
    m_decoder->pkt_timebase = m_stream->time_base;
    m_decoder->max_pixels = kMaxPixels;
    m_decoder->err_recognition =
        AV_EF_CRCCHECK | AV_EF_EXPLODE; // no error concealment for damaged films
    const int status = FFmpeg().avcodec_open2(m_decoder.get(), codec, nullptr);
    if (status < 0)
    {
        return Error{ErrorKind::Unusable, m_path.string(),
                     "cannot be decoded (" + FFmpegText(status) + ")", "record it again"};
    }
    m_packet.reset(FFmpeg().av_packet_alloc());
    m_picture.reset(FFmpeg().av_frame_alloc());
    return {};
}

void FFmpegReader::FillInfo()
{
    const AVCodecParameters& codec = *m_stream->codecpar;
    info.container = m_input->iformat->name;
    info.width = codec.width;
    info.height = codec.height;
    AVRational rate = m_stream->avg_frame_rate;
    if (info.container.find("mp4") != std::string::npos)
    {
        // The average counts a held frame only once; all times are multiples of this rate.
        rate = m_stream->r_frame_rate;
    }
    if (rate.num <= 0 || rate.den <= 0)
    {
        rate = FFmpeg().av_guess_frame_rate(m_input.get(), m_stream, nullptr);
    }
    info.framesPerSecond =
        rate.num > 0 && rate.den > 0 ? Rational{rate.num, rate.den} : Rational{1, 1};
    if (info.container == "gif")
    {
        info.framesPerSecond = RateOfGif(DelaysOf(m_path));
    }
    info.codec = m_decoder->codec->name;
    info.pixelFormat = NameOr(FFmpeg().av_get_pix_fmt_name(AVPixelFormat(codec.format)));
    info.colorSpace = NameOr(FFmpeg().av_color_space_name(codec.color_space));
    info.colorPrimaries = NameOr(FFmpeg().av_color_primaries_name(codec.color_primaries));
    info.colorTransfer = NameOr(FFmpeg().av_color_transfer_name(codec.color_trc));
    info.colorRange = NameOr(FFmpeg().av_color_range_name(codec.color_range));
}

/// Sends the next packet of the film, or its end, to the decoder.
Result<void> FFmpegReader::Feed()
{
    int status = FFmpeg().av_read_frame(m_input.get(), m_packet.get());
    if (status == AVERROR_EOF && m_input->pb != nullptr && m_input->pb->error == 0)
    {
        m_isDraining = true;
        status = FFmpeg().avcodec_send_packet(m_decoder.get(), nullptr);
        return status < 0 ? Result<void>(Damaged(FFmpegText(status))) : Result<void>();
    }
    if (status < 0)
    {
        return Damaged(FFmpegText(status));
    }
    const bool isOurs = m_packet->stream_index == m_stream->index;
    const bool isCorrupt = isOurs && (m_packet->flags & AV_PKT_FLAG_CORRUPT) != 0;
    if (isOurs && !isCorrupt)
    {
        status = FFmpeg().avcodec_send_packet(m_decoder.get(), m_packet.get());
    }
    FFmpeg().av_packet_unref(m_packet.get());
    if (isCorrupt || status < 0)
    {
        return Damaged(isCorrupt ? "a frame is incomplete" : FFmpegText(status));
    }
    return {};
}

/// True if an animation has its end marker; its header contains no length.
bool FFmpegReader::HasEnd() const
{
    constexpr std::string_view kEndOfPng("\0\0\0\0IEND\xae\x42\x60\x82", 12);
    const bool isGif = info.container == "gif";
    const std::string_view expected = isGif ? std::string_view(";") : kEndOfPng;
    std::ifstream file(m_path, std::ios::binary);
    file.seekg(-std::streamoff(expected.size()), std::ios::end);
    std::string end(expected.size(), ' ');
    file.read(end.data(), std::streamsize(end.size()));
    return (!isGif && info.container != "apng") || (file && end == expected);
}

/// Checks after the last picture that the film is as long as its header states.
Result<bool> FFmpegReader::End()
{
    if (m_frames == 0)
    {
        return Damaged("it has no frame");
    }
    if (!HasEnd())
    {
        return Damaged("its end is missing");
    }
    if (m_stream->nb_frames > 0 && m_frames < m_stream->nb_frames)
    {
        return Damaged(std::to_string(m_stream->nb_frames) + " in its header");
    }
    const double promised = double(m_input->duration) / AV_TIME_BASE;
    const double period = 1.0 / info.framesPerSecond.ToDouble();
    const bool isStoredDuration =
        m_input->duration_estimation_method != AVFMT_DURATION_FROM_BITRATE;
    // The header's time unit may be a millisecond, so only a missing whole frame counts.
    if (m_input->duration > 0 && isStoredDuration && m_end + 0.5 * period + 0.002 < promised)
    {
        return Damaged(std::to_string(promised) + " s in its header");
    }
    return false;
}

/// Returns when a frame of an animated PNG is shown. libav adds up rounded durations, which drifts
/// by one frame in a few thousand. If all durations are whole periods, these are counted instead.
double FFmpegReader::PlaceEvenly(double seconds, double length)
{
    constexpr double kRounded = 1e-5; // half of libav's tick, plus rounding [s]
    const Rational& rate = info.framesPerSecond;
    const std::int64_t before = m_periods;
    const std::int64_t periods = std::llround(length * rate.ToDouble());
    m_isEven = m_isEven && std::abs(double(periods) / rate.ToDouble() - length) < kRounded;
    m_periods += periods;
    return m_isEven ? double(before * rate.den) / double(rate.num) : seconds;
}

Result<bool> FFmpegReader::Next(StoredFrame& stored)
{
    while (true)
    {
        const int status = FFmpeg().avcodec_receive_frame(m_decoder.get(), m_picture.get());
        if (status == AVERROR_EOF)
        {
            return End();
        }
        if (status == AVERROR(EAGAIN) && !m_isDraining)
        {
            RETURN_IF_ERROR(Feed());
            continue;
        }
        if (status < 0)
        {
            return Damaged(FFmpegText(status));
        }
        break;
    }
    if (Result<void> converted = m_converter.Convert(*m_picture, stored.frame); !converted)
    {
        return Damaged(converted.GetError().Text());
    }
    const AVRational base = m_stream->time_base;
    stored.seconds = double(m_picture->best_effort_timestamp * base.num) / double(base.den);
    stored.length = double(LengthOf(*m_picture) * base.num) / double(base.den);
    if (info.container == "apng")
    {
        stored.seconds = PlaceEvenly(stored.seconds, stored.length);
    }
    m_end = stored.seconds + std::max(stored.length, 1.0 / info.framesPerSecond.ToDouble());
    ++m_frames;
    FFmpeg().av_frame_unref(m_picture.get());
    return true;
}

} // namespace

Result<std::unique_ptr<VideoSource>> OpenFFmpegReader(const std::filesystem::path& path)
{
    RETURN_IF_ERROR(LoadFFmpeg());
    auto reader = std::make_unique<FFmpegReader>(path);
    RETURN_IF_ERROR(reader->Open());
    return std::unique_ptr<VideoSource>(std::move(reader));
}

} // namespace boxreel
