// SPDX-License-Identifier: MIT
#pragma once

#include "FilmManifest.h"
#include "FilmSimulation.h"
#include "FilmThumbnail.h"
#include "StageReport.h"

#include <base/AtomicFile.h>
#include <render/Renderer.h>

/// One recording. It simulates the scene, draws and encodes the frames, and writes the accompanying
/// files (manifest, thumbnail, reports). There is one StopSignals while it runs.
namespace boxreel
{

class FilmRun
{
public:
    /// `snapshots`: where the simulation may begin, and leaves its states; null: nowhere.
    FilmRun(const RecordOptions& options, FilmPlan plan, SnapshotFolder* snapshots)
        : m_options(options), m_plan(std::move(plan)), m_progress(options.messages.progress),
          m_manifest(m_options, m_plan), m_thumbnail(m_options, m_plan),
          m_simulation(m_options, snapshots, m_progress, Stages())
    {}
    FilmRun(const FilmRun&) = delete; // its parts know it
    FilmRun& operator=(const FilmRun&) = delete;

    /// The exit code.
    Result<int> Make(SceneSource source);

private:
    Result<void> Open(SceneSource source);
    Result<RecordingEnd> Film();
    Result<void> Fill(std::int64_t frame, FrameContent& content);
    Result<int> Stopped(std::int64_t framesDone);
    Result<int> Finished();
    Result<void> FinishManifest();
    void Abandon();
    /// Its frame is one of those that another run has filmed.
    bool IsThumbnailThere() const
    {
        return m_thumbnail.IsWanted() && m_thumbnail.Index() < m_resumed;
    }
    Result<void> DrawThumbnail();
    /// Stages are timed only with --stats.
    StageTimes* Stages() { return m_options.messages.stats ? &m_stages : nullptr; }
    std::string StageText() const;

    const RecordOptions& m_options;
    FilmPlan m_plan;
    Progress m_progress;
    StageTimes m_stages;
    FilmManifest m_manifest;
    FilmThumbnail m_thumbnail;
    FilmSimulation m_simulation;
    ProcessTime m_before; // when the first frame was begun
    std::optional<VideoWriter> m_writer;
    std::optional<Renderer> m_renderer;
    std::int64_t m_resumed = 0; // frames that were there
    std::int64_t m_filmed = 0;  // and how many there are in the end
    std::int64_t m_encoded = 0; // in this run
};

} // namespace boxreel
