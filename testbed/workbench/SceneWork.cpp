// SPDX-License-Identifier: MIT
#include "SceneWork.h"

#include <script/SolverSettings.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace boxreel
{
namespace
{

constexpr double kMinHeight = 1e-3; // of a view [m] …
constexpr double kMaxHeight = 1e6;  // … beyond which nothing is to be seen

} // namespace

void SceneWork::Begin(const SolverChoices& wanted)
{
    m_preferred = SolverOf(m_session);
    const Camera view = Uncovered();
    std::vector<std::string> options{"--size", std::to_string(view.width) + "x" +
                                                   std::to_string(view.height)};
    const SceneLook& look = m_session.Look();
    if (look.simulation.seed != 1)
    {
        options.insert(options.end(), {"--seed", std::to_string(look.simulation.seed)});
    }
    if (const std::optional<Rational>& rate = look.simulation.stepsPerSecond)
    {
        options.insert(options.end(),
                       {"--hz", std::to_string(rate->num) +
                                    (rate->den == 1 ? "" : "/" + std::to_string(rate->den))});
    }
    m_log.Begin(m_session.Asked(), std::move(options), m_session.StepsPerSecond());
    for (const auto& [name, value] : Differences(m_preferred, wanted))
    {
        Set(name, value);
    }
    m_log.See(view, 0, m_session.HasOwnView());
}

void SceneWork::Do(const ScriptAction& action)
{
    m_log.Add(action, m_session.SceneStep(), m_session.World());
    Perform(action, m_session.CurrentScene(), m_session.Steps());
}

void SceneWork::Set(const std::string& name, const std::string& value)
{
    ScriptAction action;
    action.kind = ScriptAction::Kind::Set;
    action.name = name;
    action.value = *ParseSetting(name, value);
    Do(action);
}

void SceneWork::Step()
{
    m_session.Pause(false);
    m_session.AdvanceTo(m_session.Step() + 1);
    m_log.See(Uncovered(), m_session.SceneStep(), m_session.HasOwnView());
}

Camera SceneWork::View() const
{
    return Scaled(m_session.CurrentCamera(), m_session.Look().scale);
}

Camera SceneWork::Uncovered() const
{
    Camera view = m_session.CurrentCamera();
    const int covered = view.width - m_session.UncoveredWidth();
    view.width -= covered;
    view.centerX -= 0.5 * covered / view.pixelsPerMeter;
    return view;
}

b2Vec2 SceneWork::WorldAt(Vec2 pixel) const
{
    const Vec2 point = View().ToWorld(pixel);
    return b2Vec2(point.x, point.y);
}

void SceneWork::LookAt(double x, double y, double pixelsPerMeter)
{
    m_session.LookAt(b2Vec2(float32(x), float32(y)), pixelsPerMeter);
}

void SceneWork::Pan(double x, double y)
{
    const Camera view = Uncovered();
    LookAt(view.centerX + x, view.centerY + y, view.pixelsPerMeter);
}

void SceneWork::Zoom(double factor, Vec2 about)
{
    const Camera view = Uncovered();
    const double height = view.height / view.pixelsPerMeter;
    const double newHeight = std::clamp(height / factor, kMinHeight, kMaxHeight);
    const double share = 1.0 - newHeight / height; // of the way from the middle to the point
    const b2Vec2 point = WorldAt(about);
    LookAt(view.centerX + share * (double(point.x) - view.centerX),
           view.centerY + share * (double(point.y) - view.centerY), view.height / newHeight);
}

void SceneWork::Shift(float32 x, float32 y)
{
    const Camera view = Uncovered();
    ScriptAction shift;
    shift.kind = ScriptAction::Kind::Shift;
    shift.point = b2Vec2(x, y);
    Do(shift);
    if (!m_session.Follows())
    {
        LookAt(view.centerX - double(x), view.centerY - double(y), view.pixelsPerMeter);
    }
}

} // namespace boxreel
