// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

/// Scenes by name, and their time, for tests of what they are known for.
namespace boxreel
{

inline std::unique_ptr<Scene> Make(const std::string& name, uint32 seed = 1)
{
    for (const SceneEntry& entry : AllScenes())
    {
        if (entry.name == name)
        {
            return entry.create(SceneSettings{seed});
        }
    }
    ADD_FAILURE() << "no scene is called " << name;
    return nullptr;
}

/// Dynamic bodies in the order in which the scene made them.
inline std::vector<b2Body*> Movers(Scene& scene)
{
    std::vector<b2Body*> movers;
    for (b2Body* body = scene.World().GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_dynamicBody)
        {
            movers.push_back(body);
        }
    }
    std::ranges::reverse(movers);
    return movers;
}

/// Calls `look` after every step.
template <class Look>
void Play(Scene& scene, float32 seconds, const Look& look)
{
    const int32 steps = static_cast<int32>(std::lround(seconds * 60.0f));
    for (int32 i = 0; i < steps; ++i)
    {
        scene.Step(scene.PreferredSteps());
        look();
    }
}

inline void Play(Scene& scene, float32 seconds)
{
    Play(scene, seconds, [] {});
}

} // namespace boxreel
