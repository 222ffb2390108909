// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kCount = 10;
constexpr float32 kHalfSize = 0.5f; ///< [m]

// Factor of the mass from box to box. The top box of the last column has a thousand times the mass
// of the one at its foot.
constexpr float32 kGrowths[] = {1.0f, 1.29155f, 1.66810f, 2.15443f};
constexpr float32 kPitch = 4.0f; ///< from column to column [m]

/// Columns whose boxes get heavier from the foot to the top: all alike, and up to 10, 100 and 1000
/// times as heavy.
class HighMassRatio3 : public Scene
{
public:
    explicit HighMassRatio3(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:1000
        AddGroundEdge(m_world, b2Vec2(-15.0f, 0.0f), b2Vec2(15.0f, 0.0f));
        float32 x = -1.5f * kPitch;
        for (const float32 growth : kGrowths)
        {
            Material material;
            for (int32 i = 0; i < kCount; ++i)
            {
                AddBox(m_world, b2Vec2(x, kHalfSize * static_cast<float32>(2 * i + 1)), kHalfSize,
                       kHalfSize, material);
                material.density *= growth;
            }
            x += kPitch;
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeHighMassRatio3(const SceneSettings& settings)
{
    return std::make_unique<HighMassRatio3>(settings);
}

} // namespace boxreel
