// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kLinkCount = 16;
constexpr float32 kLinkLength = 1.0f;      ///< from hinge to hinge [m]
constexpr float32 kLinkHalfHeight = 0.15f; ///< [m]
constexpr float32 kBallRadius = 1.8f;      ///< [m]
constexpr float32 kAnchorHeight = 20.0f;   ///< [m]

// Links overlap at their hinges, as those of a real chain do.
constexpr float32 kLinkHalfLength = 0.5f * kLinkLength + 0.05f; ///< [m]

constexpr Material kSteel{.density = 1.6f};
constexpr Material kLead{.density = 27.0f}; ///< 275 kg on links of half a kilogram

/// A chain with a ball of five hundred times a link's mass, released from the horizontal. Only the
/// hinges hold it, and they do not stretch.
class BallAndChain : public Scene
{
public:
    explicit BallAndChain(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // masses of 1:500; with one step the chain stretches like gum
        AddGroundEdge(m_world, b2Vec2(-22.0f, 0.0f), b2Vec2(22.0f, 0.0f));
        b2Body* previous = AddGroundBox(m_world, b2Vec2(0.0f, kAnchorHeight), 0.5f, 0.5f);
        for (int32 i = 0; i < kLinkCount; ++i)
        {
            const b2Vec2 hinge(kLinkLength * static_cast<float32>(i), kAnchorHeight);
            b2Body* link = AddBox(m_world, hinge + b2Vec2(0.5f * kLinkLength, 0.0f),
                                  kLinkHalfLength, kLinkHalfHeight, kSteel);
            SetGroup(*link, -1); // a chain folds without getting entangled
            AddHinge(m_world, previous, link, hinge);
            previous = link;
        }
        const b2Vec2 end(kLinkLength * static_cast<float32>(kLinkCount), kAnchorHeight);
        b2Body* ball = AddBall(m_world, end + b2Vec2(kBallRadius, 0.0f), kBallRadius, kLead);
        AddHinge(m_world, previous, ball, end);
        SetGroup(*ball, -1);
        Name(*ball, "ball");
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 11.0f), .halfSize = b2Vec2(20.5f, 11.5f)};
    }
};

} // namespace

std::unique_ptr<Scene> MakeBallAndChain(const SceneSettings& settings)
{
    return std::make_unique<BallAndChain>(settings);
}

} // namespace boxreel
