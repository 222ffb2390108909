// SPDX-License-Identifier: MIT
#include "FFmpegLibrary.h"

#include <base/ErrorMacros.h>
#include <base/SharedLibrary.h>

#include <cassert>
#include <mutex>

namespace boxreel
{

namespace
{

FFmpegLibrary g_library;

// One per library, because each has its own list of functions.
#define BOXREEL_BIND(symbol)                                                                       \
    if (!library->Bind(#symbol, g_library.symbol))                                                 \
    {                                                                                              \
        return library->MissingError("the function " #symbol);                                     \
    }
#define BOXREEL_LOADER(function, functions)                                                        \
    Result<void> function(const std::string& name, const std::string& package)                     \
    {                                                                                              \
        Result<SharedLibrary> library = SharedLibrary::Open(name, package);                        \
        if (!library)                                                                              \
        {                                                                                          \
            return library.GetError();                                                             \
        }                                                                                          \
        functions(BOXREEL_BIND) return {};                                                         \
    }
BOXREEL_LOADER(BindUtil, BOXREEL_AVUTIL_FUNCTIONS)
BOXREEL_LOADER(BindScale, BOXREEL_SWSCALE_FUNCTIONS)
BOXREEL_LOADER(BindCodec, BOXREEL_AVCODEC_FUNCTIONS)
BOXREEL_LOADER(BindFormat, BOXREEL_AVFORMAT_FUNCTIONS)
#undef BOXREEL_LOADER
#undef BOXREEL_BIND

/// The major version is part of the name: the structures must match the headers of the build.
Result<void> LoadOne(Result<void> (*bind)(const std::string&, const std::string&),
                     const std::string& library, int major)
{
    return bind("lib" + library + ".so." + std::to_string(major),
                "lib" + library + std::to_string(major));
}

Result<void> LoadAll()
{
    RETURN_IF_ERROR(LoadOne(BindUtil, "avutil", LIBAVUTIL_VERSION_MAJOR));
    RETURN_IF_ERROR(LoadOne(BindScale, "swscale", LIBSWSCALE_VERSION_MAJOR));
    RETURN_IF_ERROR(LoadOne(BindCodec, "avcodec", LIBAVCODEC_VERSION_MAJOR));
    RETURN_IF_ERROR(LoadOne(BindFormat, "avformat", LIBAVFORMAT_VERSION_MAJOR));
    if (g_library.av_log_get_level() == AV_LOG_INFO) // libav's default: the program has not set a
                                                     // level
    {
        g_library.av_log_set_level(AV_LOG_QUIET);
    }
    return {};
}

} // namespace

Result<void> LoadFFmpeg()
{
    static std::mutex mutex;
    static bool loaded = false;
    const std::lock_guard lock(mutex);
    if (!loaded)
    {
        RETURN_IF_ERROR(LoadAll());
        loaded = true;
    }
    return {};
}

const FFmpegLibrary& FFmpeg()
{
    assert(g_library.avformat_open_input != nullptr && "LoadFFmpeg must have succeeded");
    return g_library;
}

std::string FFmpegText(int status)
{
    char text[AV_ERROR_MAX_STRING_SIZE] = "";
    FFmpeg().av_strerror(status, text, sizeof text);
    return text;
}

void FFmpegDelete::operator()(AVFrame* frame) const
{
    FFmpeg().av_frame_free(&frame);
}

void FFmpegDelete::operator()(AVPacket* packet) const
{
    FFmpeg().av_packet_free(&packet);
}

void FFmpegDelete::operator()(AVCodecContext* context) const
{
    FFmpeg().avcodec_free_context(&context);
}

void FFmpegDelete::operator()(AVCodecParameters* parameters) const
{
    FFmpeg().avcodec_parameters_free(&parameters);
}

void FFmpegDelete::operator()(SwsContext* context) const
{
    FFmpeg().sws_freeContext(context);
}

void FFmpegDelete::operator()(AVIOContext* context) const
{
    FFmpeg().av_freep(&context->buffer); // libav may have replaced the buffer
    FFmpeg().avio_context_free(&context);
}

} // namespace boxreel
