// SPDX-License-Identifier: MIT
#include "VideoFormat.h"
#include "SequenceName.h"
#include "SettingTexts.h"
#include "VideoPlan.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Words.h>

#include <cassert>
#include <numeric>

namespace boxreel
{

namespace
{

constexpr int kMaxSize = 8192;      // the renderer's limit; every format supports it [px]
constexpr int kMaxRate = 1000;      // resolution of Matroska's clock
constexpr int kMaxThreads = 64;     // limit of libvpx
constexpr int kMaxPlays = 65535;    // limit of the formats
constexpr int kGifCentiseconds = 2; // shortest delay that browsers respect

struct Extension
{
    const char* text;
    VideoFormat format;
};

constexpr Extension kExtensions[] = {
    {".mp4", VideoFormat::Mp4}, {".mkv", VideoFormat::Matroska}, {".webm", VideoFormat::WebM},
    {".gif", VideoFormat::Gif}, {".apng", VideoFormat::Apng},    {".webp", VideoFormat::WebP},
    {".y4m", VideoFormat::Y4m}, {".nut", VideoFormat::Nut},
};

std::optional<VideoFormat> FormatOfExtension(const std::string& extension)
{
    for (const Extension& known : kExtensions)
    {
        if (extension == known.text)
        {
            return known.format;
        }
    }
    return std::nullopt;
}

/// True if the format can be written and read sequentially.
bool CanBePiped(VideoFormat format)
{
    return format == VideoFormat::Y4m || format == VideoFormat::Nut ||
           format == VideoFormat::Matroska || format == VideoFormat::WebM;
}

std::string LowerExtension(const std::filesystem::path& path)
{
    return Lower(path.extension().string());
}

ErrorText FormatText(const VideoSettings& settings)
{
    return settings.format.empty() ? ErrorSetting{kFormat}
                                   : ErrorSetting{kFormat, {settings.format}};
}

Error UnknownName(const std::filesystem::path& path, const VideoSettings& settings)
{
    const std::string formats =
        "use " + JoinedBy(", ", VideoEnds()) + " or a name like frames-####.png";
    const auto unusable = [&](const std::string& problem, const std::string& remedy) {
        return Error{ErrorKind::Unusable, path.empty() ? "''" : path.string(), problem, remedy};
    };
    if (IsPipe(path))
    {
        return Error{ErrorKind::Unusable, FormatText(settings),
                     settings.format.empty() ? "is required for standard output"
                                             : "cannot be written to standard output",
                     "give " + ErrorSetting{kFormat} + " y4m, nut, mkv or webm"};
    }
    if (LowerExtension(path) == ".png")
    {
        return unusable("names a single picture",
                        "use a name with a number, such as frames-####.png");
    }
    if (!path.has_filename())
    {
        return unusable("is not a file name", formats);
    }
    const std::string extension = path.extension().string();
    return unusable(extension.empty() ? "has no extension" : "unsupported extension " + extension,
                    DidYouMean(extension, VideoEnds(), formats));
}

ErrorText SizeText(int width, int height)
{
    return ErrorSetting{kSize, {std::to_string(width), std::to_string(height)}};
}

Result<void> CheckSize(const VideoSettings& settings)
{
    const int w = settings.width;
    const int h = settings.height;
    if (w < 1 || h < 1 || w > kMaxSize || h > kMaxSize)
    {
        return Error{ErrorKind::Unusable, SizeText(w, h),
                     "width and height must be between 1 and " + std::to_string(kMaxSize)};
    }
    return {};
}

/// Checks the size for subsampled chroma.
Result<void> CheckEvenSize(VideoFormat format, const VideoSettings& settings)
{
    const int w = settings.width;
    const int h = settings.height;
    if (w % 2 == 0 && h % 2 == 0)
    {
        return {};
    }
    std::vector<ErrorText> others = {SizeText(w + w % 2, h + h % 2), kFullChroma};
    if (format == VideoFormat::Y4m) // y4m cannot be lossless
    {
        others.emplace_back("nut");
    }
    else
    {
        others.insert(others.end(), {kLossless, ".gif", "frames-####.png"});
    }
    return Error{ErrorKind::Unusable, SizeText(w, h), "must be even with 4:2:0 chroma",
                 "use " + ErrorText::AnyOf(others)};
}

Result<void> CheckRate(const Rational& rate)
{
    if (rate.num < 1 || rate.den < 1 || rate.num > rate.den * kMaxRate)
    {
        return Error{ErrorKind::Unusable,
                     ErrorSetting{BOXREEL_MEMBER(VideoSettings, framesPerSecond),
                                  {std::to_string(rate.num) + "/" + std::to_string(rate.den)}},
                     "must be above 0 and at most " + std::to_string(kMaxRate) +
                         " frames per second"};
    }
    return {};
}

Result<void> CheckNumbers(const VideoSettings& settings)
{
    if (settings.threads < 0 || settings.threads > kMaxThreads)
    {
        return Error{ErrorKind::Unusable,
                     ErrorSetting{BOXREEL_MEMBER(VideoSettings, threads),
                                  {std::to_string(settings.threads)}},
                     "must be between 0 (two threads) and " + std::to_string(kMaxThreads)};
    }
    if (settings.groupFrames < 0)
    {
        return Error{ErrorKind::Unusable,
                     ErrorSetting{BOXREEL_MEMBER(VideoSettings, groupFrames),
                                  {std::to_string(settings.groupFrames)}},
                     "must be at least 0"};
    }
    if (settings.plays < 0 || settings.plays > kMaxPlays)
    {
        return Error{ErrorKind::Unusable, ErrorSetting{kPlays, {std::to_string(settings.plays)}},
                     "must be between 0 (forever) and " + std::to_string(kMaxPlays)};
    }
    RETURN_IF_ERROR(CheckRate(settings.framesPerSecond));
    return CheckSize(settings);
}

/// Checks that no settings of a codec are given to a format without one. WebP has codec options.
Result<void> CheckCodecless(const std::filesystem::path& path, VideoFormat format,
                            const VideoSettings& settings)
{
    const std::pair<ErrorSetting, bool> given[] = {
        {{kCodec, {settings.codec}}, !settings.codec.empty()},
        {kFullChroma, settings.chroma != Chroma::Half},
        {{kCodecOptions}, format != VideoFormat::WebP && !settings.codecOptions.empty()}};
    for (const auto& [setting, isGiven] : given)
    {
        if (isGiven)
        {
            return Error{ErrorKind::Unusable, setting, "does not apply to " + path.string(),
                         "remove it"};
        }
    }
    return {};
}

/// Checks for settings that the format does not support.
Result<void> CheckFormat(const std::filesystem::path& path, VideoFormat format,
                         const VideoSettings& settings)
{
    if (settings.plays != 0 && !IsAnimation(format))
    {
        return Error{ErrorKind::Unusable, path.string(), "format has no loop count",
                     "remove " + ErrorSetting{kPlays} + ", or write .gif, .apng or .webp"};
    }
    const bool isWhole = IsPipe(path) || !HasParts(format);
    if (settings.resume && isWhole)
    {
        return Error{ErrorKind::Unusable, path.string(), "cannot be resumed",
                     "remove " + ErrorSetting{kResume} + ", or write another format"};
    }
    const bool storesAll =
        IsOfLibav(format) ? !HasParts(format) : format == VideoFormat::PngSequence;
    if (settings.timing == FrameTiming::Variable && storesAll)
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "has a constant frame rate, because the format stores every frame",
                     "remove " + kVariableRate + ", or write .mp4, .mkv or .webm"};
    }
    if (settings.timing == FrameTiming::Constant && format == VideoFormat::WebP)
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "cannot have a constant rate, because libwebp joins identical frames",
                     "remove " + ErrorText(ErrorSetting{kTiming, {"FrameTiming::Constant"}}) +
                         ", or write .apng"};
    }
    if (!IsOfLibav(format))
    {
        return CheckCodecless(path, format, settings);
    }
    ASSIGN_OR_RETURN(const EncoderPlan plan, PlanFor(format, settings));
    return plan.pixelFormat == "yuv420p" ? CheckEvenSize(format, settings) : Result<void>();
}

} // namespace

std::filesystem::path FileOfFrame(const std::filesystem::path& film, std::int64_t number)
{
    return FormatOf(film, {}) == VideoFormat::PngSequence ? ParseSequenceName(film)->PathOf(number)
                                                          : film;
}

std::vector<std::string> VideoEnds()
{
    std::vector<std::string> ends;
    for (const Extension& known : kExtensions)
    {
        ends.emplace_back(known.text);
    }
    return ends;
}

bool IsPipe(const std::filesystem::path& path)
{
    return path == "-";
}

std::optional<VideoFormat> FormatOf(const std::filesystem::path& path,
                                    const VideoSettings& settings)
{
    if (IsPipe(path))
    {
        const auto named = FormatOfExtension("." + settings.format);
        return named && CanBePiped(*named) ? named : std::nullopt;
    }
    const std::string extension = LowerExtension(path);
    if (path.stem().empty())
    {
        return std::nullopt;
    }
    if (extension == ".png" && ParseSequenceName(path))
    {
        return VideoFormat::PngSequence;
    }
    return FormatOfExtension(extension);
}

bool HasParts(VideoFormat format)
{
    return format != VideoFormat::Y4m && format != VideoFormat::Nut;
}

bool IsAnimation(VideoFormat format)
{
    return format == VideoFormat::Gif || format == VideoFormat::Apng || format == VideoFormat::WebP;
}

bool IsOfLibav(VideoFormat format)
{
    return format != VideoFormat::Gif && format != VideoFormat::WebP &&
           format != VideoFormat::PngSequence;
}

bool IsConstant(FrameTiming timing, VideoFormat format)
{
    return timing == FrameTiming::Constant ||
           (timing == FrameTiming::Automatic && !IsAnimation(format));
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

Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings)
{
    const std::optional<VideoFormat> format = FormatOf(path, settings);
    if (!format)
    {
        return UnknownName(path, settings);
    }
    if (!IsPipe(path) && !settings.format.empty())
    {
        return Error{ErrorKind::Unusable, FormatText(settings), "applies to standard output only",
                     "remove it; the extension of " + path.string() + " sets the format"};
    }
    if (*format == VideoFormat::PngSequence && ParseSequenceName(path)->digits > 9)
    {
        return Error{ErrorKind::Unusable, path.string(), "has more than nine #", "remove some"};
    }
    RETURN_IF_ERROR(CheckNumbers(settings));
    return CheckFormat(path, *format, settings);
}

std::int64_t PartLength(const std::filesystem::path& path, const VideoSettings& settings)
{
    const std::optional<VideoFormat> format = FormatOf(path, settings);
    if (!format || IsPipe(path) || !HasParts(*format))
    {
        return 0;
    }
    const bool isGif = *format == VideoFormat::Gif;
    const int groupFrames = settings.groupFrames > 0 ? settings.groupFrames : kPartFrames;
    return groupFrames * (isGif ? GifFrameStep(settings.framesPerSecond) : 1);
}

Rational StoredFrameRate(const std::filesystem::path& path, const Rational& framesPerSecond)
{
    if (FormatOf(path, {}) != VideoFormat::Gif)
    {
        return framesPerSecond;
    }
    const std::int64_t den = framesPerSecond.den * GifFrameStep(framesPerSecond);
    const std::int64_t divisor = std::gcd(framesPerSecond.num, den);
    return Rational{framesPerSecond.num / divisor, den / divisor};
}

} // namespace boxreel
