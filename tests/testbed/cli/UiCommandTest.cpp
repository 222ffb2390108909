// SPDX-License-Identifier: MIT
// The real window on a display without a screen (Xvfb), with real events of mouse and keyboard
// (xdotool).
#include "Subprocess.h"

#include <golden/Compare.h>
#include <golden/StateHash.h>
#include <recorder/VideoReader.h>
#include <render/Png.h>
#include <render/Renderer.h>
#include <script/Script.h>
#include <workbench/Workbench.h>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

constexpr int kWidth = 1000;
constexpr int kHeight = 640;

/// A display of its own; the variable DISPLAY names it while it is there.
class Display
{
public:
    Display()
    {
        int numbers[2] = {-1, -1};
        EXPECT_EQ(pipe2(numbers, 0), 0);
        m_server = fork();
        if (m_server == 0)
        {
            const int nothing = open("/dev/null", O_RDWR);
            dup2(nothing, STDOUT_FILENO);
            dup2(nothing, STDERR_FILENO);
            const std::string number = std::to_string(numbers[1]);
            close(numbers[0]);
            execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1000x640x24",
                   "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
            _exit(127);
        }
        close(numbers[1]);
        m_name = ":";
        char digit = 0; // up to the end of the line, for which it wants to be heard, too
        while (read(numbers[0], &digit, 1) == 1 && digit != '\n')
        {
            m_name += digit;
        }
        close(numbers[0]);
        EXPECT_GT(m_name.size(), 1u) << "Xvfb does not start";
        setenv("DISPLAY", m_name.c_str(), 1);
    }
    ~Display()
    {
        unsetenv("DISPLAY");
        kill(m_server, SIGTERM);
        waitpid(m_server, nullptr, 0);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// The whole screen.
    void Photograph(const std::filesystem::path& file) const
    {
        const std::string command = "ffmpeg -y -loglevel error -f x11grab -draw_mouse 0 "
                                    "-video_size 1000x640 -i " +
                                    m_name + " -frames:v 1 '" + file.string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0);
    }

private:
    pid_t m_server = -1;
    std::string m_name;
};

/// Runs commands of xdotool; the events come one after the other.
void Act(const std::string& what)
{
    EXPECT_EQ(std::system(("timeout 60 xdotool " + what + " >/dev/null").c_str()), 0) << what;
}

/// At a place of the picture, which begins at the corner of the screen.
std::string At(Vec2 place)
{
    return "mousemove " + std::to_string(int(place.x)) + " " + std::to_string(int(place.y));
}

class UiCommand : public testing::Test
{
protected:
    /// Returns the content of the window without a window, to find the positions of controls.
    Workbench Twin(const std::string& scene) const
    {
        WorkbenchSettings settings;
        settings.look.width = kWidth;
        settings.look.height = kHeight;
        settings.choices.isPaused = true;
        Result<Workbench> bench = Workbench::Open(*OpenScene(scene), settings);
        EXPECT_TRUE(bench);
        FrameContent content;
        bench->Fill(content); // lays the panels out
        bench->Fill(content = {});
        return std::move(*bench);
    }

    /// The window with this scene, until Escape is pressed or `act` has done so.
    Outcome RunUi(std::vector<std::string> arguments, const std::function<void()>& act) const
    {
        arguments.insert(arguments.begin(), "ui");
        arguments.insert(arguments.end(), {"--fresh", "--size", "1000x640"});
        return RunBoxreel(arguments, folder.Path(), [&](int) {
            Act("search --sync --onlyvisible --name boxreel");
            act();
            Act("key Escape");
        });
    }

    /// "Dominos: step 30, state …\n", as the program says it at the end.
    static std::string Summary(SceneSession& session)
    {
        return session.Title() + ": step " + std::to_string(session.SceneStep()) + ", state " +
               StateHashText(session.World()) + "\n";
    }

    TemporaryFolder folder;
    Display display;
#if BOXREEL_IS_SANITIZED
    /// The display's driver is unloaded before LeakSanitizer looks for what was never freed, so
    /// that its allocations cannot be suppressed by the name of its library (tests/lsan.supp). The
    /// tests of Workbench look for leaks without it.
    Variable leaks{"ASAN_OPTIONS", "detect_leaks=0"};
#endif
};

TEST_F(UiCommand, OpensPickedSceneAndStepsOnce)
{
    const Outcome outcome = RunUi({"pyramid", "--paused"}, [] {
        Act("key ctrl+o type domin");
        Act("key Return");
        Act("key --delay 5 --repeat 20 o");
    });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    Result<SceneSession> expected = SceneSession::Open(*OpenScene("dominos"), SceneLook());
    expected->AdvanceTo(20);
    EXPECT_EQ(outcome.output, Summary(*expected));
    EXPECT_TRUE(folder.Names().empty());
}

TEST_F(UiCommand, DrawsEqualPictureWithoutWindow)
{
    Workbench twin = Twin("bridge");
    WindowEvent mouse;
    mouse.point = {300.0f, 300.0f};
    twin.Handle(mouse);
    FrameContent content;
    twin.Fill(content);
    Result<Renderer> renderer = Renderer::Create({.width = kWidth, .height = kHeight});
    ASSERT_TRUE(renderer);
    Frame expected;
    ASSERT_TRUE(renderer->Draw(content.list, content.camera, expected, &content.overlay));
    Comparison comparison;
    const Outcome outcome = RunUi({"bridge", "--paused"}, [&] {
        Act(At({300.0f, 300.0f}));
        for (int i = 0; i < 40 && !comparison.equal; ++i) // until it is shown
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            display.Photograph(folder / "window.png");
            comparison =
                Compare(expected, *ReadPng(folder / "window.png"), CompareSettings::Exact());
        }
    });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_TRUE(comparison.equal) << comparison.Text();
}

TEST_F(UiCommand, RecordsFilmAndScriptOfPulledBody)
{
    Workbench twin = Twin("newtons-cradle");
    SceneSession& session = twin.Session();
    const b2Body* ball = session.World().GetBodyList(); // the newest
    while (ball->GetType() != b2_dynamicBody)
    {
        ball = ball->GetNext();
    }
    const b2Vec2 place = ball->GetWorldCenter();
    const Vec2 pixel = session.CurrentCamera().ToPixel({place.x, place.y});
    const Vec2 record = twin.Controls().Controls().Find("Run/Record").value();
    const Vec2 script = twin.Controls().Controls().Find("Run/Script").value();
    const Outcome outcome = RunUi({"newtons-cradle", "--paused"}, [&] {
        Act(At(record) + " click 1");
        Act(At(pixel) + " mousedown 1");
        Act(At({pixel.x + 40.0f, pixel.y - 20.0f}) + " key --delay 5 --repeat 10 o");
        Act(At({pixel.x + 80.0f, pixel.y - 60.0f}) + " key --delay 5 --repeat 10 o mouseup 1");
        Act("key --delay 5 --repeat 10 o");
        Act(At(record) + " click 1");
        Act(At(script) + " click 1");
    });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr(": step 30, state "));
    Result<SceneSession> alone = SceneSession::Open(*OpenScene("newtons-cradle"), SceneLook());
    alone->AdvanceTo(30);
    EXPECT_NE(outcome.output, Summary(*alone)) << "nothing was pulled";

    Result<VideoReader> film = VideoReader::Open(folder / "newtons-cradle-1.mp4");
    ASSERT_TRUE(film) << film.GetError().Text();
    EXPECT_EQ(film->Info().width, kWidth - Panels::kColumnWidth);
    EXPECT_EQ(film->Info().height, kHeight);
    int frames = 0;
    for (Frame frame; *film->Next(frame);)
    {
        ++frames;
    }
    EXPECT_EQ(frames, 31); // the first before any step

    const Outcome played = RunBoxreel({"play", "newtons-cradle-1.play", "--test"}, folder.Path());
    EXPECT_EQ(played.code, 0) << played.errors << played.output;
    const std::string state = outcome.output.substr(outcome.output.find("state "), 22);
    EXPECT_THAT(played.output, HasSubstr(state));
}

TEST_F(UiCommand, RunsInRealTimeUntilPaused)
{
    Workbench twin = Twin("pyramid");
    const Vec2 pause = twin.Controls().Controls().Find("Run/Pause").value();
    const Vec2 script = twin.Controls().Controls().Find("Run/Script").value();
    const Outcome outcome = RunUi({"pyramid"}, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        Act(At(pause) + " click 1");
        Act(At(script) + " click 1");
        std::this_thread::sleep_for(std::chrono::milliseconds(200)); // in which nothing moves
    });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    const std::string written = ReadBytes(folder / "pyramid-1.play");
    ASSERT_THAT(outcome.output, HasSubstr("Pyramid: step "));
    const std::string step = outcome.output.substr(14, outcome.output.find(',') - 14);
    EXPECT_GE(std::stoi(step), 2);
    const std::string state = outcome.output.substr(outcome.output.find("state "), 22);
    EXPECT_THAT(written, HasSubstr("at step " + step + " expect " + state));
}

TEST_F(UiCommand, IsLimitedToDisplaySize)
{
    RunBoxreel({"ui", "--paused", "--fresh", "--size", "8000x8000"}, folder.Path(), [&](int) {
        Act("search --sync --onlyvisible --name boxreel");
        const std::string file = (folder / "size").string();
        EXPECT_EQ(std::system(("xdotool search --onlyvisible --name boxreel getwindowgeometry "
                               "--shell > '" +
                               file + "'")
                                  .c_str()),
                  0);
        Act("key Escape");
    });
    EXPECT_THAT(ReadBytes(folder / "size"),
                testing::AllOf(HasSubstr("WIDTH=1000\n"), HasSubstr("HEIGHT=640\n")));
}

TEST_F(UiCommand, SavesSettingsForNextStart)
{
    setenv("XDG_CONFIG_HOME", folder.Path().c_str(), 1);
    const auto run = [&](const std::function<void()>& act) {
        return RunBoxreel({"ui", "--paused", "--size", "1000x640"}, folder.Path(), [&](int) {
            Act("search --sync --onlyvisible --name boxreel");
            act();
            Act("key Escape");
        });
    };
    const Outcome first = run([] { Act("key bracketright bracketright"); });
    const Outcome second = run([] {});
    unsetenv("XDG_CONFIG_HOME");
    EXPECT_EQ(first.code, 0) << first.errors;
    EXPECT_THAT(first.output, testing::Not(HasSubstr("Pyramid:")));
    EXPECT_EQ(second.output, first.output);
}

} // namespace
} // namespace boxreel
