// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/VideoReader.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>
#include <string>

/// What a VideoReader takes its frames from: one implementation per way of storing them.
namespace boxreel
{

struct StoredFrame
{
    Frame frame;
    double seconds = 0.0; ///< when it is shown [s]
    double length = 0.0;  ///< for how long; 0: not known, until the next or for one period [s]
};

class VideoSource
{
public:
    virtual ~VideoSource() = default;

    virtual Result<bool> Next(StoredFrame& stored) = 0; ///< false after the last

    VideoInfo info;
};

/// Of pictures that are stored as they are, in RGB.
VideoInfo RgbInfo(int width, int height, const Rational& framesPerSecond,
                  const std::string& container, const std::string& codec);

/// By the name's end. An Error when it is not there or no film.
Result<std::unique_ptr<VideoSource>> OpenVideoSource(const std::filesystem::path& path);

} // namespace boxreel
