// SPDX-License-Identifier: MIT
#pragma once

#include "SceneCamera.h"
#include "SceneLayers.h"
#include "SceneSearch.h"

#include <script/ScriptInput.h>

#include <debugdraw/Result.h>
#include <debugdraw/Theme.h>
#include <recorder/FrameClock.h>
#include <recorder/Recording.h>
#include <render/Overlay.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// A scene being shown: simulated step by step, looked at by a camera, described by a panel. Films,
/// stills and golden candidates all come from here, which is why a still has the very pixels that a
/// film has at that time. Knows no files and no pixels of its own; never prints.
namespace boxreel
{

/// How a scene is simulated and what its picture shows.
struct SceneLook
{
    int width = 1280;   ///< [px]
    int height = 720;   ///< [px]
    double scale = 1.0; ///< of all lengths in pixels, width and height too
    Theme theme = Theme::Classic();
    std::optional<Rational> stepsPerSecond; ///< none of these three: as the scene prefers,
    std::optional<int> velocityIterations;  ///< which is 60, 8 and 3 unless it says otherwise
    std::optional<int> positionIterations;
    std::uint32_t seed = 1;
    std::shared_ptr<const Script> script; ///< whose actions are done to it; null: none
    ViewChoice view;
    SceneLayers layers;
    ArrowScales arrows;
    /// What lies outside of the picture is collected too: for lists that are kept and compared.
    bool collectEverything = false;
    bool labels = false;          ///< the number of each body at its centre of mass
    bool hud = false;             ///< a panel with time, step and counts
    bool hudMilliseconds = false; ///< and the time a step took, which no two runs share
};

class SceneSession
{
public:
    static Result<SceneSession> Open(SceneSource source, const SceneLook& look);

    /// Simulates up to `step` (0: as created). Steps that lie behind are no mistake: nothing
    /// happens.
    void AdvanceTo(std::int64_t step);

    /// Simulates the step after `step` too, to show `fraction` of its way: 0 to below 1, where 0 is
    /// AdvanceTo. Moments must not go back.
    void AdvanceBetween(std::int64_t step, double fraction);

    /// What the picture of this moment shows, with `notes` over all but labels, which keep clear of
    /// them. Expects an empty list.
    void Fill(FrameContent& content, const DrawList& notes = {});

    std::int64_t Step() const { return m_step; } ///< the last that was simulated
    const Rational& StepsPerSecond() const { return m_stepsPerSecond; }
    const std::string& Title() const { return m_title; }
    const BodyNames& Names() const { return m_scene->Names(); }
    const b2World& World() const { return m_scene->World(); }
    b2World& World() { return m_scene->World(); } ///< whose debug drawing may be borrowed
    Scene& CurrentScene() { return *m_scene; }
    const StepSettings& Steps() const { return m_stepSettings; }
    Camera CurrentCamera() const; ///< at scale 1
    double Time() const;          ///< that is shown, simulated since the start [s]
    /// Bodies may come that are not there yet.
    bool MakesBodiesLater() const;
    /// Unusable while a body that the camera should show has never been there.
    Result<void> CheckView() const { return m_camera.CheckBodiesCame(); }

    /// All that decides which states it goes through, as lines of text: before the first step. A
    /// state that was saved may be restored wherever the text is the same.
    std::string DescribeOrigin();
    /// All that a step leaves to the next one and to pictures.
    std::vector<std::uint8_t> SaveState();
    /// False when the bytes are not such a state; the session is then as it was.
    bool RestoreState(std::span<const std::uint8_t> bytes);
    /// From which step on, at the latest, what has been restored must be simulated so that the
    /// picture of `step` has all that it shows.
    std::int64_t LatestStateFor(std::int64_t step) const;

private:
    SceneSession(std::unique_ptr<Scene> scene, std::string title, const SceneLook& look,
                 const SceneCamera& camera);
    void StepOnce();
    void Collect(double farthest, DrawList& list, const DrawList& notes);
    HudContent DescribeState() const;
    boxreel::View CollectedView(double farthest) const;

    std::unique_ptr<Scene> m_scene;
    std::string m_title;
    SceneLook m_look;
    ScriptInput m_input;
    Rational m_stepsPerSecond;
    StepSettings m_stepSettings;
    SceneCamera m_camera;
    LayerCollector m_layers;
    BodyNames m_shownNames;
    std::optional<Hud> m_hud;
    std::int64_t m_step = 0;
    b2PoseRecord m_posesBefore; // the last step, while what lies before its end is shown
    Camera m_viewBefore;
    std::optional<double> m_fraction; // of the last step's way that is shown; none: its end
    double m_stepMilliseconds = 0.0;  // of the last step, smoothed
};

} // namespace boxreel
