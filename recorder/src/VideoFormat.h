// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/VideoWriter.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Selects the format by name, with its limits. Independent of libav, so that invalid requests are
/// refused before anything is loaded or simulated.
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

/// True for the name of the standard output.
bool IsPipe(const std::filesystem::path& path);

std::optional<VideoFormat> FormatOf(const std::filesystem::path& path,
                                    const VideoSettings& settings);

/// True if libav writes it.
bool IsOfLibav(VideoFormat format);

/// True if a film of this format can be resumed and joined.
bool HasParts(VideoFormat format);

/// True if decoding and encoding again is lossless; such films are resumed and joined that way.
bool IsAnimation(VideoFormat format);

/// True if every frame is stored.
bool IsConstant(FrameTiming timing, VideoFormat format);

/// Returns n if a GIF keeps every n-th frame. Its delays are whole centiseconds, and players slow
/// down delays below two.
std::int64_t GifFrameStep(const Rational& framesPerSecond);

/// Returns the start of frame k of a GIF, rounded from the exact time, so that errors do not add up
/// [1/100 s].
std::int64_t GifTimeOfFrame(std::int64_t frame, const Rational& framesPerSecond);

} // namespace boxreel
