// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/FrameClock.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>
#include <string>

/// @file
/// Reads the frames of a film (mp4, mkv, webm, gif, apng, webp, nut, y4m, …) or of a picture
/// sequence. For tests and golden comparisons. Colours are converted by the tags of the film. Open
/// loads libav.
namespace boxreel
{

/// Metadata of a film.
struct VideoInfo
{
    int width = 0;              ///< width of the frames [px]
    int height = 0;             ///< height of the frames [px]
    Rational framesPerSecond;   ///< rate of the shown frames; fewer may be stored
    std::string container;      ///< libav's name, e.g. "mov,mp4,m4a,3gp,3g2,mj2"
    std::string codec;          ///< "h264", "ffv1", "vp9", "gif", …
    std::string pixelFormat;    ///< "yuv420p", …
    std::string colorSpace;     ///< "bt709", …; also the three below
    std::string colorPrimaries; ///< "bt709", …
    std::string colorTransfer;  ///< "bt709", …
    std::string colorRange;     ///< "tv", …
};

/// The frames that a reader returns.
enum class Frames
{
    Shown,  ///< one per period of framesPerSecond: longer frames are repeated
    Stored, ///< each once; always so for .webp, which does not store its rate
};

/// Reads the frames of a film in order.
class VideoReader
{
public:
    /// Opens a film. An Error when the file does not exist or is not a film, or libav is missing.
    static Result<VideoReader> Open(const std::filesystem::path& path,
                                    Frames frames = Frames::Shown);
    /// Leaves the source in a moved-from state.
    VideoReader(VideoReader&&) noexcept;
    /// Leaves the source in a moved-from state.
    VideoReader& operator=(VideoReader&&) noexcept;
    ~VideoReader();

    /// Returns the metadata.
    const VideoInfo& Info() const;

    /// Reads the next frame and, if requested, its time [s]; false after the last. An Error when
    /// the file is damaged or cannot be read.
    Result<bool> Next(Frame& frame, double* seconds = nullptr);

private:
    struct Impl;
    explicit VideoReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
