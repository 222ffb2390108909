// SPDX-License-Identifier: MIT
#include "WorkbenchLog.h"

#include <golden/StateHash.h>
#include <script/ScriptWriter.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace boxreel
{
namespace
{

// Interval between logged positions of a moving view [s]. Cameras interpolate smoothly between
// them.
constexpr double kSecondsBetweenKeys = 0.25;

/// "1.5s", to the nanosecond.
std::string TimeOf(std::int64_t step, const Rational& stepsPerSecond)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.9fs",
                  double(step) * double(stepsPerSecond.den) / double(stepsPerSecond.num));
    return text;
}

/// The shortest text that reads back to the same number: a film of the script has the same frames.
std::string Exact(double value)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

} // namespace

void WorkbenchLog::Begin(std::string scene, std::vector<std::string> options,
                         const Rational& stepsPerSecond)
{
    m_script = {};
    m_script.scene = std::move(scene);
    m_script.options = std::move(options);
    m_stepsPerSecond = stepsPerSecond;
    m_seen.clear();
    m_lastStep = -1;
    m_isChosen = false;
}

void WorkbenchLog::Add(ScriptAction action, std::int64_t step, const b2World& world)
{
    constexpr auto kMove = ScriptAction::Kind::Move;
    if (step != m_lastStep)
    {
        m_lastStep = step;
        m_stateBefore = StateHashText(world);
    }
    action.at.when = step;
    std::vector<ScriptAction>& actions = m_script.actions;
    // Only the last place of the mouse before a step affects the step.
    if (action.kind == kMove && !actions.empty() && actions.back().kind == kMove &&
        std::get<std::int64_t>(actions.back().at.when) == step)
    {
        actions.pop_back();
    }
    actions.push_back(std::move(action));
}

void WorkbenchLog::See(const Camera& view, std::int64_t step, bool isChosen)
{
    m_isChosen = m_isChosen || isChosen;
    const Seen seen{step, view.centerX, view.centerY, view.height / view.pixelsPerMeter};
    const auto isSame = [&](const Seen& other) {
        return other.x == seen.x && other.y == seen.y && other.height == seen.height;
    };
    const std::size_t count = m_seen.size();
    if (count > 0 && m_seen.back().step >= step)
    {
        m_seen.back() = seen; // again, before the step
        m_seen.back().step = step;
    }
    else if (count > 1 && isSame(m_seen[count - 1]) && isSame(m_seen[count - 2]))
    {
        m_seen.back().step = step; // it rests
    }
    else
    {
        m_seen.push_back(seen);
    }
}

/// Returns the start and the end of each movement of the view, and times at intervals between them.
std::vector<WorkbenchLog::Seen> WorkbenchLog::Keys() const
{
    const std::int64_t apart =
        std::max<std::int64_t>(1, std::llround(kSecondsBetweenKeys * m_stepsPerSecond.ToDouble()));
    std::vector<Seen> keys;
    for (std::size_t i = 0; i < m_seen.size(); ++i)
    {
        const bool isEnd = i == 0 || i + 1 == m_seen.size();
        const bool rests = !isEnd && (m_seen[i].step - m_seen[i - 1].step > 1 ||
                                      m_seen[i + 1].step - m_seen[i].step > 1);
        if (isEnd || rests || m_seen[i].step - keys.back().step >= apart)
        {
            keys.push_back(m_seen[i]);
        }
    }
    return keys;
}

std::string WorkbenchLog::Text(std::int64_t step, const b2World& world) const
{
    Script script = m_script;
    if (m_isChosen)
    {
        for (const Seen& key : Keys())
        {
            script.camera.emplace_back(TimeOf(key.step, m_stepsPerSecond),
                                       Exact(key.x) + "," + Exact(key.y) + "," + Exact(key.height));
        }
    }
    ScriptProduct end;
    end.kind = ScriptProduct::Kind::ExpectState;
    end.at.when = step;
    end.name = step == m_lastStep ? m_stateBefore : StateHashText(world);
    script.products.push_back(std::move(end));
    return "# What was done in the window, step by step. Play it: boxreel play FILE\n" +
           WriteScript(script);
}

} // namespace boxreel
