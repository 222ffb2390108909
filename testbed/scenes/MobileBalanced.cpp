// SPDX-License-Identifier: MIT
#include <scenes/MobileTree.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

/// The same rods and balls as in Mobile, but every rod hangs where both of its ends pull equally.
class MobileBalanced : public Scene
{
public:
    explicit MobileBalanced(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // what swings keeps its energy
        Name(*AddMobile(m_world, 14.0f, HeldAt::Balance), "top");
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 9.0f), .halfSize = b2Vec2(9.0f, 6.0f)};
    }
};

} // namespace

std::unique_ptr<Scene> MakeMobileBalanced(const SceneSettings& settings)
{
    return std::make_unique<MobileBalanced>(settings);
}

} // namespace boxreel
