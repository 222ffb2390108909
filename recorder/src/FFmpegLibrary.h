// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/avutil.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

/// libav, loaded on first use: linking it would delay the start of every command. A table of the
/// functions in use, and owners of their objects. Only the files named FFmpeg* include this.
namespace boxreel
{

#define BOXREEL_AVUTIL_FUNCTIONS(X)                                                                \
    X(av_color_primaries_name)                                                                     \
    X(av_color_range_name)                                                                         \
    X(av_color_space_name)                                                                         \
    X(av_color_transfer_name)                                                                      \
    X(av_dict_free)                                                                                \
    X(av_dict_get)                                                                                 \
    X(av_dict_set)                                                                                 \
    X(av_frame_alloc)                                                                              \
    X(av_frame_free)                                                                               \
    X(av_frame_get_buffer)                                                                         \
    X(av_frame_is_writable)                                                                        \
    X(av_frame_unref)                                                                              \
    X(av_freep)                                                                                    \
    X(av_get_pix_fmt)                                                                              \
    X(av_get_pix_fmt_name)                                                                         \
    X(av_log_get_level)                                                                            \
    X(av_log_set_level)                                                                            \
    X(av_malloc)                                                                                   \
    X(av_mallocz)                                                                                  \
    X(av_opt_get_int)                                                                              \
    X(av_opt_set_int)                                                                              \
    X(av_opt_set_q)                                                                                \
    X(av_pix_fmt_desc_get)                                                                         \
    X(av_strdup)                                                                                   \
    X(av_strerror)

#define BOXREEL_SWSCALE_FUNCTIONS(X)                                                               \
    X(sws_alloc_context)                                                                           \
    X(sws_freeContext)                                                                             \
    X(sws_getCoefficients)                                                                         \
    X(sws_init_context)                                                                            \
    X(sws_isSupportedInput)                                                                        \
    X(sws_scale)                                                                                   \
    X(sws_setColorspaceDetails)

#define BOXREEL_AVCODEC_FUNCTIONS(X)                                                               \
    X(av_new_packet)                                                                               \
    X(av_packet_alloc)                                                                             \
    X(av_packet_free)                                                                              \
    X(av_packet_get_side_data)                                                                     \
    X(av_packet_make_writable)                                                                     \
    X(av_packet_ref)                                                                               \
    X(av_packet_rescale_ts)                                                                        \
    X(av_packet_unref)                                                                             \
    X(avcodec_alloc_context3)                                                                      \
    X(avcodec_find_decoder)                                                                        \
    X(avcodec_find_encoder_by_name)                                                                \
    X(avcodec_free_context)                                                                        \
    X(avcodec_open2)                                                                               \
    X(avcodec_parameters_alloc)                                                                    \
    X(avcodec_parameters_copy)                                                                     \
    X(avcodec_parameters_free)                                                                     \
    X(avcodec_parameters_from_context)                                                             \
    X(avcodec_parameters_to_context)                                                               \
    X(avcodec_receive_frame)                                                                       \
    X(avcodec_receive_packet)                                                                      \
    X(avcodec_send_frame)                                                                          \
    X(avcodec_send_packet)

#define BOXREEL_AVFORMAT_FUNCTIONS(X)                                                              \
    X(av_find_best_stream)                                                                         \
    X(av_guess_frame_rate)                                                                         \
    X(av_read_frame)                                                                               \
    X(av_write_frame)                                                                              \
    X(av_write_trailer)                                                                            \
    X(avformat_alloc_output_context2)                                                              \
    X(avformat_close_input)                                                                        \
    X(avformat_find_stream_info)                                                                   \
    X(avformat_free_context)                                                                       \
    X(avformat_new_stream)                                                                         \
    X(avformat_open_input)                                                                         \
    X(avformat_write_header)                                                                       \
    X(avio_alloc_context)                                                                          \
    X(avio_context_free)                                                                           \
    X(avio_flush)

struct FFmpegLibrary
{
#define BOXREEL_DECLARE(name) decltype(&::name) name = nullptr;
    BOXREEL_AVUTIL_FUNCTIONS(BOXREEL_DECLARE)
    BOXREEL_SWSCALE_FUNCTIONS(BOXREEL_DECLARE)
    BOXREEL_AVCODEC_FUNCTIONS(BOXREEL_DECLARE)
    BOXREEL_AVFORMAT_FUNCTIONS(BOXREEL_DECLARE)
#undef BOXREEL_DECLARE
};

/// Loads the libraries, once per process. An Error (Absent) names the missing library and its
/// package. Disables libav's own messages unless the program has set a level.
Result<void> LoadFFmpeg();

/// Returns the function table. LoadFFmpeg must have succeeded.
const FFmpegLibrary& FFmpeg();

/// Returns libav's description of an error code.
std::string FFmpegText(int status);

struct FFmpegDelete
{
    void operator()(AVFrame* frame) const;
    void operator()(AVPacket* packet) const;
    void operator()(AVCodecContext* context) const;
    void operator()(AVCodecParameters* parameters) const;
    void operator()(SwsContext* context) const;
    void operator()(AVIOContext* context) const; ///< Frees the context and its buffer, not the
                                                 ///< underlying file.
};

template <class T>
using FFmpegOwner = std::unique_ptr<T, FFmpegDelete>;

} // namespace boxreel
