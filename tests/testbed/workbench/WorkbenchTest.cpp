// SPDX-License-Identifier: MIT
// User actions on a workbench as events, without a window.
#include "../cli/Subprocess.h"

#include <golden/StateHash.h>
#include <recorder/VideoReader.h>
#include <script/Script.h>
#include <workbench/Workbench.h>

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <random>

namespace boxreel
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Kind = WindowEvent::Kind;

constexpr int kWidth = 1000;
constexpr int kHeight = 700;

class WorkbenchTest : public testing::Test
{
protected:
    void Open(const std::string& scene, bool isPaused = true)
    {
        WorkbenchSettings settings;
        settings.look.width = kWidth;
        settings.look.height = kHeight;
        settings.choices.isPaused = isPaused;
        settings.into = folder.Path();
        Result<Workbench> opened = Workbench::Open(*OpenScene(scene), settings);
        ASSERT_TRUE(opened) << opened.GetError().Text();
        bench.emplace(std::move(*opened));
        Look();
    }

    /// The panels are laid out after two frames.
    Overlay Look()
    {
        FrameContent content;
        bench->Fill(content);
        bench->Fill(content = {});
        return content.overlay;
    }

    static WindowEvent At(Kind kind, Vec2 point, int button = 0, bool shift = false)
    {
        WindowEvent event;
        event.kind = kind;
        event.point = point;
        event.button = button;
        event.shift = shift;
        return event;
    }
    void Press(Key key, bool control = false, Kind kind = Kind::KeyDown)
    {
        WindowEvent event = At(kind, pointer);
        event.key = key;
        event.control = control;
        bench->Handle(event);
    }
    void Hit(Key key, bool control = false)
    {
        Press(key, control);
        Press(key, control, Kind::KeyUp);
    }
    void Drag(Vec2 from, Vec2 to, int button = 0, bool shift = false)
    {
        bench->Handle(At(Kind::Pointer, from));
        bench->Handle(At(Kind::ButtonDown, from, button, shift));
        bench->Handle(At(Kind::Pointer, to));
        bench->Handle(At(Kind::ButtonUp, to, button, shift));
        pointer = to;
    }
    void Click(const std::string& control)
    {
        bench->Controls().Controls().Reveal(control);
        Look();
        Look();
        const std::optional<Vec2> place = bench->Controls().Controls().Find(control);
        ASSERT_TRUE(place) << control;
        Drag(*place, *place);
    }
    void Steps(int count)
    {
        for (int i = 0; i < count; ++i)
        {
            Hit(Key::O);
        }
    }
    Vec2 PixelOf(const b2Vec2& point) const
    {
        return bench->Session().CurrentCamera().ToPixel({point.x, point.y});
    }
    std::string State() const { return StateHashText(bench->Session().World()); }
    double Height() const
    {
        const Camera view = bench->Session().CurrentCamera();
        return view.height / view.pixelsPerMeter;
    }
    /// Returns the final state of the world when the script is played from its beginning.
    static std::string StateAfter(const std::filesystem::path& file, std::int64_t step)
    {
        const Result<Script> script = ReadScript(file);
        EXPECT_TRUE(script) << script.GetError().Text();
        SceneLook look;
        for (std::size_t i = 0; i + 1 < script->options.size(); ++i)
        {
            if (script->options[i] == "--hz")
            {
                look.simulation.stepsPerSecond =
                    *ParseRatio("--hz", script->options[i + 1], 1.0, 1000.0);
            }
        }
        look.simulation.script = std::make_shared<const Script>(*script);
        Result<SceneSession> session = SceneSession::Open(*OpenScene(script->scene), look);
        EXPECT_TRUE(session) << session.GetError().Text();
        session->AdvanceTo(step);
        return StateHashText(session->World());
    }

    TemporaryFolder folder;
    mutable std::optional<Workbench> bench;
    Vec2 pointer{300.0f, 300.0f};
};

TEST_F(WorkbenchTest, GoesOnInRealTimeUnlessItIsPaused)
{
    Open("pyramid", false);
    bench->Advance(0.05);
    EXPECT_EQ(bench->Session().SceneStep(), 3);
    Hit(Key::P);
    bench->Advance(0.05);
    EXPECT_EQ(bench->Session().SceneStep(), 3);
    Hit(Key::P);
    bench->Advance(1000.0); // a machine that was asleep: what is owed is let go
    EXPECT_EQ(bench->Session().SceneStep(), 9);
}

TEST_F(WorkbenchTest, MakesSingleStepsWhichPauseIt)
{
    Open("pyramid", false);
    Steps(2);
    EXPECT_TRUE(bench->Choices().isPaused);
    EXPECT_EQ(bench->Session().SceneStep(), 2);
}

TEST_F(WorkbenchTest, PullsTheBodyThatLiesUnderTheMouse)
{
    Open("newtons-cradle");
    const b2Body* const ball = bench->Session().World().GetBodyList();
    ASSERT_EQ(ball->GetType(), b2_dynamicBody);
    const Vec2 place = PixelOf(ball->GetWorldCenter());
    bench->Handle(At(Kind::Pointer, place));
    bench->Handle(At(Kind::ButtonDown, place));
    const Vec2 goal{place.x + 60.0f, place.y - 60.0f};
    bench->Handle(At(Kind::Pointer, goal));
    Steps(40);
    const Vec2 pulled = PixelOf(ball->GetWorldCenter());
    EXPECT_GT(pulled.x, place.x + 20.0f);
    bench->Handle(At(Kind::ButtonUp, goal));
    EXPECT_NE(bench->Session().World().GetJointList()->GetType(), e_mouseJoint)
        << "it has not let go";
}

TEST_F(WorkbenchTest, SendsKeysToSceneAndReleasesThemWithFocus)
{
    Open("car");
    Press(KeyOf('d'));
    Press(KeyOf('d'), false, Kind::KeyRepeat);
    Steps(60);
    const std::string driven = State();
    Open("car");
    Steps(60);
    EXPECT_NE(State(), driven);
    Open("car");
    Press(KeyOf('d'));
    WindowEvent lost;
    lost.kind = Kind::LostFocus;
    bench->Handle(lost);
    Steps(60);
    const std::string let = State();
    Open("car");
    Hit(KeyOf('d'));
    Steps(60);
    EXPECT_EQ(State(), let);
}

TEST_F(WorkbenchTest, ZoomsAboutTheMouse)
{
    Open("bridge");
    const Vec2 mouse{200.0f, 150.0f};
    const Vec2 before = bench->Session().CurrentCamera().ToWorld(mouse);
    const double height = Height();
    WindowEvent wheel = At(Kind::Wheel, mouse);
    wheel.wheel = 2.0f;
    bench->Handle(wheel);
    const Vec2 after = bench->Session().CurrentCamera().ToWorld(mouse);
    EXPECT_LT(Height(), 0.8 * height);
    EXPECT_NEAR(after.x, before.x, 1e-3);
    EXPECT_NEAR(after.y, before.y, 1e-3);
    Hit(Key::Home);
    EXPECT_EQ(Height(), height);
    Hit(Key::Z);
    EXPECT_GT(Height(), height);
    Hit(Key::X);
    EXPECT_NEAR(Height(), height, 1e-6 * height);
}

TEST_F(WorkbenchTest, PansByDisplacementOfMouse)
{
    Open("bridge");
    const Vec2 before = PixelOf(b2Vec2(1.0f, 2.0f));
    Drag({300.0f, 300.0f}, {340.0f, 275.0f}, 1);
    const Vec2 after = PixelOf(b2Vec2(1.0f, 2.0f));
    EXPECT_NEAR(after.x - before.x, 40.0f, 0.01f);
    EXPECT_NEAR(after.y - before.y, -25.0f, 0.01f);
    Hit(Key::Left);
    EXPECT_GT(PixelOf(b2Vec2(1.0f, 2.0f)).x, after.x);
}

TEST_F(WorkbenchTest, ShiftsOriginWithoutMovingThePicture)
{
    Open("bridge");
    const b2Body* const body = bench->Session().World().GetBodyList();
    const b2Vec2 place = body->GetPosition();
    const Vec2 before = PixelOf(place);
    Hit(Key::Right, true);
    EXPECT_NEAR(body->GetPosition().x, place.x - 2.0f, 1e-5f);
    const Vec2 after = PixelOf(body->GetPosition());
    EXPECT_NEAR(after.x, before.x, 0.01f);
    EXPECT_NEAR(after.y, before.y, 0.01f);
}

TEST_F(WorkbenchTest, KeepsFollowTargetAfterOriginShift)
{
    Open("car");
    Hit(Key::Right, true);
    EXPECT_FALSE(bench->Session().HasOwnView());
    Steps(60); // until the camera is where the car is
    const double before = bench->Session().CurrentCamera().centerX;
    bench->Session().World().ShiftOrigin(b2Vec2(30.0f, 0.0f)); // as if it had driven so far
    Steps(120);
    EXPECT_NEAR(bench->Session().CurrentCamera().centerX, before - 30.0, 5.0);
}

TEST_F(WorkbenchTest, ThrowsAndSlingsBombs)
{
    Open("bridge");
    const int bodies = bench->Session().World().GetBodyCount();
    Hit(Key::Space);
    EXPECT_EQ(bench->Session().World().GetBodyCount(), bodies + 1);
    Open("bridge");
    const Camera view = bench->Session().CurrentCamera();
    Drag({200.0f, 100.0f}, {150.0f, 120.0f}, 0, true);
    const b2Body* const bomb = bench->Session().World().GetBodyList();
    EXPECT_EQ(bench->Session().World().GetBodyCount(), bodies + 1);
    const Vec2 from = view.ToWorld({200.0f, 100.0f});
    EXPECT_NEAR(bomb->GetPosition().x, from.x, 1e-3f);
    EXPECT_NEAR(bomb->GetPosition().y, from.y, 1e-3f);
    // Opposite to the direction it was pulled, and faster with the distance.
    const b2Vec2 velocity = bomb->GetLinearVelocity();
    EXPECT_NEAR(velocity.y / velocity.x, 20.0f / 50.0f, 1e-3f);
    EXPECT_NEAR(velocity.x, 6.0 * 50.0 / view.pixelsPerMeter, 1e-2);
}

TEST_F(WorkbenchTest, GoesFromSceneToSceneAndAroundTheEnd)
{
    Open("pyramid");
    const auto scenes = AllScenes();
    for (std::size_t i = 0; i < scenes.size(); ++i)
    {
        Hit(Key::RightBracket);
    }
    EXPECT_EQ(bench->Session().Title(), "Pyramid");
    Hit(Key::LeftBracket);
    EXPECT_NE(bench->Session().Title(), "Pyramid");
    Hit(Key::RightBracket);
    EXPECT_EQ(bench->Session().Title(), "Pyramid");
}

TEST_F(WorkbenchTest, OpensTheSceneThatThePickerFinds)
{
    Open("pyramid");
    Hit(Key::O, true);
    for (const char* letter : {"n", "e", "w"})
    {
        WindowEvent text = At(Kind::Text, pointer);
        text.text = letter;
        bench->Handle(text);
    }
    Hit(Key::Enter);
    EXPECT_EQ(bench->Session().Title(), "Newton's Cradle");
    EXPECT_FALSE(bench->Choices().showsPicker);
    Hit(Key::O, true);
    EXPECT_TRUE(bench->Choices().showsPicker);
    Hit(Key::Escape);
    EXPECT_FALSE(bench->Choices().showsPicker);
    EXPECT_FALSE(bench->IsDone());
    Hit(Key::Escape);
    EXPECT_TRUE(bench->IsDone());
}

TEST_F(WorkbenchTest, HidesThePanelsAndCentresTheSceneWithoutThem)
{
    Open("pyramid");
    EXPECT_FALSE(Look().IsEmpty());
    const float middle = PixelOf(b2Vec2(0.0f, 0.0f)).x;
    Hit(Key::Tab);
    EXPECT_TRUE(Look().IsEmpty());
    EXPECT_GT(PixelOf(b2Vec2(0.0f, 0.0f)).x, middle);
}

TEST_F(WorkbenchTest, KeepsTheSolverForASceneAndForAllOnRequest)
{
    Open("pyramid");
    Click("Solver/Velocity iterations/more");
    Click("Solver/Sleep");
    EXPECT_EQ(bench->Session().Steps().velocityIterations, 9);
    EXPECT_FALSE(bench->Session().World().GetAllowSleeping());
    Hit(Key::R);
    EXPECT_EQ(bench->Session().Steps().velocityIterations, 9);
    EXPECT_FALSE(bench->Session().World().GetAllowSleeping());
    Hit(Key::RightBracket);
    EXPECT_EQ(bench->Session().Steps().velocityIterations, 8);
    EXPECT_TRUE(bench->Session().World().GetAllowSleeping());
    Click("Solver/Sleep");
    Click("Solver/Keep for every scene");
    Hit(Key::RightBracket);
    EXPECT_FALSE(bench->Session().World().GetAllowSleeping());
}

TEST_F(WorkbenchTest, RestartsTheSceneAtAnotherRate)
{
    Open("pyramid");
    Steps(5);
    Click("Solver/Hertz/more");
    EXPECT_EQ(bench->Session().SceneStep(), 0);
    EXPECT_EQ(bench->Session().StepsPerSecond().ToDouble(), 61.0);
}

TEST_F(WorkbenchTest, RecordsOneFrameForEachStep)
{
    Open("bridge");
    Steps(2);
    Click("Run/Record");
    Steps(5);
    Click("Run/Record");
    Steps(2);
    Result<VideoReader> film = VideoReader::Open(folder / "bridge-1.mp4");
    ASSERT_TRUE(film) << film.GetError().Text();
    EXPECT_EQ(film->Info().width, kWidth - Panels::kColumnWidth);
    EXPECT_EQ(film->Info().height, kHeight);
    int frames = 0;
    for (Frame frame; *film->Next(frame);)
    {
        ++frames;
    }
    EXPECT_EQ(frames, 6);
}

TEST_F(WorkbenchTest, WritesFiguresUnderNamesThatAreFree)
{
    Open("bridge");
    Click("Run/SVG");
    Click("Run/PNG");
    Click("Run/SVG");
    EXPECT_THAT(folder.Names(), ElementsAre("bridge-1.png", "bridge-1.svg", "bridge-2.svg"));
    EXPECT_THAT(ReadBytes(folder / "bridge-1.svg"), HasSubstr("<title"));
    EXPECT_THAT(bench->Message(), HasSubstr("bridge-2.svg"));
}

TEST_F(WorkbenchTest, ReportsFolderThatCannotBeWritten)
{
    WorkbenchSettings settings;
    settings.look.width = kWidth;
    settings.look.height = kHeight;
    settings.choices.isPaused = true;
    settings.into = folder / "nowhere";
    bench.emplace(std::move(*Workbench::Open(*OpenScene("bridge"), settings)));
    for (const char* button : {"Run/SVG", "Run/PNG", "Run/Script", "Run/Record"})
    {
        Click(button);
        EXPECT_THAT(bench->Message(), HasSubstr("nowhere")) << button;
        EXPECT_THAT(bench->Message(), Not(HasSubstr("Wrote"))) << button;
    }
    EXPECT_TRUE(folder.Names().empty());
}

/// Anything at all, in any order.
class RandomSession : public WorkbenchTest, public testing::WithParamInterface<unsigned>
{
protected:
    void DoSomething(std::mt19937& random)
    {
        const auto below = [&](unsigned count) { return unsigned(random() % count); };
        const Vec2 place{float(below(kWidth)), float(below(kHeight))};
        const std::string keys = "dasweqcjklmbft12345,";
        switch (below(24))
        {
        case 0:
            Press(KeyOf(keys[below(unsigned(keys.size()))]));
            break;
        case 1:
            Press(KeyOf(keys[below(unsigned(keys.size()))]), false, Kind::KeyUp);
            break;
        case 2:
        case 3:
            pointer = place;
            bench->Handle(At(Kind::ButtonDown, place, 0, below(4) == 0));
            break;
        case 4:
        case 5:
        case 6:
            pointer = place;
            bench->Handle(At(Kind::Pointer, place));
            break;
        case 7:
        case 8:
            bench->Handle(At(Kind::ButtonUp, pointer));
            break;
        case 9:
            Hit(Key::Space);
            break;
        case 10:
            Hit(Key::Right, true);
            break;
        case 11:
            Drag({300.0f, 300.0f}, place, 1);
            break;
        case 12:
            Click("Solver/Position iterations/more");
            break;
        case 13:
            Click("Solver/Sub-steps/more");
            break;
        case 14:
            Click(below(2) == 0 ? "Solver/Warm starting" : "Solver/Continuous");
            break;
        case 15:
            below(6) == 0 ? Hit(Key::R) : Hit(Key::P);
            break;
        case 16:
            bench->Handle(At(Kind::LostFocus, pointer));
            break;
        case 17:
            below(12) == 0 ? Hit(Key::RightBracket) : Hit(Key::Z);
            break;
        case 18:
            below(12) == 0 ? Click("Solver/Hertz/less") : Hit(Key::X);
            break;
        default:
            below(2) == 0 ? Steps(int(below(10))) : bench->Advance(0.05);
            break;
        }
    }
};

TEST_P(RandomSession, IsRepeatedBitForBitByItsScript)
{
    std::mt19937 random(GetParam());
    Open(GetParam() % 3 == 0 ? "car" : GetParam() % 3 == 1 ? "newtons-cradle" : "bridge");
    for (int i = 0; i < 250; ++i)
    {
        DoSomething(random);
        ASSERT_FALSE(HasFailure());
    }
    bench->Handle(At(Kind::ButtonUp, pointer)); // or nothing could be clicked
    Steps(2);                                   // what was done shows in them
    Click("Run/Script");
    const std::vector<std::string> files = folder.Names();
    ASSERT_THAT(files, Contains(HasSubstr(".play")));
    const auto script = std::find_if(files.begin(), files.end(), [](const std::string& name) {
        return name.ends_with(".play");
    });
    EXPECT_EQ(StateAfter(folder / *script, bench->Session().SceneStep()), State());
    EXPECT_THAT(ReadBytes(folder / *script), HasSubstr("expect state " + State()));
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomSession, testing::Range(1u, 7u));

TEST(SceneKeys, DoNotUseKeysOfTheWindow)
{
    for (const SceneEntry& entry : AllScenes())
    {
        for (const KeyBinding& binding : entry.create({})->Keys())
        {
            EXPECT_EQ(std::string("oprxz[]").find(binding.key), std::string::npos)
                << entry.name << " answers to " << binding.key;
        }
    }
}

} // namespace
} // namespace boxreel
