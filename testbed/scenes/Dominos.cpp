// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kPerRow = 11;
constexpr float32 kHalfThickness = 0.1f; ///< of a domino [m]
constexpr float32 kHalfHeight = 1.0f;    ///< of a domino [m]
constexpr float32 kStep = 1.2f;          ///< from one domino to the next [m]
constexpr float32 kRowLength = kStep * static_cast<float32>(kPerRow - 1);
constexpr float32 kBallRadius = 0.5f; ///< [m]

constexpr float32 kUpperShelf = 13.0f; ///< height of its top [m]
constexpr float32 kUpperFirst = -6.5f; ///< where the first domino of the upper row stands [m]
constexpr float32 kLowerShelf = 4.5f;  ///< height of its top [m]
constexpr float32 kLowerFirst = 5.0f;  ///< where the first domino of the lower row stands [m]

constexpr Material kDomino{.density = 2.0f, .friction = 0.3f};
constexpr Material kBall{.density = 2.0f, .friction = 0.5f, .restitution = 0.1f};

/// The hammer fells the upper row to the right. Its last domino pushes a ball off the shelf, and a
/// ramp turns the ball round. The ball fells the lower row to the left, whose last domino pushes
/// another ball into a bucket. The dominoes are made in the order in which they fall.
class Dominos : public Scene
{
public:
    explicit Dominos(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(18.0f, 0.0f));
        AddUpperRow();
        AddRamp();
        AddLowerRow();
        AddBucket();
        AddHammer();
    }

private:
    void AddRow(float32 firstX, float32 step, float32 shelf)
    {
        for (int32 i = 0; i < kPerRow; ++i)
        {
            const float32 x = firstX + step * static_cast<float32>(i);
            AddBox(m_world, b2Vec2(x, shelf + kHalfHeight), kHalfThickness, kHalfHeight, kDomino);
        }
    }

    // The shelf ends just past the ball, so that a nudge is enough to send it over.
    void AddUpperRow()
    {
        const float32 ballX = kUpperFirst + kRowLength + 1.2f;
        const float32 left = kUpperFirst - 1.0f;
        const float32 right = ballX + 0.1f;
        AddGroundBox(m_world, b2Vec2(0.5f * (left + right), kUpperShelf - 0.25f),
                     0.5f * (right - left), 0.25f);
        AddRow(kUpperFirst, kStep, kUpperShelf);
        AddBall(m_world, b2Vec2(ballX, kUpperShelf + kBallRadius), kBallRadius, kBall);
    }

    // Ends above the middle of a domino: a push at its foot would topple it the wrong way. The
    // pillar keeps the ball on the ramp, and on the ground when it has come down at last.
    void AddRamp()
    {
        AddGroundBox(m_world, b2Vec2(10.4f, 7.4f), 4.5f, 0.25f, 0.3f);
        AddGroundBox(m_world, b2Vec2(14.9f, 6.0f), 0.25f, 6.0f);
    }

    void AddLowerRow()
    {
        const float32 ballX = kLowerFirst - kRowLength - 1.2f;
        const float32 left = ballX - 0.1f;
        const float32 right = kLowerFirst + 0.8f;
        AddGroundBox(m_world, b2Vec2(0.5f * (left + right), kLowerShelf - 0.25f),
                     0.5f * (right - left), 0.25f);
        AddRow(kLowerFirst, -kStep, kLowerShelf);
        AddBall(m_world, b2Vec2(ballX, kLowerShelf + kBallRadius), kBallRadius, kBall);
    }

    void AddBucket()
    {
        const float32 left = kLowerFirst - kRowLength - 5.0f;
        AddGroundBox(m_world, b2Vec2(left, 1.0f), 0.2f, 1.0f);
        AddGroundBox(m_world, b2Vec2(left + 4.0f, 1.0f), 0.2f, 1.0f);
    }

    // A heavy ball at the end of a light arm, held level and let go. At its lowest it touches the
    // first domino above the middle.
    void AddHammer()
    {
        constexpr float32 kArm = 3.5f;
        constexpr float32 kHead = 0.6f;
        const b2Vec2 pivot(kUpperFirst - kHalfThickness - kHead, kUpperShelf + 1.4f + kArm);
        b2Body* frame = AddGroundBox(m_world, pivot, 0.3f, 0.3f);
        b2Body* hammer = AddBody(m_world, b2_dynamicBody, pivot);
        AttachBox(*hammer, 0.5f * kArm, 0.1f, {.density = 1.0f}, b2Vec2(-0.5f * kArm, 0.0f));
        AttachCircle(*hammer, kHead, {.density = 4.0f}, b2Vec2(-kArm, 0.0f));
        AddHinge(m_world, frame, hammer, pivot);
    }
};

} // namespace

std::unique_ptr<Scene> MakeDominos(const SceneSettings& settings)
{
    return std::make_unique<Dominos>(settings);
}

} // namespace boxreel
