// SPDX-License-Identifier: MIT
#include "FilmRun.h"
#include "StopSignals.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <recorder/Recording.h>

namespace boxreel
{
namespace
{

FilmReport ReportOf(const RecordOptions& options, std::int64_t frameCount, double seconds)
{
    FilmReport report;
    report.file = options.output;
    report.framesFilmed = frameCount;
    report.width = options.look.width;
    report.height = options.look.height;
    const Rational& rate = options.film.framesPerSecond;
    const Rational stored = StoredFrameRate(options.output, rate);
    report.framesPerSecond = stored.ToDouble();
    // Both rates are exact fractions, and one is a whole multiple of the other.
    const std::int64_t every = rate.num * stored.den / (rate.den * stored.num);
    report.frames = (frameCount + every - 1) / every;
    report.seconds = seconds;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(options.output, error);
    report.bytes = error ? -1 : static_cast<std::int64_t>(bytes);
    return report;
}

} // namespace

Result<void> FilmRun::Open(SceneSource source)
{
    if (m_plan.film.resume)
    {
        ASSIGN_OR_RETURN(m_plan.film.resume, m_manifest.FindLeft());
    }
    ASSIGN_OR_RETURN(Renderer renderer, Renderer::Create({.width = m_options.look.width,
                                                          .height = m_options.look.height,
                                                          .theme = m_options.look.theme,
                                                          .backend = m_options.backend}));
    m_renderer.emplace(std::move(renderer));
    RETURN_IF_ERROR(m_simulation.Open(std::move(source)));
    // Opened last, because a writer that resumes a film removes the file when it is abandoned.
    m_plan.film.stages = Stages();
    ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::Open(m_options.output, m_plan.film));
    m_resumed = m_filmed = writer.ResumedFrames();
    m_writer.emplace(std::move(writer));
    m_simulation.TellMissingBodies();
    const std::int64_t index = IsThumbnailThere() ? m_thumbnail.Index() : m_resumed;
    const bool isAllThere = index >= m_plan.frames.Count();
    m_simulation.Begin(isAllThere ? m_plan.frames.Last() + 1 : m_plan.frames.At(index));
    return {};
}

Result<void> FilmRun::Fill(std::int64_t frame, FrameContent& content)
{
    const std::int64_t number = m_plan.frames.At(m_resumed + frame);
    if (!m_simulation.AdvanceTo(number))
    {
        content.stops = true;
        return {};
    }
    RETURN_IF_ERROR(m_manifest.Note(number, m_simulation.Session().World()));
    m_simulation.Fill(content);
    content.isLast = content.isLast || m_simulation.IsAtEnd();
    m_filmed = m_resumed + frame + 1;
    return {};
}

/// While simulating up to the frame at which the film continues.
Result<void> FilmRun::DrawThumbnail()
{
    if (!m_simulation.AdvanceTo(m_plan.frames.At(m_thumbnail.Index())))
    {
        return {};
    }
    FrameContent content;
    m_simulation.Fill(content);
    return m_thumbnail.Draw(*m_renderer, content);
}

Result<RecordingEnd> FilmRun::Film()
{
    m_progress.Update(
        {.framesDone = m_resumed, .framesTotal = m_plan.frames.Count(), .framesKept = m_resumed});
    if (IsThumbnailThere())
    {
        RETURN_IF_ERROR(DrawThumbnail());
    }
    if (m_resumed == m_plan.frames.Count()) // it was stopped after its last frame
    {
        const Result<void> closed = m_writer->Close();
        return closed ? Result<RecordingEnd>(RecordingEnd::Complete) : closed.GetError();
    }
    m_before = ProcessSoFar();
    RecordingSettings settings;
    settings.frameCount = m_plan.frames.Count() - m_resumed;
    settings.fill = [this](std::int64_t frame, FrameContent& content) {
        return Fill(frame, content);
    };
    settings.progress = [this](RecordingProgress now) {
        m_encoded = now.framesDone;
        now.framesDone += m_resumed;
        now.framesTotal += m_resumed;
        now.framesKept = m_resumed;
        m_progress.Update(now);
        return StopSignals::Caught() == 0;
    };
    if (m_thumbnail.IsWanted())
    {
        settings.seen = [this](std::int64_t frame, const Frame& pixels) {
            m_thumbnail.See(m_resumed + frame, pixels);
        };
    }
    return Record(settings, *m_renderer, *m_writer);
}

/// Keeps the part file, which is playable and can be resumed.
Result<int> FilmRun::Stopped(std::int64_t framesDone)
{
    const std::filesystem::path part = PartPath(m_options.output);
    std::string stopped = "Stopped";
    if (m_options.output != "-" && m_resumed + framesDone == 0)
    {
        stopped += " before the first frame";
        m_manifest.Remove();
    }
    else if (m_options.output != "-")
    {
        RETURN_IF_ERROR(m_writer->Suspend());
        const bool isSequence = m_manifest.IsKept() && !std::filesystem::exists(part);
        stopped += " after " + std::to_string(m_resumed + framesDone) + " frames; " +
                   (isSequence ? "they" : part.string()) + " can be looked at" +
                   (m_manifest.IsKept() ? ", and the same command with --resume goes on" : "");
    }
    m_progress.Stop(stopped + ".");
    return StopSignals::kExitCode;
}

/// A part keeps its manifest, a whole film needs none.
Result<void> FilmRun::FinishManifest()
{
    if (!m_manifest.IsKept())
    {
        return {};
    }
    m_manifest.Remove();
    if (!m_options.length.range)
    {
        return {};
    }
    const std::int64_t end = m_plan.frames.First() + m_filmed;
    m_simulation.FinishAt(end);
    return m_manifest.Complete(end, m_simulation.Session().World());
}

std::string FilmRun::StageText() const
{
    const FilmTimes times{m_filmed - m_resumed, m_before, ProcessSoFar(), RasterSeconds()};
    return m_options.messages.progress == ProgressMode::Json ? StageJson(m_stages, times)
                                                             : DescribeStages(m_stages, times);
}

Result<int> FilmRun::Finished()
{
    RETURN_IF_ERROR(FinishManifest());
    RETURN_IF_ERROR(m_thumbnail.Write(*m_renderer));
    FilmReport report = ReportOf(m_options, m_filmed, m_progress.Seconds());
    report.stored = m_writer->StoredFrames();
    m_progress.Finish(report);
    Result<int> code = m_simulation.Conclude(m_filmed);
    if (m_options.messages.stats)
    {
        WriteMessage(DescribeDrawing(m_renderer->Totals()) + "\n" +
                     DescribeSimulation(m_simulation.Totals()));
        WriteMessage(StageText());
    }
    return code;
}

/// A failure leaves nothing behind but what another run had left: another machine may go on.
void FilmRun::Abandon()
{
    if (m_resumed > 0)
    {
        (void)m_writer->Suspend(); // what failed before is what is said
    }
    else if (m_writer)
    {
        m_manifest.Remove();
    }
}

Result<int> FilmRun::Make(SceneSource source)
{
    if (Result<void> opened = Open(std::move(source)); !opened)
    {
        Abandon();
        return opened.GetError();
    }
    const Result<RecordingEnd> end = Film();
    if (!end)
    {
        m_progress.Clear();
        Abandon();
        return end.GetError();
    }
    return *end == RecordingEnd::Stopped ? Stopped(m_encoded) : Finished();
}

} // namespace boxreel
