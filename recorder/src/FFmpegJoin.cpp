// SPDX-License-Identifier: MIT
#include "FFmpegJoin.h"
#include "FFmpegCodec.h"
#include "FFmpegCopy.h"
#include "FrameTimes.h"
#include "SettingTexts.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace boxreel
{

namespace
{

/// A part, and the times of its frames in the film.
struct Part
{
    CopiedPart copied;
    std::vector<std::int64_t> shown;
    std::vector<std::int64_t> decoded;
};

Result<std::vector<Part>> LookAt(const std::vector<FilmPart>& films, const FrameTimes& times,
                                 AVRational tick)
{
    std::vector<Part> parts;
    for (const FilmPart& film : films)
    {
        const std::int64_t index = film.firstFrame - films.front().firstFrame;
        Part part{{.from = film.path, .tick = tick, .offset = times.TimeOf(index)}, {}, {}};
        ASSIGN_OR_RETURN(part.shown, TimesIn(part.copied));
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Computes the decoding time of each packet over all parts, and the duration of the last packet.
void FillDecodingTimes(std::vector<Part>& parts)
{
    std::vector<std::int64_t> shown;
    for (const Part& part : parts)
    {
        shown.insert(shown.end(), part.shown.begin(), part.shown.end());
    }
    const int delay = DelayOf(shown);
    const std::vector<std::int64_t> decoded = LatestDecodingTimes(shown, delay);
    parts.back().copied.lastDuration = LastDuration(shown, decoded, delay);
    auto next = decoded.begin();
    for (Part& part : parts)
    {
        part.decoded.assign(next, next + std::ptrdiff_t(part.shown.size()));
        next += std::ptrdiff_t(part.shown.size());
    }
}

bool IsAlike(const AVCodecParameters& a, const AVCodecParameters& b)
{
    return a.codec_id == b.codec_id && a.width == b.width && a.height == b.height &&
           a.format == b.format && a.extradata_size == b.extradata_size &&
           (a.extradata_size == 0 ||
            std::memcmp(a.extradata, b.extradata, std::size_t(a.extradata_size)) == 0);
}

/// Checks that all parts have the same codec parameters, because a stream has only one set.
Result<void> CheckAlike(const std::vector<FilmPart>& films, AVRational tick)
{
    ASSIGN_OR_RETURN(FFmpegPackets first, FFmpegPackets::Open(films.front().path, tick));
    for (const FilmPart& film : films)
    {
        ASSIGN_OR_RETURN(const FFmpegPackets packets, FFmpegPackets::Open(film.path, tick));
        if (!IsAlike(first.Codec(), packets.Codec()))
        {
            return Error{ErrorKind::Unusable, film.path.string(),
                         "is not encoded as " + films.front().path.string() + " is",
                         "record both with the same options and libraries"};
        }
    }
    return {};
}

Result<bool> Write(const std::vector<Part>& parts, FFmpegMuxer& muxer,
                   const std::function<bool()>& isStopped)
{
    for (const Part& part : parts)
    {
        RETURN_IF_ERROR(CopyPackets(part.copied, part.decoded, muxer, isStopped));
        if (isStopped())
        {
            return false;
        }
    }
    const Result<void> finished = muxer.Finish();
    return finished ? Result<bool>(true) : finished.GetError();
}

} // namespace

Result<JoinedFilm> JoinFFmpegFilms(const std::vector<FilmPart>& films,
                                   const std::filesystem::path& path, VideoFormat format,
                                   const VideoSettings& settings,
                                   const std::function<bool()>& isStopped)
{
    RETURN_IF_ERROR(LoadFFmpeg());
    ASSIGN_OR_RETURN(const EncoderPlan plan, PlanFor(format, settings));
    const AVRational tick = TickOf(settings.framesPerSecond);
    VideoSettings whole = settings;
    whole.frames = FrameRange(FrameRun{.first = films.front().firstFrame});
    ASSIGN_OR_RETURN(std::vector<Part> parts, LookAt(films, FrameTimes(format, whole), tick));
    RETURN_IF_ERROR(CheckAlike(films, tick));
    FillDecodingTimes(parts);
    Result<FFmpegPackets> first = FFmpegPackets::Open(films.front().path, tick);
    Result<AtomicFile> file = AtomicFile::Create(path, {.overwrite = settings.overwrite,
                                                        .replacesLeftover = settings.overwrite,
                                                        .leftoverRemedy = LeftoverRemedy()});
    if (!first || !file)
    {
        return first ? file.GetError() : first.GetError();
    }
    FFmpegOutput output(&*file);
    const AVRational rate{int(settings.framesPerSecond.num), int(settings.framesPerSecond.den)};
    const Options options =
        format == VideoFormat::Mp4 ? Options{{"movflags", "+faststart"}} : plan.muxerOptions;
    ASSIGN_OR_RETURN(FFmpegMuxer muxer,
                     FFmpegMuxer::Open(output, plan.muxer, options, {&first->Codec(), tick, rate},
                                       path.string()));
    ASSIGN_OR_RETURN(const bool isWhole, Write(parts, muxer, isStopped));
    if (!isWhole)
    {
        return JoinedFilm{};
    }
    RETURN_IF_ERROR(file->Commit());
    const auto countPackets = [](std::int64_t count, const Part& part) {
        return count + std::int64_t(part.shown.size());
    };
    return JoinedFilm{true,
                      std::accumulate(parts.begin(), parts.end(), std::int64_t(0), countPackets)};
}

} // namespace boxreel
