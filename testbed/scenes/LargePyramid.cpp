// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBaseCount = 50;
constexpr float32 kHalfSize = 0.5f; ///< [m]

/// Boxes that touch: nothing has to settle, and the pyramid comes to rest at once.
class LargePyramid : public Scene
{
public:
    explicit LargePyramid(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(2); // with one step it trembles on for long and does not sleep
        AddGroundBox(m_world, b2Vec2(0.0f, -1.0f), 40.0f, 1.0f);
        AddPyramid(m_world, b2Vec2(0.0f, 0.0f), kBaseCount, kHalfSize);
    }
};

} // namespace

std::unique_ptr<Scene> MakeLargePyramid(const SceneSettings& settings)
{
    return std::make_unique<LargePyramid>(settings);
}

} // namespace boxreel
