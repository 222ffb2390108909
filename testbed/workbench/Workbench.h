// SPDX-License-Identifier: MIT
#pragma once

#include "WorkbenchLog.h"

#include <recorder/Recording.h>
#include <render/Window.h>
#include <session/SessionPanels.h>

#include <filesystem>
#include <optional>
#include <set>

/// A scene at which a person works: it goes on in real time, mouse and keyboard pull and steer it,
/// panels change how it is stepped and drawn, buttons make films, figures and scripts of it. Gets a
/// window's events and gives the pictures; knows no window itself.
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

    /// So much time has passed [s]: as many steps are simulated as fit in, but at most those of a
    /// tenth of a second, so that a slow machine is slow instead of stuck.
    void Advance(double seconds);

    /// What the window shows. Expects an empty content.
    void Fill(FrameContent& content);

    void Resize(int width, int height); ///< of the picture [px], with the scale in it

    bool IsDone() const { return m_isDone; }
    /// Nothing happens unless somebody does something.
    bool IsResting() const { return m_choices.isPaused; }
    const PanelChoices& Choices() const { return m_choices; }
    SceneSession& Session() { return *m_session; }
    Panels& Controls() { return *m_panels; }
    const std::string& SceneAsked() const { return m_session->Asked(); }
    const std::set<std::string>& OpenSections() const
    {
        return m_panels->Controls().OpenSections();
    }
    const std::string& Message() const { return m_message; } ///< what was done last

    /// "Pyramid: step 412, state 0123456789abcdef".
    std::string Summary() const;

    /// Ends a film that is being made. What has been written stays.
    Result<void> Finish();

private:
    /// What the mouse's button that is down does.
    enum class Hold
    {
        Nothing,
        Panels,
        Scene,
        View,
        Bomb,
    };

    Workbench() = default;
    void BeginScene();
    void Set(const std::string& name, const std::string& value);
    void Change(const std::string& scene, bool isOther);
    void ChangeBy(int places);
    void Tick();
    void BuildPanels(const PanelInput& input);
    void ApplyChoices(const PanelChoices& before);
    void SettlePicker();
    void Cover();
    void Wish(PanelWish wish);
    void Press(const WindowEvent& event);
    void Release(const WindowEvent& event);
    void Move(const WindowEvent& event);
    void DropAt(Vec2 pixel);
    void Turn(const WindowEvent& event);
    void KeyDown(const WindowEvent& event);
    void KeyUp(Key key);
    void LetGo();
    bool Shortcut(const WindowEvent& event);
    bool Steer(const WindowEvent& event);
    void Shift(float32 x, float32 y);
    void Zoom(double factor, Vec2 about);
    void Pan(double x, double y);
    void Do(const ScriptAction& action);
    void AddSling(DrawList& list) const;
    b2Vec2 WorldAt(Vec2 pixel) const;
    Camera View() const;
    Camera Uncovered() const;
    void Film();
    void FilmFrame();
    void Picture(const std::string& extension);
    void SaveScript();
    std::filesystem::path FreeName(const std::string& extension) const;
    std::vector<std::string> PictureOptions() const;
    void Say(const std::string& message) { m_message = message; }

    WorkbenchSettings m_settings;
    std::optional<SceneSession> m_session;
    std::optional<Panels> m_panels;
    PanelChoices m_choices;
    SolverChoices m_preferred; // the scene's own
    PanelInput m_input;        // as the last event left it
    std::set<Key> m_sceneKeys; // that are down
    Hold m_hold = Hold::Nothing;
    int m_heldButton = 0;
    Vec2 m_heldAt{0.0f, 0.0f}; // where it went down, or was last [px]
    b2Vec2 m_slingFrom{0.0f, 0.0f};
    double m_owed = 0.0;    // time that no step has been simulated for [s]
    double m_elapsed = 0.0; // since the last frame of the panels [s]
    bool m_isDone = false;
    std::string m_message;
    WorkbenchLog m_log;
    std::optional<Recording> m_film;
    std::filesystem::path m_filmPath;
    std::int64_t m_filmFirst = 0; // step
    std::int64_t m_filmFrames = 0;
    int m_filmEvery = 1; // steps a frame
    int m_filmWidth = 0;
    int m_filmHeight = 0;
    bool m_filmHasPanels = false;
};

} // namespace boxreel
