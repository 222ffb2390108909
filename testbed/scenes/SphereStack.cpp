// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBallCount = 10;
constexpr float32 kRadius = 0.5f;      ///< [m]
constexpr float32 kGap = 0.4f;         ///< between balls before they fall [m]
constexpr float32 kOffset = 0.01f;     ///< of every other ball of the untrue column [m]
constexpr float32 kColumnPlace = 3.0f; ///< of a column, left and right of the middle [m]

/// A column of balls is stable as long as each is exactly above the one below. The left one is
/// exact. In the right one every other ball is off by a centimetre.
class SphereStack : public Scene
{
public:
    explicit SphereStack(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-9.0f, 0.0f), b2Vec2(9.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 2.0f));
        AddGroundEdge(m_world, b2Vec2(9.0f, 0.0f), b2Vec2(9.0f, 2.0f));
        AddColumn(-kColumnPlace, 0.0f);
        AddColumn(kColumnPlace, kOffset);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.0f), .halfSize = b2Vec2(9.5f, 7.5f)};
    }

private:
    void AddColumn(float32 x, float32 offset)
    {
        for (int32 i = 0; i < kBallCount; ++i)
        {
            const float32 y = kRadius + (2.0f * kRadius + kGap) * static_cast<float32>(i);
            AddBall(m_world, b2Vec2(i % 2 == 0 ? x : x + offset, y), kRadius, {});
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeSphereStack(const SceneSettings& settings)
{
    return std::make_unique<SphereStack>(settings);
}

} // namespace boxreel
