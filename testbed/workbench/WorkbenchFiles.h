// SPDX-License-Identifier: MIT
#pragma once

#include "SceneWork.h"

#include <recorder/Recording.h>
#include <render/Backend.h>

#include <cstdint>
#include <filesystem>
#include <string>

/// The files that the buttons of a workbench write: films and figures of a scene, each with a
/// script that makes it again.
namespace boxreel
{

/// The look of films and figures, and their folder.
struct WorkbenchOutput
{
    std::filesystem::path into; ///< a folder; empty: the current one
    Backend backend = Backend::Auto;
    Theme theme;
    PanelChoices choices; ///< the layers, by name
};

/// "pyramid-1.mp4": the first number that is not taken.
std::filesystem::path FreeName(const std::filesystem::path& folder, const std::string& title,
                               const std::string& extension);

/// Writes a figure of this moment and logs it; returns its name.
Result<std::filesystem::path> WritePicture(SceneWork& work, const WorkbenchOutput& output,
                                           const std::string& extension);

/// A film of what follows.
class WorkbenchFilm
{
public:
    /// Without a frame yet.
    static Result<WorkbenchFilm> Open(const SceneWork& work, const WorkbenchOutput& output);

    const std::filesystem::path& Path() const { return m_path; }
    double Seconds(const SceneWork& work) const; ///< simulated length of the film [s]
    /// True if this moment is one of its frames.
    bool HasFrameAt(std::int64_t sceneStep) const { return (sceneStep - m_first) % m_every == 0; }

    /// This moment, with the pixels that the window shows, less an odd row or column. False: it
    /// cannot go on, and Close says why.
    bool Add(SceneWork& work, const Overlay& panels);

    /// Logs it, too.
    Result<void> Close(SceneWork& work, const PanelChoices& choices);

private:
    WorkbenchFilm(Recording film, std::filesystem::path path)
        : m_film(std::move(film)), m_path(std::move(path))
    {}

    Recording m_film;
    std::filesystem::path m_path;
    std::int64_t m_first = 0; // step of the scene
    std::int64_t m_frames = 0;
    int m_every = 1; // steps a frame
    int m_width = 0;
    int m_height = 0;
    bool m_hasPanels = false;
};

} // namespace boxreel
