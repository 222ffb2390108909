// SPDX-License-Identifier: MIT
#include "PageRun.h"
#include "FilmSimulation.h"
#include "StopSignals.h"

#include <base/AtomicFile.h>
#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Words.h>
#include <debugdraw/WorldGlyphs.h>
#include <page/PageWriter.h>

#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

PageSettings SettingsOf(const RecordOptions& options, const std::string& title)
{
    PageSettings settings;
    settings.width = options.look.width;
    settings.height = options.look.height;
    settings.framesPerSecond = options.film.framesPerSecond.ToDouble();
    settings.speed = options.pace.speed.ToDouble();
    settings.firstTime = double(options.length.from.value_or(Duration{}).nanoseconds) * 1e-9;
    settings.title = title;
    settings.theme = options.look.theme;
    settings.shown = options.look.layers;
    settings.shown[DrawLayer::Labels] = settings.shown[DrawLayer::Labels] || options.look.labels;
    settings.overwrite = options.film.overwrite;
    return settings;
}

std::vector<PageBody> BodiesOf(SceneSession& session)
{
    std::vector<PageBody> bodies;
    session.AtShownPoses([&] {
        for (const b2Body* b = session.World().GetBodyList(); b != nullptr; b = b->GetNext())
        {
            const auto number = std::uint32_t(b->GetNumber());
            const auto name = session.Names().find(number);
            bodies.push_back({.number = number,
                              .position = {b->GetPosition().x, b->GetPosition().y},
                              .angle = b->GetAngle(),
                              .name = name != session.Names().end() ? name->second : "",
                              .velocity = {b->GetLinearVelocity().x, b->GetLinearVelocity().y},
                              .spin = b->GetAngularVelocity()});
        }
    });
    return bodies;
}

/// Returns the anchors of the signs of joints in a frame, if it shows these.
std::vector<Vec2> AnchorsOf(SceneSession& session, const SceneLook& look, const Camera& camera)
{
    std::vector<Vec2> anchors;
    if (look.layers[DrawLayer::JointGlyphs])
    {
        session.AtShownPoses([&] {
            anchors = JointGlyphAnchors(session.World(), ViewOfEverything(camera), kPageZoom);
        });
    }
    return anchors;
}

FilmReport ReportOf(const RecordOptions& options, std::int64_t frames, double seconds)
{
    FilmReport report;
    report.file = options.output;
    report.frames = report.framesFilmed = frames;
    report.width = options.look.width;
    report.height = options.look.height;
    report.framesPerSecond = options.film.framesPerSecond.ToDouble();
    report.seconds = seconds;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(options.output, error);
    report.bytes = error ? -1 : static_cast<std::int64_t>(bytes);
    return report;
}

/// How a page has ended.
struct WrittenFrames
{
    std::int64_t count = 0;
    bool isStopped = false; ///< by a signal
};

/// Appends all frames, unless a signal asks for a stop.
Result<WrittenFrames> WriteFrames(std::int64_t count, const SceneLook& look,
                                  FilmSimulation& simulation, PageWriter& writer,
                                  Progress& progress)
{
    for (std::int64_t frame = 0; frame < count; ++frame)
    {
        if (!simulation.AdvanceTo(frame))
        {
            return WrittenFrames{frame, true};
        }
        FrameContent content;
        simulation.Fill(content);
        RETURN_IF_ERROR(writer.Append(content.list, content.camera, BodiesOf(simulation.Session()),
                                      AnchorsOf(simulation.Session(), look, content.camera)));
        progress.Update({.framesDone = frame + 1, .framesTotal = count});
        if (simulation.IsAtEnd())
        {
            return WrittenFrames{frame + 1};
        }
    }
    return WrittenFrames{count};
}

/// Keeps the frames so far as a page of its own, as a stopped film does.
Result<int> Stopped(const RecordOptions& options, std::int64_t frames, PageWriter& writer,
                    Progress& progress)
{
    if (frames == 0)
    {
        progress.Stop("Stopped before the first frame.");
        return StopSignals::kExitCode;
    }
    RETURN_IF_ERROR(writer.Suspend());
    progress.Stop("Stopped after " + Counted(frames, "frame") + "; " +
                  PartPath(options.output).string() + " can be looked at.");
    return StopSignals::kExitCode;
}

} // namespace

bool IsPage(const std::filesystem::path& path)
{
    return Lower(path.extension().string()) == ".html";
}

Result<void> CheckPage(const RecordOptions& options)
{
    const VideoSettings& film = options.film;
    const VideoSettings usual;
    const std::pair<const char*, bool> ofFilms[] = {
        {"--resume", film.resume},
        {"--skip-done", options.skipDone},
        {"--stats", options.messages.stats},
        {"--frame-range", options.length.range.has_value()},
        {"--thumbnail", !options.thumbnail.file.empty()},
        {"--quality", film.quality != usual.quality},
        {"--codec", !film.codec.empty()},
        {"--chroma", film.chroma != usual.chroma},
        {"--codec-option", !film.codecOptions.empty()},
        {"--format", !film.format.empty()},
        {"--loop", film.plays != usual.plays},
        {"--group", film.groupFrames != usual.groupFrames},
        {"--constant-rate", film.timing == FrameTiming::Constant},
        {"--variable-rate", film.timing == FrameTiming::Variable},
        {"--threads", film.threads != usual.threads},
        {"--hud-ms", options.look.panels.milliseconds},
        {"--hud", options.look.panels.hud},
        {"--backend", options.backend != Backend::Auto},
        {"--ui", options.look.panels.testbed},
    };
    for (const auto& [option, isGiven] : ofFilms)
    {
        if (isGiven)
        {
            return Error{ErrorKind::Unusable, option, "applies to films, and .html is a page",
                         "remove it, or write .mp4"};
        }
    }
    return {};
}

Result<int> MakePage(const RecordOptions& options, const FilmPlan& plan, SnapshotFolder* snapshots,
                     SceneSource source)
{
    RecordOptions asked = options;
    asked.look.collectEverything = true; // the reader may pan to it
    asked.look.zoom = kPageZoom;
    Progress progress(options.messages.progress);
    FilmSimulation simulation(asked, snapshots, progress, nullptr);
    RETURN_IF_ERROR(simulation.Open(std::move(source)));
    ASSIGN_OR_RETURN(
        PageWriter writer,
        PageWriter::Open(options.output, SettingsOf(options, simulation.Session().Title())));
    simulation.TellMissingBodies();
    simulation.Begin(0);
    const Result<WrittenFrames> written =
        WriteFrames(plan.frameCount, asked.look, simulation, writer, progress);
    if (!written)
    {
        progress.Clear();
        return written.GetError();
    }
    if (written->isStopped)
    {
        return Stopped(options, written->count, writer, progress);
    }
    RETURN_IF_ERROR(writer.Close());
    progress.Finish(ReportOf(options, written->count, progress.Seconds()));
    return simulation.Conclude(written->count);
}

} // namespace boxreel
