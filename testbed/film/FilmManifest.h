// SPDX-License-Identifier: MIT
#pragma once

#include "FilmPlan.h"
#include "Manifest.h"

class b2World;

/// The manifest of the film that is being made: what another run has left is checked, states are
/// noted where the film may be continued or joined.
namespace boxreel
{

class FilmManifest
{
public:
    /// Both are borrowed.
    FilmManifest(const RecordOptions& options, const FilmPlan& plan);

    /// Reads what a stopped run has left. False: there is nothing, or the film is to be begun; an
    /// Error (Unusable, Failed) when it cannot be continued.
    Result<bool> FindLeft();

    /// True if this film has a manifest.
    bool IsKept() const { return m_isKept; }

    /// Before frame `number` is drawn. Unusable when the run before had another state there.
    Result<void> Note(std::int64_t number, const b2World& world);

    /// Writes the manifest of the closed part, which ends before frame `end`. That frame shows
    /// `world`.
    Result<void> Complete(std::int64_t end, const b2World& world);

    /// Removes the manifest of the unfinished film.
    void Remove() const;

private:
    const RecordOptions& m_options;
    const FilmPlan& m_plan;
    std::filesystem::path m_first; // the film, or its first picture
    bool m_isKept;
    Manifest m_manifest;
    Manifest m_left; // of the run before
};

} // namespace boxreel
