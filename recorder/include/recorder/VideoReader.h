// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/FrameClock.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>
#include <string>

/// @file
/// A film (mp4, mkv, webm, gif, apng, webp, nut, y4m, …) or a sequence of pictures back into
/// frames, for tests and golden comparisons. Colours are converted by the film's own tags. libav is
/// loaded by Open, not before.
namespace boxreel
{

/// What a film's file says of it.
struct VideoInfo
{
    int width = 0;              ///< of its pictures [px]
    int height = 0;             ///< of its pictures [px]
    Rational framesPerSecond;   ///< of what is shown; fewer may be stored
    std::string container;      ///< libav's name, e.g. "mov,mp4,m4a,3gp,3g2,mj2"
    std::string codec;          ///< "h264", "ffv1", "vp9", "gif", …
    std::string pixelFormat;    ///< "yuv420p", …
    std::string colorSpace;     ///< "bt709", …; likewise the three below
    std::string colorPrimaries; ///< "bt709", …
    std::string colorTransfer;  ///< "bt709", …
    std::string colorRange;     ///< "tv", …
};

/// Which frames of a film are given.
enum class Frames
{
    Shown,  ///< one for each period of framesPerSecond: one that is held for long comes several
            ///< times
    Stored, ///< each once; of a .webp always so, for it does not say its rate
};

/// A film's frames, in their order.
class VideoReader
{
public:
    /// Opens a film; an Error when the file is not there or is no film, or libav is absent.
    static Result<VideoReader> Open(const std::filesystem::path& path,
                                    Frames frames = Frames::Shown);
    /// The other may only be assigned to or destroyed.
    VideoReader(VideoReader&&) noexcept;
    /// The other may only be assigned to or destroyed.
    VideoReader& operator=(VideoReader&&) noexcept;
    ~VideoReader();

    /// What the file says.
    const VideoInfo& Info() const;

    /// Reads the next frame and, when asked, its time [s]; false after the last. An Error when what
    /// follows in the file is damaged or cannot be read.
    Result<bool> Next(Frame& frame, double* seconds = nullptr);

private:
    struct Impl;
    explicit VideoReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
