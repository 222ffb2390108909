// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/VideoReader.h>
#include <render/Frame.h>

#include <filesystem>
#include <memory>
#include <string>

/// The input of a VideoReader: one implementation per kind of storage.
namespace boxreel
{

struct StoredFrame
{
    Frame frame;
    double seconds = 0.0; ///< start [s]
    double length = 0.0;  ///< duration; 0: unknown, until the next frame or one period [s]
};

class VideoSource
{
public:
    virtual ~VideoSource() = default;

    virtual Result<bool> Next(StoredFrame& stored) = 0; ///< false after the last

    VideoInfo info;
};

/// Returns the metadata of pictures stored in RGB.
VideoInfo RgbInfo(int width, int height, const Rational& framesPerSecond,
                  const std::string& container, const std::string& codec);

/// Opens a source by its extension. An Error when the file does not exist or is not a film.
Result<std::unique_ptr<VideoSource>> OpenVideoSource(const std::filesystem::path& path);

} // namespace boxreel
