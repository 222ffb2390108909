// SPDX-License-Identifier: MIT
#include "AnimationCopy.h"

#include "FrameTimes.h"
#include "VideoSource.h"

#include <base/ErrorMacros.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace boxreel
{

namespace
{

/// The stored frames of a film, each with the frames of the recording that it represents.
class StoredFrames
{
public:
    static Result<StoredFrames> Open(const std::filesystem::path& path,
                                     const VideoSettings& settings);

    const VideoInfo& Info() const { return m_source->info; }
    const FrameTimes& Times() const { return m_times; }

    Result<bool> Next(); ///< false after the last

    const boxreel::Frame& Frame() const { return m_stored.frame; }
    std::int64_t First() const { return m_first; } ///< index of its first frame
    std::int64_t End() const { return m_end; }     ///< index after its last frame

private:
    StoredFrames(VideoFormat format, const VideoSettings& settings)
        : m_format(format), m_rate(settings.framesPerSecond), m_times(format, settings)
    {}
    std::int64_t IndexAt(double seconds) const;

    VideoFormat m_format;
    Rational m_rate;
    FrameTimes m_times;
    std::unique_ptr<VideoSource> m_source;
    StoredFrame m_stored;
    std::int64_t m_first = 0;
    std::int64_t m_end = 0;
};

Result<StoredFrames> StoredFrames::Open(const std::filesystem::path& path,
                                        const VideoSettings& settings)
{
    StoredFrames frames(*FormatOf(path, {}), settings);
    ASSIGN_OR_RETURN(std::unique_ptr<VideoSource> source, OpenVideoSource(path));
    frames.m_source = std::move(source);
    return frames;
}

/// Returns the index of the frame shown from then on. A GIF starts with the first frame that it
/// keeps.
std::int64_t StoredFrames::IndexAt(double seconds) const
{
    if (m_format != VideoFormat::Gif)
    {
        return std::llround(seconds * m_rate.ToDouble());
    }
    std::int64_t begin = 0;
    while (!m_times.IsKept(begin))
    {
        ++begin;
    }
    std::int64_t index = m_times.IndexAt(std::llround(seconds * 100.0) + m_times.TimeOf(begin));
    while (!m_times.IsKept(index)) // several frames may start in the same 1/100 s
    {
        --index;
    }
    return index;
}

Result<bool> StoredFrames::Next()
{
    Result<bool> more = m_source->Next(m_stored);
    if (!more || !*more)
    {
        return more;
    }
    const bool isApng = m_format == VideoFormat::Apng;
    // libav rounds the duration of each frame of an animated PNG, and the errors add up.
    m_first = isApng ? m_end : IndexAt(m_stored.seconds);
    m_end = isApng ? m_first + std::llround(m_stored.length * m_rate.ToDouble())
                   : IndexAt(m_stored.seconds + m_stored.length);
    m_end = std::max(m_end, m_first + 1);
    return true;
}

Error CutShort(const std::filesystem::path& path, std::int64_t frames)
{
    return Error{ErrorKind::Unusable, path.string(),
                 "has only " + std::to_string(frames) + " frames", "record it again"};
}

/// Repeats the last frame until `count` are appended.
Result<void> RepeatUntil(std::int64_t count, std::int64_t appended, VideoWriter& to)
{
    Result<void> done;
    for (; appended < count && done; ++appended)
    {
        done = to.Repeat();
    }
    return done;
}

/// Returns the `settings` of a part that starts with this frame of the film.
VideoSettings PartOf(VideoSettings settings, std::int64_t firstFrame)
{
    settings.frames = FrameRange(FrameRun{.first = firstFrame});
    return settings;
}

} // namespace

Result<void> CopyAnimation(const std::filesystem::path& from, const VideoSettings& settings,
                           std::optional<std::int64_t> count, VideoWriter& to,
                           const std::function<bool()>& isStopped)
{
    ASSIGN_OR_RETURN(StoredFrames frames, StoredFrames::Open(from, settings));
    if (frames.Info().width != settings.width || frames.Info().height != settings.height)
    {
        return Error{ErrorKind::Unusable, from.string(), "size differs from the film's",
                     "record it again"};
    }
    const std::int64_t end = count.value_or(std::numeric_limits<std::int64_t>::max());
    std::int64_t appended = 0;
    while (appended < end && !isStopped())
    {
        ASSIGN_OR_RETURN(const bool more, frames.Next());
        if (!more && count && appended > 1)
        {
            return CutShort(from, appended);
        }
        if (!more) // a film of one picture does not store its duration
        {
            return count ? RepeatUntil(*count, appended, to) : Result<void>();
        }
        // For leading frames that a GIF omits, append its first stored frame.
        for (; appended < std::min(frames.First() + 1, end); ++appended)
        {
            RETURN_IF_ERROR(to.Append(frames.Frame()));
        }
        RETURN_IF_ERROR(RepeatUntil(std::min(frames.End(), end), appended, to));
        appended = std::max(appended, std::min(frames.End(), end));
    }
    return {};
}

std::int64_t CountWholeAnimation(const std::filesystem::path& left, const VideoSettings& settings)
{
    Result<StoredFrames> frames = StoredFrames::Open(left, settings);
    if (!frames || frames->Info().width != settings.width ||
        frames->Info().height != settings.height)
    {
        return 0;
    }
    std::int64_t last = -1;
    for (Result<bool> more = frames->Next(); more && *more; more = frames->Next())
    {
        last = frames->End() - 1;
    }
    const FrameTimes& times = frames->Times();
    return last < 0 ? 0 : std::max<std::int64_t>(0, times.FirstIndexOf(times.GroupOf(last)));
}

Result<JoinedFilm> JoinAnimations(const std::vector<FilmPart>& parts,
                                  const std::filesystem::path& path, const VideoSettings& settings,
                                  const std::function<bool()>& isStopped)
{
    ASSIGN_OR_RETURN(StoredFrames first, StoredFrames::Open(parts.front().path, settings));
    VideoSettings whole = PartOf(settings, parts.front().firstFrame);
    whole.width = first.Info().width;
    whole.height = first.Info().height;
    ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::Open(path, whole));
    for (auto part = parts.begin(); part != parts.end(); ++part)
    {
        const auto next = part + 1;
        const std::optional<std::int64_t> count =
            part->frames > 0      ? std::optional(part->frames)
            : next != parts.end() ? std::optional(next->firstFrame - part->firstFrame)
                                  : std::nullopt;
        RETURN_IF_ERROR(
            CopyAnimation(part->path, PartOf(whole, part->firstFrame), count, writer, isStopped));
        if (isStopped())
        {
            return JoinedFilm{};
        }
    }
    RETURN_IF_ERROR(writer.Close());
    return JoinedFilm{true, writer.StoredFrames()};
}

} // namespace boxreel
