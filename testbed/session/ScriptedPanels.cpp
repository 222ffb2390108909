// SPDX-License-Identifier: MIT
// Panels without a window: what a script does with them, step by step.
#include "SessionPanels.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>

#include <algorithm>
#include <cctype>

namespace boxreel
{
namespace
{

// Number of frames after which opening and scrolling is complete.
constexpr int kFramesToSettle = 4;

/// "ctrl+o": a key, and whether Control is down.
struct Hit
{
    Key key = Key::None;
    bool control = false;
};

std::optional<Hit> ParseHit(std::string text)
{
    Hit hit;
    if (text.starts_with("ctrl+"))
    {
        hit.control = true;
        text = text.substr(5);
    }
    static const std::vector<std::pair<std::string, Key>> kNamed{
        {"tab", Key::Tab},     {"enter", Key::Enter},        {"escape", Key::Escape},
        {"space", Key::Space}, {"left", Key::Left},          {"right", Key::Right},
        {"up", Key::Up},       {"down", Key::Down},          {"home", Key::Home},
        {"end", Key::End},     {"backspace", Key::Backspace}};
    for (const auto& [name, key] : kNamed)
    {
        hit.key = text == name ? key : hit.key;
    }
    if (text.size() == 1)
    {
        hit.key = KeyOf(text.front());
    }
    return hit.key == Key::None ? std::nullopt : std::optional(hit);
}

class ScriptedPanels final : public SessionCompanion
{
public:
    ScriptedPanels(Panels panels, const SceneLook& look) : m_panels(std::move(panels))
    {
        m_isDrawn = look.panels.testbed;
        m_isTimed = look.panels.milliseconds;
        m_scriptFile = look.simulation.script ? look.simulation.script->file.string() : "";
    }

    void Begin(const SceneSession& session);
    void BeforeStep(SceneSession& session, const std::vector<ScriptAction>& actions) override;
    void AfterStep(SceneSession& session) override
    {
        m_panels.Observe(FactsOf(session, m_isTimed));
    }
    Overlay OverPicture(SceneSession& session) override;
    Result<void> Check() const override { return m_failure; }

private:
    void Frame(SceneSession& session, const PanelInput& input);
    void Settle(SceneSession& session);
    void Answer(SceneSession& session, const PanelAnswer& answer);
    void Change(SceneSession& session, const std::string& scene);
    void Press(SceneSession& session, const ScriptAction& action);
    void Strike(SceneSession& session, const ScriptAction& action);
    void Shortcut(SceneSession& session, const Hit& hit);
    void Fail(const ScriptAction& action, const std::string& problem, const std::string& remedy);

    Panels m_panels;
    PanelChoices m_choices;
    Vec2 m_pointer{-1.0f, -1.0f};
    bool m_isDrawn = true;
    bool m_isTimed = false;
    std::string m_scriptFile;
    Result<void> m_failure;
};

/// With the choices as the session has them.
void ScriptedPanels::Begin(const SceneSession& session)
{
    ReadChoices(m_choices, session);
}

void ScriptedPanels::Frame(SceneSession& session, const PanelInput& input)
{
    // A script may have set what the panels show.
    const SolverChoices now = SolverOf(session);
    m_choices.solver = now;
    PanelFacts facts = FactsOf(session, m_isTimed);
    facts.isWindow = false;
    const PanelAnswer answer = m_panels.Build(facts, m_choices, input);
    session.Pause(m_choices.isPaused);
    Apply(m_choices, session);
    const int hertz = m_choices.solver.hertz;
    if (m_choices.solver != now)
    {
        ApplySettings(m_choices.solver, session.World(), session.Steps());
    }
    if (hertz != now.hertz)
    {
        m_choices.solver.hertz = now.hertz; // a film and its script count by one rate
    }
    Answer(session, answer);
}

void ScriptedPanels::Settle(SceneSession& session)
{
    for (int i = 0; i < kFramesToSettle; ++i)
    {
        PanelInput input;
        input.pointer = m_pointer;
        Frame(session, input);
    }
}

void ScriptedPanels::Change(SceneSession& session, const std::string& scene)
{
    Result<SceneSource> source = OpenScene(scene);
    const Result<void> changed =
        source ? session.Replace(std::move(*source), session.Look()) : source.GetError();
    if (changed)
    {
        Begin(session);
    }
    else if (m_failure)
    {
        m_failure = changed;
    }
}

void ScriptedPanels::Answer(SceneSession& session, const PanelAnswer& answer)
{
    if (!answer.scene.empty())
    {
        Change(session, answer.scene);
    }
    for (const PanelWish wish : answer.wishes)
    {
        switch (wish)
        {
        case PanelWish::Step:
            m_choices.isPaused = true;
            session.Pause(true);
            session.StepOnceThough();
            break;
        case PanelWish::Restart:
            Change(session, session.Asked());
            break;
        case PanelWish::ResetView:
            session.LookAsBefore();
            break;
        case PanelWish::Bomb:
            session.CurrentScene().ThrowBomb();
            break;
        default:
            break; // a window's
        }
    }
}

void ScriptedPanels::Fail(const ScriptAction& action, const std::string& problem,
                          const std::string& remedy)
{
    if (m_failure)
    {
        m_failure = AtLine(m_scriptFile, action.line,
                           Error{ErrorKind::Unusable, Quoted(action.name), problem, remedy});
    }
}

void ScriptedPanels::Press(SceneSession& session, const ScriptAction& action)
{
    m_panels.Controls().Reveal(action.name);
    Settle(session);
    const std::optional<Vec2> place = m_panels.Controls().Find(action.name);
    if (!place)
    {
        Fail(action, "unknown control at this moment",
             DidYouMean(action.name, m_panels.Controls().Names(),
                        "use one such as Solver/Sleep or Run/Pause"));
        return;
    }
    m_pointer = *place;
    for (const bool isDown : {false, true, false})
    {
        PanelInput input;
        input.pointer = m_pointer;
        input.buttons[0] = isDown;
        Frame(session, input);
    }
}

/// A key that the window knows, or one for the control that has the keyboard.
void ScriptedPanels::Strike(SceneSession& session, const ScriptAction& action)
{
    const std::optional<Hit> hit = ParseHit(action.name);
    if (!hit)
    {
        Fail(action, "unknown key", "use one such as enter, escape, down, tab, p or ctrl+o");
        return;
    }
    if (!m_panels.WantsKeys(m_choices))
    {
        Shortcut(session, *hit);
        Settle(session);
        return;
    }
    for (const bool isDown : {true, false})
    {
        PanelInput input;
        input.pointer = m_pointer;
        input.control = hit->control;
        if (isDown)
        {
            input.keys.push_back(hit->key);
        }
        Frame(session, input);
    }
    Settle(session);
}

void ScriptedPanels::Shortcut(SceneSession& session, const Hit& hit)
{
    if (hit.key == Key::Tab)
    {
        m_choices.showsPanels = !m_choices.showsPanels;
    }
    else if (hit.control && hit.key == Key::O)
    {
        m_choices.showsPicker = true;
    }
    else if (hit.key == Key::P)
    {
        m_choices.isPaused = !m_choices.isPaused;
    }
    else if (hit.key == Key::O)
    {
        Answer(session, {.wishes = {PanelWish::Step}, .scene = {}});
    }
    else if (hit.key == Key::R)
    {
        Answer(session, {.wishes = {PanelWish::Restart}, .scene = {}});
    }
}

void ScriptedPanels::BeforeStep(SceneSession& session, const std::vector<ScriptAction>& actions)
{
    for (const ScriptAction& action : actions)
    {
        switch (action.kind)
        {
        case ScriptAction::Kind::Click:
            Press(session, action);
            break;
        case ScriptAction::Kind::Type: {
            PanelInput input;
            input.pointer = m_pointer;
            input.text = action.name;
            Frame(session, input);
            Settle(session);
            break;
        }
        default:
            Strike(session, action);
            break;
        }
    }
}

Overlay ScriptedPanels::OverPicture(SceneSession& session)
{
    PanelInput input;
    input.pointer = m_pointer;
    Frame(session, input);
    return m_isDrawn ? m_panels.Picture() : Overlay();
}

} // namespace

Result<std::shared_ptr<SessionCompanion>> CreateScriptedPanels(const SceneLook& look,
                                                               const SceneSession& session)
{
    const Camera size = Scaled(Camera{.width = look.width, .height = look.height}, look.scale);
    ASSIGN_OR_RETURN(Panels panels, Panels::Create(size.width, size.height, look.scale));
    auto companion = std::make_shared<ScriptedPanels>(std::move(panels), look);
    companion->Begin(session);
    return std::shared_ptr<SessionCompanion>(std::move(companion));
}

} // namespace boxreel
