// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBaseCount = 6;
constexpr float32 kHalfSize = 0.5f; ///< [m]
constexpr float32 kOverlap = 0.25f; ///< of a box's size

/// Boxes that have been put deep in each other come apart, without one being thrown.
class OverlapRecovery : public Scene
{
public:
    explicit OverlapRecovery(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // pushes what is deep out slowly
        AddGroundEdge(m_world, b2Vec2(-15.0f, 0.0f), b2Vec2(15.0f, 0.0f));
        const float32 step = 2.0f * kHalfSize * (1.0f - kOverlap);
        for (int32 row = 0; row < kBaseCount; ++row)
        {
            const int32 boxes = kBaseCount - row;
            for (int32 i = 0; i < boxes; ++i)
            {
                const float32 x =
                    step * (static_cast<float32>(i) - 0.5f * static_cast<float32>(boxes - 1));
                AddBox(m_world, b2Vec2(x, kHalfSize + step * static_cast<float32>(row)), kHalfSize,
                       kHalfSize);
            }
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeOverlapRecovery(const SceneSettings& settings)
{
    return std::make_unique<OverlapRecovery>(settings);
}

} // namespace boxreel
