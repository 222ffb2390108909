// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBaseCount = 8;
constexpr float32 kHalfSize = 0.5f;                  ///< of the light boxes [m]
constexpr float32 kHeavyHalfSize = 1.5f;             ///< [m]
constexpr Material kHeavy{.density = 200.0f / 9.0f}; ///< nine times the area, 200 times the mass

/// A pyramid whose upper half is one heavy box.
class HighMassRatio1 : public Scene
{
public:
    explicit HighMassRatio1(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:200
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        constexpr int32 kRows = 5;
        for (int32 row = 0; row < kRows; ++row)
        {
            const int32 boxes = kBaseCount - row;
            for (int32 i = 0; i < boxes; ++i)
            {
                const float32 x =
                    2.0f * kHalfSize *
                    (static_cast<float32>(i) - 0.5f * static_cast<float32>(boxes - 1));
                AddBox(m_world, b2Vec2(x, kHalfSize * static_cast<float32>(2 * row + 1)), kHalfSize,
                       kHalfSize);
            }
        }
        AddBox(m_world, b2Vec2(0.0f, 2.0f * kHalfSize * kRows + kHeavyHalfSize), kHeavyHalfSize,
               kHeavyHalfSize, kHeavy);
    }
};

} // namespace

std::unique_ptr<Scene> MakeHighMassRatio1(const SceneSettings& settings)
{
    return std::make_unique<HighMassRatio1>(settings);
}

} // namespace boxreel
