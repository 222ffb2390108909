// SPDX-License-Identifier: MIT
#include <Dynamics/ContactBlocks.h>
#include <golden/StateHash.h>
#include <scenes/Scene.h>

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

/// The state of every scene after 600 steps, as a hash, against the one that is stored in
/// scene-states.txt: the same from every compiler, at every optimisation level, on every run.
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

TEST(SceneStates, AreThoseStoredAfter600Steps)
{
    const std::map<std::string, std::string> stored = StoredStates();
    EXPECT_EQ(stored.size(), AllScenes().size());
    for (const SceneEntry& entry : AllScenes())
    {
        const std::string name(entry.name);
        const std::string state = StateAfter600Steps(entry);
        const auto found = stored.find(name);
        EXPECT_TRUE(found != stored.end() && found->second == state)
            << "When the change is meant, this line belongs into " << BOXREEL_SCENE_STATES << ":\n"
            << state << " " << name;
    }
}

TEST(SceneStates, AreThoseStoredWhateverTheNumberOfThreadsAndLanes)
{
    const std::map<std::string, std::string> stored = StoredStates();
    for (const bool wide : {true, false})
    {
        box2d::UseWideInstructions(wide);
        for (const int32 threads : {1, 2, 3, 4, 8})
        {
            for (const SceneEntry& entry : AllScenes())
            {
                const auto found = stored.find(std::string(entry.name));
                EXPECT_TRUE(found != stored.end() &&
                            found->second == StateAfter600Steps(entry, threads))
                    << entry.name << " with " << threads << " threads, wide: " << wide;
            }
        }
    }
    box2d::UseWideInstructions(true);
}

TEST(SceneStates, AreTheSameOnEveryRun)
{
    for (const SceneEntry& entry : AllScenes())
    {
        EXPECT_EQ(StateAfter600Steps(entry), StateAfter600Steps(entry)) << entry.name;
    }
}

} // namespace
} // namespace boxreel
