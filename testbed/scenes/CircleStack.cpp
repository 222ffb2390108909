// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBaseCount = 12;
constexpr float32 kRadius = 0.5f; ///< [m]

// Neighbours in a row leave a little room, so that each ball rests on the two below and not on
// those beside it.
constexpr float32 kStep = 1.02f;     ///< from centre to centre in a row [m]
constexpr float32 kRowStep = 0.861f; ///< from row to row: balls of 1 m that touch [m]

/// A heap of balls between two kerbs. Only the kerbs keep it from spreading.
class CircleStack : public Scene
{
public:
    explicit CircleStack(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-15.0f, 0.0f), b2Vec2(15.0f, 0.0f));
        const float32 kerb = 0.5f * kStep * static_cast<float32>(kBaseCount - 1) + kRadius;
        AddGroundBox(m_world, b2Vec2(-kerb - 0.5f, 0.4f), 0.5f, 0.4f);
        AddGroundBox(m_world, b2Vec2(kerb + 0.5f, 0.4f), 0.5f, 0.4f);
        for (int32 row = 0; row < kBaseCount; ++row)
        {
            const int32 balls = kBaseCount - row;
            const float32 left = -0.5f * kStep * static_cast<float32>(balls - 1);
            for (int32 i = 0; i < balls; ++i)
            {
                AddBall(m_world,
                        b2Vec2(left + kStep * static_cast<float32>(i),
                               kRadius + kRowStep * static_cast<float32>(row)),
                        kRadius);
            }
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeCircleStack(const SceneSettings& settings)
{
    return std::make_unique<CircleStack>(settings);
}

} // namespace boxreel
