// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <script/ScriptInput.h>

#include <gmock/gmock.h>

#include <cstdio>

namespace boxreel
{
namespace
{

/// Logs the actions on it.
class Listening : public Scene
{
public:
    Listening() : Scene(SceneSettings{}) {}
    std::span<const KeyBinding> Keys() const override
    {
        static constexpr KeyBinding kKeys[] = {{'d', "drives"}, {'s', "brakes"}};
        return kKeys;
    }
    void KeyDown(char key) override { notes += std::string("+") + key + " "; }
    void KeyUp(char key) override { notes += std::string("-") + key + " "; }
    void MouseDown(const b2Vec2& point) override { Note("down", point); }
    void MouseMove(const b2Vec2& point) override { Note("move", point); }
    void MouseUp(const b2Vec2& point) override { Note("up", point); }
    void ShiftOrigin(const b2Vec2& origin) override { Note("shift", origin); }

    std::string notes;

private:
    void Note(const char* what, const b2Vec2& point)
    {
        char text[64];
        std::snprintf(text, sizeof text, "%s %g,%g ", what, double(point.x), double(point.y));
        notes += text;
    }
};

Result<ScriptInput> InputOf(const std::string& lines, const Scene& scene)
{
    const Result<Script> script = ParseScript("scene car\n" + lines, "a.play");
    EXPECT_TRUE(script) << script.GetError().Text();
    return ScriptInput::Create(*script, Rational{10, 1}, scene);
}

/// Returns the actions before each of the steps, with a bar between them.
std::string Played(const std::string& lines, std::int64_t steps, std::int64_t from = 0)
{
    Listening scene;
    const Result<ScriptInput> input = InputOf(lines, scene);
    EXPECT_TRUE(input) << input.GetError().Text();
    for (std::int64_t step = from; input && step < steps; ++step)
    {
        StepSettings settings;
        input->Apply(scene, settings, step);
        scene.notes += "|";
    }
    return scene.notes;
}

TEST(ScriptInput, ReachesTheSceneBeforeItsStep)
{
    EXPECT_EQ(Played("at 0.2s press d\nat step 3 release d\nat 0.1s tap s\n", 5),
              "|+s -s |+d |-d ||");
}

TEST(ScriptInput, AppliesOneStepInOrderOfLines)
{
    EXPECT_EQ(Played("at 0s press d\nat 0s release d\nat 0s press s\n", 1), "+d -d +s |");
}

TEST(ScriptInput, DragsStraightToTheEndAndDropsThere)
{
    EXPECT_EQ(Played("at 0s grab 1,2\nat step 1 to step 5 drag 9,0\nat step 5 drop\n", 6),
              "down 1,2 |move 3,1.5 |move 5,1 |move 7,0.5 |move 9,0 |up 9,0 |");
}

TEST(ScriptInput, MovesAtOnceAndShiftsTheOrigin)
{
    EXPECT_EQ(Played("at 0s move 3,4\nat 0s shift 5,6\n", 1), "move 3,4 shift 5,6 |");
}

TEST(ScriptInput, IsTheSameWhenStartedInTheMiddle)
{
    const std::string lines = "at 0s grab 1,2\nat step 1 to step 5 drag 9,0\nat step 5 drop\n";
    EXPECT_EQ(Played(lines, 6, 3), "move 7,0.5 |move 9,0 |up 9,0 |");
}

TEST(ScriptInput, ThrowsBombs)
{
    Listening scene;
    const Result<ScriptInput> input = InputOf("at 0s bomb\nat step 1 bomb 3,4 5,6\n", scene);
    ASSERT_TRUE(input);
    StepSettings steps;
    input->Apply(scene, steps, 0);
    EXPECT_EQ(scene.World().GetBodyCount(), 1);
    input->Apply(scene, steps, 1);
    ASSERT_EQ(scene.World().GetBodyCount(), 1) << "the one before it has gone";
    EXPECT_EQ(scene.World().GetBodyList()->GetPosition(), b2Vec2(3.0f, 4.0f));
    EXPECT_EQ(scene.World().GetBodyList()->GetLinearVelocity(), b2Vec2(5.0f, 6.0f));
}

TEST(ScriptInput, NamesLineAndCulpritOfInvalidInput)
{
    const Listening scene;
    const std::pair<const char*, const char*> cases[] = {
        {"at 1s press x\n", "a.play:2: 'x'"},
        {"at 1s drop\n", "a.play:2: mouse"},
        {"at 1s to 2s drag 3,4\n", "a.play:2: mouse"},
        {"at 0s grab 1,1\nat 1s grab 2,2\n", "a.play:3: mouse"},
        {"at 0s grab 1,1\nat 2s to 1s drag 2,2\n", "a.play:3: 'drag'"},
        {"at 0s grab 1,1\nat 0s to 999999s drag 2,2\n", "a.play:3: 'drag'"},
    };
    for (const auto& [lines, culprit] : cases)
    {
        EXPECT_THAT(InputOf(lines, scene), Refuses(culprit)) << lines;
    }
}

} // namespace
} // namespace boxreel
