// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfSize = 0.5f;                    ///< of the light boxes [m]
constexpr float32 kHeavyHalfWidth = 6.0f;              ///< [m]
constexpr float32 kHeavyHalfHeight = 2.0f;             ///< [m]
constexpr Material kHeavy{.density = 1000.0f / 48.0f}; ///< 48 times the area, 1000 times the mass

/// A slab on two boxes of a thousandth of its mass.
class HighMassRatio2 : public Scene
{
public:
    explicit HighMassRatio2(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:1000
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        AddBox(m_world, b2Vec2(-5.0f, kHalfSize), kHalfSize, kHalfSize);
        AddBox(m_world, b2Vec2(5.0f, kHalfSize), kHalfSize, kHalfSize);
        AddBox(m_world, b2Vec2(0.0f, 2.0f * kHalfSize + kHeavyHalfHeight), kHeavyHalfWidth,
               kHeavyHalfHeight, kHeavy);
    }
};

} // namespace

std::unique_ptr<Scene> MakeHighMassRatio2(const SceneSettings& settings)
{
    return std::make_unique<HighMassRatio2>(settings);
}

} // namespace boxreel
