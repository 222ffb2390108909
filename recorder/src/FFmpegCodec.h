// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"
#include "VideoPlan.h"

#include <string>

/// One run of libav's encoder: pictures in, packets out. Used by FFmpegFilm, which starts one for
/// each group of frames.
namespace boxreel
{

class FFmpegCodec
{
public:
    /// `film`: for messages. An Error (Absent) when libav has no such encoder, (Unusable) when the
    /// encoder does not know an option, or will not have its value.
    static Result<FFmpegCodec> Open(const EncoderPlan& plan, const VideoSettings& settings,
                                    const std::string& film);

    const AVCodecContext& Context() const { return *m_context; }

    /// What a container has to know of such an encoder before its first packet.
    Result<FFmpegOwner<AVCodecParameters>> MakeParameters(const EncoderPlan& plan,
                                                          const VideoSettings& settings,
                                                          const std::string& film) const;

    /// An empty picture of this codec's size, format and colours.
    Result<FFmpegOwner<AVFrame>> MakePicture() const;

    /// None ends the run. libav's status.
    int Send(const AVFrame* picture);

    /// libav's status: AVERROR(EAGAIN) until more is sent, AVERROR_EOF after the last.
    int Receive(AVPacket& packet);

private:
    explicit FFmpegCodec(FFmpegOwner<AVCodecContext> context) : m_context(std::move(context)) {}
    Result<FFmpegOwner<AVPacket>> EncodeBlack();

    FFmpegOwner<AVCodecContext> m_context;
};

/// The unit of a film's times: a frame.
AVRational TickOf(const Rational& framesPerSecond);

} // namespace boxreel
