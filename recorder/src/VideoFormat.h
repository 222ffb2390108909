// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/VideoWriter.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Which format a name asks for, and how each is made at each quality: one table, no libav, so that
/// a wrong request is refused before anything is loaded or simulated.
namespace boxreel
{

enum class VideoFormat
{
    Mp4,
    Matroska,
    WebM,
    Gif,
    PngSequence,
};

using Options = std::vector<std::pair<const char*, const char*>>;

/// How libav is asked for a film. The names are libav's own.
struct EncoderPlan
{
    const char* muxer = "";
    const char* encoder = "";
    const char* pixelFormat = "";
    Options codecOptions;
    Options muxerOptions;
};

std::optional<VideoFormat> FormatOf(const std::filesystem::path& path);

/// For every format but PngSequence.
EncoderPlan PlanFor(VideoFormat format, Quality quality);

/// A GIF keeps every n-th frame: its delays are whole centiseconds and players slow anything below
/// two down.
std::int64_t GifFrameStep(const Rational& framesPerSecond);

/// When frame k of a GIF begins, rounded from the exact time, so that no error adds up [1/100 s].
std::int64_t GifTimeOfFrame(std::int64_t frame, const Rational& framesPerSecond);

/// "frames-####.png" taken apart.
struct SequenceName
{
    std::filesystem::path folder;
    std::string before;
    std::string after;
    int digits = 0;

    /// The path of picture `number`; a number with more digits than # is written out.
    std::filesystem::path PathOf(std::int64_t number) const;
    /// The number in a name of this sequence, as PathOf would write it.
    std::optional<std::int64_t> NumberIn(const std::string& name) const;
};

/// Nothing when the name has no #. The last run of # is the number's place.
std::optional<SequenceName> ParseSequenceName(const std::filesystem::path& path);

} // namespace boxreel
