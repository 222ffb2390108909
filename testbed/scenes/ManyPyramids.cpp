// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kRows = 4;
constexpr int32 kPerRow = 6;
constexpr int32 kBaseCount = 8;
constexpr float32 kHalfSize = 0.5f;   ///< [m]
constexpr float32 kPitch = 10.0f;     ///< from pyramid to pyramid [m]
constexpr float32 kRowHeight = 10.0f; ///< [m]

/// Piles that have nothing to do with each other: each comes to rest and sleeps by itself.
class ManyPyramids : public Scene
{
public:
    explicit ManyPyramids(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(2); // with one step they tremble on for long
        const float32 left = -0.5f * kPitch * static_cast<float32>(kPerRow - 1);
        for (int32 row = 0; row < kRows; ++row)
        {
            const float32 y = kRowHeight * static_cast<float32>(row);
            AddGroundEdge(m_world, b2Vec2(left - 0.6f * kPitch, y),
                          b2Vec2(-left + 0.6f * kPitch, y));
            for (int32 i = 0; i < kPerRow; ++i)
            {
                AddPyramid(m_world, b2Vec2(left + kPitch * static_cast<float32>(i), y), kBaseCount,
                           kHalfSize);
            }
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeManyPyramids(const SceneSettings& settings)
{
    return std::make_unique<ManyPyramids>(settings);
}

} // namespace boxreel
