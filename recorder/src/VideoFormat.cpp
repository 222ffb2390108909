// SPDX-License-Identifier: MIT
#include "VideoFormat.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace boxreel
{

namespace
{

constexpr int kMaxSize = 8192;      // the renderer's limit; every format here can hold it [px]
constexpr int kMaxRate = 1000;      // more frames a second than Matroska's clock can tell apart
constexpr int kMaxThreads = 64;     // what libvpx takes
constexpr int kGifCentiseconds = 2; // the shortest delay that browsers honour

std::string LowerExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

/// Presets by measured cost per 720p frame: ultrafast 2.7 ms, veryfast 7.5, medium 15. Lossless
/// keeps RGB: any YUV of 8 bits would round. No macroblock tree: with it and more than one thread,
/// one run in some hundred gives another film (5 of 1500 runs of a small one; none of 3000
/// without). On drawings it saves nothing: at equal error the size is the same within a twentieth,
/// about three steps of crf higher.
void PlanH264(EncoderPlan& plan, Quality quality)
{
    plan.encoder = "libx264";
    plan.pixelFormat = "yuv420p";
    switch (quality)
    {
    case Quality::Draft:
        plan.codecOptions = {{"preset", "ultrafast"}, {"crf", "28"}};
        break;
    case Quality::Standard:
        plan.codecOptions = {{"preset", "veryfast"}, {"crf", "22"}, {"mbtree", "0"}};
        break;
    case Quality::High:
        plan.codecOptions = {{"preset", "medium"}, {"crf", "16"}, {"mbtree", "0"}};
        break;
    case Quality::Lossless:
        plan.encoder = "libx264rgb";
        plan.pixelFormat = "bgr0";
        plan.codecOptions = {{"preset", "veryfast"}, {"qp", "0"}};
        break;
    }
}

/// "realtime" is the name of a faster search: on drawings at 720p it takes a quarter of the time of
/// "good" for a tenth more bytes at equal error.
void PlanVp9(EncoderPlan& plan, Quality quality)
{
    plan.encoder = "libvpx-vp9";
    plan.pixelFormat = "yuv420p";
    plan.codecOptions = {{"row-mt", "1"}, {"tile-columns", "1"}, {"b", "0"}};
    const auto add = [&](const char* name, const char* value) {
        plan.codecOptions.emplace_back(name, value);
    };
    switch (quality)
    {
    case Quality::Draft:
        add("deadline", "realtime");
        add("cpu-used", "8");
        add("crf", "40");
        break;
    case Quality::Standard:
        add("deadline", "realtime");
        add("cpu-used", "5");
        add("crf", "28");
        break;
    case Quality::High:
        add("cpu-used", "4");
        add("crf", "12");
        break;
    case Quality::Lossless:
        plan.pixelFormat = "gbrp";
        add("deadline", "realtime");
        add("cpu-used", "5");
        add("lossless", "1");
        break;
    }
}

Error UnknownName(const std::filesystem::path& path)
{
    const std::string formats = "use .mp4, .mkv, .webm, .gif or a name like frames-####.png";
    if (LowerExtension(path) == ".png")
    {
        return Error{ErrorKind::Unusable, path.string() +
                                              " is the name of one picture; a film as pictures has "
                                              "a place for the number, like frames-####.png."};
    }
    if (!path.has_filename())
    {
        return Error{ErrorKind::Unusable, path.string() + (path.empty() ? "An empty name" : "") +
                                              " names no file; " + formats + "."};
    }
    const std::string extension = path.extension().string();
    return Error{ErrorKind::Unusable,
                 path.string() + " does not say which kind of film to write (" +
                     (extension.empty() ? "no extension" : "unknown extension " + extension) +
                     "); " + formats + "."};
}

std::string SizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

Result<void> CheckSize(VideoFormat format, const VideoSettings& settings)
{
    const int w = settings.width;
    const int h = settings.height;
    if (w < 1 || h < 1 || w > kMaxSize || h > kMaxSize)
    {
        return Error{ErrorKind::Unusable, "A film of " + SizeText(w, h) +
                                              " cannot be made; both sides must lie "
                                              "between 1 and " +
                                              std::to_string(kMaxSize) + " pixels."};
    }
    const bool isYuv = format != VideoFormat::PngSequence &&
                       std::string(PlanFor(format, settings.quality).pixelFormat) == "yuv420p";
    if (isYuv && (w % 2 != 0 || h % 2 != 0))
    {
        const std::string codec = format == VideoFormat::WebM ? "VP9" : "H.264";
        return Error{ErrorKind::Unusable,
                     SizeText(w, h) + " is odd, and " + codec +
                         " halves the resolution of colours, so it needs even sizes; use " +
                         SizeText(w + w % 2, h + h % 2) +
                         ", or --quality lossless, .gif or frames-####.png."};
    }
    return {};
}

} // namespace

std::optional<VideoFormat> FormatOf(const std::filesystem::path& path)
{
    const std::string extension = LowerExtension(path);
    if (path.stem().empty())
    {
        return std::nullopt;
    }
    if (extension == ".mp4")
    {
        return VideoFormat::Mp4;
    }
    if (extension == ".mkv")
    {
        return VideoFormat::Matroska;
    }
    if (extension == ".webm")
    {
        return VideoFormat::WebM;
    }
    if (extension == ".gif")
    {
        return VideoFormat::Gif;
    }
    if (extension == ".png" && ParseSequenceName(path))
    {
        return VideoFormat::PngSequence;
    }
    return std::nullopt;
}

EncoderPlan PlanFor(VideoFormat format, Quality quality)
{
    assert(format != VideoFormat::PngSequence && "pictures are not made by libav");
    EncoderPlan plan;
    switch (format)
    {
    case VideoFormat::Mp4:
        plan.muxer = "mp4";
        plan.muxerOptions = {{"movflags", "+faststart"}}; // plays in a browser before it is loaded
        PlanH264(plan, quality);
        break;
    case VideoFormat::Matroska:
        plan.muxer = "matroska";
        PlanH264(plan, quality);
        if (quality == Quality::Lossless)
        {
            plan.encoder = "ffv1";
            plan.pixelFormat = "bgr0";
            // A fixed number of slices, or the bytes would depend on the threads; the sums let a
            // reader see damage.
            plan.codecOptions = {{"level", "3"}, {"slices", "4"}, {"slicecrc", "1"}};
        }
        break;
    case VideoFormat::WebM:
        plan.muxer = "webm";
        PlanVp9(plan, quality);
        break;
    case VideoFormat::Gif:
        plan.muxer = "gif";
        plan.encoder = "gif";
        plan.pixelFormat = "pal8";
        break;
    case VideoFormat::PngSequence:
        break;
    }
    return plan;
}

std::int64_t GifFrameStep(const Rational& framesPerSecond)
{
    const std::int64_t shortest = framesPerSecond.num * kGifCentiseconds;
    const std::int64_t frame = framesPerSecond.den * 100;
    return (shortest + frame - 1) / frame;
}

std::int64_t GifTimeOfFrame(std::int64_t frame, const Rational& framesPerSecond)
{
    __extension__ typedef __int128 Wide;
    const Wide doubled = Wide(frame) * 200 * framesPerSecond.den + framesPerSecond.num;
    return std::int64_t(doubled / (Wide(framesPerSecond.num) * 2));
}

std::filesystem::path SequenceName::PathOf(std::int64_t number) const
{
    std::string text = std::to_string(number);
    if (text.size() < std::size_t(digits))
    {
        text.insert(0, std::size_t(digits) - text.size(), '0');
    }
    return folder / (before + text + after);
}

std::optional<std::int64_t> SequenceName::NumberIn(const std::string& name) const
{
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
        !name.ends_with(after))
    {
        return std::nullopt;
    }
    const std::string text = name.substr(before.size(), name.size() - before.size() - after.size());
    if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    {
        return std::nullopt;
    }
    const std::int64_t number = std::stoll(text);
    return PathOf(number).filename() == name ? std::optional(number) : std::nullopt;
}

std::optional<SequenceName> ParseSequenceName(const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    const std::size_t last = name.find_last_of('#');
    if (last == std::string::npos)
    {
        return std::nullopt;
    }
    std::size_t first = last;
    while (first > 0 && name[first - 1] == '#')
    {
        --first;
    }
    return SequenceName{path.parent_path(), name.substr(0, first), name.substr(last + 1),
                        int(last - first + 1)};
}

Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings)
{
    const std::optional<VideoFormat> format = FormatOf(path);
    if (!format)
    {
        return UnknownName(path);
    }
    if (*format == VideoFormat::PngSequence && ParseSequenceName(path)->digits > 9)
    {
        return Error{ErrorKind::Unusable,
                     path.string() + " has more than nine #; no film is that long."};
    }
    if (settings.threads < 0 || settings.threads > kMaxThreads)
    {
        return Error{ErrorKind::Unusable,
                     std::to_string(settings.threads) +
                         " threads cannot encode a film; use 0 (two threads) to " +
                         std::to_string(kMaxThreads) + "."};
    }
    const Rational& rate = settings.framesPerSecond;
    if (rate.num < 1 || rate.den < 1 || rate.num > rate.den * kMaxRate)
    {
        return Error{ErrorKind::Unusable,
                     std::to_string(rate.num) + "/" + std::to_string(rate.den) +
                         " frames a second cannot be stored; use more than 0 and at most " +
                         std::to_string(kMaxRate) + "."};
    }
    return CheckSize(*format, settings);
}

Rational StoredFrameRate(const std::filesystem::path& path, const Rational& framesPerSecond)
{
    if (FormatOf(path) != VideoFormat::Gif)
    {
        return framesPerSecond;
    }
    const std::int64_t den = framesPerSecond.den * GifFrameStep(framesPerSecond);
    const std::int64_t divisor = std::gcd(framesPerSecond.num, den);
    return Rational{framesPerSecond.num / divisor, den / divisor};
}

} // namespace boxreel
