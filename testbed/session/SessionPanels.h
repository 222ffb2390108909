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

/// Applies the choices that the window and films share, except those of the solver, to a session
/// and to the look of one that is to be opened.
void Apply(const PanelChoices& choices, SceneSession& session);
void Apply(const PanelChoices& choices, SceneLook& look);

/// Reads the same choices and those of the solver.
void ReadChoices(PanelChoices& choices, const SceneSession& session);

/// Panels of a recorded session. A script can click them when they are hidden.
Result<std::shared_ptr<SessionCompanion>> CreateScriptedPanels(const SceneLook& look,
                                                               const SceneSession& session);

/// Opens a session, with panels if its look or its script requests them.
Result<SceneSession> OpenSession(SceneSource source, SceneLook look);

} // namespace boxreel
