// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

// 10 km out single precision knows places to a millimetre.
const b2Vec2 kFar(10000.0f, -8000.0f); ///< [m]
constexpr int32 kBaseCount = 12;
constexpr float32 kHalfSize = 0.5f; ///< [m]

/// A pyramid so far from the origin that single precision would let it jitter and crumble.
class FarPyramid : public Scene
{
public:
    explicit FarPyramid(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(2);
        AddGroundBox(m_world, kFar + b2Vec2(0.0f, -1.0f), 15.0f, 1.0f);
        AddPyramid(m_world, kFar, kBaseCount, kHalfSize);
        b2Body* ball = AddBall(m_world, kFar + b2Vec2(-14.0f, 1.0f), 1.0f, {.density = 2.0f});
        ball->SetLinearVelocity(b2Vec2(1.5f, 0.0f)); // by then the pyramid has been seen to stand
    }
};

} // namespace

std::unique_ptr<Scene> MakeFarPyramid(const SceneSettings& settings)
{
    return std::make_unique<FarPyramid>(settings);
}

} // namespace boxreel
