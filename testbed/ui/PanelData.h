// SPDX-License-Identifier: MIT
#pragma once

#include <base/Words.h>
#include <options/SceneLayers.h>
#include <scenes/Scene.h>
#include <script/SolverSettings.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Plain data exchanged between the panels and their owner, in both directions.
namespace boxreel
{

/// The stages of a step that are timed, in the order of the panel.
inline constexpr std::array<const char*, 8> kStageNames{
    "step", "collide", "solve", "init", "velocity", "position", "TOI", "broad-phase"};

/// The data that panels show.
struct PanelFacts
{
    std::string scene;
    std::int64_t step = 0;
    double seconds = 0.0; ///< simulated
    int bodies = 0;
    int awake = 0; ///< of the bodies
    int contacts = 0;
    int joints = 0;
    int proxies = 0;
    int treeHeight = 0;
    int treeBalance = 0;
    double treeQuality = 0.0;
    std::vector<KeyBinding> keys;                                 ///< that the scene answers to
    std::vector<std::pair<std::string, std::string>> description; ///< of the scene by itself
    std::optional<std::array<float, kStageNames.size()>> times;   ///< of the last step [ms]; none:
                                                                  ///< not measured
    bool isWindow = true;              ///< true in the window; films cannot write files
    std::optional<double> filmSeconds; ///< of the film that is being recorded
    std::string message;               ///< the last action
};

/// The settings that panels change.
struct PanelChoices
{
    bool isPaused = false;
    bool showsPanels = true;
    bool showsPicker = false;
    SolverChoices solver;
    bool keepsSolver = false; ///< for other scenes, too
    LayerSet layers;
    bool labels = false; ///< the numbers of bodies
    bool statistics = true;
    bool profile = true;
    std::string theme = "classic";
    bool filmsPanels = false; ///< they are seen in films
    friend bool operator==(const PanelChoices&, const PanelChoices&) = default;
};

/// Calls `visit(name, value)` for each choice that the window keeps from run to run, with its name
/// in the file. The names of the solver's are those of their table.
template <class Choices, class Visit>
void VisitKept(Choices& choices, const Visit& visit)
{
    visit("panels", choices.showsPanels);
    visit("keep solver", choices.keepsSolver);
    for (const LayerInfo& layer : kOptionalLayers)
    {
        visit(layer.option, choices.layers[layer.layer]);
    }
    visit("numbers", choices.labels);
    visit("statistics", choices.statistics);
    visit("profile", choices.profile);
    visit("theme", choices.theme);
    visit("film panels", choices.filmsPanels);
    visit("hertz", choices.solver.hertz);
    for (const SolverSetting& setting : SolverSettings())
    {
        const std::string name = Lower(setting.label);
        std::visit([&](auto member) { visit(name.c_str(), choices.solver.*member); },
                   setting.member);
    }
}

/// A one-time request.
enum class PanelWish
{
    Step,
    Restart,
    NextScene,
    PreviousScene,
    ResetView,
    Bomb,
    Film, ///< begin or end one
    FigureSvg,
    FigurePng,
    Script,
};

struct PanelAnswer
{
    std::vector<PanelWish> wishes;
    std::string scene; ///< that was chosen; empty: none
};

} // namespace boxreel
