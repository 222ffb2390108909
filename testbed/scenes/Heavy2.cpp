// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kSmall = 0.5f; ///< radius of the light balls [m]
constexpr float32 kLarge = 5.0f; ///< radius of the heavy ball, a hundred times the mass [m]
constexpr float32 kReach = 2.0f; ///< of the light balls to either side [m]

/// A heavy ball is dropped on two light ones that lie side by side and are held by kerbs.
class Heavy2 : public Scene
{
public:
    explicit Heavy2(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:100
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        for (const float32 side : {-1.0f, 1.0f})
        {
            AddGroundBox(m_world, b2Vec2(side * (kReach + kSmall + 0.25f), 0.4f), 0.25f, 0.4f);
            AddBall(m_world, b2Vec2(side * kReach, kSmall), kSmall);
        }
        AddBall(m_world, b2Vec2(0.0f, 10.0f), kLarge);
    }
};

} // namespace

std::unique_ptr<Scene> MakeHeavy2(const SceneSettings& settings)
{
    return std::make_unique<Heavy2>(settings);
}

} // namespace boxreel
