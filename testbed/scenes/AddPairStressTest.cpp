// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kPerSide = 20;       ///< balls, in rows and columns
constexpr float32 kStep = 0.6f;      ///< from ball to ball [m]
constexpr float32 kRadius = 0.15f;   ///< [m]
constexpr float32 kBlock = 1.5f;     ///< half its side [m]
constexpr float32 kSpeed = 60.0f;    ///< of the block [m/s]
const b2Vec2 kHalfRoom(16.0f, 9.0f); ///< [m]

/// Without gravity, so nearly all pairs come from the block and the bodies it moves.
class AddPairStressTest : public Scene
{
public:
    explicit AddPairStressTest(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        const b2Vec2 corners[] = {
            -kHalfRoom, {kHalfRoom.x, -kHalfRoom.y}, kHalfRoom, {-kHalfRoom.x, kHalfRoom.y}};
        for (int32 i = 0; i < 4; ++i)
        {
            AddGroundEdge(m_world, corners[i], corners[(i + 1) % 4]);
        }
        for (int32 i = 0; i < kPerSide * kPerSide; ++i)
        {
            const float32 x = static_cast<float32>(2 * (i % kPerSide) - kPerSide + 1);
            const float32 y = static_cast<float32>(2 * (i / kPerSide) - kPerSide + 1);
            AddBall(m_world, 0.5f * kStep * b2Vec2(x, y) + b2Vec2(2.0f, 0.0f), kRadius,
                    {.density = 0.5f, .friction = 0.1f});
        }
        b2Body* block = AddBox(m_world, b2Vec2(-13.0f, 0.0f), kBlock, kBlock, {.density = 5.0f});
        block->SetBullet(true);
        block->SetLinearVelocity(b2Vec2(kSpeed, 0.0f));
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"contacts", std::to_string(m_world.GetContactCount())}};
    }
};

} // namespace

std::unique_ptr<Scene> MakeAddPairStressTest(const SceneSettings& settings)
{
    return std::make_unique<AddPairStressTest>(settings);
}

} // namespace boxreel
