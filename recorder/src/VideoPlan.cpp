// SPDX-License-Identifier: MIT
#include "VideoPlan.h"
#include "SettingTexts.h"

#include <base/ErrorMacros.h>
#include <base/Words.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>

namespace boxreel
{

namespace
{

/// The name of a container, and its codecs; the first is the default.
struct Container
{
    VideoFormat format;
    const char* name; ///< for messages
    const char* muxer;
    Options options;
    std::vector<std::string> codecs;
};

/// MP4 is written in fragments, so that it is playable if interrupted; Close converts it to one
/// with the index at the front.
const std::array<Container, 6>& Containers()
{
    static const std::array<Container, 6> containers = {{
        {VideoFormat::Mp4,
         ".mp4",
         "mp4",
         {{"movflags", "+frag_keyframe+delay_moov+default_base_moof"}},
         {"h264", "av1"}},
        // A cluster is written when complete; shorter ones lose less when a run is killed.
        {VideoFormat::Matroska,
         ".mkv",
         "matroska",
         {{"cluster_time_limit", "1000"}},
         {"h264", "vp9", "av1", "ffv1"}},
        {VideoFormat::WebM, ".webm", "webm", {{"cluster_time_limit", "1000"}}, {"vp9", "av1"}},
        {VideoFormat::Apng, ".apng", "apng", {}, {"apng"}},
        {VideoFormat::Y4m, ".y4m", "yuv4mpegpipe", {}, {"raw"}},
        {VideoFormat::Nut, ".nut", "nut", {}, {"raw"}},
    }};
    return containers;
}

const Container& ContainerOf(VideoFormat format)
{
    const auto& all = Containers();
    return *std::find_if(all.begin(), all.end(),
                         [format](const Container& c) { return c.format == format; });
}

} // namespace

std::vector<CodecChoice> CodecChoices()
{
    std::vector<CodecChoice> choices;
    for (const Container& container : Containers())
    {
        for (const std::string& codec : container.codecs)
        {
            const auto known =
                std::find_if(choices.begin(), choices.end(),
                             [&codec](const CodecChoice& choice) { return choice.name == codec; });
            if (container.codecs.size() == 1)
            {
                continue; // nothing to choose
            }
            if (known == choices.end())
            {
                choices.push_back({codec, {container.name}});
            }
            else
            {
                known->ends.emplace_back(container.name);
            }
        }
    }
    return choices;
}

namespace
{

Error Contradiction(const ErrorText& culprit, const ErrorText& problem, const ErrorText& remedy)
{
    return Error{ErrorKind::Unusable, culprit, problem, remedy};
}

const char* YuvOf(Chroma chroma)
{
    return chroma == Chroma::Full ? "yuv444p" : "yuv420p";
}

void Add(EncoderPlan& plan, std::initializer_list<std::pair<std::string, std::string>> options)
{
    plan.codecOptions.insert(plan.codecOptions.end(), options);
}

bool HasAvx512()
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f") != 0;
#else
    return false;
#endif
}

/// With its functions for AVX-512, x264's macroblock tree reads motion vectors that nobody wrote,
/// so the bytes depend on what the memory held before (docs/notes/same-bytes.md).
constexpr const char* kUpToAvx2 = "asm=mmx2,sse2,ssse3,sse4.1,sse4.2,avx,fma3,bmi1,bmi2,avx2";

/// Presets by cost per 720p frame: ultrafast 2.7 ms, veryfast 7.5, medium 15. Lossless keeps RGB,
/// because 8-bit YUV would round.
/// What is predicted must not depend on the distance of pictures, because repeated ones lie between
/// (H264Repeat). One reference is safe.
void PlanH264(EncoderPlan& plan, const VideoSettings& settings)
{
    plan.encoder = "libx264";
    plan.pixelFormat = YuvOf(settings.chroma);
    switch (settings.quality)
    {
    case Quality::Draft:
        Add(plan, {{"preset", "ultrafast"}, {"crf", "28"}});
        break;
    case Quality::Standard:
        Add(plan, {{"preset", "veryfast"}, {"crf", "18"}});
        break;
    case Quality::High:
        Add(plan, {{"preset", "medium"}, {"crf", "13"}, {"weightb", "0"}});
        break;
    case Quality::Lossless:
        plan.encoder = "libx264rgb";
        plan.pixelFormat = "bgr0";
        Add(plan, {{"preset", "veryfast"}, {"qp", "0"}});
        break;
    }
    Add(plan, {{"direct-pred", "spatial"}});
    if (HasAvx512())
    {
        Add(plan, {{"x264-params", kUpToAvx2}});
    }
}

/// "realtime" selects a faster search: for 720p drawings a quarter of the time of "good", for a
/// tenth more bytes at equal error.
void PlanVp9(EncoderPlan& plan, const VideoSettings& settings)
{
    plan.encoder = "libvpx-vp9";
    plan.pixelFormat = YuvOf(settings.chroma);
    Add(plan, {{"row-mt", "1"}, {"tile-columns", "1"}, {"b", "0"}});
    switch (settings.quality)
    {
    case Quality::Draft:
        Add(plan, {{"deadline", "realtime"}, {"cpu-used", "8"}, {"crf", "40"}});
        break;
    case Quality::Standard:
        Add(plan, {{"deadline", "realtime"}, {"cpu-used", "5"}, {"crf", "28"}});
        break;
    case Quality::High:
        Add(plan, {{"cpu-used", "4"}, {"crf", "12"}});
        break;
    case Quality::Lossless:
        plan.pixelFormat = "gbrp";
        Add(plan, {{"deadline", "realtime"}, {"cpu-used", "5"}, {"lossless", "1"}});
        break;
    }
}

/// Quality levels match the errors of VP9 (docs/notes/codec-qualities.md). Speed 8 takes 1.6 times
/// the bytes of speed 6 for 0.6 of its time.
/// SVT-AV1 takes the same time for half the bytes. However, it supports neither 4:4:4 nor lossless,
/// and hangs when closed before its first frame.
void PlanAv1(EncoderPlan& plan, const VideoSettings& settings)
{
    const bool isLossless = settings.quality == Quality::Lossless;
    const char* const speeds[] = {"8", "6", "6", "6"};
    const char* const qualities[] = {"36", "26", "12", ""};
    const std::size_t level = std::size_t(settings.quality);
    plan.encoder = "libaom-av1";
    plan.pixelFormat = isLossless ? "gbrp" : YuvOf(settings.chroma);
    // libaom's realtime search has errors of up to 46 of 255 in lossless mode.
    Add(plan, {{"usage", isLossless ? "good" : "realtime"},
               {"cpu-used", speeds[level]},
               {"row-mt", "1"},
               {"b", "0"}});
    if (isLossless)
    {
        Add(plan, {{"aom-params", "lossless=1"}});
    }
    else
    {
        Add(plan, {{"crf", qualities[level]}});
    }
}

/// The number of slices is fixed, because the bytes depend on it; checksums let a reader detect
/// damage. Intra frames only, so that parts equal the whole film.
void PlanFfv1(EncoderPlan& plan, const VideoSettings& settings)
{
    plan.encoder = "ffv1";
    plan.pixelFormat = "bgr0";
    Add(plan, {{"g", "1"}});
    // libav 5.1 refuses 2 x 2 slices with a side of one pixel, and decodes those with two as black.
    // Such small frames are one slice.
    const bool isTiny = std::min(settings.width, settings.height) < 3;
    if (isTiny)
    {
        Add(plan, {{"level", "1"}});
    }
    else
    {
        Add(plan, {{"level", "3"}, {"slices", "4"}, {"slicecrc", "1"}});
    }
}

/// Lossless at every setting. Cost per frame of 720p drawings: none and level 1: 30 ms, 71 kB;
/// paeth and 3: 35 ms, 54 kB; mixed and 6: 60 ms, 51 kB.
void PlanApng(EncoderPlan& plan, const VideoSettings& settings)
{
    plan.encoder = "apng";
    plan.pixelFormat = "rgb24";
    switch (settings.quality)
    {
    case Quality::Draft:
        Add(plan, {{"pred", "none"}, {"compression_level", "1"}});
        break;
    case Quality::Standard:
        Add(plan, {{"pred", "paeth"}, {"compression_level", "3"}});
        break;
    default:
        Add(plan, {{"pred", "mixed"}, {"compression_level", "6"}});
        break;
    }
}

/// True for options that set the quality, which conflict with `lossless`.
bool IsRateOption(const std::string& name)
{
    constexpr const char* kNames[] = {"b",        "crf",        "qp",          "cqp",
                                      "qmin",     "qmax",       "qdiff",       "maxrate",
                                      "lossless", "aom-params", "x264-params", "x264opts"};
    return std::any_of(std::begin(kNames), std::end(kNames),
                       [&](const char* known) { return name == known; });
}

/// The user's options come last and take precedence. x264-params silently accepts unknown options;
/// x264opts is the same otherwise.
Result<void> AddUsers(EncoderPlan& plan, const VideoSettings& settings)
{
    for (const auto& [name, value] : settings.codecOptions)
    {
        if (settings.quality == Quality::Lossless && plan.needsGroups && IsRateOption(name))
        {
            return Contradiction(ErrorSetting{kCodecOptions, {name}}, "is set by " + kLossless,
                                 "remove one of them");
        }
        if (name == "flags" && value.find("pass") != std::string::npos)
        {
            return Contradiction(ErrorSetting{kCodecOptions, {"flags=" + value}},
                                 "films are encoded in one pass", "remove it");
        }
        if (name == "b" || name == "qp" || name == "cqp")
        {
            // Encoders prefer the quality's crf, and would ignore these silently.
            std::erase_if(plan.codecOptions, [](const auto& set) { return set.first == "crf"; });
        }
        plan.codecOptions.emplace_back(name == "x264-params" ? "x264opts" : name, value);
    }
    return {};
}

Result<void> PlanRaw(EncoderPlan& plan, VideoFormat format, const VideoSettings& settings)
{
    plan.encoder = format == VideoFormat::Y4m ? "wrapped_avframe" : "rawvideo";
    plan.isConstantRate = true;
    plan.pixelFormat = format == VideoFormat::Nut ? "rgb24" : YuvOf(settings.chroma);
    if (format == VideoFormat::Y4m && settings.quality == Quality::Lossless)
    {
        return Contradiction(kLossless, "y4m stores YUV, which rounds colours",
                             "use nut, or remove it");
    }
    return {};
}

Result<std::string> CodecOf(const Container& container, const VideoSettings& settings)
{
    if (settings.codec.empty())
    {
        const bool isFfv1 =
            container.format == VideoFormat::Matroska && settings.quality == Quality::Lossless;
        return isFfv1 ? "ffv1" : container.codecs.front();
    }
    const auto& codecs = container.codecs;
    if (std::find(codecs.begin(), codecs.end(), settings.codec) == codecs.end())
    {
        const bool hasChoice = codecs.size() > 1;
        return Contradiction(ErrorSetting{kCodec, {settings.codec}},
                             std::string(container.name) + " does not support it",
                             hasChoice ? ErrorText("use one of " + JoinedBy(", ", codecs))
                                       : "remove " + ErrorSetting{kCodec} + ", it has only one");
    }
    return settings.codec;
}

Result<void> PlanCodec(EncoderPlan& plan, VideoFormat format, const std::string& codec,
                       const VideoSettings& settings)
{
    plan.needsGroups = codec == "h264" || codec == "vp9" || codec == "av1";
    const bool isLossless = settings.quality == Quality::Lossless;
    const bool hasChroma = format == VideoFormat::Y4m || plan.needsGroups;
    if (settings.chroma == Chroma::Full && (!hasChroma || isLossless))
    {
        return Contradiction(kFullChroma, "applies to YUV, and this film is RGB", "remove it");
    }
    if (codec == "ffv1" && !isLossless)
    {
        return Contradiction(ErrorSetting{kCodec, {"ffv1"}}, "requires " + kLossless,
                             "add it, or use another codec");
    }
    if (codec == "h264")
    {
        PlanH264(plan, settings);
    }
    else if (codec == "vp9")
    {
        PlanVp9(plan, settings);
    }
    else if (codec == "av1")
    {
        PlanAv1(plan, settings);
    }
    else if (codec == "ffv1")
    {
        PlanFfv1(plan, settings);
    }
    else if (codec == "apng")
    {
        PlanApng(plan, settings);
    }
    else
    {
        return PlanRaw(plan, format, settings);
    }
    return {};
}

/// Sets the number of plays.
void PlanPlays(EncoderPlan& plan, VideoFormat format, int plays)
{
    if (format == VideoFormat::Apng)
    {
        plan.muxerOptions.emplace_back("plays", std::to_string(plays));
    }
}

} // namespace

Result<EncoderPlan> PlanFor(VideoFormat format, const VideoSettings& settings)
{
    assert(IsOfLibav(format) && "others have no plan");
    const Container& container = ContainerOf(format);
    ASSIGN_OR_RETURN(const std::string codec, CodecOf(container, settings));
    EncoderPlan plan;
    plan.muxer = container.muxer;
    plan.muxerOptions = container.options;
    RETURN_IF_ERROR(PlanCodec(plan, format, codec, settings));
    PlanPlays(plan, format, settings.plays);
    RETURN_IF_ERROR(AddUsers(plan, settings));
    return plan;
}

} // namespace boxreel
