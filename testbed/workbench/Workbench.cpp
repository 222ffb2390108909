// SPDX-License-Identifier: MIT
#include "Workbench.h"

#include <base/ErrorMacros.h>
#include <golden/StateHash.h>
#include <script/ScriptSettings.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxreel
{
namespace
{

constexpr double kMostOwed = 0.1; // simulated at once [s]

int Unscaled(int pixels, double scale)
{
    return std::max(1, static_cast<int>(std::lround(pixels / scale)));
}

} // namespace

Result<Workbench> Workbench::Open(SceneSource source, const WorkbenchSettings& settings)
{
    Workbench bench;
    bench.m_settings = settings;
    bench.m_choices = settings.choices;
    SceneLook& look = bench.m_settings.look;
    look.panels = true;
    look.layers = settings.choices.layers;
    look.labels = settings.choices.labels;
    look.covered = settings.choices.showsPanels ? Panels::kColumnWidth : 0;
    const bool keeps = settings.choices.keepsSolver && settings.keepsChoices;
    SceneLook first = look;
    if (keeps && !first.stepsPerSecond)
    {
        first.stepsPerSecond = Rational{settings.choices.solver.hertz, 1};
    }
    ASSIGN_OR_RETURN(SceneSession session, SceneSession::Open(std::move(source), first));
    const Camera size = Scaled(Camera{.width = look.width, .height = look.height}, look.scale);
    ASSIGN_OR_RETURN(Panels panels, Panels::Create(size.width, size.height, look.scale));
    bench.m_session.emplace(std::move(session));
    bench.m_panels.emplace(std::move(panels));
    if (!keeps)
    {
        bench.m_choices.solver = SolverOf(*bench.m_session);
    }
    bench.BeginScene();
    return bench;
}

/// Of the session, which is at its start: the choices are made in it, and a script begins.
void Workbench::BeginScene()
{
    m_preferred = SolverOf(*m_session);
    m_choices.solver.hertz = m_preferred.hertz;
    const Camera view = Uncovered();
    std::vector<std::string> options{"--size", std::to_string(view.width) + "x" +
                                                   std::to_string(view.height)};
    if (m_settings.look.seed != 1)
    {
        options.insert(options.end(), {"--seed", std::to_string(m_settings.look.seed)});
    }
    if (const std::optional<Rational>& rate = m_session->Look().stepsPerSecond)
    {
        options.insert(options.end(),
                       {"--hz", std::to_string(rate->num) +
                                    (rate->den == 1 ? "" : "/" + std::to_string(rate->den))});
    }
    m_log.Begin(m_session->Asked(), std::move(options), m_session->StepsPerSecond());
    for (const auto& [name, value] : Differences(m_preferred, m_choices.solver))
    {
        Set(name, value);
    }
    m_log.See(view, 0, m_session->HasOwnView());
    m_sceneKeys.clear();
    m_hold = m_hold == Hold::Scene || m_hold == Hold::Bomb ? Hold::Nothing : m_hold;
    m_owed = 0.0;
}

void Workbench::Set(const std::string& name, const std::string& value)
{
    ScriptAction action;
    action.kind = ScriptAction::Kind::Set;
    action.name = name;
    action.value = *ParseSetting(name, value);
    Do(action);
}

/// To another scene, or the same one anew.
void Workbench::Change(const std::string& scene, bool isOther)
{
    Result<SceneSource> source = OpenScene(scene);
    if (!source)
    {
        Say(source.GetError().Text());
        return;
    }
    SceneLook look = m_settings.look;
    look.layers = m_choices.layers;
    look.labels = m_choices.labels;
    const bool keeps = !isOther || m_choices.keepsSolver;
    if (keeps && m_choices.solver.hertz != m_preferred.hertz)
    {
        look.stepsPerSecond = Rational{m_choices.solver.hertz, 1};
    }
    else if (keeps)
    {
        look.stepsPerSecond = m_session->Look().stepsPerSecond;
    }
    const bool keepsView = !isOther && m_session->HasOwnView();
    const Camera view = Uncovered();
    if (const Result<void> changed = m_session->Replace(std::move(*source), look); !changed)
    {
        Say(changed.GetError().Text());
        return;
    }
    if (!keeps)
    {
        m_choices.solver = SolverOf(*m_session);
    }
    if (keepsView)
    {
        m_session->LookAt(b2Vec2(float32(view.centerX), float32(view.centerY)),
                          view.pixelsPerMeter);
    }
    BeginScene();
}

void Workbench::ChangeBy(int places)
{
    const auto scenes = AllScenes();
    const auto now = std::find_if(scenes.begin(), scenes.end(), [&](const SceneEntry& entry) {
        return m_session->Title() == entry.name;
    });
    const int count = static_cast<int>(scenes.size());
    const int place = now == scenes.end() ? (places > 0 ? -1 : 0) // a file, before them all
                                          : static_cast<int>(now - scenes.begin());
    Change(scenes[std::size_t((place + places + count) % count)].name, true);
}

void Workbench::Advance(double seconds)
{
    m_elapsed += seconds;
    if (m_choices.isPaused)
    {
        m_owed = 0.0;
        return;
    }
    m_owed = std::min(m_owed + seconds, kMostOwed);
    const double step = 1.0 / m_session->StepsPerSecond().ToDouble();
    while (m_owed >= step)
    {
        Tick();
        m_owed -= step;
    }
}

void Workbench::Tick()
{
    m_session->Pause(false);
    m_session->AdvanceTo(m_session->Step() + 1);
    m_panels->Observe(FactsOf(*m_session, m_choices.profile));
    m_log.See(Uncovered(), m_session->SceneStep(), m_session->HasOwnView());
    if (m_film && (m_session->SceneStep() - m_filmFirst) % m_filmEvery == 0)
    {
        FilmFrame();
    }
}

void Workbench::BuildPanels(const PanelInput& input)
{
    PanelFacts facts = FactsOf(*m_session, m_choices.profile);
    facts.message = m_message;
    if (m_film)
    {
        facts.filmSeconds =
            double(m_filmFrames) * m_filmEvery / m_session->StepsPerSecond().ToDouble();
    }
    const PanelChoices before = m_choices;
    const PanelAnswer answer = m_panels->Build(facts, m_choices, input);
    ApplyChoices(before);
    if (!answer.scene.empty())
    {
        Change(answer.scene, answer.scene != m_session->Title());
    }
    for (const PanelWish wish : answer.wishes)
    {
        Wish(wish);
    }
    if (m_choices.showsPicker != before.showsPicker)
    {
        SettlePicker();
    }
}

/// It takes the keyboard, and gives it back, after a frame or two: what is typed before would be
/// lost.
void Workbench::SettlePicker()
{
    BuildPanels(m_input);
    BuildPanels(m_input);
}

void Workbench::ApplyChoices(const PanelChoices& before)
{
    m_session->SetLayers(m_choices.layers, m_choices.labels);
    if (before.showsPanels != m_choices.showsPanels)
    {
        Cover();
    }
    if (before.theme != m_choices.theme)
    {
        m_settings.look.theme = FindTheme(m_choices.theme).value_or(Theme::Classic());
    }
    for (const auto& [name, value] : Differences(before.solver, m_choices.solver))
    {
        Set(name, value);
    }
    if (before.solver.hertz != m_choices.solver.hertz)
    {
        Change(m_session->Asked(), false);
    }
}

/// The view keeps clear of the panels, when they are there.
void Workbench::Cover()
{
    m_settings.look.covered = m_choices.showsPanels ? Panels::kColumnWidth : 0;
    m_session->Resize(m_settings.look.width, m_settings.look.height, m_settings.look.covered);
}

void Workbench::Resize(int width, int height)
{
    SceneLook& look = m_settings.look;
    look.width = Unscaled(width, look.scale);
    look.height = Unscaled(height, look.scale);
    if (m_film) // whose frames have the size of the first
    {
        Film();
    }
    m_panels->Resize(width, height);
    Cover();
}

void Workbench::Wish(PanelWish wish)
{
    ScriptAction bomb;
    bomb.kind = ScriptAction::Kind::Bomb;
    switch (wish)
    {
    case PanelWish::Step:
        m_choices.isPaused = true;
        Tick();
        break;
    case PanelWish::Restart:
        Change(m_session->Asked(), false);
        break;
    case PanelWish::NextScene:
        ChangeBy(1);
        break;
    case PanelWish::PreviousScene:
        ChangeBy(-1);
        break;
    case PanelWish::ResetView:
        m_session->LookAsBefore();
        break;
    case PanelWish::Bomb:
        Do(bomb);
        break;
    case PanelWish::Film:
        Film();
        break;
    case PanelWish::FigureSvg:
        Picture(".svg");
        break;
    case PanelWish::FigurePng:
        Picture(".png");
        break;
    case PanelWish::Script:
        SaveScript();
        break;
    }
}

/// At full size, over the whole window.
Camera Workbench::View() const
{
    return Scaled(m_session->CurrentCamera(), m_settings.look.scale);
}

/// The part of the view that no panel covers, at scale 1.
Camera Workbench::Uncovered() const
{
    Camera view = m_session->CurrentCamera();
    const int covered = view.width - m_session->UncoveredWidth();
    view.width -= covered;
    view.centerX -= 0.5 * covered / view.pixelsPerMeter;
    return view;
}

void Workbench::Fill(FrameContent& content)
{
    PanelInput input = m_input;
    input.seconds = std::exchange(m_elapsed, 0.0);
    BuildPanels(input);
    DrawList notes;
    AddSling(notes);
    m_session->Fill(content, notes);
    content.camera = View();
    content.overlay = m_panels->Picture();
}

std::string Workbench::Summary() const
{
    return m_session->Title() + ": step " + std::to_string(m_session->SceneStep()) + ", state " +
           StateHashText(m_session->World());
}

} // namespace boxreel
