// SPDX-License-Identifier: MIT
// What mouse and keyboard do at a workbench.
#include "Workbench.h"

#include <debugdraw/DrawCollector.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

using Kind = WindowEvent::Kind;

constexpr double kZoomByKey = 1.1;
constexpr double kZoomByNotch = 1.15;
constexpr double kPanByKey = 0.05;    // of the view's height
constexpr float32 kShiftByKey = 2.0f; // of the origin [m]
constexpr float32 kSlingSpeed = 6.0f; // of a bomb, for each metre it was pulled [1/s]
constexpr double kLeastHeight = 1e-3; // of a view [m] …
constexpr double kMostHeight = 1e6;   // … beyond which nothing is to be seen

ScriptAction Action(ScriptAction::Kind kind, const b2Vec2& point = b2Vec2(0.0f, 0.0f))
{
    ScriptAction action;
    action.kind = kind;
    action.point = point;
    return action;
}

} // namespace

void Workbench::Handle(const WindowEvent& event)
{
    m_input.pointer = event.point;
    m_input.shift = event.shift;
    m_input.control = event.control;
    switch (event.kind)
    {
    case Kind::ButtonDown:
        Press(event);
        break;
    case Kind::ButtonUp:
        Release(event);
        break;
    case Kind::Pointer:
        Move(event);
        break;
    case Kind::Wheel:
        Turn(event);
        break;
    case Kind::KeyDown:
    case Kind::KeyRepeat:
        KeyDown(event);
        break;
    case Kind::KeyUp:
        KeyUp(event.key);
        break;
    case Kind::Text: {
        PanelInput input = m_input;
        input.text = event.text;
        BuildPanels(input);
        break;
    }
    case Kind::LostFocus:
        LetGo();
        break;
    case Kind::Close:
        m_isDone = true;
        break;
    case Kind::Resized:
    case Kind::Exposed:
        break; // the window's own
    }
}

b2Vec2 Workbench::WorldAt(Vec2 pixel) const
{
    const Vec2 point = View().ToWorld(pixel);
    return b2Vec2(point.x, point.y);
}

/// To the scene, and into the log.
void Workbench::Do(const ScriptAction& action)
{
    m_log.Add(action, m_session->SceneStep(), m_session->World());
    Perform(action, m_session->CurrentScene(), m_session->Steps());
}

void Workbench::Press(const WindowEvent& event)
{
    if (event.button < 0 || event.button >= int(m_input.buttons.size()))
    {
        return;
    }
    BuildPanels(m_input); // the mouse is there first
    m_input.buttons[std::size_t(event.button)] = true;
    BuildPanels(m_input);
    if (m_hold != Hold::Nothing)
    {
        return; // another button is down
    }
    m_heldButton = event.button;
    m_heldAt = event.point;
    if (m_panels->WantsPointer())
    {
        m_hold = Hold::Panels;
    }
    else if (event.button != 0)
    {
        m_hold = Hold::View;
    }
    else if (event.shift)
    {
        m_hold = Hold::Bomb;
        m_slingFrom = WorldAt(event.point);
    }
    else
    {
        m_hold = Hold::Scene;
        Do(Action(ScriptAction::Kind::Grab, WorldAt(event.point)));
    }
}

void Workbench::Release(const WindowEvent& event)
{
    if (event.button < 0 || event.button >= int(m_input.buttons.size()))
    {
        return;
    }
    m_input.buttons[std::size_t(event.button)] = false;
    BuildPanels(m_input);
    if (event.button != m_heldButton)
    {
        return;
    }
    const b2Vec2 point = WorldAt(event.point);
    const Hold held = std::exchange(m_hold, Hold::Nothing);
    if (held == Hold::Scene)
    {
        DropAt(event.point);
    }
    else if (held == Hold::Bomb)
    {
        ScriptAction bomb = Action(ScriptAction::Kind::Sling, m_slingFrom);
        bomb.velocity = kSlingSpeed * (m_slingFrom - point);
        Do(bomb);
    }
}

/// Scripts let go where the mouse was last.
void Workbench::DropAt(Vec2 pixel)
{
    Do(Action(ScriptAction::Kind::Move, WorldAt(pixel)));
    Do(Action(ScriptAction::Kind::Drop, WorldAt(pixel)));
}

void Workbench::Move(const WindowEvent& event)
{
    if (m_hold == Hold::Scene)
    {
        Do(Action(ScriptAction::Kind::Move, WorldAt(event.point)));
    }
    else if (m_hold == Hold::View)
    {
        const double scale = View().pixelsPerMeter;
        Pan(double(m_heldAt.x - event.point.x) / scale, double(event.point.y - m_heldAt.y) / scale);
        m_heldAt = event.point;
    }
}

void Workbench::Turn(const WindowEvent& event)
{
    PanelInput input = m_input;
    input.wheel = event.wheel;
    BuildPanels(input);
    if (!m_panels->WantsPointer())
    {
        Zoom(std::pow(kZoomByNotch, double(event.wheel)), event.point);
    }
}

/// The middle of what is seen goes by so much [m].
void Workbench::Pan(double x, double y)
{
    const Camera view = Uncovered();
    m_session->LookAt(b2Vec2(float32(view.centerX + x), float32(view.centerY + y)),
                      view.pixelsPerMeter);
}

/// What is at `about` [px] stays there.
void Workbench::Zoom(double factor, Vec2 about)
{
    const Camera view = Uncovered();
    const double height = view.height / view.pixelsPerMeter;
    const double newHeight = std::clamp(height / factor, kLeastHeight, kMostHeight);
    const double share = 1.0 - newHeight / height; // of the way from the middle to the point
    const b2Vec2 point = WorldAt(about);
    m_session->LookAt(b2Vec2(float32(view.centerX + share * (double(point.x) - view.centerX)),
                             float32(view.centerY + share * (double(point.y) - view.centerY))),
                      view.height / newHeight);
}

/// The point (x, y) becomes the origin [m]; what is seen stays where it is, unless the view goes
/// with what it follows.
void Workbench::Shift(float32 x, float32 y)
{
    const Camera view = Uncovered();
    Do(Action(ScriptAction::Kind::Shift, b2Vec2(x, y)));
    if (m_session->Follows())
    {
        return;
    }
    m_session->LookAt(b2Vec2(float32(view.centerX - double(x)), float32(view.centerY - double(y))),
                      view.pixelsPerMeter);
}

void Workbench::KeyDown(const WindowEvent& event)
{
    const bool isForPanels = m_panels->WantsKeys(m_choices);
    if (event.key != Key::None)
    {
        m_input.keys.assign(1, event.key);
        BuildPanels(m_input);
    }
    if (isForPanels)
    {
        return;
    }
    if (!Steer(event) && event.kind == Kind::KeyDown && !Shortcut(event) && !event.control)
    {
        const auto keys = m_session->CurrentScene().Keys();
        const bool isKnown = std::any_of(keys.begin(), keys.end(), [&](const KeyBinding& binding) {
            return KeyOf(binding.key) == event.key;
        });
        if (isKnown && m_sceneKeys.insert(event.key).second)
        {
            ScriptAction action = Action(ScriptAction::Kind::Press);
            action.key = static_cast<char>(event.key);
            Do(action);
        }
    }
}

void Workbench::KeyUp(Key key)
{
    m_input.keys.clear();
    BuildPanels(m_input);
    if (m_sceneKeys.erase(key) > 0)
    {
        ScriptAction action = Action(ScriptAction::Kind::Release);
        action.key = static_cast<char>(key);
        Do(action);
    }
}

/// Nobody will say when what is down goes up.
void Workbench::LetGo()
{
    while (!m_sceneKeys.empty())
    {
        KeyUp(*m_sceneKeys.begin());
    }
    m_input.keys.clear();
    m_input.buttons = {};
    if (std::exchange(m_hold, Hold::Nothing) == Hold::Scene)
    {
        DropAt(m_input.pointer);
    }
    BuildPanels(m_input);
}

/// Keys that go on while they are held.
bool Workbench::Steer(const WindowEvent& event)
{
    const double way = kPanByKey * Uncovered().height / Uncovered().pixelsPerMeter;
    const auto go = [&](int x, int y) {
        event.control ? Shift(float32(x) * kShiftByKey, float32(y) * kShiftByKey)
                      : Pan(x * way, y * way);
    };
    const Camera view = View();
    const Vec2 middle = view.ToPixel({float(Uncovered().centerX), float(Uncovered().centerY)});
    switch (event.key)
    {
    case Key::Left:
        go(-1, 0);
        return true;
    case Key::Right:
        go(1, 0);
        return true;
    case Key::Up:
        go(0, 1);
        return true;
    case Key::Down:
        go(0, -1);
        return true;
    case Key::Z:
        Zoom(1.0 / kZoomByKey, middle);
        return true;
    case Key::X:
        Zoom(kZoomByKey, middle);
        return true;
    case Key::O:
        if (!event.control)
        {
            Wish(PanelWish::Step);
            return true;
        }
        return false;
    default:
        return false;
    }
}

/// Keys that do something once.
bool Workbench::Shortcut(const WindowEvent& event)
{
    const bool isPicker = event.control && event.key == Key::O;
    if (event.control && !isPicker)
    {
        return false;
    }
    switch (event.key)
    {
    case Key::O:
        m_choices.showsPicker = true;
        SettlePicker();
        return true;
    case Key::P:
        m_choices.isPaused = !m_choices.isPaused;
        return true;
    case Key::R:
        Wish(PanelWish::Restart);
        return true;
    case Key::LeftBracket:
    case Key::PageUp:
        Wish(PanelWish::PreviousScene);
        return true;
    case Key::RightBracket:
    case Key::PageDown:
        Wish(PanelWish::NextScene);
        return true;
    case Key::Tab:
        m_choices.showsPanels = !m_choices.showsPanels;
        Cover();
        return true;
    case Key::Home:
        Wish(PanelWish::ResetView);
        return true;
    case Key::Space:
        Wish(PanelWish::Bomb);
        return true;
    case Key::Escape:
        m_isDone = true;
        return true;
    default:
        return false;
    }
}

/// While a bomb is pulled back, the way that it was.
void Workbench::AddSling(DrawList& list) const
{
    if (m_hold == Hold::Bomb)
    {
        DrawCollector collector(list);
        const b2Vec2 pulled = WorldAt(m_input.pointer);
        collector.DrawSegment(m_slingFrom, pulled, b2Color(0.9f, 0.9f, 0.3f));
        collector.DrawCircle(m_slingFrom, 0.3f, b2Color(0.9f, 0.9f, 0.3f));
    }
}

} // namespace boxreel
