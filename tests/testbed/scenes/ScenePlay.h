// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

/// Helpers for tests of single scenes: make one by its name and play it.
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
    std::abort();
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

/// The body that the scene calls so.
inline b2Body& Named(Scene& scene, std::string_view name)
{
    for (b2Body* body = scene.World().GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const auto found = scene.Names().find(static_cast<std::uint32_t>(body->GetNumber()));
        if (found != scene.Names().end() && found->second == name)
        {
            return *body;
        }
    }
    ADD_FAILURE() << "no body is called " << name;
    std::abort();
}

/// Joints of a class in the order in which the scene made them.
template <class Joint>
std::vector<Joint*> JointsOf(Scene& scene)
{
    std::vector<Joint*> joints;
    for (b2Joint* joint = scene.World().GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        if (auto* wanted = dynamic_cast<Joint*>(joint))
        {
            joints.push_back(wanted);
        }
    }
    std::ranges::reverse(joints);
    return joints;
}

/// Calls `look` after every step, as the scene prefers it: of a sixtieth of a second.
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

/// Between the anchors of a joint, for those whose anchors belong together.
inline float32 WidestJointGap(Scene& scene)
{
    float32 widest = 0.0f;
    for (b2Joint* joint = scene.World().GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        widest = std::max(widest, b2Distance(joint->GetAnchorA(), joint->GetAnchorB()));
    }
    return widest;
}

/// The same of hinges only.
inline float32 WidestHingeGap(Scene& scene)
{
    float32 widest = 0.0f;
    for (const b2RevoluteJoint* hinge : JointsOf<b2RevoluteJoint>(scene))
    {
        widest = std::max(widest, b2Distance(hinge->GetAnchorA(), hinge->GetAnchorB()));
    }
    return widest;
}

} // namespace boxreel
