// SPDX-License-Identifier: MIT
#include "FilmRun.h"
#include "StopSignals.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <golden/StateHash.h>
#include <recorder/Recording.h>
#include <render/Png.h>
#include <session/SessionPanels.h>

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

std::int64_t FilmRun::StepOf(std::int64_t number) const
{
    return StepAt(m_options.length.from.value_or(Duration{}), m_session->StepsPerSecond()) +
           m_clock.StepOfFrame(number);
}

void FilmRun::Step()
{
    m_session->AdvanceTo(m_session->Step() + 1);
    if (m_snapshots != nullptr)
    {
        m_snapshots->Offer(*m_session);
    }
}

/// From a state that another run has left, if there is one.
void FilmRun::BeginSimulation()
{
    if (m_snapshots != nullptr)
    {
        const std::int64_t index = ThumbnailIsThere() ? ThumbnailFrame() : m_resumed;
        const bool isAllThere = index >= m_plan.frames.Count();
        const std::int64_t frame = isAllThere ? m_plan.frames.Last() + 1 : m_plan.frames.At(index);
        m_snapshots->Begin(*m_session, m_session->LatestStateFor(StepOf(frame)));
    }
    m_firstStep = m_session->Step();
}

SimulationTotals FilmRun::Simulated() const
{
    return {.firstStep = m_firstStep, .steps = m_session->Step() - m_firstStep};
}

/// A simulation of many steps a frame is left between two of them when a signal asks for it.
void FilmRun::AdvanceTo(std::int64_t number)
{
    const StageTimer timer(Stages(), Stage::Simulate);
    const std::int64_t first = m_session->Step();
    const std::int64_t step = StepOf(number);
    while (m_session->Step() < step && StopSignals::Caught() == 0)
    {
        Step();
        m_progress.Simulate({.step = m_session->Step(), .first = first, .last = step});
    }
    if (StopSignals::Caught() == 0)
    {
        Show(number);
    }
}

/// The step is simulated; with --interpolate the next one may be needed too.
void FilmRun::Show(std::int64_t number)
{
    const double fraction = m_options.pace.interpolate ? m_clock.FractionOfFrame(number) : 0.0;
    const std::int64_t before = m_session->Step();
    m_session->AdvanceBetween(StepOf(number), fraction);
    if (m_snapshots != nullptr && m_session->Step() != before)
    {
        m_snapshots->Offer(*m_session);
    }
}

/// What was left is gone on with only if it is the same film.
Result<void> FilmRun::OpenManifest()
{
    m_hasManifest = HasManifest(m_options, m_plan);
    m_manifest = {.version = BOXREEL_VERSION,
                  .command = CommandOfFilm(m_options.arguments),
                  .framesPerSecond = m_plan.film.framesPerSecond,
                  .groupFrames = m_plan.groupFrames,
                  .plays = m_plan.film.plays,
                  .frameCount = m_plan.frameCount,
                  .first = m_plan.frames.First(),
                  .end = m_plan.frames.Last() + 1,
                  .checksum = {},
                  .states = {}};
    std::error_code ignored;
    const bool isLeft = std::filesystem::exists(ManifestPath(Part()), ignored) ||
                        std::filesystem::exists(Part(), ignored);
    if (!m_plan.film.resume || !isLeft)
    {
        m_plan.film.resume = false; // it is begun
        return {};
    }
    if (IsBeingWritten(Part()))
    {
        return Error{ErrorKind::Failed, Part().string(), "another program is writing it",
                     "wait for it"};
    }
    ASSIGN_OR_RETURN(Manifest left, ReadManifest(Part(), "start again with --force"));
    const std::string difference = DifferenceOf(left, m_manifest);
    if (!difference.empty() || left.first != m_manifest.first)
    {
        return Error{ErrorKind::Unusable, Part().string(),
                     "belongs to another film (" +
                         (difference.empty() ? "it begins with another frame" : difference) + ")",
                     "give the same command, or start again with --force"};
    }
    m_left = std::move(left);
    m_manifest.states = m_left.states; // merge asks for the first one
    return {};
}

Result<void> FilmRun::Open(SceneSource source)
{
    RETURN_IF_ERROR(OpenManifest());
    ASSIGN_OR_RETURN(Renderer renderer, Renderer::Create({.width = m_options.look.width,
                                                          .height = m_options.look.height,
                                                          .theme = m_options.look.theme,
                                                          .backend = m_options.backend}));
    m_renderer.emplace(std::move(renderer));
    ASSIGN_OR_RETURN(SceneSession session, OpenSession(std::move(source), m_options.look));
    m_session.emplace(std::move(session));
    // The last, for a writer that goes on with what was left takes that with it when it is given
    // up.
    m_plan.film.stages = Stages();
    ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::Open(m_options.output, m_plan.film));
    m_resumed = m_filmed = writer.ResumedFrames();
    m_writer.emplace(std::move(writer));
    m_clock = {m_plan.film.framesPerSecond, m_session->StepsPerSecond(), m_options.pace.speed};
    for (const Condition& condition : m_options.length.until)
    {
        const auto missing = condition.MissingBody(m_session->World(), m_session->Names());
        if (missing) // a scene may yet make it
        {
            WriteMessage("boxreel: " + missing->Text());
        }
    }
    BeginSimulation();
    return {};
}

/// Where the film may be continued or joined, the state of the world goes into its manifest.
Result<void> FilmRun::NoteState(std::int64_t number)
{
    if (!m_hasManifest || (number % m_plan.groupFrames != 0 && number != m_manifest.first))
    {
        return {};
    }
    const std::string state = StateHashText(m_session->World());
    const auto left = m_left.states.find(number);
    if (left != m_left.states.end() && left->second != state)
    {
        return Error{ErrorKind::Unusable, Part().string(),
                     "was made by another build of boxreel: frame " + std::to_string(number) +
                         " differs",
                     "start again with --force"};
    }
    m_manifest.states[number] = state;
    return WriteManifest(Part(), m_manifest);
}

void FilmRun::Collect(FrameContent& content)
{
    const StageTimer timer(Stages(), Stage::Collect);
    m_session->Fill(content);
}

Result<void> FilmRun::Fill(std::int64_t frame, FrameContent& content)
{
    const std::int64_t number = m_plan.frames.At(m_resumed + frame);
    AdvanceTo(number);
    if (StopSignals::Caught() != 0)
    {
        content.stops = true;
        return {};
    }
    RETURN_IF_ERROR(NoteState(number));
    Collect(content);
    for (const Condition& condition : m_options.length.until)
    {
        content.isLast = content.isLast ||
                         condition.Holds(m_session->World(), m_session->Names(), m_session->Time());
    }
    m_hasEndedByItself = content.isLast;
    m_filmed = m_resumed + frame + 1;
    return {};
}

std::int64_t FilmRun::ThumbnailFrame() const
{
    const std::int64_t count = m_plan.frames.Count();
    return m_options.thumbnail.at
               ? std::min(StepAt(*m_options.thumbnail.at, m_plan.film.framesPerSecond), count - 1)
               : count / 2;
}

/// Its frame is one of those that another run has filmed.
bool FilmRun::ThumbnailIsThere() const
{
    return !m_options.thumbnail.file.empty() && ThumbnailFrame() < m_resumed;
}

/// On the way to the frame that the film goes on with.
Result<void> FilmRun::DrawThumbnail()
{
    AdvanceTo(m_plan.frames.At(ThumbnailFrame()));
    if (StopSignals::Caught() != 0)
    {
        return {};
    }
    FrameContent content;
    Collect(content);
    const Overlay* overlay = content.overlay.IsEmpty() ? nullptr : &content.overlay;
    return m_renderer->Draw(content.list, content.camera, m_thumbnail, overlay);
}

void FilmRun::See(std::int64_t frame, const Frame& pixels)
{
    if (m_resumed + frame == ThumbnailFrame())
    {
        m_thumbnail = pixels;
    }
}

Result<RecordingEnd> FilmRun::Film()
{
    m_progress.Update(
        {.framesDone = m_resumed, .framesTotal = m_plan.frames.Count(), .framesKept = m_resumed});
    if (ThumbnailIsThere())
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
    if (!m_options.thumbnail.file.empty())
    {
        settings.seen = [this](std::int64_t frame, const Frame& pixels) { See(frame, pixels); };
    }
    return Record(settings, *m_renderer, *m_writer);
}

/// Of the film that is being made.
void FilmRun::RemoveManifest()
{
    std::error_code ignored;
    if (m_hasManifest)
    {
        std::filesystem::remove(ManifestPath(Part()), ignored);
    }
}

/// What there is stays, can be played, and can be continued.
Result<int> FilmRun::Stopped(std::int64_t framesDone)
{
    std::string stopped = "Stopped";
    if (m_options.output != "-" && m_resumed + framesDone == 0)
    {
        stopped += " before the first frame";
        RemoveManifest();
    }
    else if (m_options.output != "-")
    {
        RETURN_IF_ERROR(m_writer->Suspend());
        const bool isSequence = m_hasManifest && !std::filesystem::exists(Part());
        stopped += " after " + std::to_string(m_resumed + framesDone) + " frames; " +
                   (isSequence ? "they" : Part().string()) + " can be looked at" +
                   (m_hasManifest ? ", and the same command with --resume goes on" : "");
    }
    m_progress.Stop(stopped + ".");
    return StopSignals::kExitCode;
}

/// A part keeps its manifest, a whole film needs none.
Result<void> FilmRun::FinishManifest()
{
    if (!m_hasManifest)
    {
        return {};
    }
    RemoveManifest();
    if (m_options.length.range)
    {
        m_manifest.end = m_plan.frames.First() + m_filmed;
        for (const std::int64_t step = StepOf(m_manifest.end); m_session->Step() < step;)
        {
            Step();
        }
        Show(m_manifest.end);
        m_manifest.states[m_manifest.end] = StateHashText(m_session->World());
        m_manifest.checksum = ChecksumOfFilm(m_options.output);
        RETURN_IF_ERROR(WriteManifest(m_options.output, m_manifest));
    }
    return {};
}

Result<void> FilmRun::WriteThumbnail()
{
    if (m_options.thumbnail.file.empty())
    {
        return {};
    }
    if (m_thumbnail.rgba.empty()) // the film ended earlier: its last frame
    {
        RETURN_IF_ERROR(m_renderer->Read(m_thumbnail));
    }
    return WritePng(m_options.thumbnail.file, m_thumbnail, {.overwrite = m_plan.film.overwrite});
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
    RETURN_IF_ERROR(WriteThumbnail());
    m_progress.Finish(ReportOf(m_options, m_filmed, m_progress.Seconds()));
    if (!m_options.length.until.empty() && !m_hasEndedByItself)
    {
        WriteMessage("boxreel: --until: no condition became true within " +
                     std::to_string(m_filmed) + " frames");
    }
    // A film in which what the camera waits for has never come is a film all the same.
    const Result<void> played = m_session->CheckCompanion();
    if (const Result<void> met = m_session->CheckView(); played && !met)
    {
        WriteMessage("boxreel: " + met.GetError().Text());
    }
    if (m_options.messages.stats)
    {
        WriteMessage(DescribeDrawing(m_renderer->Totals()) + "\n" +
                     DescribeSimulation(Simulated()));
        WriteMessage(StageText());
    }
    return played ? Result<int>(0) : played.GetError(); // the film is there, not what was asked
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
        RemoveManifest();
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
