// SPDX-License-Identifier: MIT
#include <scenes/Scenes.h>

namespace boxreel
{

std::span<const SceneEntry> AllScenes()
{
    static const SceneEntry kScenes[] = {
        {"Pyramid", "Stacking", "A pyramid of 210 boxes settles and stands.", MakePyramid},
        {"Vertical Stack", "Stacking",
         "Columns of boxes, true and untrue, stand until a heavy ball runs into them.",
         MakeVerticalStack},
        {"Bridge", "Joints", "A bridge of hinged planks carries what falls on it.", MakeBridge},
        {"Chain", "Joints", "A chain let go from the horizontal swings and curls.", MakeChain},
        {"Dominos", "Examples",
         "A hammer starts two rows of dominoes, a ball carries the news from one to the other.",
         MakeDominos},
        {"Tumbler", "Stacking", "A turning drum churns boxes that are dropped in one by one.",
         MakeTumbler},
        {"Newton's Cradle", "Joints",
         "One ball falls against a row of touching balls and the last one swings out.",
         MakeNewtonsCradle},
    };
    return kScenes;
}

} // namespace boxreel
