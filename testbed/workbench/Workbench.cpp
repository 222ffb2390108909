// SPDX-License-Identifier: MIT
#include "Workbench.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <golden/StateHash.h>
#include <options/OptionNames.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxreel
{
namespace
{

constexpr double kMaxOwed = 0.1; // simulated at once [s]

int Unscaled(int pixels, double scale)
{
    return std::max(1, static_cast<int>(std::lround(pixels / scale)));
}

} // namespace

Result<Workbench> Workbench::Open(SceneSource source, const WorkbenchSettings& settings)
{
    WorkbenchSettings own = settings;
    SceneLook& look = own.look;
    look.panels.testbed = true;
    Apply(settings.choices, look);
    look.panels.covered = settings.choices.showsPanels ? Panels::kColumnWidth : 0;
    const bool keeps = settings.choices.keepsSolver && settings.keepsChoices;
    SceneLook first = look;
    if (keeps && !first.simulation.stepsPerSecond)
    {
        first.simulation.stepsPerSecond = Rational{settings.choices.solver.hertz, 1};
    }
    ASSIGN_OR_RETURN(SceneSession session, SceneSession::Open(std::move(source), first));
    const Camera size = Scaled(Camera{.width = look.width, .height = look.height}, look.scale);
    ASSIGN_OR_RETURN(Panels panels, Panels::Create(size.width, size.height, look.scale));
    if (!keeps)
    {
        own.choices.solver = SolverOf(session);
    }
    Workbench bench(std::move(session), std::move(panels), own);
    bench.BeginScene();
    return bench;
}

/// The session is at its start: the choices are made in it, and a script begins.
void Workbench::BeginScene()
{
    m_choices.solver.hertz = SolverOf(Session()).hertz;
    m_work.Begin(m_choices.solver);
    m_hand.Forget();
    m_owed = 0.0;
}

/// Opens another scene, or the same one again.
void Workbench::Change(const std::string& scene, bool isOther)
{
    Result<SceneSource> source = OpenScene(scene);
    if (!source)
    {
        Say(TextInOptions(source.GetError()));
        return;
    }
    SceneLook look = m_settings.look;
    Apply(m_choices, look);
    const bool keeps = !isOther || m_choices.keepsSolver;
    if (keeps && m_choices.solver.hertz != m_work.Preferred().hertz)
    {
        look.simulation.stepsPerSecond = Rational{m_choices.solver.hertz, 1};
    }
    else if (keeps)
    {
        look.simulation.stepsPerSecond = Session().Look().simulation.stepsPerSecond;
    }
    const bool keepsView = !isOther && Session().HasOwnView();
    const Camera view = m_work.Uncovered();
    if (const Result<void> changed = Session().Replace(std::move(*source), look); !changed)
    {
        Say(TextInOptions(changed.GetError()));
        return;
    }
    if (!keeps)
    {
        m_choices.solver = SolverOf(Session());
    }
    if (keepsView)
    {
        m_work.LookAt(view.centerX, view.centerY, view.pixelsPerMeter);
    }
    BeginScene();
}

void Workbench::ChangeBy(int places)
{
    const auto scenes = AllScenes();
    const auto now = std::find_if(scenes.begin(), scenes.end(), [&](const SceneEntry& entry) {
        return Session().Title() == entry.name;
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
    m_owed = std::min(m_owed + seconds, kMaxOwed);
    const double step = 1.0 / Session().StepsPerSecond().ToDouble();
    while (m_owed >= step)
    {
        Tick();
        m_owed -= step;
    }
}

void Workbench::Tick()
{
    m_work.Step();
    m_panels.Observe(FactsOf(Session(), m_choices.profile));
    if (m_film && m_film->HasFrameAt(Session().SceneStep()))
    {
        FilmFrame();
    }
}

void Workbench::BuildPanels(const PanelInput& input)
{
    PanelFacts facts = FactsOf(Session(), m_choices.profile);
    facts.message = m_message;
    if (m_film)
    {
        facts.filmSeconds = m_film->Seconds(m_work);
    }
    const PanelChoices before = m_choices;
    const PanelAnswer answer = m_panels.Build(facts, m_choices, input);
    ApplyChoices(before);
    if (!answer.scene.empty())
    {
        Change(answer.scene, answer.scene != Session().Title());
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

/// The picker takes and releases the keyboard after a frame or two. Keys typed before would be
/// lost.
void Workbench::SettlePicker()
{
    BuildPanels(m_input);
    BuildPanels(m_input);
}

void Workbench::ApplyChoices(const PanelChoices& before)
{
    Apply(m_choices, Session());
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
        m_work.Set(name, value);
    }
    if (before.solver.hertz != m_choices.solver.hertz)
    {
        Change(Session().Asked(), false);
    }
}

/// Fits the view to the part that no shown panel covers.
void Workbench::Cover()
{
    m_settings.look.panels.covered = m_choices.showsPanels ? Panels::kColumnWidth : 0;
    Session().Resize(m_settings.look.width, m_settings.look.height, m_settings.look.panels.covered);
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
    m_panels.Resize(width, height);
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
        Change(Session().Asked(), false);
        break;
    case PanelWish::NextScene:
        ChangeBy(1);
        break;
    case PanelWish::PreviousScene:
        ChangeBy(-1);
        break;
    case PanelWish::ResetView:
        Session().LookAsBefore();
        break;
    case PanelWish::Bomb:
        m_work.Do(bomb);
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

void Workbench::Fill(FrameContent& content)
{
    PanelInput input = m_input;
    input.seconds = std::exchange(m_elapsed, 0.0);
    BuildPanels(input);
    DrawList notes;
    m_hand.AddSling(m_work, m_input.pointer, notes);
    Session().Fill(content, notes);
    content.camera = m_work.View();
    content.overlay = m_panels.Picture();
}

std::string Workbench::Summary() const
{
    return m_work.Session().Title() + ": step " + std::to_string(m_work.Session().SceneStep()) +
           ", state " + StateHashText(m_work.Session().World());
}

/// Returns the current look of its films and figures.
WorkbenchOutput Workbench::Output() const
{
    return {m_settings.into, m_settings.backend, m_settings.look.theme, m_choices};
}

/// Begins one, or ends it.
void Workbench::Film()
{
    if (m_film)
    {
        const std::filesystem::path path = m_film->Path();
        const Result<void> ended = Finish();
        Say(ended ? "Wrote " + path.string() + "." : TextInOptions(ended.GetError()));
        return;
    }
    Result<WorkbenchFilm> film = WorkbenchFilm::Open(m_work, Output());
    if (!film)
    {
        Say(TextInOptions(film.GetError()));
        return;
    }
    const std::filesystem::path path = film->Path();
    m_film.emplace(std::move(*film));
    FilmFrame();
    Say("Recording " + path.string() + ".");
}

void Workbench::FilmFrame()
{
    if (!m_film->Add(m_work, m_panels.Picture()))
    {
        const Result<void> why = Finish();
        Say(why ? "The film ended." : TextInOptions(why.GetError()));
    }
}

Result<void> Workbench::Finish()
{
    const Result<void> closed = m_film ? m_film->Close(m_work, m_choices) : Result<void>();
    m_film.reset();
    return closed;
}

void Workbench::Picture(const std::string& extension)
{
    const Result<std::filesystem::path> written = WritePicture(m_work, Output(), extension);
    Say(written ? "Wrote " + written->string() + "." : TextInOptions(written.GetError()));
}

void Workbench::SaveScript()
{
    const std::filesystem::path path = FreeName(m_settings.into, Session().Title(), ".play");
    const Result<void> written = WriteWhole(path, m_work.Script(), false);
    Say(written ? "Wrote " + path.string() + ": what was done since the scene began."
                : TextInOptions(written.GetError()));
}

} // namespace boxreel
