// SPDX-License-Identifier: MIT
#include <workbench/SceneHand.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

struct SceneHandTest : testing::Test
{
    SceneWork work{*SceneSession::Open(*OpenScene("car"), {})};
    SceneHand hand;

    SceneHandTest() { work.Begin(SolverOf(work.Session())); }

    static WindowEvent At(Vec2 point, int button = 0, bool shift = false)
    {
        WindowEvent event;
        event.point = point;
        event.button = button;
        event.shift = shift;
        return event;
    }
    std::size_t SlingLines()
    {
        DrawList list;
        hand.AddSling(work, {10.0f, 10.0f}, list);
        return list.items.size();
    }
};

TEST_F(SceneHandTest, LeavesTheSceneAloneWhenPressedOnPanels)
{
    hand.Press(work, At({10.0f, 10.0f}), true);
    hand.Move(work, At({90.0f, 90.0f}));
    hand.Release(work, At({90.0f, 90.0f}));
    EXPECT_THAT(work.Script(), Not(HasSubstr("grab")));
}

TEST_F(SceneHandTest, MovesTheViewWithTheOtherButton)
{
    const Camera before = work.View();
    hand.Press(work, At({100.0f, 100.0f}, 1), false);
    hand.Move(work, At({60.0f, 130.0f}, 1));
    const Camera after = work.View();
    EXPECT_NEAR(after.centerX - before.centerX, 40.0 / before.pixelsPerMeter, 1e-4);
    EXPECT_NEAR(after.centerY - before.centerY, 30.0 / before.pixelsPerMeter, 1e-4);
}

TEST_F(SceneHandTest, IgnoresASecondButtonWhileOneHolds)
{
    hand.Press(work, At({100.0f, 100.0f}, 0, true), false);
    hand.Press(work, At({100.0f, 100.0f}, 1), false);
    hand.Release(work, At({100.0f, 100.0f}, 1));
    EXPECT_EQ(SlingLines(), 2u) << "the bomb is still pulled";
    hand.Release(work, At({60.0f, 100.0f}, 0));
    EXPECT_EQ(SlingLines(), 0u);
    EXPECT_THAT(work.Script(), HasSubstr("bomb"));
}

TEST_F(SceneHandTest, ReleasesKeysAndBodiesWhenLettingGo)
{
    hand.PressKey(work, KeyOf('d'));
    hand.PressKey(work, KeyOf('x')); // the scene does not know it
    hand.Press(work, At({500.0f, 300.0f}), false);
    hand.LetGo(work, {510.0f, 300.0f});
    EXPECT_THAT(work.Script(), HasSubstr("release d"));
    EXPECT_THAT(work.Script(), Not(HasSubstr("press x")));
    EXPECT_THAT(work.Script(), HasSubstr("drop"));
}

} // namespace
} // namespace boxreel
