// SPDX-License-Identifier: MIT
#include "CommandLineOptions.h"

namespace boxreel
{

void DeclareUi(CLI::App& program, ParsedOptions& parsed)
{
    UiOptions& ui = parsed.ui;
    CLI::App* command = program.add_subcommand("ui", "Work at a scene in a window");
    AddScene(*command, ui.scene)->group(kMayBeLeftOut);
    AddText(
        *command, "--size",
        [&ui](const std::string& text) {
            const Result<PixelSize> size = ParseSize("--size", text);
            if (!size)
            {
                Refuse(size.GetError().Text());
            }
            ui.size = *size;
        },
        "Of the window in pixels, as far as the display has room\n(as it was; 1280x720)")
        ->type_name("WxH");
    const std::vector<std::string> themes(ThemeNames().begin(), ThemeNames().end());
    const auto readTheme = [&ui, themes](const std::string& text) {
        if (!FindTheme(text))
        {
            Refuse(NotOneOf("--theme", text, themes).Text());
        }
        ui.theme = text;
    };
    CLI::Option* theme =
        AddText(*command, "--theme", readTheme, ListedWords(themes) + " (as it was; classic)");
    Completes(theme->type_name("NAME"), {Completion::Kind::Words, themes});
    AddValue(*command, "--seed", "N", ui.seed, WholeBetween(0, 0xffffffffll),
             "Of the scene's random numbers (1)");
    AddValue(*command, "--hz", "RATE", ui.stepsPerSecond, RatioBetween(5.0, 480.0),
             "Simulation steps a second (as the scene prefers; 60)");
    AddPath(*command, "--into", "DIR", ui.into,
            "Folder for films, figures and scripts (the current one)");
    AddFlag(*command, "--paused", ui.isPaused, "Begin paused; O makes a step, P goes on");
    AddFlag(*command, "--fresh", ui.fresh, "As if for the first time; nothing is kept, either");
    AddBackend(*command, ui.backend);
    command->footer(
        "Keys:\n"
        "  P pause and go on    O a step             R restart           [ ] other scenes\n"
        "  Ctrl+O find a scene  Tab hide panels      Home reset view     Esc quit\n"
        "  Z X, wheel zoom      arrows, right drag pan                   Ctrl+arrows shift origin\n"
        "  left drag pull a body                     Space, Shift+drag bombs\n"
        "The window keeps its size, scene, theme and what it draws for the next time, in\n"
        "$XDG_CONFIG_HOME/boxreel/ui.json (~/.config). When it is closed it says the step and the\n"
        "state of the world. Record writes a film of what follows, SVG and PNG a figure, Script\n"
        "what was done since the scene began, for `boxreel play`.\n\n"
        "Examples:\n"
        "  boxreel ui\n"
        "  boxreel ui car --paused\n"
        "  boxreel ui scene.json --size 1600x900 --into films");
}

} // namespace boxreel
