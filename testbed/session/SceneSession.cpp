// SPDX-License-Identifier: MIT
#include "SceneSession.h"

#include <base/ErrorMacros.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

namespace boxreel
{
namespace
{

/// A number with `decimals` digits after the point, independent of the locale.
std::string Decimals(double value, int decimals)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

double StepSeconds(const Rational& stepsPerSecond)
{
    return double(stepsPerSecond.den) / double(stepsPerSecond.num);
}

/// Rounded once: a step at a whole second is exactly there.
double SecondsAt(std::int64_t step, const Rational& stepsPerSecond)
{
    return double(step) * double(stepsPerSecond.den) / double(stepsPerSecond.num);
}

/// A scene states a time step in single precision: 1/60 is meant when the nearest float to it is
/// there.
Rational RateOf(float32 timeStep)
{
    const std::int64_t thousandths =
        std::max<std::int64_t>(1, std::llround(1000.0 / double(timeStep)));
    const std::int64_t common = std::gcd<std::int64_t>(thousandths, 1000);
    return Rational{thousandths / common, 1000 / common};
}

/// Returns the view that the scene prefers, in a picture of this shape.
ViewChoice PreferredView(const Scene& scene, double aspect)
{
    const std::optional<SceneArea> area = scene.PreferredView();
    if (!area)
    {
        return FitView{};
    }
    const double height =
        2.0 * std::max(double(area->halfSize.y), double(area->halfSize.x) / aspect);
    if (area->followed != nullptr)
    {
        return FollowView{{area->followed->GetNumber()}, height};
    }
    return FixedView{area->center.x, area->center.y, height};
}

/// Numbers are names of bodies that have none.
LayerSet LayersOf(const SceneLook& look)
{
    LayerSet layers = look.layers;
    layers[DrawLayer::Labels] = layers[DrawLayer::Labels] || look.labels;
    return layers;
}

/// Returns the labels of bodies: names, numbers, or "3 ball" with both.
BodyNames ShownNames(const SceneLook& look, const BodyNames& names)
{
    BodyNames shown = look.layers[DrawLayer::Labels] ? names : BodyNames();
    for (auto& [number, name] : shown)
    {
        name = look.labels && !name.empty() ? std::to_string(number) + " " + name : name;
    }
    return shown;
}

/// Returns the width that panels cover in the picture [px]. It always leaves some width for the
/// scene.
int WidthBesidePanels(const SceneLook& look)
{
    return std::max(look.width - look.panels.covered, (2 * look.width + 4) / 5);
}

/// Bodies come by the scene or by bombs.
bool MakesBodies(const Scene& scene, const SceneLook& look)
{
    return scene.MakesBodiesLater() ||
           (look.simulation.script != nullptr && look.simulation.script->ThrowsBombs());
}

} // namespace

SceneSession::SceneSession(SceneSource source, const SceneLook& look, const SceneCamera& camera)
    : m_scene(std::move(source.scene)), m_title(std::move(source.title)),
      m_asked(std::move(source.asked)), m_look(look),
      m_stepsPerSecond(
          look.simulation.stepsPerSecond.value_or(RateOf(m_scene->PreferredSteps().timeStep))),
      m_stepSettings(m_scene->PreferredSteps()), m_camera(camera),
      m_layers(LayersOf(look), look.arrows, m_stepsPerSecond.ToDouble(), m_scene->World()),
      m_shownNames(ShownNames(look, m_scene->Names()))
{
    m_stepSettings.timeStep = static_cast<float32>(StepSeconds(m_stepsPerSecond));
    m_stepSettings.velocityIterations =
        look.simulation.velocityIterations.value_or(m_stepSettings.velocityIterations);
    m_stepSettings.positionIterations =
        look.simulation.positionIterations.value_or(m_stepSettings.positionIterations);
}

Result<SceneSession> SceneSession::Open(SceneSource source, const SceneLook& look)
{
    if (source.entry != nullptr)
    {
        source.scene = source.entry->create(SceneSettings{look.simulation.seed});
    }
    ViewChoice view = look.view;
    if (std::holds_alternative<SceneView>(view))
    {
        view = PreferredView(*source.scene, double(WidthBesidePanels(look)) / look.height);
    }
    RETURN_IF_ERROR(FindNames("--camera", BodiesOf(view), source.scene->Names()));
    ASSIGN_OR_RETURN(const SceneCamera camera,
                     SceneCamera::Create(view, source.scene->World(), WidthBesidePanels(look),
                                         look.height, MakesBodies(*source.scene, look),
                                         source.scene->Framed()));
    SceneSession session(std::move(source), look, camera);
    if (look.simulation.script != nullptr)
    {
        ASSIGN_OR_RETURN(const ScriptInput input,
                         ScriptInput::Create(*look.simulation.script, session.m_stepsPerSecond,
                                             *session.m_scene));
        session.m_input = input;
    }
    if (look.panels.hud)
    {
        const Camera size = Scaled(Camera{.width = look.width, .height = look.height}, look.scale);
        ASSIGN_OR_RETURN(Hud hud, Hud::Create(size.width, size.height, look.scale));
        session.m_hud.emplace(std::move(hud));
    }
    return session;
}

bool SceneSession::MakesBodiesLater() const
{
    return MakesBodies(*m_scene, m_look);
}

void SceneSession::AdvanceTo(std::int64_t step)
{
    if (step >= m_step)
    {
        m_fraction.reset();
    }
    while (m_step < step)
    {
        StepOnce();
    }
}

void SceneSession::AdvanceBetween(std::int64_t step, double fraction)
{
    AdvanceTo(step);
    if (fraction == 0.0)
    {
        return;
    }
    if (m_step == step)
    {
        m_posesBefore.Save(m_scene->World());
        m_viewBefore = m_camera.View();
        StepOnce();
    }
    m_fraction = fraction;
}

void SceneSession::StepOnce()
{
    if (m_companion)
    {
        m_companion->BeforeStep(*this, m_input.ForPanels(m_step));
    }
    m_input.Apply(*m_scene, m_stepSettings, m_step);
    ++m_step;
    if (m_isPaused && !m_stepsOnce)
    {
        return;
    }
    m_stepsOnce = false;
    Simulate();
    if (m_companion)
    {
        m_companion->AfterStep(*this);
    }
}

void SceneSession::Simulate()
{
    using Clock = std::chrono::steady_clock;
    m_layers.BeforeStep(m_scene->World());
    const Clock::time_point start = Clock::now();
    m_scene->Step(m_stepSettings);
    ++m_sceneStep;
    if (m_look.panels.milliseconds)
    {
        const double taken =
            std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        m_stepMilliseconds = m_sceneStep == 1 ? taken : 0.9 * m_stepMilliseconds + 0.1 * taken;
    }
    m_camera.Update(m_scene->World(), SecondsAt(m_sceneStep, m_stepsPerSecond),
                    StepSeconds(m_stepsPerSecond), m_scene->Framed());
}

double SceneSession::Time() const
{
    const bool isBetween = m_fraction && m_sceneStep > 0;
    return isBetween ? SecondsAt(m_sceneStep - 1, m_stepsPerSecond) +
                           *m_fraction * StepSeconds(m_stepsPerSecond)
                     : SecondsAt(m_sceneStep, m_stepsPerSecond);
}

Result<void> SceneSession::CheckView() const
{
    const Result<void> gone = CheckCompanion();
    return gone ? m_camera.CheckBodiesCame() : gone;
}

void SceneSession::SetLayers(const LayerSet& layers, bool labels)
{
    if (layers == m_look.layers && labels == m_look.labels)
    {
        return;
    }
    m_look.layers = layers;
    m_look.labels = labels;
    m_layers = LayerCollector(LayersOf(m_look), m_look.arrows, m_stepsPerSecond.ToDouble(),
                              m_scene->World());
    m_shownNames = ShownNames(m_look, m_scene->Names());
}

int SceneSession::UncoveredWidth() const
{
    return WidthBesidePanels(m_look);
}

void SceneSession::LookAt(const b2Vec2& center, double pixelsPerMeter)
{
    m_ownView = Camera{.width = m_look.width,
                       .height = m_look.height,
                       .centerX = double(center.x),
                       .centerY = double(center.y),
                       .pixelsPerMeter = pixelsPerMeter};
}

void SceneSession::Resize(int width, int height, int covered)
{
    if (m_ownView)
    {
        const double scale = double(height) / m_look.height;
        m_ownView->pixelsPerMeter *= scale;
    }
    m_look.width = width;
    m_look.height = height;
    m_look.panels.covered = covered;
}

Result<void> SceneSession::Replace(SceneSource source, const SceneLook& look)
{
    SceneLook begun = look;
    begun.simulation.script = nullptr; // whose actions were understood for the first scene
    ASSIGN_OR_RETURN(SceneSession other, Open(std::move(source), begun));
    other.m_look.simulation.script = look.simulation.script;
    other.m_input = std::move(m_input);
    other.m_step = m_step;
    other.m_isPaused = m_isPaused;
    other.m_companion = std::move(m_companion);
    *this = std::move(other);
    return {};
}

/// Returns the view fitted to the part that no panel covers.
Camera SceneSession::Placed(const Camera& view) const
{
    if (m_look.panels.covered == 0 && view.width == m_look.width && view.height == m_look.height)
    {
        return view;
    }
    Camera placed = view;
    const int uncovered = UncoveredWidth();
    if (!m_ownView)
    {
        placed.pixelsPerMeter *=
            std::min(double(uncovered) / view.width, double(m_look.height) / view.height);
    }
    placed.width = m_look.width;
    placed.height = m_look.height;
    placed.centerX += 0.5 * (m_look.width - uncovered) / placed.pixelsPerMeter;
    return placed;
}

Camera SceneSession::CurrentCamera() const
{
    if (m_ownView)
    {
        return Placed(*m_ownView);
    }
    return Placed(m_fraction ? Between(m_viewBefore, m_camera.View(), *m_fraction)
                             : m_camera.View());
}

void SceneSession::AtShownPoses(const std::function<void()>& function)
{
    if (m_fraction)
    {
        const b2PosesBetween between(m_scene->World(), m_posesBefore, *m_fraction);
        function();
    }
    else
    {
        function();
    }
}

void SceneSession::Fill(FrameContent& content, const DrawList& notes)
{
    if (m_fraction)
    {
        const b2PosesBetween between(m_scene->World(), m_posesBefore, *m_fraction);
        Collect(double(between.GetFarthest()), content.list, notes);
    }
    else
    {
        Collect(0.0, content.list, notes);
    }
    content.camera = Scaled(CurrentCamera(), m_look.scale);
    if (m_companion)
    {
        content.overlay = m_companion->OverPicture(*this);
    }
    if (m_hud)
    {
        content.overlay = m_hud->Build(DescribeState());
    }
}

void SceneSession::Collect(double farthest, DrawList& list, const DrawList& notes)
{
    static const JointNames kNone;
    DrawList own;
    own.layer = DrawLayer::Scene;
    DrawCollector collector(own);
    m_scene->Draw(collector);
    Append(own, notes);
    m_layers.Collect(m_scene->World(), CollectedView(farthest), m_shownNames,
                     m_look.layers[DrawLayer::Labels] ? m_scene->JointNames() : kNone, list, own);
}

/// A body that has jumped is found at its current position, at most `farthest` [m] from where it is
/// shown.
View SceneSession::CollectedView(double farthest) const
{
    const Camera camera = CurrentCamera();
    if (m_look.collectEverything)
    {
        View everything = ViewOfEverything(camera);
        everything.zoom = m_look.zoom;
        return everything;
    }
    View view = PictureView(camera, m_look.theme, m_look.scale);
    if (view.area && farthest > 0.0)
    {
        const float margin = static_cast<float>(farthest);
        view.area->lower.x -= margin;
        view.area->lower.y -= margin;
        view.area->upper.x += margin;
        view.area->upper.y += margin;
    }
    return view;
}

HudContent SceneSession::DescribeState() const
{
    const b2World& world = World();
    HudContent content;
    content.title = m_title;
    content.rows = {{"time", Decimals(Time(), 3) + " s"},
                    {"step", std::to_string(m_fraction ? m_sceneStep - 1 : m_sceneStep)},
                    {"bodies", std::to_string(world.GetBodyCount())},
                    {"contacts", std::to_string(world.GetContactCount())}};
    for (auto& row : m_scene->Describe())
    {
        content.rows.push_back(std::move(row));
    }
    if (m_look.panels.milliseconds)
    {
        content.rows.emplace_back("ms per step", Decimals(m_stepMilliseconds, 2));
    }
    return content;
}

} // namespace boxreel
