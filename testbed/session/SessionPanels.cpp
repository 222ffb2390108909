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
    facts.remarks = session.CurrentScene().Describe();
    if (isTimed)
    {
        facts.times = TimesOf(world.GetProfile());
    }
    return facts;
}

SolverChoices SolverOf(const SceneSession& session)
{
    const b2World& world = session.World();
    SolverChoices solver;
    solver.velocityIterations = session.Steps().velocityIterations;
    solver.positionIterations = session.Steps().positionIterations;
    solver.subSteps = world.GetSubStepCount();
    solver.hertz = static_cast<int>(std::lround(session.StepsPerSecond().ToDouble()));
    solver.sleep = world.GetAllowSleeping();
    solver.warmStarting = world.GetWarmStarting();
    solver.continuous = world.GetContinuousPhysics();
    solver.subStepping = world.GetSubStepping();
    return solver;
}

void Apply(const SolverChoices& solver, SceneSession& session)
{
    b2World& world = session.World();
    session.Steps().velocityIterations = solver.velocityIterations;
    session.Steps().positionIterations = solver.positionIterations;
    world.SetSubStepCount(solver.subSteps);
    world.SetAllowSleeping(solver.sleep);
    world.SetWarmStarting(solver.warmStarting);
    world.SetContinuousPhysics(solver.continuous);
    world.SetSubStepping(solver.subStepping);
}

std::vector<std::pair<std::string, std::string>> Differences(const SolverChoices& before,
                                                             const SolverChoices& after)
{
    std::vector<std::pair<std::string, std::string>> changed;
    const auto number = [&](const char* name, int SolverChoices::*value) {
        if (before.*value != after.*value)
        {
            changed.emplace_back(name, std::to_string(after.*value));
        }
    };
    const auto flag = [&](const char* name, bool SolverChoices::*value) {
        if (before.*value != after.*value)
        {
            changed.emplace_back(name, after.*value ? "on" : "off");
        }
    };
    number("velocity-iterations", &SolverChoices::velocityIterations);
    number("position-iterations", &SolverChoices::positionIterations);
    number("sub-steps", &SolverChoices::subSteps);
    flag("sleep", &SolverChoices::sleep);
    flag("warm-starting", &SolverChoices::warmStarting);
    flag("continuous", &SolverChoices::continuous);
    flag("sub-stepping", &SolverChoices::subStepping);
    return changed;
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
