// SPDX-License-Identifier: MIT
#pragma once

#include "FilmPlan.h"
#include "Manifest.h"
#include "RenderReport.h"
#include "StageReport.h"

#include <base/AtomicFile.h>
#include <render/Renderer.h>
#include <session/SnapshotFolder.h>

/// One recording: the scene is simulated, its frames drawn and encoded, and what is beside the film
/// (manifest, thumbnail, reports) written. While it runs there is one StopSignals.
namespace boxreel
{

class FilmRun
{
public:
    /// `snapshots`: where the simulation may begin, and leaves its states; null: nowhere.
    FilmRun(const RecordOptions& options, FilmPlan plan, SnapshotFolder* snapshots)
        : m_options(options), m_plan(std::move(plan)), m_snapshots(snapshots),
          m_progress(options.messages.progress)
    {}

    /// The exit code.
    Result<int> Make(SceneSource source);

private:
    Result<void> OpenManifest();
    Result<void> Open(SceneSource source);
    Result<RecordingEnd> Film();
    Result<void> Fill(std::int64_t frame, FrameContent& content);
    Result<void> NoteState(std::int64_t number);
    void See(std::int64_t frame, const Frame& pixels);
    Result<int> Stopped(std::int64_t framesDone);
    Result<int> Finished();
    void Abandon();
    void RemoveManifest();
    Result<void> FinishManifest();
    Result<void> WriteThumbnail();
    void BeginSimulation();
    void Step();
    void AdvanceTo(std::int64_t number);
    void Show(std::int64_t number);
    void Collect(FrameContent& content);
    SimulationTotals Simulated() const;
    std::int64_t StepOf(std::int64_t number) const;
    Result<void> DrawThumbnail();
    /// Counted from the first that is filmed.
    std::int64_t ThumbnailFrame() const;
    bool ThumbnailIsThere() const;
    /// Nobody is timed unless the figures are asked for.
    StageTimes* Stages() { return m_options.messages.stats ? &m_stages : nullptr; }
    std::string StageText() const;
    std::filesystem::path Part() const { return PartPath(m_options.output); }

    const RecordOptions& m_options;
    FilmPlan m_plan;
    SnapshotFolder* m_snapshots;
    Progress m_progress;
    StageTimes m_stages;
    ProcessTime m_before; // when the first frame was begun
    bool m_hasManifest = false;
    Manifest m_manifest;
    Manifest m_left; // of the run before
    std::optional<VideoWriter> m_writer;
    std::optional<Renderer> m_renderer;
    std::optional<SceneSession> m_session;
    FrameClock m_clock;
    std::int64_t m_firstStep = 0;    // from which on there was something to simulate
    std::int64_t m_resumed = 0;      // frames that were there
    std::int64_t m_filmed = 0;       // and how many there are in the end
    std::int64_t m_encoded = 0;      // in this run
    bool m_hasEndedByItself = false; // a condition held
    Frame m_thumbnail;
};

} // namespace boxreel
