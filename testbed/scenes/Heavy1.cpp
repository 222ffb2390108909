// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kSmall = 0.5f; ///< radius of the light ball [m]
constexpr float32 kLarge = 5.0f; ///< radius of the heavy ball, a hundred times the mass [m]

/// A heavy ball rests on a light one and does not press it into the ground.
class Heavy1 : public Scene
{
public:
    explicit Heavy1(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:100
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        AddBall(m_world, b2Vec2(0.0f, kSmall), kSmall);
        AddBall(m_world, b2Vec2(0.0f, 2.0f * kSmall + kLarge), kLarge);
    }
};

} // namespace

std::unique_ptr<Scene> MakeHeavy1(const SceneSettings& settings)
{
    return std::make_unique<Heavy1>(settings);
}

} // namespace boxreel
