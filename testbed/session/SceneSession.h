// SPDX-License-Identifier: MIT
#pragma once

#include "SceneCamera.h"
#include "SceneSearch.h"

#include <base/Result.h>
#include <debugdraw/Theme.h>
#include <options/SceneLayers.h>
#include <recorder/FrameClock.h>
#include <recorder/Recording.h>
#include <render/Overlay.h>
#include <script/ScriptInput.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// A scene that is simulated step by step, with a camera and a panel. Films, stills and golden
/// candidates are all made by it, so a still equals the film's frame of that time. It does not use
/// files, does not draw pixels, and never prints.
namespace boxreel
{

/// How a scene is simulated.
struct SimulationChoices
{
    std::optional<Rational> stepsPerSecond; ///< none of these three: as the scene prefers,
    std::optional<int> velocityIterations;  ///< which is 60, 8 and 3 unless it says otherwise
    std::optional<int> positionIterations;
    std::uint32_t seed = 1;
    std::shared_ptr<const Script> script; ///< whose actions are done to it; null: none
};

/// What stands over the picture.
struct PanelLook
{
    bool hud = false;          ///< time, step and counts
    bool testbed = false;      ///< the panels of the testbed's window
    bool milliseconds = false; ///< also the time a step took, which no two runs share
    int covered = 0;           ///< of the picture's right side: views keep clear of it [px]
};

/// The settings of a scene's simulation and picture.
struct SceneLook
{
    int width = 1280;   ///< [px]
    int height = 720;   ///< [px]
    double scale = 1.0; ///< of all lengths in pixels, width and height too
    Theme theme = Theme::Classic();
    SimulationChoices simulation;
    ViewChoice view;
    LayerSet layers;
    ArrowScales arrows;
    /// Also collects items outside of the picture, for lists that are stored and compared.
    bool collectEverything = false;
    double zoom = 1.0;   ///< of View: by how much a viewer may enlarge what is collected
    bool labels = false; ///< the number of each body at its centre of mass
    PanelLook panels;
};

class SceneSession;

/// An observer that accompanies a session and may change it between two steps, such as panels that
/// a script clicks.
class SessionCompanion
{
public:
    virtual ~SessionCompanion() = default;
    /// `actions`: what the script does with the panels before this step.
    virtual void BeforeStep(SceneSession& session, const std::vector<ScriptAction>& actions) = 0;
    virtual void AfterStep(SceneSession& session) = 0;
    /// Returns the overlay over the picture.
    virtual Overlay OverPicture(SceneSession& session) = 0;
    /// Returns the first error.
    virtual Result<void> Check() const = 0;
};

class SceneSession
{
public:
    static Result<SceneSession> Open(SceneSource source, const SceneLook& look);

    /// Simulates up to `step` (0: as created). Earlier steps are not an error: nothing
    /// happens.
    void AdvanceTo(std::int64_t step);

    /// Simulates the step after `step` too, to show `fraction` of it: 0 to below 1, where 0 is
    /// AdvanceTo. Moments must not go back.
    void AdvanceBetween(std::int64_t step, double fraction);
    /// Calls the function while bodies have the poses that are shown: between steps, those between.
    void AtShownPoses(const std::function<void()>& function);

    /// Adds the picture of this moment, with `notes` on top of all items except labels. Labels
    /// avoid the notes. Expects an empty list.
    void Fill(FrameContent& content, const DrawList& notes = {});

    std::int64_t Step() const
    {
        return m_step;
    } ///< the last that was simulated, or passed by
      ///< while it was paused
    std::int64_t SceneStep() const { return m_sceneStep; } ///< the scene's own count
    const Rational& StepsPerSecond() const { return m_stepsPerSecond; }
    const std::string& Title() const { return m_title; }
    const std::string& Asked() const { return m_asked; } ///< finds the scene again (OpenScene)
    const BodyNames& Names() const { return m_scene->Names(); }
    const b2World& World() const { return m_scene->World(); }
    b2World& World() { return m_scene->World(); } ///< whose debug drawing may be borrowed
    Scene& CurrentScene() { return *m_scene; }
    const StepSettings& Steps() const { return m_stepSettings; }
    StepSettings& Steps() { return m_stepSettings; } ///< but for the time step
    Camera CurrentCamera() const;                    ///< at scale 1
    double Time() const; ///< that is shown, simulated since the scene began [s]
    /// Bodies may come that are not there yet.
    bool MakesBodiesLater() const;
    /// Unusable while a body that the camera should show has never been there.
    Result<void> CheckView() const;
    /// Returns the first error of the companion.
    Result<void> CheckCompanion() const
    {
        return m_companion ? m_companion->Check() : Result<void>();
    }

    // Changes of the user during the session.
    const SceneLook& Look() const { return m_look; }
    void SetLayers(const LayerSet& layers, bool labels);
    /// Paused, steps pass by and nothing is simulated.
    void Pause(bool isPaused) { m_isPaused = isPaused; }
    bool IsPaused() const { return m_isPaused; }
    /// The next step is simulated although it is paused.
    void StepOnceThough() { m_stepsOnce = true; }
    /// Sets a fixed view: this point is in the middle of the uncovered area, at a scale in pixels
    /// per metre.
    void LookAt(const b2Vec2& center, double pixelsPerMeter);
    /// Restores the view of its look.
    void LookAsBefore() { m_ownView.reset(); }
    /// True if the view follows bodies.
    bool Follows() const { return !m_ownView && m_camera.Follows(); }
    bool HasOwnView() const { return m_ownView.has_value(); }
    /// Returns the width of the picture that no panel covers [px].
    int UncoveredWidth() const;
    /// Changes the size of the picture and the width that panels cover. The view shows the same
    /// area.
    void Resize(int width, int height, int covered);
    /// Replaces the scene by another, or by a new one of the same name. The count of steps
    /// continues, and companions stay. Unchanged if there is an Error.
    Result<void> Replace(SceneSource source, const SceneLook& look);
    void SetCompanion(std::shared_ptr<SessionCompanion> companion)
    {
        m_companion = std::move(companion);
    }

    /// Returns everything that determines the sequence of states, as lines of text. Call it before
    /// the first step. A saved state can be restored in sessions with the same text.
    std::string DescribeOrigin();
    /// Returns what a step leaves to the next one and to pictures.
    std::vector<std::uint8_t> SaveState();
    /// False if the bytes are not such a state; the session is then unchanged.
    bool RestoreState(std::span<const std::uint8_t> bytes);
    /// Returns the latest step from which a restored state must be simulated, so the picture of
    /// `step` contains all of its items.
    std::int64_t LatestStateFor(std::int64_t step) const;

private:
    SceneSession(SceneSource source, const SceneLook& look, const SceneCamera& camera);
    void StepOnce();
    void Simulate();
    Camera Placed(const Camera& view) const;
    void Collect(double farthest, DrawList& list, const DrawList& notes);
    HudContent DescribeState() const;
    boxreel::View CollectedView(double farthest) const;

    std::unique_ptr<Scene> m_scene;
    std::string m_title;
    std::string m_asked;
    SceneLook m_look;
    ScriptInput m_input;
    Rational m_stepsPerSecond;
    StepSettings m_stepSettings;
    SceneCamera m_camera;
    LayerCollector m_layers;
    BodyNames m_shownNames;
    std::optional<Hud> m_hud;
    std::int64_t m_step = 0;
    std::int64_t m_sceneStep = 0;
    bool m_isPaused = false;
    bool m_stepsOnce = false;
    std::optional<Camera> m_ownView; // that a person has chosen; its middle is the uncovered part's
    std::shared_ptr<SessionCompanion> m_companion;
    b2PoseRecord m_posesBefore; // the last step, while what lies before its end is shown
    Camera m_viewBefore;
    std::optional<double> m_fraction; // shown of the last step; none: its end
    double m_stepMilliseconds = 0.0;  // of the last step, smoothed
};

} // namespace boxreel
