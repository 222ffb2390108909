// SPDX-License-Identifier: MIT
#include <scenes/MobileTree.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

/// Every rod hangs at its middle and none is balanced, so the pendulums move chaotically.
class Mobile : public Scene
{
public:
    explicit Mobile(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // what swings keeps its energy
        Name(*AddMobile(m_world, 14.0f, HeldAt::Middle), "top");
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 8.0f), .halfSize = b2Vec2(12.0f, 10.0f)};
    }
};

} // namespace

std::unique_ptr<Scene> MakeMobile(const SceneSettings& settings)
{
    return std::make_unique<Mobile>(settings);
}

} // namespace boxreel
