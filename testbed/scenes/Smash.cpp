// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kColumns = 30;
constexpr int32 kRows = 20;
constexpr float32 kHalfSize = 0.2f;    ///< [m]
constexpr float32 kRamHalfSize = 2.0f; ///< [m]
constexpr float32 kRamSpeed = 40.0f;   ///< [m/s]

// On all sides, so that no body leaves the arena.
const b2Vec2 kMiddle(8.0f, 0.0f);      ///< [m]
const b2Vec2 kHalfArena(30.0f, 16.5f); ///< [m]

/// Without gravity: a heavy box flies into a wall of small ones, and they scatter.
class Smash : public Scene
{
public:
    explicit Smash(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        const b2Vec2 low = kMiddle - kHalfArena, high = kMiddle + kHalfArena;
        const b2Vec2 corners[] = {low, b2Vec2(high.x, low.y), high, b2Vec2(low.x, high.y)};
        b2ChainShape arena;
        arena.CreateLoop(corners, 4);
        AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f))->CreateFixture(&arena, 0.0f);
        b2Body* ram =
            AddBox(m_world, b2Vec2(-15.0f, 0.3f), kRamHalfSize, kRamHalfSize, {.density = 8.0f});
        ram->SetLinearVelocity(b2Vec2(kRamSpeed, 0.0f));
        for (int32 column = 0; column < kColumns; ++column)
        {
            for (int32 row = 0; row < kRows; ++row)
            {
                const b2Vec2 place(static_cast<float32>(column),
                                   static_cast<float32>(row) - 0.5f * (kRows - 1));
                AddBox(m_world, 2.0f * kHalfSize * place, kHalfSize, kHalfSize);
            }
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = kMiddle, .halfSize = 1.03f * kHalfArena};
    }
};

} // namespace

std::unique_ptr<Scene> MakeSmash(const SceneSettings& settings)
{
    return std::make_unique<Smash>(settings);
}

} // namespace boxreel
