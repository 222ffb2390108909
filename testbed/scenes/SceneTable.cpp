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
        {"Car", "Vehicles",
         "A car on springs drives over waves, a seesaw, a hanging bridge and into boxes.", MakeCar},
        {"Theo Jansen's Walker", "Vehicles", "Six legs of bars, moved by one crank, walk.",
         MakeTheoJansensWalker},
        {"Revolute", "Joints",
         "Hinges: a wheel with a motor, a gate with a limit, a free pendulum.", MakeRevolute},
        {"Prismatic", "Joints", "A motor moves a carriage up and down a slide between its limits.",
         MakePrismatic},
        {"Pulleys", "Joints",
         "A basket on a rope over two wheels goes down when enough has fallen into it.",
         MakePulleys},
        {"Gears", "Joints", "A small gear turns a large one, which moves a rack up and down.",
         MakeGears},
        {"Slider Crank", "Examples", "A crank drives a piston up and down in its guide.",
         MakeSliderCrank},
        {"Apply Force", "Examples",
         "Seen from above, a ship is pushed and turned and runs into boxes.", MakeApplyForce},
        {"Motor Joint", "Joints",
         "A plate follows a path with a limited force and pushes boxes aside.", MakeMotorJoint},
        {"RopeJoint", "Joints",
         "A rope from end to end keeps a light chain whole under a heavy ball.", MakeRopeJoint},
        {"Joint Grid", "Joints", "A cloth of hinged balls swings from one nail.", MakeJointGrid},
    };
    return kScenes;
}

} // namespace boxreel
