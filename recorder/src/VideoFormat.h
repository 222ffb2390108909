// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/VideoWriter.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Which format a name asks for, and what it can hold. No libav, so that a wrong request is refused
/// before anything is loaded or simulated.
namespace boxreel
{

enum class VideoFormat
{
    Mp4,
    Matroska,
    WebM,
    Gif,
    Apng,
    WebP,
    Y4m,
    Nut,
    PngSequence,
};

/// The name that stands for the standard output.
bool IsPipe(const std::filesystem::path& path);

std::optional<VideoFormat> FormatOf(const std::filesystem::path& path,
                                    const VideoSettings& settings);

/// Whether libav writes it.
bool IsOfLibav(VideoFormat format);

/// Whether a film of this format may be kept unfinished and continued, and be a part of another.
bool HasParts(VideoFormat format);

/// Whether frames come back from it as they were written, so that such a film is continued and
/// joined by writing them once more.
bool IsAnimation(VideoFormat format);

/// A GIF keeps every n-th frame: its delays are whole centiseconds and players slow anything below
/// two down.
std::int64_t GifFrameStep(const Rational& framesPerSecond);

/// When frame k of a GIF begins, rounded from the exact time, so that no error adds up [1/100 s].
std::int64_t GifTimeOfFrame(std::int64_t frame, const Rational& framesPerSecond);

} // namespace boxreel
