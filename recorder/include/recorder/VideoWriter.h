// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/FrameClock.h>
#include <render/Frame.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

/// Frames into a film: Open, Append each, Close. The format follows from the name: .mp4 (H.264), .mkv
/// (FFV1 when lossless, else H.264), .webm (VP9), .gif, or a PNG sequence for a name with ####.
/// The film is written as NAME.part.EXT in the same folder and renamed by Close; a writer that is
/// destroyed before Close removes what it wrote. libav is loaded by Open, not before.
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
    int width = 1280; ///< [px]
    int height = 720; ///< [px]
    Rational framesPerSecond{60, 1};
    Quality quality = Quality::Standard;
    int threads = 0;        ///< of the encoder; 0: chosen by it
    bool overwrite = false; ///< false: an existing file is an Error
};

/// Whether `path` names a format that can be written with these settings, without opening anything:
/// unknown extension, a size the format cannot hold (with the nearest that it can).
Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings);

class VideoWriter
{
public:
    static Result<VideoWriter> Open(const std::filesystem::path& path, const VideoSettings& settings);
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;
    ~VideoWriter();

    /// The frame's size must be that of the settings. Its time is its number / framesPerSecond.
    Result<void> Append(const Frame& frame);

    /// Flushes the encoder, syncs, gives the file its name. Nothing may follow.
    Result<void> Close();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
