// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kLinkCount = 10;
constexpr float32 kLinkLength = 1.2f;    ///< from hinge to hinge [m]
constexpr float32 kBallRadius = 1.5f;    ///< [m]
constexpr float32 kAnchorHeight = 18.0f; ///< [m]
constexpr float32 kLength = kLinkLength * static_cast<float32>(kLinkCount) + kBallRadius;
constexpr Material kLink{.density = 2.0f};
constexpr Material kLoad{.density = 40.0f}; ///< 280 kg on links of half a kilogram

constexpr KeyBinding kKeys[] = {{'j', "cuts the rope, or ties it again"}};

/// A heavy ball swings on a light chain. A rope from end to end takes the load off the hinges; cut,
/// they are torn wide open.
class RopeJoint : public Scene
{
public:
    explicit RopeJoint(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(18.0f, 0.0f));
        m_anchor = AddGroundBox(m_world, b2Vec2(0.0f, kAnchorHeight), 0.5f, 0.5f);
        b2Body* previous = m_anchor;
        for (int32 i = 0; i < kLinkCount; ++i)
        {
            const float32 x = kLinkLength * static_cast<float32>(i);
            b2Body* link = AddBox(m_world, b2Vec2(x + 0.5f * kLinkLength, kAnchorHeight),
                                  0.5f * kLinkLength, 0.12f, kLink);
            AddHinge(m_world, previous, link, b2Vec2(x, kAnchorHeight));
            SetGroup(*link, -1);
            previous = link;
        }
        m_ball = AddBall(m_world, b2Vec2(kLength, kAnchorHeight), kBallRadius, kLoad);
        SetGroup(*m_ball, -1);
        Name(*m_ball, "ball");
        AddHinge(m_world, previous, m_ball, b2Vec2(kLength - kBallRadius, kAnchorHeight));
        Tie();
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key != 'j')
        {
            return;
        }
        if (m_rope != nullptr)
        {
            m_world.DestroyJoint(m_rope);
            m_rope = nullptr;
            return;
        }
        Tie();
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"rope", m_rope != nullptr ? "tied" : "cut"}};
    }

    void VisitState(SceneState& state) override { state(m_anchor, m_ball, m_rope); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 9.8f), .halfSize = b2Vec2(16.0f, 10.3f)};
    }

private:
    // A centimetre longer than the chain, which is for the way of the chain only.
    void Tie()
    {
        m_rope = AddRope(m_world, m_anchor, m_ball, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 0.0f),
                         kLength + 0.01f);
    }

    void JointGone(b2Joint* joint) override
    {
        if (joint == m_rope)
        {
            m_rope = nullptr;
        }
    }

    b2Body* m_anchor = nullptr;
    b2Body* m_ball = nullptr;
    b2Joint* m_rope = nullptr; ///< null when it is cut
};

} // namespace

std::unique_ptr<Scene> MakeRopeJoint(const SceneSettings& settings)
{
    return std::make_unique<RopeJoint>(settings);
}

} // namespace boxreel
