// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/FrameClock.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>
#include <string>

/// A film (mp4, mkv, webm, gif, apng, webp, nut, y4m, …) or a sequence of pictures back into
/// frames, for tests and golden comparisons. Colours are converted by the film's own tags. libav is
/// loaded by Open, not before.
namespace boxreel
{

struct VideoInfo
{
    int width = 0;
    int height = 0;
    Rational framesPerSecond; ///< of what is shown; fewer may be stored
    std::string container;    ///< libav's name, e.g. "mov,mp4,m4a,3gp,3g2,mj2"
    std::string codec;        ///< "h264", "ffv1", "vp9", "gif", …
    std::string pixelFormat;  ///< "yuv420p", …
    std::string colorSpace;   ///< "bt709", …; likewise the three below
    std::string colorPrimaries;
    std::string colorTransfer;
    std::string colorRange;
};

/// Which frames of a film are given.
enum class Frames
{
    Shown,  ///< one for each period of framesPerSecond: one that is held for long comes several
            ///< times
    Stored, ///< each once; of a .webp always so, for it does not say its rate
};

class VideoReader
{
public:
    static Result<VideoReader> Open(const std::filesystem::path& path,
                                    Frames frames = Frames::Shown);
    VideoReader(VideoReader&&) noexcept;
    VideoReader& operator=(VideoReader&&) noexcept;
    ~VideoReader();

    const VideoInfo& Info() const;

    /// The next frame and, when asked, its time [s]; false after the last.
    Result<bool> Next(Frame& frame, double* seconds = nullptr);

private:
    struct Impl;
    explicit VideoReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
