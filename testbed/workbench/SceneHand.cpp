// SPDX-License-Identifier: MIT
#include "SceneHand.h"

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

constexpr float32 kSlingSpeed = 6.0f; // of a bomb, for each metre it was pulled [1/s]

using Kind = ScriptAction::Kind;

ScriptAction Action(Kind kind, const b2Vec2& point)
{
    ScriptAction action;
    action.kind = kind;
    action.point = point;
    return action;
}

ScriptAction Action(Kind kind, Key key)
{
    ScriptAction action;
    action.kind = kind;
    action.key = static_cast<char>(key);
    return action;
}

/// Scripts let go where the mouse was last.
void DropAt(SceneWork& work, Vec2 pixel)
{
    work.Do(Action(Kind::Move, work.WorldAt(pixel)));
    work.Do(Action(Kind::Drop, work.WorldAt(pixel)));
}

} // namespace

void SceneHand::Press(SceneWork& work, const WindowEvent& event, bool isOnPanels)
{
    if (m_hold != Hold::Nothing)
    {
        return; // another button is down
    }
    m_button = event.button;
    m_at = event.point;
    if (isOnPanels)
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
        m_slingFrom = work.WorldAt(event.point);
    }
    else
    {
        m_hold = Hold::Scene;
        work.Do(Action(Kind::Grab, work.WorldAt(event.point)));
    }
}

void SceneHand::Release(SceneWork& work, const WindowEvent& event)
{
    if (event.button != m_button)
    {
        return;
    }
    const Hold held = std::exchange(m_hold, Hold::Nothing);
    if (held == Hold::Scene)
    {
        DropAt(work, event.point);
    }
    else if (held == Hold::Bomb)
    {
        ScriptAction bomb = Action(Kind::Sling, m_slingFrom);
        bomb.velocity = kSlingSpeed * (m_slingFrom - work.WorldAt(event.point));
        work.Do(bomb);
    }
}

void SceneHand::Move(SceneWork& work, const WindowEvent& event)
{
    if (m_hold == Hold::Scene)
    {
        work.Do(Action(Kind::Move, work.WorldAt(event.point)));
    }
    else if (m_hold == Hold::View)
    {
        const double scale = work.View().pixelsPerMeter;
        work.Pan(double(m_at.x - event.point.x) / scale, double(event.point.y - m_at.y) / scale);
        m_at = event.point;
    }
}

void SceneHand::PressKey(SceneWork& work, Key key)
{
    const auto keys = work.Session().CurrentScene().Keys();
    const bool isKnown = std::any_of(keys.begin(), keys.end(), [key](const KeyBinding& binding) {
        return KeyOf(binding.key) == key;
    });
    if (isKnown && m_keys.insert(key).second)
    {
        work.Do(Action(Kind::Press, key));
    }
}

void SceneHand::ReleaseKey(SceneWork& work, Key key)
{
    if (m_keys.erase(key) > 0)
    {
        work.Do(Action(Kind::Release, key));
    }
}

void SceneHand::LetGo(SceneWork& work, Vec2 pointer)
{
    while (!m_keys.empty())
    {
        ReleaseKey(work, *m_keys.begin());
    }
    if (std::exchange(m_hold, Hold::Nothing) == Hold::Scene)
    {
        DropAt(work, pointer);
    }
}

void SceneHand::Forget()
{
    m_keys.clear();
    m_hold = m_hold == Hold::Scene || m_hold == Hold::Bomb ? Hold::Nothing : m_hold;
}

void SceneHand::AddSling(const SceneWork& work, Vec2 pointer, DrawList& list) const
{
    if (m_hold == Hold::Bomb)
    {
        const b2Vec2 pulled = work.WorldAt(pointer);
        const Vec2 from{m_slingFrom.x, m_slingFrom.y};
        list.AddSegment(from, {pulled.x, pulled.y}, ColorRole::ContactImpulse);
        list.AddCircle(from, 0.3f, ColorRole::ContactImpulse);
    }
}

} // namespace boxreel
