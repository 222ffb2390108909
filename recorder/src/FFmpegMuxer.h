// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegOutput.h"
#include "VideoPlan.h"

#include <memory>
#include <string>

/// Writes packets to a file with libav's muxer, independent of encoders. The packets are new or
/// copied from other films.
namespace boxreel
{

/// The header's description of the only stream.
struct MuxerStream
{
    const AVCodecParameters* codec = nullptr;
    AVRational tick{1, 60};            ///< time unit of the packets [s]
    AVRational framesPerSecond{60, 1}; ///< shown by players
};

class FFmpegMuxer
{
public:
    /// Writes the header. `output` must outlive it; `film`: for messages.
    static Result<FFmpegMuxer> Open(FFmpegOutput& output, const std::string& muxer,
                                    const Options& options, const MuxerStream& stream,
                                    const std::string& film);
    FFmpegMuxer(FFmpegMuxer&&) noexcept = default;
    FFmpegMuxer& operator=(FFmpegMuxer&&) noexcept = default;
    ~FFmpegMuxer();

    /// Writes a packet with times in ticks; the packet is empty afterwards.
    Result<void> Write(AVPacket& packet);

    /// Writes buffered packets and the index. The object cannot be used afterwards.
    Result<void> Finish();

    /// Sets the duration of the last frame of an animated PNG [ticks]; call before Finish.
    void SetFinalDelay(std::int64_t ticks);

private:
    struct ContextDelete
    {
        void operator()(AVFormatContext* context) const { FFmpeg().avformat_free_context(context); }
    };

    explicit FFmpegMuxer(FFmpegOutput& output) : m_output(&output) {}
    Result<void> WriteHeader(const Options& options);
    Error WriteError(int status) const;

    FFmpegOutput* m_output;
    std::string m_film;
    std::unique_ptr<AVFormatContext, ContextDelete> m_context;
    AVStream* m_stream = nullptr; // owned by the context
    AVRational m_tick{1, 60};
    bool m_isTrailerDue = false; // the header is written
};

} // namespace boxreel
