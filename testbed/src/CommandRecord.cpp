// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "RenderReport.h"
#include "StopSignals.h"
#include "Terminal.h"

#include <debugdraw/AtomicFile.h>
#include <recorder/Recording.h>
#include <render/Renderer.h>

#include <csignal>

namespace boxreel
{
namespace
{

constexpr Duration kDefaultLength{10'000'000'000};
constexpr std::int64_t kMostFrames = 10'000'000; // 46 hours at 60 frames a second

Result<std::int64_t> FrameCount(const RecordOptions& options)
{
    const std::int64_t frames = options.frames.value_or(
        FramesIn(options.seconds.value_or(kDefaultLength), options.framesPerSecond));
    if (frames > kMostFrames)
    {
        return Error{ErrorKind::Unusable, "The film would have " + std::to_string(frames) +
                                              " frames; make it shorter or lower --fps, " +
                                              std::to_string(kMostFrames) + " is the most."};
    }
    return frames;
}

VideoSettings VideoSettingsOf(const RecordOptions& options)
{
    VideoSettings settings;
    settings.width = options.look.width;
    settings.height = options.look.height;
    settings.framesPerSecond = options.framesPerSecond;
    settings.quality = options.quality;
    settings.overwrite = options.force;
    return settings;
}

/// A simulation of many steps a frame is left between two of them when a signal asks for it.
Result<void> AdvanceUntilStopped(SceneSession& session, std::int64_t step)
{
    while (session.Step() < step && StopSignals::Caught() == 0)
    {
        session.AdvanceTo(session.Step() + 1);
    }
    return {};
}

Result<void> Film(const RecordOptions& options, std::int64_t frameCount, SceneSession& session,
                  Renderer& renderer, VideoWriter& writer, Progress& progress)
{
    const FrameClock clock{options.framesPerSecond, session.StepsPerSecond(), options.speed};
    RecordingSettings settings;
    settings.frameCount = frameCount;
    settings.fill = [&](std::int64_t frame, FrameContent& content) -> Result<void> {
        Result<void> advanced = AdvanceUntilStopped(session, clock.StepOfFrame(frame));
        session.Fill(content);
        return advanced;
    };
    settings.progress = [&](const RecordingProgress& now) {
        progress.Update(now);
        return StopSignals::Caught() == 0;
    };
    return Record(settings, renderer, writer);
}

FilmReport ReportOf(const RecordOptions& options, std::int64_t frameCount, double seconds)
{
    FilmReport report;
    report.file = options.output;
    report.framesFilmed = frameCount;
    report.width = options.look.width;
    report.height = options.look.height;
    const Rational stored = StoredFrameRate(options.output, options.framesPerSecond);
    report.framesPerSecond = stored.ToDouble();
    // Both rates are exact fractions, and one is a whole multiple of the other.
    const std::int64_t every =
        options.framesPerSecond.num * stored.den / (options.framesPerSecond.den * stored.num);
    report.frames = (frameCount + every - 1) / every;
    report.seconds = seconds;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(options.output, error);
    report.bytes = error ? -1 : static_cast<std::int64_t>(bytes);
    return report;
}

Result<int> RecordScene(const RecordOptions& options, std::int64_t frameCount, SceneSource source)
{
    Progress progress(options.progress);
    StopSignals::RemoveWhenEnded(PartPath(options.output)); // before there is anything to remove
    Result<VideoWriter> writer = VideoWriter::Open(options.output, VideoSettingsOf(options));
    if (!writer)
    {
        return writer.GetError();
    }
    Result<Renderer> renderer = Renderer::Create({.width = options.look.width,
                                                  .height = options.look.height,
                                                  .theme = options.look.theme,
                                                  .backend = options.backend});
    if (!renderer)
    {
        return renderer.GetError();
    }
    Result<SceneSession> session = SceneSession::Open(std::move(source), options.look);
    if (!session)
    {
        return session.GetError();
    }
    const Result<void> filmed = Film(options, frameCount, *session, *renderer, *writer, progress);
    const int signal = StopSignals::Caught();
    if (!filmed && signal == 0)
    {
        progress.Clear();
        return filmed.GetError();
    }
    if (signal != 0)
    {
        progress.Clear();
        WriteMessage("boxreel: Stopped; the unfinished film was removed.");
        return 128 + signal;
    }
    progress.Finish(ReportOf(options, frameCount, progress.Seconds()));
    if (options.stats)
    {
        WriteMessage(DescribeDrawing(renderer->Totals()));
    }
    return 0;
}

} // namespace

Result<int> RunRecord(const RecordOptions& options)
{
    const Result<std::int64_t> frameCount = FrameCount(options);
    if (!frameCount)
    {
        return frameCount.GetError();
    }
    const Result<void> usable = CheckVideoPath(options.output, VideoSettingsOf(options));
    if (!usable)
    {
        return usable.GetError();
    }
    Result<SceneSource> source = OpenScene(options.scene);
    if (!source)
    {
        return source.GetError();
    }
    for (const std::string& line : source->leftOut)
    {
        WriteMessage(line);
    }
    const StopSignals stopSignals;
    return RecordScene(options, *frameCount, std::move(*source));
}

} // namespace boxreel
