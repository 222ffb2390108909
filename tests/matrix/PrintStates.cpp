// SPDX-License-Identifier: MIT
#include <golden/StateHash.h>
#include <scenes/Scene.h>

#include <cstdio>

/// Prints the state of every scene after 600 steps, with one step and with sub-steps: what builds
/// for two kinds of processor can be compared by. Needs the engine and the scenes alone, so that it
/// can be built where no other library is.
int main()
{
    for (const int32 subSteps : {1, 2, 4})
    {
        for (const boxreel::SceneEntry& entry : boxreel::AllScenes())
        {
            const std::unique_ptr<boxreel::Scene> scene = entry.create(boxreel::SceneSettings{});
            scene->World().SetSubStepCount(subSteps);
            for (int32 step = 0; step < 600; ++step)
            {
                scene->Step(boxreel::StepSettings{});
            }
            std::printf("%s %s, %d sub-steps\n", boxreel::StateHashText(scene->World()).c_str(),
                        entry.name, int(subSteps));
        }
    }
    return 0;
}
