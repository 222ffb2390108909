// SPDX-License-Identifier: MIT
#pragma once

#include "SceneSession.h"

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

/// A folder in which runs of a film save the state of their simulation at intervals. Other runs
/// then do not need to simulate the steps before their first frame. Any number of runs, also of
/// other films, may use it at the same time. All files are optional: if one is missing or unusable,
/// its steps are simulated. Used by record.
namespace boxreel
{

/// Returns true if the state after this many steps is saved. With `every`, that is each multiple of
/// it. Without, it is every 100 steps. From step 3,200 on, the gaps grow up to a sixteenth of the
/// elapsed steps, so the number of files grows with the logarithm of the film's length.
bool IsSnapshotDue(std::int64_t step, std::optional<std::int64_t> every);

class SnapshotFolder
{
public:
    /// Creates the folder if it does not exist. Removes incomplete files of killed runs on this
    /// machine. Failed if the folder does not accept files.
    static Result<SnapshotFolder> Open(const std::filesystem::path& folder,
                                       std::optional<std::int64_t> every);

    /// For a session before its first step: restores the newest stored state at or before `latest`.
    /// Reports each invalid state file once on standard error.
    void Begin(SceneSession& session, std::int64_t latest);

    /// After each step: saves the state when it is due and not there. A folder that takes no more
    /// is said once, and no reason to end the film.
    void Offer(SceneSession& session);

private:
    SnapshotFolder(std::filesystem::path folder, std::optional<std::int64_t> every)
        : m_folder(std::move(folder)), m_every(every)
    {}
    std::filesystem::path PathOf(std::int64_t step) const;
    std::set<std::int64_t> Steps() const;
    std::string Heading(std::int64_t step) const;
    std::string WhyNot(SceneSession& session, std::int64_t step) const;
    Result<void> Write(SceneSession& session) const;

    std::filesystem::path m_folder;
    std::optional<std::int64_t> m_every;
    std::string m_origin;            // what the states are of
    std::string m_name;              // of its files, but for the step
    std::set<std::int64_t> m_broken; // steps whose files are written again
    bool m_isFull = false;           // takes no more
};

} // namespace boxreel
