// SPDX-License-Identifier: MIT
#pragma once

#include "SceneSession.h"

#include <ui/Panels.h>

#include <memory>

/// Connects a session with the panels, in a window and without one: facts in one direction, choices
/// the other.
namespace boxreel
{

/// `isTimed`: with where the time of the last step went, which no two runs share.
PanelFacts FactsOf(SceneSession& session, bool isTimed);

/// Returns the current solver settings of the session's world.
SolverChoices SolverOf(const SceneSession& session);

/// Applies the settings that may change during a session: all except the rate.
void Apply(const SolverChoices& solver, SceneSession& session);

/// Returns the names and new values of the choices that differ, as in scripts: {"sleep", "off"}.
std::vector<std::pair<std::string, std::string>> Differences(const SolverChoices& before,
                                                             const SolverChoices& after);

/// Panels of a recorded session. A script can click them when they are hidden.
Result<std::shared_ptr<SessionCompanion>> CreateScriptedPanels(const SceneLook& look,
                                                               const SceneSession& session);

/// Opens a session, with panels if its look or its script requests them.
Result<SceneSession> OpenSession(SceneSource source, SceneLook look);

} // namespace boxreel
