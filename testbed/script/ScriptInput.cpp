// SPDX-License-Identifier: MIT
#include "ScriptInput.h"

#include "SolverSettings.h"

#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Unusable.h>
#include <base/Words.h>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

using Kind = ScriptAction::Kind;

constexpr std::int64_t kLongestDrag = 1'000'000; // steps: more than four hours

/// "d (drives forward), a (brakes)".
std::string KeysOf(const Scene& scene)
{
    return JoinedBy(", ", scene.Keys(), [](const KeyBinding& binding) {
        return std::string(1, binding.key) + " (" + binding.effect + ")";
    });
}

Result<void> CheckKey(const Script& script, const ScriptAction& action, const Scene& scene)
{
    const auto keys = scene.Keys();
    const bool isKey = action.kind == Kind::Press || action.kind == Kind::Release;
    const bool isKnown = std::any_of(keys.begin(), keys.end(), [&](const KeyBinding& binding) {
        return binding.key == action.key;
    });
    if (!isKey || isKnown)
    {
        return {};
    }
    return script.At(action.line,
                     Unusable(Quoted(std::string(1, action.key)), "the scene does not use this key",
                              keys.empty() ? "" : "use one of " + KeysOf(scene)));
}

} // namespace

Result<void> ScriptInput::Add(const Script& script, const ScriptAction& action,
                              const Rational& stepsPerSecond)
{
    const std::int64_t first = action.at.Step(stepsPerSecond);
    if (action.kind != Kind::Drag)
    {
        m_events.push_back({first, action});
        return {};
    }
    const std::int64_t last = action.until.Step(stepsPerSecond);
    if (last <= first || last - first > kLongestDrag)
    {
        return script.At(action.line,
                         Unusable("'drag'", last <= first
                                                ? "must end at least one step after it begins"
                                                : "takes more than a million steps"));
    }
    for (std::int64_t step = first; step < last; ++step)
    {
        const double share = double(step + 1 - first) / double(last - first);
        m_events.push_back({step, action, float32(share)});
    }
    return {};
}

/// Tracks the position of the mouse for actions that move or release it.
Result<void> ScriptInput::FollowMouse(const Script& script)
{
    bool holds = false;
    b2Vec2 point(0.0f, 0.0f);
    b2Vec2 start(0.0f, 0.0f);
    int dragLine = 0;
    for (Event& event : m_events)
    {
        ScriptAction& action = event.action;
        const bool isMouse = action.kind == Kind::Grab || action.kind == Kind::Move ||
                             action.kind == Kind::Drag || action.kind == Kind::Drop;
        if (!isMouse)
        {
            continue;
        }
        if (action.kind == Kind::Grab ? holds : (action.kind != Kind::Move && !holds))
        {
            return script.At(
                action.line,
                Unusable("mouse", holds ? "the button is already down" : "the button is not down",
                         holds ? "drop first" : "grab first"));
        }
        holds = action.kind != Kind::Drop && (holds || action.kind == Kind::Grab);
        if (action.kind == Kind::Drag)
        {
            if (action.line != dragLine)
            {
                dragLine = action.line;
                start = point;
            }
            const float32 share = event.share;
            const b2Vec2 end = action.point;
            action.point = share == 1.0f ? end : start + share * (end - start);
        }
        if (action.kind == Kind::Drop)
        {
            action.point = point;
        }
        point = action.point;
    }
    return {};
}

Result<ScriptInput> ScriptInput::Create(const Script& script, const Rational& stepsPerSecond,
                                        const Scene& scene)
{
    ScriptInput input;
    for (const ScriptAction& action : script.actions)
    {
        RETURN_IF_ERROR(CheckKey(script, action, scene));
        RETURN_IF_ERROR(input.Add(script, action, stepsPerSecond));
    }
    std::stable_sort(input.m_events.begin(), input.m_events.end(),
                     [](const Event& a, const Event& b) { return a.step < b.step; });
    RETURN_IF_ERROR(input.FollowMouse(script));
    return input;
}

std::span<const ScriptInput::Event> ScriptInput::At(std::int64_t step) const
{
    const auto first = std::lower_bound(m_events.begin(), m_events.end(), step,
                                        [](const Event& e, std::int64_t s) { return e.step < s; });
    const auto end = std::find_if(first, m_events.end(),
                                  [step](const Event& event) { return event.step != step; });
    return {first, end};
}

std::vector<ScriptAction> ScriptInput::ForPanels(std::int64_t step) const
{
    std::vector<ScriptAction> actions;
    for (const Event& event : At(step))
    {
        if (event.action.IsForPanels())
        {
            actions.push_back(event.action);
        }
    }
    return actions;
}

void ScriptInput::Apply(Scene& scene, StepSettings& steps, std::int64_t step) const
{
    for (const Event& event : At(step))
    {
        Perform(event.action, scene, steps);
    }
}

void Perform(const ScriptAction& action, Scene& scene, StepSettings& steps)
{
    switch (action.kind)
    {
    case Kind::Press:
        scene.KeyDown(action.key);
        break;
    case Kind::Release:
        scene.KeyUp(action.key);
        break;
    case Kind::Grab:
        scene.MouseDown(action.point);
        break;
    case Kind::Move:
    case Kind::Drag:
        scene.MouseMove(action.point);
        break;
    case Kind::Drop:
        scene.MouseUp(action.point);
        break;
    case Kind::Bomb:
        scene.ThrowBomb();
        break;
    case Kind::Sling:
        scene.ThrowBomb(action.point, action.velocity);
        break;
    case Kind::Shift:
        scene.ShiftOrigin(action.point);
        break;
    case Kind::Set:
        ApplySetting(action.name, action.value, scene.World(), steps);
        break;
    case Kind::Click:
    case Kind::Type:
    case Kind::Hit:
        break;
    }
}

} // namespace boxreel
