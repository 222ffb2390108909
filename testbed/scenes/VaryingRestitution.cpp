// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBallCount = 7;
constexpr float32 kBallStep = 3.0f; ///< from ball to ball [m]
constexpr float32 kRadius = 1.0f;   ///< [m]
constexpr float32 kDrop = 12.0f;    ///< how far they fall [m]

constexpr float32 RestitutionOf(int32 ball)
{
    return static_cast<float32>(ball) / static_cast<float32>(kBallCount - 1);
}

constexpr float32 PlaceOf(int32 ball)
{
    return kBallStep * static_cast<float32>(ball - kBallCount / 2);
}

/// From a ball that stays where it falls to one that comes back as high as it was. The lines mark
/// the height that each first bounce should reach.
class VaryingRestitution : public Scene
{
public:
    explicit VaryingRestitution(const SceneSettings& settings) : Scene(settings)
    {
        m_ground = AddGroundEdge(m_world, b2Vec2(-12.0f, 0.0f), b2Vec2(12.0f, 0.0f));
        for (int32 i = 0; i < kBallCount; ++i)
        {
            AddBall(m_world, b2Vec2(PlaceOf(i), kDrop + kRadius), kRadius,
                    {.restitution = RestitutionOf(i)});
        }
    }

    void Draw(b2Draw& draw) const override
    {
        for (int32 i = 0; i < kBallCount; ++i)
        {
            const float32 height = RestitutionOf(i) * RestitutionOf(i) * kDrop + kRadius;
            const b2Vec2 middle = m_ground->GetWorldPoint(b2Vec2(PlaceOf(i), height));
            const b2Vec2 reach(1.2f * kRadius, 0.0f);
            draw.DrawSegment(middle - reach, middle + reach, kOrange);
        }
    }

    void VisitState(SceneState& state) override { state(m_ground); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.0f), .halfSize = b2Vec2(12.5f, 7.5f)};
    }

private:
    b2Body* m_ground;
};

} // namespace

std::unique_ptr<Scene> MakeVaryingRestitution(const SceneSettings& settings)
{
    return std::make_unique<VaryingRestitution>(settings);
}

} // namespace boxreel
