// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/FrameClock.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>

/// Frames into a film: Open, Append each, Close. The format follows from the name: .mp4 (H.264),
/// .mkv (FFV1 when lossless, else H.264), .webm (VP9), .gif, or a PNG sequence for a name with
/// ####. The film is written as NAME.part.EXT in the same folder and renamed by Close; a writer
/// that is destroyed before Close removes what it wrote. libav is loaded by Open, not before, and
/// not at all for pictures. Same frames and settings, same bytes, on any machine with the same
/// libraries.
///
/// - Films have no transparency: the frame's premultiplied colours are taken as they are, so what
/// is
///   see-through lies on black.
/// - H.264 and VP9 store YUV 4:2:0, matrix, primaries and transfer bt709, limited range, and say
/// so. The
///   transfer is tagged bt709 although frames are sRGB: it is what players expect of HD and show
///   unchanged, while the sRGB tag makes some of them convert or give up their fast path.
/// - Lossless stores RGB: .mkv FFV1, .mp4 H.264 of the profile High 4:4:4 Predictive (mpv, VLC and
/// ffmpeg
///   play it, browsers do not), .webm VP9 4:4:4, .gif when no frame has more than 256 colours.
/// - A GIF's palette holds a frame's colours exactly when they are at most 256, otherwise those
/// that matter
///   most; no dither. It stores times in 1/100 s: each is rounded by itself and never drifts.
///   Frames shorter than 1/50 s are not shown by browsers, so above 50 frames a second every n-th
///   frame is kept (StoredFrameRate says what is left: 60 becomes 30).
/// - Matroska and WebM store times in 1/1000 s, rounded in the same way; MP4 stores them exactly.
/// - Pictures are numbered from 0, with as many digits as there are # (more when the number needs
/// them), and
///   each is there whole or not at all.
namespace boxreel
{

enum class Quality
{
    Draft,    ///< fastest to encode
    Standard, ///< lines look clean, files are small
    High,     ///< hard to tell from the frames
    Lossless, ///< every pixel survives; a format that cannot is an Error
};

struct VideoSettings
{
    int width = 1280;                ///< 1 to 8192, even for H.264 and VP9 below Lossless [px]
    int height = 720;                ///< likewise [px]
    Rational framesPerSecond{60, 1}; ///< at most 1000
    Quality quality = Quality::Standard;
    int threads = 0; ///< of the encoder, at most 64; 0: two. H.264's bytes depend on it, the film's
                     ///< look does not.
    bool overwrite = false; ///< false: an existing file is an Error
};

/// Whether `path` names a format that can be written with these settings, without opening anything:
/// unknown extension, a size the format cannot hold (with the nearest that it can).
Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings);

/// How many frames a second the film at `path` will hold: as asked, but for a GIF above 50.
Rational StoredFrameRate(const std::filesystem::path& path, const Rational& framesPerSecond);

class VideoWriter
{
public:
    static Result<VideoWriter> Open(const std::filesystem::path& path,
                                    const VideoSettings& settings);
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;
    ~VideoWriter();

    /// The frame's size must be that of the settings. Its time is its number / framesPerSecond.
    /// After an Error nothing more can be appended.
    Result<void> Append(const Frame& frame);

    /// The last frame once more, without converting it again.
    Result<void> Repeat();

    /// Flushes the encoder, syncs, gives the file its name. Nothing may follow.
    Result<void> Close();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
