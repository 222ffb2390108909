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
        {"Card House", "Stacking", "A house of cards of five storeys stands.", MakeCardHouse},
        {"Arch", "Stacking", "A half circle of stones stands by itself and carries a load.",
         MakeArch},
        {"Double Domino", "Examples", "A wedge falls between two rows of dominoes, and both run.",
         MakeDoubleDomino},
        {"Circle Stack", "Stacking", "A heap of balls stands between two kerbs.", MakeCircleStack},
        {"Rain", "Stacking", "Balls, boxes and triangles rain through pegs into a basin.",
         MakeRain},
        {"Large Pyramid", "Stacking", "A pyramid of 1275 boxes stands and falls asleep at once.",
         MakeLargePyramid},
        {"Many Pyramids", "Stacking", "Two dozen pyramids come to rest, each by itself.",
         MakeManyPyramids},
        {"Far Pyramid", "Stacking", "A pyramid 13 km from the origin stands as it would there.",
         MakeFarPyramid},
        {"Smash", "Stacking", "Without gravity, a heavy box scatters a wall of small ones.",
         MakeSmash},
        {"Spinner", "Joints", "A motor stirs a box full of small things.", MakeSpinner},
        {"High Mass Ratio 1", "Stacking",
         "A pyramid carries a box of two hundred times the mass of one of its own.",
         MakeHighMassRatio1},
        {"High Mass Ratio 2", "Stacking", "A slab lies on two boxes of a thousandth of its mass.",
         MakeHighMassRatio2},
        {"High Mass Ratio 3", "Stacking",
         "Columns stand though their boxes get up to a thousand times heavier to the top.",
         MakeHighMassRatio3},
        {"Heavy 1", "Stacking", "A heavy ball rests on a light one.", MakeHeavy1},
        {"Heavy 2", "Stacking", "A heavy ball falls on two light ones and is carried.", MakeHeavy2},
        {"Overlap Recovery", "Stacking",
         "Boxes that are deep in each other come apart without a jump.", MakeOverlapRecovery},
        {"Chain Slide", "Collision",
         "A box slides down a chain of many pieces as if it were smooth.", MakeChainSlide},
        {"Ghost Bumps", "Collision",
         "Boxes slide over the seams of a row of boxes, of edges and of a chain, and none bumps.",
         MakeGhostBumps},
        {"Skinny Box", "Continuous",
         "A thin rod of a box is thrown on an edge again and again and never passes.",
         MakeSkinnyBox},
    };
    return kScenes;
}

} // namespace boxreel
