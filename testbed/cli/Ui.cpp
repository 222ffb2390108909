// SPDX-License-Identifier: MIT
#include "Ui.h"
#include "Declare.h"
// `boxreel ui`: the window.

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <film/StopSignals.h>
#include <options/OptionNames.h>
#include <render/Renderer.h>
#include <render/Window.h>
#include <ui/UiSettings.h>
#include <workbench/Workbench.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace boxreel
{
namespace
{

using Clock = std::chrono::steady_clock;

// Interval at which the window checks for signals while nothing moves [s].
constexpr double kRest = 0.1;
// Pause between frames of a scene in which nothing visible moves, to avoid a busy loop.
constexpr std::chrono::milliseconds kPause(4);

Error WithoutWindow(const Error& error)
{
    return {error.kind, error.culprit, error.problem,
            (error.remedy.empty() ? "" : error.remedy + "; ") +
                std::string("`boxreel record`, `shot` and `play` need no display")};
}

/// A window with its workbench and its renderer, until it is closed.
class Desk
{
public:
    Desk(Window window, const UiOptions& options) : m_window(std::move(window)), m_options(options)
    {}

    Result<void> Open(const UiSettings& settings);
    Result<void> Run();
    UiSettings Settings() const;
    const Workbench& Bench() const { return *m_bench; }

private:
    Result<SceneSource> Source(const UiSettings& settings) const;
    Result<void> Prepare();
    Result<void> Show();
    void HandleEvents();

    Window m_window;
    const UiOptions& m_options;
    std::optional<Workbench> m_bench;
    std::optional<Renderer> m_renderer; // before the window it goes
    int m_width = 0;                    // of its picture [px]
    int m_height = 0;
    std::string m_theme;  // that it draws in
    bool m_isLost = true; // what the window shows
    std::string m_title;
};

/// Returns the requested scene, otherwise the last one, otherwise the first of all.
Result<SceneSource> Desk::Source(const UiSettings& settings) const
{
    if (!m_options.scene.empty())
    {
        return OpenScene(m_options.scene);
    }
    Result<SceneSource> last = OpenScene(settings.scene);
    return last ? std::move(last) : OpenScene("Pyramid");
}

Result<void> Desk::Open(const UiSettings& settings)
{
    ASSIGN_OR_RETURN(SceneSource source, Source(settings));
    for (const RubeNote& part : source.leftOut)
    {
        WriteMessage("left out: " + part.Text());
    }
    WorkbenchSettings bench;
    bench.choices = settings.choices;
    bench.choices.isPaused = m_options.isPaused;
    bench.choices.theme = m_options.theme.empty() ? settings.choices.theme : m_options.theme;
    bench.keepsChoices = true;
    bench.into = m_options.into;
    bench.backend = m_options.backend;
    SceneLook& look = bench.look;
    look.scale = m_window.Scale();
    look.width = std::max(1, int(m_window.Width() / look.scale));
    look.height = std::max(1, int(m_window.Height() / look.scale));
    look.theme = FindTheme(bench.choices.theme).value_or(Theme::Classic());
    look.simulation.seed = m_options.seed;
    look.simulation.stepsPerSecond = m_options.stepsPerSecond;
    ASSIGN_OR_RETURN(Workbench opened, Workbench::Open(std::move(source), bench));
    m_bench.emplace(std::move(opened));
    m_bench->Controls().Controls().SetOpenSections(settings.openSections);
    return Prepare();
}

/// A renderer of the window's size and in the chosen theme.
Result<void> Desk::Prepare()
{
    const int width = m_window.Width();
    const int height = m_window.Height();
    const std::string& theme = m_bench->Choices().theme;
    const bool fits = m_renderer && width == m_width && height == m_height && theme == m_theme;
    if (fits || width < 1 || height < 1) // minimised
    {
        return {};
    }
    if (width != m_width || height != m_height)
    {
        m_bench->Resize(width, height);
    }
    m_renderer.reset();
    ASSIGN_OR_RETURN(
        Renderer renderer,
        Renderer::CreateIn(m_window, {.width = width,
                                      .height = height,
                                      .theme = FindTheme(theme).value_or(Theme::Classic()),
                                      .scale = m_window.Scale()}));
    m_renderer.emplace(std::move(renderer));
    m_width = width;
    m_height = height;
    m_theme = theme;
    m_isLost = true;
    return {};
}

void Desk::HandleEvents()
{
    const std::vector<WindowEvent> events = m_window.Poll(m_bench->IsResting() ? kRest : 0.0);
    for (const WindowEvent& event : events)
    {
        m_isLost = m_isLost || event.kind == WindowEvent::Kind::Exposed;
        m_bench->Handle(event);
    }
}

/// An unchanged picture is not shown again.
Result<void> Desk::Show()
{
    if (m_window.Width() != m_width || m_window.Height() != m_height)
    {
        return {}; // until it fits again
    }
    FrameContent content;
    m_bench->Fill(content);
    content.camera.width = m_width; // a scale may have rounded otherwise
    content.camera.height = m_height;
    RETURN_IF_ERROR(m_renderer->Submit(content.list, content.camera, &content.overlay));
    if (m_renderer->Statistics().unchanged && !m_isLost)
    {
        std::this_thread::sleep_for(kPause); // else the display is waited for
        return {};
    }
    m_isLost = false;
    return m_renderer->Show();
}

Result<void> Desk::Run()
{
    const StopSignals signals;
    Clock::time_point last = Clock::now();
    while (!m_bench->IsDone() && StopSignals::Caught() == 0)
    {
        HandleEvents();
        if (m_title != m_bench->Session().Title())
        {
            m_title = m_bench->Session().Title();
            m_window.SetTitle(m_title + " - boxreel");
        }
        const Clock::time_point now = Clock::now();
        m_bench->Advance(std::chrono::duration<double>(now - last).count());
        last = now;
        RETURN_IF_ERROR(Prepare());
        RETURN_IF_ERROR(Show());
    }
    return m_bench->Finish();
}

UiSettings Desk::Settings() const
{
    UiSettings settings;
    settings.width = std::max(1, int(m_width / m_window.Scale()));
    settings.height = std::max(1, int(m_height / m_window.Scale()));
    settings.scene = m_bench->SceneAsked();
    settings.choices = m_bench->Choices();
    settings.choices.isPaused = false;
    settings.choices.showsPicker = false;
    settings.openSections = m_bench->OpenSections();
    return settings;
}

/// Returns the stored settings. If they cannot be read, prints a message and returns the defaults.
UiSettings Kept(const UiOptions& options, const std::filesystem::path& file)
{
    UiSettings settings;
    if (!options.fresh && !file.empty())
    {
        const Result<UiSettings> kept = ReadUiSettings(file);
        if (kept)
        {
            settings = *kept;
        }
        else
        {
            WriteMessage("boxreel: " + TextInOptions(kept.GetError()));
        }
    }
    if (options.size)
    {
        settings.width = options.size->width;
        settings.height = options.size->height;
    }
    return settings;
}

} // namespace

Result<int> Run(const UiOptions& options)
{
    const std::filesystem::path file = UiSettingsPath();
    const UiSettings settings = Kept(options, file);
    Result<Window> window = Window::Create("boxreel", settings.width, settings.height);
    if (!window)
    {
        return WithoutWindow(window.GetError());
    }
    Desk desk(std::move(*window), options);
    RETURN_IF_ERROR(desk.Open(settings));
    RETURN_IF_ERROR(desk.Run());
    if (!options.fresh && !file.empty())
    {
        if (const Result<void> kept = WriteUiSettings(file, desk.Settings()); !kept)
        {
            WriteMessage("boxreel: The settings were not saved: " + TextInOptions(kept.GetError()));
        }
    }
    const Result<void> said = WriteOutput(desk.Bench().Summary() + "\n");
    return said ? Result<int>(0) : said.GetError();
}

Command& Declare(Command& program, UiOptions& ui)
{
    Command& command = AddCommand(program, "ui", "Open a scene in a window");
    AddScene(command, ui.scene).isOptional = true;
    AddValue(command, "--size", "WxH", ui.size, ParseSize,
             "Set the size of the window in pixels, up to that of the display\n(last size, or "
             "1280x720)");
    const std::vector<std::string> themes(ThemeNames().begin(), ThemeNames().end());
    AddValue(command, "--theme", "NAME", ui.theme, OneWordOf(themes),
             "Set the colours: " + JoinedBy(", ", themes) + "\n(last theme, or classic)");
    AddValue(command, "--seed", "N", ui.seed, WholeBetween(0, 0xffffffffll),
             "Seed the scene's random numbers (1)");
    AddValue(command, "--hz", "RATE", ui.stepsPerSecond, RatioBetween(5.0, 480.0),
             "Set simulation steps per second (the scene's own, or 60)");
    AddPath(command, "--into", "DIR", ui.into,
            "Write films, figures and scripts to this folder (the current one)");
    AddFlag(command, "--paused", ui.isPaused, "Start paused; O makes one step, P continues");
    AddFlag(command, "--fresh", ui.fresh, "Ignore saved settings and save none");
    AddBackend(command, ui.backend);
    command.notes = {
        {"Keys:"},
        {"P pause, continue    O single step        R restart           [ ] other scenes\n"
         "Ctrl+O find a scene  Tab hide panels      Home reset view     Esc quit\n"
         "Z X, wheel zoom      arrows, right drag pan                   Ctrl+arrows shift origin\n"
         "left drag pull a body                     Space, Shift+drag bombs",
         NoteKind::Table},
        {"Size, scene, theme and layers are saved for the next start, in\n"
         "$XDG_CONFIG_HOME/boxreel/ui.json (~/.config). Closing the window prints the step and "
         "the\n"
         "state hash. The button Record writes a film from now on, SVG and PNG write a figure, "
         "and\n"
         "Script writes the actions since the scene's start for `boxreel play`."}};
    command.examples = {"boxreel ui", "boxreel ui car --paused",
                        "boxreel ui scene.json --size 1600x900 --into films"};
    return command;
}

} // namespace boxreel
