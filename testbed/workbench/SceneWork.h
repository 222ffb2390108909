// SPDX-License-Identifier: MIT
#pragma once

#include "WorkbenchLog.h"

#include <session/SessionPanels.h>

#include <string>

/// A scene with its user. User actions and views are logged, so a script can repeat them.
namespace boxreel
{

class SceneWork
{
public:
    /// Call Begin first.
    explicit SceneWork(SceneSession session) : m_session(std::move(session)) {}

    /// The session is at its start: a script begins, whose first actions make the solver `wanted`.
    void Begin(const SolverChoices& wanted);

    SceneSession& Session() { return m_session; }
    const SceneSession& Session() const { return m_session; }
    WorkbenchLog& Log() { return m_log; }
    /// The scene's own, before anything was set.
    const SolverChoices& Preferred() const { return m_preferred; }
    /// Returns the actions since the scene began, as a script.
    std::string Script() const { return m_log.Text(m_session.SceneStep(), m_session.World()); }

    void Do(const ScriptAction& action); ///< to the scene
    void Set(const std::string& name,
             const std::string& value); ///< changes a setting of the solver
    void Step();                        ///< simulates one

    Camera View() const;      ///< at full size, over the whole window
    Camera Uncovered() const; ///< the part of the view that no panel covers, at scale 1
    b2Vec2 WorldAt(Vec2 pixel) const;
    void LookAt(double x, double y, double pixelsPerMeter); ///< the middle of what is uncovered [m]
    void Pan(double x, double y);                           ///< the middle goes by so much [m]
    void Zoom(double factor, Vec2 about); ///< the point at `about` [px] stays there
    /// Makes the point (x, y) the origin [m]. The visible area stays the same, unless the view
    /// follows a body.
    void Shift(float32 x, float32 y);

private:
    SceneSession m_session;
    SolverChoices m_preferred;
    WorkbenchLog m_log;
};

} // namespace boxreel
