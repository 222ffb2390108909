// SPDX-License-Identifier: MIT
#include "SessionPanels.h"

#include <base/ErrorMacros.h>

#include <cmath>
#include <utility>

namespace boxreel
{
namespace
{

/// Returns the times of the last step's stages, in the panel's order [ms].
std::array<float, kStageNames.size()> TimesOf(const b2Profile& profile)
{
    return {profile.step,          profile.collide,       profile.solve,    profile.solveInit,
            profile.solveVelocity, profile.solvePosition, profile.solveTOI, profile.broadphase};
}

} // namespace

PanelFacts FactsOf(SceneSession& session, bool isTimed)
{
    const b2World& world = session.World();
    PanelFacts facts;
    facts.scene = session.Title();
    facts.step = session.SceneStep();
    facts.seconds = session.Time();
    facts.bodies = world.GetBodyCount();
    facts.awake = world.GetAwakeBodyCount();
    facts.contacts = world.GetContactCount();
    facts.joints = world.GetJointCount();
    facts.proxies = world.GetProxyCount();
    facts.treeHeight = world.GetTreeHeight();
    facts.treeBalance = world.GetTreeBalance();
    facts.treeQuality = double(world.GetTreeQuality());
    const auto keys = session.CurrentScene().Keys();
    facts.keys.assign(keys.begin(), keys.end());
    facts.description = session.CurrentScene().Describe();
    if (isTimed)
    {
        facts.times = TimesOf(world.GetProfile());
    }
    return facts;
}

SolverChoices SolverOf(const SceneSession& session)
{
    SolverChoices solver;
    solver.hertz = static_cast<int>(std::lround(session.StepsPerSecond().ToDouble()));
    ReadSettings(solver, session.World(), session.Steps());
    return solver;
}

void Apply(const PanelChoices& choices, SceneLook& look)
{
    look.layers = choices.layers;
    look.labels = choices.labels;
}

void Apply(const PanelChoices& choices, SceneSession& session)
{
    session.SetLayers(choices.layers, choices.labels);
}

void ReadChoices(PanelChoices& choices, const SceneSession& session)
{
    choices.solver = SolverOf(session);
    choices.layers = session.Look().layers;
    choices.labels = session.Look().labels;
    choices.isPaused = session.IsPaused();
}

Result<SceneSession> OpenSession(SceneSource source, SceneLook look)
{
    const bool isClicked =
        look.simulation.script != nullptr && look.simulation.script->UsesPanels();
    if (!look.panels.testbed && !isClicked)
    {
        return SceneSession::Open(std::move(source), look);
    }
    if (look.panels.testbed)
    {
        look.panels.covered = Panels::kColumnWidth;
    }
    Result<SceneSession> session = SceneSession::Open(std::move(source), look);
    if (!session)
    {
        return session;
    }
    ASSIGN_OR_RETURN(std::shared_ptr<SessionCompanion> panels,
                     CreateScriptedPanels(look, *session));
    session->SetCompanion(std::move(panels));
    return session;
}

} // namespace boxreel
