// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "FilmPapers.h"
#include "OutputPath.h"
#include "RenderReport.h"
#include "StopSignals.h"
#include "Terminal.h"

#include <debugdraw/AtomicFile.h>
#include <golden/StateHash.h>
#include <recorder/Recording.h>
#include <render/Png.h>
#include <render/Renderer.h>

#include <csignal>

namespace boxreel
{
namespace
{

constexpr Duration kDefaultLength{10'000'000'000};
constexpr Duration kLongestWait{600'000'000'000}; // of a film that ends when something holds
constexpr std::int64_t kMostFrames = 10'000'000;  // 46 hours at 60 frames a second
constexpr int kStoppedCode = 75;                  // as sysexits.h calls "try again later"

/// What the options come to before anything is opened.
struct FilmPlan
{
    VideoSettings film;
    std::int64_t frameCount = 0;  ///< of the whole film, or the most when it ends earlier
    FrameRange frames;            ///< those that are made
    std::int64_t groupFrames = 0; ///< from a frame that a part may begin with to the next
};

Result<std::int64_t> FrameCount(const RecordOptions& options)
{
    const Duration length = options.until.empty() ? kDefaultLength : kLongestWait;
    const std::int64_t frames = options.frames.value_or(
        FramesIn(options.seconds.value_or(length), options.film.framesPerSecond));
    if (frames > kMostFrames)
    {
        return Error{ErrorKind::Unusable, "The film would have " + std::to_string(frames) +
                                              " frames; make it shorter or lower --fps, " +
                                              std::to_string(kMostFrames) + " is the most."};
    }
    return frames;
}

Result<FilmPlan> Plan(const RecordOptions& options)
{
    const Result<std::int64_t> frameCount = FrameCount(options);
    if (!frameCount)
    {
        return frameCount.GetError();
    }
    FilmPlan plan{.film = options.film,
                  .frameCount = *frameCount,
                  .frames = FrameRange(FrameRun{0, *frameCount - 1, 1})};
    if (options.range)
    {
        plan.frames = options.range->Below(*frameCount);
        if (plan.frames.Count() == 0)
        {
            return Error{ErrorKind::Unusable, "--frame-range " + options.range->Text() +
                                                  ": the film has the frames 0 to " +
                                                  std::to_string(*frameCount - 1) +
                                                  "; give some of these, or a longer film."};
        }
    }
    plan.film.width = options.look.width;
    plan.film.height = options.look.height;
    plan.film.frames = plan.frames;
    plan.groupFrames = PartLength(options.output, plan.film);
    const Result<void> usable = CheckVideoPath(options.output, plan.film);
    return usable ? Result<FilmPlan>(std::move(plan)) : usable.GetError();
}

/// A film that may be stopped and continued, or be a part of another, has papers beside it.
bool HasPapers(const RecordOptions& options, const FilmPlan& plan)
{
    return plan.groupFrames > 0 && options.output != "-" && plan.frames.IsWhole();
}

/// One run of the command.
class FilmRun
{
public:
    FilmRun(const RecordOptions& options, FilmPlan plan)
        : m_options(options), m_plan(std::move(plan)), m_progress(options.progress)
    {}

    Result<int> Make(SceneSource source);

private:
    Result<void> OpenPapers();
    Result<void> Open(SceneSource source);
    Result<RecordingEnd> Film();
    Result<void> Fill(std::int64_t frame, FrameContent& content);
    Result<void> NoteState(std::int64_t number);
    void See(std::int64_t frame, const Frame& pixels);
    Result<int> Stopped(std::int64_t framesDone);
    Result<int> Finished();
    Result<void> FinishPapers();
    Result<void> WriteThumbnail();
    void AdvanceTo(std::int64_t number);
    std::int64_t StepOf(std::int64_t number) const;
    std::int64_t ThumbnailFrame() const;
    std::filesystem::path Part() const { return PartPath(m_options.output); }

    const RecordOptions& m_options;
    FilmPlan m_plan;
    Progress m_progress;
    bool m_hasPapers = false;
    FilmPapers m_papers;
    FilmPapers m_left; // of the run before
    std::optional<VideoWriter> m_writer;
    std::optional<Renderer> m_renderer;
    std::optional<SceneSession> m_session;
    FrameClock m_clock;
    std::int64_t m_resumed = 0;      // frames that were there
    std::int64_t m_filmed = 0;       // and how many there are in the end
    std::int64_t m_encoded = 0;      // in this run
    bool m_hasEndedByItself = false; // a condition held
    Frame m_thumbnail;
};

std::int64_t FilmRun::StepOf(std::int64_t number) const
{
    return StepAt(m_options.from.value_or(Duration{}), m_session->StepsPerSecond()) +
           m_clock.StepOfFrame(number);
}

/// A simulation of many steps a frame is left between two of them when a signal asks for it.
void FilmRun::AdvanceTo(std::int64_t number)
{
    const std::int64_t step = StepOf(number);
    while (m_session->Step() < step && StopSignals::Caught() == 0)
    {
        m_session->AdvanceTo(m_session->Step() + 1);
    }
}

/// What was left is gone on with only if it is the same film.
Result<void> FilmRun::OpenPapers()
{
    m_hasPapers = HasPapers(m_options, m_plan);
    m_papers = {.version = BOXREEL_VERSION,
                .command = CommandOfFilm(m_options.arguments),
                .framesPerSecond = m_plan.film.framesPerSecond,
                .groupFrames = m_plan.groupFrames,
                .plays = m_plan.film.plays,
                .frameCount = m_plan.frameCount,
                .first = m_plan.frames.First(),
                .end = m_plan.frames.Last() + 1,
                .states = {}};
    std::error_code ignored;
    const bool isLeft = std::filesystem::exists(PapersPath(Part()), ignored) ||
                        std::filesystem::exists(Part(), ignored);
    if (!m_plan.film.resume || !isLeft)
    {
        m_plan.film.resume = false; // it is begun
        return {};
    }
    Result<FilmPapers> left = ReadPapers(Part(), "begin anew with --force");
    if (!left)
    {
        return left.GetError();
    }
    const std::string difference = DifferenceOf(*left, m_papers);
    if (!difference.empty() || left->first != m_papers.first)
    {
        return Error{ErrorKind::Unusable,
                     Part().string() + " is left of another film (" +
                         (difference.empty() ? "it begins with another frame" : difference) +
                         "); give the same command, or begin anew with --force."};
    }
    m_left = std::move(*left);
    return {};
}

Result<void> FilmRun::Open(SceneSource source)
{
    if (Result<void> opened = OpenPapers(); !opened)
    {
        return opened;
    }
    Result<Renderer> renderer = Renderer::Create({.width = m_options.look.width,
                                                  .height = m_options.look.height,
                                                  .theme = m_options.look.theme,
                                                  .backend = m_options.backend});
    if (!renderer)
    {
        return renderer.GetError();
    }
    m_renderer.emplace(std::move(*renderer));
    Result<SceneSession> session = SceneSession::Open(std::move(source), m_options.look);
    if (!session)
    {
        return session.GetError();
    }
    m_session.emplace(std::move(*session));
    // The last, for a writer that goes on with what was left takes that with it when it is given
    // up.
    Result<VideoWriter> writer = VideoWriter::Open(m_options.output, m_plan.film);
    if (!writer)
    {
        return writer.GetError();
    }
    m_resumed = m_filmed = writer->ResumedFrames();
    m_writer.emplace(std::move(*writer));
    m_clock = {m_plan.film.framesPerSecond, m_session->StepsPerSecond(), m_options.speed};
    return {};
}

/// Where the film may be continued or joined, the state of the world goes into its papers.
Result<void> FilmRun::NoteState(std::int64_t number)
{
    if (!m_hasPapers || (number % m_plan.groupFrames != 0 && number != m_papers.first))
    {
        return {};
    }
    const std::string state = StateHashText(m_session->World());
    const auto left = m_left.states.find(number);
    if (left != m_left.states.end() && left->second != state)
    {
        return Error{ErrorKind::Unusable,
                     "Frame " + std::to_string(number) + " shows another state than when " +
                         Part().string() +
                         " was made, by another build of this program; begin anew with --force."};
    }
    m_papers.states[number] = state;
    return WritePapers(Part(), m_papers);
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
    if (Result<void> noted = NoteState(number); !noted)
    {
        return noted;
    }
    m_session->Fill(content);
    for (const Condition& condition : m_options.until)
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
    return m_options.thumbnailAt ? FramesIn(*m_options.thumbnailAt, m_plan.film.framesPerSecond)
                                 : m_plan.frames.Count() / 2;
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
    RecordingSettings settings;
    settings.frameCount = m_plan.frames.Count() - m_resumed;
    settings.fill = [this](std::int64_t frame, FrameContent& content) {
        return Fill(frame, content);
    };
    settings.progress = [this](RecordingProgress now) {
        m_encoded = now.framesDone;
        now.framesDone += m_resumed;
        now.framesTotal += m_resumed;
        m_progress.Update(now);
        return StopSignals::Caught() == 0;
    };
    if (!m_options.thumbnail.empty())
    {
        settings.seen = [this](std::int64_t frame, const Frame& pixels) { See(frame, pixels); };
    }
    return Record(settings, *m_renderer, *m_writer);
}

/// What there is stays, can be played, and can be continued.
Result<int> FilmRun::Stopped(std::int64_t framesDone)
{
    m_progress.Clear();
    if (m_options.output == "-")
    {
        WriteMessage("boxreel: Stopped.");
        return kStoppedCode;
    }
    if (framesDone == 0)
    {
        WriteMessage("boxreel: Stopped before the first frame.");
        return kStoppedCode;
    }
    if (Result<void> suspended = m_writer->Suspend(); !suspended)
    {
        return suspended.GetError();
    }
    const bool isSequence = !m_hasPapers ? false : !std::filesystem::exists(Part());
    WriteMessage("boxreel: Stopped after " + std::to_string(m_resumed + framesDone) + " frames; " +
                 (isSequence ? "they" : Part().string()) + " can be looked at" +
                 (m_hasPapers ? ", and the same command with --resume goes on." : "."));
    return kStoppedCode;
}

/// A part keeps its papers, a whole film needs none.
Result<void> FilmRun::FinishPapers()
{
    std::error_code ignored;
    std::filesystem::remove(PapersPath(Part()), ignored);
    if (m_hasPapers && m_options.range)
    {
        m_papers.end = m_plan.frames.First() + m_filmed;
        m_session->AdvanceTo(StepOf(m_papers.end));
        m_papers.states[m_papers.end] = StateHashText(m_session->World());
        if (Result<void> written = WritePapers(m_options.output, m_papers); !written)
        {
            return written;
        }
    }
    return {};
}

Result<void> FilmRun::WriteThumbnail()
{
    if (m_options.thumbnail.empty())
    {
        return {};
    }
    if (m_thumbnail.rgba.empty()) // the film ended earlier: its last frame
    {
        if (Result<void> read = m_renderer->Read(m_thumbnail); !read)
        {
            return read;
        }
    }
    return WritePng(m_options.thumbnail, m_thumbnail, {.overwrite = m_plan.film.overwrite});
}

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

Result<int> FilmRun::Finished()
{
    if (Result<void> finished = FinishPapers(); !finished)
    {
        return finished.GetError();
    }
    if (Result<void> written = WriteThumbnail(); !written)
    {
        return written.GetError();
    }
    m_progress.Finish(ReportOf(m_options, m_filmed, m_progress.Seconds()));
    if (!m_options.until.empty() && !m_hasEndedByItself)
    {
        WriteMessage("boxreel: What the film waited for did not come within " +
                     std::to_string(m_filmed) + " frames.");
    }
    // A film in which what the camera waits for has never come is a film all the same.
    if (const Result<void> met = m_session->CheckView(); !met)
    {
        WriteMessage("boxreel: " + met.GetError().message);
    }
    if (m_options.stats)
    {
        WriteMessage(DescribeDrawing(m_renderer->Totals()));
    }
    return 0;
}

Result<int> FilmRun::Make(SceneSource source)
{
    if (Result<void> opened = Open(std::move(source)); !opened)
    {
        return opened.GetError();
    }
    const Result<RecordingEnd> end = Film();
    if (!end)
    {
        m_progress.Clear();
        std::error_code ignored;
        std::filesystem::remove(PapersPath(Part()), ignored);
        return end.GetError();
    }
    return *end == RecordingEnd::Stopped ? Stopped(m_encoded) : Finished();
}

Result<int> MakeFilm(const RecordOptions& options)
{
    Result<FilmPlan> plan = Plan(options);
    if (!plan)
    {
        return plan.GetError();
    }
    if (!options.thumbnail.empty())
    {
        const Result<void> usable = CheckPicturePath(options.thumbnail, options.film.overwrite);
        if (!usable)
        {
            return usable.GetError();
        }
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
    return FilmRun(options, std::move(*plan)).Make(std::move(*source));
}

} // namespace

Result<int> RunRecord(const RecordOptions& options)
{
    const Result<int> code = MakeFilm(options);
    if (!code && options.progress == ProgressMode::OpenJD)
    {
        const Result<void> said = WriteOutput("openjd_fail: " + code.GetError().message + "\n");
        if (!said)
        {
            return said.GetError();
        }
    }
    return code;
}

} // namespace boxreel
