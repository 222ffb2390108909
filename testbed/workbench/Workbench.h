// SPDX-License-Identifier: MIT
#pragma once

#include "SceneHand.h"
#include "SceneWork.h"
#include "WorkbenchFiles.h"

#include <render/Window.h>
#include <session/SessionPanels.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>

/// An interactive scene. It runs in real time, mouse and keyboard control it, panels change its
/// solver and its look, and buttons make films, figures and scripts. Gets the events of a window
/// and returns the pictures; does not depend on a window.
namespace boxreel
{

struct WorkbenchSettings
{
    SceneLook look;             ///< its size is the window's, at scale 1
    PanelChoices choices;       ///< to begin with
    bool keepsChoices = false;  ///< the choices of the solver are to be used for the first scene
    std::filesystem::path into; ///< a folder for what buttons write; empty: the current one
    Backend backend = Backend::Auto; ///< that draws films and figures
};

class Workbench
{
public:
    static Result<Workbench> Open(SceneSource source, const WorkbenchSettings& settings);

    void Handle(const WindowEvent& event);

    /// Simulates the steps of an elapsed time [s], but at most those of a tenth of a second. A slow
    /// machine is then slow instead of stuck.
    void Advance(double seconds);

    /// Adds the content of the window. Expects an empty content.
    void Fill(FrameContent& content);

    void Resize(int width, int height); ///< of the picture [px], with the scale in it

    bool IsDone() const { return m_isDone; }
    /// True while paused: only user input changes the picture.
    bool IsResting() const { return m_choices.isPaused; }
    const PanelChoices& Choices() const { return m_choices; }
    SceneSession& Session() { return m_work.Session(); }
    Panels& Controls() { return m_panels; }
    const std::string& SceneAsked() const { return m_work.Session().Asked(); }
    const std::set<std::string>& OpenSections() const { return m_panels.Controls().OpenSections(); }
    const std::string& Message() const { return m_message; } ///< the result of the last action

    /// "Pyramid: step 412, state 0123456789abcdef".
    std::string Summary() const;

    /// Ends a recording. The written file is kept.
    Result<void> Finish();

private:
    Workbench(SceneSession session, Panels panels, const WorkbenchSettings& settings)
        : m_settings(settings), m_work(std::move(session)), m_panels(std::move(panels)),
          m_choices(settings.choices)
    {}
    void BeginScene();
    void Change(const std::string& scene, bool isOther);
    void ChangeBy(int places);
    void Tick();
    void BuildPanels(const PanelInput& input);
    void ApplyChoices(const PanelChoices& before);
    void SettlePicker();
    void Cover();
    void Wish(PanelWish wish);
    void Button(const WindowEvent& event, bool isDown);
    void Turn(const WindowEvent& event);
    void KeyDown(const WindowEvent& event);
    void KeyUp(Key key);
    void LetGo();
    bool Shortcut(const WindowEvent& event);
    bool Steer(const WindowEvent& event);
    WorkbenchOutput Output() const;
    void Film();
    void FilmFrame();
    void Picture(const std::string& extension);
    void SaveScript();
    void Say(const std::string& message) { m_message = message; }

    WorkbenchSettings m_settings;
    SceneWork m_work;
    SceneHand m_hand;
    Panels m_panels;
    PanelChoices m_choices;
    PanelInput m_input; // as the last event left it
    std::optional<WorkbenchFilm> m_film;
    double m_owed = 0.0;    // time that no step has been simulated for [s]
    double m_elapsed = 0.0; // since the last frame of the panels [s]
    bool m_isDone = false;
    std::string m_message;
};

} // namespace boxreel
