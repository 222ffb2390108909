// SPDX-License-Identifier: MIT
#include "Declare.h"

#include <base/ErrorMacros.h>

namespace boxreel
{
namespace
{

constexpr std::uint32_t kLargestSeed = 0xffffffffu;
// Smallest picture that leaves room for the scene beside the panels [px].
constexpr int kMinPanelWidth = 480;
constexpr int kMinPanelHeight = 240;
// Size of the panel of --hud [px].
constexpr int kHudWidth = 200;
constexpr int kHudHeight = 130;
constexpr int kHudMsHeight = 150;

/// A theme's name, or "both" where `bothThemes` may say so.
void AddTheme(Command& command, SceneLook& look, bool* bothThemes)
{
    std::vector<std::string> names(ThemeNames().begin(), ThemeNames().end());
    if (bothThemes != nullptr)
    {
        names.emplace_back("both");
    }
    const auto read = [&look, bothThemes, names](const std::string& text) -> Result<void> {
        const std::optional<Theme> theme = FindTheme(text);
        if (!theme && text == "both")
        {
            if (bothThemes == nullptr)
            {
                return BadValue("--theme", text, "a film can have only one theme",
                                "use one of " + JoinedBy(", ", names));
            }
            *bothThemes = true;
            return {};
        }
        if (!theme)
        {
            return NotOneOf("--theme", text, names);
        }
        look.theme = *theme;
        return {};
    };
    AddText(command, "--theme", "NAME", read,
            "Set the colours: " + JoinedBy(", ", names) + " (classic)")
        .Group("Picture")
        .Completes({Completion::Kind::Words, names});
}

void AddSize(Command& command, SceneLook& look)
{
    const auto read = [&look](const std::string& text) -> Result<void> {
        ASSIGN_OR_RETURN(const PixelSize size, ParseSize("--size", text));
        look.width = size.width;
        look.height = size.height;
        return {};
    };
    AddText(command, "--size", "WxH", read, "Set width and height in pixels (1280x720)")
        .Group("Picture");
}

} // namespace

void AddLook(Command& command, SceneLook& look, bool* bothThemes)
{
    const auto parseHertz = [](const std::string& option, const std::string& text) {
        return ParseRatio(option, text, 1.0, 100000.0);
    };
    AddSize(command, look);
    AddTheme(command, look, bothThemes);
    AddValue(command, "--camera", "VIEW", look.view, ParseView,
             "Set the view (scene: the scene's own view, or fit).\n"
             "fit: keep all moving bodies in view; fit:world: all bodies;\n"
             "fit:3,17: these bodies. follow:3,17 or follow:17:HEIGHT: keep these\n"
             "in the centre. X,Y,HEIGHT: fix centre and height, in metres.\n"
             "\"path:0s=X,Y,HEIGHT;3s=X,Y,HEIGHT\": move from key to key")
        .Group("Picture");
    AddValue(command, "--draw", "LAYERS", look.layers, ParseLayers,
             Filled("Draw these layers (" + TextOf(LayerSet()) + "). All: ", LayerNames(), ","))
        .Group("Picture")
        .Completes({Completion::Kind::List, LayerNames()});
    AddValue(command, "--velocity-scale", "S", look.arrows.velocitySeconds,
             NumberBetween(1e-6, 1e6, "must be seconds from 1e-6 to 1e6, such as 0.2"),
             "Draw a velocity as the displacement in S seconds (0.2)")
        .Group("Picture");
    AddValue(
        command, "--force-scale", "M", look.arrows.metersPerNewton,
        NumberBetween(1e-12, 1e12, "must be metres per newton from 1e-12 to 1e12, such as 0.01"),
        "Draw forces, friction and impulses at M metres per newton, averaged\n"
        "over a step (draws the mean weight at 1/8 of the mean body size for\n"
        "joints, at 1/3 for contacts)")
        .Group("Picture");
    AddFlag(command, "--labels", look.labels, "Show the number of each body").Group("Picture");
    AddFlag(command, "--hud", look.panels.hud, "Show a panel with time, step, bodies, contacts")
        .Group("Picture");
    AddFlag(command, "--hud-ms", look.panels.milliseconds,
            "Show this panel with the milliseconds per step")
        .Group("Picture");
    AddFlag(command, "--ui", look.panels.testbed,
            "Show the panels of `boxreel ui`; with --hud-ms\n"
            "also the time of each part of the solver")
        .Group("Picture");
    AddValue(command, "--hz", "RATE", look.simulation.stepsPerSecond, parseHertz,
             "Set simulation steps per second (60; a scene file has its own)")
        .Group("Simulation");
    AddValue(command, "--seed", "N", look.simulation.seed, WholeBetween(0, kLargestSeed),
             "Seed the scene's random numbers (1)")
        .Group("Simulation");
    AddValue(command, "--velocity-iterations", "N", look.simulation.velocityIterations,
             WholeBetween(1, 1000),
             "Set the solver's velocity iterations per step\n(8; a scene file has its own)")
        .Group("Simulation");
    AddValue(command, "--position-iterations", "N", look.simulation.positionIterations,
             WholeBetween(1, 1000),
             "Set the solver's position iterations per step\n(3; a scene file has its own)")
        .Group("Simulation");
}

Result<void> CheckHud(SceneLook& look)
{
    if (look.panels.testbed && look.panels.hud)
    {
        return Conflict("--hud", "--ui");
    }
    const auto needs = [&look](const char* option, int width, int height) {
        const bool fits = look.width >= width && look.height >= height;
        return fits ? Result<void>()
                    : Error{ErrorKind::Unusable, option,
                            "requires a picture of at least " + std::to_string(width) + "x" +
                                std::to_string(height) + " pixels",
                            "give a larger --size"};
    };
    if (look.panels.testbed)
    {
        return needs("--ui", kMinPanelWidth, kMinPanelHeight);
    }
    look.panels.hud = look.panels.hud || look.panels.milliseconds;
    return look.panels.hud
               ? needs("--hud", kHudWidth, look.panels.milliseconds ? kHudMsHeight : kHudHeight)
               : Result<void>();
}

} // namespace boxreel
