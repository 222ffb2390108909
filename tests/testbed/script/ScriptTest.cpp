// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <script/Script.h>
#include <script/ScriptWords.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = ScriptAction::Kind;

constexpr Rational kRate{60, 1};

Script Parsed(const std::string& text)
{
    Result<Script> script = ParseScript(text, "a.play");
    EXPECT_TRUE(script) << script.GetError().Text();
    return script ? *script : Script();
}

TEST(ScriptWords, AreBetweenBlanksOrInQuotesUpToAComment)
{
    EXPECT_THAT(*WordsOf("  at 1s\tpress d # a remark"), ElementsAre("at", "1s", "press", "d"));
    EXPECT_THAT(*WordsOf("scene \"Theo Jansen's Walker\" --caption=\"# no remark\""),
                ElementsAre("scene", "Theo Jansen's Walker", "--caption=# no remark"));
    EXPECT_THAT(*WordsOf("a#b \"\""), ElementsAre("a#b", ""));
    EXPECT_THAT(*WordsOf("# nothing\r"), IsEmpty());
    EXPECT_FALSE(WordsOf("scene \"dominos"));
}

TEST(ScriptWords, AreReadBackFromTheirLine)
{
    const std::vector<std::string> words{"shot", "a b.png", "", "#3", "plain"};
    EXPECT_EQ(*WordsOf(LineOf(words)), words);
}

TEST(Script, ReadsSceneOptionsAndTimedActions)
{
    const Script script = Parsed("# drives\n"
                                 "scene car --seed 3\n"
                                 "\n"
                                 "at 1.5s press d\n"
                                 "at step 240 release d\n"
                                 "at 2s tap s\n"
                                 "at 500ms grab 3.5,-4\n"
                                 "at 1s to 2s drag 8,4\n"
                                 "at 2s drop\n"
                                 "at 3s bomb\n"
                                 "at 3s bomb 0,30 5,-40\n"
                                 "at 4s shift 100,0\n");
    EXPECT_EQ(script.scene, "car");
    EXPECT_THAT(script.SceneOptions(), ElementsAre("--seed", "3"));
    std::vector<Kind> kinds;
    std::vector<std::int64_t> steps;
    for (const ScriptAction& action : script.actions)
    {
        kinds.push_back(action.kind);
        steps.push_back(action.at.Step(kRate));
    }
    EXPECT_THAT(kinds,
                ElementsAre(Kind::Press, Kind::Release, Kind::Press, Kind::Release, Kind::Grab,
                            Kind::Drag, Kind::Drop, Kind::Bomb, Kind::Sling, Kind::Shift));
    EXPECT_THAT(steps, ElementsAre(90, 240, 120, 120, 30, 60, 120, 180, 180, 240));
    EXPECT_EQ(script.actions[4].point, b2Vec2(3.5f, -4.0f));
    EXPECT_EQ(script.actions[5].until.Step(kRate), 120);
    EXPECT_EQ(script.actions[8].velocity, b2Vec2(5.0f, -40.0f));
    EXPECT_EQ(script.actions[2].line, 6);
}

TEST(Script, MakesFilmsAndPicturesWithTheOptionsOfTheirCommands)
{
    const Script script = Parsed("scene car\n"
                                 "at 5s shot \"a car.png\" --draw shapes\n"
                                 "shot grid.svg --at 0s,1s\n"
                                 "at step 3 golden car/3 --size 480x270\n"
                                 "at 8s expect chassis.x > 10\n"
                                 "record car.mp4 --seconds 8\n");
    ASSERT_EQ(script.products.size(), 5u);
    EXPECT_EQ(script.products[0].name, "a car.png");
    EXPECT_THAT(script.products[0].options,
                ElementsAre("--draw", "shapes", "--at", "5.000000000s"));
    EXPECT_THAT(script.products[1].options, ElementsAre("--at", "0s,1s"));
    EXPECT_EQ(script.products[2].at.Step(kRate), 3);
    EXPECT_THAT(script.products[2].options, ElementsAre("--size", "480x270"));
    EXPECT_EQ(script.products[3].name, "chassis.x > 10");
    EXPECT_EQ(script.products[4].kind, ScriptProduct::Kind::Record);
}

TEST(Script, MovesTheCameraFromLineToLine)
{
    EXPECT_THAT(Parsed("scene car\nat 0s camera 0,5,20\n").SceneOptions(),
                ElementsAre("--camera", "0,5,20"));
    EXPECT_THAT(Parsed("scene car\nat 0s camera 0,5,20\nat 1.5s camera 9,5,10\n").SceneOptions(),
                ElementsAre("--camera", "path:0.000000000s=0,5,20;1.500000000s=9,5,10"));
}

TEST(Script, NamesLineAndCulpritOfErrors)
{
    const std::pair<const char*, const char*> cases[] = {
        {"", "a.play"},
        {"at 1s press d", "a.play:1: 'at'"},
        {"scene", "a.play:1: 'scene'"},
        {"scene car\nscene bridge", "a.play:2: 'scene'"},
        {"scene car\n\nat 1s pres d", "a.play:3: 'pres'"},
        {"scene car\nat 1s", "a.play:2: 'at'"},
        {"scene car\nat", "a.play:2: 'at'"},
        {"scene car\nat noon press d", "a.play:2: at noon"},
        {"scene car\nat step -1 press d", "a.play:2: step -1"},
        {"scene car\nat step", "a.play:2: 'step'"},
        {"scene car\nat 1s press", "a.play:2: 'press'"},
        {"scene car\nat 1s press space", "a.play:2: 'press'"},
        {"scene car\nat 1s press d d", "a.play:2: 'd'"},
        {"scene car\nat 1s grab 3", "a.play:2: 'grab'"},
        {"scene car\nat 1s grab 3,nan", "a.play:2: 'grab'"},
        {"scene car\nat 1s move 1e300,0", "a.play:2: 'move'"},
        {"scene car\nat 1s bomb 0,30", "a.play:2: 'bomb'"},
        {"scene car\nat 1s drag 3,4", "a.play:2: 'drag'"},
        {"scene car\nat 1s to 2s press d", "a.play:2: 'press'"},
        {"scene car\nat 1s camera 3,4", "a.play:2: 'camera'"},
        {"scene car\nat step 3 camera 3,4,5", "a.play:2: 'camera'"},
        {"scene car\nat 2s camera 3,4,5\nat 1s camera 3,4,5", "a.play:3: 'camera'"},
        {"scene car\nat 1s expect", "a.play:2: 'expect'"},
        {"scene car\ngolden a", "a.play:2: 'golden'"},
        {"scene car\nrecord", "a.play:2: 'record'"},
        {"scene car\nrecord -o a.mp4", "a.play:2: 'record'"},
        {"scene car\nrecrod a.mp4", "a.play:2: 'recrod'"},
        {"scene car\nrecord \"a.mp4", "a.play:2: \""},
    };
    for (const auto& [text, culprit] : cases)
    {
        EXPECT_THAT(ParseScript(text, "a.play"), Refuses(culprit)) << text;
    }
}

TEST(Script, ReadsOrRefusesAnyBytes)
{
    std::uint32_t state = 1;
    const std::string letters = "scene at 1s to press,\"#\n\t-.9drag record\\\xff";
    for (int i = 0; i < 20000; ++i)
    {
        std::string text = "scene car\n";
        for (int k = 0; k < 30; ++k)
        {
            state = state * 1664525u + 1013904223u;
            text += letters[(state >> 8) % letters.size()];
        }
        const Result<Script> script = ParseScript(text, "a.play");
        if (!script)
        {
            EXPECT_THAT(script.GetError().culprit, testing::StartsWith("a.play:")) << text;
        }
    }
}

} // namespace
} // namespace boxreel
