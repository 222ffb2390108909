// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"
#include "FFmpegPackets.h"
#include "H264Repeat.h"
#include "VideoPlan.h"

#include <cstdint>
#include <deque>
#include <optional>

/// Packets of frames that equal the one before, at almost no cost: the encoder does not see such
/// frames. H.264 has slices that skip everything, VP9 shows a stored picture again, and a packet of
/// FFV1 is written twice. Used by FFmpegFilm for films with a constant rate.
namespace boxreel
{

class FFmpegRepeat
{
public:
    /// None if frames of this film must be encoded each. `parameters` become those of the film.
    static std::optional<FFmpegRepeat> Create(const EncoderPlan& plan,
                                              AVCodecParameters& parameters);

    /// Adds frame `index`, which equals frame `shown`. The encoder has received that one as its
    /// last, with a type that no later frame refers across.
    void Add(std::int64_t index, std::int64_t shown) { m_waiting.push_back({index, shown}); }

    /// Takes the next packet of the encoder; null at its end. Returns packets of the film: repeated
    /// frames in front of it whose turn has come, and the packet. An Error (Failed) if the packet
    /// cannot be read.
    Result<Packets> Pass(FFmpegOwner<AVPacket> packet);

private:
    enum class Kind
    {
        H264,
        Vp9,
        Intra,
    };
    struct Waiting
    {
        std::int64_t index = 0;
        std::int64_t shown = 0;
    };

    FFmpegRepeat(Kind kind, int profile) : m_kind(kind), m_profile(profile) {}
    Result<FFmpegOwner<AVPacket>> Make(const Waiting& waiting) const;
    Result<FFmpegOwner<AVPacket>> Note(FFmpegOwner<AVPacket> packet);

    Kind m_kind;
    int m_profile = 0; // of VP9
    std::optional<H264Repeat> m_h264;
    std::optional<int> m_slot;      // of VP9: the place of the shown picture in the decoder
    FFmpegOwner<AVPacket> m_packet; // of FFV1: the last one
    std::deque<Waiting> m_waiting;
};

} // namespace boxreel
