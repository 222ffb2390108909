// SPDX-License-Identifier: MIT
#include "../../engine/UnguardedWorld.h"
#include "EveryScene.h"

#include <golden/StateHash.h>

#include <gtest/gtest.h>

#include <memory>

/// The energy guard must leave all scenes alone: none of them gains energy. Each is played twice,
/// once without the guard, and both must stay the same to the last bit.
namespace boxreel
{
namespace
{

constexpr int kSteps = 600; // of 1/60 s

class GuardedScene : public testing::TestWithParam<SceneCase>
{};

TEST_P(GuardedScene, LosesNothingToTheEnergyGuard)
{
    const std::unique_ptr<Scene> guarded = GetParam()->create(SceneSettings{});
    const std::unique_ptr<Scene> unguarded = GetParam()->create(SceneSettings{});
    for (int step = 0; step < kSteps; ++step)
    {
        dynamics::LeaveNextStepUnguarded(unguarded->World());
        guarded->Step(guarded->PreferredSteps());
        unguarded->Step(unguarded->PreferredSteps());
        // Equal energies do not say that all bits are equal, but this tells the first step.
        const double left = dynamics::KineticOf(guarded->World());
        const double without = dynamics::KineticOf(unguarded->World());
        ASSERT_EQ(left, without) << "step " << step << ": the guard took " << without - left
                                 << " J of " << without;
    }
    EXPECT_EQ(StateHashText(guarded->World()), StateHashText(unguarded->World()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, GuardedScene, testing::ValuesIn(EveryScene()), CaseName);

} // namespace
} // namespace boxreel
