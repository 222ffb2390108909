// SPDX-License-Identifier: MIT
#pragma once

#include "Progress.h"
#include "RecordOptions.h"
#include "RenderReport.h"

#include <session/SnapshotFolder.h>

/// The scene of a film: which step a frame shows, and the simulation up to there. May begin with a
/// state that another run has left.
namespace boxreel
{

class FilmSimulation
{
public:
    /// All are borrowed; `snapshots` and `stages` may be null.
    FilmSimulation(const RecordOptions& options, SnapshotFolder* snapshots, Progress& progress,
                   StageTimes* stages)
        : m_options(options), m_snapshots(snapshots), m_progress(progress), m_stages(stages)
    {}

    Result<void> Open(SceneSource source);

    /// `number`: of the first frame that is wanted.
    void Begin(std::int64_t number);

    /// Simulates up to this frame. Returns false if a signal requests a stop, even between two
    /// steps.
    bool AdvanceTo(std::int64_t number);

    /// Same as AdvanceTo, but ignores stop signals.
    void FinishAt(std::int64_t number);

    void Fill(FrameContent& content);

    /// What --until waits for and the scene does not have, on standard error: it may yet make it.
    void TellMissingBodies() const;

    /// A condition of --until is true.
    bool IsAtEnd() const;

    /// What is shown lies between two steps.
    bool IsBetweenSteps() const { return m_isBetween; }

    /// Says on standard error what the film has missed, after its last frame. Returns the exit
    /// code, or the Error of what goes along: the film is there, not what was asked.
    Result<int> Conclude(std::int64_t frames) const;

    SceneSession& Session() { return *m_session; }
    SimulationTotals Totals() const;

private:
    std::int64_t StepOf(std::int64_t number) const;
    void Step();
    void Show(std::int64_t number);

    const RecordOptions& m_options;
    SnapshotFolder* m_snapshots;
    Progress& m_progress;
    StageTimes* m_stages;
    std::optional<SceneSession> m_session;
    FrameClock m_clock;
    bool m_isBetween = false;
    std::int64_t m_firstStep = 0; // from which on there was something to simulate
};

} // namespace boxreel
