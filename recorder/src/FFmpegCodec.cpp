// SPDX-License-Identifier: MIT
#include "FFmpegCodec.h"
#include "SettingTexts.h"

#include "FFmpegPicture.h"

#include <base/ErrorMacros.h>
#include <base/Words.h>

#include <algorithm>
#include <utility>

namespace boxreel
{

namespace
{

// The bytes of x264 depend on the number of threads, so the default must not depend on the machine.
constexpr int kDefaultThreads = 2;

std::string ThisLibrary()
{
    return "libavcodec" + std::to_string(LIBAVCODEC_VERSION_MAJOR);
}

Error Missing(const EncoderPlan& plan, const std::string& film)
{
    return Error{ErrorKind::Absent, film,
                 "needs the encoder " + plan.encoder + ", which this build of libavcodec lacks",
                 "install Debian's " + ThisLibrary() +
                     " or write another format, such as frames-####.png"};
}

std::string Given(const VideoSettings& settings)
{
    return JoinedBy(" ", settings.codecOptions,
                    [](const auto& option) { return option.first + "=" + option.second; });
}

/// The encoder refused to start, most likely because of the user's options.
Error Refused(const EncoderPlan& plan, const VideoSettings& settings, const std::string& film,
              int status)
{
    const std::string options = Given(settings);
    if (!options.empty())
    {
        return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions, {options}},
                     "the encoder " + plan.encoder + " refuses it (" + FFmpegText(status) + ")",
                     "`ffmpeg -h encoder=" + plan.encoder + "` lists its options"};
    }
    return Error{ErrorKind::Failed, film, plan.encoder + " failed (" + FFmpegText(status) + ")",
                 "try another quality, size or format"};
}

/// Reports an option that the encoder did not use: a user's option, or one of ours that this
/// version does not have.
Error Unknown(const EncoderPlan& plan, const VideoSettings& settings, const std::string& option)
{
    for (const auto& [name, value] : settings.codecOptions)
    {
        if (name == option)
        {
            return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions, {option}},
                         "the encoder " + plan.encoder + " has no such option",
                         "`ffmpeg -h encoder=" + plan.encoder + "` lists its options"};
        }
    }
    return Error{ErrorKind::Absent, plan.encoder, "has no option " + option,
                 "install Debian's " + ThisLibrary()};
}

void TagColours(AVCodecContext& context, const EncoderPlan& plan)
{
    const std::string& pixelFormat = plan.pixelFormat;
    const bool isYuv = pixelFormat.starts_with("yuv");
    const bool isTagged = plan.muxer != "yuv4mpegpipe"; // has no field for a matrix
    context.colorspace = !isYuv     ? AVCOL_SPC_RGB
                         : isTagged ? AVCOL_SPC_BT709
                                    : UntaggedSpace(context.height);
    context.color_primaries = AVCOL_PRI_BT709;
    context.color_trc = isYuv ? AVCOL_TRC_BT709 : AVCOL_TRC_IEC61966_2_1;
    context.color_range = isYuv ? AVCOL_RANGE_MPEG : AVCOL_RANGE_JPEG;
    const bool isHalved = pixelFormat == "yuv420p";
    context.chroma_sample_location = isHalved ? AVCHROMA_LOC_LEFT : AVCHROMA_LOC_UNSPECIFIED;
}

/// Sets the common options of all codecs, before opening.
void SetUp(AVCodecContext& context, const EncoderPlan& plan, const VideoSettings& settings)
{
    context.width = settings.width;
    context.height = settings.height;
    context.sample_aspect_ratio = AVRational{1, 1};
    context.pix_fmt = FFmpeg().av_get_pix_fmt(plan.pixelFormat.c_str());
    context.framerate =
        AVRational{int(settings.framesPerSecond.num), int(settings.framesPerSecond.den)};
    context.time_base = TickOf(settings.framesPerSecond);
    context.thread_count = settings.threads > 0 ? settings.threads : kDefaultThreads;
    context.flags |= AV_CODEC_FLAG_BITEXACT; // no library versions in the film
    if (plan.muxer != "nut")
    {
        context.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    TagColours(context, plan);
}

/// True if libvpx may drop frames to hold a bit rate; the film would be shorter than stated.
bool DropsFrames(const AVCodecContext& context)
{
    std::int64_t threshold = 0;
    return context.codec->priv_class != nullptr &&
           FFmpeg().av_opt_get_int(context.priv_data, "drop-threshold", 0, &threshold) == 0 &&
           threshold > 0;
}

/// Returns the setting that a codec option has overridden although the film depends on it; null if
/// there is none.
const char* Overridden(const AVCodecContext& context, const EncoderPlan& plan,
                       const VideoSettings& settings)
{
    const auto equal = [](AVRational a, AVRational b) { return a.num == b.num && a.den == b.den; };
    FFmpegOwner<AVCodecContext> asked(FFmpeg().avcodec_alloc_context3(context.codec));
    SetUp(*asked, plan, settings);
    constexpr int kKept = AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_GLOBAL_HEADER;
    return context.width != asked->width || context.height != asked->height ? "size"
           : !equal(context.time_base, asked->time_base)                    ? "times"
           : context.pix_fmt != asked->pix_fmt                              ? "kind of pixels"
           : context.colorspace != asked->colorspace || context.color_range != asked->color_range ||
                   context.color_primaries != asked->color_primaries ||
                   context.color_trc != asked->color_trc
               ? "colours"
           : DropsFrames(context)                          ? "number of frames"
           : ((context.flags ^ asked->flags) & kKept) != 0 ? "header"
                                                           : nullptr;
}

} // namespace

AVRational TickOf(const Rational& framesPerSecond)
{
    return AVRational{int(framesPerSecond.den), int(framesPerSecond.num)};
}

Result<FFmpegCodec> FFmpegCodec::Open(const EncoderPlan& plan, const VideoSettings& settings,
                                      const std::string& film)
{
    const AVCodec* codec = FFmpeg().avcodec_find_encoder_by_name(plan.encoder.c_str());
    if (codec == nullptr)
    {
        return Missing(plan, film);
    }
    FFmpegOwner<AVCodecContext> context(FFmpeg().avcodec_alloc_context3(codec));
    SetUp(*context, plan, settings);
    AVDictionary* options = nullptr;
    for (const auto& [name, value] : plan.codecOptions)
    {
        FFmpeg().av_dict_set(&options, name.c_str(), value.c_str(), 0);
    }
    const int status = FFmpeg().avcodec_open2(context.get(), codec, &options);
    const AVDictionaryEntry* left =
        FFmpeg().av_dict_get(options, "", nullptr, AV_DICT_IGNORE_SUFFIX);
    const std::string unknown = left != nullptr ? left->key : "";
    FFmpeg().av_dict_free(&options);
    if (status < 0)
    {
        return Refused(plan, settings, film, status);
    }
    if (!unknown.empty())
    {
        return Unknown(plan, settings, unknown);
    }
    if (const char* what = Overridden(*context, plan, settings); what != nullptr)
    {
        return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions, {Given(settings)}},
                     std::string("changes the film's ") + what + ", which other options set",
                     "remove it"};
    }
    return FFmpegCodec(std::move(context));
}

Result<FFmpegOwner<AVCodecParameters>> FFmpegCodec::MakeParameters(const EncoderPlan& plan,
                                                                   const VideoSettings& settings,
                                                                   const std::string& film) const
{
    FFmpegOwner<AVCodecParameters> parameters(FFmpeg().avcodec_parameters_alloc());
    FFmpeg().avcodec_parameters_from_context(parameters.get(), m_context.get());
    if (parameters->extradata_size > 0 || plan.encoder != "libaom-av1")
    {
        return parameters;
    }
    // libaom returns its header only with the first packet. That is too late for a pipe, and for a
    // film that starts with packets of another. A separate run returns it.
    ASSIGN_OR_RETURN(FFmpegCodec probe, Open(plan, settings, film));
    ASSIGN_OR_RETURN(const FFmpegOwner<AVPacket> packet, probe.EncodeBlack());
    std::size_t size = 0;
    const std::uint8_t* header =
        FFmpeg().av_packet_get_side_data(packet.get(), AV_PKT_DATA_NEW_EXTRADATA, &size);
    if (header != nullptr)
    {
        parameters->extradata =
            static_cast<std::uint8_t*>(FFmpeg().av_mallocz(size + AV_INPUT_BUFFER_PADDING_SIZE));
        parameters->extradata_size = int(size);
        std::copy_n(header, size, parameters->extradata);
    }
    return parameters;
}

/// Encodes one black picture and returns its packet.
Result<FFmpegOwner<AVPacket>> FFmpegCodec::EncodeBlack()
{
    ASSIGN_OR_RETURN(FFmpegOwner<AVFrame> picture, MakePicture());
    const Frame black(m_context->width, m_context->height);
    ASSIGN_OR_RETURN(const FrameToPicture converter,
                     FrameToPicture::Create(black.width, black.height, m_context->pix_fmt,
                                            m_context->colorspace));
    converter.Convert(black, *picture);
    picture->pts = 0;
    FFmpegOwner<AVPacket> packet(FFmpeg().av_packet_alloc());
    int status = Send(picture.get());
    status = status < 0 ? status : Send(nullptr);
    status = status < 0 ? status : Receive(*packet);
    if (status < 0)
    {
        return Error{ErrorKind::Failed, m_context->codec->name,
                     "the encoder refuses a picture (" + FFmpegText(status) + ")",
                     "try another quality or format"};
    }
    return packet;
}

Result<FFmpegOwner<AVFrame>> FFmpegCodec::MakePicture() const
{
    FFmpegOwner<AVFrame> picture(FFmpeg().av_frame_alloc());
    picture->width = m_context->width;
    picture->height = m_context->height;
    picture->format = m_context->pix_fmt;
    picture->colorspace = m_context->colorspace;
    picture->color_primaries = m_context->color_primaries;
    picture->color_trc = m_context->color_trc;
    picture->color_range = m_context->color_range;
    picture->chroma_location = m_context->chroma_sample_location;
    const int status = FFmpeg().av_frame_get_buffer(picture.get(), 0);
    if (status < 0)
    {
        return Error{ErrorKind::Failed,
                     std::to_string(picture->width) + "x" + std::to_string(picture->height) +
                         " pixels",
                     "not enough memory for a frame (" + FFmpegText(status) + ")",
                     "free some memory or use a smaller size"};
    }
    return picture;
}

int FFmpegCodec::Send(const AVFrame* picture)
{
    return FFmpeg().avcodec_send_frame(m_context.get(), picture);
}

int FFmpegCodec::Receive(AVPacket& packet)
{
    return FFmpeg().avcodec_receive_packet(m_context.get(), &packet);
}

} // namespace boxreel
