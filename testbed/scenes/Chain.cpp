// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kLinkCount = 16;
constexpr float32 kLinkLength = 1.1f;      ///< from hinge to hinge [m]
constexpr float32 kLinkHalfHeight = 0.14f; ///< [m]
constexpr float32 kAnchorHeight = 20.0f;   ///< [m]

// Links overlap at their hinges, as those of a real chain do; hinged neighbours do not collide.
constexpr float32 kLinkHalfLength = 0.5f * kLinkLength + 0.08f; ///< [m]

constexpr Material kSteel{.density = 10.0f, .friction = 0.2f};

/// Held at one end, let go from the horizontal: it swings down, its free end cracks like a whip,
/// and after some swings it hangs.
class Chain : public Scene
{
public:
    explicit Chain(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        b2Body* previous = AddGroundBox(m_world, b2Vec2(0.0f, kAnchorHeight), 0.4f, 0.4f);
        for (int32 i = 0; i < kLinkCount; ++i)
        {
            const float32 hinge = kLinkLength * static_cast<float32>(i);
            const b2Vec2 center(hinge + 0.5f * kLinkLength, kAnchorHeight);
            b2Body* link = AddBox(m_world, center, kLinkHalfLength, kLinkHalfHeight, kSteel);
            AddHinge(m_world, previous, link, b2Vec2(hinge, kAnchorHeight));
            previous = link;
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeChain(const SceneSettings& settings)
{
    return std::make_unique<Chain>(settings);
}

} // namespace boxreel
