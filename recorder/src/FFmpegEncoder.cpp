// SPDX-License-Identifier: MIT
#include "FFmpegEncoder.h"

#include "FFmpegLibrary.h"
#include "FFmpegOutput.h"
#include "FFmpegPicture.h"
#include "GifPalette.h"

#include <debugdraw/AtomicFile.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace boxreel
{

namespace
{

// The bytes of x264's film depend on the number of its threads, so the number must not depend on
// the machine.
constexpr int kDefaultThreads = 2;

struct FormatContextDelete
{
    void operator()(AVFormatContext* context) const { FFmpeg().avformat_free_context(context); }
};

class FFmpegEncoder final : public VideoSink
{
public:
    FFmpegEncoder(std::filesystem::path path, VideoFormat format, const VideoSettings& settings)
        : m_path(std::move(path)), m_format(format), m_settings(settings),
          m_plan(PlanFor(format, settings.quality))
    {}

    ~FFmpegEncoder() override;

    Result<void> Open();
    Result<void> Append(const Frame& frame) override;
    Result<void> Repeat() override;
    Result<void> Close() override;

private:
    bool IsGif() const { return m_format == VideoFormat::Gif; }
    std::int64_t TimeOf(std::int64_t frame) const; ///< in ticks of the codec
    Result<void> OpenCodec();
    void TagColours();
    Result<void> OpenPicture();
    Result<void> OpenMuxer();
    Result<void> WriteHeader();
    Result<void> RenewPicture();
    Result<void> FillIndexed(const Frame& frame);
    Result<void> SendPicture();
    Result<void> Drain();
    Error SetupError(const char* what, int status) const;
    Error WriteError(int status) const;

    std::filesystem::path m_path;
    VideoFormat m_format;
    VideoSettings m_settings;
    EncoderPlan m_plan;
    std::optional<AtomicFile> m_file;
    std::unique_ptr<FFmpegOutput> m_output;
    std::unique_ptr<AVFormatContext, FormatContextDelete> m_muxer;
    AVStream* m_stream = nullptr; // the muxer's
    FFmpegOwner<AVCodecContext> m_codec;
    FFmpegOwner<AVFrame> m_picture;
    FFmpegOwner<AVPacket> m_packet;
    std::unique_ptr<FrameToPicture> m_converter; // none for a GIF
    GifPalette m_palette;
    std::int64_t m_frames = 0;   // appended or repeated
    bool m_isTrailerDue = false; // the header is written
};

Error FFmpegEncoder::SetupError(const char* what, int status) const
{
    return Error{ErrorKind::Failed, m_path.string() + " cannot be made: " + what + " failed (" +
                                        FFmpegText(status) +
                                        "); try another quality, size or format."};
}

/// What the file said first, or libav's reason.
Error FFmpegEncoder::WriteError(int status) const
{
    return m_output->FirstError(
        Error{ErrorKind::Failed, m_path.string() + " could not be written: " + FFmpegText(status) +
                                     "; try another format."});
}

Result<void> FFmpegEncoder::Open()
{
    if (Result<void> done = OpenCodec(); !done)
    {
        return done;
    }
    if (Result<void> done = OpenPicture(); !done)
    {
        return done;
    }
    Result<AtomicFile> file = AtomicFile::Create(m_path, m_settings.overwrite);
    if (!file)
    {
        return file.GetError();
    }
    m_file.emplace(std::move(*file));
    m_output = std::make_unique<FFmpegOutput>(*m_file);
    return OpenMuxer();
}

std::int64_t FFmpegEncoder::TimeOf(std::int64_t frame) const
{
    return IsGif() ? GifTimeOfFrame(frame, m_settings.framesPerSecond) : frame;
}

Result<void> FFmpegEncoder::OpenCodec()
{
    const AVCodec* codec = FFmpeg().avcodec_find_encoder_by_name(m_plan.encoder);
    if (codec == nullptr)
    {
        return Error{ErrorKind::Absent,
                     m_path.string() + " needs the encoder " + m_plan.encoder +
                         ", which this build of libavcodec lacks; install Debian's libavcodec" +
                         std::to_string(LIBAVCODEC_VERSION_MAJOR) +
                         " or write another format, such as frames-####.png."};
    }
    m_codec.reset(FFmpeg().avcodec_alloc_context3(codec));
    m_codec->width = m_settings.width;
    m_codec->height = m_settings.height;
    m_codec->sample_aspect_ratio = AVRational{1, 1};
    m_codec->pix_fmt = FFmpeg().av_get_pix_fmt(m_plan.pixelFormat);
    const AVRational rate{int(m_settings.framesPerSecond.num), int(m_settings.framesPerSecond.den)};
    m_codec->framerate = rate;
    m_codec->time_base = IsGif() ? AVRational{1, 100} : AVRational{rate.den, rate.num};
    m_codec->thread_count = m_settings.threads > 0 ? m_settings.threads : kDefaultThreads;
    m_codec->flags |= AV_CODEC_FLAG_BITEXACT; // no versions of libraries in the film
    if (std::strcmp(m_plan.muxer, "gif") != 0)
    {
        m_codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    TagColours();
    AVDictionary* options = nullptr;
    for (const auto& [name, value] : m_plan.codecOptions)
    {
        FFmpeg().av_dict_set(&options, name, value, 0);
    }
    const int status = FFmpeg().avcodec_open2(m_codec.get(), codec, &options);
    const AVDictionaryEntry* unknown =
        FFmpeg().av_dict_get(options, "", nullptr, AV_DICT_IGNORE_SUFFIX);
    const std::string unknownName = unknown != nullptr ? unknown->key : "";
    FFmpeg().av_dict_free(&options);
    if (status < 0)
    {
        return SetupError(m_plan.encoder, status);
    }
    if (!unknownName.empty())
    {
        return Error{ErrorKind::Absent, std::string("The encoder ") + m_plan.encoder +
                                            " of this machine knows no option " + unknownName +
                                            "; install Debian's libavcodec" +
                                            std::to_string(LIBAVCODEC_VERSION_MAJOR) + "."};
    }
    return {};
}

void FFmpegEncoder::TagColours()
{
    if (IsGif())
    {
        return; // a GIF has no place for tags
    }
    const bool isYuv = std::strcmp(m_plan.pixelFormat, "yuv420p") == 0;
    m_codec->colorspace = isYuv ? AVCOL_SPC_BT709 : AVCOL_SPC_RGB;
    m_codec->color_primaries = AVCOL_PRI_BT709;
    m_codec->color_trc = isYuv ? AVCOL_TRC_BT709 : AVCOL_TRC_IEC61966_2_1;
    m_codec->color_range = isYuv ? AVCOL_RANGE_MPEG : AVCOL_RANGE_JPEG;
    m_codec->chroma_sample_location = isYuv ? AVCHROMA_LOC_LEFT : AVCHROMA_LOC_UNSPECIFIED;
}

Result<void> FFmpegEncoder::OpenPicture()
{
    m_packet.reset(FFmpeg().av_packet_alloc());
    if (!IsGif())
    {
        Result<FrameToPicture> converter =
            FrameToPicture::Create(m_settings.width, m_settings.height, m_codec->pix_fmt);
        if (!converter)
        {
            return converter.GetError();
        }
        m_converter = std::make_unique<FrameToPicture>(std::move(*converter));
    }
    m_picture.reset(FFmpeg().av_frame_alloc());
    return RenewPicture();
}

/// An empty picture to write into.
Result<void> FFmpegEncoder::RenewPicture()
{
    FFmpeg().av_frame_unref(m_picture.get());
    m_picture->width = m_codec->width;
    m_picture->height = m_codec->height;
    m_picture->format = m_codec->pix_fmt;
    m_picture->colorspace = m_codec->colorspace;
    m_picture->color_primaries = m_codec->color_primaries;
    m_picture->color_trc = m_codec->color_trc;
    m_picture->color_range = m_codec->color_range;
    m_picture->chroma_location = m_codec->chroma_sample_location;
    const int status = FFmpeg().av_frame_get_buffer(m_picture.get(), 0);
    return status < 0 ? Result<void>(SetupError("making a picture", status)) : Result<void>();
}

Result<void> FFmpegEncoder::OpenMuxer()
{
    AVFormatContext* muxer = nullptr;
    const int status = FFmpeg().avformat_alloc_output_context2(&muxer, nullptr, m_plan.muxer,
                                                               m_path.filename().c_str());
    if (status < 0)
    {
        return SetupError(m_plan.muxer, status);
    }
    m_muxer.reset(muxer);
    m_muxer->flags |= AVFMT_FLAG_BITEXACT; // no dates, no versions, no random numbers
    m_output->AttachTo(*m_muxer);
    m_stream = FFmpeg().avformat_new_stream(muxer, nullptr);
    m_stream->time_base = m_codec->time_base;
    m_stream->avg_frame_rate = m_codec->framerate;
    m_stream->sample_aspect_ratio = m_codec->sample_aspect_ratio;
    FFmpeg().avcodec_parameters_from_context(m_stream->codecpar, m_codec.get());
    return WriteHeader();
}

Result<void> FFmpegEncoder::WriteHeader()
{
    AVDictionary* options = nullptr;
    for (const auto& [name, value] : m_plan.muxerOptions)
    {
        FFmpeg().av_dict_set(&options, name, value, 0);
    }
    const int status = FFmpeg().avformat_write_header(m_muxer.get(), &options);
    FFmpeg().av_dict_free(&options);
    if (status < 0)
    {
        return m_output->FirstError(SetupError(m_plan.muxer, status));
    }
    m_isTrailerDue = true;
    return {};
}

FFmpegEncoder::~FFmpegEncoder()
{
    if (m_isTrailerDue && IsGif())
    {
        // libav's GIF muxer lets go of its last packet only here; the file itself is discarded.
        FFmpeg().av_write_trailer(m_muxer.get());
    }
}

Result<void> FFmpegEncoder::Append(const Frame& frame)
{
    // The encoder may still look at the last picture; a new one then costs an allocation from a
    // pool.
    if (FFmpeg().av_frame_is_writable(m_picture.get()) == 0)
    {
        if (Result<void> done = RenewPicture(); !done)
        {
            return done;
        }
    }
    if (IsGif())
    {
        if (Result<void> done = FillIndexed(frame); !done)
        {
            return done;
        }
    }
    else
    {
        m_converter->Convert(frame, *m_picture);
    }
    return SendPicture();
}

Result<void> FFmpegEncoder::Repeat()
{
    return SendPicture();
}

Result<void> FFmpegEncoder::FillIndexed(const Frame& frame)
{
    const bool exact =
        m_palette.Map(frame, m_picture->data[0], std::size_t(m_picture->linesize[0]));
    if (!exact && m_settings.quality == Quality::Lossless)
    {
        return Error{ErrorKind::Unusable,
                     m_path.string() + " cannot be lossless, frame " + std::to_string(m_frames) +
                         " has more than 256 colours; use .mkv or frames-####.png."};
    }
    std::memcpy(m_picture->data[1], m_palette.Colors().data(),
                sizeof(std::uint32_t) * GifPalette::kSize);
    return {};
}

Result<void> FFmpegEncoder::SendPicture()
{
    const std::int64_t frame = m_frames++;
    if (IsGif() && frame % GifFrameStep(m_settings.framesPerSecond) != 0)
    {
        return {};
    }
    m_picture->pts = TimeOf(frame);
    const int status = FFmpeg().avcodec_send_frame(m_codec.get(), m_picture.get());
    if (status < 0)
    {
        return WriteError(status);
    }
    return Drain();
}

/// Writes what the encoder has ready.
Result<void> FFmpegEncoder::Drain()
{
    const std::int64_t step = IsGif() ? GifFrameStep(m_settings.framesPerSecond) : 1;
    while (true)
    {
        int status = FFmpeg().avcodec_receive_packet(m_codec.get(), m_packet.get());
        if (status == AVERROR(EAGAIN) || status == AVERROR_EOF)
        {
            return m_output->HasFailed() ? Result<void>(WriteError(status)) : Result<void>();
        }
        if (status >= 0)
        {
            // GIF knows no reordering, so packets come in the order of frames, each `step` after
            // the last.
            m_packet->duration = 1;
            if (IsGif())
            {
                const std::int64_t last = (m_frames - 1) / step * step;
                m_packet->duration = TimeOf(last + step) - TimeOf(last);
            }
            FFmpeg().av_packet_rescale_ts(m_packet.get(), m_codec->time_base, m_stream->time_base);
            status = FFmpeg().av_write_frame(m_muxer.get(), m_packet.get());
            FFmpeg().av_packet_unref(m_packet.get());
        }
        if (status < 0)
        {
            return WriteError(status);
        }
    }
}

Result<void> FFmpegEncoder::Close()
{
    int status = FFmpeg().avcodec_send_frame(m_codec.get(), nullptr);
    if (status < 0)
    {
        return WriteError(status);
    }
    if (Result<void> done = Drain(); !done)
    {
        return done;
    }
    if (IsGif())
    {
        // The last frame stays until the end of the film; the muxer alone would repeat the delay
        // before it.
        const std::int64_t step = GifFrameStep(m_settings.framesPerSecond);
        const std::int64_t last = (m_frames - 1) / step * step;
        FFmpeg().av_opt_set_int(m_muxer->priv_data, "final_delay",
                                std::max<std::int64_t>(TimeOf(m_frames) - TimeOf(last), 2), 0);
    }
    m_isTrailerDue = false;
    status = FFmpeg().av_write_trailer(m_muxer.get());
    m_output->Flush();
    if (status < 0 || m_output->HasFailed())
    {
        return WriteError(status);
    }
    return m_file->Commit();
}

} // namespace

Result<std::unique_ptr<VideoSink>> OpenFFmpegEncoder(const std::filesystem::path& path,
                                                     VideoFormat format,
                                                     const VideoSettings& settings)
{
    if (Result<void> loaded = LoadFFmpeg(); !loaded)
    {
        return loaded.GetError();
    }
    auto encoder = std::make_unique<FFmpegEncoder>(path, format, settings);
    if (Result<void> opened = encoder->Open(); !opened)
    {
        return opened.GetError();
    }
    return std::unique_ptr<VideoSink>(std::move(encoder));
}

} // namespace boxreel
