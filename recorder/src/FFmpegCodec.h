// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"
#include "VideoPlan.h"

#include <string>

/// One run of libav's encoder: pictures in, packets out. FFmpegFilm starts one for each group of
/// frames.
namespace boxreel
{

class FFmpegCodec
{
public:
    /// Opens the encoder. `film`: for messages. An Error (Absent) when libav does not have it,
    /// (Unusable) for an unknown option or an invalid value.
    static Result<FFmpegCodec> Open(const EncoderPlan& plan, const VideoSettings& settings,
                                    const std::string& film);

    const AVCodecContext& Context() const { return *m_context; }

    /// Returns the parameters that a container needs before the first packet.
    Result<FFmpegOwner<AVCodecParameters>> MakeParameters(const EncoderPlan& plan,
                                                          const VideoSettings& settings,
                                                          const std::string& film) const;

    /// Returns an empty picture with this codec's size, format and colours.
    Result<FFmpegOwner<AVFrame>> MakePicture() const;

    /// Sends a picture; null ends the run. Returns libav's status.
    int Send(const AVFrame* picture);

    /// Receives a packet. Returns libav's status: AVERROR(EAGAIN) if more input is needed,
    /// AVERROR_EOF after the last.
    int Receive(AVPacket& packet);

private:
    explicit FFmpegCodec(FFmpegOwner<AVCodecContext> context) : m_context(std::move(context)) {}
    Result<FFmpegOwner<AVPacket>> EncodeBlack();

    FFmpegOwner<AVCodecContext> m_context;
};

/// Returns the time unit of a film: one frame.
AVRational TickOf(const Rational& framesPerSecond);

} // namespace boxreel
