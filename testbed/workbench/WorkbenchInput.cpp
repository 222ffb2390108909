// SPDX-License-Identifier: MIT
// Mouse and keyboard input of a workbench.
#include "Workbench.h"

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
} // namespace

void Workbench::Handle(const WindowEvent& event)
{
    m_input.pointer = event.point;
    m_input.shift = event.shift;
    m_input.control = event.control;
    switch (event.kind)
    {
    case Kind::ButtonDown:
        Button(event, true);
        break;
    case Kind::ButtonUp:
        Button(event, false);
        break;
    case Kind::Pointer:
        m_hand.Move(m_work, event);
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

void Workbench::Button(const WindowEvent& event, bool isDown)
{
    if (event.button < 0 || event.button >= int(m_input.buttons.size()))
    {
        return;
    }
    if (isDown)
    {
        BuildPanels(m_input); // with the mouse at its new position, before the button is down
    }
    m_input.buttons[std::size_t(event.button)] = isDown;
    BuildPanels(m_input);
    if (isDown)
    {
        m_hand.Press(m_work, event, m_panels.WantsPointer());
    }
    else
    {
        m_hand.Release(m_work, event);
    }
}

void Workbench::Turn(const WindowEvent& event)
{
    PanelInput input = m_input;
    input.wheel = event.wheel;
    BuildPanels(input);
    if (!m_panels.WantsPointer())
    {
        m_work.Zoom(std::pow(kZoomByNotch, double(event.wheel)), event.point);
    }
}

void Workbench::KeyDown(const WindowEvent& event)
{
    const bool isForPanels = m_panels.WantsKeys(m_choices);
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
        m_hand.PressKey(m_work, event.key);
    }
}

void Workbench::KeyUp(Key key)
{
    m_input.keys.clear();
    BuildPanels(m_input);
    m_hand.ReleaseKey(m_work, key);
}

void Workbench::LetGo()
{
    m_input.keys.clear();
    m_input.buttons = {};
    m_hand.LetGo(m_work, m_input.pointer);
    BuildPanels(m_input);
}

/// Keys that go on while they are held.
bool Workbench::Steer(const WindowEvent& event)
{
    const Camera view = m_work.Uncovered();
    const double way = kPanByKey * view.height / view.pixelsPerMeter;
    const auto go = [&](int x, int y) {
        event.control ? m_work.Shift(float32(x) * kShiftByKey, float32(y) * kShiftByKey)
                      : m_work.Pan(x * way, y * way);
    };
    const Vec2 middle = m_work.View().ToPixel({float(view.centerX), float(view.centerY)});
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
        m_work.Zoom(1.0 / kZoomByKey, middle);
        return true;
    case Key::X:
        m_work.Zoom(kZoomByKey, middle);
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

} // namespace boxreel
