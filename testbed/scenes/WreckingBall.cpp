// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

const b2Vec2 kHook(0.0f, 15.0f); ///< at the crane's end, where the chain hangs [m]
constexpr int32 kLinkCount = 6;
constexpr float32 kLinkLength = 1.6f;  ///< from hinge to hinge [m]
constexpr float32 kBallRadius = 1.2f;  ///< [m]
constexpr float32 kAside = -1.1f;      ///< how far it is drawn aside, from hanging [rad]
constexpr int32 kRows = 9;             ///< of the wall
constexpr int32 kColumns = 3;          ///< of the wall
constexpr float32 kWallStart = 1.6f;   ///< the side that the ball comes to [m]
constexpr float32 kBrickWidth = 0.6f;  ///< half [m]
constexpr float32 kBrickHeight = 0.4f; ///< half [m]
constexpr Material kSteel{.density = 6.0f};
constexpr Material kIron{.density = 20.0f, .friction = 0.4f}; ///< 90 kg
constexpr Material kBrick{.density = 1.0f};                   ///< 1 kg each

/// A ball on a chain, drawn aside, swings down from a crane and through a wall.
class WreckingBall : public Scene
{
public:
    explicit WreckingBall(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // the ball is much heavier than links and bricks
        AddGroundEdge(m_world, b2Vec2(-14.5f, 0.0f), b2Vec2(40.0f, 0.0f));
        AddWall();
        AddBallOnChain(AddCrane());
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(3.0f, 7.8f), .halfSize = b2Vec2(17.5f, 8.8f)};
    }

private:
    /// In bond: every other row is half a brick aside.
    void AddWall()
    {
        for (int32 row = 0; row < kRows; ++row)
        {
            const float32 y = kBrickHeight * static_cast<float32>(2 * row + 1);
            const float32 first = kWallStart + (row % 2 == 0 ? 1.0f : 2.0f) * kBrickWidth;
            for (int32 column = 0; column < kColumns; ++column)
            {
                const float32 x = first + 2.0f * kBrickWidth * static_cast<float32>(column);
                AddBox(m_world, b2Vec2(x, y), kBrickWidth, kBrickHeight, kBrick);
            }
        }
    }

    b2Body* AddCrane()
    {
        b2Body* crane = AddBody(m_world, b2_staticBody, kHook);
        AttachBox(*crane, 7.5f, 0.2f, {}, b2Vec2(-6.5f, 0.5f));   // jib
        AttachBox(*crane, 0.3f, 8.0f, {}, b2Vec2(-12.0f, -7.0f)); // mast
        AttachBox(*crane, 0.8f, 0.6f, {}, b2Vec2(-13.2f, -0.3f)); // counterweight
        return crane;
    }

    void AddBallOnChain(b2Body* crane)
    {
        const b2Vec2 along = b2Rot(kAside - 0.5f * b2_pi).GetXAxis();
        b2Body* previous = crane;
        for (int32 i = 0; i < kLinkCount; ++i)
        {
            const b2Vec2 hinge = kHook + kLinkLength * static_cast<float32>(i) * along;
            b2Body* link = AddBox(m_world, hinge + 0.5f * kLinkLength * along,
                                  0.5f * kLinkLength + 0.05f, 0.1f, kSteel, kAside - 0.5f * b2_pi);
            SetGroup(*link, -1);
            AddHinge(m_world, previous, link, hinge);
            previous = link;
        }
        const b2Vec2 end = kHook + kLinkLength * static_cast<float32>(kLinkCount) * along;
        b2Body* ball = AddBall(m_world, end + kBallRadius * along, kBallRadius, kIron);
        AddHinge(m_world, previous, ball, end);
        Name(*ball, "ball");
    }
};

} // namespace

std::unique_ptr<Scene> MakeWreckingBall(const SceneSettings& settings)
{
    return std::make_unique<WreckingBall>(settings);
}

} // namespace boxreel
