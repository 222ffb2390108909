// SPDX-License-Identifier: MIT
// Panels without a window, clicked by scripts.
#include "../../base/Errors.h"

#include <golden/StateHash.h>
#include <script/ScriptWriter.h>
#include <session/SessionPanels.h>

#include <gmock/gmock.h>

#include <set>

namespace boxreel
{
namespace
{

using testing::Contains;

SceneSession Played(const std::string& lines, std::int64_t steps, bool isDrawn = true,
                    const std::string& scene = "pyramid")
{
    const Result<Script> script = ParseScript("scene " + scene + "\n" + lines, "a.play");
    EXPECT_TRUE(script) << script.GetError().Text();
    SceneLook look;
    look.panels.testbed = isDrawn;
    look.simulation.script = std::make_shared<const Script>(*script);
    Result<SceneSession> session = OpenSession(*OpenScene(scene), look);
    EXPECT_TRUE(session) << session.GetError().Text();
    session->AdvanceTo(steps);
    return std::move(*session);
}

TEST(ScriptedPanels, ChangeTheSolver)
{
    SceneSession session = Played("at step 1 click Solver/Sleep\n"
                                  "at step 1 click \"Solver/Warm starting\"\n"
                                  "at step 1 click Solver/Continuous\n"
                                  "at step 1 click Solver/Sub-stepping\n"
                                  "at step 2 click \"Solver/Velocity iterations/more\"\n"
                                  "at step 2 click \"Solver/Position iterations/less\"\n"
                                  "at step 2 click Solver/Sub-steps/more\n",
                                  3);
    ASSERT_TRUE(session.CheckCompanion());
    const b2World& world = session.World();
    EXPECT_FALSE(world.GetAllowSleeping());
    EXPECT_FALSE(world.GetWarmStarting());
    EXPECT_FALSE(world.GetContinuousPhysics());
    EXPECT_TRUE(world.GetSubStepping());
    EXPECT_EQ(world.GetSubStepCount(), 2);
    EXPECT_EQ(session.Steps().velocityIterations, 9);
    EXPECT_EQ(session.Steps().positionIterations, 2);
}

TEST(ScriptedPanels, ChooseTheLayersOneByOne)
{
    std::string lines;
    for (const LayerInfo& layer : kOptionalLayers)
    {
        lines += "at step 0 click \"Draw/" + std::string(layer.label) + "\"\n";
    }
    const SceneSession session = Played(lines + "at step 0 click Draw/Numbers\n", 1);
    ASSERT_TRUE(session.CheckCompanion()) << session.CheckCompanion().GetError().Text();
    const LayerSet before;
    for (const LayerInfo& layer : kOptionalLayers)
    {
        EXPECT_NE(session.Look().layers[layer.layer], before[layer.layer]) << layer.label;
    }
    EXPECT_TRUE(session.Look().labels);
}

TEST(ScriptedPanels, PauseAndStepWhileTheScriptGoesOn)
{
    SceneSession session = Played("at step 5 click Run/Pause\n"
                                  "at step 8 click Run/Step\n"
                                  "at step 12 hit p\n",
                                  10);
    EXPECT_EQ(session.Step(), 10);
    EXPECT_EQ(session.SceneStep(), 6);
    EXPECT_NEAR(session.Time(), 0.1, 1e-6);
    session.AdvanceTo(20);
    EXPECT_EQ(session.SceneStep(), 6 + 8);
    const SceneSession alone = Played("", 14, false);
    EXPECT_EQ(StateHashText(session.World()), StateHashText(alone.World()));
}

TEST(ScriptedPanels, RestartTheScene)
{
    const SceneSession session = Played("at step 5 click Run/Restart\n", 8);
    EXPECT_EQ(session.SceneStep(), 3);
    const SceneSession alone = Played("", 3, false);
    EXPECT_EQ(StateHashText(session.World()), StateHashText(alone.World()));
}

TEST(ScriptedPanels, OpenAnotherSceneByThePickerAndByTheTree)
{
    const SceneSession picked = Played("at step 5 hit ctrl+o\nat step 5 type bridg\n"
                                       "at step 6 hit enter\n",
                                       8);
    EXPECT_EQ(picked.Title(), "Bridge");
    EXPECT_EQ(picked.SceneStep(), 2);
    const SceneSession clicked = Played("at step 2 hit ctrl+o\nat step 3 type domi\n"
                                        "at step 4 click Picker/Dominos\n",
                                        6);
    EXPECT_EQ(clicked.Title(), "Dominos");
    const SceneSession chosen = Played("at step 2 click Panels/Scenes\n"
                                       "at step 3 click Scenes/Joints\n"
                                       "at step 4 click Scenes/Bridge\n",
                                       6);
    EXPECT_TRUE(chosen.CheckCompanion());
    EXPECT_EQ(chosen.Title(), "Bridge");
    const SceneSession left = Played("at step 5 hit ctrl+o\nat step 5 type bridg\n"
                                     "at step 6 hit escape\nat step 7 click Run/Pause\n",
                                     9);
    EXPECT_EQ(left.Title(), "Pyramid");
    EXPECT_EQ(left.SceneStep(), 7);
}

TEST(ScriptedPanels, NameMissingControl)
{
    const SceneSession session = Played("at step 1 click Solver/Slep\n", 3);
    EXPECT_THAT(session.CheckCompanion(), RefusesWith("a.play:2: 'Solver/Slep'", "'Solver/Sleep'"));
    const SceneSession key = Played("at step 1 hit f13\n", 3);
    EXPECT_THAT(key.CheckCompanion(), Refuses("a.play:2: 'f13'"));
}

TEST(ScriptedPanels, OpenSectionsAndScrollToWhatIsOutOfSight)
{
    SceneLook look;
    look.height = 300;
    look.panels.testbed = true;
    look.simulation.script = std::make_shared<const Script>(
        *ParseScript("scene pyramid\nat step 0 click Panels/Solver\n"
                     "at step 0 click Draw/Profile\nat step 1 click Solver/Sleep\n",
                     "a.play"));
    Result<SceneSession> session = OpenSession(*OpenScene("pyramid"), look);
    session->AdvanceTo(2);
    ASSERT_TRUE(session->CheckCompanion()) << session->CheckCompanion().GetError().Text();
    EXPECT_FALSE(session->World().GetAllowSleeping());
}

TEST(ScriptedPanels, AreHiddenWhenOpenedOnlyForScript)
{
    SceneSession clicked = Played("at step 3 click Run/Bomb\n", 5, false);
    FrameContent content;
    clicked.Fill(content);
    EXPECT_TRUE(content.overlay.IsEmpty());
    const SceneSession bombed = Played("at step 3 bomb\n", 5, false);
    EXPECT_EQ(content.camera, bombed.CurrentCamera());
    EXPECT_EQ(StateHashText(clicked.World()), StateHashText(bombed.World()));
}

TEST(ScriptedPanels, LookTheSameForAnyNumberOfPictures)
{
    const std::string lines = "at step 1 click \"Draw/Contact points\"\nat step 2 hit ctrl+o\n"
                              "at step 3 type arc\n";
    const auto last = [&](bool looksOften) {
        SceneSession session = Played(lines, 0);
        FrameContent content;
        for (int step = 1; step <= 6; ++step)
        {
            session.AdvanceTo(step);
            if (looksOften || step == 6)
            {
                session.Fill(content = {});
            }
        }
        return content.overlay;
    };
    EXPECT_EQ(last(true), last(false));
}

TEST(Panels, KeepLayersApartAndInTheColumnAtEachScale)
{
    for (const double scale : {0.75, 1.0, 1.5, 2.0})
    {
        const auto width = int(1280.0 * scale);
        Result<Panels> panels = Panels::Create(width, int(4000.0 * scale), scale);
        ASSERT_TRUE(panels);
        PanelChoices choices;
        panels->Controls().SetOpenSections({"Solver", "Draw"});
        panels->Build({}, choices, {});
        panels->Build({}, choices, {});
        const Widgets& controls = panels->Controls();
        for (const auto& [left, right] :
             {std::pair("Draw/Shapes", "Draw/Joints"),
              std::pair("Draw/Contact points", "Draw/Contact normals"),
              std::pair("Draw/Contact impulses", "Draw/Friction impulses"),
              std::pair("Draw/Centres of mass", "Draw/Mass signs"),
              std::pair("Solver/Continuous", "Solver/Sub-stepping")})
        {
            const auto a = controls.PlaceOf(left);
            const auto b = controls.PlaceOf(right);
            ASSERT_TRUE(a && b) << left;
            EXPECT_EQ(a->low.y, b->low.y) << left << ": in one row";
            EXPECT_GE(b->low.x - a->high.x, 4.0 * scale) << left << " at scale " << scale;
            EXPECT_LE(b->high.x, float(width) - 8.0 * scale) << right << " at scale " << scale;
        }
    }
}

TEST(Panels, GiveEachControlItsOwnName)
{
    Result<Panels> panels = Panels::Create(1280, 4000, 1.0);
    ASSERT_TRUE(panels);
    PanelChoices choices;
    panels->Controls().SetOpenSections(
        {"Scenes", "Solver", "Draw", "Statistics", "Profile", "Keys"});
    panels->Build({}, choices, {});
    panels->Build({}, choices, {});
    const std::vector<std::string> names = panels->Controls().Names();
    EXPECT_GT(names.size(), 50u);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_THAT(names, Contains("Run/Record"));
    EXPECT_THAT(names, Contains("Draw/Theme"));
}

TEST(ScriptWriter, WritesScriptThatIsReadBack)
{
    const std::string text = "scene \"Newton's Cradle\" --size 640x360\n"
                             "at 0.000000000s camera 0,5,20\n"
                             "at 1.500000000s camera 1,5,20\n"
                             "at step 1 press d\n"
                             "at step 2 release d\n"
                             "at step 3 grab 0.100000001,-1.23456786e-07\n"
                             "at step 3 to step 9 drag 8,4\n"
                             "at step 10 move 3.5,4\n"
                             "at step 11 drop\n"
                             "at step 12 bomb\n"
                             "at step 13 bomb 0,30 5,-40\n"
                             "at step 14 shift 100,0\n"
                             "at step 15 set sub-steps 4\n"
                             "at step 15 set sleep off\n"
                             "at step 16 click \"Draw/Contact points\"\n"
                             "at step 17 type \"a b\"\n"
                             "at step 18 hit ctrl+o\n"
                             "at step 20 expect ball.x > 3\n"
                             "shot a.png --draw shapes --step 20\n"
                             "record a.mp4 --seconds 2\n";
    const Result<Script> script = ParseScript(text, "a.play");
    ASSERT_TRUE(script) << script.GetError().Text();
    EXPECT_EQ(WriteScript(*script), text);
}

TEST(Script, NamesCulpritOfInvalidSettingsAndPanels)
{
    for (const auto& [line, culprit, detail] : {std::tuple("set slep off", "'slep'", "'sleep'"),
                                                {"set sleep maybe", "sleep maybe", "on or off"},
                                                {"set sub-steps 65", "sub-steps 65", "64"},
                                                {"set", "'set'", "velocity-iterations"},
                                                {"click", "'click'", "Solver/Sleep"},
                                                {"type a b", "'b'", "'type'"},
                                                {"hit", "'hit'", "ctrl+o"}})
    {
        EXPECT_THAT(ParseScript(std::string("scene car\nat 1s ") + line + "\n", "a.play"),
                    RefusesWith(std::string("a.play:2: ") + culprit, detail));
    }
}

TEST(Script, KeepsChangedSettingsInSavedState)
{
    const std::string lines = "at step 2 set velocity-iterations 3\nat step 2 set sleep off\n";
    SceneSession session = Played(lines, 5, false);
    EXPECT_EQ(session.Steps().velocityIterations, 3);
    const std::vector<std::uint8_t> state = session.SaveState();
    session.AdvanceTo(40);
    SceneSession other = Played(lines, 0, false);
    ASSERT_TRUE(other.RestoreState(state));
    EXPECT_EQ(other.Steps().velocityIterations, 3);
    other.AdvanceTo(40);
    EXPECT_EQ(StateHashText(other.World()), StateHashText(session.World()));
}

} // namespace
} // namespace boxreel
