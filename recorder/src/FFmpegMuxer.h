// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegOutput.h"
#include "VideoPlan.h"

#include <memory>
#include <string>

/// Packets into a file: libav's muxer, which knows nothing of encoders. Used by whatever makes
/// films of packets, fresh ones or those of other films.
namespace boxreel
{

/// What the file's header says of its one stream.
struct MuxerStream
{
    const AVCodecParameters* codec = nullptr;
    AVRational tick{1, 60};            ///< the unit of the packets' times [s]
    AVRational framesPerSecond{60, 1}; ///< as a player may show it
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

    /// Times in ticks; the packet is empty afterwards.
    Result<void> Write(AVPacket& packet);

    /// Writes what the muxer still holds, and its index. Nothing may follow.
    Result<void> Finish();

    /// How long the last frame of an animated PNG stays [ticks]; before Finish.
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
    AVStream* m_stream = nullptr; // the context's
    AVRational m_tick{1, 60};
    bool m_isTrailerDue = false; // the header is written
};

} // namespace boxreel
