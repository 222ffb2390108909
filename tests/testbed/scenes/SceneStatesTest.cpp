// SPDX-License-Identifier: MIT
#include "EveryScene.h"

#include <golden/StateHash.h>
#include <scenes/Scene.h>

#include <Common/WideInstructions.h>
#include <Dynamics/Solver/ContactBlocks.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

/// The state of every scene after 600 steps as a hash, compared with scene-states.txt. It is the
/// same from every compiler, at every optimisation level, on every run. After an intended change,
/// `cmake --build build --target accept_scene_states` writes the file again.
namespace boxreel
{
namespace
{

std::string StateAfter600Steps(const SceneEntry& entry, int32 threads = 1)
{
    const std::unique_ptr<Scene> scene = entry.create(SceneSettings{});
    scene->World().SetThreadCount(threads);
    for (int step = 0; step < 600; ++step)
    {
        scene->Step(StepSettings{});
    }
    return StateHashText(scene->World());
}

std::map<std::string, std::string> StoredStates()
{
    std::map<std::string, std::string> states;
    std::ifstream file(BOXREEL_SCENE_STATES);
    for (std::string hash, name; file >> hash >> std::ws && std::getline(file, name);)
    {
        states[name] = hash;
    }
    return states;
}

/// Returns the stored state; empty if there is none.
std::string StoredState(const SceneEntry& entry)
{
    const std::map<std::string, std::string> stored = StoredStates();
    const auto found = stored.find(entry.name);
    return found != stored.end() ? found->second : "";
}

/// Writes the file before any test reads it, for the target accept_scene_states.
class Acceptance : public testing::Environment
{
public:
    void SetUp() override
    {
        if (std::getenv("BOXREEL_ACCEPT_SCENE_STATES") == nullptr)
        {
            return;
        }
        std::ofstream file(BOXREEL_SCENE_STATES);
        for (const SceneEntry& entry : AllScenes())
        {
            file << StateAfter600Steps(entry) << " " << entry.name << "\n";
        }
    }
};

[[maybe_unused]] testing::Environment* const kAcceptance =
    testing::AddGlobalTestEnvironment(new Acceptance);

TEST(SceneStates, AreStoredForExactlyAllScenes)
{
    EXPECT_EQ(StoredStates().size(), AllScenes().size());
    for (const SceneEntry& entry : AllScenes())
    {
        EXPECT_NE(StoredState(entry), "") << entry.name;
    }
}

class StateOfScene : public testing::TestWithParam<SceneCase>
{};

TEST_P(StateOfScene, IsTheStoredOneAfter600Steps)
{
    const std::string state = StateAfter600Steps(*GetParam());
    EXPECT_EQ(state, StoredState(*GetParam()))
        << "When the change is meant, this line belongs into " << BOXREEL_SCENE_STATES << ":\n"
        << state << " " << GetParam()->name;
}

// The division of work among threads is independent of the lanes. So each number of threads is
// tested once with the widest, and one and several with fewer.
TEST_P(StateOfScene, IsIndependentOfThreadsAndLanes)
{
    const std::string stored = StoredState(*GetParam());
    for (const int32 threads : {2, 3, 4, 8})
    {
        EXPECT_EQ(StateAfter600Steps(*GetParam(), threads), stored) << threads << " threads";
    }
    for (const int lanes : {4, 8})
    {
        box2d::UseLanes(lanes);
        EXPECT_EQ(StateAfter600Steps(*GetParam(), lanes == 4 ? 1 : 3), stored) << lanes << " lanes";
    }
    box2d::UseLanes(16);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StateOfScene, testing::ValuesIn(EveryScene()), CaseName);

} // namespace
} // namespace boxreel
